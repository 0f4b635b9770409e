/* SPDX-License-Identifier: Apache-2.0
 * A tank empties through a hole. Returns 0 if the library agrees with the closed form, and says what is wrong with a tank that has none. */
#include <gasjet.h>
#include <gasjet_exact.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  gasjet_handle gas, tank, table;
  gasjet_tank_state state;
  const double time = 0.1, *pressure;
  double off;

  if (gasjet_gas_create_ideal(296.8, 1038.8, &gas) || gasjet_tank_create(gas, 5e5, 600.0, 0.06, 101325.0, 1e-10, &tank) ||
      gasjet_tank_add_vent(tank, 1.0, 1e-3, 0.0) || gasjet_tank_advance(tank, time, 0.06) || gasjet_tank_read(tank, &state)) {
    printf("C: %s\n", gasjet_last_error());
    return 1;
  }
  if (gasjet_exact_create("blowdown", NULL, &time, 1, &table) || gasjet_exact_column(table, 1, &pressure)) {
    printf("C: %s\n", gasjet_exact_last_error());
    return 1;
  }
  off = fabs(state.pressure / pressure[0] - 1.0);
  if (gasjet_tank_create(gas, 5e5, 600.0, -1.0, 101325.0, 1e-10, &tank) != GASJET_BAD_INPUT ||
      strncmp(gasjet_last_error(), "volume: ", 8) != 0)
    return 1;
  printf("C: off by %.0e: %s\n", off, off < 1e-8 ? "holds" : "differs"); /* the tank's tolerance, a hundredfold */
  return off < 1e-8 ? 0 : 1;
}
