// SPDX-License-Identifier: Apache-2.0
// An object of every kind: made, used, refused and freed. Run under valgrind, which finds what is not given
// back. usage: every_kind CASE.toml
#include <gasjet.h>
#include <gasjet_exact.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int status, int wanted) {
  if (status == wanted) return;
  fprintf(stderr, "every_kind: %d %s\n", status, gasjet_last_error());
  exit(1);
}

static int stop(double time, double end, void* user) {
  return time <= end && user == NULL;
}

static const double nodes[] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
static const double not_finite[] = {0.0, 0.0, 0.0, NAN, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
static const int32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
static const int32_t wrong[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 9};
enum { NODES = 4, TRIANGLES = 4 };

static void gas_and_tank(void) {
  gasjet_handle gas, tank, none;
  gasjet_gas_values values;
  check(gasjet_gas_create("N2=0.7, CO2=0.3", 0.0, &gas), GASJET_OK);
  check(gasjet_gas_create("N2=0.7, XY=0.3", 0.0, &none), GASJET_BAD_INPUT);
  check(gasjet_gas_evaluate(gas, 500.0, &values), GASJET_OK);
  check(gasjet_gas_evaluate(gas, 50.0, &values), GASJET_DOMAIN);
  const double time[] = {0.0, 1.0}, flow[] = {0.1, 0.1}, temperature[] = {500.0, 500.0};
  check(gasjet_tank_create(gas, 2e5, 300.0, 0.06, 1e5, 1e-8, &tank), GASJET_OK);
  check(gasjet_tank_add_inflow(tank, gas, 2, time, flow, temperature, 0.0), GASJET_OK);
  check(gasjet_tank_add_vent(tank, 0.6, 1e-3, 0.0), GASJET_OK);
  check(gasjet_tank_add_backflow(tank, 0, gas, 300.0), GASJET_OK);
  check(gasjet_tank_add_backflow(tank, 1, gas, 300.0), GASJET_BAD_INPUT);
  check(gasjet_free(gas), GASJET_OK);
  check(gasjet_tank_advance(tank, 0.1, 0.06), GASJET_OK);
  check(gasjet_tank_set_vent(tank, 0, 2e-3), GASJET_OK);
  check(gasjet_tank_set_heat_loss(tank, 10.0, 300.0), GASJET_OK);
  check(gasjet_tank_advance(tank, 0.2, 0.06), GASJET_OK);
  char names[20];
  int64_t size;
  double mass[2], amount[2];
  check(gasjet_tank_species(tank, names, sizeof names, &size), GASJET_OK);
  check(gasjet_tank_masses(tank, mass, amount, 2), GASJET_OK);
  check(gasjet_tank_advance(tank, 0.1, 0.06), GASJET_BAD_INPUT);
  check(gasjet_free(tank), GASJET_OK);
}

static void jet_and_surface(void) {
  gasjet_handle jet, surface, none;
  gasjet_jet_model model;
  double pressure[TRIANGLES], force[3];
  uint8_t lit[TRIANGLES];
  const gasjet_source source = {{0.1, 0.1, 0.1}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.05};
  check(gasjet_jet_defaults(&model), GASJET_OK);
  for (int i = 0; i < 3; ++i) model.centre[i] = 0.1, model.axis[i] = i == 0;
  model.radius = 0.05;
  model.decay_coefficient = 0.08;
  check(gasjet_jet_create(&model, triangles, TRIANGLES, NULL, NODES, NULL, 0, NULL, 0, &jet), GASJET_OK);
  check(gasjet_jet_create(&model, wrong, TRIANGLES, NULL, NODES, NULL, 0, NULL, 0, &none), GASJET_BAD_INPUT);
  check(gasjet_surface_create(triangles, TRIANGLES, NULL, NODES, NULL, 0, NULL, 0, &surface), GASJET_OK);
  check(gasjet_jet_expansion(jet, 1.2, 0.9, NAN), GASJET_OK);
  check(gasjet_jet_expansion(jet, 0.0, 0.9, NAN), GASJET_BAD_INPUT);
  for (int i = 0; i < 3; ++i) {
    check(gasjet_jet_pressure(jet, nodes, NODES, NULL, 400.0, 1.0, 1, 1e-3 * i, pressure, TRIANGLES, force,
                              NULL),
          GASJET_OK);
    check(gasjet_surface_visible(surface, nodes, NODES, NULL, &source, NULL, 0, NAN, lit, TRIANGLES, NULL),
          GASJET_OK);
  }
  check(gasjet_surface_visible(surface, not_finite, NODES, NULL, &source, NULL, 0, NAN, lit, TRIANGLES, NULL),
        GASJET_BAD_INPUT);
  check(gasjet_free(jet), GASJET_OK);
  check(gasjet_free(surface), GASJET_OK);
}

static void moved_jet(void) {
  gasjet_handle jet;
  gasjet_jet_model model;
  double pressure[TRIANGLES], force[3], power;
  float single[3 * NODES];
  const double centre[] = {0.12, 0.1, 0.1}, axis[] = {1.0, 0.1, 0.0}, velocities[3 * NODES] = {0.0};
  const uint8_t on[] = {1, 1, 0, 1};
  const int32_t some[] = {3, 0}, twice[] = {3, 3};
  for (int i = 0; i < 3 * NODES; ++i) single[i] = (float)nodes[i];
  check(gasjet_jet_defaults(&model), GASJET_OK);
  for (int i = 0; i < 3; ++i) model.centre[i] = 0.1, model.axis[i] = i == 0;
  model.radius = 0.05;
  model.decay_coefficient = 0.08;
  check(gasjet_jet_create(&model, triangles, TRIANGLES, NULL, NODES, NULL, 0, NULL, 0, &jet), GASJET_OK);
  for (int n = 1; n < 4; ++n) {
    check(gasjet_jet_pressure_of(jet, nodes, NODES, NULL, velocities, NULL, 400.0, 1.0, 1, 1e-3 * n, some, 2,
                                 pressure, 2, force, &power, NULL),
          GASJET_OK);
    check(gasjet_jet_place(jet, centre, axis, NULL), GASJET_OK);
    check(gasjet_jet_pressure_float(jet, single, NODES, NULL, NULL, NULL, 400.0, 1.0, 1, NAN, NULL, 0,
                                    pressure, TRIANGLES, force, NULL, NULL),
          GASJET_OK);
    check(gasjet_jet_set_elements(jet, on, TRIANGLES), GASJET_OK);
    check(gasjet_jet_subdivide(jet, n), GASJET_OK);
  }
  check(gasjet_jet_pressure_of(jet, nodes, NODES, NULL, NULL, NULL, 400.0, 1.0, 1, NAN, twice, 2, pressure, 2,
                               force, NULL, NULL),
        GASJET_BAD_INPUT);
  check(gasjet_jet_relative_to_skin(jet, 1), GASJET_OK);
  check(gasjet_jet_pressure(jet, nodes, NODES, NULL, 400.0, 1.0, 1, NAN, pressure, TRIANGLES, force, NULL),
        GASJET_BAD_INPUT);
  check(gasjet_free(jet), GASJET_OK);
}

static void membrane_and_contact(void) {
  gasjet_handle membrane, contact, body, none;
  const gasjet_impactor disc = {GASJET_DISC, {0.2, 0.1, 0.0}};
  const double axes[] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  gasjet_fabric_model fabric = {4e-4, 800.0, 3e8, 0.3, 1, GASJET_HENCKY};
  gasjet_membrane_sums sums;
  gasjet_contact_sums touch;
  double mass[NODES], force[3 * NODES] = {0.0};
  const double centre[] = {0.3, 0.3, -0.15};
  check(gasjet_membrane_create(nodes, NODES, NULL, triangles, TRIANGLES, NULL, &fabric, NULL, 0, NULL, 0,
                               &membrane),
        GASJET_OK);
  check(gasjet_membrane_masses(membrane, mass, NODES), GASJET_OK);
  check(gasjet_membrane_evaluate(membrane, nodes, NODES, NULL, 1.4, 1e5, force, NULL, 3 * NODES, &sums),
        GASJET_OK);
  check(gasjet_contact_create(nodes, NODES, NULL, triangles, TRIANGLES, NULL, mass, 1.0, 0.2, 1e5, 0.1,
                              &contact),
        GASJET_OK);
  check(gasjet_contact_evaluate(contact, nodes, NODES, NULL, centre, NULL, force, 3 * NODES, &touch),
        GASJET_OK);
  check(gasjet_contact_create_body(nodes, NODES, NULL, triangles, TRIANGLES, NULL, mass, 1.0, &disc, 1e5, 0.1,
                                   &body),
        GASJET_OK);
  check(gasjet_contact_evaluate_body(body, nodes, NODES, NULL, centre, axes, NULL, force, 3 * NODES, &touch),
        GASJET_OK);
  check(gasjet_free(body), GASJET_OK);
  fabric.thickness = -1.0;
  check(gasjet_membrane_create(nodes, NODES, NULL, triangles, TRIANGLES, NULL, &fabric, NULL, 0, NULL, 0,
                               &none),
        GASJET_BAD_INPUT);
  check(gasjet_free(membrane), GASJET_OK);
  check(gasjet_free(contact), GASJET_OK);
}

static void rigid_body(void) {
  gasjet_rigid_body_model model;
  gasjet_rigid_body_state state;
  gasjet_rigid_body_point point;
  gasjet_rigid_body_kick kick;
  const gasjet_impactor disc = {GASJET_DISC, {0.2, 0.1, 0.0}};
  const double push[] = {0.0, 0.0, 1.0}, time[] = {0.0, 0.01};
  double reach, mass, frequency, criterion;
  check(gasjet_rigid_body_defaults(&model), GASJET_OK);
  check(gasjet_rigid_body_start(&model, &state), GASJET_BAD_INPUT);
  model.mass = 2.0;
  for (int i = 0; i < 3; ++i)
    model.centre[i] = 0.0, model.inertia[4 * i] = 0.1, model.angular_velocity[i] = i;
  check(gasjet_impactor_reach(&disc, &reach), GASJET_OK);
  check(gasjet_rigid_body_start(&model, &state), GASJET_OK);
  for (int n = 0; n < 3; ++n) {
    check(gasjet_rigid_body_evaluate(&model, &state, &point), GASJET_OK);
    check(gasjet_rigid_body_limits(&model, reach, 1.0, &mass, &frequency), GASJET_OK);
    check(gasjet_rigid_body_advance(&model, push, n == 0 ? NULL : push, n == 0 ? 0.0 : 1e-3, 1e-3, &state,
                                    n == 0 ? NULL : &kick),
          GASJET_OK);
  }
  check(gasjet_rigid_body_advance(&model, push, push, -1.0, 1e-3, &state, &kick), GASJET_BAD_INPUT);
  model.motion = GASJET_ON_RAIL;
  model.inertia[0] = NAN;
  check(gasjet_rigid_body_start(&model, &state), GASJET_BAD_INPUT);
  check(gasjet_head_injury_criterion(time, nodes, 2, NULL, 0.015, &criterion), GASJET_OK);
  check(gasjet_head_injury_criterion(time, nodes, 2, NULL, 1.0, &criterion), GASJET_BAD_INPUT);
}

static void skin_contact(void) {
  gasjet_handle contact, none;
  gasjet_skin_contact_sums touch;
  double mass[] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, force[18] = {0.0};
  double layers[] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0,
                     0.0, 0.0, 0.2, 1.0, 0.0, 0.2, 0.0, 1.0, 0.2};
  const int32_t two[] = {0, 1, 2, 3, 4, 5};
  check(gasjet_skin_contact_create(layers, 6, NULL, two, 2, NULL, mass, 0.1, 1e5, 0.1, &contact), GASJET_OK);
  check(gasjet_skin_contact_create(layers, 6, NULL, two, 2, NULL, mass, 0.9, 1e5, 0.1, &none),
        GASJET_BAD_INPUT);
  for (int level = 0; level < 3; ++level) {
    for (int i = 11; i < 18; i += 3) layers[i] = 0.2 - 0.15 * level;
    check(gasjet_skin_contact_evaluate(contact, layers, 6, NULL, force, 18, &touch),
          level < 2 ? GASJET_OK : GASJET_DOMAIN);
  }
  check(gasjet_skin_contact_restart(contact), GASJET_OK);
  check(gasjet_skin_contact_evaluate(contact, layers, 6, NULL, force, 18, &touch), GASJET_OK);
  check(gasjet_free(contact), GASJET_OK);
}

