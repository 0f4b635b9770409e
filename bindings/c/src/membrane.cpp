// SPDX-License-Identifier: Apache-2.0
#include <gasjet/membrane.h>

#include <algorithm>

#include "arrays.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"
#include "mesh/surface_check.hpp"

using namespace border;

namespace {

struct Membrane : Object {
  explicit Membrane(const membrane::BagDescription& description)
      : model(membrane::make_model(description)), state(membrane::make_state(model, description.reference)) {}
  static constexpr const char* name = "a membrane";
  static constexpr bool shared = false;

  membrane::BagModel model;
  membrane::BagState state;
};

membrane::BagDescription description_of(const Points& reference, Eigen::Matrix3Xi triangles,
                                        const gasjet_fabric_model& fabric,
                                        const std::vector<int>& null_elements) {
  membrane::BagDescription bag;
  bag.reference = reference.view();
  bag.elements = std::move(triangles);
  membrane::ElementProperties properties;
  properties.thickness = fabric.thickness;
  properties.density = fabric.density;
  properties.young_modulus = fabric.young_modulus;
  properties.poisson = fabric.poisson;
  bag.properties.assign(static_cast<std::size_t>(bag.elements.cols()), properties);
  for (const int e : null_elements) bag.properties[static_cast<std::size_t>(e)].null_panel = true;
  if (fabric.law != GASJET_SAINT_VENANT_KIRCHHOFF && fabric.law != GASJET_HENCKY)
    refuse("fabric.law", "is " + std::to_string(fabric.law) + ", allowed: a gasjet_fabric_law, 0 or 1");
  if (fabric.law == GASJET_HENCKY && fabric.wrinkles == 0)
    refuse("fabric.wrinkles", "is 0, allowed with the Hencky law: not 0, because it carries no compression");
  if (fabric.law == GASJET_HENCKY) bag.law = "hencky";
  bag.compression = fabric.wrinkles != 0 ? membrane::Compression::none : membrane::Compression::linear;
  return bag;
}

gasjet_membrane_sums sums_of(const Membrane& membrane, double gamma, double pressure) {
  const auto shares = membrane::stiffness_shares(membrane.model, membrane.state, gamma, pressure);
  return {membrane.state.surface.volume,
          membrane.state.surface.area,
          membrane.model.fabric_mass,
          membrane.state.forces.strain_energy,
          shares.element,
          shares.gas,
          membrane::critical_time_step(shares)};
}

gasjet_surface_faults faults_of(const mesh::SurfaceReport& report) {
  const auto count = [](const auto& list) { return static_cast<int64_t>(list.size()); };
  return {report.ok() ? 1 : 0,
          count(report.boundary_edges),
          count(report.non_manifold_edges),
          count(report.inconsistent_edges),
          count(report.repeated_node_elements),
          count(report.pinched_nodes),
          count(report.unused_nodes),
          report.components.empty() ? 0 : count(report.components) - 1,
          report.inward ? 1 : 0,
          report.flat ? 1 : 0};
}

void write_vectors(const membrane::Vectors& from, double* to) {
  if (to == nullptr) return;
  Eigen::Map<Eigen::Matrix3Xd>(to, 3, from.count()) = from.map();
}

}  // namespace

int gasjet_surface_check(const double nodes[], int64_t node_count, const int64_t node_stride[],
                         const int32_t triangles[], int64_t triangle_count, const int64_t triangle_stride[],
                         gasjet_surface_faults* faults, char text[], int64_t size, int64_t* needed_size) {
  return call([&] {
    const Points points(nodes, node_count, node_stride, "nodes");
    const auto report = mesh::check_closed_surface(
        points.view(), triangles_of(triangles, triangle_count, triangle_stride, node_count));
    needed(faults, "faults") = faults_of(report);
    write_sized(report.describe(), text, size, needed_size);
  });
}

int gasjet_membrane_create(const double reference[], int64_t node_count, const int64_t reference_stride[],
                           const int32_t triangles[], int64_t triangle_count, const int64_t triangle_stride[],
                           const gasjet_fabric_model* fabric, const int32_t null_elements[],
                           int64_t null_count, const int32_t fixed_nodes[], int64_t fixed_count,
                           gasjet_handle* membrane) {
  return call([&] {
    needed(membrane, "membrane");
    const Points points(reference, node_count, reference_stride, "reference");
    auto bag = description_of(points, triangles_of(triangles, triangle_count, triangle_stride, node_count),
                              needed(fabric, "fabric"),
                              numbers_of(null_elements, null_count, triangle_count, "null_elements"));
    bag.fixed_nodes = numbers_of(fixed_nodes, fixed_count, node_count, "fixed_nodes");
    *membrane = keep(std::make_shared<Membrane>(bag));
  });
}

int gasjet_membrane_masses(gasjet_handle membrane, double mass[], int64_t mass_count) {
  return call([&] {
    const Use<Membrane> use(membrane, "membrane");
    const auto out = output(mass, mass_count, use->model.node_count, "mass");
    std::copy(use->model.node_mass.begin(), use->model.node_mass.end(), out.begin());
  });
}

int gasjet_membrane_evaluate(gasjet_handle membrane, const double nodes[], int64_t node_count,
                             const int64_t node_stride[], double gamma, double pressure, double force[],
                             double gradient[], int64_t vector_count, gasjet_membrane_sums* sums) {
  return call([&] {
    const Use<Membrane> use(membrane, "membrane");
    require_count(node_count, use->model.node_count, "nodes");
    const Points points(nodes, node_count, node_stride, "nodes");
    needed(sums, "sums");
    number(gamma, "gamma", 0.0);
    number(pressure, "pressure", 0.0);
    if (force != nullptr || gradient != nullptr)
      require_count(vector_count, 3 * node_count, "force, gradient");
    use->state.position.map() = points.view();
    membrane::update_skin(use->model, use->state);
    const auto found = sums_of(*use, gamma, pressure);
    if (force != nullptr && !use->state.membrane_force.map().allFinite())
      throw Failure(GASJET_DOMAIN, not_finite("force"));
    finite(found.volume, "volume");
    finite(found.strain_energy, "strain_energy");
    *sums = found;
    write_vectors(use->state.membrane_force, force);
    write_vectors(use->state.volume_gradient, gradient);
  });
}
