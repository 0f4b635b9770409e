// SPDX-License-Identifier: Apache-2.0
#include "scene/bag_start.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/supply.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace driver {
namespace {

constexpr double file_rounding = 1e-6;  // of the bag's extent: what the decimals of mesh files leave

double longest_extent(const Eigen::Matrix3Xd& nodes) {
  return (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).maxCoeff();
}

// Where a plate would push a node that can move: its depth [m], or 0.
double depth_in_plate(const membrane::Plate& plate, const BagPart& bag, Eigen::Index node) {
  const Eigen::Vector3d normal = plate.normal.normalized();
  const Eigen::Vector3d mobility = bag.model.inverse_mass.map().col(node).head<3>();
  if (mobility.cwiseProduct(normal.cwiseAbs()).maxCoeff() == 0.0) return 0.0;
  return std::max(0.0, normal.dot(plate.point - bag.initial_position.col(node)));
}

// [J] of each element at the start.
std::vector<double> strain_energies(const BagPart& bag) {
  const membrane::BagState state = membrane::make_state(bag.model, bag.initial_position);
  std::vector<double> energies;
  for (int e = 0; e < bag.mesh.element_count(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    const membrane::ElementProperties& fabric = bag.model.description.properties[i];
    energies.push_back(fabric.null_panel
                           ? 0.0
                           : membrane::element_response(bag.model, state, e).response.energy_density *
                                 bag.model.reference_area[i] * fabric.thickness);
  }
  return energies;
}

// [J] What drives the scene: p V at the start or what flows in, or the pressure on a sheet.
double driving_energy(const Scene& scene) {
  const BagPart& bag = *scene.bag;
  if (bag.overpressure) {
    const double area =
        std::accumulate(bag.model.reference_area.begin(), bag.model.reference_area.end(), 0.0);
    return std::max(std::abs(bag.overpressure->maximum()), std::abs(bag.overpressure->minimum())) * area *
           std::sqrt(area);
  }
  const double held =
      scene.gas->initial_pressure * std::abs(mesh::enclosed_volume(bag.initial_position, bag.mesh.elements));
  try {
    return std::max(held, supply_of(scene).work);
  } catch (const gas::DomainError&) {
    return held;  // a stage of the run says why
  }
}

// The elements with most of the energy, by their lines if the mesh has them.
std::string elements_text(const BagPart& bag, const std::vector<double>& energies, double total) {
  std::vector<std::size_t> order(energies.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return energies[a] > energies[b]; });
  constexpr double most = 0.9;
  constexpr std::size_t named = 6;
  std::size_t count = 0;
  for (double sum = 0.0; sum < most * total; ++count) sum += energies[order[count]];
  std::vector<int> names;  // a quad's elements have one line
  for (std::size_t i = 0; i < count && names.size() < named; ++i) {
    const int name = bag.mesh.line.empty() ? static_cast<int>(order[i]) : bag.mesh.line[order[i]];
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return fmt::format("{:.0f} % of it in {} of {} elements ({} {}{}, up to {:.3g} J each)", 100.0 * most,
                     count, energies.size(), bag.mesh.line.empty() ? "from 0:" : "lines",
                     fmt::join(names, ", "), count > named ? ", ..." : "", energies[order.front()]);
}

// A node whose elements have most of the energy is likely to be misplaced.
std::string node_text(const BagPart& bag, const std::vector<double>& energies, double total) {
  std::vector<double> around(static_cast<std::size_t>(bag.mesh.node_count()), 0.0);
  for (int e = 0; e < bag.mesh.element_count(); ++e)
    for (const int node : bag.mesh.elements.col(e))
      around[static_cast<std::size_t>(node)] += energies[static_cast<std::size_t>(e)];
  const auto worst = std::ranges::max_element(around);
  if (*worst < 0.5 * total) return "";
  const auto node = worst - around.begin();
  const Eigen::Vector3d x = bag.initial_position.col(node);
  return fmt::format(", around the node at [{:.3g}, {:.3g}, {:.3g}] m", x.x(), x.y(), x.z());
}

}  // namespace

void require_before_plates(const TableReader& table, const BagPart& bag) {
  const Eigen::Vector3d middle = bag.initial_position.rowwise().mean();
  for (const membrane::Plate& plate : bag.model.description.plates) {
    if (plate.normal.dot(middle - plate.point) < 0.0)
      table.fail("plate", "has the bag behind it, allowed: a normal that points to the bag's side");
    Eigen::Index deepest = 0;
    for (Eigen::Index node = 0; node < bag.initial_position.cols(); ++node)
      if (depth_in_plate(plate, bag, node) > depth_in_plate(plate, bag, deepest)) deepest = node;
    const double reach = depth_in_plate(plate, bag, deepest);
    if (!(reach > file_rounding * longest_extent(bag.initial_position))) continue;
    const Eigen::Vector3d x = bag.initial_position.col(deepest);
    table.fail("plate", fmt::format("reaches {:.3g} m into the bag at the start, at the node [{:.3g}, "
                                    "{:.3g}, {:.3g}] m: move its point by {:.3g} m against its normal",
                                    reach, x.x(), x.y(), x.z(), reach));
  }
}

void warn_of_strained_start(Scene& scene) {
  constexpr double share = 1e-3;
  const BagPart& bag = *scene.bag;
  const std::vector<double> energies = strain_energies(bag);
  const double total = std::accumulate(energies.begin(), energies.end(), 0.0), drive = driving_energy(scene);
  if (!(total > share * drive) || !(drive > 0.0)) return;
  scene.warnings.push_back(
      fmt::format("membrane.mesh: the fabric is strained at the start, with {:.3g} J or {:.2g} % of the "
                  "scene's {:.3g} J: {}{}; a folded start has less, a start from a run under pressure more",
                  total, 100.0 * total / drive, drive, elements_text(bag, energies, total),
                  node_text(bag, energies, total)));
}

}  // namespace driver
