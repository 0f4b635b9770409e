// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "gas/integrator.hpp"
#include "inflow_segment.hpp"

namespace gas {

/// How gas leaves; each regime has a smooth right-hand side, and the integration is broken where they meet.
enum class Regime {
  kClosed,    // p <= p_a: nothing leaves
  kSubsonic,  // p_a < p < p_a/(critical ratio)
  kChoked,    // vents sonic
};

/// Right-hand side of the stepped unknowns over one step:
///   y = (mass out of each species [kg], enthalpy out [J], work [J], vent mass out [kg], fabric mass out
///   [kg])
/// The state follows: m_k = m_k(t0) + delivered_k - y_k, U = U(t0) + delivered enthalpy - enthalpy out -
/// work.
class FlowBalance {
 public:
  using Vector = std::vector<double>;

  /// The gas at the last evaluation.
  struct Point {
    bool valid;                // masses not negative, temperature in its range
    double mass;               // [kg]
    double pressure;           // [Pa]
    double temperature;        // [K]
    double gamma;              // [-]
    double volume;             // [m3]
    double thermal_energy;     // [J] m cv T: the scale of energy errors
    double specific_enthalpy;  // [J/kg]
  };

  /// `model` must outlive this.
  explicit FlowBalance(const ControlVolumeModel& model);

  std::size_t unknowns() const { return masses_.size() + 4; }
  std::size_t enthalpy_slot() const { return masses_.size(); }
  std::size_t work_slot() const { return masses_.size() + 1; }
  std::size_t vent_slot() const { return masses_.size() + 2; }
  std::size_t fabric_slot() const { return masses_.size() + 3; }

  void begin_step(const ControlVolumeState& state, double t0, double t1, const VolumePath& path);
  double next_break(double t) const;
  void begin_segment(double a, double b);
  void end_segment();

  /// dy/dt at (y, t), in the regime set; fills point().
  void operator()(const Vector& y, Vector& dydt, double t);
  /// Turns the state of begin_step() into the one at the end of the last segment; throws DomainError, and
  /// leaves it as it is, if its temperature is out of range.
  void finish(const Vector& y, ControlVolumeState& state);

  bool is_open() const;                                  // gas can leave
  bool is_rigid() const { return volume_rate_ == 0.0; }  // the volume is constant
  double pressure_excess() const;                        // [Pa] p - p_a
  double sonic_excess() const;                           // [Pa] critical ratio * p - p_a
  /// V dp/dt [W] of the last point if nothing left, with the inflow at time t of this segment.
  double closed_pressure_growth(double t) const;
  /// dp/dt [Pa/s] at the last point, where the rates are `dydt` and the time is t; zero without gas.
  double pressure_rate(const Vector& dydt, double t) const;
  void set_regime(Regime regime) { regime_ = regime; }
  Regime regime() const { return regime_; }
  const Point& point() const { return point_; }
  void invalidate() { point_.valid = false; }
  double ambient_pressure() const { return model_.ambient.pressure; }
  double mass_in() const;
  double enthalpy_in() const { return enthalpy_in_; }

 private:
  double collect(const Vector& y, double elapsed);
  void locate_point(double internal_energy, double t);
  double volume(double t) const { return volume_begin_ + volume_rate_ * (t - t0_); }
  double leak_area(double t) const { return leak_area_begin_ + leak_area_rate_ * (t - t0_); }
  void outflow_rates(Vector& dydt, double t) const;

  const ControlVolumeModel& model_;
  std::vector<Mixture> inflow_gas_;  // 1 kg of each inflow
  double vent_area_ = 0.0;           // [m2] sum Cd A

  double t0_ = 0.0, volume_begin_ = 0.0, volume_rate_ = 0.0, leak_area_begin_ = 0.0, leak_area_rate_ = 0.0;
  const ControlVolumeState* start_ = nullptr;
  double segment_begin_ = 0.0;
  std::vector<InflowSegment> segments_;
  std::vector<double> delivered_;  // [kg] of each inflow, up to segment_begin_
  double enthalpy_in_ = 0.0;       // [J] up to segment_begin_

  Regime regime_ = Regime::kClosed;
  std::vector<double> masses_;  // [kg] at the last evaluation
  Mixture mixture_;
  Point point_{};
};

}  // namespace gas
