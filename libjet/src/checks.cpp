// SPDX-License-Identifier: Apache-2.0
#include "checks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace jet {
namespace {

constexpr double kSmallest = 1e-100;

bool allowed(double x) {
  return x == 0.0 || (std::abs(x) >= kSmallest && std::abs(x) <= kLargest);
}

/// 17 digits, so that 1e-120 is not shown as 0.
std::string text(double value) {
  return (std::ostringstream() << std::setprecision(17) << value).str();
}

void require_coordinates(const char* name, const Eigen::Vector3d& vector) {
  for (const double x : vector) {
    if (!allowed(x))
      refuse(std::string(name) + " has coordinate " + text(x) + ", allowed: 0 or 1e-100 to 1e100");
  }
}

}  // namespace

void refuse(const std::string& message) {
  throw std::invalid_argument("visibility " + message);
}

void require_index(const char* name, int index, int count) {
  if (index < 0 || index >= count) {
    refuse(std::string(name) + " " + std::to_string(index) + ", allowed: 0 to " + std::to_string(count - 1));
  }
}

void check_source(const RaySource& source) {
  require_coordinates("source centre", source.centre);
  require_coordinates("source axis", source.axis);
  if (source.axis.isZero(0.0)) refuse("source axis is zero");
  if (!(source.half_long >= 0.0 && allowed(source.half_long))) {
    refuse("source half_long is " + text(source.half_long) + ", allowed: 0 or 1e-100 to 1e100");
  }
  if (source.half_long == 0.0) return;
  require_coordinates("source long_direction", source.long_direction);
  if (source.long_direction.isZero(0.0)) refuse("source long_direction is zero");
  if (!(source.half_long * source.long_direction.cwiseAbs().maxCoeff() <= kLargest))
    refuse("source is too long");
}

// Magnitudes are compared by their bits, which order like the values and put infinities and NaN above every
// number.
double check_nodes(const Surface& surface) {
  constexpr std::uint64_t smallest = std::bit_cast<std::uint64_t>(kSmallest);
  constexpr std::uint64_t magnitude = ~std::uint64_t{0} >> 1;
  std::uint64_t largest = 0;
  bool tiny = false;
  for (int i = 0; i < surface.node_count; ++i) {
    for (int j = 0; j < 3; ++j) {
      const std::uint64_t bits = std::bit_cast<std::uint64_t>(surface.node(i)[j]) & magnitude;
      tiny |= bits - 1 < smallest - 1;  // 0 wraps around and passes
      largest = std::max(largest, bits);
    }
  }
  if (!tiny && largest <= std::bit_cast<std::uint64_t>(kLargest)) return std::bit_cast<double>(largest);
  for (int i = 0; i < surface.node_count; ++i) {
    const double* x = surface.node(i);
    require_coordinates(("node " + std::to_string(surface.name(i))).c_str(), {x[0], x[1], x[2]});
  }
  return kLargest;
}

}  // namespace jet
