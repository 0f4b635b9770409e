// SPDX-License-Identifier: Apache-2.0
// [inflator.jet] -> JetPart.
#include <fmt/format.h>

#include <Eigen/Geometry>

#include "coupling/side.hpp"
#include "scene_parts.hpp"

namespace driver {
namespace {

jet::JetModel read_model(TableReader& table) {
  jet::JetModel model;
  model.shape = table.choice<jet::OutletShape>(
      "shape", {{"round", jet::OutletShape::round}, {"rectangular", jet::OutletShape::rectangular}});
  model.centre = table.vector("centre");
  model.axis = table.vector("axis");
  if (model.shape == jet::OutletShape::round) {
    model.radius = table.number("radius", positive);
  } else {
    model.long_direction = table.vector("long_direction");
    model.long_side = table.number("long_side", positive);
    model.short_side = table.number("short_side", positive);
  }
  model.decay_coefficient = table.number("decay_coefficient", positive);
  model.spread = table.choice<jet::Spread>(
      "spread", {{"momentum", jet::Spread::momentum}, {"cone", jet::Spread::cone}}, "momentum");
  if (model.spread == jet::Spread::cone) {
    model.cone_initial_width = table.number("cone_initial_width", positive);
    model.cone_half_angle = table.number("cone_half_angle", non_negative);
  }
  model.direction = table.choice<jet::Direction>(
      "direction", {{"axial", jet::Direction::axial}, {"radial", jet::Direction::radial}}, "axial");
  model.restitution = table.number("restitution", fraction, 1.0);
  model.cut_off = table.number("cut_off", fraction, model.cut_off);
  return model;
}

jet::OutletModel read_outlet(TableReader& table, const jet::JetModel& model) {
  jet::OutletModel outlet;
  outlet.law = table.choice<jet::OutletLaw>(
      "outlet", {{"sonic", jet::OutletLaw::sonic}, {"pressure_matched", jet::OutletLaw::pressure_matched}},
      "sonic");
  outlet.temperature = table.choice<jet::OutletTemperature>(
      "temperature",
      {{"static", jet::OutletTemperature::static_value}, {"stagnation", jet::OutletTemperature::stagnation}},
      "static");
  outlet.area = jet::outlet_area(model);
  jet::validate(outlet);
  return outlet;
}

// Ends and centre of the outlet, moved into the bag by a millionth of its size.
void require_outlet_inside(const jet::JetModel& model, const BagPart& bag) {
  const double size =
      (bag.initial_position.rowwise().maxCoeff() - bag.initial_position.rowwise().minCoeff()).norm();
  const auto source = jet::ray_source(model);
  for (const double side : {-1.0, 0.0, 1.0}) {
    const Eigen::Vector3d end = source.centre + side * source.half_long * source.long_direction;
    const Eigen::Vector3d point = end + 1e-6 * size * source.axis.normalized();
    const double winding = coupling::winding_number(bag.mesh.elements, bag.initial_position, point);
    if (!(winding > 0.5))
      throw std::invalid_argument(
          fmt::format("the outlet at [{}, {}, {}] m is outside the bag; a place inside it, or "
                      "on its skin with the axis inwards, is allowed",
                      end.x(), end.y(), end.z()));
    if (source.half_long == 0.0) break;
  }
}

// A target behind the outlet, or facing the wrong way, would feel nothing: a slip.
void require_target_ahead(const TableReader& table, const jet::JetModel& model, const TargetPart& target) {
  const Eigen::Vector3d a = target.nodes.col(target.triangles(0, 0)),
                        b = target.nodes.col(target.triangles(1, 0)),
                        c = target.nodes.col(target.triangles(2, 0));
  if (!((b - a).cross(c - a).dot(model.axis) > 0.0))
    table.fail("axis",
               "does not meet the target's face: a target whose normal points away from the jet is allowed");
  if (!((model.axis.transpose() * (target.nodes.colwise() - model.centre)).maxCoeff() > 0.0))
    table.fail("centre", "lies behind the whole target, which would feel nothing");
}

std::vector<int> attachment_elements(TableReader& table, const Scene& scene) {
  std::vector<int> elements;
  const auto panels = table.texts("attachment_panels");
  if (!panels.empty() && !scene.bag) table.fail("attachment_panels", "the scene has no membrane");
  table.located("attachment_panels", [&] {
    for (const auto& name : panels)
      for (const int element : membrane::panel_elements(scene.bag->mesh, name)) elements.push_back(element);
  });
  return elements;
}

}  // namespace

void read_jet(TableReader& inflator, std::size_t index, Scene& scene) {
  auto table = inflator.optional_table("jet");
  if (!table) return;
  if (!scene.bag && !scene.target) table->fail("", "needs something to blow at: [membrane] or [target]");
  jet::JetModel model = read_model(*table);
  table->located("", [&] { model = jet::validated(model); });
  const std::vector<int> attachment = attachment_elements(*table, scene);
  const std::vector<int> null_elements = scene.bag ? scene.bag->null_elements : std::vector<int>{};
  const auto elements = scene.bag ? scene.bag->mesh.elements.cols() : scene.target->triangles.cols();

  table->located("", [&] {
    jet::OutletModel outlet = read_outlet(*table, model);
    scene.jets.push_back(JetPart{index,
                                 jet::JetField(model, static_cast<int>(elements), null_elements),
                                 outlet,
                                 {null_elements, attachment}});
  });
  JetPart& part = scene.jets.back();
  part.occlusion = table->flag("occlusion", true);
  part.route = table->choice<jet::VisibilityRoute>("visibility",
                                                   {{"fast", jet::VisibilityRoute::fast},
                                                    {"cgal_tree", jet::VisibilityRoute::cgal_tree},
                                                    {"brute_force", jet::VisibilityRoute::brute_force}},
                                                   "fast");
  part.work = table->choice<JetWork>(
      "jet_work", {{"external", JetWork::external}, {"from_gas", JetWork::from_gas}}, "external");
  if (part.work == JetWork::from_gas && part.outlet.temperature != jet::OutletTemperature::stagnation)
    table->fail("jet_work",
                "\"from_gas\" needs temperature = \"stagnation\": with a static temperature the jet's "
                "kinetic energy is no part of the inflator's enthalpy");
  if (scene.target) require_target_ahead(*table, model, *scene.target);
  if (scene.bag) table->located("centre", [&] { require_outlet_inside(model, *scene.bag); });
  table->finish();
}

}  // namespace driver
