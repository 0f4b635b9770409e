// SPDX-License-Identifier: Apache-2.0
// Progress of long work on standard error: a bar on a terminal, else a line a second at most. And Ctrl-C.
#pragma once

#include <chrono>
#include <string>

namespace driver {

class Progress {
 public:
  /// `total` in the unit of update(); nothing is shown when quiet.
  Progress(std::string what, double total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Cheap enough to be called every step: shows at most ten bars, or one line, a second.
  void update(double done, const std::string& note = {});

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

/// From now on the first Ctrl-C (or SIGTERM) sets a flag that the time loop reads; a second one kills as
/// usual.
void catch_interrupt();
bool interrupted();

}  // namespace driver
