// SPDX-License-Identifier: Apache-2.0
// Folded strips: positions, distances and strains in closed form; refusals.
#include "mesh/fold.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "fold_strain.hpp"
#include "intersections.hpp"
#include "mesh/driver_bag.hpp"
#include "mesh/passenger_bag.hpp"

namespace {

using fold_strain::largest_strain;
using mesh::Folding;
using mesh::FoldOptions;
using mesh::FoldType;
using mesh::Mesh;
using mesh::PackSide;

constexpr double gap = 1e-3, cell = 0.01;
constexpr double level = 1.05 * gap;  // a bend sets layers apart by the gap and 5 %
constexpr PackSide up{.axis = 2, .sign = 1.0};

// Sheets of `cells` x 3 squares in the plane z = 0, gap, ...; the squares of odd sheets have the other
// diagonal and begin `shift` cells later.
Mesh sheets(int cells, int count, double shift = 0.0) {
  Mesh mesh;
  const int row = cells + 1, sheet = 4 * row;
  mesh.nodes.resize(3, count * sheet);
  mesh.elements.resize(3, count * cells * 6);
  Eigen::Index e = 0;
  for (int s = 0; s < count; ++s)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i <= cells; ++i) {
        const int a = s * sheet + j * row + i;
        mesh.nodes.col(a) << cell * (i + (s % 2 == 0 ? 0.0 : shift)), cell * j, gap * s;
        if (i == cells || j == 3) continue;
        const int b = a + 1, c = a + row + 1, d = a + row, last = s % 2 == 0 ? c : d;
        mesh.elements.col(e++) << a, b, last;
        if (s % 2 == 0)
          mesh.elements.col(e++) << a, c, d;
        else
          mesh.elements.col(e++) << b, c, d;
      }
  mesh.panel.assign(static_cast<std::size_t>(e), 0);
  mesh.panel_names = {"all"};
  return mesh;
}

FoldOptions options(FoldType type, std::vector<double> at, int axis = 0) {
  return {.type = type, .axis = axis, .at = std::move(at), .gap = gap};
}

Folding folded(const Mesh& mesh, const FoldOptions& how, const std::vector<int>& fixed = {0}) {
  Folding folding(mesh, mesh.nodes, fixed, up);
  folding.fold(how);
  return folding;
}

// Least distance of elements that are further apart than `far` in the pack, or in different sheets.
double least_distance(const Mesh& mesh, const Eigen::Matrix3Xd& nodes, double far) {
  using namespace intersections;
  double least = 1e300;
  const auto sheet = [&](int e) { return mesh.nodes(2, mesh.elements(0, e)); };
  const auto middle = [&](int e) { return mesh.nodes(0, mesh.elements.col(e)).mean(); };
  const auto corners = [&](int e) {
    return triangle(nodes, {mesh.elements(0, e), mesh.elements(1, e), mesh.elements(2, e)});
  };
  for (int a = 0; a < mesh.element_count(); ++a)
    for (int b = 0; b < a; ++b) {
      if (sheet(a) == sheet(b) && std::abs(middle(a) - middle(b)) < far) continue;
      const Triangle s = corners(a), t = corners(b);
      for (int i = 0; i < 3; ++i) {
        least = std::min({least, CGAL::squared_distance(s[i], t), CGAL::squared_distance(t[i], s)});
        for (int j = 0; j < 3; ++j)
          least = std::min(least, CGAL::squared_distance(Segment(s[i], s[i + 1]), Segment(t[j], t[j + 1])));
      }
    }
  return std::sqrt(least);
}

// Half a cell on each side of the line is gathered; all else is mirrored, to the last bits.
TEST(Fold, a_flap_is_mirrored_about_line_and_plane) {
  const Mesh mesh = sheets(12, 1);
  const double at = 5.5 * cell;
  const Folding folding = folded(mesh, options(FoldType::letter, {at}));
  ASSERT_EQ(folding.lines().size(), 1u);
  EXPECT_FALSE(folding.lines()[0].eased);
  EXPECT_NEAR(folding.lines()[0].height, level, 1e-15);
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i) {
    const Eigen::Vector3d before = mesh.nodes.col(i), after = folding.nodes().col(i);
    EXPECT_EQ(after.y(), before.y());
    if (std::abs(before.x() - at) < 0.6 * cell) {  // in a corner of the bend
      EXPECT_NEAR(after.x(), at - 0.5 * cell, 0.02 * gap);
      EXPECT_NEAR(after.z(), before.x() < at ? 0.0 : level, 0.02 * gap);
    } else if (before.x() < at) {
      EXPECT_TRUE(after == before);
    } else {
      EXPECT_NEAR(after.x(), 2.0 * at - before.x(), 1e-15);
      EXPECT_NEAR(after.z(), level, 1e-15);
    }
  }
}

