// SPDX-License-Identifier: Apache-2.0
// Elements that close a hole: no force, no way through for the centre.
#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "scenes.hpp"

namespace {

using Eigen::Vector3d;
using scenes::kRadius;

struct OpenPlate {
  scenes::Skin skin = scenes::plate(6, kRadius);
  std::vector<int> open;
  coupling::ContactModel model;
  explicit OpenPlate(bool is_open)
      : open(is_open ? static_cast<std::size_t>(skin.triangles.cols()) : 0), model(build()) {}
  coupling::ContactModel build() {
    std::iota(open.begin(), open.end(), 0);
    return {skin.triangles, skin.nodes, skin.masses, 8.41, {coupling::Sphere{kRadius}, 1e8}, open};
  }
};

TEST(ContactOpen, overlap_pushes_nothing) {
  for (const bool is_open : {true, false}) {
    const OpenPlate plate(is_open);
    auto state = plate.model.make_state();
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, plate.skin.nodes.cols());
    const auto touch =
        plate.model.evaluate(state, plate.skin.nodes, {Vector3d(0.0, 0.0, 0.8 * kRadius)}, forces);
    EXPECT_EQ(touch.force.norm() == 0.0 && forces.norm() == 0.0 && touch.energy == 0.0, is_open);
  }
}

TEST(ContactOpen, centre_cannot_cross) {
  const OpenPlate plate(true);
  auto state = plate.model.make_state();
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, plate.skin.nodes.cols());
  plate.model.evaluate(state, plate.skin.nodes, {Vector3d(0.001, 0.002, 0.3 * kRadius)}, forces);
  try {
    plate.model.evaluate(state, plate.skin.nodes, {Vector3d(0.001, 0.002, -0.3 * kRadius)}, forces);
    ADD_FAILURE() << "crossed unseen";
  } catch (const coupling::ContactError& error) {
    EXPECT_NE(std::string(error.what()).find("crossed the skin"), std::string::npos) << error.what();
  }
}

TEST(ContactOpen, element_number_is_checked) {
  const scenes::Skin skin = scenes::plate(2, kRadius);
  const std::vector<int> bad{static_cast<int>(skin.triangles.cols())};
  EXPECT_THROW(coupling::ContactModel(skin.triangles, skin.nodes, skin.masses, 8.41,
                                      {coupling::Sphere{kRadius}, 1e8}, bad),
               std::invalid_argument);
}

}  // namespace
