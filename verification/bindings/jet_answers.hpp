// SPDX-License-Identifier: Apache-2.0
// Jets at a rough surface, and all that a call of theirs returns, to compare bit for bit.
#pragma once

#include <cstring>
#include <random>

#include "meshes.hpp"

namespace border_test {

/// What a call returns.
struct Answer {
  std::vector<double> pressure;
  double force[3] = {};
  gasjet_visibility counters = {};
  bool operator==(const Answer& other) const {
    return pressure == other.pressure && std::memcmp(force, other.force, sizeof force) == 0 &&
           std::memcmp(&counters, &other.counters, sizeof counters) == 0;
  }
};

/// A box with scattered nodes, in which a smaller one, turned inside out, stands before a part of it.
inline Mesh rough(unsigned seed) {
  Mesh mesh = box(8, 2.0, -1.0), inner = box(2, 0.3, 0.2);
  for (std::size_t i = 0; i < inner.nodes.size(); ++i)
    if (i % 3 != 0) inner.nodes[i] -= 0.3;
  const auto first = static_cast<int32_t>(mesh.node_count());
  mesh.nodes.insert(mesh.nodes.end(), inner.nodes.begin(), inner.nodes.end());
  for (std::size_t e = 0; e < inner.triangles.size(); e += 3)
    for (const std::size_t k : {e, e + 2, e + 1}) mesh.triangles.push_back(first + inner.triangles[k]);
  std::mt19937 random(seed);
  for (double& x : mesh.nodes) x += 1e-3 * static_cast<double>(random() % 100);
  return mesh;
}

/// As a size.
inline std::size_t elements_of(const Mesh& mesh) {
  return static_cast<std::size_t>(mesh.triangle_count());
}

/// A broad jet, so that many elements are asked.
inline gasjet_jet_model slot() {
  gasjet_jet_model model = round_jet();
  model.radius = kNan;
  model.short_side = 0.2, model.long_side = 0.4;
  for (int i = 0; i < 3; ++i) model.long_direction[i] = i == 1 ? 1.0 : 0.0;
  return model;
}
/// The same, round.
inline gasjet_jet_model broad() {
  gasjet_jet_model model = round_jet();
  model.radius = 0.15;
  return model;
}

/// A jet on a mesh.
inline void make(Handle& jet, const gasjet_jet_model& model, const Mesh& mesh) {
  ASSERT_OK(gasjet_jet_create(&model, mesh.triangles.data(), mesh.triangle_count(), nullptr,
                              mesh.node_count(), nullptr, 0, nullptr, 0, &jet.value));
}

/// A call for all elements.
inline Answer answer(const Handle& jet, const Mesh& mesh, double bound = kNan) {
  Answer found{std::vector<double>(elements_of(mesh), 7.0)};
  EXPECT_OK(gasjet_jet_pressure(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, 400.0, 1.2, 1,
                                bound, found.pressure.data(), mesh.triangle_count(), found.force,
                                &found.counters));
  return found;
}

/// A call for some.
inline Answer answer_of(const Handle& jet, const Mesh& mesh, const std::vector<int32_t>& list,
                        double bound = kNan) {
  Answer found{std::vector<double>(list.size(), 7.0)};
  EXPECT_OK(gasjet_jet_pressure_of(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, nullptr, nullptr,
                                   400.0, 1.2, 1, bound, list.data(), static_cast<int64_t>(list.size()),
                                   found.pressure.data(), static_cast<int64_t>(list.size()), found.force,
                                   nullptr, &found.counters));
  return found;
}

}  // namespace border_test
