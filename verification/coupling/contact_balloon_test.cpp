// SPDX-License-Identifier: Apache-2.0
// An inflated elastic balloon pressed between two rigid spheres: work and force against the exact
// equilibrium, as mesh and contact stiffness are refined together and apart.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "claim.hpp"
#include "closed_form/coupled.hpp"
#include "coupling/sphere_contact.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"
#include "mesh/icosphere.hpp"

namespace {

using Eigen::Vector3d;

constexpr double kBalloon = 0.3, kPressure = 2e4, kAngle = 0.4;  // [m] [Pa] [rad]: a patch of 0.12 m

closed_form::PressedBalloon scene(double indenter) {
  return {{closed_form::paper_fabric(), kBalloon}, kPressure, indenter};
}

// Icosahedron with every side cut into n, pushed out to the sphere: finer steps than halving all sides.
// Turned, so that the axis meets no node.
mesh::Mesh geodesic_sphere(int n) {
  const mesh::Mesh base = mesh::icosphere(1.0, 0);
  using Place = std::array<std::pair<int, int>, 3>;  // corner and its weight, those of weight 0 as (-1, 0)
  std::map<Place, int> numbers;
  std::vector<Vector3d> nodes;
  const auto node = [&](const Eigen::Vector3i& face, int i, int j) {
    Place place{{{face[0], n - i - j}, {face[1], i}, {face[2], j}}};
    Vector3d x = Vector3d::Zero();
    for (const auto& [corner, weight] : place) x += weight * base.nodes.col(corner);
    for (auto& entry : place)
      if (entry.second == 0) entry = {-1, 0};
    std::sort(place.begin(), place.end());
    const auto [entry, fresh] = numbers.try_emplace(place, static_cast<int>(nodes.size()));
    if (fresh) nodes.push_back(x.normalized());
    return entry->second;
  };
  mesh::Mesh mesh;
  mesh.elements.resize(3, 20 * n * n);
  Eigen::Index e = 0;
  for (int f = 0; f < base.element_count(); ++f)
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const Eigen::Vector3i face = base.elements.col(f);
        mesh.elements.col(e++) << node(face, i, j), node(face, i + 1, j), node(face, i, j + 1);
        if (i + j < n - 1)
          mesh.elements.col(e++) << node(face, i + 1, j), node(face, i + 1, j + 1), node(face, i, j + 1);
      }
  mesh.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  const Eigen::AngleAxisd turn(0.7, Vector3d(1.0, 2.0, 3.0).normalized());
  for (std::size_t a = 0; a < nodes.size(); ++a)
    mesh.nodes.col(static_cast<Eigen::Index>(a)) = kBalloon * (turn * nodes[a]);
  return mesh;
}

// The balloon at rest, free first, then pressed.
class Press {
 public:
  Press(int n, double indenter, double share)
      : mesh_(geodesic_sphere(n)),
        model_(membrane::make_model(describe(mesh_))),
        contact_(mesh_.elements, mesh_.nodes, model_.node_mass, 1e3,
                 {coupling::Sphere{indenter},
                  coupling::default_contact_stiffness(
                      {share, model_.fabric_frequency, 0.31, coupling::Sphere{indenter}, 1e9})}),
        stretch_(closed_form::stretched_sphere(scene(indenter).sphere, kPressure).stretch),
        state_(membrane::make_state(model_, stretch_ * mesh_.nodes, {false, true})) {
    const auto exact = closed_form::pressed_balloon(scene(indenter), kAngle);
    const double touching = stretch_ * kBalloon + indenter;
    settle(0.02, [&](double) { return 2.0 * touching; });
    const double free = potential();
    // 0.025 s to get there and 16 decay times of the motion that this leaves.
    settle(0.07, [&](double t) { return std::max(exact.centre_height, touching - 4.0 * t); });
    work_ = potential() - free;
  }
  double work() const { return work_; }                                               // [J]
  double force() const { return 0.5 * (touch_[0].force.z() - touch_[1].force.z()); }  // [N] the mean of both

