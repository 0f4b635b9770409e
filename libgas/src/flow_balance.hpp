// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "compensated_sum.hpp"
#include "gas/integrator.hpp"
#include "inflow_segment.hpp"
#include "openings.hpp"
#include "pressure_volume.hpp"

namespace gas {

/// Which way gas flows; each regime has a smooth right-hand side, and the integration is broken where they
/// meet.
enum class Regime {
  kClosed,     // p <= p_a and no backflow, or p held at p_a: nothing flows through the openings
  kOut,        // p > p_a, vents subsonic
  kOutSonic,   // p > p_a, vents sonic
  kBack,       // p < p_a, ambient gas flows in through vents with backflow, subsonic
  kBackSonic,  // the same, sonic
  kHeldOut,    // p held within hold_near() of p_a: what comes in leaves
  kHeldBack,   // the same: ambient gas replaces what p would lose
};

/// Right-hand side of the stepped unknowns y over one step; they count from the begin of a sub-step, t0. The
/// gas follows:
///   m_k = m_k(t0) + delivered_k + Y_ak back - out_k,  U = U(t0) + delivered enthalpy + h_a back - out - work
///   - heat.
class FlowBalance {
 public:
  using Vector = std::vector<double>;
  using Gas = std::vector<double>;  // mass [kg] of each species, and last U [J]

  /// The gas last located, and its flows.
  struct Point {
    bool valid;                           // masses not negative, temperature in its range
    std::optional<std::size_t> depleted;  // not valid: species of which more has left than there was
    double mass;                          // [kg]
    double pressure;                      // [Pa]
    double overpressure;                  // [Pa] p - p_a, PressurePlace's where the volume follows p
    double temperature;                   // [K]
    double gamma;                         // [-]
    double volume;                        // [m3]
    double compliance;                    // [-] 1 + gamma (p/V) dV/dp
    double work;                          // [J] (G.19) where the volume follows the pressure
    bool beyond;                          // p is above the curve of such a volume
    double thermal_energy;                // [J] m cv T, with (G.19): the scale of energy errors
    double specific_enthalpy;             // [J/kg]
    double vent;                          // [kg/s] out through all vents
    double fabric;                        // [kg/s] out through the fabric
    double back;                          // [kg/s] in through all vents
    double heat;                          // [W]
    double share;  // [-] while p is held: flow its way through the openings over that at hold_near() from p_a
  };

  /// `model` must outlive this. `negligible`: share of the gas by which a species may be lacking; it is then
  /// gone.
  FlowBalance(const ControlVolumeModel& model, double negligible);

  // Unknowns: mass out of each species [kg], work [J], heat [J], then mass [kg] and enthalpy [J] out through
  // each vent and last the fabric, then (if any vent has backflow) mass [kg] in through each vent.
  std::size_t species() const { return masses_.size(); }
  std::size_t work_slot() const { return masses_.size(); }
  std::size_t heat_slot() const { return masses_.size() + 1; }
  std::size_t out_slot(std::size_t stream) const { return masses_.size() + 2 + 2 * stream; }
  std::size_t back_slot(std::size_t vent) const { return out_slot(openings_.vents() + 1) + vent; }
  std::size_t streams() const { return openings_.vents() + 1; }
  std::size_t backflows() const { return openings_.any_backflow() ? openings_.vents() : 0; }
  bool is_flow(std::size_t i) const { return i != work_slot() && i != heat_slot(); }
  std::size_t unknowns() const { return back_slot(backflows()); }

  void begin_step(const ControlVolumeState& state, double t0, double t1, const VolumePath& path);
  double next_break(const TriggerState& triggers, double t) const;
  void begin_segment(const TriggerState& triggers, double a, double b);
  void end_segment(double reached);
  /// The band around `overpressure` [Pa], which is no level: until the segment ends, each curve against it is
  /// its line there.
  void enter_band(double overpressure);
  /// Overpressures [Pa] at which the curves of openings and volume have knots.
  std::vector<double> levels() const;

