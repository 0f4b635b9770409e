// SPDX-License-Identifier: Apache-2.0
// [target] -> TargetPart: a rigid rectangle that a jet blows at.
#include <Eigen/Geometry>

#include "membrane/icosphere.hpp"
#include "scene/parts.hpp"

namespace driver {
namespace {

Eigen::Vector3d direction(const TableReader& table, const char* key, const Eigen::Vector3d& vector) {
  if (!(vector.norm() > 0.0)) table.fail(key, "has length 0, a direction of any other length is allowed");
  return vector.normalized();
}

}  // namespace

void read_target(TableReader& root, Scene& scene) {
  auto table = root.optional_table("target");
  if (!table) return;
  if (scene.bag) table->fail("", "a scene has a [target] or a [membrane], not both");
  const Eigen::Vector3d centre = table->vector("centre");
  const Eigen::Vector3d normal = direction(*table, "normal", table->vector("normal"));
  const Eigen::Vector3d given = direction(*table, "side", table->vector("side", normal.unitOrthogonal()));
  const Eigen::Vector3d side = direction(*table, "side", given - given.dot(normal) * normal);
  const double width = table->number("width", positive);
  const double height = table->number("height", positive);
  const int columns = table->integer("columns", 1, 2000, 50);
  const int rows = table->integer("rows", 1, 2000, 50);
  table->finish();

  const auto mesh = membrane::rectangle(columns, rows, width, height, membrane::Diagonals::union_jack);
  Eigen::Matrix3d frame;
  frame << side, normal.cross(side), normal;
  const Eigen::Vector3d middle(0.5 * width, 0.5 * height, 0.0);
  scene.target.emplace(
      TargetPart{(frame * (mesh.nodes.colwise() - middle)).colwise() + centre, mesh.elements});
}

}  // namespace driver
