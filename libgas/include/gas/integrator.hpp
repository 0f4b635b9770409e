// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <memory>
#include <span>

#include "gas/control_volume.hpp"

namespace gas {

/// Volume and leak area over one step (G.17). Both are linear in time between the two ends; the volume has in
/// addition a parabola that is zero at both ends. The volumes are not read if the model's volume follows the
/// pressure.
struct VolumePath {
  double volume_begin;        // [m3] > 0
  double volume_end;          // [m3] > 0
  double leak_area_begin;     // [m2] >= 0, see fabric_mass_flow
  double leak_area_end;       // [m2] >= 0
  double volume_bulge = 0.0;  // [m3] V at mid-step minus the mean of its ends; > -(smaller end)
};

/// Mass and enthalpy that one stream carried.
struct StreamFlux {
  double mass;      // [kg]
  double enthalpy;  // [J]
};

/// When the flow changed its regime during a step; NaN if it did not.
struct StepMoments {
  /// [s] last time at which the vents became choked or unchoked.
  double sonic_switch = std::numeric_limits<double>::quiet_NaN();
  /// [s] last time at which flow through the openings brought p within 1e-7 of p_a.
  double equalisation = std::numeric_limits<double>::quiet_NaN();
};

/// Amounts that crossed the boundary during one step: integrals over [t0, t1]. The spans point into the
/// integrator and are valid until its next step.
struct StepFluxes {
  double mass_in;                         // [kg] of all inflows
  double enthalpy_in;                     // [J]
  double vent_mass_out;                   // [kg] of all vents
  double fabric_mass_out;                 // [kg]
  double enthalpy_out;                    // [J] of vents and fabric
  double work;                            // [J] int p dV, done by the gas
  double heat;                            // [J] lost through the walls
  double backflow_mass;                   // [kg] of ambient gas that came in through all vents
  double backflow_enthalpy;               // [J]
  int steps;                              // accepted sub-steps; 0 if quadrature was enough
  int evaluations;                        // of the right-hand side
  std::span<const StreamFlux> inflows;    // [inflow] in
  std::span<const StreamFlux> outflows;   // [vents, then fabrics] out
  std::span<const StreamFlux> backflows;  // [vent] in; empty if no vent has backflow
  StepMoments moments;                    // times at which the flow changed its regime
};

/// Method of integration between break points.
enum class Method {
  /// The default: explicit, order 5(4), and Rosenbrock 4 where the gas is stiff.
  dormand_prince_5,
  runge_kutta_4,  // explicit, order 4, error by step doubling
  euler,          // explicit, order 1, error by step doubling
  rosenbrock_4,   // implicit, L-stable, order 4(3)
};

/// Stability limit on the negative real axis: largest h |lambda| [-] with |R(-h |lambda|)| <= 1, R the
/// stability function. Infinity for the implicit method. Source: E. Hairer, G. Wanner, Solving Ordinary
/// Differential Equations II, sec. IV.2.
double stability_limit(Method method);

/// Accuracy and method of the integration. The defaults suit an airbag.
struct IntegratorOptions {
  /// [-] 1e-13 to 1e-2: bound of the local error of mass and thermal energy, relative to the gas in the
  /// volume.
  double relative_tolerance = 1e-10;
  int maximum_steps = 100000;                // > 0: most sub-steps in one advance(), rejected ones included
  Method method = Method::dormand_prince_5;  // see Method
  /// [s] > 0: length of all sub-steps between break points, by `method` alone. 0: lengths follow from error
  /// control.
  double fixed_step = 0.0;
  /// True: a fixed_step may exceed the method's stability limit, so that the limit can be measured.
  bool unsafe_step = false;
};

/// Stage S10: integrates (G.9) and (G.10) over a step.
///
/// Sub-steps integrate outflows, backflow, heat and work only. Inflow over a sub-step is added in closed
/// form; the stages of Rosenbrock 4 see it as a rate. So mass and energy balance to round-off, and no inflow
/// is missed, with any tolerance and method.
///
/// Sub-steps end at break points. Some are known in advance: knots and firing times of the inflows, inflow
/// temperatures of 1000 K, knots of the vents' curves over time, switching times of the triggers. Others are
/// located on the way: pressure triggers, knots over the overpressure, the sonic/subsonic switch of the
/// vents, and p = p_a.
///
/// A sealed adiabatic volume that is constant or follows the pressure needs quadrature only, unless a
/// pressure sensor watches it. The default method uses Rosenbrock 4 for sub-steps longer than 1.5 times the
/// relaxation time, by (G.14) and (G.16).
class GasIntegrator {
 public:
  /// Copies the model and allocates all that advance() needs. Throws std::invalid_argument for a bad model or
  /// option.
  explicit GasIntegrator(const ControlVolumeModel& model, const IntegratorOptions& options = {});
  GasIntegrator(const GasIntegrator& other);             // an integrator of the same model and options
  GasIntegrator& operator=(const GasIntegrator& other);  // likewise
  ~GasIntegrator();
  GasIntegrator(GasIntegrator&&) noexcept;             // leaves `other` without a model
  GasIntegrator& operator=(GasIntegrator&&) noexcept;  // likewise

  /// Advances `state` from t0 to t1 > t0 [s]. Does not allocate. On an exception `state` is unchanged.
  /// - Throws std::invalid_argument for times that are not finite or t1 <= t0, and for a state with other
  ///   sizes, a negative mass or a number that is not finite.
  /// - Throws DomainError if a volume is not positive, a leak area is negative, the temperature leaves its
  ///   range, or p passes the last knot of volume_of_overpressure.
  /// - Throws DomainError if maximum_steps is exceeded or sub-steps become shorter than t resolves. Either
  ///   the gas is too stiff, or a pressure sensor keeps switching.
  /// - With a fixed_step, throws DomainError if a species runs out or the flow reverses within a sub-step.
  ///   Without unsafe_step it also throws if the step is above the stability limit, steps over an
  ///   equilibrium, or takes p through p_a against the feed.
  StepFluxes advance(ControlVolumeState& state, double t0, double t1, const VolumePath& path);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gas
