// SPDX-License-Identifier: Apache-2.0
// Interface between the library and its kernels, which are compiled once for each instruction set. It has
// plain data only, so that no inline code of the standard library or Eigen is compiled with different flags.
#pragma once

#include <cstddef>
#include <cstdint>

namespace jet {

template <class T>
struct Vec3 {
  T x, y, z;
};

/// 3 x n columns. Kernels load four doubles per column; `tail` has a padded copy of the last column.
struct Rows {
  const double* first;
  std::ptrdiff_t stride;
  int last;
  double tail[4];
};

/// A jet in the form that profile.hpp uses.
struct JetShape {
  bool round, momentum, axial;
  double centre[3], axis[3], across[3], along[3];  // across and along: zero for a round outlet
  double size;                                     // [m] R0 or b0
  double half_long;                                // [m]
  double decay_coefficient;
  double cone_width, cone_slope;           // [m], [-]
  double origin;                           // [m] of the virtual origin upstream
  double cut_core, cut_origin, cut_slope;  // [m], [m], [-]: outside where |r| > max(core, origin + slope z)
  double cut_cosine;                       // [-] cosine of the angle between cut-off and axis, beyond the
                                           // core
  double centre_size;                      // [m] largest magnitude of the centre's coordinates
};

struct FieldArrays {
  Rows area_vectors, centroids, velocities;
  bool relative_to_skin;
  /// Bits of groups of four: set for elements that take load.
  const std::uint8_t* loaded;
  int count;                  // elements
  double displacement_bound;  // [m]
  double* slack;              // [m] see FieldState
  std::uint8_t* inside;       // see FieldState
  double velocity, factor;    // [m/s] V0, [kg/m3] (1 + e) rho0
  double* overpressure;       // [Pa] written at the candidates
  int* candidates;            // has room for eight more
};

/// Coordinates along a jet as floats between -1 and 1, four a row: u across, v along the outlet's long side,
/// w downstream, and the node's code. Bits 0 to 4 of the code: u - slope w is below -bound; above bound; the
/// same two for v; w is below -bound. Bit 7: w <= 0 in double.
struct ProjectArrays {
  Rows nodes;            // [m]
  int count;             // of nodes
  double centre[3];      // [m]
  double column[3][4];   // [1/m] (u, v, w, 0) for x, y and z
  float* local;          // a row per node, with room for 7 more
  std::int32_t* codes;   // of the nodes, with room for 7 more
  const int* triangles;  // 3 per element
  const int* elements;   // elements whose rays are bounded
  float slope[4], bound[5];
  /// If only some nodes are projected: the begins of their rows in `local`, ascending, the last one repeated
  /// to a multiple of eight.
  const std::uint32_t* listed;
};

inline constexpr int kSides = 0x1f;

struct ProjectFlags {
  bool outside;  // a coordinate is beyond -1 or 1, or is NaN
  bool small;    // no coordinate is above 1/64
  /// A coordinate of a node is below 1e-100 in magnitude and not 0; not tested for listed nodes.
  bool tiny;
};

/// Rays to their targets.
struct RayArrays {
  const float* targets;  // rows of local coordinates
  float half_long;       // 0: a point source
  /// Rows of the rays, which are the places of their own elements. Eight can be read.
  const int* list;
  int count;
};

/// Bounds of the rays' slopes u/w and v/w (of v itself for a line of sources), including errors.
struct Frustum {
  float low_u, high_u, low_v, high_v;
};

/// Patches of eight elements near the rays; a byte has one bit for each. Elements are numbered in the mesh's
/// order, eight to a patch. Lists have room for all elements and eight more.
struct PatchArrays {
  const float* local;
  float half_long;
  const std::uint32_t* corner_rows;  // see OrderedMesh
  int elements;                      // elements of the mesh
  const int* patches;
  int count;
  int outside;                // bits of a code that exclude an element
  const std::uint8_t* asked;  // by patch of the mesh: bits of elements with rays
  float error;                // absolute part of the error bound of the orientation
  /// Winding ray from a source: its slopes, or slope across and place along the line.
  float winding_u, winding_v;
  /// The patches that rays can meet; may be the same array as `patches`.
  int* near;
  /// Boxes of their elements, kBoxFloats each. Lanes after the mesh's last element repeat its box.
  float* boxes;
  float* targets;  // rows of the near patches that have rays
  // By patch of the mesh, written for near patches. Sources whose rays can touch an element certainly see its
  // inner side; or it is near and does not certainly show that.
  std::uint8_t *inner, *not_inner;
  int* uncertain;       // near elements that may show either side
  int* between;         // near elements that may lie between two sources
  int* on_winding_ray;  // near elements that may touch the winding ray
  int* upstream;        // elements with rays that are not certainly downstream
};
struct PatchesFound {
  int near, uncertain, between, on_winding_ray, upstream;  // lengths of the lists
  int asked;                                               // near patches that have rays
  /// Bounds of the rays that go downstream.
  Frustum bounds;
};

/// Boxes of patches, see PatchArrays.
struct BoxArrays {
  const float* boxes;
  const int* patches;
  int count;
};

/// Pairs of a ray and an element.
struct PairArrays {
  const float *targets, *local;
  float half_long;
  const std::uint32_t* corner_rows;  // see OrderedMesh
  const int *rays, *elements;
  // Results, one bit for each of eight; a set bit is certain:
  std::uint8_t* blocked;  // the segment crosses the interior
  std::uint8_t* pierced;  // the line crosses the interior
  std::uint8_t* apart;    // the segment does not touch the element
  std::uint8_t* missed;   // the line does not touch the element
};

inline constexpr int kBoxFloats = 40;  // boxes of eight elements

/// Lists of pairs, with room for eight times all elements and eight more; and two workspace lists with room
/// for all elements and eight more.
struct PairLists {
  int *rays, *elements, *first, *second;
};

/// Pyramid of boxes, each around eight lower ones; see pyramid.hpp.
struct PyramidView {
  const float* boxes;
  int levels;
  int first[12];  // first block of each level
  int last[12];   // one past the last block
};

struct KernelTable {
  /// Lists the elements whose rows `select` and `evaluate` will read in `elements`, which has room for eight
  /// more. Returns their number.
  int (*list_needed)(const FieldArrays&, int* elements);
  /// Lists the elements inside the cut-off in `candidates`; for an axial jet only those that do not face
  /// away. Returns their number.
  int (*select)(const JetShape&, const FieldArrays&);
  /// Computes the overpressure of the first `count` candidates and drops those with none. Returns the number
  /// left, or -1 - element if the overpressure of that element is not finite.
  int (*evaluate)(const JetShape&, const FieldArrays&, int count);
  /// Sum of overpressure times area vector over `count` elements. `sum` has four numbers, three of them used.
  void (*force)(const Rows& area_vectors, const double* overpressure, const int* elements, int count,
                double* sum);

