// SPDX-License-Identifier: Apache-2.0
/* Pendulum and rigid body, contact of a body with a skin, and of a skin with itself: libcoupling. Tags (K.n):
 * docs/theory/coupling.md. */
#ifndef GASJET_COUPLING_H
#define GASJET_COUPLING_H

#include <gasjet/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Rigid pendulum with a sphere as impactor; both lie on one line through the pivot. */
typedef struct gasjet_pendulum_model {
  double pivot[3];          /* [m] */
  double axis[3];           /* [-] the angle grows right-handed about it */
  double rest_direction[3]; /* [-] pivot to centre of gravity at angle 0, normal to the axis */
  double mass;              /* [kg] > 0 */
  double inertia_cg;        /* [kg m2] >= 0 about the axis through the centre of gravity */
  double cg_distance;       /* [m] >= 0 */
  double impactor_distance; /* [m] > 0 */
  double impactor_radius;   /* [m] > 0, at most impactor_distance */
  double gravity[3];        /* [m/s2] */
} gasjet_pendulum_model;

/* The pendulum at an angle and an angular velocity. */
typedef struct gasjet_pendulum_point {
  double impactor_centre[3];   /* [m] */
  double impactor_velocity[3]; /* [m/s] */
  double cg_position[3];       /* [m] */
  double gravity_moment;       /* [N m] about the axis */
  double potential_energy;     /* [J] (K.7) */
  double kinetic_energy;       /* [J] (K.7) */
  double axis_inertia;         /* [kg m2] (K.2) */
  double effective_mass;       /* [kg] (K.3) for a force along the impactor's path */
} gasjet_pendulum_point;

GASJET_API int gasjet_pendulum_evaluate(const gasjet_pendulum_model* model, double angle,
                                        double angular_velocity, gasjet_pendulum_point* point);

/* Moment about the axis [N m] of a force [N] that acts at a point [m]. */
GASJET_API int gasjet_pendulum_moment(const gasjet_pendulum_model* model, const double force[3],
                                      const double point[3], double* moment);

/* Central difference (K.4): advances `angle` [rad] from time n to n + 1, and `angular_velocity` [rad/s]
 * from n - 1/2 (at the start: from time 0) to n + 1/2. moment [N m]: sum of all moments at n, including
 * gravity_moment. dt_before [s] >= 0 is the step before n (0 at the start), dt_after [s] > 0 the step
 * after it. */
GASJET_API int gasjet_pendulum_advance(const gasjet_pendulum_model* model, double moment, double dt_before,
                                       double dt_after, double* angle, double* angular_velocity);

enum gasjet_motion {
  GASJET_FREE_BODY = 0, /* moves and turns by all forces and couples */
  GASJET_ON_RAIL = 1    /* moves along a direction, does not turn */
};

/* A spring with a damper between a body and its rail. */
typedef struct gasjet_rail_spring {
  double stiffness;  /* [N/m] >= 0 */
  double damping;    /* [N s/m] >= 0 */
  double at;         /* [m] displacement without force */
  int64_t one_sided; /* not 0: a stop, which acts beyond `at` only, on the side away from the start */
} gasjet_rail_spring;

/* Rigid body of any shape. gasjet_rigid_body_defaults sets the defaults. Mass and centre are NaN, and inertia
 * and direction 0: they must be given, the last two to a free body and to a rail. */
typedef struct gasjet_rigid_body_model {
  int64_t motion;                /* a gasjet_motion; default GASJET_FREE_BODY */
  double mass;                   /* [kg] > 0 */
  double centre[3];              /* [m] of gravity, at the start */
  double axes[9];                /* [-] x, y and z axis of the body at the start; default: those of space */
  double velocity[3];            /* [m/s] at the start, along the rail; default 0 */
  double angular_velocity[3];    /* [rad/s] at the start, of a free body; default 0 */
  double inertia[9];             /* [kg m2] 3 x 3 about the centre, in the body's axes; of a free body */
  double gravity[3];             /* [m/s2] default 0 */
  double direction[3];           /* [-] of the rail, any length but 0 */
  gasjet_rail_spring springs[4]; /* of the rail; those without stiffness and damping do nothing; default */
} gasjet_rigid_body_model;

GASJET_API int gasjet_rigid_body_defaults(gasjet_rigid_body_model* model);

/* Motion of a body: centre and axes at time n, speeds at n - 1/2 (at the start: at time 0).
 * gasjet_contact_evaluate_body takes centre and axes; turn since its last call: the last step times
 * angular_velocity of gasjet_rigid_body_point. */
typedef struct gasjet_rigid_body_state {
  double centre[3];           /* [m] */
  double axes[9];             /* [-] x, y and z axis of the body */
  double velocity[3];         /* [m/s] */
  double angular_momentum[3]; /* [kg m2/s] in space; 0 on a rail */
} gasjet_rigid_body_state;

