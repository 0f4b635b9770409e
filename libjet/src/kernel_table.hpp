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
};

struct FieldArrays {
  Rows area_vectors, centroids, velocities;
  bool relative_to_skin;
  const std::uint8_t* is_null;
  int count;                // elements
  double velocity, factor;  // [m/s] V0, [kg/m3] (1 + e) rho0
  double* overpressure;     // [Pa] written at the candidates
  int* candidates;
};

/// Coordinates along a jet as floats between -1 and 1, four a row: u across, v along the outlet's long side,
/// w downstream, 0.
struct ProjectArrays {
  Rows nodes;            // [m]
  int count;             // of nodes
  double centre[3];      // [m]
  double column[3][4];   // [1/m] (u, v, w, 0) of x, y and z
  float* local;          // 4 a node, and room for 7 more nodes
  const int* triangles;  // 3 an element
  const int* elements;   // to project the centroids of
  std::uint8_t* codes;   // bits 0 to 4: u - slope w below -bound, above bound, the same of v, w below -bound;
  float slope[5], bound[5];  // bit 7: w <= 0 in double. Room for 7 more as well
};

struct ProjectFlags {
  bool outside;  // some coordinate is not within -1 and 1, or not a number
  bool small;    // none is above 1/64
  bool tiny;     // some coordinate of a node is not 0, but below 1e-100
};

/// Boxes of the two coordinates that do not change along a ray, eight side by side: low p, high p, low q,
/// high q.
struct BoxArrays {
  const float* local;
  float half_long;  // 0: a point source
  float* boxes;     // 32 floats for eight
  float* points;  // eight u, eight v and so on: the rays' targets and places of their sources, the elements'
                  // corners
  // Of elements:
  const int* elements;  // indices of a multiple of eight elements
  const int* triangles;
  float error;           // absolute part of the bound of the orientation
  std::uint8_t* facing;  // bit i of byte b: element 8 b + i faces all sources for certain
  std::uint8_t* away;    // faces none of them for certain
};

/// Slopes u/w (v/w, or v of a line of sources) of the rays, with their errors.
struct RayBounds {
  float low_u, high_u, low_v, high_v;
};

/// Local coordinates of what is to be met.
struct Touch {
  float corner[9];          // element: (u, v, w) of its corners
  float target[3], source;  // ray
};
/// What a kernel knows of a ray that may touch an element: nothing more, that its segment crosses the
/// interior, or that the line does, before or behind the segment.
inline constexpr int kHitKinds = 4, kBlocked = 1, kMet = 2;
inline constexpr int kRayFloats = 32, kElementFloats = 72;  // of the points of eight

/// Boxes over boxes, eight below one; see pyramid.hpp.
struct PyramidView {
  const float* boxes;
  int levels;
  int first[12];  // block of each level
  int last[12];   // and behind its last
};

/// Blocks of eight rays, and the boxes around them.
struct RayList {
  const float* boxes;
  const int* blocks;
  int count;
  const float* ray_boxes;
  const float* ray_points;
};

struct KernelTable {
  /// Elements that an axial jet does not see from behind, inside the cut-off, to `candidates`: their number.
  int (*select)(const JetShape&, const FieldArrays&);
  /// Overpressure of the first `count` candidates; those without are dropped. Returns their number, or
  /// -1 - element where the overpressure is not finite.
  int (*evaluate)(const JetShape&, const FieldArrays&, int count);

  /// Nodes to local coordinates and codes; centroids of `count` elements to local coordinates.
  ProjectFlags (*project_nodes)(const ProjectArrays&);
  void (*project_centroids)(const ProjectArrays&, int count);
  /// Boxes and bounds of `count` rays; those not certainly downstream get empty boxes and a bit in `aside`.
  RayBounds (*ray_boxes)(const BoxArrays&, int count, std::uint8_t* aside);
  void (*element_boxes)(const BoxArrays&, int count);
  /// The eight boxes of a block to one: the box around them.
  void (*merge)(const float* block, float* box);
  /// Entries whose boxes overlap `box`, in ascending order, to `out`: their number. An entry stands there
  /// times kHitKinds, plus what is certain of it.
  int (*overlap)(const PyramidView&, const float* box, int* out);
  /// Blocks of rays that overlap any of eight boxes: boxes to `list`, numbers to `blocks`, their number.
  int (*shortlist)(const PyramidView& rays, const float* boxes, float* list, int* blocks);
  /// Entries that may touch, in this way: rays of the list the element, which has this box; elements the
  /// segment from (0, source, 0) to the target.
  int (*rays_touching)(const RayList&, const float* box, const Touch& element, int* out);
  int (*elements_touching)(const PyramidView&, const float* box, const float* points, const Touch& ray,
                           int* out);
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
