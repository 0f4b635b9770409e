// SPDX-License-Identifier: Apache-2.0
// A walk through the events of pressure sensors.
#pragma once

#include <array>

#include "start.hpp"
#include "walk.hpp"

namespace enclosure {

/// Why there are no bounds at a requested time [s].
std::string too_close(const Ball& time);

/// A walk whose law changes where a pressure sensor switches. Up to then the old law holds. If under it p is
/// on one side of the threshold at t_0 and on the other at t_1, the sensor switches in [t_0, t_1], whatever
/// its switching does. With that ball as its time the walk goes on from t_0. Of several levels passed on the
/// way up (down) the lowest (highest) comes first; whether p comes to the others depends on the new law.
class SensedWalk {
 public:
  /// Throws Refusal.
  SensedWalk(const Scene& scene, double tolerance);

  /// Steps to the exact time `end` or a part of the way, across events and changes of functions of time.
  void step(const Ball& end);

  const Tank& tank() const { return *tank_; }
  Walk& walk() { return *walk_; }
  const Ball& empty_until() const { return empty_until_; }
  /// True while a sensor may have switched unnoticed: the walk may then be under the wrong law.
  bool is_open() const { return open_steps_ > 0; }
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
  std::optional<Place> clear_;     // where each sensor last was on its side
  int open_steps_ = 0;             // since then, if one may have met its threshold
  std::array<bool, 2> touched_{};  // if so, one that waits for p to fall, to rise
  long steps_ = 0, crossings_ = 0;
};

}  // namespace enclosure
