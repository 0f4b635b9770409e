// SPDX-License-Identifier: Apache-2.0
#include "closed_form/common.hpp"

#include "check.hpp"

namespace closed_form {

double specific_heat_cp(const PerfectGas& gas) {
  check::gas(gas);
  return gas.heat_capacity_ratio * gas.gas_constant / (gas.heat_capacity_ratio - 1.0);
}

double specific_heat_cv(const PerfectGas& gas) {
  check::gas(gas);
  return gas.gas_constant / (gas.heat_capacity_ratio - 1.0);
}

}  // namespace closed_form
