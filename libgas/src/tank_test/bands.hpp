// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gsl_objects.hpp"
#include "inversion.hpp"

namespace gas {

/// Inversion of one draw of the pressures.
struct Sample {
  FlowCurves flow;
  std::vector<double> enthalpy_flow;  // K [kg K/s]
};

/// Independent standard normal numbers, the same in every run.
class NormalNumbers {
 public:
  explicit NormalNumbers(unsigned long seed);
  std::span<const double> operator()(std::size_t count);

 private:
  gsl::Generator generator_;
  std::vector<double> numbers_;
};

/// 95 % band of a normal number, from the scatter of its draws.
Band band_of(double value, std::span<const double> draws);

/// Sets bands and amplifications of `result` from the samples.
void add_bands(std::span<const Sample> samples, Identified& result);

}  // namespace gas
