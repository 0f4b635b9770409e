// SPDX-License-Identifier: Apache-2.0
// The command `gasjet exact` by itself: a small program for pages that show closed forms (bindings/browser).
// usage: exact exact NAME [--set name=value]... [--times first:last:step] [--format FORMAT], or exact exact
// --list
#include <fmt/format.h>

#include <exception>
#include <string>

#include "base/case_reader.hpp"
#include "commands/command.hpp"

namespace {

driver::commands::ExactArguments arguments(int argc, char** argv) {
  driver::commands::ExactArguments a;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--list")
      a.list = true;
    else if (!word.starts_with("--"))
      a.name = word;
    else if (++i == argc)
      throw driver::CaseError(word + ": needs a value");
    else if (word == "--set")
      a.parameters.emplace_back(argv[i]);
    else if (word == "--times")
      a.times = argv[i];
    else if (word == "--format")
      a.format = argv[i];
    else
      throw driver::CaseError(word + ": unknown, allowed: --list, --set, --times, --format");
  }
  return a;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return driver::commands::exact(arguments(argc, argv));
  } catch (const std::exception& error) {
    fmt::print(stderr, "gasjet: {}\n", error.what());
    return driver::commands::exit_input;
  }
}
