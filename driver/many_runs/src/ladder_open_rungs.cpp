// SPDX-License-Identifier: Apache-2.0
// Where a ladder of a chaotic scene spends more runs.
#include <algorithm>
#include <cmath>
#include <elementary/hypot.hpp>

#include "many_runs/ladder.hpp"

namespace driver {
namespace {

constexpr double small_part = 0.5;  // of the larger standard error: more runs of the smaller change little
constexpr double scatter = 2.0;     // standard errors below which a difference of
                                    // meshes may be nothing else

// Rungs that the reference rests on.
std::vector<std::size_t> reference_rungs(const LadderResult& result) {
  std::vector<std::size_t> rungs{0, result.finest};
  for (std::size_t r = 1; r < result.rungs.size(); ++r) {
    const LadderRung& rung = result.rungs[r];
    if (!rung.axis || r == result.finest) continue;
    const LadderAxis& axis = result.plan.axes[*rung.axis];
    const bool counts = axis.kind != AxisKind::effect && !follows_finer_mesh(result.plan, axis);
    if (counts && rung.choice >= axis.first) rungs.push_back(r);
  }
  return rungs;
}

}  // namespace

std::vector<std::size_t> open_rungs(const LadderResult& result, double tolerance) {
  const LadderReference& reference = result.reference;
  const double allowed = tolerance * std::abs(reference.value - result.zero);
  const double coarse = elementary::hypot(result.rungs[0].value.standard_error, reference.standard_error);
  std::vector<bool> open(result.rungs.size(), false);
  bool of_reference = false;
  for (std::size_t r = 0; r < result.rungs.size(); ++r) {
    const LadderRung& rung = result.rungs[r];
    if (rung.verdict != Verdict::undecided) continue;
    const double own = rung.can_be_perturbed ? rung.value.standard_error : 0.0;
    const bool runs_decide = std::abs(std::abs(rung.error) - allowed) > reference.uncertainty;
    if (!runs_decide && reference.uncertainty > scatter * coarse) continue;
    open[r] = runs_decide && own > small_part * reference.standard_error;
    of_reference = of_reference || !runs_decide || reference.standard_error > small_part * own;
  }
  if (of_reference)
    for (const std::size_t r : reference_rungs(result)) open[r] = true;
  std::vector<std::size_t> rungs;
  for (std::size_t r = 0; r < open.size(); ++r)
    if (open[r] && result.rungs[r].failure.empty() && result.rungs[r].can_be_perturbed) rungs.push_back(r);
  return rungs;
}

}  // namespace driver
