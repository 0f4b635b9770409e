// SPDX-License-Identifier: Apache-2.0
// When a run looks whether its skin passes through itself.
#pragma once

#include <string>
#include <vector>

#include "driver/crossing.hpp"
#include "driver/scene.hpp"
#include "driver/state.hpp"
#include "step/schedule.hpp"

namespace driver {

/// Looks at a bag at the start, at the end, and at the first levels where a quarter, a half and three
/// quarters of the way from its initial to its design volume are done; also at the first level at or past
/// each multiple of output.self_intersection_every. A sheet has no volume: it has the other looks.
class SkinLooks {
 public:
  explicit SkinLooks(const Scene& scene);
  /// Whether level n, whose volume S9 has written, is to be looked at; `last`: it is the end.
  bool due(const State& state, bool last);
  /// Looks at level n.
  SkinLook look(const State& state) const;

 private:
  const Scene& scene_;
  double initial_volume_ = 0.0, design_volume_ = 0.0;  // [m3]
  int quarters_ = 3;                                   // of the way that are done
  Schedule schedule_;
};

/// What to warn of after a run: the look at which most of the volume was counted wrongly, if that was more
/// than a hundredth of it; else empty. The look at the start is left to add_skin_warning.
std::string note_of_crossing(const std::vector<SkinLook>& looks);

}  // namespace driver
