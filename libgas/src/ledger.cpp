// SPDX-License-Identifier: Apache-2.0
#include "ledger.hpp"

#include <algorithm>
#include <cmath>

namespace gas {
namespace {

// Round-off that a species leaves when it runs out, of either sign, relative to the mass that passed through.
constexpr double kSpeciesRoundOff = 1e-13;

}  // namespace

Ledger::Ledger(const Boundary& boundary, double negligible)
    : boundary_(boundary),
      negligible_(negligible),
      sums_(boundary.slots().species + 1),
      totals_(boundary.slots().size()),
      gas_(boundary.slots().species + 1),
      received_(boundary.inflows().size()) {}

void Ledger::begin_step(const ControlVolumeState& state, double work) {
  std::ranges::copy(state.masses, gas_.begin());
  gas_.back() = state.internal_energy + work;
  for (std::size_t i = 0; i < gas_.size(); ++i) sums_[i] = gas_[i];
  depleted_.reset();
  std::ranges::fill(totals_, CompensatedSum{});
  std::ranges::fill(received_, Received{});
}

void Ledger::deliver(double t) {
  if (t == time_) return;
  const std::size_t species = boundary_.slots().species;
  const Inflows& inflows = boundary_.inflows();
  for (std::size_t i = 0; i < inflows.size(); ++i) {
    if (inflows[i].is_idle()) continue;
    const auto [mass, enthalpy] = inflows[i].delivered(time_, t);
    const auto& fractions = boundary_.model().inflows[i].mass_fractions;
    for (std::size_t k = 0; k < species; ++k) sums_[k].add(fractions[k] * mass);
    sums_[species].add(enthalpy);
    received_[i].mass.add(mass);
    received_[i].enthalpy.add(enthalpy);
  }
  time_ = t;
  update_gas();
}

void Ledger::update_gas() {
  for (std::size_t i = 0; i < gas_.size(); ++i) gas_[i] = sums_[i].value();
}

bool Ledger::clear_lacking(Vector& gas, double passed) {
  const Slots& s = boundary_.slots();
  depleted_.reset();
  double mass = 0.0, least = 0.0;
  for (std::size_t k = 0; k < s.species; ++k) {
    mass += std::max(0.0, gas[k]);
    least = std::min(least, gas[k]);
  }
  if (least == 0.0) return true;
  const double allowed = std::max(negligible_ * mass, kSpeciesRoundOff * (mass + passed));
  for (std::size_t k = 0; k < s.species; ++k) {
    if (!(gas[k] >= -allowed)) depleted_ = k;
    gas[k] = std::max(0.0, gas[k]);
  }
  return !depleted_;
}

bool Ledger::gas_at(const Vector& y, double t, Vector& gas) {
  const Slots& s = boundary_.slots();
  change(y, gas);
  for (std::size_t i = 0; i < gas.size(); ++i) gas[i] += gas_[i];
  boundary_.inflows().add(
      1.0, [&](const InflowSegment& in) { return in.delivered(time_, t); }, gas);
  double passed = 0.0;
  for (std::size_t k = 0; k < s.species; ++k) passed += std::abs(y[s.out(k)]);
  return clear_lacking(gas, passed);
}

void Ledger::change(const Vector& y, Vector& change) const {
  const Slots& s = boundary_.slots();
  double back = 0.0, energy = -y[s.work()] - y[s.heat()];
  for (std::size_t j = 0; j < s.backflows; ++j) back += y[s.back(j)];
  for (std::size_t j = 0; j < s.streams(); ++j) energy -= y[s.enthalpy(j)];
  for (std::size_t k = 0; k < s.species; ++k)
    change[k] = back == 0.0 ? -y[s.out(k)] : boundary_.model().ambient.mass_fractions[k] * back - y[s.out(k)];
  change[s.species] = energy + boundary_.ambient().enthalpy * back;
}

void Ledger::accept(Vector& y, double t) {
  const Slots& s = boundary_.slots();
  deliver(t);
  Vector& moved = gas_;
  change(y, moved);
  double species = 0.0, streams = 0.0;
  for (std::size_t k = 0; k < s.species; ++k) {
    sums_[k].add(moved[k]);
    if (const double left = sums_[k].value(); left < 0.0) {
      y[s.out(k)] += left;
      sums_[k] = 0.0;
    }
    species += y[s.out(k)];
  }
  sums_.back().add(moved.back());
  for (std::size_t j = 0; j < s.streams(); ++j) streams += y[s.mass(j)];
  for (std::size_t j = 0; streams > 0.0 && j < s.streams(); ++j) y[s.mass(j)] *= species / streams;
  for (std::size_t i = 0; i < totals_.size(); ++i) totals_[i].add(y[i]);
  update_gas();
}

double Ledger::stop_reversed(Vector& y, Vector& error) const {
  const Slots& s = boundary_.slots();
  double out = 0.0, reversed = 0.0;
  for (std::size_t j = 0; j < s.streams(); ++j) out += y[s.mass(j)];
  const auto stop = [&](std::size_t i) {
    error[i] += y[i];
    y[i] = 0.0;
  };
  if (out < 0.0) {
    reversed = -out;
    for (std::size_t k = 0; k < s.species; ++k) stop(s.out(k));
    for (std::size_t j = 0; j < s.streams(); ++j) stop(s.mass(j)), stop(s.enthalpy(j));
  }
  for (std::size_t j = 0; j < s.backflows; ++j)
    if (y[s.back(j)] < 0.0) {
      reversed -= y[s.back(j)];
      stop(s.back(j));
    }
  return reversed;
}

}  // namespace gas
