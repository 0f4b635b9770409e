// SPDX-License-Identifier: Apache-2.0
// Arrays of a caller for the libraries, without a copy if the layout allows it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "border.hpp"

namespace border {

/// Refuses a count below `least` or too large for an int.
int count_of(int64_t count, std::string_view argument, int64_t least = 0);
/// Refuses a count other than `wanted`.
void require_count(int64_t count, int64_t wanted, std::string_view argument);

/// Distances in an array, counted in its numbers.
struct Stride {
  int64_t row = 3;        // from row to row
  int64_t component = 1;  // from component to component
};
/// The stride given, or that of packed rows for NULL. Refuses an impossible one.
Stride stride_of(const int64_t* stride, int64_t count, std::string_view argument);

/// Rows of three doubles: a view if the components are adjacent, otherwise a copy.
class Points {
 public:
  using View = Eigen::Ref<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>;
  /// Refuses NULL, impossible strides, and a coordinate that is not finite, with its row.
  Points(const double* data, int64_t count, const int64_t* stride, std::string_view argument);
  /// Reads only the rows `only`, each below `count`; the view's other rows may have any content. Without
  /// `finite` the caller checks the coordinates.
  Points(const double* data, int64_t count, const int64_t* stride, std::string_view argument,
         std::span<const int> only, bool finite = true);
  Points(const Points&) = delete;
  Points& operator=(const Points&) = delete;
  const View& view() const { return view_; }

 private:
  Eigen::Matrix3Xd copy_;
  View view_;
};

/// Rows of three node numbers from 0, copied. Refuses a number that is not a node, with its row.
Eigen::Matrix3Xi triangles_of(const int32_t* data, int64_t count, const int64_t* stride, int64_t node_count);

/// Element or node numbers; NULL with count 0.
std::vector<int> numbers_of(const int32_t* data, int64_t count, int64_t below, std::string_view argument);

/// Three finite numbers.
Eigen::Vector3d vector_of(const double* data, std::string_view argument);
void write_vector(const Eigen::Vector3d& from, double* to);

/// An output array of `wanted` numbers.
template <class T>
std::span<T> output(T* data, int64_t count, int64_t wanted, std::string_view argument) {
  needed(data, argument);
  require_count(count, wanted, argument);
  return {data, static_cast<std::size_t>(count)};
}

}  // namespace border