  /// Computes local coordinates and codes of all nodes.
  ProjectFlags (*project_nodes)(const ProjectArrays&);
  /// Computes only bits 0 to 4 of the codes.
  ProjectFlags (*code_nodes)(const ProjectArrays&);
  /// Computes local coordinates, with codes in their rows, of `count` listed nodes; a multiple of eight.
  ProjectFlags (*project_listed)(const ProjectArrays&, int count);
  /// Bounds of the rays to the centroids of `count` elements, over the rays that are certainly downstream.
  Frustum (*frustum_of)(const ProjectArrays&, float half_long, int count);
  PatchesFound (*classify_patches)(const PatchArrays&);
  /// Lists the places of the bits of `count` bytes, a multiple of 32. Returns their number. `places` has room
  /// for eight more.
  int (*list_bits)(const std::uint8_t* bytes, int count, int* places);
  /// Lists the patches with `chosen` elements (bits by patch of the mesh) in `patches`, and their boxes in
  /// `boxes`, where other elements have empty boxes. Returns their number.
  int (*choose_boxes)(const BoxArrays&, const std::uint8_t* chosen, float* boxes, int* patches);
  /// Merges the eight boxes of each block to the box around them. Lanes after the last hold anything.
  void (*merge)(const float* blocks, int count, float* boxes);
  /// Finds pairs of a ray, of at most eight, and an element whose box it meets. Returns their number. If
  /// `to_targets`, only elements before the ray's target and other than its own; places after the mesh's last
  /// element stand for it and are not excluded. The lowest blocks of the pyramid are `patches`.
  ///
  /// If the places of two successive rays differ by more than `far_places`, returns minus the number of rays
  /// before the first such gap: the caller should split them there.
  int (*find_pairs)(const RayArrays&, int far_places, bool to_targets, const PyramidView&, const int* patches,
                    const PairLists&);
  void (*meet_pairs)(const PairArrays&, int count);
};

namespace baseline {
extern const KernelTable kTable;
}
namespace avx2 {
extern const KernelTable kTable;
}

/// The kernels of the best instruction set of this processor.
const KernelTable& kernel_table();

}  // namespace jet