 private:
  static membrane::BagDescription describe(const mesh::Mesh& mesh) {
    membrane::BagDescription d;
    d.reference = mesh.nodes;
    d.elements = mesh.elements;
    d.properties.assign(static_cast<std::size_t>(mesh.element_count()), {0.5e-3, 620.0, 60e6, 0.3});
    d.mass_damping = 700.0;  // critical for the slow shape modes
    return d;
  }
  template <class Height>
  void settle(double duration, Height height) {
    double dt = 0.0;
    for (double time = 0.0; time < duration; time += dt) {
      membrane::update_skin(model_, state_);
      membrane::pressure_forces(state_, kPressure);
      state_.contact_force.map().setZero();
      for (const std::size_t side : {0u, 1u})
        touch_[side] = contact_.evaluate(caches_[side], state_.position.map(),
                                         {{0.0, 0.0, (side == 0 ? 1.0 : -1.0) * height(time)}},
                                         state_.contact_force.map());
      const double before = dt, stiffest = std::max(touch_[0].omega_squared(), touch_[1].omega_squared());
      dt = 0.9 *
           membrane::critical_time_step(membrane::stiffness_shares(model_, state_, 0.0, kPressure, stiffest));
      membrane::advance(model_, state_, before, dt);
    }
    membrane::update_skin(model_, state_);
  }
  double potential() const {
    return state_.forces.strain_energy + touch_[0].energy + touch_[1].energy -
           kPressure * state_.surface.volume;
  }

  mesh::Mesh mesh_;
  membrane::BagModel model_;
  coupling::ContactModel contact_;
  double stretch_;
  membrane::BagState state_;
  std::array<coupling::ContactState, 2> caches_{contact_.make_state(), contact_.make_state()};
  std::array<coupling::ContactResult, 2> touch_;
  double work_ = 0.0;
};

// Exact work [J] of both indenters from first touch.
double exact_work(double indenter) {
  const auto pressed = closed_form::pressed_balloon(scene(indenter), kAngle);
  const auto free = closed_form::stretched_sphere(scene(indenter).sphere, kPressure);
  return pressed.strain_energy - free.strain_energy - kPressure * (pressed.volume - free.volume);
}

// The default stiffness grows as 1/h^2 with the mesh, so depth and facets fade together, at order 2: under a
// plate, where the force is p times the patch, and in the dent of a sphere, where tension adds a quarter to
// it.
TEST(ContactBalloon, work_and_force_of_pressing_converge_at_order_2_to_the_stiff_limit) {
  for (const double indenter : {1e3 * kBalloon, 4.0 * kBalloon}) {
    const double work = exact_work(indenter);
    const bool plate = indenter > 100.0 * kBalloon;
    const double force = closed_form::pressed_balloon(scene(indenter), kAngle).force;
    const double n[] = {8.0, 12.0, 18.0};
    std::vector<double> error(3);
    for (int level = 0; level < 3; ++level) {
      const Press press(static_cast<int>(n[level]), indenter, 1.0);
      error[static_cast<std::size_t>(level)] = press.work() / work - 1.0;
      claim::expect_relative(
          {"K.18", std::string("balloon pressed by ") + (plate ? "plates" : "spheres") + ": force [N]",
           "the patch's edge between the points: (spacing / radius of the patch)^(5/2)"},
          press.force(), force, std::pow(1.05 / (n[level] * kAngle), 2.5));
    }
    claim::expect_order({"K.18",
                         std::string("balloon pressed by ") + (plate ? "plates" : "spheres") +
                             ", meshes 1.5 times finer: error of the work",
                         "shifts of the patch's edge leave 0.1 in the order of steps this small"},
                        error, 1.8, 2.2, 1.5);
    EXPECT_LT(std::abs(error[2]), 1e-2) << indenter;
  }
}

// On one mesh the depth that a finite stiffness allows, p/kappa, takes its part of the work at order 1, a
// little less for the patch's edge, which moves with it.
TEST(ContactBalloon, work_of_pressing_converges_at_order_1_in_the_contact_stiffness) {
  std::vector<double> change;
  double before = Press(12, kBalloon, 0.02).work();
  for (int level = 1; level < 4; ++level) {
    const double work = Press(12, kBalloon, 0.02 * (1 << level)).work();
    change.push_back(work - before);
    before = work;
  }
  claim::expect_order({"K.10", "balloon pressed by contact ever stiffer: change of the work [J]",
                       "depth p / kappa; the patch's edge moves with it"},
                      change, 0.9, 1.1);
}

}  // namespace
