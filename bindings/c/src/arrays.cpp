// SPDX-License-Identifier: Apache-2.0
#include "arrays.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace border {
namespace {

constexpr int64_t kMost = std::numeric_limits<int>::max() - 4;
constexpr int64_t kMostApart = int64_t{1} << 40;  // doubles from one row to the next: 8 TiB

Eigen::Matrix3Xd copy_of(const double* data, int count, Stride stride, std::span<const int> only) {
  Eigen::Matrix3Xd copy(3, count);
  for (const int i : only)
    for (int k = 0; k < 3; ++k) copy(k, i) = data[i * stride.row + k * stride.component];
  return copy;
}

std::vector<int> all_rows(int64_t count, std::string_view argument) {
  std::vector<int> rows(static_cast<std::size_t>(count_of(count, std::string(argument) + "_count")));
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

bool fits(Stride stride) {
  return stride.component == 1 && stride.row >= 3;
}

Points::View view_of(const double* data, int count, Stride stride, const Eigen::Matrix3Xd& copy) {
  if (!fits(stride)) return copy;
  return Eigen::Map<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>(data, 3, count,
                                                                     Eigen::OuterStride<>(stride.row));
}

}  // namespace

Stride stride_of(const int64_t* stride, int64_t count, std::string_view argument) {
  if (stride == nullptr) return {};
  const Stride given{stride[0], stride[1]};
  for (const int64_t apart : {given.row, given.component})
    if (apart > kMostApart || apart < -kMostApart)
      refuse(argument, "has the stride " + std::to_string(apart) +
                           ", allowed: counts of numbers from row to row and from component to component");
  if (given.component == 0 || (given.row == 0 && count > 1))
    refuse(argument, "has a stride of 0, allowed: a stride to other values");
  return given;
}

int count_of(int64_t count, std::string_view argument, int64_t least) {
  if (count < least || count > kMost)
    refuse(argument, "is " + std::to_string(count) + ", allowed: " + std::to_string(least) + " to " +
                         std::to_string(kMost));
  return static_cast<int>(count);
}

void require_count(int64_t count, int64_t wanted, std::string_view argument) {
  if (count != wanted)
    refuse(argument, "has " + std::to_string(count) + " numbers, allowed: " + std::to_string(wanted));
}

Points::Points(const double* data, int64_t count, const int64_t* stride, std::string_view argument)
    : Points(data, count, stride, argument, all_rows(count, argument)) {}

Points::Points(const double* data, int64_t count, const int64_t* stride, std::string_view argument,
               std::span<const int> only, bool finite)
    : copy_([&] {
        needed(data, argument);
        const Stride given = stride_of(stride, count, argument);
        const int rows = count_of(count, std::string(argument) + "_count");
        return fits(given) ? Eigen::Matrix3Xd() : copy_of(data, rows, given, only);
      }()),
      view_(view_of(data, static_cast<int>(count), stride_of(stride, count, argument), copy_)) {
  if (!finite) return;
  for (const int i : only)
    if (!view_.col(i).array().isFinite().all())
      refuse(argument,
             "has a coordinate in row " + std::to_string(i) + " that is not finite, allowed: finite numbers");
}

Eigen::Matrix3Xi triangles_of(const int32_t* data, int64_t count, const int64_t* stride, int64_t node_count) {
  needed(data, "triangles");
  const Stride given = stride_of(stride, count, "triangles");
  const int rows = count_of(count, "triangle_count", 1);
  count_of(node_count, "node_count", 1);
  Eigen::Matrix3Xi triangles(3, rows);
  for (int e = 0; e < rows; ++e)
    for (int k = 0; k < 3; ++k) {
      const int32_t node = triangles(k, e) = data[e * given.row + k * given.component];
      if (node < 0 || node >= node_count)
        refuse("triangles", "has the node " + std::to_string(node) + " in row " + std::to_string(e) +
                                ", allowed: 0 to " + std::to_string(node_count - 1));
    }
  return triangles;
}

std::vector<int> numbers_of(const int32_t* data, int64_t count, int64_t below, std::string_view argument) {
  const int size = count_of(count, std::string(argument) + ": its count");
  if (size == 0) return {};
  needed(data, argument);
  std::vector<int> numbers(data, data + size);
  for (const int number : numbers)
    if (number < 0 || number >= below)
      refuse(argument,
             "has the number " + std::to_string(number) + ", allowed: 0 to " + std::to_string(below - 1));
  return numbers;
}

Eigen::Vector3d vector_of(const double* data, std::string_view argument) {
  needed(data, argument);
  for (int i = 0; i < 3; ++i) number(data[i], argument);
  return {data[0], data[1], data[2]};
}

void write_vector(const Eigen::Vector3d& from, double* to) {
  std::copy(from.data(), from.data() + 3, to);
}

}  // namespace border
