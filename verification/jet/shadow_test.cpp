// SPDX-License-Identifier: Apache-2.0
// Shadows of discs and spheres (J.7) against closed forms. An element is lit or dark as a whole, so the
// shadow's area is a count of centroids: for a smooth outline in general position its error is that of
// lattice points in an oval, of order 3/2 in the mesh size in the mean square (D. G. Kendall, On the number
// of lattice points inside a random oval, 1948). Each order below is fitted through root mean squares over
// random positions; those of N samples scatter by 1/sqrt(2 N), and the slope through four of them, each half
// the one before, by 0.65/sqrt(N).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "closed_form/occlusion.hpp"
#include "jet/field.hpp"
#include "models.hpp"
#include "plates.hpp"
#include "routes.hpp"
#include "scenes.hpp"

namespace {

using std::numbers::pi;
constexpr int kSamples = 60;        // scatter of an order: 0.084
constexpr double kOrderBand = 0.3;  // 3.5 times that
const char* const kWhy =
    "order of lattice points in an oval, fitted; 60 random places a level scatter it by 0.084";

const Eigen::Vector3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

/// Both surfaces as one.
plates::Target joined(const plates::Target& a, const plates::Target& b) {
  Eigen::Matrix3Xd nodes(3, a.nodes.cols() + b.nodes.cols());
  nodes << a.nodes, b.nodes;
  Eigen::Matrix3Xi triangles(3, a.count() + b.count());
  triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.nodes.cols())).matrix();
  return plates::finish(std::move(nodes), std::move(triangles));
}

/// Disc of the given area: a polygon of 96 sides, so small against the elements behind it that it counts as
/// round.
plates::Target occluder(const Eigen::Vector3d& centre, double radius) {
  const double sides = 96.0;
  const double equal_area = std::sqrt(2.0 * pi / (sides * std::sin(2.0 * pi / sides)));
  return plates::disc(centre, kX, kY, radius * equal_area, 16);
}

/// Which of the first `count` elements are lit from the origin.
std::vector<std::uint8_t> lit_of_first(const plates::Target& scene, int count) {
  std::vector<int> candidates(static_cast<std::size_t>(count));
  for (std::size_t e = 0; e < candidates.size(); ++e) candidates[e] = static_cast<int>(e);
  std::vector<std::uint8_t> lit(candidates.size());
  jet::VisibilityQuery query(scene.triangles, static_cast<int>(scene.nodes.cols()));
  jet::RaySource source;
  source.axis = kZ;
  query.query(jet::VisibilityRoute::fast, scene.nodes, source, candidates, lit);
  return lit;
}

/// Slope of log2(error) over equal halvings of the mesh size, least squares.
double fitted_order(const std::vector<double>& errors) {
  double sum = 0.0, squares = 0.0;
  const double middle = 0.5 * (static_cast<double>(errors.size()) - 1.0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = static_cast<double>(i) - middle;
    sum -= x * std::log2(errors[i]);
    squares += x * x;
  }
  return sum / squares;
}

/// Root mean square of sample(random) over kSamples.
template <class Sample>
double root_mean_square(std::uint64_t seed, Sample sample) {
  scenes::Random random(seed);
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i) sum += std::pow(sample(random), 2);
  return std::sqrt(sum / kSamples);
}

/// n x n cells of side h at distance 2 along z, the grid's position random within a cell.
plates::Target wall(double h, int n, scenes::Random& random) {
  const Eigen::Vector3d shift(random.uniform(-0.5, 0.5) * h, random.uniform(-0.5, 0.5) * h, 0.0);
  return plates::plate(2.0 * kZ + shift, h * kX, h * kY, n, n);
}

TEST(shadow, disc_on_a_wall_eq_scaled_disc) {
  const double exact = pi * 0.6 * 0.6;  // radius 0.3 at half the distance
  std::vector<double> errors;
  for (const int n : {10, 20, 40, 80})
    errors.push_back(root_mean_square(11, [&](scenes::Random& random) {
      const plates::Target target = wall(2.0 / n, n, random);
      const auto lit = lit_of_first(joined(target, occluder(kZ, 0.3)), target.count());
      const auto dark = static_cast<double>(std::count(lit.begin(), lit.end(), 0));
      return dark * target.area_vectors.col(0).norm() / exact - 1.0;
    }));
  claim::expect_near({"J.7", "shadow of a disc on a wall: order of its area [-]", kWhy}, fitted_order(errors),
                     1.5, kOrderBand);
  EXPECT_LT(errors.back(), 5e-3);
}

TEST(shadow, disc_off_the_axis_hides_a_lens_of_a_disc) {
  const double offset = 0.25;  // of the occluder; its shadow of radius 0.7 is off by twice that
  const double exact = closed_form::hidden_disc_fraction(0.35, 1.0, 0.8, 2.0, offset);
  std::vector<double> errors;
  for (const int rings : {6, 12, 24, 48})
    errors.push_back(root_mean_square(12, [&](scenes::Random& random) {
      const double angle = random.uniform(0.0, 2.0 * pi);
      const plates::Target target = plates::disc(2.0 * kZ, kX, kY, 0.8, rings);
      const Eigen::Vector3d place = kZ + offset * (std::cos(angle) * kX + std::sin(angle) * kY);
      const auto lit = lit_of_first(joined(target, occluder(place, 0.35)), target.count());
      double dark = 0.0;
      for (int e = 0; e < target.count(); ++e)
        if (lit[static_cast<std::size_t>(e)] == 0) dark += target.area_vectors.col(e).norm();
      return dark / target.area_vectors.colwise().norm().sum() / exact - 1.0;
    }));
  claim::expect_near({"J.7", "lens that a disc off the axis hides of another: order of its area [-]", kWhy},
                     fitted_order(errors), 1.5, kOrderBand);
  EXPECT_LT(errors.back(), 5e-3);
}

