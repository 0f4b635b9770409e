// SPDX-License-Identifier: Apache-2.0
#include "gas/mixture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "gas/error.hpp"
#include "gas/species.hpp"
#include "limits.hpp"
#include "require.hpp"

namespace gas {
namespace {

using Sums = Mixture::Sums;

constexpr double kThird = 1.0 / 3.0;  // a multiplication is several times faster than a division

// Polynomials in pairs of terms: half the latency of Horner's rule, which the root find waits for.
double cp_of(const Sums& a, double t) {
  const double t2 = t * t;
  return (a[0] + a[1] * t) + t2 * ((a[2] + a[3] * t) + t2 * a[4]);
}

double cp_slope_of(const Sums& a, double t) {
  return (a[1] + 2.0 * a[2] * t) + t * t * (3.0 * a[3] + 4.0 * a[4] * t);
}

double enthalpy_of(const Sums& a, double t) {
  const double t2 = t * t;
  return a[5] + t * ((a[0] + 0.5 * a[1] * t) + t2 * ((kThird * a[2] + 0.25 * a[3] * t) + t2 * (0.2 * a[4])));
}

// Newton's method converges quadratically: after a step below this times T the error is below round-off.
constexpr double kNewtonTolerance = 1e-8;
// Chebyshev's method converges cubically, with a factor of order 1 for every gas: the same holds after a step
// below this.
constexpr double kChebyshevTolerance = 2e-6;
constexpr int kQuickIterations = 4;
constexpr int kMaximumIterations = 200;

struct Root {
  const Sums& coefficients;
  double gas_constant_sum;
  double target;  // [J]
  double excess(double t) const { return enthalpy_of(coefficients, t) - gas_constant_sum * t - target; }
  double slope(double t) const { return cp_of(coefficients, t) - gas_constant_sum; }
  double newton(double t) const { return t - excess(t) / slope(t); }
  double chebyshev(double t) const {
    const double inverse = 1.0 / slope(t), step = excess(t) * inverse;
    return t - step * (1.0 + 0.5 * step * inverse * cp_slope_of(coefficients, t));
  }
};

/// Unguarded iteration; empty unless it converges strictly inside (low, high).
std::optional<double> quick_root(const Root& root, double t, double low, double high) {
  for (int i = 0; i < kQuickIterations; ++i) {
    const double next = root.chebyshev(t);
    if (!(next > low && next < high)) return {};
    if (std::abs(next - t) <= kChebyshevTolerance * next) return next;
    t = next;
  }
  return {};
}

/// Newton inside a shrinking bracket; excess(low) <= 0 <= excess(high).
double bracketed_root(const Root& root, double t, double low, double high) {
  t = std::clamp(t, low, high);
  for (int i = 0; i < kMaximumIterations; ++i) {
    (root.excess(t) > 0.0 ? high : low) = t;
    const double next = root.newton(t);
    if (std::abs(next - t) <= kNewtonTolerance * t) return std::clamp(next, low, high);
    t = next >= low && next <= high ? next : 0.5 * (low + high);
  }
  return t;
}

}  // namespace

double Mixture::cp(double temperature) const {
  return cp_of(temperature <= kJointTemperature ? low : high, temperature);
}

double Mixture::cp_slope(double temperature) const {
  return cp_slope_of(temperature <= kJointTemperature ? low : high, temperature);
}

double Mixture::enthalpy(double temperature) const {
  return enthalpy_of(temperature <= kJointTemperature ? low : high, temperature);
}

std::optional<double> Mixture::find_temperature(double internal_energy, double guess) const noexcept {
  if (!std::isfinite(internal_energy)) return {};
  if (constant_cp) {
    const double t = internal_energy / (low[0] - gas_constant_sum);
    return t > 0.0 && std::isfinite(t) ? std::optional(t) : std::nullopt;
  }
  const Root lower{low, gas_constant_sum, internal_energy}, upper{high, gas_constant_sum, internal_energy};
  const double round_off =
      kEnergyRoundOff * (std::abs(internal_energy) + gas_constant_sum * maximum_temperature);
  const double joint = std::min(kJointTemperature, maximum_temperature);
  // Stay one kelvin away from the joint, because both ranges may have a root there.
  if (guess < joint) {
    if (const auto t = quick_root(lower, guess, minimum_temperature, joint)) return t;
  } else if (const auto t = quick_root(upper, guess, joint + 1.0, maximum_temperature)) {
    return t;
  }
  if (!(lower.excess(minimum_temperature) <= round_off)) return {};
  if (lower.excess(joint) >= 0.0) return bracketed_root(lower, guess, minimum_temperature, joint);
  if (maximum_temperature <= joint || !(upper.excess(maximum_temperature) >= -round_off)) return {};
  if (upper.excess(joint) >= 0.0) return joint;
  return bracketed_root(upper, guess, joint, maximum_temperature);
}

double Mixture::temperature(double internal_energy, double guess) const {
  if (const auto t = find_temperature(internal_energy, guess)) return *t;
  throw DomainError("no temperature in the range " + to_text(minimum_temperature) + " to " +
                    to_text(maximum_temperature) + " K has the internal energy " +
                    to_short_text(internal_energy) + " J of " + to_short_text(mass) + " kg of gas");
}

}  // namespace gas
