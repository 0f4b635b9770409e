// SPDX-License-Identifier: Apache-2.0
// The terms of the energy balance (K.21): its columns and its residual come from one table.
#pragma once

#include <span>

#include "engine/columns.hpp"

namespace driver {

/// Place of a term in the balance, where held + kinetic + elastic + spent - supplied stays as it was at the
/// start.
enum class Role {
  none,      // no term of it
  held,      // by gas and weights
  kinetic,   // held too, by what moves
  elastic,   // held too, by what is stretched or pressed
  spent,     // since the start, on what is outside
  supplied,  // since the start, from outside
};

/// [J] at level n; flows are sums from the start. A term that the scene does not have is zero.
struct EnergyTerm {
  const char* name;
  Role role;
  bool (*when)(const Scene&);
  double (*value)(const Scene&, const State&);
};

std::span<const EnergyTerm> energy_terms();
/// Held by gas, weights, motion or stretch.
constexpr bool is_held(Role role) {
  return role == Role::held || role == Role::kinetic || role == Role::elastic;
}
/// Sum of the terms of one place [J].
double sum_of(Role role, const Scene& scene, const State& state);

/// Energy that is held at level n [J].
double held_energy(const Scene& scene, const State& state);
/// Physical drift [J]: what is held and was spent, less what was held at the start and was supplied since.
double energy_residual(const Scene& scene, const State& state);

}  // namespace driver
