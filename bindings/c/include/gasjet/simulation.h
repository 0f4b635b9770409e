// SPDX-License-Identifier: Apache-2.0
/* A case that the caller steps, reads and changes; without changes it has the bits of gasjet_run. */
#ifndef GASJET_SIMULATION_H
#define GASJET_SIMULATION_H

#include <gasjet/gas.h>
#include <gasjet/run.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A step has two halves. Evaluation finds gas, forces and the length of the step that leaves the level, where
 * the simulation is; the step then moves to the next level. Functions that need the first half do it. A
 * computation that leaves its domain gives GASJET_DOMAIN, then and at later calls; what was computed stays
 * readable. */

/* Creates a simulation at time 0. The arguments are those of gasjet_run. With `out` the command's files are
 * written while it goes on, and completed by gasjet_sim_finish or when it is freed. */
GASJET_API int gasjet_sim_create(const char* case_file, const char* GASJET_OR_NULL case_text,
                                 const char* GASJET_OR_NULL overrides, const char* GASJET_OR_NULL out,
                                 int threads, gasjet_handle* sim);

/* A simulation in the same state, which goes on by itself. It has the rows so far, but no folder. */
GASJET_API int gasjet_sim_clone(gasjet_handle sim, gasjet_handle* clone);

/* Gives a simulation the state and the rows of another one of the same case: of one that was cloned from it,
 * or from which it was cloned, at any time. Not for a simulation with a folder. */
GASJET_API int gasjet_sim_assign(gasjet_handle sim, gasjet_handle from);

/* The state and all that was set, as bytes for a file or another process; only the same build reads them, for
 * the same case. Sizes as in gasjet_run_summary. */
GASJET_API int gasjet_sim_save(gasjet_handle sim, uint8_t GASJET_OR_NULL bytes[], int64_t size,
                               int64_t* needed);

/* Gives a simulation of the same case that state; further steps have the same bits. It keeps its rows.
 * Damaged bytes: GASJET_BAD_INPUT, and nothing changes. Not for a simulation with a folder. */
GASJET_API int gasjet_sim_restore(gasjet_handle sim, const uint8_t bytes[], int64_t size);

/* Back to time 0 of the case, without any change. Not for a simulation with a folder. */
GASJET_API int gasjet_sim_reset(gasjet_handle sim);

/* Where it is: the level's time [s] and number; ended: not 0 at the end of the scene. */
GASJET_API int gasjet_sim_time(gasjet_handle sim, double* time, int64_t* steps, int* ended);

/* The first half of the step. step [s]: length of the step that leaves the level; limit [s]: its bound by
 * stability. */
GASJET_API int gasjet_sim_evaluate(gasjet_handle sim, double* step, double* limit);

/* count >= 0 steps, fewer at the end of the scene; GASJET_BAD_INPUT if it is there already. */
GASJET_API int gasjet_sim_step(gasjet_handle sim, int64_t count);

/* Steps until the level is at or past `time` [s] or at the end. exactly: not 0 to shorten steps so that
 * `time` is met. progress is called some ten times a second, as in gasjet_run; a result other than 0 stops.
 * Without it the call cannot be stopped. */
GASJET_API int gasjet_sim_advance(gasjet_handle sim, double time, int exactly,
                                  gasjet_progress GASJET_OR_NULL progress, void* GASJET_OR_NULL user);

/* Steps meet the multiples of an interval [s] from now on, at which the caller exchanges values with another
 * program; 0: of none. Between two of them steps are equal, as they are not if each is met by an exact
 * advance. */
GASJET_API int gasjet_sim_meet_every(gasjet_handle sim, double interval);

/* Evaluates the last level if that is reached, and completes the files of a folder. Later steps add nothing
 * to them. */
GASJET_API int gasjet_sim_finish(gasjet_handle sim);

/* The rows so far as a run, for the functions of gasjet/run.h, with a summary. */
GASJET_API int gasjet_sim_results(gasjet_handle sim, gasjet_handle* run);

/* every: not 0 to record each level in the tables, not only those that the case asks for. */
GASJET_API int gasjet_sim_record(gasjet_handle sim, int every);

/* Arrays of a simulation, without copies. */
enum gasjet_sim_array {
  GASJET_SIM_POSITION = 0,        /* [m] nodes, of the level */
  GASJET_SIM_VELOCITY = 1,        /* [m/s] nodes, half a step before the level */
  GASJET_SIM_FABRIC_FORCE = 2,    /* [N] nodes, of the level */
  GASJET_SIM_VOLUME_GRADIENT = 3, /* [m2] nodes, of the level; times p - p_a the pressure's force */
  GASJET_SIM_CONTACT_FORCE = 4,   /* [N] nodes; empty without contact; this and the next two as evaluated */
  GASJET_SIM_JET_FORCE = 5,       /* [N] nodes; empty without jets */
  GASJET_SIM_SUPPORT_FORCE = 6,   /* [N] nodes, of straps and plates; empty without them */
  GASJET_SIM_GAS_MASS = 7,        /* [kg] species, of the level */
  GASJET_SIM_INFLOWS = 8,         /* [kg], [J] mass and enthalpy since the start, of each inflator */
  GASJET_SIM_OUTFLOWS = 9,        /* likewise, of each vent, then of the fabric */
  GASJET_SIM_BACKFLOWS = 10       /* likewise, into the bag, of each vent */
};

