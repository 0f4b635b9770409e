// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "libgas_route.hpp"

namespace random_tanks {

/// An answer may be off by so many tolerances.
inline constexpr double kAllowedTolerances = 100.0;

enum class Verdict {
  agrees,
  refused_rightly,  // libgas refuses, and names a limit that the second route meets at that time
  undecided,        // the second route does not know its answer well enough
  sensitive,        // a start one tolerance away changes the answer by more than the allowance
  too_stiff,        // libgas finds the gas too stiff
  disagrees,        // the answers differ by more than the allowance
  wrong_refusal,    // libgas refuses, and the second route meets no such limit; or does not refuse where it
                    // must
};
inline constexpr std::size_t kVerdicts = 7;
const char* name_of(Verdict verdict);

struct Comparison {
  Verdict verdict = Verdict::agrees;
  double error = 0.0;    // of p, T, m, largest at the ends of the calls, in allowances
  double own = 0.0;      // of the second route by its two tolerances, in allowances
  double balance = 0.0;  // see Computed
  std::string why;       // of what is not `agrees`
};

/// The largest relative difference of p, T and m, of species to the whole mass.
double difference(const Sample& a, const Sample& b);

/// libgas on `tank` against the second route on `other`, the same tank as a rule.
Comparison compare(const Tank& tank, const Tank& other, const std::string& csv);

struct Tally {
  std::array<int, kVerdicts> counts{};
  std::vector<std::uint64_t> disagreeing;         // seeds of disagrees and wrong_refusal
  double worst_error = 0.0, worst_balance = 0.0;  // of tanks with two answers, in allowances; of all tanks
  int count(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
};

/// Compares the tanks of seeds first to last and prints those that neither agree nor are refused rightly.
Tally compare_seeds(std::uint64_t first, std::uint64_t last, const std::string& csv);

}  // namespace random_tanks
