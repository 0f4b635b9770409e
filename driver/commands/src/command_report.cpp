// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands/command.hpp"
#include "input_files.hpp"
#include "report/report.hpp"
#include "results/results.hpp"

namespace driver::commands {

int report(const ReportArguments& arguments) {
  if (std::filesystem::is_directory(arguments.out))
    throw OutputError(fmt::format("--out {}: is a folder, allowed: a file", arguments.out.string()));
  // Only pages are replaced, so that other files of a results folder are safe.
  if (const auto ending = arguments.out.extension(); ending != ".html" && ending != ".htm")
    throw OutputError(fmt::format("--out {}: a page ends with .html", arguments.out.string()));
  std::vector<std::filesystem::path> inputs = arguments.results;
  if (!arguments.reference.empty()) inputs.push_back(arguments.reference);
  refuse_same_file("--out", arguments.out, inputs);
  const std::string page = report_page(arguments.results, {.reference = arguments.reference});
  replace_file(arguments.out, page);
  fmt::print("{}: {:.1f} MB\n", arguments.out.string(), static_cast<double>(page.size()) * 1e-6);
  return exit_done;
}

}  // namespace driver::commands
