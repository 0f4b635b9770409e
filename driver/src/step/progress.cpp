// SPDX-License-Identifier: Apache-2.0
#include "driver/progress.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <new>

namespace driver {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

extern "C" void on_interrupt(int) {
  interrupt_flag = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
}

}  // namespace

void catch_interrupt() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  if (std::signal(SIGHUP, on_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // as `nohup` has it
}

std::string text_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr) return error.what();
  std::ifstream statm("/proc/self/statm");  // [pages] of address space, of memory
  double space = 0.0;
  statm >> space;
  rlimit most{};
  getrlimit(RLIMIT_AS, &most);
  const double mebibyte = 1024.0 * 1024.0,
               used = space * static_cast<double>(sysconf(_SC_PAGESIZE)) / mebibyte;
  const std::string limit =
      most.rlim_cur == RLIM_INFINITY
          ? "the system's limit"
          : fmt::format("the limit of {:.0f} MiB", static_cast<double>(most.rlim_cur) / mebibyte);
  return fmt::format(
      "out of memory: {:.0f} MiB of addresses are in use, and what is needed next is beyond {}", used, limit);
}

void tell(const std::string& line) {
  std::fputs((line + '\n').c_str(), stderr);
}

bool interrupted() {
  return interrupt_flag != 0;
}

Progress::Progress(std::string what, double total, bool quiet)
    : what_(std::move(what)),
      total_(total),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      started_(std::chrono::steady_clock::now()),
      last_(started_) {}

Progress::~Progress() {
  if (shown_ && terminal_) std::fputc('\n', stderr);
}

void Progress::update(double done, const std::string& note) {
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(1000);
  const bool finished = done >= total_ && shown_ && terminal_;
  if (now - last_ < pause && !finished) return;
  last_ = now;
  show(done, note);
}

void Progress::show(double done, const std::string& note) {
  shown_ = true;
  const double part = std::clamp(done / total_, 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(last_ - started_).count();
  const double left = part > 0.0 ? elapsed * (1.0 - part) / part : 0.0;
  std::string text;
  if (terminal_) {
    constexpr int width = 40;
    const int filled = static_cast<int>(part * width);
    text = fmt::format("\r{} [{:#<{}}{:.<{}}] {:3.0f} %  {:.1f} s left  {}\033[K", what_, "", filled, "",
                       width - filled, 100.0 * part, left, note);
  } else {
    text = fmt::format("{}: {:.0f} %, {:.1f} s left {}\n", what_, 100.0 * part, left, note);
  }
  std::fputs(text.c_str(), stderr);  // where nobody can read it the work goes on
  std::fflush(stderr);
}

}  // namespace driver
