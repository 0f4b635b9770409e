// SPDX-License-Identifier: Apache-2.0
// Elements cut into pieces (J.8): geometry of the pieces, averages of the field, shadows within an element.
#include "jet/subdivision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "claim.hpp"
#include "closed_form/occlusion.hpp"
#include "jet/centreline.hpp"
#include "models.hpp"
#include "plates.hpp"
#include "rounding.hpp"
#include "scenes.hpp"

namespace {

using models::kAcross;
using models::kOutlet;
using support::kEps;

/// A target whose elements are cut into n^2 pieces.
struct Cut {
  jet::Subdivision subdivision;
  Eigen::Matrix3Xd nodes, area_vectors, centroids;

  Cut(const plates::Target& target, int n)
      : subdivision(target.triangles, static_cast<int>(target.nodes.cols()), n),
        nodes(3, subdivision.node_count()),
        area_vectors(3, subdivision.triangles().cols()),
        centroids(3, subdivision.triangles().cols()) {
    subdivision.interpolate(target.nodes, nodes);
    subdivision.share_areas(target.area_vectors, area_vectors);
    jet::corner_means(nodes, subdivision.triangles(), centroids);
  }
};

/// Field of the target's elements, averaged over n^2 pieces, without shadows.
jet::FieldState averaged(const jet::JetModel& model, const plates::Target& target, int n) {
  const Cut cut(target, n);
  const jet::JetField fine(model, static_cast<int>(cut.centroids.cols())), coarse(model, target.count());
  jet::FieldState pieces = fine.make_state(), elements = coarse.make_state();
  fine.evaluate(cut.area_vectors, cut.centroids, kOutlet, pieces);
  pieces.restitution = 0.5;  // the loads are known by now
  cut.subdivision.average(pieces, elements);
  EXPECT_EQ(elements.restitution, 0.5);
  return elements;
}

TEST(subdivision, pieces_of_a_closed_bag_close_and_share_their_elements_area) {
  const scenes::Mesh sphere = scenes::sphere(2, 0.3);
  const plates::Target target = plates::finish(sphere.points(), sphere.triangles());
  for (const int n : {1, 2, 3, 5}) {
    const Cut cut(target, n);
    jet::VisibilityQuery query(cut.subdivision.triangles(), cut.subdivision.node_count());
    EXPECT_TRUE(query.closed());
    // Euler: an edge has n - 1 inner nodes, an element (n - 1)(n - 2)/2.
    const int inner = 3 * target.count() / 2 * (n - 1) + target.count() * (n - 1) * (n - 2) / 2;
    EXPECT_EQ(cut.subdivision.node_count(), target.nodes.cols() + inner);
    EXPECT_EQ(cut.nodes.leftCols(target.nodes.cols()), target.nodes);
    const plates::Target pieces = plates::finish(cut.nodes, cut.subdivision.triangles());
    // Two products of coordinates of 0.3 m, known to a few roundings.
    EXPECT_LT((pieces.area_vectors - cut.area_vectors).cwiseAbs().maxCoeff(), 32 * kEps * 0.3 * 0.3);
  }
}

TEST(subdivision, means_of_corners_that_do_not_exist_are_refused) {
  const Eigen::Matrix3Xd values = Eigen::Matrix3Xd::Ones(3, 4);
  Eigen::Matrix3Xd means(3, 1);
  for (const int wrong : {-1, 4}) {
    const Eigen::Matrix3Xi triangle = Eigen::Vector3i(0, 1, wrong);
    EXPECT_THROW(jet::corner_means(values, triangle, means), std::invalid_argument);
  }
  jet::corner_means(values, Eigen::Matrix3Xi(Eigen::Vector3i(0, 1, 3)), means);
  EXPECT_EQ(means.sum(), 3.0);
}

TEST(subdivision, average_eq_field_of_the_refined_mesh) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  const double z = 0.4, width = jet::section(model, z).width;
  const Eigen::Vector3d slope = kAcross + std::tan(0.3) * models::kAxis;
  const auto tilted = [&](double h, int cells) {
    return plates::plate(models::kCentre + z * models::kAxis, h * models::kLong, h * slope, cells, cells);
  };
  const plates::Target coarse = tilted(width, 8), fine = tilted(width / 4, 32);
  const jet::FieldState refined = averaged(model, fine, 1);
  const double force = jet::jet_force(refined, fine.area_vectors).norm();
  claim::expect_relative({"J.8", "16 pieces an element against the mesh refined to them: force [N]",
                          "2048 positive terms with exp each"},
                         jet::jet_force(averaged(model, coarse, 4), coarse.area_vectors).norm(), force,
                         1e-12);
  EXPECT_GT(std::abs(jet::jet_force(averaged(model, coarse, 1), coarse.area_vectors).norm() - force),
            1e-3 * force)
      << "the average must make a difference";
}

TEST(subdivision, average_converges_with_second_order) {
  jet::JetModel model = models::round(0.02, 0.08);
  model.cut_off = 0.0;
  const double z = 0.4, width = jet::section(model, z).width;
  const plates::Target disc =
      plates::disc(models::kCentre + z * models::kAxis, models::kLong, kAcross, width, 2);
  std::vector<double> forces;
  for (const int n : {4, 8, 16, 32})
    forces.push_back(jet::jet_force(averaged(model, disc, n), disc.area_vectors).norm());
  std::vector<double> changes;
  for (std::size_t i = 1; i < forces.size(); ++i) changes.push_back(forces[i] - forces[i - 1]);
  claim::expect_order({"J.8", "disc of 24 elements by pieces, 4^2 to 32^2: change of the force [N]",
                       "midpoint rule; the next term h^4 is 4 % of it at n = 8"},
                      changes, 1.9, 2.1);
}

