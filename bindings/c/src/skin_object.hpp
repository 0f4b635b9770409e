// SPDX-License-Identifier: Apache-2.0
// Input that jets and surfaces share.
#pragma once

#include <gasjet/jet.h>

#include <span>
#include <vector>

#include "arrays.hpp"
#include "jet/visibility.hpp"

namespace border {

/// Triangles of a caller, and the nodes they use.
struct Skin {
  /// Copies. Refuses a wrong array or count, with its name.
  Skin(const int32_t* data, int64_t count, const int64_t* stride, int64_t nodes, const int32_t* null_elements,
       int64_t null_count, const int32_t* attachment_elements, int64_t attachment_count);

  /// Rows of all nodes, of which a call reads only those of triangles. Without `finite` the caller checks
  /// them.
  Points points(const double* data, int64_t count, const int64_t* stride, bool finite,
                std::string_view argument = "nodes") const;
  /// The same for single precision: fills `copy`, a packed row for each node.
  Points points(const float* data, int64_t count, const int64_t* stride, std::vector<double>& copy,
                std::string_view argument) const;

  Eigen::Matrix3Xi triangles;  // node numbers, 3 x M
  jet::SurfaceRoles roles;     // null and attachment elements
  std::vector<int> named;      // nodes of triangles, ascending
  int64_t node_count;          // of the caller
};

/// Copies counters, unless `to` is NULL.
void write_counters(const jet::VisibilityCounters& from, gasjet_visibility* to);
/// Refuses a bound that is negative or infinite.
double bound_of(double displacement_bound);

}  // namespace border
