// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "membrane/element_group.hpp"
#include "membrane/isa.hpp"

// Interface between the library and its kernels, which are compiled once for each instruction set. Only plain
// pointers cross it, so no inline code of the standard library or Eigen is compiled with different flags. For
// the same reason no member has a default initialiser; the structs are made with {}.
namespace membrane {

// One block of elements: fabric forces, surface, or both in one pass.
struct SkinArrays {
  const ElementGroup* group;
  const FabricGroup* fabric;
  const YarnCurves* curves;  // curves, for laws by curves
  const FrequencyGroup* frequency;
  int group_count;
  const std::int32_t* node;  // nodes of the block: own_count own ones, then shared ones, node_count in total
  int own_count, node_count;
  /// Sizes of the next block; 0 if there is none, and in bags that fit the cache.
  int next_groups, next_nodes;
  const double* position;      // nodes x 4
  const double* inverse_mass;  // nodes x 4
  double *force, *gradient;    // nodes x 4
  NodeSums* shared_sums;       // sums of this block's shared nodes
};

struct SkinTotals {
  double moment;  // sum of (x_a - x_0) . S_e = 3 V
  double area, porosity_area, porosity_squared_area;
  double mobility;  // mobility of the block's own nodes
  double energy, frequency;
};

// Area vectors and centroids.
struct GeometryArrays {
  const double* position;          // nodes x 4
  const int* corners;              // nodes, 3 x elements
  const int* elements;             // requested elements; null: all
  int count;                       // number of these
  double *area_vector, *centroid;  // elements x 4
};

// Nodes that blocks share: their slots are summed.
struct SharedArrays {
  const std::int32_t *node, *row_begin, *slot;
  const NodeSums* sums;
  const double* inverse_mass;  // nodes x 4
  double *force, *gradient;    // nodes x 4
};

inline constexpr int kMaxExtraForces = 5;
inline constexpr int kRateNodes = 16;  // nodes with a common bound of the rate of deformation

struct AdvanceArrays {
  double *position, *velocity;                     // nodes x 4
  const double *membrane_force, *volume_gradient;  // nodes x 4
  double gauge_pressure;
  const double* extra_force[kMaxExtraForces];  // nodes x 4
  int extra_count;
  const double* mass;                   // nodes
  const double* node_gradient_squared;  // nodes
  double* rate_bound_squared;           // for each kRateNodes nodes
  const double* inverse_mass;           // nodes x 4
  alignas(32) double gravity[4];
  double damping, dt_before, dt_after;
};

struct AdvanceTotals {
  double kinetic_before, kinetic_after;
  double work_membrane, work_pressure;
  double work_extra[kMaxExtraForces];
  double damped;  // tau times the sum of m |v_mean|^2
  double momentum_before[3], momentum_after[3], impulse[3];
  double max_speed_squared;
};

// Quantities that a pass over the elements computes.
enum SkinPass { kSurfacePass, kForcesPass, kSkinPass };

// One entry per kernel. Kernels over nodes handle [first, last).
struct KernelTable {
  using Skin = void (*)(const SkinArrays&, SkinTotals&);
  Skin surface;
  struct OfLaw {
    Skin compression[2];  // linear and none; linear is null if the law has none
  };
  OfLaw forces[FabricLaws::count], skin[FabricLaws::count];
  void (*geometry)(const GeometryArrays&);
  void (*shared[3])(const SharedArrays&, int first, int last, double& mobility);
  void (*advance)(const AdvanceArrays&, int first, int last, AdvanceTotals&);
};

const KernelTable& kernel_table(Isa isa);  // precondition: the processor has it

namespace baseline {
extern const KernelTable kTable;
extern const KernelTable kScalarTable;
}  // namespace baseline
namespace avx2 {
extern const KernelTable kTable;
}

}  // namespace membrane