  /// Ends a sub-step with y at t: the next begins there.
  /// What more of a species has left than there was is taken out of y again.
  void accept(Vector& y, double t);
  /// Makes what leaves in all streams the mass of what leaves of all species, which an implicit method keeps
  /// only as well as it knows its matrix.
  void close_streams(Vector& y) const;
  /// Whether more of a species would have left than there was, at the gas last located, by however little.
  bool lacks_species() const {
    return std::ranges::any_of(lack_, [](double lack) { return lack > 0.0; });
  }
  /// What an error of the method let flow the wrong way does not flow: it is error. Returns its mass [kg].
  double stop_reversed_streams(Vector& y, Vector& error) const;
  /// Sum of unknown i over the step, up to the last sub-step accepted.
  double total(std::size_t i) const { return totals_[i].value(); }

  /// p [Pa] at t, between two segments or at the begin of one.
  double pressure(double t);
  /// The gas at (y, t): fills point(), its flows aside.
  void locate(const Vector& y, double t);
  /// The same for `gas` at time t.
  void locate_gas(const Gas& gas, double t);
  /// Puts the gas last located, as it is, at `change` [Pa] more than the pressure of `at`.
  void move_pressure(const Point& at, double change);
  /// dp [Pa] of 1 kg more of species `part` at constant T, or, after the last, of 1 J more, with (G.19).
  double pressure_slope(const Point& at, std::size_t part) const;
  /// Fills `gas` with that of the sub-step's begin; `change` with that which the unknowns make; adds factor
  /// times the inflow's rates at t.
  void gas_begin(Gas& gas) const;
  void gas_change(const Vector& y, Gas& change) const;
  void add_inflow_rates(double factor, double t, Gas& rates) const;
  /// The same of their derivatives with t.
  void add_inflow_slopes(double factor, double t, Gas& slopes) const;
  /// dy/dt at the gas located, in the regime set; fills the flows of point().
  void fill_rates(Vector& dydt, double t);
  /// Where p is held, or on its balance, corrects y at t, the end of h, by flow that goes on longer, so that
  /// p is on its balance.
  void settle(Vector& y, Vector& dydt, double t, double h);
  /// What the openings would let through at `overpressure` [Pa], of what would hold p at the gas located,
  /// [-]; spoils point()'s flows.
  double relief(double t, double overpressure);
  /// Whether the balance of flows, not held, at t is one to which p comes well within h, and both are so
  /// close to p_a that it comes there within rounding of t, or that an `error` [Pa] of p matters there.
  bool is_on_balance(double t, double h, double error);
  /// Whether backflow at p_a raises p: cold gas of many atoms takes more from hot gas of one atom than it
  /// brings.
  bool can_hold_back(double t);
  /// How close to p_a p can be held [Pa].
  double hold_near() const;
  bool has_walls() const { return model_.heat_loss.conductance > 0.0; }
  /// The rates of backflow alone at t, p as at the last point.
  void fill_backflow(Vector& dydt, double t);
  /// Flow into an evacuated volume from `begin` of a segment: backflow, sonic, is linear in time as areas
  /// are.
  struct FirstFlow {
    const Vector &begin_rate, &end_rate;  // dy/dt
    double begin, end;                    // [s]
  };
  double mass_in(const FirstFlow& flow) const;  // [kg]
  /// Fills an evacuated volume: without a heat capacity the gas is at the temperature at which inflow and
  /// walls balance at the end, that of the last fill_backflow().
  void fill_until(Vector& y, const FirstFlow& flow);
  /// Turns the state of begin_step() into the one at the end of the last segment; throws DomainError, and
  /// leaves it as it is, if its temperature is out of range. Fills the total of the work of a volume that
  /// follows p.
  void finish(ControlVolumeState& state);

