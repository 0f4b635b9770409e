// SPDX-License-Identifier: Apache-2.0
#include "input_files.hpp"

#include <fmt/format.h>

#include "base/result_folder.hpp"
#include "commands/command.hpp"
#include "results/load_scene.hpp"

namespace driver::commands {
namespace {

bool is_same(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;  // error of a file that does not exist yet: then the names decide
  if (std::filesystem::equivalent(a, b, ignored)) return true;
  return std::filesystem::absolute(a).lexically_normal() == std::filesystem::absolute(b).lexically_normal();
}

}  // namespace

void refuse_same_file(const char* option, const std::filesystem::path& out,
                      const std::vector<std::filesystem::path>& inputs) {
  for (const auto& input : inputs)
    if (!out.empty() && !input.empty() && is_same(out, input))
      throw CaseError(
          fmt::format("{} {}: would overwrite {}: name another file", option, out.string(), input.string()));
}

void refuse_inputs(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& inputs) {
  const auto status = read_status(folder);
  if (!status) return;
  for (const auto& name : status->files) refuse_same_file("--out", folder / name, inputs);
}

void require_file(const std::filesystem::path& file) {
  std::error_code ignored;  // error of a missing file, which its reader reports
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file))
    throw CaseError(fmt::format(
        "{}: is not a regular file: it is read more than once, so copy it to a file first", file.string()));
}

std::vector<std::filesystem::path> input_files(const std::filesystem::path& file,
                                               const std::vector<std::string>& overrides) {
  CaseDocument document(file, overrides);
  load_scene(document);
  return document.files();
}

std::string id_of(const std::string& command, const std::vector<std::string>& options,
                  const std::vector<const CaseDocument*>& cases) {
  std::vector<std::string> facts{command};
  facts.insert(facts.end(), options.begin(), options.end());
  std::vector<std::filesystem::path> files;
  for (const CaseDocument* one : cases) {
    const auto folder = one->file().parent_path();
    facts.push_back(one->text(folder.empty() ? "." : folder));  // as it is, with its overrides
    for (auto& file : one->files()) files.push_back(std::move(file));
  }
  return run_id(facts, files);
}

}  // namespace driver::commands
