// SPDX-License-Identifier: Apache-2.0
// The same bits from every instruction set, block order and number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <vector>

#include "membrane/node_order.hpp"
#include "scenes.hpp"

using membrane::Compression;
using membrane::Isa;

namespace {

struct Reversed {
  template <class F>
  void operator()(int count, F&& f) const {
    for (int block = count - 1; block >= 0; --block) f(block);
  }
};

struct TwoThreads {
  template <class F>
  void operator()(int count, F&& f) const {
    const auto half = [&](int parity) {
      for (int block = parity; block < count; block += 2) f(block);
    };
    std::thread other(half, 1);
    half(0);
    other.join();
  }
};

// Everything a run writes, after some steps with every load; surface and fabric in one pass, or in two.
template <class ForEachBlock>
std::vector<double> run(const mesh::Mesh& mesh, Compression compression, Isa isa, ForEachBlock for_each,
                        bool one_pass = true) {
  auto d = scenes::describe(mesh, compression);
  d.isa = isa;
  d.straps = {{0, 10, 4500.0, 0.01}};
  d.plates = {{{0.0, 0.0, -0.1}, {0.0, 0.0, 1.0}, 1e6}};
  d.fixed_nodes = {3};
  d.held_nodes = {{{5}, {5, 9}, {7}}};
  d.gravity = {0.0, 0.0, -9.81};
  d.mass_damping = 20.0;
  for (std::size_t e = 0; e < d.properties.size(); ++e)
    d.properties[e].porosity = 0.001 * static_cast<double>(e % 50);
  const auto model = make_model(d);
  auto s = membrane::make_state(model, scenes::shaken(mesh.nodes, 0.002, 1), {.jet = true, .contact = true});
  std::vector<double> dp(static_cast<std::size_t>(model.element_count), 700.0), out;
  const double dt = 2e-6;
  for (int i = 0; i < 3; ++i) {
    if (one_pass) {
      membrane::update_skin(model, s, for_each);
    } else {
      membrane::update_surface(model, s, for_each);
      membrane::membrane_forces(model, s, for_each);
    }
    membrane::update_mass_shares(model, s, for_each);
    membrane::update_geometry(model, s);
    membrane::pressure_forces(s, 2e4);
    membrane::jet_forces(model, s, dp);
    membrane::support_forces(model, s, for_each);
    const auto& sums = membrane::advance(model, s, i == 0 ? 0.0 : dt, dt, for_each);
    for (const double value :
         {s.surface.volume, s.surface.area, s.surface.porosity_area, s.surface.porosity_squared_area,
          s.surface.gradient_mobility, s.forces.strain_energy, s.forces.strap_energy, s.forces.plate_energy,
          s.forces.element_frequency, sums.work.total(), sums.kinetic_after, sums.max_speed_squared})
      out.push_back(value);
  }
  for (const membrane::Vectors* v :
       {&s.position, &s.velocity, &s.area_vector, &s.centroid, &s.membrane_force}) {
    const Eigen::Matrix3Xd values = v->map();
    out.insert(out.end(), values.data(), values.data() + values.size());
  }
  return out;
}

void expect_same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

// 42 elements (not whole groups of lanes), and 1280 (three blocks).
std::vector<mesh::Mesh> meshes() {
  return {mesh::rectangle(7, 3, 0.7, 0.3, mesh::Diagonals::uniform), mesh::icosphere(0.3, 3)};
}

}  // namespace

TEST(SameBits, every_instruction_set_gives_the_same_bits) {
  for (const auto& mesh : meshes())
    for (const auto compression : {Compression::linear, Compression::none}) {
      const auto scalar = run(mesh, compression, Isa::scalar, membrane::Serial{});
      expect_same_bits(scalar, run(mesh, compression, Isa::baseline, membrane::Serial{}));
      if (membrane::best_isa() != Isa::baseline)
        expect_same_bits(scalar, run(mesh, compression, membrane::best_isa(), membrane::Serial{}));
    }
}

