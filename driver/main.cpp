// SPDX-License-Identifier: Apache-2.0
// The `gasjet` command.
#include "commands/program.hpp"

int main(int argc, char** argv) {
  const driver::MakeCrew threads = [](const std::string&, const driver::CrewWork& work, int count) {
    return driver::thread_crew(work, count);
  };
  return driver::commands::program(argc, argv, threads);
}
