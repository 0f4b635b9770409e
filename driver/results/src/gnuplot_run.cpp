// SPDX-License-Identifier: Apache-2.0
#include "gnuplot_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>

#include "base/progress.hpp"

namespace driver {
namespace {

constexpr std::chrono::seconds longest_wait{30};  // some hundred times the time of a chart

// Exit status of the process. Empty if it did not end within that time or before Ctrl-C; it is then killed.
std::optional<int> status_within(pid_t child, std::chrono::seconds time) {
  const auto until = std::chrono::steady_clock::now() + time;
  int status = 0;
  for (;;) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if (ended < 0 && errno != EINTR) return std::nullopt;
    if (interrupted() || std::chrono::steady_clock::now() > until) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return std::nullopt;
}

}  // namespace

std::string run_gnuplot(const std::filesystem::path& folder, const std::string& name) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string program = "gnuplot", no_settings_of_the_user = "-d", script = name + ".gp";
  char* const arguments[] = {program.data(), no_settings_of_the_user.data(), script.data(), nullptr};
  pid_t child = 0;
  const int code = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (code != 0) return fmt::format("gnuplot: {}", std::strerror(code));
  const std::optional<int> status = status_within(child, longest_wait);
  if (!status) return fmt::format("gnuplot did not end within {} s or before Ctrl-C", longest_wait.count());
  const bool drawn =
      WIFEXITED(*status) && WEXITSTATUS(*status) == 0 && std::filesystem::exists(folder / (name + ".svg"));
  return drawn ? "" : "gnuplot failed";
}

}  // namespace driver
