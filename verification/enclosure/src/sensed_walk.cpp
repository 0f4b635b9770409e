// SPDX-License-Identifier: Apache-2.0
#include "sensed_walk.hpp"

#include <cstdio>
#include <map>

#include "network.hpp"

namespace enclosure {
namespace {

/// Sensors that are on at the start switch at time 0.
std::vector<Balls> first_events(const Scene& scene) {
  std::vector<Balls> events(scene.sensors.size());
  for (std::size_t i = 0; i < scene.sensors.size(); ++i)
    if (const auto& threshold = scene.sensors[i].threshold)
      if (!(Ball(scene.initial_pressure) - Ball(scene.ambient_pressure) - Ball(*threshold)).is_negative())
        events[i].emplace_back(0.0);
  return events;
}

std::string at_time(const char* format, const Ball& time) {
  char text[200];
  std::snprintf(text, sizeof text, format, time.middle());
  return text;
}

}  // namespace

std::string too_close(const Ball& time) {
  return at_time(
      "t = %.10g s is too close to a change at an uncertain time; ask for another time or a smaller width",
      time);
}

SensedWalk::SensedWalk(const Scene& scene, double tolerance)
    : scene_(scene), tolerance_(tolerance), tank_(std::make_unique<Tank>(scene, first_events(scene))) {
  const Start start = start_of(*tank_);
  empty_until_ = start.empty_until;
  walk_ = std::make_unique<Walk>(*tank_, start.time, start.unknowns, tolerance);
  breaks_ = tank_->breaks();
  look();
}

void SensedWalk::step(const Ball& end) {
  const Ball* next = nullptr;
  for (const Ball& t : breaks_)
    if (before(walk_->time(), upper(t)) && before(lower(t), end) && (!next || before(lower(t), lower(*next))))
      next = &t;
  if (!next)
    walk_->step(end);
  else if (before(walk_->time(), lower(*next)))
    walk_->step(lower(*next));
  else if (before(end, upper(*next)))
    throw Refusal(too_close(end));
  else
    walk_->cross_to(upper(*next));
  look();
}

/// Looks if a sensor has switched in the last step.
void SensedWalk::look() {
  const std::vector<int> now = walk_->sides_now();
  bool open = false;
  std::map<double, bool> passed;  // levels, and if on the way up
  for (std::size_t i = 0; i < scene_.sensors.size(); ++i) {
    const auto level = tank_->watched_level(i);
    if (!level) continue;
    std::size_t surface = 0;
    while (tank_->surfaces[surface].kind != Surface::Kind::level ||
           !arb_equal(tank_->surfaces[surface].offset.get(), Ball(*level).get()))
      ++surface;
    const int own = tank_->is_on(i) ? 1 : -1;
    const bool meets = now[surface] != own || walk_->met(surface), up = own < 0;
    open = open || meets;
    touched_.at(up) = touched_.at(up) || meets;
    if (now[surface] == -own) passed.emplace(*level, up);
  }
  if (!passed.empty()) {
    if (!clear_) throw Refusal("a tank starts within the width of the tube of a sensor's threshold");
    if (touched_[0] && touched_[1]) throw Refusal(order_is_open);
    const double first = touched_[1] ? passed.begin()->first : passed.rbegin()->first;
    std::vector<Balls> events = tank_->events;
    for (std::size_t i = 0; i < events.size(); ++i)
      if (tank_->watched_level(i) == first) events[i].push_back(hull(clear_->time, walk_->time()));
    return go_on(Place(*clear_), events);
  }
  open_steps_ = open || open_steps_ > 0 ? open_steps_ + 1 : 0;
  if (open_steps_ > 10)
    throw Refusal(
        at_time("the pressure is within the tube's width of a sensor's threshold, and does not pass it "
                "in ten steps, at t = %.6g s; a smaller width may tell its side",
                walk_->time()));
  if (open_steps_ > 0) return;
  clear_ = walk_->place();
  touched_ = {};
}

void SensedWalk::go_on(const Place& place, const std::vector<Balls>& events) {
  open_steps_ = 0;
  touched_ = {};
  steps_ += walk_->steps;
  crossings_ += walk_->crossings;
  auto tank = std::make_unique<Tank>(scene_, events);
  walk_ = std::make_unique<Walk>(*tank, place, tolerance_);
  tank_ = std::move(tank);
  breaks_ = tank_->breaks();
}

}  // namespace enclosure