static void run_and_closed_form(const char* file) {
  gasjet_handle run, table;
  const double* values;
  const double times[] = {0.0, 0.1};
  check(gasjet_run(file, NULL, "scene.end_time=0.02", NULL, 2, NULL, NULL, &run), GASJET_OK);
  check(gasjet_run_find(run, GASJET_HISTORY, "pressure_Pa", &values), GASJET_OK);
  check(gasjet_free(run), GASJET_OK);
  check(gasjet_run(file, NULL, "scene.end_time=0.02", NULL, 1, stop, NULL, &run), GASJET_STOPPED);
  check(gasjet_free(run), GASJET_OK);
  check(gasjet_run(file, NULL, "scene.end=0.02", NULL, 1, NULL, NULL, &run), GASJET_BAD_INPUT);
  check(gasjet_exact_create("blowdown", "volume=0.03", times, 2, &table), GASJET_OK);
  check(gasjet_exact_free(table), GASJET_OK);
}

static void simulation(const char* file) {
  gasjet_handle sim, clone, run;
  check(gasjet_sim_create(file, NULL, "scene.end_time=0.02", NULL, 1, &sim), GASJET_OK);
  check(gasjet_sim_step(sim, 2), GASJET_OK);
  check(gasjet_sim_set_vent(sim, 0, 1e-3), GASJET_OK);
  check(gasjet_sim_set_vent(sim, 9, 1e-3), GASJET_BAD_INPUT);
  check(gasjet_sim_clone(sim, &clone), GASJET_OK);
  check(gasjet_sim_advance(sim, 0.01, 1, NULL, NULL), GASJET_OK);
  check(gasjet_sim_assign(sim, clone), GASJET_OK);
  check(gasjet_sim_results(sim, &run), GASJET_OK);
  check(gasjet_free(run), GASJET_OK);
  check(gasjet_free(clone), GASJET_OK);
  check(gasjet_free(sim), GASJET_OK);
}

int main(int count, char** arguments) {
  if (count != 2) return 2;
  gas_and_tank();
  jet_and_surface();
  moved_jet();
  membrane_and_contact();
  rigid_body();
  skin_contact();
  run_and_closed_form(arguments[1]);
  simulation(arguments[1]);
  puts("an object of every kind was made and freed");
}
