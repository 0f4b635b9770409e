// SPDX-License-Identifier: Apache-2.0
// Bags at rest under constant overpressure, against closed forms: cylinder, clamped disc, two discs sewn
// together.
#include <gtest/gtest.h>

#include <numbers>

#include "claim.hpp"
#include "inflated_disc.hpp"

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
    const char* why = "the apothem of the polygon, whose next term is (pi / n)^2 / 12 of the first";
    claim::expect_order(
        {"M.2", closed ? "closed tube: hoop stretch" : "tube of fixed length: hoop stretch", why}, hoop, 1.95,
        2.05);
    if (closed) claim::expect_order({"M.2", "closed tube: axial stretch", why}, axial, 1.95, 2.05);
    if (!closed)
      claim::expect_near(
          {"M.2", "tube of fixed length: axial stretch, deviation from 1", "what relaxation leaves"},
          axial.back(), 0.0, 1e-9);
  }
}

TEST(Inflated, clamped_disc_converges_to_follower_pressure_solution_with_order_2) {
  const scenes::Disc disc{0.01, false};
  const auto exact = closed_form::clamped_disc(disc.exact());
  std::vector<double> volume, height;
  for (const int rings : {4, 8, 16}) {
    const scenes::DiscShape shape = scenes::inflate(disc, rings, 1e-6);
    volume.push_back(shape.volume / exact.volume - 1.0);
    height.push_back(shape.centre_height / exact.centre_deflection - 1.0);
  }
  claim::expect_order(
      {"M.6", "clamped disc under follower pressure: volume", "the first mesh has 96 elements"}, volume, 1.9,
      2.1);
  claim::expect_order(
      {"M.6", "clamped disc under follower pressure: height of the centre", "at a point: h^2 log h"}, height,
      1.7, 2.1);
}

TEST(Inflated, sealed_discs_converge_to_elastic_balloon) {
  const scenes::Disc disc{0.01, true};
  const auto exact = closed_form::sealed_disc(disc.exact());
  std::vector<double> volume;
  for (const int rings : {4, 8, 16})
    volume.push_back(scenes::inflate(disc, rings, 1e-3).volume / exact.volume - 1.0);
  claim::expect_order({"M.3", "two discs sewn together, without compression: volume",
                       "the seam wrinkles over single elements and tension peaks at the pole: below 2"},
                      volume, 1.6, 2.1);
}

// On the whole disc the seam wrinkles ever finer and draws in (by 1 % at 32 rings), so the axisymmetric shape
// is that of a sector. The elastic balloon is 0.2 % from the inextensible one.
TEST(Inflated, sector_of_nearly_inextensible_discs_converges_to_the_mylar_balloon_with_order_2) {
  const scenes::Disc disc{1e-3, true};
  const double a = scenes::Disc::kRadius;
  const auto exact = closed_form::sealed_disc(disc.exact());
  std::vector<double> volume;
  for (const int rings : {8, 16, 32}) {
    const auto shape = scenes::inflate_sector(disc, rings, 3 * rings / 2, 1e-3);
    volume.push_back(shape.volume / exact.volume - 1.0);
    if (rings < 32) continue;
    const auto mylar = closed_form::mylar_balloon(a);
    const char* why = "the elastic balloon, thicker by 0.005 a, and chords 5e-4 a off";
    claim::expect_relative({"M.3", "nearly inextensible sewn discs, the mylar balloon: volume [m3]", why},
                           2.0 * shape.volume, mylar.volume, 0.01);
    claim::expect_near({"M.3", "nearly inextensible sewn discs, the mylar balloon: equator radius [m]", why},
                       shape.nodes.col(2 * rings).norm(), mylar.equator_radius, 0.006 * a);
    for (Eigen::Index n = 0; n < shape.nodes.cols(); ++n) {
      const double r = shape.nodes.col(n).head<2>().norm();
      if (r > 0.9 * mylar.equator_radius) break;  // the profile turns vertical
      claim::expect_near({"M.3", "nearly inextensible sewn discs, the mylar balloon: heights [m]", why},
                         shape.nodes(2, n), closed_form::mylar_profile(a, r), 0.006 * a);
    }
  }
  claim::expect_order(
      {"M.3", "sector of sewn discs, nearly inextensible: volume", "tension peaks at the pole"}, volume, 1.85,
      2.1);
}
