// SPDX-License-Identifier: Apache-2.0
#include "base/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <new>

#include "base/result_folder.hpp"

namespace driver {
namespace {

// Columns of the terminal on standard error; 80 if not known.
std::size_t columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// One line that fits the terminal. On a narrow one it drops first the bar, then the name, then the last parts
// of the text.
std::string bar(const std::string& what, double part, const std::string& text) {
  const std::size_t room = columns() - 1, used = what.size() + text.size() + 4;
  const std::size_t width = room > used ? std::min<std::size_t>(40, room - used) : 0;
  const auto filled = static_cast<std::size_t>(part * static_cast<double>(width));
  if (width >= 10)
    return fmt::format("{} [{}{}] {}", what, std::string(filled, '#'), std::string(width - filled, '.'),
                       text);
  if (what.size() + 1 + text.size() <= room) return what + ' ' + text;
  if (text.size() <= room) return text;
  const std::size_t comma = text.rfind(',', room);  // drops whole parts only
  return text.substr(0, comma == std::string::npos ? room : comma);
}

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
  if (std::signal(SIGHUP, on_interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // `nohup` ignores it
}

std::string text_of(const std::exception& error) {
  if (!dynamic_cast<const std::bad_alloc*>(&error) || dynamic_cast<const OutOfMemory*>(&error))
    return error.what();
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
  return fmt::format("out of memory: {:.0f} MiB of addresses are in use, and more exceeds {}", used, limit);
}

void tell(const std::string& line) {
  constexpr std::size_t longest = 1000;  // of a word from an input
  std::string shown;
  std::size_t word = 0;
  for (const char c : line) {
    word = c == ' ' || c == '\n' ? 0 : word + 1;
    if (word > longest) continue;
    if (c == '\n')
      shown += c;
    else if (static_cast<unsigned char>(c) < ' ' || c == 0x7f)
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      shown += c;
    if (word == longest) shown += "...";
  }
  std::fputs((shown + '\n').c_str(), stderr);
}

bool interrupted() {
  return interrupt_flag != 0;
}

void interrupt() {
  interrupt_flag = 1;
}

Progress::Progress(const std::string& what, double total, bool quiet)
    : what_(one_line(what)),
      total_(total),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      started_(std::chrono::steady_clock::now()),
      last_(started_) {}

Progress::~Progress() {
  if (shown_ && terminal_) std::fputc('\n', stderr);
}

void Progress::update(double done, const std::function<std::string()>& note) {
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(1000);
  const bool finished = done >= total_ && shown_ && terminal_;
  if (now - last_ < pause && !finished) return;
  last_ = now;
  show(done, note ? note() : std::string());
}

void Progress::show(double done, const std::string& note) {
  shown_ = true;
  const double part = std::clamp(done / total_, 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(last_ - started_).count();
  const double left = part > 0.0 ? elapsed * (1.0 - part) / part : 0.0;
  std::string text =
      fmt::format("{:3.0f} %, {:.1f} s left{}{}", 100.0 * part, left, note.empty() ? "" : ", ", note);
  if (terminal_) {
    text = fmt::format("\r{}\033[K", bar(what_, part, text));
  } else {
    text = fmt::format("{}: {}\n", what_, text.substr(text.find_first_not_of(' ')));
  }
  std::fputs(text.c_str(), stderr);  // a failure to print must not stop the work
  std::fflush(stderr);
}

}  // namespace driver