// A fine strip follows the bend: its upright part is as long as the fabric there.
TEST(Fold, fine_fabric_stands_upright_in_the_bend) {
  Mesh mesh = sheets(120, 1);
  mesh.nodes.row(0) *= 0.02;  // cells of 0.2 mm
  const double at = 0.0121;
  const Folding folding = folded(mesh, options(FoldType::letter, {at}));
  int upright = 0;
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i) {
    const double u = mesh.nodes(0, i) - at;
    if (std::abs(u) > 0.4 * level) continue;
    EXPECT_NEAR(folding.nodes()(2, i), 0.5 * level + u, 0.01 * level);
    EXPECT_TRUE(folding.gathered()[static_cast<std::size_t>(i)]);
    ++upright;
  }
  EXPECT_EQ(upright, 4 * 4);
  EXPECT_LE(largest_strain(mesh, folding, false), 1e-7);  // the root of round-off
}

TEST(Fold, layers_keep_the_gap) {
  const std::vector<std::function<FoldOptions()>> folds{
      [] {
        return options(FoldType::letter, {0.13, 0.27});
      },
      [] {
        return options(FoldType::accordion, {0.1, 0.2, 0.3});
      },
      [] {
        return options(FoldType::roll, {0.1, 0.18, 0.27});
      }};
  for (const double shift : {0.0, 0.3})
    for (const auto& fold : folds) {
      const Mesh mesh = sheets(40, 2, shift);
      const std::vector<int> middle{20}, end{0};
      const FoldOptions how = fold();
      const Folding folding = folded(mesh, how, how.type == FoldType::letter ? middle : end);
      EXPECT_GE(least_distance(mesh, folding.nodes(), 0.06), gap * (1.0 - 1e-9))
          << int(how.type) << " " << shift;
      EXPECT_LE(largest_strain(mesh, folding, false), 1e-3) << int(how.type);
      EXPECT_EQ(intersections::intersecting_pairs(folding.nodes(), mesh.elements), 0) << int(how.type);
    }
}

// Heights of the panels' middles above the part that stays, in levels.
TEST(Fold, the_type_orders_the_panels) {
  const Mesh mesh = sheets(60, 1);
  const auto level_at = [&](const Folding& folding, double x) {
    return folding.nodes()(2, static_cast<Eigen::Index>(std::lround(x / cell))) / level;
  };
  const std::vector<double> lines{0.155, 0.305, 0.455};
  const Folding accordion = folded(mesh, options(FoldType::accordion, lines));
  const Folding roll = folded(mesh, options(FoldType::roll, lines));
  const std::vector<double> middles{0.08, 0.23, 0.38, 0.53};
  const std::vector<double> to_and_fro{0.0, 1.0, 2.0, 3.0}, spiral{0.0, 3.0, 1.0, 2.0};
  for (std::size_t i = 0; i < middles.size(); ++i) {
    EXPECT_NEAR(level_at(accordion, middles[i]), to_and_fro[i], 1e-9) << i;
    EXPECT_NEAR(level_at(roll, middles[i]), spiral[i], 1e-9) << i;
  }
  const Folding letter = folded(mesh, options(FoldType::letter, {0.405, 0.195}), {30});
  EXPECT_NEAR(level_at(letter, 0.55), 1.0, 1e-9);  // the first of the list lies below
  EXPECT_NEAR(level_at(letter, 0.05), 2.0, 1e-9);
}

// The first flap ends just before the second line: the bend passes round it and does not lift it.
TEST(Fold, a_bend_leaves_room_for_what_lies_in_it) {
  const Mesh mesh = sheets(40, 2);
  const Folding folding = folded(mesh, options(FoldType::letter, {0.255, 0.1097}), {18});
  const auto height = [&](Eigen::Index node) { return folding.nodes()(2, node); };
  const Eigen::Index sheet = mesh.nodes.cols() / 2;
  EXPECT_NEAR(height(40), 2.0 * gap + level, 1e-15);
  EXPECT_NEAR(height(sheet + 40), gap + level, 1e-15);
  EXPECT_GT(folding.nodes()(0, sheet + 40), folding.nodes().row(0).minCoeff() + gap);
  EXPECT_NEAR(height(sheet), 2.0 * gap + 2.0 * level, 1e-15);
  EXPECT_NEAR(height(0), 3.0 * gap + 2.0 * level, 1e-15);
}

