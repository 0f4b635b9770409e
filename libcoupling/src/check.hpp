// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "coupling/skin.hpp"

namespace coupling::detail {

[[noreturn]] inline void reject(const std::string& field, const std::string& value,
                                const std::string& allowed) {
  throw std::invalid_argument(field + " = " + value + ": must be " + allowed);
}

inline std::string text(double value, int digits = 10) {
  std::ostringstream stream;
  stream.precision(digits);
  stream << value;
  return stream.str();
}

inline std::string text(const Eigen::Vector3d& v) {
  std::ostringstream stream;
  stream.precision(10);
  stream << '[' << v.x() << ", " << v.y() << ", " << v.z() << ']';
  return stream.str();
}

inline void require_positive(const std::string& field, double value) {
  if (!(std::isfinite(value) && value > 0.0)) reject(field, text(value), "finite and greater than 0");
}

inline void require_not_negative(const std::string& field, double value) {
  if (!(std::isfinite(value) && value >= 0.0)) reject(field, text(value), "finite and not negative");
}

inline void require_finite(const std::string& field, const Eigen::Vector3d& value) {
  if (!value.allFinite()) reject(field, text(value), "finite");
}

// Throws std::invalid_argument unless every corner is a column of the nodes.
inline void require_nodes(const std::string& field, const Triangles& triangles, Eigen::Index node_count) {
  for (Eigen::Index e = 0; e < triangles.cols(); ++e)
    for (int i = 0; i < 3; ++i)
      if (triangles(i, e) < 0 || triangles(i, e) >= node_count)
        reject(field + "[" + std::to_string(e) + "]", std::to_string(triangles(i, e)), "a node number");
}

}  // namespace coupling::detail
