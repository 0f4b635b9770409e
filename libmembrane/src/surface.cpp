// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "kernel_table.hpp"
#include "membrane/error.hpp"
#include "membrane/stages.hpp"

namespace membrane {

namespace {

int blocks_of(int count) {
  return (count + kBlock - 1) / kBlock;
}

}  // namespace

int element_blocks(const BagModel& model) {
  return blocks_of(model.element_count);
}
int node_blocks(const BagModel& model) {
  return blocks_of(model.node_count);
}

void surface_block(const BagModel& model, BagState& state, int block) {
  const ElementConstants& c = model.constants;
  const SurfaceArrays arrays{c.node_a.data(),          c.node_b.data(),           c.node_c.data(),
                             c.porosity.data(),        c.porosity_squared.data(), state.position.data(),
                             state.area_vector.data(), state.centroid.data(),     state.area.data()};
  const int first = block * kBlock, last = std::min(first + kBlock, padded(model.element_count));
  SurfaceTotals totals{};
  kernel_table(model.description.isa).surface(arrays, first, last, totals);
  SurfaceSums& sums = state.block[static_cast<std::size_t>(block)].surface;
  sums.volume = totals.moment;
  sums.area = totals.area;
  sums.porosity_area = totals.porosity_area;
  sums.porosity_squared_area = totals.porosity_squared_area;
}

void volume_gradient_block(const BagModel& model, BagState& state, int block) {
  const NodeArrays arrays{model.corners.row_begin.data(),
                          model.corners.element.data(),
                          model.corners.offset.data(),
                          model.inverse_mass.data(),
                          state.corner_force.data(),
                          state.area_vector.data(),
                          nullptr,
                          state.volume_gradient.data()};
  const int first = block * kBlock, last = std::min(first + kBlock, model.node_count);
  kernel_table(model.description.isa)
      .volume_gradient(arrays, first, last,
                       state.block[static_cast<std::size_t>(block)].surface.gradient_mobility);
}

// The volume is taken about the first node, (1/3) sum of (x_a - x_0) . S_e, so that it does not depend on
// where the origin is; on a closed surface this is (1/6) sum of x_a . (x_b x x_c).
void sum_surface(const BagModel& model, BagState& state) {
  SurfaceSums sums;
  double moment = 0.0;
  for (int b = 0; b < element_blocks(model); ++b) {
    const SurfaceSums& block = state.block[static_cast<std::size_t>(b)].surface;
    moment += block.volume;
    sums.area += block.area;
    sums.porosity_area += block.porosity_area;
    sums.porosity_squared_area += block.porosity_squared_area;
  }
  for (int b = 0; b < node_blocks(model); ++b)
    sums.gradient_mobility += state.block[static_cast<std::size_t>(b)].surface.gradient_mobility;
  sums.volume = moment / 3.0;
  if (!std::isfinite(sums.volume) || !std::isfinite(sums.area))
    throw MembraneError("stage surface: the enclosed volume is not finite");
  state.surface = sums;
}

}  // namespace membrane
