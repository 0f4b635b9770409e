// SPDX-License-Identifier: Apache-2.0
// Border between the library and its kernels, which are compiled once for each instruction set: plain data
// only, so that no inline code of the standard library or Eigen is compiled twice with different flags.
#pragma once

#include <cstddef>
#include <cstdint>

namespace jet {

template <class T>
struct Vec3 {
  T x, y, z;
};

/// 3 x n columns. Kernels load four doubles a row: the last one has its copy in `tail`.
struct Rows {
  const double* first;
  std::ptrdiff_t stride;
  int last;
  double tail[4];
};

/// A jet as the formulas of profile.hpp read it.
struct JetShape {
  bool round, momentum, axial;
  double centre[3], axis[3], across[3], along[3];  // across and along: zero for a round outlet
  double size;                                     // [m] R0 or b0
  double half_long;                                // [m]
  double decay_coefficient;
  double cone_width, cone_slope;           // [m], [-]
  double origin;                           // [m] of the virtual origin upstream
  double cut_core, cut_origin, cut_slope;  // [m], [m], [-]: outside where |r| > max(core, origin + slope z)
  double cut_cosine;                       // [-] of the cut-off's angle to the axis beyond the core
  double centre_size;                      // [m] largest coordinate of the centre
};

struct FieldArrays {
  Rows area_vectors, centroids, velocities;
  bool relative_to_skin;
  const std::uint8_t* loaded;  // bits of groups of four: elements that take load
  int count;                   // elements
  double displacement_bound;   // [m]
  double* slack;               // [m] see FieldState
  std::uint8_t* inside;        // see FieldState
  double velocity, factor;     // [m/s] V0, [kg/m3] (1 + e) rho0
  double* overpressure;        // [Pa] written at the candidates
  int* candidates;             // and room for eight more
};

/// Coordinates along a jet as floats between -1 and 1, four a row: u across, v along the outlet's long side,
/// w downstream, and a node's code. Bits 0 to 4 of that: u - slope w below -bound, above bound, the same of
/// v, w below -bound; bit 7: w <= 0 in double.
struct ProjectArrays {
  Rows nodes;            // [m]
  int count;             // of nodes
  double centre[3];      // [m]
  double column[3][4];   // [1/m] (u, v, w, 0) of x, y and z
  float* local;          // a row a node, and room for 7 more
  std::int32_t* codes;   // of the nodes, and room for 7 more
  const int* triangles;  // 3 an element
  const int* elements;   // to bound the rays of
  float slope[4], bound[5];
  const std::uint32_t* listed;  // where rows in `local` begin of the nodes to project if not all are:
                                // ascending, the last repeated to a multiple of eight
  bool aligned = false;         // u, v and w are coordinates but for factors: each is made of one column
  int axis[3] = {};             // these columns, if so
};

inline constexpr int kSides = 0x1f;

struct ProjectFlags {
  bool outside;  // some coordinate is not within -1 and 1, or not a number
  bool small;    // none is above 1/64
  bool tiny;     // some coordinate of a node is not 0, but below 1e-100; not asked of nodes listed
};

/// Rays to their targets.
struct RayArrays {
  const float* targets;  // rows of local coordinates
  float half_long;       // 0: a point source
  const int* list;       // rows, the places of the rays' own elements; eight can be read
  int count;
};

/// Slopes u/w (v/w, or v of a line of sources) of the rays, with their errors.
struct Frustum {
  float low_u, high_u, low_v, high_v;
};

/// Patches of eight elements near the rays. Bits of a byte stand for its elements; elements have the numbers
/// of the mesh's order, eight a patch. Lists have room for all of them and eight more.
struct PatchArrays {
  const float* local;
  float half_long;
  const std::uint32_t* corner_rows;  // see OrderedMesh
  int elements;                      // of the mesh
  const int* patches;
  int count;
  int outside;                // bits of a code that keep an element out
  const std::uint8_t* asked;  // by patch of the mesh: elements that have rays
  float error;                // absolute part of the bound of the orientation
  float winding_u,
      winding_v;   // of a line from a source: its slopes, or slope across and place along the line
  int* near;       // those of `patches` that rays can meet; may be the same array
  float* boxes;    // of their elements, kBoxFloats each; behind the mesh's last, of that one
  float* targets;  // rows of the patches near that have rays
  // By patch of the mesh, written for those near: the sources of rays that can touch an element see its inner
  // side for certain, or its outer side for certain; or it is near and not certain to show its inner side.
  std::uint8_t *inner, *outer, *not_inner;
  int* uncertain;       // list of those near that may show either side
  int* between;         // near, may lie between two sources
  int* on_winding_ray;  // near, may touch the winding ray
  int* upstream;        // asked, but with rays that are not certainly downstream
};
struct PatchesFound {
  int near, uncertain, between, on_winding_ray, upstream;  // lengths of the lists
  int asked;                                               // patches near that have rays
  Frustum bounds;                                          // of the rays that go downstream
};

/// Boxes of patches, see PatchArrays.
struct BoxArrays {
  const float* boxes;
  const int* patches;
  int count;
};

/// Rays and one element for each.
struct PairArrays {
  const float *targets, *local;
  float half_long;
  const std::uint32_t* corner_rows;  // see OrderedMesh
  const int *rays, *elements;
  // Bits of eight, for certain:
  std::uint8_t* blocked;  // the segment crosses the interior
  std::uint8_t* pierced;  // the line does
  std::uint8_t* apart;    // the segment does not touch the element
  std::uint8_t* missed;   // nor does its line
};

inline constexpr int kBoxFloats = 40;  // of eight elements

/// Rays are better parted if a place follows another in their list by more than `places`, or if some level of
/// a pyramid shows more than `blocks` in their common box.
struct Parting {
  int places, blocks;
};

/// Where pairs go, with room for all elements eight times and eight more, and two lists on the way to them
/// with room for all elements and eight more.
struct PairLists {
  int *rays, *elements, *first, *second;
};

/// Boxes over boxes, eight below one; see pyramid.hpp.
struct PyramidView {
  const float* boxes;
  int levels;
  int first[12];  // block of each level
  int last[12];   // and behind its last
};

struct KernelTable {
  /// Elements that an axial jet does not see from behind, inside the cut-off, to `candidates`: their number.
  int (*select)(const JetShape&, const FieldArrays&);
  /// Overpressure of the first `count` candidates; those without are dropped. Returns their number, or
  /// -1 - element where the overpressure is not finite.
  int (*evaluate)(const JetShape&, const FieldArrays&, int count);
  /// Sum of overpressure times area vector over `count` elements, to `sum` of four, three of which
  /// count.
  void (*force)(const Rows& area_vectors, const double* overpressure, const int* elements, int count,
                double* sum);