// The libraries compile Eigen without vectors, whose users need not: its types must not move in our structs.
TEST(SameBits, eigens_types_are_aligned_as_by_default) {
#if defined(__SSE2__)
  EXPECT_EQ(alignof(Eigen::Vector2d), 16u);
  EXPECT_EQ(alignof(Eigen::Matrix2d), 16u);
  EXPECT_EQ(alignof(Eigen::Vector4d), 16u);
#endif
  EXPECT_EQ(alignof(Eigen::Vector3d), alignof(double));
}

// 156,800 elements: past the size from which a block is fetched while the one before it is computed.
TEST(SameBits, bag_too_large_for_the_cache_has_those_of_the_oracle) {
  const auto mesh = mesh::rectangle(280, 280, 1.0, 1.0, mesh::Diagonals::uniform);
  expect_same_bits(run(mesh, Compression::none, Isa::scalar, membrane::Serial{}),
                   run(mesh, Compression::none, membrane::best_isa(), membrane::Serial{}));
}

TEST(SameBits, every_block_order_gives_the_same_bits) {
  for (const auto& mesh : meshes()) {
    const auto serial = run(mesh, Compression::none, membrane::best_isa(), membrane::Serial{});
    expect_same_bits(serial, run(mesh, Compression::none, membrane::best_isa(), Reversed{}));
    expect_same_bits(serial, run(mesh, Compression::none, membrane::best_isa(), TwoThreads{}));
  }
}

// An icosphere's own numbers go by its subdivision, all over the sphere.
TEST(SameBits, node_order_puts_blocks_together_and_moves_no_node) {
  const auto mesh = mesh::icosphere(0.3, 3);
  const auto order = membrane::node_order(mesh.elements, mesh.node_count());
  const auto ordered = mesh::renumbered(mesh, order);
  const auto moved = [](const mesh::Mesh& m) {
    const auto model = make_model(scenes::describe(m, Compression::none));
    auto state = membrane::make_state(model, 1.01 * m.nodes);
    for (int i = 0; i < 20; ++i) {
      membrane::update_skin(model, state);
      membrane::pressure_forces(state, 2e4);
      membrane::advance(model, state, i == 0 ? 0.0 : 1e-5, 1e-5);
    }
    return state;
  };
  const auto a = moved(mesh), b = moved(ordered);
  EXPECT_TRUE(a.position.map()(Eigen::all, order) == b.position.map());
  EXPECT_TRUE(a.velocity.map()(Eigen::all, order) == b.velocity.map());
  EXPECT_NEAR(a.surface.volume / b.surface.volume, 1.0, 1280 * scenes::kEps);  // about another node
  const auto model = make_model(scenes::describe(ordered, Compression::none));
  std::int32_t next = 0;  // the blocks' own nodes follow each other, the shared ones come after them all
  for (const auto& block : model.elements.block)
    for (auto i = block.first_node; i < block.first_shared; ++i)
      EXPECT_EQ(model.elements.node[static_cast<std::size_t>(i)], next++);
  EXPECT_EQ(model.shared.node.front(), next);
  EXPECT_TRUE(renumbered(ordered, membrane::node_order(ordered.elements, ordered.node_count())).elements ==
              ordered.elements);
}

TEST(SameBits, node_order_has_every_node_once) {
  auto mesh = mesh::rectangle(2, 2, 1.0, 1.0, mesh::Diagonals::uniform);
  mesh.elements.conservativeResize(3, 1);  // the other nodes belong to no element
  auto order = membrane::node_order(mesh.elements, mesh.node_count());
  std::sort(order.begin(), order.end());
  for (int node = 0; node < mesh.node_count(); ++node)
    EXPECT_EQ(order.at(static_cast<std::size_t>(node)), node);
  mesh.elements(0, 0) = mesh.node_count();
  EXPECT_THROW(membrane::node_order(mesh.elements, mesh.node_count()), std::invalid_argument);
}

TEST(SameBits, one_pass_gives_the_same_bits_as_two) {
  for (const auto& mesh : meshes())
    for (const auto compression : {Compression::linear, Compression::none})
      expect_same_bits(run(mesh, compression, membrane::best_isa(), membrane::Serial{}),
                       run(mesh, compression, membrane::best_isa(), membrane::Serial{}, false));
}
