// SPDX-License-Identifier: Apache-2.0
// The `gasjet` command: maps errors to exit codes.
#include <cstdio>
#include <exception>

#include "commands/commands.hpp"
#include "driver/case_reader.hpp"
#include "driver/results.hpp"

namespace {

int report(const char* message, int code) {
  std::fprintf(stderr, "gasjet: %s\n", message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace driver::commands;
  try {
    return run_command_line(argc, argv);
  } catch (const driver::CaseError& error) {
    return report(error.what(), exit_input);
  } catch (const driver::OutputError& error) {
    return report(error.what(), exit_input);
  } catch (const std::exception& error) {
    return report(error.what(), exit_domain);
  }
}
