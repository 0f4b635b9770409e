// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <memory>
#include <span>

#include "gas/control_volume.hpp"

namespace gas {

/// Volume and leak area over one step: linear in time between the two ends, the volume plus a parabola that
/// is zero there. (G.17) Its volumes are not read where the model's follows the pressure.
struct VolumePath {
  double volume_begin;        // [m3] > 0
  double volume_end;          // [m3] > 0
  double leak_area_begin;     // [m2] >= 0, see fabric_mass_flow
  double leak_area_end;       // [m2] >= 0
  double volume_bulge = 0.0;  // [m3] of V at the middle above the mean of its ends; > -min of them
};

/// What one stream carried.
struct StreamFlux {
  double mass;      // [kg]
  double enthalpy;  // [J]
};

/// When the flow changed its nature in a step; NaN: not in this one.
struct StepMoments {
  double sonic_switch =
      std::numeric_limits<double>::quiet_NaN();  // [s] vents choked or unchoked, the last time
  double equalisation =
      std::numeric_limits<double>::quiet_NaN();  // [s] p came to p_a, to 1e-7 of it, the last time
};

/// What crossed the boundary during one step; integrals over [t0, t1]. The spans belong to the integrator and
/// hold until its next step.
struct StepFluxes {
  double mass_in;                         // [kg] of all inflows
  double enthalpy_in;                     // [J]
  double vent_mass_out;                   // [kg] of all vents
  double fabric_mass_out;                 // [kg]
  double enthalpy_out;                    // [J] of vents and fabric
  double work;                            // [J] int p dV
  double heat;                            // [J] lost through the walls
  double backflow_mass;                   // [kg] of ambient gas, in through all vents
  double backflow_enthalpy;               // [J]
  int steps;                              // accepted sub-steps of the integrator (0: no stepper was needed)
  int evaluations;                        // evaluations of the right-hand side
  std::span<const StreamFlux> inflows;    // in, one each
  std::span<const StreamFlux> outflows;   // out, one per vent, and then one per fabric
  std::span<const StreamFlux> backflows;  // in, one per vent; empty without backflow
  StepMoments moments;                    // see there
};

/// How the gas is stepped between break points.
enum class Method {
  dormand_prince_5,  // explicit, order 5(4), and Rosenbrock 4 where the gas is stiff; the default
  runge_kutta_4,     // explicit, order 4, error by step doubling
  euler,             // explicit, order 1, error by step doubling
  rosenbrock_4,      // implicit, L-stable, order 4(3)
};

/// Largest stable h times a real, negative eigenvalue's magnitude, where the stability function |R(z)| passes
/// 1; infinity for the implicit method. Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations
/// II, sec. IV.2.
double stability_limit(Method method);

/// Accuracy and method of the integration; the defaults suit an airbag.
struct IntegratorOptions {
  double relative_tolerance =
      1e-10;  // local error of mass and thermal energy, of the gas in the volume; 1e-13 to 1e-2
  int maximum_steps = 100000;                // sub-steps (rejected ones included) in one advance()
  Method method = Method::dormand_prince_5;  // see there
  // [s] > 0: sub-steps of this length between break points, all by the method itself; no error control
  double fixed_step = 0.0;
  bool unsafe_step = false;  // take a fixed_step past the method's limit: for measuring that limit
};

/// Stage S10: integrates (G.9), (G.10) over a step. Only outflows, backflow, heat and work are stepped;
/// inflow is added in closed form at every stage, so that mass and energy balance to round-off and no inflow
/// is ever stepped over, at any tolerance, by any method. Break points: knots and firing times of the
/// inflows, inflow temperatures of 1000 K, knots of the vents' curves, switching times of the triggers;
/// located: pressure triggers, knots of the overpressure, the sonic/subsonic switch of the vents and p = p_a.
/// A sealed adiabatic volume of constant size, or that follows the pressure, is pure quadrature. The default
/// method takes sub-steps longer than the gas relaxes, 1/(G.14), by Rosenbrock 4; with fixed_step a sub-step
/// past the method's limit, or past p_a against what feeds the flow, is an error.
class GasIntegrator {
 public:
  /// Copies the model. Throws std::invalid_argument for a bad model or option. Allocates all that advance()
  /// needs.
  explicit GasIntegrator(const ControlVolumeModel& model, const IntegratorOptions& options = {});
  ~GasIntegrator();
  GasIntegrator(GasIntegrator&&) noexcept;
  GasIntegrator& operator=(GasIntegrator&&) noexcept;

  /// Advances `state` from t0 to t1 > t0 [s]. Does not allocate. Throws std::invalid_argument
  /// for t1 <= t0 or a state of another size, DomainError if a volume is not positive, the temperature leaves
  /// its range, maximum_steps is exceeded (the gas is too stiff) or fixed_step is past the stability limit;
  /// `state` is then unchanged.
  StepFluxes advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gas
