// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "membrane/isa.hpp"

// Border between the library and its kernels, which are compiled once for each instruction set: plain
// pointers only, so that no inline code of the standard library or Eigen is compiled twice with different
// flags (hence no default member initialisers either: the structs are made with {}).
namespace membrane {

struct SurfaceArrays {
  const std::int32_t *node_a, *node_b, *node_c;
  const double *porosity, *porosity_squared;
  const double* position;  // nodes x 4
  double* area_vector;     // elements x 4
  double* centroid;        // elements x 4
  double* area;            // elements
};

struct SurfaceTotals {
  double moment;  // sum of (x_a - x_0) . S_e = 3 V
  double area, porosity_area, porosity_squared_area;
};

// Beside `spherical` and `deviator`, for a woven bag only (null otherwise): see OrthotropicConstants.
struct WeaveArrays {
  const double *cosine, *sine, *warp_scale, *shear, *series, *skew, *taut;
};

struct ForceArrays {
  const std::int32_t *node_a, *node_b, *node_c;
  const double *gradient_b1, *gradient_b2, *gradient_c2, *volume;
  const double *young, *spherical, *deviator, *material_frequency, *geometric_frequency;
  const double* position;  // nodes x 4
  double* corner_force;    // groups x 36
  WeaveArrays weave;
};

struct ForceTotals {
  double energy;
  double frequency;
};

struct NodeArrays {
  const std::int32_t *row_begin, *element, *offset;  // corner table
  const double* inverse_mass;
  const double* corner_force;
  const double* area_vector;
  const double* overpressure;  // elements, jet only
  double* out;                 // nodes x 4
};

inline constexpr int kMaxExtraForces = 3;

struct AdvanceArrays {
  double *position, *velocity;                     // nodes x 4
  const double *membrane_force, *volume_gradient;  // nodes x 4
  double gauge_pressure;
  const double* extra_force[kMaxExtraForces];  // nodes x 4
  int extra_count;
  const double *mass, *inverse_mass;
  alignas(32) double gravity[4];
  double damping, dt_before, dt_after;
};

struct AdvanceTotals {
  double kinetic_before, kinetic_after;
  double work_membrane, work_pressure;
  double work_extra[kMaxExtraForces];
  double damped;  // sum of m |v_mean|^2
  double momentum_before[3], momentum_after[3], impulse[3];
  double max_speed_squared;
};

// One entry per kernel; each handles the elements or nodes [first, last).
struct KernelTable {
  void (*surface)(const SurfaceArrays&, int first, int last, SurfaceTotals&);
  void (*element_forces_linear)(const ForceArrays&, int first, int last, ForceTotals&);
  void (*element_forces_relaxed)(const ForceArrays&, int first, int last, ForceTotals&);
  void (*woven_forces_linear)(const ForceArrays&, int first, int last, ForceTotals&);
  void (*woven_forces_relaxed)(const ForceArrays&, int first, int last, ForceTotals&);
  void (*nodal_forces)(const NodeArrays&, int first, int last);
  void (*volume_gradient)(const NodeArrays&, int first, int last, double& mobility);
  void (*jet_forces)(const NodeArrays&, int first, int last);
  void (*advance)(const AdvanceArrays&, int first, int last, AdvanceTotals&);
};

const KernelTable& kernel_table(Isa isa);  // the processor must have it

namespace baseline {
extern const KernelTable kTable;
extern const KernelTable kScalarTable;
}  // namespace baseline
namespace avx2 {
extern const KernelTable kTable;
}

}  // namespace membrane
