// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace driver {

/// Formats that CGAL reads.
enum class SoupFormat { stl, ply };

/// Nodes and polygons as in the file.
struct Soup {
  Eigen::Matrix3Xd nodes;                  // 3 x N
  std::vector<std::vector<int>> polygons;  // node numbers from 0
  std::string fault;                       // the fault of the file; empty if there is none
  std::size_t stopped_at = 0;              // byte at which the reader stopped
  bool is_text = true;                     // false: the file has no lines
};

/// Reads the bytes of a file with CGAL. Never throws for a bad file. Precondition: counts of the header fit
/// into the file.
Soup read_soup(SoupFormat format, const std::string& bytes);

}  // namespace driver
