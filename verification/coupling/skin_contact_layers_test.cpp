// SPDX-License-Identifier: Apache-2.0
// Layers of a skin at rest against closed forms: the gap under a pressure and under weight, two spheres, and
// limits that start below the thickness (K.44, K.45).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "claim.hpp"
#include "skin_scenes.hpp"

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

using scenes::kDensity;
using scenes::kSkinStiffness;
using scenes::kThickness;

// Where nodes come to rest that move along z under constant forces and contact. Nodes below `held` stay.
Matrix3Xd at_rest(const scenes::Skin& skin, const coupling::SkinContactModel& model, const Matrix3Xd& load,
                  Eigen::Index held, int steps) {
  auto state = model.make_state();
  Matrix3Xd nodes = skin.nodes, speed = Matrix3Xd::Zero(3, nodes.cols());
  const double dt = 1.0 / std::sqrt(model.full_omega_squared());
  for (int n = 0; n < steps; ++n) {
    const Matrix3Xd force = scenes::level_of(model, state, nodes).forces + load;
    for (Eigen::Index a = held; a < nodes.cols(); ++a)
      speed(2, a) = 0.5 * speed(2, a) + dt / skin.masses[static_cast<std::size_t>(a)] * force(2, a);
    nodes += dt * speed;
  }
  return nodes;
}

TEST(SkinContactLayers, gap_under_a_pressure_eq_thickness_minus_pressure_by_stiffness) {
  const scenes::Skin skin = scenes::two_plates(5, 5, 0.3, 1.1 * kThickness);
  const Eigen::Index half = skin.nodes.cols() / 2;
  const auto model = scenes::skin_contact(skin, kThickness, kSkinStiffness);
  for (const double pressure : {100.0, 500.0, 1900.0}) {
    Matrix3Xd load = Matrix3Xd::Zero(3, 2 * half);
    for (Eigen::Index a = 0; a < 2 * half; ++a)
      load(2, a) = (a < half ? 1.0 : -1.0) * pressure * skin.masses[static_cast<std::size_t>(a)] / kDensity;
    const Matrix3Xd nodes = at_rest(skin, model, load, 0, 300);
    for (Eigen::Index a = 0; a < half; ++a) {
      const double gap = nodes(2, half + a) - nodes(2, a);
      claim::expect_relative({"K.44", "two layers pressed together by a pressure: gap h - p / kappa [m]",
                              "rounding; 300 damped steps leave less"},
                             gap, kThickness - pressure / kSkinStiffness, 1e-11);
    }
  }
}

// Each layer carries those above it, and touches on both sides.
TEST(SkinContactLayers, gaps_of_a_stack_follow_from_the_weight_above) {
  constexpr int layers = 5, cells = 3;
  constexpr double weight = 3.0;  // [Pa] of a layer
  constexpr double stiffness = layers * weight / (0.18 * kThickness);
  scenes::Skin skin = scenes::plate(cells, 0.05);
  const Eigen::Index each = skin.nodes.cols();
  for (int k = 1; k <= layers; ++k) {
    scenes::Skin next = scenes::plate(cells, 0.05);
    next.nodes.row(2).setConstant(1.01 * k * kThickness);
    skin = scenes::joined(skin, next);
  }
  const auto model = scenes::skin_contact(skin, kThickness, stiffness);
  Matrix3Xd load = Matrix3Xd::Zero(3, skin.nodes.cols());
  for (Eigen::Index a = 0; a < load.cols(); ++a)
    load(2, a) = -weight * skin.masses[static_cast<std::size_t>(a)] / kDensity;
  const Matrix3Xd nodes = at_rest(skin, model, load, each, 1500);
  for (int k = 0; k < layers; ++k) {
    const Eigen::Index below = k * each, above = below + each;
    for (Eigen::Index a = 0; a < each; ++a)
      claim::expect_relative({"K.44", "stack of five layers on a sixth: gap h - weight above / kappa [m]",
                              "rounding; 1500 damped steps leave less"},
                             nodes(2, above + a) - nodes(2, below + a),
                             kThickness - (layers - k) * weight / stiffness, 1e-11);
  }
}

// Two caps of spheres, the upper one turned and shifted against the lower one.
struct Caps {
  static constexpr double edge = 0.01, radius = 855.0 * edge, thickness = 0.65 * edge;
  static constexpr double depth = 0.18 * thickness;  // less, and edges would touch
  scenes::Skin skin;

  explicit Caps(int cells) {
    const double patch = std::sqrt(depth * radius);  // of the lens
    scenes::Skin lower = scenes::plate(cells, 2.8 * patch / cells), upper = lower;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vector3d::UnitZ()).toRotationMatrix();
    upper.nodes = (turn * upper.nodes).colwise() + Vector3d(0.123, 0.217, 0.0) * 2.8 * patch / cells;
    for (scenes::Skin* cap : {&lower, &upper})
      for (auto x : cap->nodes.colwise()) {
        // Without the loss of digits of a difference of radii.
        const double r2 = x[0] * x[0] + x[1] * x[1];
        x[2] = (cap == &lower ? -1.0 : 1.0) * r2 / (radius + std::sqrt(radius * radius - r2));
      }
    skin = scenes::joined(lower, upper);
  }
};

struct Lens {
  double force = 0.0, energy = 0.0;  // [N] [J]
};

