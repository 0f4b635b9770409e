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

Entry described(const char* name, const char* title, const char* equation, const char* source,
                const char* validity, int digits) {
  return {name, title, equation, source, validity, digits, {}, {}, {}, {}};
}

void add_parameter(Entry& entry, const char* name, const char* symbol, const char* unit, double default_value,
                   const char* meaning) {
  entry.parameters.push_back({name, symbol, unit, default_value, meaning});
}

}  // namespace closed_form::entries
