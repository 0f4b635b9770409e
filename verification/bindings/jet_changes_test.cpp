// SPDX-License-Identifier: Apache-2.0
// A jet that changes between calls: moved outlet, elements off and on, some elements. Each answer is compared
// bit for bit with a jet made for it alone.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "jet_answers.hpp"

using namespace border_test;

namespace {

TEST(c_jet_place, moved_outlet_eq_a_jet_made_there) {
  const Mesh mesh = rough(1);
  std::mt19937 random(2);
  const auto in_unit = [&] { return 2e-3 * static_cast<double>(random() % 1000) - 1.0; };
  for (gasjet_jet_model model : {broad(), slot()}) {
    Handle jet;
    make(jet, model, mesh);
    int64_t hidden = 0;
    for (int step = 0; step < 30; ++step) {
      const double large = step % 10 == 9 ? 0.5 : 0.01;  // small motions, and now and then a large one
      for (double& x : model.centre) x = std::clamp(x + large * in_unit(), -0.5, 0.1);
      for (double& x : model.axis) x += large * in_unit();
      const Eigen::Vector3d axis(model.axis[0], model.axis[1], model.axis[2]), side = axis.unitOrthogonal();
      std::copy(side.data(), side.data() + 3, model.long_direction);
      ASSERT_OK(gasjet_jet_place(jet.value, model.centre, model.axis, model.long_direction));
      Handle fresh;
      make(fresh, model, mesh);
      const Answer moved = answer(jet, mesh, 0.0);  // nodes at rest: what is kept must not show
      EXPECT_TRUE(moved == answer(fresh, mesh)) << step;
      hidden += moved.counters.hidden;
    }
    EXPECT_GT(hidden, 30);
  }
}

TEST(c_jet_place, the_long_side_turns_with_the_axis) {
  const Mesh mesh = rough(1);
  gasjet_jet_model model = slot();
  Handle jet, fresh;
  make(jet, model, mesh);
  const double axis[] = {0.0, 0.0, 2.0}, centre[] = {0.0, 0.1, 0.0};
  ASSERT_OK(gasjet_jet_place(jet.value, centre, axis, nullptr));  // about y, the long side
  std::copy_n(axis, 3, model.axis);
  std::copy_n(centre, 3, model.centre);
  make(fresh, model, mesh);
  EXPECT_TRUE(answer(jet, mesh) == answer(fresh, mesh));
}

/// The mesh without the elements that are off, and where the others are in the whole one.
struct Rest {
  Mesh mesh;
  std::vector<std::size_t> elements;
  Rest(const Mesh& whole, const std::vector<uint8_t>& on) {
    mesh.nodes = whole.nodes;
    for (std::size_t e = 0; e < on.size(); ++e) {
      if (on[e] == 0) continue;
      elements.push_back(e);
      mesh.triangles.insert(mesh.triangles.end(), whole.triangles.begin() + static_cast<long>(3 * e),
                            whole.triangles.begin() + static_cast<long>(3 * e + 3));
    }
  }
  Answer in_whole(Answer found, std::size_t elements_of_whole) const {
    std::vector<double> all(elements_of_whole, 0.0);
    for (std::size_t k = 0; k < elements.size(); ++k) all[elements[k]] = found.pressure[k];
    found.pressure = all;
    return found;
  }
};

TEST(c_jet_elements, off_eq_a_mesh_without_them) {
  Mesh mesh = rough(3);
  std::mt19937 random(4);
  for (const int pieces : {1, 2}) {
    Handle jet;
    make(jet, broad(), mesh);
    ASSERT_OK(gasjet_jet_subdivide(jet.value, pieces));
    std::vector<uint8_t> on(elements_of(mesh), 1);
    const Answer whole = answer(jet, mesh);
    int differ = 0;
    for (int step = 0; step < 12; ++step) {
      for (uint8_t& one : on)
        if (random() % 30 == 0) one ^= 1;  // off, or on again
      ASSERT_OK(gasjet_jet_set_elements(jet.value, on.data(), mesh.triangle_count()));
      const Rest rest(mesh, on);
      Handle fresh;
      make(fresh, broad(), rest.mesh);
      ASSERT_OK(gasjet_jet_subdivide(fresh.value, pieces));
      for (int call = 0; call < 2; ++call) {  // the second has data of the first
        const Answer found = answer(jet, mesh, 1e-3);
        EXPECT_TRUE(found == rest.in_whole(answer(fresh, rest.mesh), on.size())) << step;
        differ += found.counters.hidden != whole.counters.hidden;
      }
    }
    EXPECT_GT(differ, 12) << "what blocks must change";
    std::fill(on.begin(), on.end(), uint8_t{1});
    ASSERT_OK(gasjet_jet_set_elements(jet.value, on.data(), mesh.triangle_count()));
    EXPECT_TRUE(answer(jet, mesh) == whole);
    std::fill(on.begin(), on.end(), uint8_t{0});
    ASSERT_OK(gasjet_jet_set_elements(jet.value, on.data(), mesh.triangle_count()));
    const Answer none = answer(jet, mesh);
    EXPECT_EQ(none.counters.candidates, 0);
    EXPECT_EQ(none.pressure, std::vector<double>(on.size(), 0.0));
  }
}

/// A source on an element is moved along the axis; on one that is off it is not.
TEST(c_jet_elements, a_source_on_an_element_that_is_off) {
  const Mesh mesh = box(4, 1.0, 0.0);
  gasjet_jet_model model = broad();
  std::vector<uint8_t> on(elements_of(mesh), 1);
  std::copy_n(std::array{0.0, 0.125, 0.25}.data(), 3, model.centre);  // on an edge of the side x = 0
  model.axis[2] = 0.7;
  Handle jet;
  make(jet, model, mesh);
  const auto at_outlet = [&](std::size_t e) {
    for (std::size_t k = 3 * e; k < 3 * e + 3; ++k)
      if (mesh.nodes[3 * static_cast<std::size_t>(mesh.triangles[k])] != 0.0) return false;
    return true;
  };
  for (std::size_t e = 0; e < on.size(); ++e) on[e] = !at_outlet(e);
  const Rest rest(mesh, on);
  Handle fresh;
  make(fresh, model, rest.mesh);
  ASSERT_OK(gasjet_jet_set_elements(jet.value, on.data(), mesh.triangle_count()));
  EXPECT_TRUE(answer(jet, mesh) == rest.in_whole(answer(fresh, rest.mesh), on.size()));
}

TEST(c_jet_elements, ranks_together_eq_the_whole) {
  const Mesh mesh = rough(5);
  for (const int pieces : {1, 3}) {
    Handle jet;
    make(jet, broad(), mesh);
    ASSERT_OK(gasjet_jet_subdivide(jet.value, pieces));
    const Answer whole = answer(jet, mesh);
    EXPECT_GT(whole.counters.hidden, 0);
    for (const std::size_t ranks : {2u, 3u, 7u}) {
      Answer together{std::vector<double>(elements_of(mesh), 7.0)};
      double size = 0.0;
      for (std::size_t rank = 0; rank < ranks; ++rank) {
        std::vector<int32_t> list;  // not in order
        for (std::size_t e = rank; e < elements_of(mesh); e += ranks)
          list.insert(list.begin(), static_cast<int32_t>(e));
        const Answer part = answer_of(jet, mesh, list, 1e-3);
        for (std::size_t k = 0; k < list.size(); ++k)
          together.pressure[static_cast<std::size_t>(list[k])] = part.pressure[k];
        for (int i = 0; i < 3; ++i) together.force[i] += part.force[i], size += std::abs(part.force[i]);
        together.counters.candidates += part.counters.candidates;
        together.counters.hidden += part.counters.hidden;
      }
      EXPECT_EQ(together.pressure, whole.pressure);
      EXPECT_EQ(together.counters.candidates, whole.counters.candidates);
      EXPECT_EQ(together.counters.hidden, whole.counters.hidden);
      for (int i = 0; i < 3; ++i)  // sums in another order: one rounding an element
        EXPECT_NEAR(together.force[i], whole.force[i], 2.3e-16 * 800 * size);
    }
    std::vector<int32_t> all(elements_of(mesh));
    for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<int32_t>(e);
    EXPECT_TRUE(answer_of(jet, mesh, all) == whole);
    const int32_t none = 0;
    double nothing, force[3];
    ASSERT_OK(gasjet_jet_pressure_of(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, nullptr,
                                     nullptr, 400.0, 1.2, 1, kNan, &none, 0, &nothing, 0, force, nullptr,
                                     nullptr));
    EXPECT_EQ(force[0], 0.0);
  }
}

}  // namespace
