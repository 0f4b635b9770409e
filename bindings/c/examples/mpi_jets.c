/* SPDX-License-Identifier: Apache-2.0
 * A jet on a bag whose elements are shared out over MPI ranks. Each rank moves the nodes of its own elements,
 * gets the positions of all others from their ranks, and asks Gasjet for its own elements. The gathered
 * overpressure has the bits of one process that asks for all.
 * usage: mpirun -n RANKS mpi_jets */
#include <gasjet.h>
#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RINGS = 20, SECTORS = 36, NODES = 2 + (RINGS - 1) * SECTORS, ELEMENTS = 2 * (RINGS - 1) * SECTORS };

static double nodes[NODES][3], mine[NODES][3];
static int32_t triangles[ELEMENTS][3], list[ELEMENTS];
static double part[ELEMENTS], all[ELEMENTS], whole[ELEMENTS];

static void check(int status) {
  if (status == GASJET_OK) return;
  fprintf(stderr, "%s\n", gasjet_last_error());
  MPI_Abort(MPI_COMM_WORLD, 1);
}

static int32_t at(int ring, int sector) {
  return 1 + (ring - 1) * SECTORS + sector % SECTORS;
}

static int32_t* add(int32_t* t, int32_t a, int32_t b, int32_t c) {
  t[0] = a, t[1] = b, t[2] = c;
  return t + 3;
}

/* A sphere of rings about the x axis between two poles; seen from outside, corners run counter-clockwise. */
static void make_triangles(void) {
  int32_t* t = triangles[0];
  int i, j;
  for (i = 1; i < RINGS; ++i)
    for (j = 0; j < SECTORS; ++j) {
      if (i == 1) t = add(t, 0, at(1, j + 1), at(1, j));
      if (i == RINGS - 1) t = add(t, NODES - 1, at(i, j), at(i, j + 1));
      if (i == RINGS - 1) continue;
      t = add(t, at(i, j), at(i, j + 1), at(i + 1, j));
      t = add(t, at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    }
}

/* Where a node is at a time [s]: a bag with waves, which hide parts of it. */
static void move(int node, double time, double x[3]) {
  const double pi = acos(-1.0);
  const int ring = node == 0 ? 0 : node == NODES - 1 ? RINGS : 1 + (node - 1) / SECTORS;
  const double across = pi * ring / RINGS, around = 2.0 * pi * ((node - 1) % SECTORS) / SECTORS;
  const double radius = 0.3 + 0.15 * sin(20.0 * across + 60.0 * time) * cos(3.0 * around);
  x[0] = -radius * cos(across);
  x[1] = radius * sin(across) * cos(around);
  x[2] = radius * sin(across) * sin(around);
}

int main(int argc, char** argv) {
  const double axis[3] = {1.0, 0.0, 0.0};
  double force[3], total[3];
  gasjet_jet_model model;
  gasjet_visibility seen, sum;
  gasjet_handle jet, alone;
  int rank, ranks, first, last, step, i;

  MPI_Init(&argc, &argv);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  make_triangles();
  check(gasjet_jet_defaults(&model));
  for (i = 0; i < 3; ++i) model.centre[i] = 0.0, model.axis[i] = axis[i];
  model.radius = 0.05;
  model.decay_coefficient = 0.08;
  check(gasjet_jet_create(&model, triangles[0], ELEMENTS, NULL, NODES, NULL, 0, NULL, 0, &jet));
  check(gasjet_jet_create(&model, triangles[0], ELEMENTS, NULL, NODES, NULL, 0, NULL, 0, &alone));

  first = ELEMENTS * rank / ranks, last = ELEMENTS * (rank + 1) / ranks;
  for (i = first; i < last; ++i) list[i - first] = i;
  for (step = 0; step < 20; ++step) {
    const double time = 1e-3 * step, centre[3] = {-0.12, 0.004 * step, 0.0};
    memset(mine, 0, sizeof mine);
    for (i = NODES * rank / ranks; i < NODES * (rank + 1) / ranks; ++i) move(i, time, mine[i]);
    MPI_Allreduce(mine, nodes, 3 * NODES, MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD); /* all positions, on every rank */
    check(gasjet_jet_place(jet, centre, axis, NULL));
    check(gasjet_jet_pressure_of(jet, nodes[0], NODES, NULL, NULL, NULL, 400.0, 1.2, 1, NAN, list,
                                 last - first, part, last - first, force, NULL, &seen));
    memset(whole, 0, sizeof whole);
    memcpy(whole + first, part, sizeof *part * (size_t)(last - first));
    MPI_Allreduce(whole, all, ELEMENTS, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    MPI_Allreduce(force, total, 3, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    MPI_Allreduce(&seen, &sum, 4, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);

    check(gasjet_jet_place(alone, centre, axis, NULL));
    check(
        gasjet_jet_pressure(alone, nodes[0], NODES, NULL, 400.0, 1.2, 1, NAN, whole, ELEMENTS, force, &seen));
    if (memcmp(all, whole, sizeof all) != 0 || sum.hidden != seen.hidden || sum.lit != seen.lit ||
        fabs(total[0] - force[0]) > 1e-12 * force[0]) {
      fprintf(stderr, "rank %d: step %d differs from one process\n", rank, step);
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
    if (rank == 0 && step % 5 == 0)
      printf("%d ms: %.1f N, %d lit, %d hidden, same bits as one process\n", step, total[0], (int)sum.lit,
             (int)sum.hidden);
  }
  check(gasjet_free(jet));
  check(gasjet_free(alone));
  MPI_Finalize();
  return 0;
}
