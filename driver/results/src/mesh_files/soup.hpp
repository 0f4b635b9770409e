// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace driver {

/// Formats that CGAL reads.
enum class SoupFormat { stl, ply };

/// Nodes and polygons as a file has them.
struct Soup {
  Eigen::Matrix3Xd nodes;                  // 3 x N
  std::vector<std::vector<int>> polygons;  // node numbers from 0
  std::string fault;                       // what is wrong; empty if nothing is
  std::size_t stopped_at = 0;              // byte at which the reader gave up or ended
  bool is_text = true;                     // false: lines mean nothing
};

/// Reads the bytes of a file with CGAL. Never throws for a bad file. Precondition: counts of the header fit
/// into the file.
Soup read_soup(SoupFormat format, const std::string& bytes);

}  // namespace driver
