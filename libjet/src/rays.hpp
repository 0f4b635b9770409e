// SPDX-License-Identifier: Apache-2.0
// The rays of one query in the jet's frame, as boxes of the two coordinates that do not change along a ray:
// the slopes against the axis (point source), or slope across and place along the line (line source). An
// element covers a range of each. Boxes carry margins far above rounding, so they cost work at worst, never
// an answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blocking.hpp"
#include "frame.hpp"
#include "kernel_table.hpp"
#include "mesh_order.hpp"
#include "pyramid.hpp"

namespace jet {

class RayBundle {
 public:
  void reserve(std::size_t element_count, std::size_t node_count);
  void set_mesh(std::span<const Triangle> triangles) { mesh_ = OrderedMesh(triangles); }

  /// Projects rays and nodes; allocates nothing. False if no frame holds them all but a few: nothing but
  /// `size` is known then. Throws std::invalid_argument for coordinates out of range.
  bool build(const Surface& surface, const RaySource& source, std::span<const int> as_given);

  /// Ray of a candidate in the definition's arithmetic, made when first asked for.
  const blocking::Ray& ray(std::size_t k) const;

  /// Elements that can meet a ray or the way of the winding number, in the mesh's order; their number. `near`
  /// has room for eight more, which repeat the last.
  int collect(int* near) const;

  /// Boxes of elements, 32 floats for eight, and bits for those that all sources see
  /// from inside for certain, and those that none does.
  void element_boxes(const int* elements, int count, float* boxes, float* points, std::uint8_t* facing,
                     std::uint8_t* away) const;

  /// visit(hit, slot) for the rays that may touch the elements in the slots named, see KernelTable. `boxes`
  /// and `points` belong to the elements, `hits` is room for as many as there are rays.
  template <class Visit>
  void for_each_touching(const Pyramid& elements, const float* points, std::span<const int> slots, int* hits,
                         Visit visit) {
    for (std::size_t first = 0; first < slots.size(); first += 8) {
      const auto eight = slots.subspan(first, std::min<std::size_t>(8, slots.size() - first));
      make_list(elements, eight);
      for (const int slot : eight) {
        const int count = touching_rays(elements, points, slot, hits);
        for (int i = 0; i < count; ++i) visit(hits[i], slot);
      }
    }
  }
  /// Elements that may touch a ray; their number.
  int touching_elements(const Pyramid& elements, const float* points, std::size_t k, int* out) const;

  /// Certain that no way from one source to another meets the element.
  bool beside_sources(int element) const;

  /// From the source of a ray not aside, moved, to a point outside the surface, within the rays' bounds; and
  /// its box.
  blocking::Ray way(float* box) const;

  std::span<const int> candidates;   // in the mesh's order, in which all here is numbered
  std::vector<int> given;            // their places in the query
  double size = 0.0;                 // [m] bounds the magnitude of every coordinate of nodes and sources
  Pyramid boxes;                     // of the rays
  std::vector<std::uint32_t> aside;  // rays without length, or not downstream of the outlet: empty boxes

 private:
  void sort(std::span<const int> as_given);
  bool project();
  void make_list(const Pyramid& elements, std::span<const int> slots);
  int touching_rays(const Pyramid& elements, const float* points, int slot, int* out) const;
  void rescale();
  void set_scale(double extent);
  void set_sides(const RayBounds& bounds);
  void set_side(int bit, double slope, double bound);
  void find_aside(std::size_t count);

  Surface surface_;
  const RaySource* source_ = nullptr;
  OrderedMesh mesh_;
  std::vector<int> sorted_;
  std::vector<std::uint64_t> chosen_;  // bit i: the i-th element of the order is a candidate
  std::vector<int> given_at_;          // place of the i-th element in the query
  Frame frame_;
  double scale_ = 0.0;  // [1/m] power of two that brings local coordinates below 1; kept for the next query
  RayBounds bounds_{};
  ProjectArrays arrays_{};
  BoxArrays rays_{};
  ProjectFlags flags_{};
  unsigned outside_ = 0;              // bits of a code that keep an element out
  std::vector<float> local_;          // 4 a node
  std::vector<float> local_targets_;  // 4 a ray
  std::vector<float> points_;         // of the rays, see BoxArrays
  std::vector<float> list_boxes_;     // rays near some elements, see RayList
  std::vector<int> list_blocks_;
  int list_count_ = 0;
  std::vector<std::uint8_t> codes_;  // of the nodes
  std::vector<std::uint8_t> aside_bits_;
  mutable std::vector<blocking::Ray> made_;
  mutable std::vector<std::uint8_t> is_made_;
};

}  // namespace jet
