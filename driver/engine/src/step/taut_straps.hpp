// SPDX-License-Identifier: Apache-2.0
// Straps that were taut at a level of a run, and a note of those that never were.
#pragma once

#include <fmt/format.h>

#include <vector>

#include "engine/run.hpp"
#include "engine/state.hpp"

namespace driver {

/// Looks at each level of a run.
class TautStraps {
 public:
  explicit TautStraps(const Scene& scene)
      : taut_(scene.bag ? scene.bag->model.description.straps.size() : 0, false) {}
  void look(const State& now) {
    for (std::size_t i = 0; i < taut_.size(); ++i) taut_[i] = taut_[i] || now.bag->strap_tension[i] > 0.0;
  }
  void note(const Scene& scene, RunOutcome& outcome) const {
    for (std::size_t i = 0; i < taut_.size(); ++i)
      if (!taut_[i])
        outcome.notes.push_back(fmt::format("membrane.strap.{} was never taut: its free_length is {:.3g} m",
                                            i, scene.bag->model.description.straps[i].free_length));
  }

 private:
  std::vector<bool> taut_;
};

}  // namespace driver
