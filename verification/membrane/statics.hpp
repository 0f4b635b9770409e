// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "disc_mesh.hpp"
#include "scenes.hpp"

// Meshes of round membranes, and static equilibrium under constant overpressure.
namespace scenes {

// Grid closed in one direction, `around` x `along` cells with uniform diagonals; node i + j around at
// place(i / around, j / along). Outward if place turns anticlockwise about the second direction.
using Place = std::function<Eigen::Vector3d(double turn, double height)>;
mesh::Mesh wrapped_grid(int around, int along, const Place& place);

// Clears the components of the forces that a support takes up (symmetry planes, sliding edges).
using Support = std::function<void(membrane::BagState&)>;

// Nodes that stay in the plane x_c = constant.
struct HeldComponent {
  int component;
  std::vector<int> nodes;
};
Support sliding(std::vector<HeldComponent> held);

struct Rest {
  double potential;  // strain energy - overpressure * volume [J]
  double volume;     // between the surface and the origin [m3]: the bag's, if its cut planes meet there
  int steps;
};

// Moves the bag with the shipped dynamics from rest until no force exceeds `tolerance` [N]. Its damping is
// that of the slowest motion, 2 omega, with omega from the Rayleigh quotient of the last displacement
// (dynamic relaxation, P. Underwood 1983). Throws std::runtime_error after 100 000 steps.
Rest relax(membrane::BagModel model, membrane::BagState& state, double overpressure, double tolerance,
           const Support& support = {});

// Volume between the surface and the origin [m3]: that of the bag if its cut planes go through the origin.
double volume_about_origin(const membrane::BagState& state);

}  // namespace scenes
