// SPDX-License-Identifier: Apache-2.0
#include "scene/read_impactor.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/curve_reader.hpp"
#include "scene/gas_curve.hpp"

namespace driver {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

// Beyond these a step would add nothing to the angle.
constexpr Bounds turns{-1000.0, 1000.0, false, "a number from -1000 to 1000"};

enum class ShapeName { sphere, ellipsoid, cylinder, disc };
enum class MotionName { pendulum, rail, free };

coupling::Impactor read_shape(TableReader& impactor) {
  TableReader table = impactor.table("shape");
  const auto type = table.at("type").choice<ShapeName>({{"sphere", ShapeName::sphere},
                                                        {"ellipsoid", ShapeName::ellipsoid},
                                                        {"cylinder", ShapeName::cylinder},
                                                        {"disc", ShapeName::disc}});
  const Bounds length = positive.in("m");
  coupling::Impactor shape;
  switch (type) {
    case ShapeName::sphere:
      shape = coupling::Sphere{table.at("radius").number(length)};
      break;
    case ShapeName::ellipsoid:
      shape = coupling::Ellipsoid{table.at("half_axes").vector("m")};
      break;
    case ShapeName::cylinder:
      shape = coupling::Cylinder{table.at("radius").number(length), table.at("half_length").number(length)};
      break;
    case ShapeName::disc:
      shape = coupling::Disc{table.at("radius").number(length), table.at("rim_radius").number(length)};
  }
  table.located("", [&] { coupling::require_valid(shape); });
  table.finish();
  return shape;
}

// The body's z along `axis`, its x along the part of `second_axis` at right angles to that.
Matrix3d read_axes(TableReader& table, const Vector3d& usual) {
  const Vector3d z_given = table.at("axis").vector("", usual, "the rail's direction, or [0, 0, 1]");
  if (!(z_given.norm() > 0.0))
    table.fail("axis", "[0, 0, 0] has no direction, allowed: a vector of any length");
  const Vector3d z = z_given.normalized();
  const Vector3d any = z.cross(std::abs(z.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY()).cross(z);
  const Vector3d given = table.at("second_axis").vector("", any, "any at right angles to axis");
  const Vector3d x = given - given.dot(z) * z;
  if (!(x.norm() > 1e-6 * given.norm())) table.fail("second_axis", "is parallel to axis, or zero");
  Matrix3d axes;
  axes.col(0) = x.normalized();
  axes.col(2) = z;
  axes.col(1) = z.cross(axes.col(0));
  return axes;
}

coupling::RailSpring read_spring(TableReader table, bool is_stop) {
  coupling::RailSpring spring;
  spring.stiffness = table.at("stiffness").number(is_stop ? positive.in("N/m") : non_negative.in("N/m"));
  spring.damping = table.at("damping").number(non_negative.in("N s/m"), 0.0);
  spring.one_sided = is_stop;
  spring.at =
      is_stop ? table.at("at").number(positive.in("m")) : table.at("at").number(any_number.in("m"), 0.0);
  table.finish();
  return spring;
}

coupling::Rail read_rail(TableReader& table) {
  coupling::Rail rail;
  rail.direction = table.at("direction").vector("");
  if (!(rail.direction.norm() > 0.0))
    table.fail("direction", "[0, 0, 0] has no direction, allowed: a vector of any length");
  rail.direction.normalize();
  if (table.has("spring")) rail.springs.push_back(read_spring(table.table("spring"), false));
  if (table.has("stop")) rail.springs.push_back(read_spring(table.table("stop"), true));
  return rail;
}

// Three principal moments, or xx, yy, zz, xy, yz, zx.
Matrix3d read_inertia(TableReader& table) {
  const std::vector<double> given = table.at("inertia").numbers(any_number.in("kg m²"));
  if (given.size() != 3 && given.size() != 6)
    table.fail(
        "inertia",
        fmt::format("has {} numbers, allowed: 3 principal moments, or xx, yy, zz, xy, yz, zx", given.size()));
  Matrix3d inertia = Vector3d(given[0], given[1], given[2]).asDiagonal();
  if (given.size() == 6) {
    inertia(0, 1) = inertia(1, 0) = given[3];
    inertia(1, 2) = inertia(2, 1) = given[4];
    inertia(2, 0) = inertia(0, 2) = given[5];
  }
  return inertia;
}

BodyPart read_body(TableReader& impactor, TableReader& table, bool on_rail, const Vector3d& gravity) {
  coupling::RigidBodyParameters p;
  p.mass = table.at("mass").number(positive.in("kg"));
  p.centre = impactor.at("centre").vector("m");
  p.gravity = gravity;
  if (on_rail) {
    p.rail = read_rail(table);
    p.velocity = table.at("velocity").number(any_number.in("m/s"), 0.0) * p.rail->direction;
  } else {
    p.velocity = table.at("velocity").vector("m/s", Vector3d::Zero());
    p.angular_velocity = table.at("angular_velocity").vector("rad/s", Vector3d::Zero());
    p.inertia = read_inertia(table);
  }
  p.axes = read_axes(impactor, on_rail ? p.rail->direction : Vector3d::UnitZ());
  std::optional<BodyPart> part;
  table.located("", [&] { part.emplace(BodyPart{coupling::RigidBodyModel(p), {}}); });
  if (on_rail && table.has("force"))
    table.located("force", [&] {
      part->force = to_gas_curve(CurveReader(table, "force").curve(any_number.in("N")), gas::Outside::zero);
    });
  return *part;
}

}  // namespace

PendulumPart read_pendulum_motion(TableReader& table, double radius, const Vector3d& gravity) {
  coupling::PendulumParameters p;
  p.pivot = table.at("pivot").vector("m");
  p.axis = table.at("axis").vector("");
  p.rest_direction = table.at("rest_direction").vector("");
  p.mass = table.at("mass").number(positive.in("kg"));
  p.inertia_cg = table.at("inertia_cg").number(non_negative.in("kg m²"));
  p.cg_distance = table.at("cg_distance").number(non_negative.in("m"));
  p.impactor_distance = table.at("impactor_distance").number(positive.in("m"));
  p.impactor_radius = radius;
  p.gravity = gravity;
  coupling::PendulumState initial;
  initial.angle = table.at("initial_angle").number(turns.in("rad"), 0.0);
  initial.angular_velocity = table.at("initial_angular_velocity").number(any_number.in("rad/s"), 0.0);
  PendulumPart part{coupling::PendulumModel(p), initial, {}};
  if (table.has("driving_moment"))
    table.located("driving_moment", [&] {
      part.driving_moment =
          to_gas_curve(CurveReader(table, "driving_moment").curve(any_number.in("N m")), gas::Outside::zero);
    });
  return part;
}

void read_impactor(TableReader& table, Scene& scene) {
  scene.impactor = read_shape(table);
  TableReader motion = table.table("motion");
  const auto type = motion.at("type").choice<MotionName>(
      {{"pendulum", MotionName::pendulum}, {"rail", MotionName::rail}, {"free", MotionName::free}});
  if (type == MotionName::pendulum) {
    motion.located("", [&] {
      scene.pendulum.emplace(read_pendulum_motion(motion, coupling::size_of(scene.impactor), scene.gravity));
    });
    scene.pendulum->path = motion.path();
    scene.pendulum->axes = read_axes(table, Vector3d::UnitZ());
  } else {
    scene.body.emplace(read_body(table, motion, type == MotionName::rail, scene.gravity));
  }
  motion.finish();
}

}  // namespace driver
