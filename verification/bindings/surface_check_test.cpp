// SPDX-License-Identifier: Apache-2.0
// Faults of surfaces through gasjet.h.
#include "meshes.hpp"

using namespace border_test;

namespace {

struct Checked {
  gasjet_surface_faults faults{};
  std::string text;
};

Checked check(const Mesh& mesh) {
  Checked found;
  int64_t needed = 0;
  const auto ask = [&](char* text, int64_t size) {
    return gasjet_surface_check(mesh.nodes.data(), mesh.node_count(), nullptr, mesh.triangles.data(),
                                mesh.triangle_count(), nullptr, &found.faults, text, size, &needed);
  };
  EXPECT_OK(ask(nullptr, 0));
  found.text.resize(static_cast<std::size_t>(needed));
  EXPECT_OK(ask(found.text.data(), needed));
  found.text.pop_back();
  return found;
}

void turn(Mesh& mesh, std::size_t element) {
  std::swap(mesh.triangles[3 * element], mesh.triangles[3 * element + 1]);
}

TEST(c_surface_check, nothing_is_found_in_a_box) {
  const Checked found = check(box(3, 0.5));
  EXPECT_EQ(found.faults.ok, 1);
  EXPECT_EQ(found.faults.boundary_edges, 0);
  EXPECT_EQ(found.text, "");
}

TEST(c_surface_check, a_missing_triangle_leaves_three_open_edges) {
  Mesh mesh = box(3, 0.5);
  mesh.triangles.resize(mesh.triangles.size() - 3);
  const Checked found = check(mesh);
  EXPECT_EQ(found.faults.ok, 0);
  EXPECT_EQ(found.faults.boundary_edges, 3);
  EXPECT_EQ(found.faults.inconsistent_edges, 0);
  EXPECT_NE(found.text, "");
}

TEST(c_surface_check, a_triangle_wound_the_other_way_has_three_inconsistent_edges) {
  Mesh mesh = box(3, 0.5);
  turn(mesh, 7);
  const Checked found = check(mesh);
  EXPECT_EQ(found.faults.ok, 0);
  EXPECT_EQ(found.faults.inconsistent_edges, 3);
  EXPECT_EQ(found.faults.boundary_edges, 0);
}

TEST(c_surface_check, a_surface_wound_inward_is_told) {
  Mesh mesh = box(3, 0.5);
  for (std::size_t e = 0; e < mesh.triangles.size() / 3; ++e) turn(mesh, e);
  const Checked found = check(mesh);
  EXPECT_EQ(found.faults.ok, 0);
  EXPECT_EQ(found.faults.inward, 1);
  EXPECT_EQ(found.faults.inconsistent_edges, 0);
}

TEST(c_surface_check, two_boxes_and_a_node_apart_are_told) {
  Mesh mesh = box(1, 0.5);
  const Mesh other = box(1, 0.5, 2.0);
  const auto first = static_cast<int32_t>(mesh.node_count());
  mesh.nodes.insert(mesh.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (const int32_t node : other.triangles) mesh.triangles.push_back(first + node);
  mesh.nodes.insert(mesh.nodes.end(), {5.0, 5.0, 5.0});
  const Checked found = check(mesh);
  EXPECT_EQ(found.faults.more_components, 1);
  EXPECT_EQ(found.faults.unused_nodes, 1);
}

TEST(c_surface_check, bad_calls_are_refused) {
  const Mesh mesh = box(1, 0.5);
  gasjet_surface_faults faults{};
  int64_t needed = 0;
  const auto ask = [&](const double* nodes, const int32_t* triangles, gasjet_surface_faults* to,
                       int64_t* size) {
    const int status = gasjet_surface_check(nodes, mesh.node_count(), nullptr, triangles,
                                            mesh.triangle_count(), nullptr, to, nullptr, 0, size);
    EXPECT_EQ(status, GASJET_BAD_INPUT);
    const std::string message = gasjet_last_error();
    return message.substr(0, message.find(':'));
  };
  const double* x = mesh.nodes.data();
  const int32_t* t = mesh.triangles.data();
  EXPECT_EQ(ask(nullptr, t, &faults, &needed), "nodes");
  EXPECT_EQ(ask(x, nullptr, &faults, &needed), "triangles");
  EXPECT_EQ(ask(x, t, nullptr, &needed), "faults");
  EXPECT_EQ(ask(x, t, &faults, nullptr), "needed");
  std::vector<int32_t> shifted = mesh.triangles;
  for (int32_t& node : shifted) ++node;
  EXPECT_EQ(ask(x, shifted.data(), &faults, &needed), "triangles");
}

}  // namespace
