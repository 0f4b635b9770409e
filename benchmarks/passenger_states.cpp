// SPDX-License-Identifier: Apache-2.0
#include "passenger_states.hpp"

#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace benchmarks {
namespace {

struct Settings {
  double flattening;      // [-] of the depth
  double gauge_pressure;  // [Pa]
  double mass_damping;    // [1/s]
  double duration;        // [s]
};

Settings settings(Shape shape) {
  switch (shape) {
    case Shape::flat:
      return {0.1, 20e3, 0.0, 0.0};
    case Shape::crumpled:
      return {1.0, -1e3, 20.0, 7e-3};
    case Shape::inflated:
      break;
  }
  return {1.0, 5e3, 300.0, 60e-3};
}

membrane::BagModel make_bag_model(const mesh::PassengerBag& bag, double mass_damping) {
  membrane::BagDescription d;
  d.reference = bag.mesh.nodes;
  d.elements = bag.mesh.elements;
  d.properties.assign(static_cast<std::size_t>(bag.mesh.element_count()),
                      {0.5e-3, 620.0, 60e6, 0.3, 0.05, false});
  membrane::ElementProperties null_panel;
  null_panel.null_panel = true;
  for (const int e : mesh::panel_elements(bag.mesh, "vent"))
    d.properties[static_cast<std::size_t>(e)] = null_panel;
  d.fixed_nodes = mesh::panel_nodes(bag.mesh, "attachment");
  for (const auto& anchors : bag.strap_anchors) d.straps.push_back({anchors[0], anchors[1], 4500.0, 0.62});
  d.mass_damping = mass_damping;
  return membrane::make_model(d);
}

void update_forces(PassengerState& p) {
  membrane::update_surface(p.model, p.state);
  membrane::update_geometry(p.model, p.state);
  membrane::membrane_forces(p.model, p.state);
  membrane::support_forces(p.model, p.state);
  membrane::pressure_forces(p.state, p.gauge_pressure);
}

PassengerState make_passenger_state(Shape shape) {
  const Settings s = settings(shape);
  const auto bag = mesh::passenger_bag();
  const auto model = make_bag_model(bag, s.mass_damping);
  PassengerState p{bag,
                   model,
                   membrane::make_state(model, mesh::flatten(bag.mesh, s.flattening), {true, true}),
                   s.gauge_pressure,
                   mesh::panel_elements(bag.mesh, "vent"),
                   mesh::panel_elements(bag.mesh, "attachment")};
  update_forces(p);
  double before = 0.0;
  for (double time = 0.0; time < s.duration; time += before) {
    // The pressure is prescribed: no gas stiffness.
    const double step =
        0.8 * membrane::critical_time_step(membrane::stiffness_shares(p.model, p.state, 0.0, 0.0));
    membrane::advance(p.model, p.state, before, step);
    before = step;
    update_forces(p);
  }
  return p;
}

}  // namespace

const char* name_of(Shape shape) {
  switch (shape) {
    case Shape::flat:
      return "flat";
    case Shape::crumpled:
      return "crumpled";
    case Shape::inflated:
      break;
  }
  return "inflated";
}

const PassengerState& passenger_state(Shape shape) {
  static const PassengerState states[kShapes] = {make_passenger_state(Shape::flat),
                                                 make_passenger_state(Shape::crumpled),
                                                 make_passenger_state(Shape::inflated)};
  return states[static_cast<int>(shape)];
}

}  // namespace benchmarks
