/* SPDX-License-Identifier: Apache-2.0
 * usage: run_case CASE.toml     runs a case and prints pressure against time */
#include <gasjet.h>
#include <stdio.h>

static int show(double time, double end, void* user) {
  fprintf((FILE*)user, "%3.0f %%\n", 100.0 * time / end);
  return 0;
}

int main(int argc, char** argv) {
  gasjet_handle run = 0;
  int64_t columns, rows, i;
  const double *time, *pressure;

  if (argc != 2) return 2;
  if (gasjet_run(argv[1], NULL, NULL, NULL, 1, show, stderr, &run) != GASJET_OK ||
      gasjet_run_size(run, GASJET_HISTORY, &columns, &rows) != GASJET_OK ||
      gasjet_run_find(run, GASJET_HISTORY, "time_s", &time) != GASJET_OK ||
      gasjet_run_find(run, GASJET_HISTORY, "pressure_Pa", &pressure) != GASJET_OK) {
    fprintf(stderr, "%s\n", gasjet_last_error());
    return 1;
  }
  for (i = 0; i < rows; i += rows > 10 ? rows / 10 : 1) printf("%10.4f s %12.1f Pa\n", time[i], pressure[i]);
  return gasjet_free(run);
}