  /// Nodes to local coordinates and codes.
  ProjectFlags (*project_nodes)(const ProjectArrays&);
  /// Bits 0 to 4 of their codes, and nothing else.
  ProjectFlags (*code_nodes)(const ProjectArrays&);
  /// Local coordinates, and codes in their rows, of `count` nodes listed, a multiple of eight.
  ProjectFlags (*project_listed)(const ProjectArrays&, int count);
  /// Bounds of the rays to the centroids of `count` elements, of those that are certainly downstream.
  Frustum (*frustum_of)(const ProjectArrays&, float half_long, int count);
  PatchesFound (*classify_patches)(const PatchArrays&);
  /// Places of the bits of `count` bytes, a multiple of 32: their number. Room for eight more.
  int (*list_bits)(const std::uint8_t* bytes, int count, int* places);
  /// Of these patches those with elements `chosen`, bits by patch of the mesh, to `patches`: their number.
  /// And their boxes to `boxes`, those of other elements empty.
  int (*choose_boxes)(const BoxArrays&, const std::uint8_t* chosen, float* boxes, int* patches);
  /// The eight boxes of each block to one: the box around them. Lanes behind the last hold anything.
  void (*merge)(const float* blocks, int count, float* boxes);
  /// Pairs of these rays, eight at most, and elements whose boxes they meet: their number. Or `to_targets`:
  /// before their targets, without their own elements; places behind the mesh's last stand for that one, and
  /// are not left out. Lowest blocks of the pyramid stand for `patches`. Rays that are better parted: minus
  /// the number of the first of them, and 8 less if it is for the blocks.
  int (*find_pairs)(const RayArrays&, const Parting&, bool to_targets, const PyramidView&, const int* patches,
                    const PairLists&);
  void (*meet_pairs)(const PairArrays&, int count);
};

namespace baseline {
extern const KernelTable kTable;
}
namespace avx2 {
extern const KernelTable kTable;
}

/// The fastest that this processor has.
const KernelTable& kernel_table();

}  // namespace jet