/* An array of rows x columns doubles, rows `stride` doubles apart. It belongs to the simulation, stays at its
 * place until that is freed, and changes as it steps. */
GASJET_API int gasjet_sim_view(gasjet_handle sim, int array, const double** values, int64_t* rows,
                               int64_t* columns, int64_t* stride);

/* Forces [N] of the caller on the nodes, rows of 3 that are `stride` doubles apart; zero at first. The caller
 * may write them at any time; the second half of a step reads them. The step's bound does not know their
 * stiffness. */
GASJET_API int gasjet_sim_own_force(gasjet_handle sim, double** force, int64_t* nodes, int64_t* stride);

/* Triangles of the skin: elements x 3 node numbers from 0. */
GASJET_API int gasjet_sim_triangles(gasjet_handle sim, const int32_t** triangles, int64_t* elements);

/* A jet as evaluated: overpressure [Pa] of each element, 0 where it is hidden; the elements that it can
 * reach, and for each of these 1 if it is lit (on pieces of elements: 0 candidates). Valid until the next
 * step. */
GASJET_API int gasjet_sim_jet(gasjet_handle sim, int64_t jet, const double** overpressure, int64_t* elements,
                              const int32_t** candidates, const uint8_t** lit, int64_t* candidate_count);

/* Gas of the level. internal_energy counts what jets have taken. */
GASJET_API int gasjet_sim_gas(gasjet_handle sim, gasjet_tank_state* gas);

/* The impactor and its contact as evaluated. */
typedef struct gasjet_sim_impact {
  double centre[3];           /* [m] */
  double axes[9];             /* its x, y and z axis in space, three numbers each */
  double velocity[3];         /* [m/s] half a step before the level */
  double angular_velocity[3]; /* [rad/s] likewise */
  double force[3];            /* [N] of the skin on the impactor */
  double couple[3];           /* [N m] about the centre */
  double energy;              /* [J] of the contact */
  double penetration;         /* [m] */
} gasjet_sim_impact;
GASJET_API int gasjet_sim_read_impact(gasjet_handle sim, gasjet_sim_impact* impact);

/* Value of a column, or of a term of the energy balance, at the last level that was recorded. drift: largest
 * drift of the energy so far over the largest energy; what the caller supplies is in the balance, so it is no
 * drift. */
GASJET_API int gasjet_sim_value(gasjet_handle sim, int table, const char* name, double* value);
GASJET_API int gasjet_sim_drift(gasjet_handle sim, double* drift);

/* What the caller sets. Each value stays until it is set again. What forces feel (ambient, inflow, outlet)
 * holds from this level on, or from the next one if this is evaluated; the others hold from this step on. The
 * work of forces, impactor and gravity is the term driving_work_J of the balance. */

/* Area [m2] >= 0 of a vent, in place of the case's; its trigger stays. */
GASJET_API int gasjet_sim_set_vent(gasjet_handle sim, int64_t vent, double area);

/* Switches a sensor of the case with `external = true`. */
GASJET_API int gasjet_sim_set_sensor(gasjet_handle sim, const char* name, int on);

/* Gas outside: pressure [Pa] >= 0, temperature [K] > 0. */
GASJET_API int gasjet_sim_set_ambient(gasjet_handle sim, double pressure, double temperature);

/* Mass flow [kg/s] >= 0 and temperature [K] of an inflator, whatever its trigger does. */
GASJET_API int gasjet_sim_set_inflow(gasjet_handle sim, int64_t inflator, double mass_flow,
                                     double temperature);

/* Outlet of a jet: centre [m] inside the bag or on its skin, axis [-] of any length. A slot's long side turns
 * with the axis. */
GASJET_API int gasjet_sim_set_outlet(gasjet_handle sim, int64_t jet, const double centre[3],
                                     const double axis[3]);

/* Gravity [m/s2], or what stands for it in a frame that moves. Not in a case with a constant one. */
GASJET_API int gasjet_sim_set_gravity(gasjet_handle sim, const double gravity[3]);

/* Place of an impactor on a rail or free, from then on in place of its own dynamics: centre [m], its x, y and
 * z axis in space, three numbers each (NULL: as now), velocity [m/s] and angular velocity [rad/s]
 * (NULL: 0) with which it goes on. After a step, before the level is evaluated. */
GASJET_API int gasjet_sim_set_impactor(gasjet_handle sim, const double centre[3],
                                       const double GASJET_OR_NULL axes[9], const double velocity[3],
                                       const double GASJET_OR_NULL angular_velocity[3]);

/* Speeds with which that impactor goes on from this level; also once the level is evaluated, so that they may
 * follow from its forces. */
GASJET_API int gasjet_sim_set_impactor_speed(gasjet_handle sim, const double velocity[3],
                                             const double GASJET_OR_NULL angular_velocity[3]);

#ifdef __cplusplus
}
#endif
#endif
