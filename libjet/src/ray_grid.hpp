// SPDX-License-Identifier: Apache-2.0
// Rays sorted by where they go, so that an element finds the few that can meet it. Every ray has two
// coordinates that do not change along it: for a point source the two slopes against the axis; for a line
// source the slope across and the place along the line. An element covers a range of each. As in rays.hpp the
// ranges carry margins.
#pragma once

#include <cstdint>
#include <vector>

#include "blocking.hpp"
#include "rays.hpp"

namespace jet {

class RayGrid {
 public:
  void reserve(std::size_t ray_count, std::size_t node_count);

  /// Sorts all rays but those aside. Precondition: `bundle` is bounded.
  void build(const RayBundle& bundle, const Surface& surface, double size);

  /// visit(ray index) for every ray that can meet the element, and perhaps for some others.
  template <class Visit>
  void for_each_near(const Surface& surface, int element, Visit visit) const {
    const Range range = element_range(surface, element);
    const int first = bin(range.low[0], 0), last = bin(range.high[0], 0);
    for (int row = bin(range.low[1], 1); row <= bin(range.high[1], 1); ++row) {
      const std::uint32_t* start = cell_start_.data() + row * side_;
      for (std::uint32_t i = start[first]; i < start[last + 1]; ++i) {
        const Entry& entry = sorted_[i];
        const bool inside = entry.p >= range.low[0] && entry.p <= range.high[0] && entry.q >= range.low[1] &&
                            entry.q <= range.high[1];
        if (inside) visit(entry.ray);
      }
    }
    for (const std::uint32_t ray : wide_) visit(ray);
  }

 private:
  struct Entry {
    double p, q;
    std::uint32_t ray;
  };
  struct Range {
    double low[2], high[2];
  };
  /// Where a point projects to, and which of its local coordinates are too small to rely on (bits).
  struct Place {
    double p, q;
    unsigned small;
  };
  Place place(const Local& x) const;
  bool has_place(const Local& target, const Local& ray) const;
  Range element_range(const Surface& surface, int element) const;
  void extend(Range& range, int axis, unsigned small, double margin) const;
  int bin(double value, int axis) const;
  int cell(const Entry& entry) const { return bin(entry.q, 1) * side_ + bin(entry.p, 0); }
  void sort();

  bool line_ = false;
  double size_ = 0.0;
  int side_ = 1;
  double first_[2], scale_[2];
  std::vector<Place> nodes_;
  std::vector<Entry> entries_, sorted_;
  std::vector<std::uint32_t> cell_start_;
  std::vector<std::uint32_t> wide_;
};

}  // namespace jet
