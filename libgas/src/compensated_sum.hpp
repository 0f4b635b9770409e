// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

namespace gas {

/// A sum of any number of terms, accurate to one rounding of its value. Source: A. Neumaier, Z. angew. Math.
/// Mech. 54 (1974) 39.
class CompensatedSum {
 public:
  CompensatedSum& operator=(double value) {
    sum_ = value;
    lost_ = 0.0;
    return *this;
  }
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0, lost_ = 0.0;
};

}  // namespace gas
