// SPDX-License-Identifier: Apache-2.0
/* Fabric of triangles around a volume: libmembrane. Tags (M.n): docs/theory/membrane.md. */
#ifndef GASJET_MEMBRANE_H
#define GASJET_MEMBRANE_H

#include <gasjet/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Faults that keep a surface from enclosing a volume. */
typedef struct gasjet_surface_faults {
  int64_t ok;                     /* not 0 if closed, connected and wound outward; then all others are 0 */
  int64_t boundary_edges;         /* edges of only one triangle: a hole */
  int64_t non_manifold_edges;     /* edges of more than two triangles */
  int64_t inconsistent_edges;     /* edges that two triangles pass in one direction: one is wound wrongly */
  int64_t repeated_node_elements; /* triangles with a node twice */
  int64_t pinched_nodes;          /* nodes whose triangles touch only there */
  int64_t unused_nodes;           /* nodes of no triangle */
  int64_t more_components;        /* parts without a common edge, minus one */
  int64_t inward;                 /* 1: closed, but wound inward */
  int64_t flat;                   /* 1: closed, but without a volume */
} gasjet_surface_faults;

/* Checks a surface of triangles. text: one line for each finding; numbers count from 0; sizes as in
 * gasjet_run_summary. `faults` is set in any case. */
GASJET_API int gasjet_surface_check(const double nodes[], int64_t node_count,
                                    const int64_t GASJET_OR_NULL node_stride[], const int32_t triangles[],
                                    int64_t triangle_count, const int64_t GASJET_OR_NULL triangle_stride[],
                                    gasjet_surface_faults* faults, char GASJET_OR_NULL text[], int64_t size,
                                    int64_t* needed);

enum gasjet_fabric_law {
  GASJET_SAINT_VENANT_KIRCHHOFF = 0, /* stress linear in Green-Lagrange strain (M.2) */
  GASJET_HENCKY = 1 /* Cauchy stress linear in logarithmic strain (M.25); goes slack, to stretches of 1.65 */
};

/* Isotropic fabric. */
typedef struct gasjet_fabric_model {
  double thickness;     /* [m] > 0 */
  double density;       /* [kg/m3] > 0 */
  double young_modulus; /* [Pa] > 0 */
  double poisson;       /* [-] between -1 and 1 */
  int64_t wrinkles;     /* 0: carries compression; else: goes slack (tension field, M.3) */
  int64_t law;          /* a gasjet_fabric_law; 0: stress linear in Green-Lagrange strain */
} gasjet_fabric_model;

/* The membrane at given positions. */
typedef struct gasjet_membrane_sums {
  double volume;            /* [m3] enclosed (M.5), if gasjet_surface_check finds no fault */
  double area;              /* [m2] */
  double mass;              /* [kg] of the fabric */
  double strain_energy;     /* [J] */
  double element_frequency; /* [1/s2] bound of the fabric's omega^2 (M.10) */
  double gas_frequency;     /* [1/s2] bound of the gas's omega^2 (M.11) */
  double critical_step;     /* [s] largest stable step of the central difference (M.12) */
} gasjet_membrane_sums;

/* A membrane with its stress-free shape. null_elements close holes: they have no mass and no stress.
 * fixed_nodes do not move and do not affect frequencies. */
GASJET_API int gasjet_membrane_create(
    const double reference[], int64_t node_count, const int64_t GASJET_OR_NULL reference_stride[],
    const int32_t triangles[], int64_t triangle_count, const int64_t GASJET_OR_NULL triangle_stride[],
    const gasjet_fabric_model* fabric, const int32_t GASJET_OR_NULL null_elements[], int64_t null_count,
    const int32_t GASJET_OR_NULL fixed_nodes[], int64_t fixed_count, gasjet_handle* membrane);

/* Mass of each node [kg]. */
GASJET_API int gasjet_membrane_masses(gasjet_handle membrane, double mass[], int64_t mass_count);

/* At positions `nodes` [m]: the fabric's forces [N] and the volume's gradient dV/dx [m2], three numbers
 * per node (either may be NULL); the gas exerts the force (p - p_a) dV/dx. Volume and gradient are
 * meaningful only if gasjet_surface_check finds no fault. gamma [-] >= 0 and the absolute pressure [Pa] >=
 * 0 of the gas affect the critical step; gamma = 0: the pressure is prescribed. */
GASJET_API int gasjet_membrane_evaluate(gasjet_handle membrane, const double nodes[], int64_t node_count,
                                        const int64_t GASJET_OR_NULL node_stride[], double gamma,
                                        double pressure, double GASJET_OR_NULL force[],
                                        double GASJET_OR_NULL gradient[], int64_t vector_count,
                                        gasjet_membrane_sums* sums);

#ifdef __cplusplus
}
#endif
#endif
