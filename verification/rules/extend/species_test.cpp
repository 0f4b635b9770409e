// SPDX-License-Identifier: Apache-2.0
// A species added as rows of the table is known by its name, with the heat capacity of its row.
#include <cmath>
#include <cstdio>

#include "gas/thermo.hpp"

int main() {
  const gas::Thermo thermo({gas::nasa7_species("Kr")});
  const double cp = thermo.cp(0, 500.0), expected = 2.5 * gas::kMolarGasConstant / 0.083798;
  if (std::abs(cp - expected) < 1e-9 * expected) return 0;
  std::printf("cp of Kr: %.9g, expected %.9g\n", cp, expected);
  return 1;
}
