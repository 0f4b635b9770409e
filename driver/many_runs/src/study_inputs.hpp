// SPDX-License-Identifier: Apache-2.0
// The files that a study reads, and scenes from them.
#pragma once

#include <mutex>

#include "engine/scene.hpp"
#include "many_runs/study.hpp"
#include "run_journal.hpp"

namespace driver {

inline constexpr const char* plan_copy = "plan.toml";  // in the study's folder

/// All files that a study reads, but its plan. Any thread may call.
class StudyInputs {
 public:
  /// Throws FileError for one that holds something else than when it was first read, or can no longer be
  /// read. To be called after what reads the files: then they have been read as they were at first.
  void check(const std::vector<std::filesystem::path>& files);
  void check_all();
  std::vector<RunInput> list() const;

 private:
  mutable std::mutex lock_;
  std::vector<RunInput> list_;
};

/// The files of a study in `folder`, the copy of its plan first.
std::vector<RunInput> study_inputs(const StudyPlan& plan, const std::filesystem::path& folder);

/// What a point, or its first factors, change in the case.
std::vector<std::string> study_overrides(const StudyPlan& plan, const StudyPoint& point);

/// The case with overrides. Throws FileError if a file cannot be read or has changed, and CaseError for what
/// the case refuses.
Scene study_scene(const StudyPlan& plan, const std::vector<std::string>& overrides);

}  // namespace driver
