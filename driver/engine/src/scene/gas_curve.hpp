// SPDX-License-Identifier: Apache-2.0
// Curves of a case as libgas takes them.
#pragma once

#include "base/curve_reader.hpp"
#include "gas/curve.hpp"

namespace driver {

/// A constant, or zero (mass flow) or held (temperature) outside the knots.
gas::Curve to_gas_curve(const CurveData& data, gas::Outside outside);

}  // namespace driver
