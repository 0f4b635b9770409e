// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <new>
#include <vector>

#include "membrane/element_group.hpp"

namespace membrane {

/// Allocator of storage aligned to cache lines, so that the SIMD kernels load whole nodes.
template <class T>
struct AlignedAllocator {
  using value_type = T;                              // required by std::allocator_traits
  static constexpr std::align_val_t kAlignment{64};  // [byte] a cache line
  AlignedAllocator() = default;
  /// Allocators of all types are interchangeable.
  template <class U>
  explicit AlignedAllocator(const AlignedAllocator<U>&) {}
  /// Allocates n values at a multiple of kAlignment. Throws std::bad_alloc.
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), kAlignment)); }
  /// Frees memory from allocate().
  void deallocate(T* p, std::size_t) { ::operator delete(p, kAlignment); }
  /// Always true: any allocator can free another one's memory.
  template <class U>
  bool operator==(const AlignedAllocator<U>&) const {
    return true;
  }
};

/// std::vector that starts at a cache line.
template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

/// 3 x n view with columns 4 doubles apart. It binds without a copy to Eigen::Ref<const Eigen::Matrix3Xd, 0,
/// Eigen::OuterStride<>>.
using VectorsMap = Eigen::Map<Eigen::Matrix3Xd, Eigen::Unaligned, Eigen::OuterStride<4>>;
/// The same, read-only.
using ConstVectorsMap = Eigen::Map<const Eigen::Matrix3Xd, Eigen::Unaligned, Eigen::OuterStride<4>>;
/// Argument type that takes either view or a plain 3 x n matrix.
using ConstVectorsRef = Eigen::Ref<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<>>;

/// Length of an array of vectors or elements, rounded up to whole groups of lanes.
constexpr int padded(int count) {
  return (count + kLanes - 1) / kLanes * kLanes;
}

/// n vectors of three components, each padded by a zero to 4 doubles.
class Vectors {
 public:
  Vectors() = default;
  /// n vectors, all zero. Precondition: count >= 0.
  explicit Vectors(int count) : count_(count), values_(4 * static_cast<std::size_t>(padded(count)), 0.0) {}

  int count() const { return count_; }        // n
  bool empty() const { return count_ == 0; }  // n = 0
  double* data() { return values_.data(); }   // 4 doubles a vector, 64-byte aligned, padded(n) vectors
  /// The same, read-only.
  const double* data() const { return values_.data(); }
  /// View as a 3 x n matrix, valid as long as this object.
  VectorsMap map() { return VectorsMap(values_.data(), 3, count_); }
  /// The same, read-only.
  ConstVectorsMap map() const { return ConstVectorsMap(values_.data(), 3, count_); }

 private:
  int count_ = 0;
  AlignedVector<double> values_;  // 4 x n, column-major
};

}  // namespace membrane