/* The state at the start. */
GASJET_API int gasjet_rigid_body_start(const gasjet_rigid_body_model* model, gasjet_rigid_body_state* state);

/* What follows from a state. */
typedef struct gasjet_rigid_body_point {
  double displacement;        /* [m] from the start along the rail, or its length */
  double speed;               /* [m/s] along the rail, or the length of the velocity */
  double angular_velocity[3]; /* [rad/s] in space */
  double own_force[3];        /* [N] of gravity and springs, along the rail (K.53) */
  double gravity_energy;      /* [J] less that at the start (K.54) */
  double spring_energy;       /* [J] (K.54) */
  double kinetic_energy;      /* [J] of the state's speeds */
} gasjet_rigid_body_point;

GASJET_API int gasjet_rigid_body_evaluate(const gasjet_rigid_body_model* model,
                                          const gasjet_rigid_body_state* state,
                                          gasjet_rigid_body_point* point);

/* The motion at time n, and what the change of speeds from n - 1/2 to n + 1/2 did. */
typedef struct gasjet_rigid_body_kick {
  double velocity[3];     /* [m/s] at n */
  double acceleration[3]; /* [m/s2] at n */
  double kinetic_energy;  /* [J] at n, of second order, as (K.21) counts it */
  double kinetic_before;  /* [J] at n - 1/2 */
  double kinetic_after;   /* [J] at n + 1/2 */
  double load_work;       /* [J] of force and couple */
  double damping_loss;    /* [J] */
  double work; /* [J] of load, gravity and springs less damping_loss: kinetic_after less kinetic_before */
} gasjet_rigid_body_kick;

/* Central difference (K.55), (K.56): advances the state from time n to n + 1. force [N] and couple [N m]
 * about the centre act at n beside gravity and springs; a rail takes what is not along it. dt_before [s] >= 0
 * is the step before n (0 at the start), dt_after [s] >= 0 the step after it; with 0 the speeds come to time
 * n, and the next dt_before is 0. The springs and the contact limit the step, dampers do not. */
GASJET_API int gasjet_rigid_body_advance(const gasjet_rigid_body_model* model, const double force[3],
                                         const double GASJET_OR_NULL couple[3], double dt_before,
                                         double dt_after, gasjet_rigid_body_state* state,
                                         gasjet_rigid_body_kick GASJET_OR_NULL* kick);

/* Limits (K.57) for a contact up to `reach` [m] >= 0 from the centre: effective_mass [kg], which it feels at
 * least, and frequency [1/s2], a bound of omega^2 of the springs and of a contact_force [N] >= 0 that turns a
 * free body. Steps up to 2/sqrt(sum of all frequencies) are stable. */
GASJET_API int gasjet_rigid_body_limits(const gasjet_rigid_body_model* model, double reach,
                                        double contact_force, double* effective_mass, double* frequency);

/* Head injury criterion (K.58) of an acceleration [m/s2] at count >= 2 rising times [s], which span at most
 * 10 s, for intervals of up to `window` [s], 1e-4 to 0.1: 0.015 or 0.036 by 49 CFR 571.208. Its components
 * are filtered by CFC 1000 first. stride: as of nodes. */
GASJET_API int gasjet_head_injury_criterion(const double time[], const double acceleration[], int64_t count,
                                            const int64_t GASJET_OR_NULL stride[], double window,
                                            double* criterion);

/* Contact of a rigid sphere with a skin, from an energy over the skin (K.10). mass [kg]: one per node;
 * effective_mass [kg] > 0: of the sphere; radius [m] > 0, stiffness [N/m3] > 0, friction [-] >= 0. */
GASJET_API int gasjet_contact_create(const double reference[], int64_t node_count,
                                     const int64_t GASJET_OR_NULL reference_stride[],
                                     const int32_t triangles[], int64_t triangle_count,
                                     const int64_t GASJET_OR_NULL triangle_stride[], const double mass[],
                                     double effective_mass, double radius, double stiffness, double friction,
                                     gasjet_handle* contact);

enum gasjet_shape {
  GASJET_SPHERE = 0,    /* radius */
  GASJET_ELLIPSOID = 1, /* three half axes */
  GASJET_CYLINDER = 2,  /* radius, half the distance between the centres of its round ends, on its z axis */
  GASJET_DISC = 3       /* radius of its flat faces, radius of its rim; across its z axis */
};

/* Shape of a rigid body. */
typedef struct gasjet_impactor {
  int64_t shape;        /* a gasjet_shape */
  double dimensions[3]; /* [m] as the shape lists them; those after the last are ignored */
} gasjet_impactor;

/* Largest distance [m] of a point of the shape from its centre. */
GASJET_API int gasjet_impactor_reach(const gasjet_impactor* impactor, double* reach);

