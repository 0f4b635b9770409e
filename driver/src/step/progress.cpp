// SPDX-License-Identifier: Apache-2.0
#include "driver/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace driver {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;

extern "C" void on_interrupt(int) {
  interrupt_flag = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void catch_interrupt() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
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
  if (terminal_) {
    constexpr int width = 40;
    const int filled = static_cast<int>(part * width);
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %  {:.1f} s left  {}\033[K", what_, "", filled, "",
               width - filled, 100.0 * part, left, note);
  } else {
    fmt::print(stderr, "{}: {:.0f} %, {:.1f} s left {}\n", what_, 100.0 * part, left, note);
  }
  std::fflush(stderr);
}

}  // namespace driver
