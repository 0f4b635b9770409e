// SPDX-License-Identifier: Apache-2.0
// Bags at rest under constant overpressure, against closed forms: cylinder, clamped disc, two discs sewn
// together.
#include <gtest/gtest.h>

#include <numbers>

#include "closed_form/disc.hpp"
#include "orders.hpp"
#include "statics.hpp"

using membrane::Compression;
using std::numbers::pi;

namespace {

// Long cylinder of radius 0.15 m under 20 kPa.
constexpr double kTubeRadius = 0.15, kTubePressure = 2e4;

struct Tube {
  membrane::Mesh mesh;
  int around, along;
  std::vector<int> ring(int j) const {
    std::vector<int> nodes;
    for (int i = 0; i < around; ++i) nodes.push_back(i + j * around);
    return nodes;
  }
};

Tube tube(int around) {
  const int along = around / 2;
  const auto place = [](double turn, double height) {
    const double angle = 2.0 * pi * turn;
    return Eigen::Vector3d(kTubeRadius * std::cos(angle), kTubeRadius * std::sin(angle), 0.5 * height);
  };
  return {scenes::wrapped_grid(around, along, place), around, along};
}

// End walls that stay plane: they pull the end rings by the pressure on them, and share out the axial force
// evenly.
void push_end_walls(const Tube& tube, membrane::BagState& state) {
  for (const int j : {0, tube.along}) {
    const std::vector<int> ring = tube.ring(j);
    double area = 0.0, axial = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d a = state.position.map().col(ring[i]),
                            b = state.position.map().col(ring[(i + 1) % ring.size()]);
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      axial += state.membrane_force.map()(2, ring[i]);
    }
    for (const int n : ring) {
      state.membrane_force.map()(2, n) = axial / tube.around;
      state.volume_gradient.map()(2, n) = (j == 0 ? -1.0 : 1.0) * area / tube.around;
    }
  }
}

struct TubeStretch {
  double hoop, axial;
};
// Half way along the tube.
TubeStretch stretch_tube(int around, bool closed) {
  const Tube t = tube(around);
  const auto model = make_model(scenes::describe(t.mesh, Compression::none));
  auto state = membrane::make_state(model, 1.05 * t.mesh.nodes);
  if (!closed) state.position.map().row(2) = t.mesh.nodes.row(2);
  std::vector<int> ends = t.ring(0);
  for (const int n : t.ring(t.along)) ends.push_back(n);
  const double tolerance = 1e-9 * kTubePressure * kTubeRadius * kTubeRadius;
  const auto walls = [&](membrane::BagState& s) { push_end_walls(t, s); };
  scenes::relax(model, state, kTubePressure, tolerance,
                closed ? scenes::Support(walls) : scenes::sliding({{2, ends}}));
  const auto at = [&](int j) { return Eigen::Vector3d(state.position.map().col(j * t.around)); };
  const int middle = t.along / 2;
  return {at(middle).head<2>().norm() / kTubeRadius,
          (at(middle + 1)[2] - at(middle - 1)[2]) / (2.0 * 0.5 / t.along)};
}

// A flat disc of fabric of radius 0.3 m under the overpressure q E h / a, edge clamped or sewn to its mirror
// image.
struct Disc {
  double q;
  bool sealed;
  static constexpr double kRadius = 0.3;
  double pressure() const { return q * 60e6 * 0.5e-3 / kRadius; }
  closed_form::CircularMembrane exact() const { return {closed_form::paper_fabric(), kRadius, pressure()}; }
};

struct DiscShape {
  double volume, centre_height;
  Eigen::Matrix3Xd nodes;
};
DiscShape inflate(const Disc& disc, int rings, double relative_tolerance) {
  const double a = Disc::kRadius;
  const auto mesh = scenes::disc(a, rings);
  std::vector<int> edge;
  for (int n = mesh.node_count() - 6 * rings; n < mesh.node_count(); ++n) edge.push_back(n);
  auto d = scenes::describe(mesh, Compression::none);
  if (!disc.sealed) d.fixed_nodes = edge;
  const auto model = make_model(d);
  Eigen::Matrix3Xd x = (disc.sealed ? 0.8 : 1.0) * mesh.nodes;
  x.row(2) = (disc.sealed ? 0.5 : 0.1) * (a - mesh.nodes.colwise().squaredNorm().array() / a);
  auto state = membrane::make_state(model, x);
  const double tolerance = relative_tolerance * disc.pressure() * a * a / (rings * rings);
  const auto rest = scenes::relax(model, state, disc.pressure(), tolerance, scenes::sliding({{2, edge}}));
  return {rest.volume, state.position.map()(2, 0), state.position.map()};
}

}  // namespace

