// SPDX-License-Identifier: Apache-2.0
// One run of many: what stands of it in a journal.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace driver {

struct RunRecord {
  long number = 0;                             // in its plan
  std::string status;                          // "done", "inaccurate", "failed" or "refused"
  std::string message;                         // why it is not done
  std::string warning = {};                    // of a run that is done: its energy drifts
  std::vector<std::optional<double>> values;   // of the quantities; none: of an event that did not occur
  std::vector<std::vector<double>> rows = {};  // of row_names(), of a run that is done, if they are asked for
  long steps = 0;
  double cpu_seconds = 0.0;

  bool is_done() const { return status == "done"; }
};

/// As JSON on one line.
std::string line_of(const RunRecord& run);

/// What the records of a plan are like.
struct RunShape {
  long end = 0;                        // all numbers lie below it
  std::size_t quantities = 0;          // of each run
  std::size_t columns = 0;             // of the rows of a run that is done; 0: it has no rows
  std::function<bool(long)> has = {};  // a number below the end; empty: all
};

/// The same doubles as in line_of(). Nothing if the line is none of a run of this shape.
std::optional<RunRecord> record_of_line(const std::string& line, const RunShape& shape);

}  // namespace driver
