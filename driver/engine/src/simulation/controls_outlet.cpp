// SPDX-License-Identifier: Apache-2.0
// Outlets that a caller moves.
#include <Eigen/Geometry>

#include "engine/controls.hpp"
#include "scene/outlet_place.hpp"
#include "simulation/control_checks.hpp"

namespace driver {
namespace {

using Eigen::Vector3d;

// A module moves a little with each step, and the test costs as much as a step: it is made anew when the
// outlet has moved by a tenth of its size, or turned by 0.1 rad.
void require_inside(Simulation& simulation, std::size_t jet, const Vector3d& centre, const Vector3d& axis) {
  const Scene& scene = simulation.scene();
  if (!scene.bag) return;
  jet::JetModel model = simulation.now().given->jets[jet].field.model();
  const double size = model.shape == jet::OutletShape::round ? model.radius : model.short_side;
  const auto& known = simulation.state().jets[jet].known_inside;
  if ((centre - known.col(0)).norm() <= 0.1 * size && (axis - known.col(1)).norm() <= 0.1) return;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(model.axis, axis);
  model.centre = centre;
  model.long_direction = turn * model.long_direction;
  model.axis = axis;
  try {
    require_centre_inside(model, scene.bag->mesh.elements, simulation.state().bag->position.map());
  } catch (const std::invalid_argument& error) {
    control::refuse(fmt::format("centre: {}", error.what()));
  }
  simulation.change_now([&](Scene&, State& state) { state.jets[jet].known_inside << centre, axis; });
}

}  // namespace

void set_outlet(Simulation& simulation, std::size_t jet, const Vector3d& centre, const Vector3d& axis) {
  control::require_number(jet, simulation.scene().jets.size(), "jet");
  control::require_finite(centre, "centre");
  control::require_finite(axis, "axis");
  if (!(axis.norm() > 0.0)) control::refuse("axis: is zero, allowed: any other length");
  require_inside(simulation, jet, centre, axis.normalized());
  place_outlet(simulation, jet, centre, axis);
}

void place_outlet(Simulation& simulation, std::size_t jet, const Vector3d& centre, const Vector3d& axis) {
  const jet::JetField& field = simulation.scene().jets[jet].field;
  const jet::JetModel& model = simulation.now().given->jets[jet].field.model();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(model.axis, axis);
  const Vector3d along =
      model.shape == jet::OutletShape::rectangular ? turn * model.long_direction : model.long_direction;
  simulation.change_level([jet, field = field.placed(centre, axis, along)](Scene& changed, State& state) {
    changed.jets[jet].field = field;
    JetRun& run = state.jets[jet];
    run.field.displacement_bound = jet::kMotionUnknown;
    run.load_change = 0.0;
  });
  simulation.note({Control::outlet, jet, {centre.x(), centre.y(), centre.z(), axis.x(), axis.y(), axis.z()}});
}

}  // namespace driver
