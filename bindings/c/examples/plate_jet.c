/* SPDX-License-Identifier: Apache-2.0
 * Force of a jet on a square plate, which a closed form judges: 2 mdot V0.
 * usage: plate_jet [MAP.csv]      MAP.csv: centroid and overpressure of each triangle */
#include <gasjet.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define N 100 /* squares a side */

static void check(int status) {
  if (status == GASJET_OK) return;
  fprintf(stderr, "%s\n", gasjet_last_error());
  exit(1);
}

static void write_map(const char* path, double (*nodes)[3], int32_t (*triangles)[3], const double* pressure) {
  FILE* file = fopen(path, "w");
  int e;
  if (file == NULL) {
    perror(path);
    exit(1);
  }
  fprintf(file, "y_m,z_m,overpressure_Pa\n");
  for (e = 0; e < 2 * N * N; ++e) {
    const double *a = nodes[triangles[e][0]], *b = nodes[triangles[e][1]], *c = nodes[triangles[e][2]];
    fprintf(file, "%.6g,%.6g,%.6g\n", (a[1] + b[1] + c[1]) / 3.0, (a[2] + b[2] + c[2]) / 3.0, pressure[e]);
  }
  fclose(file);
}

int main(int argc, char** argv) {
  static double nodes[(N + 1) * (N + 1)][3], pressure[2 * N * N], force[3];
  static int32_t triangles[2 * N * N][3];
  const double radius = 0.03, flow = 2.0, pi = acos(-1.0);
  gasjet_outlet_state outlet;
  gasjet_jet_model model;
  gasjet_handle jet;
  int i, j;

  for (i = 0; i <= N; ++i)
    for (j = 0; j <= N; ++j) {
      double* x = nodes[i * (N + 1) + j];
      x[0] = 0.5, x[1] = (double)i / N - 0.5, x[2] = (double)j / N - 0.5;
    }
  for (i = 0; i < N; ++i)
    for (j = 0; j < N; ++j) {
      const int32_t a = i * (N + 1) + j, b = a + N + 1;
      int32_t* t = triangles[2 * (i * N + j)];
      t[0] = a, t[1] = b, t[2] = b + 1; /* seen from +x, away from the jet, counter-clockwise */
      t[3] = a, t[4] = b + 1, t[5] = a + 1;
    }
  check(gasjet_jet_defaults(&model));
  for (i = 0; i < 3; ++i) model.centre[i] = 0.0, model.axis[i] = i == 0;
  model.radius = radius;
  model.decay_coefficient = 0.08;
  model.cut_off = 1e-6;
  check(gasjet_outlet(GASJET_SONIC_STATIC, pi * radius * radius, flow, 400.0, 1038.8, 296.8, 0.0, &outlet));
  check(gasjet_jet_create(&model, triangles[0], 2 * N * N, NULL, (N + 1) * (N + 1), NULL, 0, NULL, 0, &jet));
  check(gasjet_jet_pressure(jet, nodes[0], (N + 1) * (N + 1), NULL, outlet.velocity, outlet.density, 1, NAN, pressure,
                            2 * N * N, force, NULL));
  check(gasjet_free(jet));
  if (argc > 1) write_map(argv[1], nodes, triangles, pressure);
  printf("force %.4f N, closed form %.4f N\n", force[0], 2.0 * flow * outlet.velocity);
  return fabs(force[0] / (2.0 * flow * outlet.velocity) - 1.0) < 1e-4 ? 0 : 1;
}