// The polygon of n sides has the apothem cos(pi / n), order 2.
TEST(Inflated, tube_stretch_converges_with_order_2) {
  const closed_form::StretchedCylinder cylinder{closed_form::paper_fabric(), kTubeRadius};
  for (const bool closed : {false, true}) {
    const auto exact = closed ? closed_form::closed_cylinder(cylinder, kTubePressure)
                              : closed_form::fixed_length_cylinder(cylinder, kTubePressure);
    std::vector<double> hoop, axial;
    for (const int around : {12, 24, 48}) {
      const TubeStretch s = stretch_tube(around, closed);
      hoop.push_back(s.hoop - exact.hoop_stretch);
      axial.push_back(s.axial - exact.axial_stretch);
    }
    scenes::expect_order(closed ? "closed_tube_hoop" : "fixed_tube_hoop", hoop, 1.95, 2.05);
    if (closed) scenes::expect_order("closed_tube_axial", axial, 1.95, 2.05);
    if (!closed) {
      EXPECT_NEAR(axial.back(), 0.0, 1e-9);  // held at the ends; what relaxation leaves
    }
  }
}

TEST(Inflated, clamped_disc_converges_to_follower_pressure_solution_with_order_2) {
  const Disc disc{0.01, false};
  const auto exact = closed_form::clamped_disc(disc.exact());
  std::vector<double> volume, height;
  for (const int rings : {4, 8, 16}) {
    const DiscShape shape = inflate(disc, rings, 1e-6);
    volume.push_back(shape.volume / exact.volume - 1.0);
    height.push_back(shape.centre_height / exact.centre_deflection - 1.0);
  }
  scenes::expect_order("clamped_disc_volume", volume, 1.9, 2.1);
  scenes::expect_order("clamped_disc_height", height, 1.7, 2.1);  // at a point: h^2 log h
}

TEST(Inflated, sealed_discs_converge_to_elastic_balloon) {
  const Disc disc{0.01, true};
  const auto exact = closed_form::sealed_disc(disc.exact());
  std::vector<double> volume;
  for (const int rings : {4, 8, 16}) volume.push_back(inflate(disc, rings, 1e-3).volume / exact.volume - 1.0);
  // The seam wrinkles over single elements and the tension is greatest at the pole: below 2 on the way there.
  scenes::expect_order("sealed_discs_volume", volume, 1.6, 2.1);
}

TEST(Inflated, nearly_inextensible_discs_have_the_mylar_shape) {
  const Disc disc{1e-3, true};
  const int rings = 8;
  const DiscShape shape = inflate(disc, rings, 1e-3);
  const auto mylar = closed_form::mylar_balloon(Disc::kRadius);
  // Sides of an eighth of the radius cut chords of (a / 8)^2 / 8 over curvatures of 2 / a: 0.004 a; the
  // elastic strain is 0.001. The seam's scallops stand out by 0.03 a, their mean does not.
  for (int k = 1; k <= rings; ++k) {
    const auto ring = shape.nodes.middleCols(3 * k * (k - 1) + 1, 6 * k);
    const double r = ring.topRows<2>().colwise().norm().mean(), z = ring.row(2).mean();
    const double profile = closed_form::mylar_profile(Disc::kRadius, std::min(r, mylar.equator_radius));
    EXPECT_NEAR(z, profile, 0.004 * Disc::kRadius) << k;
    if (k == rings) {
      EXPECT_NEAR(r, mylar.equator_radius, 0.004 * Disc::kRadius);
    }
  }
  EXPECT_NEAR(2.0 * shape.centre_height, mylar.thickness, 0.008 * Disc::kRadius);
  EXPECT_NEAR(2.0 * shape.volume, mylar.volume, 0.02 * mylar.volume);  // inscribed: twice the seam's chords
}
