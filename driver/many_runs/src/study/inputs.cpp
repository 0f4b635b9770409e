// SPDX-License-Identifier: Apache-2.0
// Files that a study reads, and scenes from them.
#include <fmt/format.h>

#include <algorithm>

#include "base/result_folder.hpp"
#include "base/text_file.hpp"
#include "results/load_scene.hpp"
#include "study/parts.hpp"

namespace driver {

void StudyInputs::check(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    const auto digits = digits_of_file(file);
    const std::lock_guard<std::mutex> guard(lock_);
    const auto known = std::ranges::find(list_, file, &StudyInput::file);
    if (known == list_.end()) {
      if (digits) list_.push_back({file, *digits});  // what reads it says that it cannot be read
    } else if (!digits) {
      throw FileError(
          fmt::format("{}: can no longer be read: when it can, the same command goes on", file.string()));
    } else if (*digits != known->digits) {
      throw FileError(
          fmt::format("{}: changed while the study ran: the runs so far are kept; with the file as it "
                      "was the same command goes on, for another case use another folder",
                      file.string()));
    }
  }
}

void StudyInputs::check_all() {
  std::vector<std::filesystem::path> files;
  for (const auto& input : list()) files.push_back(input.file);
  check(files);
}

std::vector<StudyInput> StudyInputs::list() const {
  const std::lock_guard<std::mutex> guard(lock_);
  return list_;
}

Scene scene_at(const StudyPlan& plan, const StudyPoint& point) {
  auto overrides = plan.overrides;
  for (std::size_t f = 0; f < point.size(); ++f)
    for (auto& text : plan.factors[f].overrides_of(point[f])) overrides.push_back(std::move(text));
  std::optional<CaseDocument> document;
  try {
    document.emplace(plan.case_file, overrides);
    Scene scene = load_scene(*document);
    plan.inputs->check(document->files());
    return scene;
  } catch (const FileError&) {
    throw;
  } catch (const CaseError& error) {
    // A file that cannot be read, or that is half written, is refused as a wrong value is.
    plan.inputs->check_all();
    for (const auto& file : document ? document->files() : std::vector<std::filesystem::path>{})
      if (!digits_of_file(file)) throw FileError(error.what());
    throw;
  }
}

std::unique_ptr<Scene> StudyScenes::take(const StudyPlan& plan, std::size_t point) {
  {
    const std::lock_guard<std::mutex> guard(lock_);
    const auto found = std::ranges::find(free_, point, [](const auto& one) { return one.first; });
    if (found != free_.end()) {
      auto scene = std::move(found->second);
      free_.erase(found);
      return scene;
    }
  }
  return std::make_unique<Scene>(scene_at(plan, plan.points[point]));
}

void StudyScenes::give(std::size_t point, std::unique_ptr<Scene> scene) {
  const std::lock_guard<std::mutex> guard(lock_);
  if (free_.size() == workers_) free_.erase(free_.begin());
  free_.emplace_back(point, std::move(scene));
}

}  // namespace driver
