// SPDX-License-Identifier: Apache-2.0
// A walk through the events of pressure sensors.
#pragma once

#include "start.hpp"
#include "walk.hpp"

namespace enclosure {

/// A walk whose law changes where a pressure sensor switches. Up to then the old law holds. If under it p is
/// on one side of the threshold at t_0 and on the other at t_1, the sensor switches in [t_0, t_1], whatever
/// its switching does. With that ball as its time the walk goes on from t_0.
class SensedWalk {
 public:
  /// Throws Refusal.
  SensedWalk(const Scene& scene, double tolerance);

  /// Steps to the exact time `end` or a part of the way, across events and changes of functions of time.
  void step(const Ball& end);

  const Tank& tank() const { return *tank_; }
  Walk& walk() { return *walk_; }
  const Ball& empty_until() const { return empty_until_; }
  long steps() const { return steps_ + walk_->steps; }
  long crossings() const { return crossings_ + walk_->crossings; }

 private:
  void look();
  void go_on(const Place& place, const std::vector<Balls>& events);

  const Scene& scene_;
  const double tolerance_;
  Ball empty_until_;
  std::unique_ptr<Tank> tank_;
  std::unique_ptr<Walk> walk_;
  Balls breaks_;
  std::optional<Place> clear_;  // where each sensor last was on its side
  int open_steps_ = 0;          // since then, if one may have met its threshold
  long steps_ = 0, crossings_ = 0;
};

}  // namespace enclosure
