// SPDX-License-Identifier: Apache-2.0
// Progress of long work on standard error: a bar on a terminal, else at most one line a second. Also Ctrl-C.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <utility>

namespace driver {

/// Shows the progress of one piece of work.
class Progress {
 public:
  /// `total` has the unit of update(). Shows nothing if `quiet`.
  Progress(const std::string& what, double total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows at most ten bars, or one line, a second; cheap enough to call every step. `note` is asked for
  /// only where it is shown.
  void update(double done, const std::function<std::string()>& note = {});

 private:
  void show(double done, const std::string& note);

  std::string what_;
  double total_;
  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point last_;
};

/// Memory ran out; what() says what needed it.
class OutOfMemory : public std::bad_alloc {
 public:
  explicit OutOfMemory(std::string text) : text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// what() of an error. For a plain std::bad_alloc, the memory in use.
std::string text_of(const std::exception& error);

/// Prints a line on standard error, without control characters and with long words cut. Ignores failures to
/// write.
void tell(const std::string& line);

/// After this call the first Ctrl-C (or SIGTERM, or SIGHUP unless it is ignored) sets a flag that the time
/// loop reads. A second one ends the program as usual.
void catch_interrupt();
/// True after the first Ctrl-C.
bool interrupted();
/// Sets the flag for a Ctrl-C that another process received.
void interrupt();

}  // namespace driver
