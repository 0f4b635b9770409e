// SPDX-License-Identifier: Apache-2.0
// [target] -> TargetPart: a rigid rectangle that a jet blows at.
#include "scene/read_target.hpp"

#include <Eigen/Geometry>

#include "mesh/icosphere.hpp"

namespace driver {
namespace {

Eigen::Vector3d direction(const TableReader& table, const char* key, const Eigen::Vector3d& vector) {
  if (!(vector.norm() > 0.0)) table.fail(key, "has length 0, allowed: a direction of any other length");
  return vector.normalized();
}

}  // namespace

void read_target(TableReader& root, Scene& scene) {
  auto table = root.optional_table("target");
  if (!table) return;
  if (scene.bag) table->fail("", "a scene has a [target] or a [membrane], not both");
  const Eigen::Vector3d centre = table->at("centre").vector("m");
  const Eigen::Vector3d normal = direction(*table, "normal", table->at("normal").vector(""));
  const Eigen::Vector3d given = direction(
      *table, "side", table->at("side").vector("", normal.unitOrthogonal(), "any across the normal"));
  const Eigen::Vector3d side = direction(*table, "side", given - given.dot(normal) * normal);
  const double width = table->at("width").number(positive.in("m"));
  const double height = table->at("height").number(positive.in("m"));
  const int columns = table->at("columns").integer(1, 2000, 50);
  const int rows = table->at("rows").integer(1, 2000, 50);
  table->finish();

  const auto mesh = mesh::rectangle(columns, rows, width, height, mesh::Diagonals::union_jack);
  Eigen::Matrix3d frame;
  frame << side, normal.cross(side), normal;
  const Eigen::Vector3d middle(0.5 * width, 0.5 * height, 0.0);
  scene.target.emplace(
      TargetPart{columns, rows, (frame * (mesh.nodes.colwise() - middle)).colwise() + centre, mesh.elements});
}

}  // namespace driver
