// SPDX-License-Identifier: Apache-2.0
// The `gasjet` command: maps errors to exit codes.
#include <cstdio>
#include <exception>
#include <iostream>

#include "commands/commands.hpp"
#include "driver/case_reader.hpp"
#include "driver/results.hpp"
#include "jet_tree/tree_route.hpp"

namespace {

int report(const char* message, int code) {
  std::fprintf(stderr, "gasjet: %s\n", message);
  return code;
}

constexpr const char* lost_output = "standard output: write failed (disk full?)";

// What was printed has arrived, or the command has not done its work.
int finish(int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  return report(lost_output, driver::commands::exit_domain);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace driver::commands;
  jet::add_tree_route();
  try {
    return finish(run_command_line(argc, argv));
  } catch (const driver::CaseError& error) {
    return report(error.what(), exit_input);
  } catch (const driver::OutputError& error) {
    return report(error.what(), exit_input);
  } catch (const std::exception& error) {
    return report(std::ferror(stdout) ? lost_output : error.what(), exit_domain);
  }
}
