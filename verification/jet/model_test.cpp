// SPDX-License-Identifier: Apache-2.0
// What a jet's description is checked for.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "jet/field.hpp"
#include "models.hpp"

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

struct Wrong {
  const char* member;
  std::function<void(jet::JetModel&)> change;
};

void expect_refused(const jet::JetModel& good, const Wrong& wrong) {
  jet::JetModel model = good;
  wrong.change(model);
  try {
    jet::validated(model);
    ADD_FAILURE() << wrong.member << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(wrong.member), std::string::npos) << error.what();
  }
}

TEST(model, wrong_members_are_refused_by_name) {
  const Wrong of_any[] = {{"axis", [](auto& m) { m.axis.setZero(); }},
                          {"axis", [](auto& m) { m.axis[1] = kNan; }},
                          {"centre", [](auto& m) { m.centre[0] = kNan; }},
                          {"decay_coefficient", [](auto& m) { m.decay_coefficient = 0.0; }},
                          {"restitution", [](auto& m) { m.restitution = std::nextafter(4.0, 5.0); }},
                          {"restitution", [](auto& m) { m.restitution = std::nextafter(-0.5, -1.0); }},
                          {"restitution", [](auto& m) { m.restitution = kNan; }},
                          {"cut_off", [](auto& m) { m.cut_off = 1.0; }},
                          {"cone_initial_width", [](auto& m) { m.spread = jet::Spread::cone; }},
                          {"cone_half_angle", [](auto& m) {
                             m.spread = jet::Spread::cone;
                             m.cone_initial_width = 0.1;
                             m.cone_half_angle = 2.0;
                           }}};
  const jet::JetModel round = models::round(0.02, 0.08), wedge = models::rectangular(0.02, 0.2, 0.11);
  for (const Wrong& wrong : of_any) {
    expect_refused(round, wrong);
    expect_refused(wedge, wrong);
  }
  expect_refused(round, {"radius", [](auto& m) { m.radius = 0.0; }});
  expect_refused(wedge, {"short_side", [](auto& m) { m.short_side = -1.0; }});
  expect_refused(wedge, {"long_side", [](auto& m) { m.long_side = kNan; }});
  expect_refused(wedge, {"short_side", [](auto& m) { std::swap(m.short_side, m.long_side); }});
  expect_refused(wedge, {"long_direction", [](auto& m) { m.long_direction = m.axis; }});
}

TEST(model, restitution_reaches_its_ends) {
  for (const double end : {-0.5, 4.0}) {
    jet::JetModel model = models::round(0.02, 0.08);
    model.restitution = end;
    EXPECT_EQ(jet::validated(model).restitution, end);
    EXPECT_EQ(jet::JetField(model, 4).make_state().restitution, end);
  }
}

TEST(model, widened_outlet_has_so_much_more_area) {
  for (const jet::JetModel& model : {models::round(0.02, 0.08), models::rectangular(0.02, 0.2, 0.11)}) {
    for (const double ratio : {0.7, 1.0, 3.0}) {
      const jet::JetModel wider = jet::widened(model, ratio);
      EXPECT_NEAR(jet::outlet_area(wider), ratio * jet::outlet_area(model), 1e-15 * ratio);
      if (model.shape == jet::OutletShape::rectangular) {
        EXPECT_EQ(wider.long_side, 0.2);
      }
    }
  }
}

TEST(model, directions_are_normalised_and_unit_ones_kept_bit_for_bit) {
  jet::JetModel model = models::rectangular(0.02, 0.2, 0.11);
  const Eigen::Vector3d axis = model.axis;
  EXPECT_EQ(jet::validated(model).axis, axis);
  model.axis *= 1e-200;
  model.long_direction *= 1e200;
  const jet::JetModel result = jet::validated(model);
  EXPECT_NEAR((result.axis - axis).norm(), 0.0, 1e-15);
  EXPECT_NEAR(result.long_direction.norm(), 1.0, 1e-15);
}

TEST(model, field_refuses_wrong_surfaces) {
  const jet::JetModel model = models::round(0.02, 0.08);
  EXPECT_THROW(jet::JetField(model, 0), std::invalid_argument);
  EXPECT_THROW(jet::JetField(model, 4, std::vector<int>{4}), std::invalid_argument);
  const jet::JetField field(model, 4);
  jet::FieldState state = field.make_state();
  const Eigen::Matrix3Xd four = Eigen::Matrix3Xd::Ones(3, 4), three = Eigen::Matrix3Xd::Ones(3, 3);
  EXPECT_THROW(field.evaluate(three, four, {}, state), std::invalid_argument);
  EXPECT_THROW(field.evaluate(four, three, {}, state), std::invalid_argument);
  jet::FieldState foreign;
  EXPECT_THROW(field.evaluate(four, four, {}, foreign), std::invalid_argument);
}

}  // namespace
