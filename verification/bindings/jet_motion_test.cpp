// SPDX-License-Identifier: Apache-2.0
// Pieces, a skin that moves, and nodes in single precision.
#include <Eigen/Geometry>

#include "jet/field.hpp"
#include "jet/subdivision.hpp"
#include "jet_answers.hpp"

using namespace border_test;

namespace {

/// The library's own field on pieces, with the velocities of a skin that turns.
TEST(c_jet_motion, pieces_and_velocities_eq_the_librarys) {
  const Mesh mesh = rough(6);
  const auto count = mesh.triangle_count();
  const Eigen::Map<const Eigen::Matrix3Xd> x(mesh.nodes.data(), 3, mesh.node_count());
  const Eigen::Map<const Eigen::Matrix3Xi> t(mesh.triangles.data(), 3, count);
  Eigen::Matrix3Xd v(3, x.cols());
  for (Eigen::Index i = 0; i < x.cols(); ++i) v.col(i) << 30.0 * x(1, i), -20.0 * x(0, i), 15.0;
  jet::JetModel model;
  model.centre.setZero(), model.axis = Eigen::Vector3d::UnitX();
  model.radius = 0.15, model.decay_coefficient = 0.08, model.relative_to_skin = true;
  const jet::Subdivision cut(t, static_cast<int>(x.cols()), 2);
  Eigen::Matrix3Xd points(3, cut.node_count()), areas(3, count), piece_areas(3, 4 * count),
      centroids(3, 4 * count), speed(3, count), piece_speed(3, 4 * count);
  cut.interpolate(x, points);
  for (Eigen::Index e = 0; e < count; ++e) {
    const Eigen::Vector3d a = x.col(t(0, e)), ab = x.col(t(1, e)) - a, ac = x.col(t(2, e)) - a;
    areas.col(e) = 0.5 * ab.cross(ac);
  }
  cut.share_areas(areas, piece_areas);
  jet::corner_means(points, cut.triangles(), centroids);
  jet::corner_means(v, t, speed);
  for (Eigen::Index e = 0; e < count; ++e) piece_speed.middleCols(4 * e, 4).colwise() = speed.col(e);
  const jet::JetField field(model, static_cast<int>(4 * count));
  jet::FieldState pieces = field.make_state();
  jet::FieldState whole = jet::JetField(model, static_cast<int>(count)).make_state();
  const jet::Points piece_velocities(piece_speed);
  field.evaluate(piece_areas, centroids, {400.0, 1.2}, pieces, &piece_velocities);
  std::vector<std::uint8_t> lit(pieces.candidates.size());
  jet::VisibilityQuery(cut.triangles(), cut.node_count())
      .query(jet::VisibilityRoute::fast, points, jet::ray_source(jet::validated(model)), pieces.candidates,
             lit);
  jet::apply_mask(lit, pieces);
  cut.average(pieces, whole);
  double work = 0.0, size = 0.0;
  for (const int e : whole.candidates) {
    const double dp = whole.overpressure[static_cast<std::size_t>(e)];
    work += dp * areas.col(e).dot(speed.col(e));
    size += dp * areas.col(e).norm() * speed.col(e).norm();
  }

  Handle jet;
  make(jet, broad(), mesh);
  ASSERT_OK(gasjet_jet_subdivide(jet.value, 2));
  ASSERT_OK(gasjet_jet_relative_to_skin(jet.value, 1));
  Answer found{std::vector<double>(elements_of(mesh))};
  double power = 0.0;
  ASSERT_OK(gasjet_jet_pressure_of(jet.value, x.data(), x.cols(), nullptr, v.data(), nullptr, 400.0, 1.2, 1,
                                   kNan, nullptr, 0, found.pressure.data(), count, found.force, &power,
                                   &found.counters));
  EXPECT_EQ(found.pressure, whole.overpressure);
  EXPECT_NEAR(power, work, 2.3e-16 * 800 * size);  // a rounding for each of fewer than 800 elements
  EXPECT_GT(std::abs(power), 10.0);
  EXPECT_EQ(found.counters.candidates, static_cast<int64_t>(lit.size()));
  EXPECT_GT(found.counters.hidden, 0);
  ASSERT_OK(gasjet_jet_relative_to_skin(jet.value, 0));
  EXPECT_NE(answer(jet, mesh).pressure, found.pressure) << "the skin's motion must count";
}

TEST(c_jet_motion, single_precision_eq_its_values_in_double) {
  Mesh mesh = rough(7);
  const std::vector<float> x(mesh.nodes.begin(), mesh.nodes.end());
  std::vector<float> columns(x.size()), v(x.size());
  const auto nodes = static_cast<std::size_t>(mesh.node_count());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mesh.nodes[i] = static_cast<double>(x[i]);
    columns[i % 3 * nodes + i / 3] = x[i];
    v[i] = 10.0f * x[i];
  }
  const std::vector<double> velocity(v.begin(), v.end());
  const int64_t stride[] = {1, mesh.node_count()};
  Handle jet;
  make(jet, broad(), mesh);
  Answer one{std::vector<double>(elements_of(mesh))}, two = one;
  double power, same;
  ASSERT_OK(gasjet_jet_pressure_of(jet.value, mesh.nodes.data(), mesh.node_count(), nullptr, velocity.data(),
                                   nullptr, 400.0, 1.2, 1, kNan, nullptr, 0, one.pressure.data(),
                                   mesh.triangle_count(), one.force, &power, &one.counters));
  ASSERT_OK(gasjet_jet_pressure_float(jet.value, columns.data(), mesh.node_count(), stride, v.data(), nullptr,
                                      400.0, 1.2, 1, kNan, nullptr, 0, two.pressure.data(),
                                      mesh.triangle_count(), two.force, &same, &two.counters));
  EXPECT_TRUE(one == two);
  EXPECT_EQ(power, same);
}

}  // namespace