TEST(subdivision, one_piece_is_the_element_bit_for_bit) {
  const scenes::Mesh mesh = scenes::sphere(3, 0.3);
  const plates::Target bag =
      plates::finish(mesh.points().colwise() + (models::kCentre + 0.1 * models::kAxis), mesh.triangles());
  const jet::JetModel model = models::round(0.02, 0.08);
  const jet::JetField field(model, bag.count());
  jet::FieldState direct = field.make_state();
  field.evaluate(bag.area_vectors, bag.centroids, kOutlet, direct);
  const jet::FieldState piece = averaged(model, bag, 1);
  ASSERT_GT(direct.candidates.size(), 10u);
  EXPECT_EQ(direct.candidates, piece.candidates);
  EXPECT_EQ(direct.overpressure, piece.overpressure);
}

/// Share of the pieces of the closed forms' target triangle that the occluder hides, and of its load.
TEST(subdivision, shadow_within_an_element_eq_clipped_shadow) {
  const closed_form::Triangle2 target = {{{0, 0}, {2, 0}, {0, 2}}};
  const closed_form::Triangle2 occluders[] = {{{{0, 0}, {0.5, 0}, {0, 0.5}}},
                                              {{{0.25, 0.25}, {1, 0.25}, {0.25, 1}}}};
  for (const auto& occluder : occluders) {
    scenes::Mesh mesh;
    for (const auto& p : target) mesh.nodes.emplace_back(p[0], p[1], 2.0);
    for (const auto& p : occluder) mesh.nodes.emplace_back(p[0], p[1], 1.0);
    mesh.elements = {{0, 1, 2}, {3, 4, 5}};
    const Cut cut(plates::finish(mesh.points(), mesh.triangles()), 24);  // the shadow ends at pieces' edges
    jet::FieldState pieces{std::vector<double>(2 * 576, 0.0), cut.subdivision.pieces_of(std::vector<int>{0})};
    for (const int piece : pieces.candidates) pieces.overpressure[static_cast<std::size_t>(piece)] = 5.0;
    std::vector<std::uint8_t> lit(576);
    jet::VisibilityQuery query(cut.subdivision.triangles(), cut.subdivision.node_count());
    query.query(jet::VisibilityRoute::fast, cut.nodes, {}, pieces.candidates, lit);
    jet::apply_mask(lit, pieces);
    jet::FieldState elements{std::vector<double>(2, 7.0), {}};
    elements.candidates = {0, 1};  // of the query before: reset by the average
    pieces.restitution = 0.5;      // the loads are known by now
    cut.subdivision.average(pieces, elements);
    EXPECT_EQ(elements.restitution, 0.5);
    const double hidden = closed_form::hidden_triangle_fraction(occluder, 1.0, target, 2.0);
    claim::expect_near(
        {"J.8", "clipped shadow within an element: mean overpressure [Pa]", "576 terms of 5 Pa"},
        elements.overpressure[0], 5.0 * (1.0 - hidden), 5.0 * 576 * kEps);
    EXPECT_EQ(elements.candidates, std::vector<int>{0});
    EXPECT_EQ(elements.overpressure[1], 0.0);
  }
}

void expect_refused(const std::function<void()>& action, const char* name) {
  try {
    action();
    ADD_FAILURE() << name << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

TEST(enumerators, outside_of_their_range_are_refused_by_name) {
  jet::JetModel model = models::round(0.05, 0.08);
  model.spread = static_cast<jet::Spread>(2);
  expect_refused([&] { jet::JetField(model, 1); }, "spread");
  expect_refused([] { jet::decay_coefficient(static_cast<jet::OutletType>(6)); }, "outlet type");
  expect_refused([] { jet::validate(jet::OutletModel{.law = static_cast<jet::OutletLaw>(-1), .area = 1.0}); },
                 "outlet law");
}

TEST(subdivision, wrong_meshes_and_sizes_are_refused_by_name) {
  const scenes::Mesh mesh = scenes::octahedron();
  const Eigen::Matrix3Xi triangles = mesh.triangles();
  expect_refused([&] { jet::Subdivision(triangles, 6, 0); }, "subdivision n is 0");
  expect_refused([&] { jet::Subdivision(triangles, 6, 65); }, "subdivision n is 65");
  expect_refused([&] { jet::Subdivision(triangles, 5, 2); }, "node index is 5");
  expect_refused([&] { jet::Subdivision(triangles.leftCols(0), 6, 2); }, "element count");
  expect_refused([&] { jet::Subdivision(triangles, 6, 100000); }, "subdivision n is 100000");
  const jet::Subdivision good(triangles, 6, 2);
  for (const int element : {-1, 8, 2147483647})
    expect_refused([&] { good.pieces_of(std::vector{0, element}); }, "subdivision element");
  Eigen::Matrix3Xd few(3, 5), nodes(3, good.node_count());
  expect_refused([&] { good.interpolate(few, nodes); }, "values");
  expect_refused([&] { good.interpolate(mesh.points(), few); }, "result");
  expect_refused([&] { good.share_areas(few, nodes); }, "result");
  jet::FieldState pieces{std::vector<double>(32), {}}, elements{std::vector<double>(7), {}};
  expect_refused([&] { good.average(pieces, elements); }, "field of the pieces");
}

}  // namespace
