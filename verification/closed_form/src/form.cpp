// SPDX-License-Identifier: Apache-2.0
#include "form.hpp"

#include <cmath>

namespace closed_form::entries {

Row range(double first, double last, int n) {
  Row values;
  for (int i = 0; i <= n; ++i) values.push_back(i == n ? last : first + (last - first) * i / n);
  return values;
}

int whole(const std::string& name, double value) {
  if (!(std::abs(value) <= 1e6) || value != std::floor(value))
    check::refuse(name, value, "must be a whole number of magnitude <= 1e6");
  return static_cast<int>(value);
}

}  // namespace closed_form::entries