// (K.44) as an integral over the two spheres: d is the distance of a point of one to the other.
Lens exact_lens(double stiffness) {
  constexpr double r = Caps::radius, h = Caps::thickness, between = 2.0 * r + h - Caps::depth;
  Lens lens;
  const double end = 1.01 * std::sqrt(Caps::depth / r);
  const int steps = 200000;  // midpoints: the integrand of the force has a kink
  for (int i = 0; i < steps; ++i) {
    const double angle = (i + 0.5) / steps * end, half = std::sin(0.5 * angle);
    const double rise = 2.0 * r * half * half;  // of the point
    const double span = std::hypot(between - r + rise, r * std::sin(angle)), gap = span - r;
    if (!(gap < h)) continue;
    const double area = 2.0 * M_PI * r * r * std::sin(angle) * end / steps;
    lens.energy += area * stiffness * (h - gap) * (h - gap) / 2.0;
    lens.force += area * stiffness * (h - gap) * (between - r + rise) / span;
  }
  return lens;
}

TEST(SkinContactLayers, two_spheres_converge_at_order_2_to_the_integral_over_their_lens) {
  const Lens exact = exact_lens(kSkinStiffness);
  std::vector<double> energy_error, force_error;
  for (const int cells : {7, 14, 28}) {
    const Caps caps(cells);
    const auto model = scenes::skin_contact(caps.skin, Caps::thickness, kSkinStiffness);
    auto state = model.make_state();
    const Eigen::Index half = caps.skin.nodes.cols() / 2;
    Matrix3Xd nodes = caps.skin.nodes;
    nodes.rightCols(half).row(2).array() += 2.0 * Caps::thickness;
    scenes::level_of(model, state, nodes);
    nodes.rightCols(half).row(2).array() -= Caps::thickness + Caps::depth;
    const auto level = scenes::level_of(model, state, nodes);
    energy_error.push_back(level.result.energy / exact.energy - 1.0);
    force_error.push_back(level.forces.rightCols(half).row(2).sum() / exact.force - 1.0);
  }
  claim::expect_order({"K.44", "two spheres in touch: relative error of the energy",
                       "facets, and sums for integrals of what is smooth but at the lens's edge"},
                      energy_error, 1.8, 2.2);
  claim::expect_order({"K.44", "two spheres in touch: relative error of the force",
                       "the same; the force has a kink at the edge"},
                      force_error, 1.7, 2.3);
}

// A layer over a larger one at rest, both flat; the upper one goes where it is told, tilted at will.
class Tilting {
 public:
  Tilting() { go(0.6, 0.0); }
  /// To that gap of the middle [h] and that slope; returns the work of the motion by the mean force.
  double go(double gap, double slope) {
    Matrix3Xd nodes = skin_.nodes;
    auto upper = nodes.rightCols(36);
    upper.row(2) = (gap * kThickness + (slope * upper.row(0)).array()).matrix();
    const auto level = scenes::level_of(model_, state_, nodes);
    double work = 0.0;
    if (nodes_.cols() > 0) work = -0.5 * ((level.forces + forces_).array() * (nodes - nodes_).array()).sum();
    nodes_ = nodes;
    forces_ = level.forces;
    energy_ = level.result.energy;
    return work;
  }
  double energy() const { return energy_; }

 private:
  scenes::Skin skin_ = scenes::two_plates(7, 5, 0.3, 0.6 * kThickness);
  coupling::SkinContactModel model_ = scenes::skin_contact(skin_, kThickness, kSkinStiffness);
  coupling::SkinContactState state_ = model_.make_state();
  Matrix3Xd nodes_, forces_;
  double energy_ = 0.0;
};

// Starts at 0.6 h. Limits rise as layers part and tilt, and hold as they close.
TEST(SkinContactLayers, work_while_limits_rise_is_the_change_of_energy_at_order_2) {
  std::vector<double> error;
  for (const int steps : {100, 200, 400, 800}) {
    Tilting layer;
    double work = 0.0;
    for (int n = 1; n <= steps; ++n) {
      const double t = 2.0 * M_PI * n / steps;
      work += layer.go(0.6 + 0.04 * std::sin(3.0 * t) + 0.08 * (1.0 - std::cos(t)) - 0.03 * std::sin(t),
                       1e-3 * std::sin(2.0 * t));
    }
    error.push_back((work - layer.energy()) / (kSkinStiffness * kThickness * kThickness * 0.09));
  }
  EXPECT_LT(std::abs(error.back()), 1e-5);
  claim::expect_order(
      {"K.45", "layer that moves while its limits rise: work minus energy, in units of kappa A h2",
       "the mean of two forces; kinks where a node touches"},
      error, 1.5, 2.5);
}

TEST(SkinContactLayers, work_around_a_closed_path_below_the_limits_is_zero) {
  Tilting layer;
  double work = 0.0, largest = 0.0;
  // A linear law and straight legs between its kinks: the mean force is exact.
  for (const double gap : {0.55, 0.58, 0.52, 0.56, 0.51, 0.6}) {
    work += layer.go(gap, 0.0);
    largest = std::max(largest, layer.energy());
  }
  EXPECT_GT(largest, 0.0);
  claim::expect_near({"K.45",
                      "layers that start at 0.6 h and stay below it: work around a closed path, "
                      "of the largest energy",
                      "rounding"},
                     work / largest, 0.0, 1e-11);
  EXPECT_NEAR(layer.energy(), 0.0, 1e-25);
}

}  // namespace
