// SPDX-License-Identifier: Apache-2.0
/* Outlet, field and exact hidden elements of a gas jet: libjet. Tags (J.n): docs/theory/jet.md. */
#ifndef GASJET_JET_H
#define GASJET_JET_H

#include <gasjet/base.h>

#ifdef __cplusplus
extern "C" {
#endif

enum gasjet_outlet_law {
  GASJET_SONIC_STATIC = 0,     /* sonic, temperature of the moving gas (the paper's form) */
  GASJET_SONIC_STAGNATION = 1, /* sonic, temperature of the chamber */
  GASJET_PRESSURE_MATCHED =
      2, /* of the chamber; subsonic at bag pressure if a sonic outlet's pressure would be below it */
  GASJET_EXPANDED = 3 /* the same, but a sonic outlet above bag pressure expands to it: the state is that of
                       * the notional nozzle (J.12) */
};

/* Uniform gas in an outlet, or at the notional nozzle. */
typedef struct gasjet_outlet_state {
  double velocity;    /* [m/s] V0, or V of the notional nozzle */
  double density;     /* [kg/m3] rho0, or rho */
  double pressure;    /* [Pa] */
  double temperature; /* [K] static */
} gasjet_outlet_state;

/* (J.1), (J.2): area [m2] > 0, mass_flow [kg/s] >= 0, temperature [K] > 0, cp > gas_constant > 0 [J/(kg
 * K)], bag_pressure [Pa] > 0 (used by GASJET_PRESSURE_MATCHED and GASJET_EXPANDED only), (J.12). */
GASJET_API int gasjet_outlet(int law, double area, double mass_flow, double temperature, double cp,
                             double gas_constant, double bag_pressure, gasjet_outlet_state* state);

/* Outlet and field. gasjet_jet_defaults sets the defaults. All other members are NaN and must be given if
 * the shape or the spread uses them. */
typedef struct gasjet_jet_model {
  double centre[3];          /* [m] of the outlet */
  double axis[3];            /* [-] into the bag, any length but 0 */
  double radius;             /* [m] of a round outlet; NaN: rectangular */
  double short_side;         /* [m] rectangular: at most long_side; NaN: round */
  double long_side;          /* [m] rectangular; NaN: round */
  double long_direction[3];  /* [-] rectangular: along the long side, normal to the axis */
  double decay_coefficient;  /* [-] a of (J.3), (J.4) */
  double cone_initial_width; /* [m] of the cone of the width; NaN: conservation of momentum */
  double cone_half_angle;    /* [rad] of that cone, 0 to pi/2; NaN without one */
  double restitution;        /* [-] -0.5 to 4, default 1: complete reflection */
  double cut_off;            /* [-] no load if (V/V_max)^2 is below this; default 1e-3 */
  int64_t radial; /* not 0: velocity points away from the virtual origin; default 0: along the axis */
} gasjet_jet_model;

GASJET_API int gasjet_jet_defaults(gasjet_jet_model* model);

/* A jet at a surface of triangles. null_elements close a hole: they take no load and never hide others;
 * attachment_elements around the outlet never hide others. Elements are numbered from 0; pass NULL with
 * count 0. node_count may include nodes of other parts, up to 20 million more than corners of triangles.
 * Calls read only nodes of triangles; other nodes may have any content, and cost nothing. The jet loads
 * inner sides, so a wrongly wound triangle takes no load; gasjet_surface_check finds it. */
GASJET_API int gasjet_jet_create(const gasjet_jet_model* model, const int32_t triangles[],
                                 int64_t triangle_count, const int64_t GASJET_OR_NULL triangle_stride[],
                                 int64_t node_count, const int32_t GASJET_OR_NULL null_elements[],
                                 int64_t null_count, const int32_t GASJET_OR_NULL attachment_elements[],
                                 int64_t attachment_count, gasjet_handle* jet);

/* Notional nozzle and restitution of the calls of gasjet_jet_pressure that follow. area_ratio [-] > 0: area
 * of the nozzle over the outlet's, mass_flow / (density velocity area) with the state of GASJET_EXPANDED;
 * the jet is wider by it. reflected [-] in (0, 1]: velocity in the outlet (GASJET_SONIC_STAGNATION) over that
 * of the nozzle. Both are 1 at first, and for outlets that do not expand. restitution [-]: -0.5 to 4; NaN: as
 * it is. */
GASJET_API int gasjet_jet_expansion(gasjet_handle jet, double area_ratio, double reflected,
                                    double restitution);

/* Counters of a query: candidates = lit + hidden + facing_away. */
typedef struct gasjet_visibility {
  int64_t candidates;  /* elements queried */
  int64_t lit;         /* facing the source, nothing between */
  int64_t hidden;      /* facing the source, but blocked */
  int64_t facing_away; /* the source is on their outer side */
} gasjet_visibility;

/* Overpressure [Pa] of each element, dp = (1 + e reflected) rho (V.n)^2 (J.6), 0 if hidden and `occlusion`
 * is not 0. velocity [m/s] and density [kg/m3] are those of gasjet_outlet; e and reflected: see
 * gasjet_jet_expansion. The caller loads each corner by dp S_e / 3. force [N]: sum of dp S_e.
 * displacement_bound [m]: a sum that only grows; no node has moved farther since the first call; NaN:
 * unknown. It affects the speed only. */
GASJET_API int gasjet_jet_pressure(gasjet_handle jet, const double nodes[], int64_t node_count,
                                   const int64_t GASJET_OR_NULL node_stride[], double velocity,
                                   double density, int occlusion, double displacement_bound,
                                   double overpressure[], int64_t overpressure_count, double force[3],
                                   gasjet_visibility* GASJET_OR_NULL counters);

/* Moves the outlet of the calls that follow, for example with its module: centre [m], axis into the bag, any
 * length but 0. long_direction, normal to the axis, is used by a rectangular outlet; NULL turns the last one
 * by the smallest rotation between the axes. Results have the bits of a jet that was created there.
 * displacement_bound goes on as before. */
GASJET_API int gasjet_jet_place(gasjet_handle jet, const double centre[3], const double axis[3],
                                const double GASJET_OR_NULL long_direction[3]);

/* Switches elements off (on[e] = 0), for example as they erode, and on again. An element that is off takes no
 * load and hides none: results are those of a jet on the mesh without it. on_count: number of triangles.
 * Nodes of elements that are off must stay finite, and count in displacement_bound. */
GASJET_API int gasjet_jet_set_elements(gasjet_handle jet, const uint8_t on[], int64_t on_count);

/* Cuts each element into n^2 pieces, n from 1 (as created) to 64: the overpressure of an element is then the
 * mean over its pieces (J.8), and gasjet_visibility counts pieces. */
GASJET_API int gasjet_jet_subdivide(gasjet_handle jet, int n);

/* relative not 0: dp = (1 + e reflected) rho max(V.n - v.n, 0)^2 with the velocity v of the element, the mean
 * of its nodes. Calls then need velocities. Such a load damps the skin (J.9) and shortens its stable step. */
GASJET_API int gasjet_jet_relative_to_skin(gasjet_handle jet, int relative);

/* gasjet_jet_pressure for some elements, with the same bits as for all. elements[k], each at most once, has
 * the overpressure in overpressure[k]; NULL with element_count 0 means all, and an address with 0 none. So
 * each rank of a decomposition asks for its own elements; it needs the positions of all nodes, as any element
 * may hide another. force [N] and counters are those of the elements asked for. A call with the elements of
 * the last one is faster. velocities [m/s]: three for each node, or NULL. power [W]: sum of dp S_e.v_e, the
 * rate at which the jet works on these elements; needs velocities. */
GASJET_API int gasjet_jet_pressure_of(
    gasjet_handle jet, const double nodes[], int64_t node_count, const int64_t GASJET_OR_NULL node_stride[],
    const double GASJET_OR_NULL velocities[], const int64_t GASJET_OR_NULL velocity_stride[], double velocity,
    double density, int occlusion, double displacement_bound, const int32_t GASJET_OR_NULL elements[],
    int64_t element_count, double overpressure[], int64_t overpressure_count, double force[3],
    double GASJET_OR_NULL* power, gasjet_visibility GASJET_OR_NULL* counters);

/* The same for nodes and velocities in single precision, which it copies: results are those of their values
 * as doubles. Strides count floats. */
GASJET_API int gasjet_jet_pressure_float(
    gasjet_handle jet, const float nodes[], int64_t node_count, const int64_t GASJET_OR_NULL node_stride[],
    const float GASJET_OR_NULL velocities[], const int64_t GASJET_OR_NULL velocity_stride[], double velocity,
    double density, int occlusion, double displacement_bound, const int32_t GASJET_OR_NULL elements[],
    int64_t element_count, double overpressure[], int64_t overpressure_count, double force[3],
    double GASJET_OR_NULL* power, gasjet_visibility GASJET_OR_NULL* counters);

/* Velocity relative to the outlet, V/V0 [-], at points: three numbers per point. */
GASJET_API int gasjet_jet_velocity(const gasjet_jet_model* model, const double points[], int64_t point_count,
                                   const int64_t GASJET_OR_NULL point_stride[], double velocity[],
                                   int64_t velocity_count);

/* Source of rays. */
typedef struct gasjet_source {
  double centre[3];         /* [m] */
  double axis[3];           /* [-] not 0; a source on the surface is moved along it by a vanishing length */
  double long_direction[3]; /* [-] unit vector; used if half_long > 0 */
  double half_long;         /* [m] half the long side of a rectangular outlet; 0: a point */
} gasjet_source;

/* A surface for repeated queries of the elements that a source sees; arguments as gasjet_jet_create. */
GASJET_API int gasjet_surface_create(const int32_t triangles[], int64_t triangle_count,
                                     const int64_t GASJET_OR_NULL triangle_stride[], int64_t node_count,
                                     const int32_t GASJET_OR_NULL null_elements[], int64_t null_count,
                                     const int32_t GASJET_OR_NULL attachment_elements[],
                                     int64_t attachment_count, gasjet_handle* surface);

/* Sets lit[k] to 1 if candidates[k] (NULL: every element) is seen, exactly (J.7), else 0.
 * displacement_bound as above. */
GASJET_API int gasjet_surface_visible(gasjet_handle surface, const double nodes[], int64_t node_count,
                                      const int64_t GASJET_OR_NULL node_stride[], const gasjet_source* source,
                                      const int32_t GASJET_OR_NULL candidates[], int64_t candidate_count,
                                      double displacement_bound, uint8_t lit[], int64_t lit_count,
                                      gasjet_visibility* GASJET_OR_NULL counters);

#ifdef __cplusplus
}
#endif
#endif
