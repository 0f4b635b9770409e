// SPDX-License-Identifier: Apache-2.0
// The candidates of a query, by their places in the mesh's order, and the exact rays to them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/blocking.hpp"
#include "visibility/mesh_order.hpp"

namespace jet {

/// One ray to each candidate.
class AskedRays {
 public:
  /// `patches`: bytes of a set of elements.
  void reserve(const OrderedMesh& mesh, std::size_t patches);
  void ask(const Surface& surface, const RaySource& source, std::span<const int> candidates);

  const Surface& surface() const { return surface_; }
  const RaySource& source() const { return *source_; }
  std::span<const int> places() const { return given_; }         // in the order of the candidates
  std::span<const std::uint8_t> bits() const { return asked_; }  // by patch: bits of the candidates
  int patches() const { return patches_; }                       // patches with candidates
  /// Number of candidates; one that is given twice counts once.
  std::size_t count() const;

  /// Ray to an element in the definition's arithmetic, made at its first use.
  const blocking::Ray& ray(int place) const;

  /// Places of the candidates outside these patches.
  std::span<const int> list_outside(std::span<const int> patches);

 private:
  Surface surface_;
  const RaySource* source_ = nullptr;
  const OrderedMesh* mesh_ = nullptr;
  std::vector<int> given_;
  std::vector<std::uint8_t> asked_, outside_;  // outside_, listed_: workspace
  std::vector<int> listed_;
  int patches_ = 0;
  mutable std::vector<blocking::Ray> made_;
  mutable std::vector<std::uint8_t> is_made_;
  mutable std::vector<int> made_places_;
};

}  // namespace jet