TEST(shadow, jet_force_behind_a_disc_eq_what_passes_it) {
  jet::JetModel model;
  model.centre.setZero();
  model.axis = kZ;
  model.radius = 0.1;
  model.decay_coefficient = 0.08;
  model.cut_off = 0.0;
  const double width = jet::section(model, 2.0).width;
  // The shadow has radius R/2: rays are straight from the outlet's centre, wherever the jet spreads to.
  const double passes = 1.0 - closed_form::disc_fraction(0.5 * width, width);
  const jet::OutletState outlet{400.0, 1.0, 1e5, 300.0};
  const double exact = 2.0 * jet::momentum_flux(outlet, jet::outlet_area(model)) * passes;
  std::vector<double> errors;
  for (const int n : {12, 24, 48, 96})
    errors.push_back(root_mean_square(13, [&](scenes::Random& random) {
      const plates::Target target = wall(6.0 * width / n, n, random);
      const plates::Target scene = joined(target, occluder(kZ, 0.25 * width));
      const jet::JetField field(model, target.count());
      jet::FieldState state = field.make_state();
      field.evaluate(target.area_vectors, target.centroids, outlet, state);
      const auto lit = lit_of_first(scene, target.count());
      EXPECT_EQ(state.candidates.size(), lit.size());
      jet::apply_mask(lit, state);
      return jet::jet_force(state, target.area_vectors).z() / exact - 1.0;
    }));
  claim::expect_near({"J.7", "jet force on a wall behind a disc: order [-]", kWhy}, fitted_order(errors), 1.5,
                     kOrderBand);
  EXPECT_LT(errors.back(), 5e-3);
}

TEST(shadow, sphere_hides_its_solid_angle) {
  const double distance = 1.3, exact = closed_form::sphere_solid_angle(0.7, distance);
  std::vector<double> errors;
  for (const int level : {1, 2, 3, 4})
    errors.push_back(root_mean_square(14, [&](scenes::Random& random) {
      scenes::Mesh mesh = scenes::shell_with_body(level);
      scenes::append(mesh, {});
      Eigen::Vector3d place = random.vector(1.0);
      while (place.norm() > 1.0 || place.norm() < 0.1) place = random.vector(1.0);
      place *= distance / place.norm();
      for (auto& node : mesh.nodes) node -= place;  // the source is the origin
      const plates::Target scene = plates::finish(mesh.points(), mesh.triangles());
      const int shell = scene.count() / 2;
      const auto lit = lit_of_first(scene, shell);
      double dark = 0.0;
      for (std::size_t e = 0; e < lit.size(); ++e) {
        const auto at = [&](int i) -> closed_form::Point3 {
          const Eigen::Vector3d& p = mesh.corner(e, i);
          return {p[0], p[1], p[2]};
        };
        if (lit[e] == 0) dark += closed_form::triangle_solid_angle(at(0), at(1), at(2));
      }
      return dark / exact - 1.0;
    }));
  // The inscribed body is too small by O(h^2), more than the count at coarse meshes: between 3/2 and 2.
  const double order = fitted_order(errors);
  EXPECT_GT(order, 1.5 - kOrderBand);
  EXPECT_LT(order, 2.0 + kOrderBand);
  EXPECT_LT(errors.back(), 3e-2);
}

/// Icosahedron with a vertex on the z axis, faces looking outward inverted, so that a source outside sees
/// them.
scenes::Mesh inverted_icosahedron() {
  scenes::Mesh mesh;
  mesh.nodes.push_back(kZ);
  mesh.nodes.push_back(-kZ);
  const double height = 1.0 / std::sqrt(5.0), radius = 2.0 * height;
  for (int i = 0; i < 10; ++i) {
    const double angle = pi * i / 5.0;
    mesh.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                            i % 2 == 0 ? height : -height);
  }
  for (int i = 0; i < 10; ++i) {  // upper ring even, lower ring odd
    const int a = 2 + i, b = 2 + (i + 1) % 10, c = 2 + (i + 2) % 10;
    if (i % 2 == 0) mesh.elements.push_back({a, b, c}), mesh.elements.push_back({0, c, a});
    if (i % 2 == 1) mesh.elements.push_back({a, c, b}), mesh.elements.push_back({1, a, c});
  }
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {  // wind every face inward
    const Eigen::Vector3d normal =
        (mesh.corner(e, 1) - mesh.corner(e, 0)).cross(mesh.corner(e, 2) - mesh.corner(e, 0));
    if (normal.dot(mesh.centroid(e)) > 0.0) std::swap(mesh.elements[e][1], mesh.elements[e][2]);
  }
  return mesh;
}

TEST(shadow, icosahedron_shows_the_faces_of_the_closed_form) {
  const scenes::Mesh mesh = inverted_icosahedron();
  ASSERT_EQ(mesh.elements.size(), 20u);
  for (const double ratio : {1.01, 2.0, 4.2, 4.3, 100.0}) {
    const auto lit = jet::visible(mesh.points(), mesh.triangles(), routes::point({0, 0, ratio}, {0, 0, -1}));
    EXPECT_EQ(std::count(lit.begin(), lit.end(), 1), closed_form::icosahedron_visible_faces(ratio)) << ratio;
  }
}

}  // namespace
