// SPDX-License-Identifier: Apache-2.0
#include <random>
#include <stdexcept>

#include "engine/scene.hpp"

namespace driver {

void displace_nodes(Scene& scene, double amplitude, int seed) {
  if (!scene.bag) throw std::invalid_argument("the scene has no membrane to displace");
  if (amplitude == 0.0) return;
  const auto inverse_mass = scene.bag->model.inverse_mass.map();
  Eigen::Matrix3Xd& position = scene.bag->initial_position;
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  for (Eigen::Index node = 0; node < position.cols(); ++node)
    for (int axis = 0; axis < 3; ++axis) {
      // By hand: the standard distributions differ between libraries.
      const double unit = static_cast<double>(generator() >> 11) * 0x1p-53;
      if (inverse_mass(axis, node) > 0.0) position(axis, node) += amplitude * (2.0 * unit - 1.0);
    }
}

}  // namespace driver