  bool is_open() const;                                           // gas can leave
  bool has_backflow() const;                                      // gas can come in
  bool needs_stepper() const;                                     // something but inflow changes the gas
  double pressure_excess() const { return point_.overpressure; }  // [Pa] p - p_a
  double sonic_excess() const;                                    // [Pa] critical ratio * p - p_a
  double back_sonic_excess() const;                               // [Pa] p - critical ratio * p_a
  /// V dp/dt [W] of the last point if nothing flowed through the openings, at time t of this segment.
  double closed_pressure_growth(double t) const;
  /// dp/dt [Pa/s] at the last point, time t; zero without gas.
  double pressure_rate(double t) const;
  /// The faster of the two relaxation rates [1/s] of outflow at the last point, (G.14); that of p by
  /// backflow.
  double relaxation_rate() const;
  /// That of the walls, (G.16); zero without gas.
  double heat_rate() const;
  double volume_rate(double t) const {  // [m3/s]
    return mean_rate_ + curvature_ * (t0_ + t1_ - 2.0 * t);
  }
  void set_regime(Regime regime) { regime_ = regime; }
  Regime regime() const { return regime_; }
  bool is_held() const { return regime_ == Regime::kHeldOut || regime_ == Regime::kHeldBack; }
  const Point& point() const { return point_; }
  void invalidate() { point_.valid = false; }
  const Thermo& thermo() const { return model_.thermo; }
  double ambient_pressure() const { return model_.ambient.pressure; }
  double back_enthalpy() const { return air_enthalpy_; }  // [J/kg]
  double air_fraction(std::size_t k) const { return model_.ambient.mass_fractions[k]; }
  std::span<const StreamFlux> delivered() const { return delivered_; }
  /// Changes of species k's mass and of U with the unknowns: errors of the state from errors of y.
  double species_change(const Vector& y, std::size_t k) const;
  double energy_change(const Vector& y) const;
  /// Whether the band lies above the curve of the volume.
  bool is_beyond_volume() const { return volume_by_pressure_ && volume_by_pressure_->is_beyond(); }
  const std::optional<Curve>& volume_curve() const { return model_.volume_of_overpressure; }
  /// Energy [J/kg] that species k brings along at the temperature of the last point, u and the work (G.19)
  /// that it does; zero without gas.
  double species_energy(std::size_t k) const;
  /// h [J/kg] of species k there.
  double species_enthalpy(std::size_t k) const { return model_.thermo.enthalpy(k, point_.temperature); }

 private:
  void begin_books(const ControlVolumeState& state);
  void add_inflow(std::size_t i, double mass, double enthalpy);
  void add_stream(std::size_t i, double factor, const InflowSegment::Delivered& stream, Gas& gas) const;
  void keep_masses_non_negative();
  void supply(double t);
  void collect(const Vector& y, double t);
  void find_depleted();
  void find_point(double t);
  std::optional<double> temperature_of(double energy) const;
  void place_gas(double energy, double temperature);
  double settled_work();
  double volume(double t) const {
    return volume_begin_ + (mean_rate_ + curvature_ * (t1_ - t)) * (t - t0_);
  }  // (G.17)
  double leak_area(double t) const { return leak_area_begin_ + leak_area_rate_ * (t - t0_); }
  std::optional<double> temperature_of_first_gas(double t) const;
  double first_backflow(std::size_t vent, const FirstFlow& flow) const;  // [kg]
  void outflow_rates(Vector& dydt, double t, double overpressure);
  void backflow_rates(Vector& dydt, double t, double overpressure);
  double flows_near_ambient(Vector& dydt, double t, bool out, double share);
  void hold(Vector& dydt, double t);
  double held_overpressure(double t);
  double balanced_overpressure(double t);

  const ControlVolumeModel& model_;
  double negligible_;                // [-] of the gas
  std::vector<Mixture> inflow_gas_;  // 1 kg of each inflow
  Mixture air_;                      // 1 kg of the ambient gas, if a vent lets it in
  double air_enthalpy_ = 0.0, air_gamma_ = 1.4;
  Openings openings_;
  std::optional<PressureVolume> volume_by_pressure_;

  double t0_ = 0.0, t1_ = 0.0, volume_begin_ = 0.0, mean_rate_ = 0.0, curvature_ = 0.0;
  double work_begin_ = 0.0;  // [J] (G.19) at t0
  double leak_area_begin_ = 0.0, leak_area_rate_ = 0.0;
  double segment_begin_ = 0.0, base_time_ = 0.0;  // [s] of the segment, of the sub-step
  std::vector<InflowSegment> segments_;
  std::vector<StreamFlux> delivered_;  // of each inflow, up to segment_begin_
  struct Received {
    CompensatedSum mass, enthalpy;
  };
  std::vector<Received> received_;  // of each inflow, from there to base_time_

  Regime regime_ = Regime::kClosed;
  std::vector<double> masses_;          // [kg] at the last evaluation
  std::vector<double> lack_;            // [kg] by which more of each had left there
  double energy_ = 0.0;                 // [J] U there
  std::vector<CompensatedSum> base_;    // the gas at base_time_
  std::vector<CompensatedSum> totals_;  // of the unknowns, over the step
  Vector scratch_;
  Mixture mixture_;
  double work_share_ = 0.0;  // [-] of a change of p V at the last point
  Point point_{};
};

}  // namespace gas
