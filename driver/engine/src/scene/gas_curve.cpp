// SPDX-License-Identifier: Apache-2.0
#include "scene/gas_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace driver {

namespace {

// Takes off the knots before 0, from which on a curve that is zero outside counts, if it is zero there.
// Records begin before firing.
CurveData from_zero_on(const CurveData& data) {
  const auto first = std::ranges::find_if(data.time, [](double t) { return t >= 0.0; }) - data.time.begin();
  const auto flow = std::ranges::find_if(data.value, [](double v) { return v != 0.0; }) - data.value.begin();
  if (first == std::ssize(data.time) || flow <= first)
    throw std::invalid_argument(fmt::format(
        "its first knot is at {} s: time counts from firing, allowed: 0 or more, or values of 0 before",
        data.time.front()));
  CurveData rest{{0.0}, {0.0}};
  rest.time.insert(rest.time.end(), data.time.begin() + first + (data.time[first] == 0.0), data.time.end());
  rest.value.insert(rest.value.end(), data.value.begin() + first + (data.time[first] == 0.0),
                    data.value.end());
  return rest;
}

}  // namespace

gas::Curve to_gas_curve(const CurveData& data, gas::Outside outside) {
  if (data.time.empty()) return gas::Curve::constant(data.value.front());
  if (outside == gas::Outside::zero && data.time.front() < 0.0)
    return to_gas_curve(from_zero_on(data), outside);
  std::vector<gas::Curve::Knot> knots;
  for (std::size_t i = 0; i < data.time.size(); ++i) knots.push_back({data.time[i], data.value[i]});
  return {std::move(knots), outside};
}

}  // namespace driver
