// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"
#include "mesh/icosphere.hpp"

// Small membranes shared by these tests.
namespace scenes {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

// Fabric of the paper: 60 MPa, 0.3, 0.5 mm, 620 kg/m3.
inline membrane::ElementProperties fabric(double porosity = 0.0) {
  return {0.5e-3, 620.0, 60e6, 0.3, porosity, false};
}

inline membrane::BagDescription describe(const mesh::Mesh& mesh, membrane::Compression compression) {
  membrane::BagDescription d;
  d.reference = mesh.nodes;
  d.elements = mesh.elements;
  d.properties.assign(static_cast<std::size_t>(mesh.element_count()), fabric());
  d.compression = compression;
  return d;
}

// Uniform numbers in [-1, 1), the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1.0; }
  Eigen::Vector3d vector() {
    const double x = (*this)(), y = (*this)();
    return {x, y, (*this)()};
  }
  Eigen::Matrix3Xd vectors(Eigen::Index count) {
    Eigen::Matrix3Xd m(3, count);
    for (Eigen::Index i = 0; i < count; ++i) m.col(i) = vector();
    return m;
  }

 private:
  std::mt19937_64 engine_;
};

inline Eigen::Matrix3Xd shaken(const Eigen::Matrix3Xd& nodes, double amplitude, std::uint64_t seed) {
  return nodes + amplitude * Random(seed).vectors(nodes.cols());
}

// State at x with surface and membrane forces computed.
inline membrane::BagState evaluated(const membrane::BagModel& model, const Eigen::Matrix3Xd& x,
                                    membrane::LoadKinds loads = {}) {
  auto state = membrane::make_state(model, x, loads);
  membrane::update_surface(model, state);
  if (loads.jet) membrane::update_geometry(model, state);
  membrane::membrane_forces(model, state);
  membrane::support_forces(model, state);
  return state;
}

inline Eigen::Matrix3d rotation() {
  return Eigen::AngleAxisd(2.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

}  // namespace scenes
