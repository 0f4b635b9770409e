// SPDX-License-Identifier: Apache-2.0
#include "scene/gas_curve.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace driver {

gas::Curve to_gas_curve(const CurveData& data, gas::Outside outside) {
  if (outside == gas::Outside::zero && !data.time.empty() && data.time.front() < 0.0)
    throw std::invalid_argument(fmt::format(
        "its first knot is at {} s: time counts from firing, allowed: 0 or more", data.time.front()));
  if (data.time.empty()) return gas::Curve::constant(data.value.front());
  std::vector<gas::Curve::Knot> knots;
  for (std::size_t i = 0; i < data.time.size(); ++i) knots.push_back({data.time[i], data.value[i]});
  return {std::move(knots), outside};
}

}  // namespace driver
