// SPDX-License-Identifier: Apache-2.0
#include "scene/gas_curve.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace driver {

namespace {

// The part from 0 on of a curve that is zero outside and, as records before firing, 0 before. Its first knot
// from 0 on is 0 too, or it would rise from the last one before.
CurveData from_zero_on(const CurveData& data) {
  CurveData rest{{0.0}, {0.0}};
  bool is_first = true;
  for (std::size_t i = 0; i < data.time.size(); ++i) {
    if (is_first && data.value[i] != 0.0) break;
    if (data.time[i] < 0.0) continue;
    if (!is_first || data.time[i] > 0.0)
      rest.time.push_back(data.time[i]), rest.value.push_back(data.value[i]);
    is_first = false;
  }
  if (is_first)
    throw std::invalid_argument(fmt::format(
        "its first knot is at {} s: time counts from firing, allowed: 0 or more, or values of 0 before",
        data.time.front()));
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
