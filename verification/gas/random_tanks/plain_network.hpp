// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "tank.hpp"

namespace random_tanks {

/// Sensors and gates of a tank over time.
class PlainNetwork {
 public:
  explicit PlainNetwork(const Tank& tank);

  /// At t, where p - p_a is `overpressure`.
  void update(double t, double overpressure);
  /// Whether a pressure sensor changes at `overpressure`.
  bool switches(double overpressure) const;
  /// Whether any may still change.
  bool watches() const;
  /// First time after t at which a sensor of time or signal or a delay may change something.
  double next_break(double t) const;

  bool is_on(Node node) const { return !node || nodes_[*node].on; }
  double since(Node node) const { return node ? nodes_[*node].since : 0.0; }     // [s] when it last came on
  double first(Node node) const { return node ? nodes_[*node].first_on : 0.0; }  // [s] when it first came on
  int switchings() const { return switchings_; }                                 // of pressure sensors

 private:
  struct Memory {
    bool on = false;
    double since = kInfinity;
    double first_on = kInfinity;
    double held = kInfinity;  // [s] since when a gate's condition holds
  };
  /// `slack` of the pressures counts as reached.
  bool sensor(std::size_t i, double t, double overpressure, double slack) const;
  bool gate(std::size_t i, double t);

  const Tank& tank_;
  std::vector<std::vector<double>> crossings_;  // [s] of each sensor's signal with its threshold
  std::vector<Memory> nodes_;
  double slack_;  // [s] what counts as the same time
  int switchings_ = 0;
};

}  // namespace random_tanks
