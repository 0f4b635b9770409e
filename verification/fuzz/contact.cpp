// SPDX-License-Identifier: Apache-2.0
// On any triangles the contact with any shape refuses, or its forces are finite and add up to that on the
// sphere.
#include <stdexcept>
#include <vector>

#include "bytes.hpp"
#include "coupling/error.hpp"
#include "coupling/sphere_contact.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const int node_count = bytes.integer(3, 12), element_count = bytes.integer(1, 16);
  Eigen::Matrix3Xd nodes(3, node_count), forces = Eigen::Matrix3Xd::Zero(3, node_count);
  for (int n = 0; n < node_count; ++n)
    for (int c = 0; c < 3; ++c) nodes(c, n) = bytes.number();
  Eigen::Matrix3Xi triangles(3, element_count);
  for (int e = 0; e < element_count; ++e)
    for (int a = 0; a < 3; ++a) triangles(a, e) = bytes.integer(0, node_count - 1);
  const std::vector<double> masses(static_cast<std::size_t>(node_count), bytes.number(1e-3, 1.0));
  const double radius = bytes.number(0.01, 10.0), stiffness = bytes.number(1.0, 1e8),
               friction = bytes.number(0.0, 2.0);
  Eigen::Vector3d centre, step;
  for (int c = 0; c < 3; ++c) centre(c) = bytes.number();
  for (int c = 0; c < 3; ++c) step(c) = bytes.number(-0.01, 0.01);
  const double length = bytes.number(0.0, 10.0);
  const coupling::Impactor shapes[] = {coupling::Sphere{radius},
                                       coupling::Ellipsoid{{radius, 0.5 * radius, 0.4 * radius}},
                                       coupling::Cylinder{radius, length}, coupling::Disc{length, radius}};
  const coupling::Impactor& shape = shapes[bytes.integer(0, 3)];
  try {
    const coupling::ContactModel model(triangles, nodes, masses, 1.0, {shape, stiffness, friction});
    coupling::ContactState state = model.make_state();
    for (int level = 0; level < 3; ++level) {
      forces.setZero();
      const auto result = model.evaluate(state, nodes, {centre + level * step}, forces);
      fuzz::require(forces.allFinite() && result.force.allFinite(), "forces are finite");
      const double largest = forces.cwiseAbs().maxCoeff();
      fuzz::require((forces.rowwise().sum() + result.force).cwiseAbs().maxCoeff() <= 1e-9 * (1.0 + largest),
                    "forces add up to nothing");
    }
  } catch (const std::invalid_argument&) {
    // elements without area, numbers out of range
  } catch (const coupling::ContactError&) {
    // too deep, or through the skin
  }
  return 0;
}
