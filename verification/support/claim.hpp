// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

// Checks that also write their row for docs/verification.md and docs/stability.md: if the environment
// variable GASJET_CLAIMS names a folder, each test replaces its SUITE.TEST.tsv there (columns: claim.cpp).
// Rows of one test that say the same `what` are a sweep: the report shows the one that uses most of its
// tolerance.
namespace claim {

/// As std::source_location, which clang 14 lacks.
struct Where {
  const char* file;
  int line;
  static constexpr Where current(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    return {file, line};
  }
};

struct Claim {
  const char* equation;  // tag in docs/theory, such as "G.4"
  std::string what;      // quantity with its unit, "rigid tank, pressure at 0.1 s [Pa]"
  const char* why;       // reason of the tolerance or band, in a few words
};

// Expects |computed - exact| <= tolerance (absolute, in the quantity's unit).
void expect_near(const Claim& claim, double computed, double exact, double tolerance,
                 Where where = Where::current());

// The same with a tolerance relative to |exact|.
void expect_relative(const Claim& claim, double computed, double exact, double tolerance,
                     Where where = Where::current());

// Expects errors of resolutions each `ratio` times finer than the one before to fall with an order inside
// (low, high), for each pair of neighbours; at least three errors, all of one sign.
void expect_order(const Claim& claim, const std::vector<double>& errors, double low, double high,
                  double ratio = 2.0, Where where = Where::current());

// A way in which a method fails: expects measured / predicted inside [low, high].
struct Threshold {
  const char* failure;  // row of the atlas, "sonic switch"
  const char* formula;  // of the limit, in words of docs/theory, "dt = 2 / omega"
  double predicted, measured;
  const char* unit;  // of both, "s"
  const char* past;  // what the program does beyond it, "exit 3 before the first step"
};
void expect_threshold(const Claim& claim, const Threshold& threshold, double low, double high,
                      Where where = Where::current());

}  // namespace claim
