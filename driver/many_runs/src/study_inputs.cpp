// SPDX-License-Identifier: Apache-2.0
#include "study_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/case_reader.hpp"
#include "base/run_id.hpp"
#include "base/text_file.hpp"
#include "results/load_scene.hpp"

namespace driver {

void StudyInputs::check(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    const auto digits = digits_of_file(file);
    const std::lock_guard<std::mutex> guard(lock_);
    const auto known = std::ranges::find(list_, file, &RunInput::file);
    if (known == list_.end()) {
      if (digits) list_.push_back({file, *digits});  // what reads it says that it cannot be read
    } else if (!digits) {
      throw FileError(fmt::format(
          "{}: is no longer readable: restore it and run the same command to continue", file.string()));
    } else if (*digits != known->digits) {
      throw FileError(
          fmt::format("{}: changed while the study ran, finished runs are kept: restore it and run the "
                      "same command to continue, or use another folder for another case",
                      file.string()));
    }
  }
}

void StudyInputs::check_all() {
  std::vector<std::filesystem::path> files;
  for (const auto& input : list()) files.push_back(input.file);
  check(files);
}

std::vector<RunInput> StudyInputs::list() const {
  const std::lock_guard<std::mutex> guard(lock_);
  return list_;
}

std::vector<RunInput> study_inputs(const StudyPlan& plan, const std::filesystem::path& folder) {
  std::vector<RunInput> inputs{{folder / plan_copy, digits_of_file(folder / plan_copy).value_or("")}};
  for (auto& input : plan.inputs->list()) inputs.push_back(std::move(input));
  return inputs;
}

std::vector<std::string> study_overrides(const StudyPlan& plan, const StudyPoint& point) {
  auto overrides = plan.overrides;
  for (std::size_t f = 0; f < point.size(); ++f)
    for (auto& text : plan.factors[f].overrides_of(point[f])) overrides.push_back(std::move(text));
  return overrides;
}

Scene study_scene(const StudyPlan& plan, const std::vector<std::string>& overrides) {
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

}  // namespace driver