TEST(Fold, a_flap_goes_to_the_side_away_from_the_fixed_nodes) {
  const Mesh mesh = sheets(12, 2);
  EXPECT_EQ(mesh::thin_side(mesh.nodes, {0}).sign, 1.0);
  EXPECT_EQ(mesh::thin_side(mesh.nodes, {}).sign, 1.0);
  const int above = mesh.node_count() / 2;
  const PackSide side = mesh::thin_side(mesh.nodes, {above});
  EXPECT_EQ(side.axis, 2);
  EXPECT_EQ(side.sign, -1.0);
  Folding folding(mesh, mesh.nodes, {above}, side);
  folding.fold(options(FoldType::letter, {5.5 * cell}));
  EXPECT_NEAR(folding.nodes().row(2).minCoeff(), -gap - level, 1e-12);
  EXPECT_EQ(folding.nodes().row(2).maxCoeff(), gap);
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Fold, bad_input_is_named) {
  const Mesh mesh = sheets(40, 2);
  const auto says = [&](FoldOptions how, const std::vector<int>& fixed, const std::string& text) {
    const std::string message = refusal([&] { folded(mesh, how, fixed); });
    EXPECT_NE(message.find(text), std::string::npos) << text << "\n" << message;
  };
  FoldOptions good = options(FoldType::letter, {0.2}), how = good;
  how.gap = 0.0;
  says(how, {0}, "gap = 0 m: needs a finite number above 0");
  how.gap = 1.1 * gap;
  says(how, {0}, "gap = 0.0011 m: layers of the pack are only 0.001 m apart");
  how = good;
  how.axis = 2;
  says(how, {0}, "axis: must lie in the plane of the pack, which is thin along z");
  how = good;
  how.easing = -1.0;
  says(how, {0}, "easing = -1, allowed: 0 to 10");
  says(options(FoldType::letter, {}), {0}, "at: needs the coordinate");
  says(options(FoldType::letter, {0.5}), {0},
       "at = 0.5 m: the fold line must lie within the bag, between 0 m and 0.4 m");
  says(options(FoldType::letter, {0.2}), {0, 30},
       "at = 0.2 m: the fold line must not cross the part that stays, 0 m to 0.3 m");
  says(options(FoldType::letter, {0.2, 0.2}), {0}, "is given twice");
  says(options(FoldType::letter, {0.2, 0.3}), {0}, "a letter fold has one line on each side");
  says(options(FoldType::roll, {0.395}), {0}, "and the flap has only 0.005 m, allowed: about ");
  says(options(FoldType::roll, {0.302}), {30}, "and the fixed nodes are 0.002 m away, allowed: about ");
  says(options(FoldType::roll, {0.395}), {39},
       "and the flap has only 0.005 m: no line has room on this side");
  says(options(FoldType::accordion, {0.05, 0.2}), {0}, "below the part that stays");
  const Mesh bag = mesh::driver_bag().mesh, box = mesh::passenger_bag().mesh;
  const auto press = [&](const Mesh& it, const std::vector<int>& fixed, double distance) {
    return refusal([&] { Folding(it, it.nodes, fixed, PackSide{.axis = 0}).press(distance); });
  };
  const int front = mesh::panel_nodes(bag, "front").front(),
            back = mesh::panel_nodes(bag, "attachment").front();
  EXPECT_EQ(press(bag, {back}, gap), "");
  EXPECT_NE(press(bag, {front, back}, gap).find("one plane and in one sheet"), std::string::npos);
  EXPECT_NE(press(box, {}, gap).find("needs two sheets"), std::string::npos);
  EXPECT_NE(press(bag, {back}, 1.0).find("gap = 1 m, allowed: up to 0.0"), std::string::npos);
  EXPECT_NE(press(bag, {}, -1.0).find("a finite number above 0"), std::string::npos);
  EXPECT_NE(refusal([&] { Folding(bag, box.nodes, {}, up); }).find("one position for each"),
            std::string::npos);
  EXPECT_NE(refusal([&] { Folding(bag, bag.nodes, {-1}, up); }).find("out of range"), std::string::npos);
}

// Just inside the limits that a refusal names a line has room.
TEST(Fold, lines_within_the_limits_of_the_message_have_room) {
  const Mesh mesh = sheets(40, 2);
  for (const double at : {0.202, 0.395}) {
    const std::string message = refusal([&] { folded(mesh, options(FoldType::roll, {at}), {20}); });
    const std::string key = "allowed: about ", to = " m to ";
    ASSERT_NE(message.find(key), std::string::npos) << message;
    const std::string limits = message.substr(message.find(key) + key.size());
    const double low = std::stod(limits), high = std::stod(limits.substr(limits.find(to) + to.size()));
    EXPECT_GT(low, 0.2);
    EXPECT_LT(high, 0.4);
    // The limits move by the length of an element with the line, as its elements do.
    for (const double line : {low + cell, high - cell})
      EXPECT_EQ(refusal([&] { folded(mesh, options(FoldType::roll, {line}), {20}); }), "") << message;
  }
}

}  // namespace
