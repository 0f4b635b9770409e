// SPDX-License-Identifier: Apache-2.0
// Checks during a run whether the skin passes through itself.
#pragma once

#include <string>
#include <vector>

#include "engine/run.hpp"
#include "results/crossing.hpp"

namespace driver {

/// Result of a check at one level.
struct SkinCheck {
  double time = 0.0;    // [s]
  double volume = 0.0;  // [m3] signed volume (M.5) of a bag; 0 for a sheet
  Crossing crossing{};
};

/// Checks a bag at the start, at the end, and at the first levels after a quarter, a half and three quarters
/// of the way from its initial to its design volume; also at the first level at or after each multiple of
/// output.self_intersection_every. A sheet has no volume, and only the other checks.
class SkinChecks {
 public:
  explicit SkinChecks(const Scene& scene);
  /// Goes on as another one, of the same scene.
  void go_on_as(const SkinChecks& other);
  /// Goes on from a state of the scene: what was due by then is done, and what was found later is forgotten.
  void go_on_from(const State& state);
  /// For run_scene(); it refers to this object.
  LevelView view();
  /// In the order of time.
  const std::vector<SkinCheck>& found() const { return found_; }
  /// Adds note_of_crossing() to the notes of a run that has ended.
  void note(RunOutcome& outcome) const;

 private:
  bool due(const State& state, bool last);
  void check(const State& state);

  const Scene& scene_;
  double initial_volume_ = 0.0, design_volume_ = 0.0;  // [m3]
  int quarters_ = 3;                                   // quarters of the way that are done
  Schedule schedule_;
  std::vector<SkinCheck> found_;
};

/// Warning after a run: the check with the largest wrongly counted share of the volume, if above a hundredth;
/// otherwise empty. With `self_contact`, first of all that with most layers that cross. The check at the
/// start is left to the next two functions.
std::string note_of_crossing(const std::vector<SkinCheck>& checks, bool self_contact = false);

/// Adds a warning if elements of the bag cross each other at the start.
void add_skin_warning(Scene& scene);

/// Number, place and volume of the bag's layers that cross at the start; empty if none do.
std::string crossed_layers(const Scene& scene);
/// Throws CaseError if layers of a bag with [membrane.self_contact] cross at the start.
void require_separate_layers(CaseDocument& document, const Scene& scene);

}  // namespace driver