/* The same contact for a body of another shape (K.49). effective_mass: the least of any point of the body. */
GASJET_API int gasjet_contact_create_body(const double reference[], int64_t node_count,
                                          const int64_t GASJET_OR_NULL reference_stride[],
                                          const int32_t triangles[], int64_t triangle_count,
                                          const int64_t GASJET_OR_NULL triangle_stride[], const double mass[],
                                          double effective_mass, const gasjet_impactor* impactor,
                                          double stiffness, double friction, gasjet_handle* contact);

/* One evaluation; `force` and `couple` act on the body. */
typedef struct gasjet_contact_sums {
  double force[3];         /* [N] */
  double couple[3];        /* [N m] about the body's centre: of the friction alone on a sphere */
  double energy;           /* [J] */
  double friction_loss;    /* [J] since the last call */
  double area;             /* [m2] in contact */
  double penetration;      /* [m] the largest; 0 if nothing touches */
  double frequency;        /* [1/s2] bound of the contact's omega^2 (K.12) */
  int64_t deepest_element; /* -1 if nothing touches */
} gasjet_contact_sums;

/* Adds the contact's forces [N] to `force`, three numbers per node. Calls are successive times of a run:
 * between two of them the sphere's centre must not cross the skin. turn [rad]: rotation of the sphere
 * since the last call; used by friction only. GASJET_DOMAIN if the sphere sinks in by more than half its
 * radius or crosses the skin; `force` must not be used then. */
GASJET_API int gasjet_contact_evaluate(gasjet_handle contact, const double nodes[], int64_t node_count,
                                       const int64_t GASJET_OR_NULL node_stride[], const double centre[3],
                                       const double GASJET_OR_NULL turn[3], double force[],
                                       int64_t force_count, gasjet_contact_sums* sums);

/* The same for a body of any shape. axes: its x, y and z axis in space, three numbers each; NULL: those of
 * space. GASJET_DOMAIN if it sinks in by more than half its radius, its rim's, or c^2/a of an ellipsoid with
 * half axes from c to a, or moves so far past the skin that it may have crossed it. */
GASJET_API int gasjet_contact_evaluate_body(gasjet_handle contact, const double nodes[], int64_t node_count,
                                            const int64_t GASJET_OR_NULL node_stride[],
                                            const double centre[3], const double GASJET_OR_NULL axes[9],
                                            const double GASJET_OR_NULL turn[3], double force[],
                                            int64_t force_count, gasjet_contact_sums* sums);

/* Contact of a skin with itself (K.44): layers closer than `thickness` push each other apart. mass [kg]: one
 * per node; thickness [m] > 0, at most the smallest altitude of a triangle; stiffness [N/m3] > 0: pressure
 * per depth; friction [-] >= 0. Parts with a common node, or nodes that an edge joins, do not touch. */
GASJET_API int gasjet_skin_contact_create(const double reference[], int64_t node_count,
                                          const int64_t GASJET_OR_NULL reference_stride[],
                                          const int32_t triangles[], int64_t triangle_count,
                                          const int64_t GASJET_OR_NULL triangle_stride[], const double mass[],
                                          double thickness, double stiffness, double friction,
                                          gasjet_handle* skin_contact);

/* One evaluation. The closest parts are a node and a triangle, or two edges; unused numbers are -1. */
typedef struct gasjet_skin_contact_sums {
  double energy;           /* [J] */
  double friction_loss;    /* [J] since the last call */
  double frequency;        /* [1/s2] bound of the contact's omega^2 (K.46) */
  double gap;              /* [m] the smallest distance; infinity if nothing touches */
  double approach;         /* [-] largest decrease of a distance since the last call over its reach (K.47) */
  int64_t contacts;        /* pairs that touch */
  int64_t limited_nodes;   /* nodes that started too close and have not moved away since (K.45) */
  int64_t first_nodes[2];  /* of the closest parts: a node and -1, or an edge */
  int64_t second_nodes[3]; /* a triangle, or an edge and -1 */
} gasjet_skin_contact_sums;

/* Adds the contact's forces [N] to `force`, three numbers per node. Calls are successive times of a run.
 * Layers that are too close at the first call start without force. GASJET_DOMAIN if layers meet on straight
 * paths from the last call; `force` must not be used then, and gasjet_skin_contact_restart must come next. */
GASJET_API int gasjet_skin_contact_evaluate(gasjet_handle skin_contact, const double nodes[],
                                            int64_t node_count, const int64_t GASJET_OR_NULL node_stride[],
                                            double force[], int64_t force_count,
                                            gasjet_skin_contact_sums* sums);

/* Forgets all calls: the next one is the first of a run. */
GASJET_API int gasjet_skin_contact_restart(gasjet_handle skin_contact);

/* Stiffness [N/m3] that adds at most `share` of other_frequency [1/s2], the omega^2 of all other terms, to a
 * skin of surface_density [kg/m2] without friction: share omega^2 rho h / 4 (K.46). */
GASJET_API int gasjet_default_skin_stiffness(double share, double other_frequency, double surface_density,
                                             double* stiffness);

#ifdef __cplusplus
}
#endif
#endif
