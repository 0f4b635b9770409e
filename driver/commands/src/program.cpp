// SPDX-License-Identifier: Apache-2.0
// The commands as a program: maps errors to exit codes.
#include "commands/program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "base/case_reader.hpp"
#include "base/progress.hpp"
#include "commands/command.hpp"
#include "huge_pages.hpp"
#include "results/results.hpp"
#ifndef GASJET_ALONE  // a small program does without the reference route of visibility
#include "jet_tree/tree_route.hpp"
#endif

namespace driver::commands {
namespace {

int report_error(const std::string& message, int code) {
  tell("gasjet: " + message);
  return code;
}

// Exit code if nobody reads the output any more, as in `gasjet exact ... | head`: the one that a shell shows.
int lost_output() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  if (poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0) return 128 + SIGPIPE;
  return report_error("standard output: write failed (disk full?)", exit_domain);
}

// Flushes the output. If that fails, the command has failed.
int finish(int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  return lost_output();
}

// Opens closed standard descriptors, because a result file would otherwise get their number and their output.
// A closed output discards text without an error; a closed input fails when it is read.
void guard_standard_descriptors() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(number, F_GETFD) < 0) open("/dev/null", O_WRONLY);
}

}  // namespace

int program(int argc, char** argv, const MakeCrew& crew) {
  use_huge_heap();
  guard_standard_descriptors();
  for (const int number : {SIGPIPE, SIGXFSZ})
    std::signal(number, SIG_IGN);  // the failing write reports the
                                   // error
#ifndef GASJET_ALONE
  jet::add_tree_route();
#endif
  try {
    return finish(run_command_line(argc, argv, crew));
  } catch (const CaseError& error) {
    return report_error(error.what(), exit_input);
  } catch (const OutputError& error) {
    return report_error(error.what(), exit_input);
  } catch (const std::bad_alloc& error) {
    return report_error(std::string(argc > 1 ? argv[1] : "start") + ": " + text_of(error), exit_domain);
  } catch (const std::exception& error) {
    return std::ferror(stdout) ? lost_output() : report_error(text_of(error), exit_domain);
  }
}

}  // namespace driver::commands
