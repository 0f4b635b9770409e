// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "gas/control_volume.hpp"

namespace gas {

/// Volume and leak area over one step, linear in time between the two ends.
struct VolumePath {
  double volume_begin;     // [m3] > 0
  double volume_end;       // [m3] > 0
  double leak_area_begin;  // [m2] >= 0, see fabric_mass_flow
  double leak_area_end;    // [m2] >= 0
};

/// What crossed the boundary during one step; integrals over [t0, t1].
struct StepFluxes {
  double mass_in;          // [kg]
  double enthalpy_in;      // [J]
  double vent_mass_out;    // [kg]
  double fabric_mass_out;  // [kg]
  double enthalpy_out;     // [J]
  double work;             // [J] int p dV
  int steps;               // accepted sub-steps of the integrator (0: no stepper was needed)
  int evaluations;         // evaluations of the right-hand side
};

struct IntegratorOptions {
  double relative_tolerance =
      1e-10;  // local error of mass and thermal energy, of the gas in the volume; 1e-13 to 1e-2
  int maximum_steps = 100000;  // sub-steps (rejected ones included) in one advance()
};

/// Stage S10: integrates (G.9), (G.10) over a step. Only outflows and work are stepped (Dormand-Prince 5(4),
/// Boost.Odeint, error-controlled); inflow is added in closed form at every stage, so that mass and energy
/// balance to round-off and no inflow is ever stepped over, at any tolerance. Break points: knots and start
/// times of the inflows, inflow temperatures of 1000 K, the sonic/subsonic switch of the vents and p = p_a,
/// each located. Below p_a nothing flows. A sealed volume of constant size is pure quadrature. Limit:
/// explicit, so sub-steps are of the order sqrt(p - p_a)/kappa where an inflow or a compression is balanced
/// by outflow at p close to p_a, kappa = gamma p_a C/(V sqrt(2 rho)) with C = sum Cd A + leak area.
class GasIntegrator {
 public:
  /// Copies the model. Throws std::invalid_argument for a bad model or option. Allocates all that advance()
  /// needs.
  explicit GasIntegrator(const ControlVolumeModel& model, const IntegratorOptions& options = {});
  ~GasIntegrator();
  GasIntegrator(GasIntegrator&&) noexcept;
  GasIntegrator& operator=(GasIntegrator&&) noexcept;

  /// Advances `state` from t0 to t1 > t0 [s]. Does not allocate. Throws std::invalid_argument for t1 <= t0 or
  /// a state of another size, DomainError if a volume is not positive, the temperature leaves its range or
  /// maximum_steps is exceeded (the gas is too stiff); `state` is then unchanged.
  StepFluxes advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gas
