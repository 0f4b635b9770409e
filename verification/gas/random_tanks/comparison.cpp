// SPDX-License-Identifier: Apache-2.0
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace random_tanks {
namespace {

constexpr double kTight = 1e-12, kLess = 1e-11;  // tolerances of the second route

double largest_difference(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, difference(a[i], b[i]));
  return largest;
}

bool says(const Computed& computed, const char* text) {
  return computed.refusal.find(text) != std::string::npos;
}

/// How far inside its limit the second route is when libgas says that the limit is passed, relative; 0 if
/// beyond.
double distance_to_limit(const Tank& tank, const std::string& csv, const Computed& computed) {
  Options options{kTight};
  options.until = computed.refused_at;
  if (!(options.until >= 0.0)) return HUGE_VAL;
  const Outcome own = plain_route(tank, csv, options);
  if (!own.failure.empty() || own.samples.empty()) return HUGE_VAL;
  const Sample& last = own.samples.back();
  if (says(computed, "the end of the volume's curve"))
    return std::max(0.0, tank.volume_of_overpressure.x.back() - last.overpressure) / last.pressure;
  const auto [low, high] = range_of(tank, csv);
  return std::max(0.0, std::min(last.temperature - low, high - last.temperature)) / last.temperature;
}

void judge_refusal(const Tank& tank, const std::string& csv, const Computed& computed, const Outcome& own,
                   Comparison& result) {
  result.why = computed.refusal;
  if (says(computed, "too stiff")) {
    result.verdict = Verdict::too_stiff;
    return;
  }
  constexpr int kOften = 100;  // sensors that switch so often in a call are refused
  bool right = false;
  if (says(computed, "keeps switching")) right = own.switchings >= kOften;
  if (says(computed, "temperature range") || says(computed, "the end of the volume's curve")) {
    const double distance = distance_to_limit(tank, csv, computed);
    right = distance <= kAllowedTolerances * tank.tolerance;
    result.why +=
        "; the second route is inside by " + std::to_string(distance / tank.tolerance) + " tolerances";
  }
  result.verdict = right ? Verdict::refused_rightly : Verdict::wrong_refusal;
}

/// Whether a start that is off by one tolerance changes the answer by more than the allowance.
bool is_sensitive(const Tank& tank, const std::string& csv, const Outcome& own) {
  for (const double sign : {-1.0, 1.0}) {
    const Outcome moved =
        plain_route(tank, csv, {.tolerance = kTight, .perturbation = sign * tank.tolerance});
    if (largest_difference(moved.samples, own.samples) > kAllowedTolerances * tank.tolerance) return true;
  }
  return false;
}

}  // namespace

const char* name_of(Verdict verdict) {
  constexpr const char* names[kVerdicts] = {"agrees",    "refused rightly", "undecided",    "sensitive",
                                            "too stiff", "disagrees",       "wrong refusal"};
  return names[static_cast<std::size_t>(verdict)];
}

double difference(const Sample& a, const Sample& b) {
  if (!(b.mass > 0.0)) return a.mass == b.mass ? 0.0 : HUGE_VAL;
  double largest = 0.0;
  const auto add = [&](double off) { largest = off <= largest ? largest : off; };  // takes what is no number
  add(std::abs(a.pressure / b.pressure - 1.0));
  add(std::abs(a.temperature / b.temperature - 1.0));
  add(std::abs(a.mass / b.mass - 1.0));
  for (std::size_t k = 0; k < a.masses.size(); ++k) add(std::abs(a.masses[k] - b.masses[k]) / b.mass);
  return largest;
}

Comparison compare(const Tank& tank, const Tank& other, const std::string& csv) {
  const Computed computed = libgas_route(tank);
  const Outcome own = plain_route(other, csv, {kTight}), less = plain_route(other, csv, {kLess});
  const double allowance = kAllowedTolerances * tank.tolerance;
  Comparison result;
  result.balance = computed.balance;
  result.error = largest_difference(computed.samples, own.samples) / allowance;
  result.own = largest_difference(less.samples, own.samples) / allowance;
  const auto [low, high] = range_of(other, csv);
  const bool leaves = own.coldest < low * (1.0 - allowance) || own.hottest > high * (1.0 + allowance);
  if (!own.failure.empty() || !less.failure.empty() || !(result.own <= 1.0)) {
    result.verdict = Verdict::undecided;
    result.why = own.failure + " " + less.failure;
  } else if (!(result.error <= 1.0)) {
    result.verdict = is_sensitive(other, csv, own) ? Verdict::sensitive : Verdict::disagrees;
    result.why = "the answers differ";
  } else if (!computed.refusal.empty()) {
    judge_refusal(other, csv, computed, own, result);
  } else if (leaves) {
    result.verdict = Verdict::wrong_refusal;
    result.why = "the second route leaves the range of temperatures: " + std::to_string(own.coldest) +
                 " to " + std::to_string(own.hottest) + " K";
  }
  return result;
}

Tally compare_seeds(std::uint64_t first, std::uint64_t last, const std::string& csv) {
  Tally tally;
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    const Tank tank = random_tank(seed);
    const Comparison c = compare(tank, tank, csv);
    ++tally.counts[static_cast<std::size_t>(c.verdict)];
    tally.worst_balance = std::max(tally.worst_balance, c.balance);
    if (c.verdict == Verdict::agrees || c.verdict == Verdict::disagrees)
      tally.worst_error = std::max(tally.worst_error, c.error);
    if (c.verdict == Verdict::disagrees || c.verdict == Verdict::wrong_refusal)
      tally.disagreeing.push_back(seed);
    if (c.verdict == Verdict::agrees || c.verdict == Verdict::refused_rightly) continue;
    std::cout << name_of(c.verdict) << ": " << c.why << "\nerror " << c.error << ", second route " << c.own
              << " of the allowance\n"
              << tank << '\n';
  }
  return tally;
}

}  // namespace random_tanks
