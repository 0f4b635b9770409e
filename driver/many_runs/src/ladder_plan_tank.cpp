// SPDX-License-Identifier: Apache-2.0
// The gas of a bag without its membrane.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <elementary/exponential.hpp>

#include "forecast/bag_volume.hpp"
#include "ladder_plan.hpp"
#include "many_runs/quantities.hpp"

namespace driver {
namespace {

std::string curve_text(const gas::Curve& curve) {
  std::vector<double> overpressure, value;
  for (const gas::Curve::Knot& knot : curve.knots()) {
    overpressure.push_back(knot.time);
    value.push_back(knot.value);
  }
  return fmt::format("{{overpressure={}, value={}}}", overpressure, value);
}

// The skin's leak with each element's area as it is cut, panel by panel; empty: none.
std::string tank_fabric(const Scene& scene) {
  const LeakLaw law = scene.bag->leak_law;
  const auto& model = scene.bag->model;
  double area = 0.0;
  for (std::size_t e = 0; e < model.reference_area.size(); ++e) {
    const auto& fabric = model.description.properties[e];
    if (fabric.null_panel || law == LeakLaw::none) continue;
    area += model.reference_area[e] * fabric.porosity * (law == LeakLaw::printed ? fabric.porosity : 1.0);
  }
  if (area == 0.0) return {};
  return fmt::format("tank.fabric={{area={}, {}}}", area,
                     law == LeakLaw::table
                         ? fmt::format("leak_law=\"table\", velocity={}",
                                       curve_text(*scene.gas->model.fabrics.front().velocity))
                         : "porosity=1");
}

std::vector<std::string> taken_out(const Scene& scene, const CaseSettings& settings) {
  std::vector<std::string> list;
  if (auto fabric = tank_fabric(scene); !fabric.empty()) list.push_back(std::move(fabric));
  for (const char* key :
       {"membrane", "fabric", "pendulum", "impactor", "scene.gravity", "time.safety", "time.step",
        "time.unsafe_step", "output.fields_every", "output.frames", "output.channel_classes"})
    settings.unset(list, key);
  if (scene.contact) list.emplace_back("unset contact");
  for (auto& jets : CaseSettings::without_jets(scene)) list.push_back(std::move(jets));
  return list;
}

// Of the shape as sewn; what rounding leaves of a flat one counts for nothing.
double design_volume(const BagPart& bag) {
  double area = 0.0;
  for (const double a : bag.model.reference_area) area += a;
  constexpr double flat = 1e-9;  // of a volume of that area: far more than the roundings of a sum
  const double volume = mesh::enclosed_volume(bag.mesh.nodes, bag.mesh.elements);
  return volume > flat * elementary::pow(area, 1.5) ? volume : 0.0;
}

}  // namespace

std::vector<std::string> without_membrane(const LadderPlan& plan, const std::string& volume) {
  return joined(*plan.no_membrane, {"tank.volume=" + volume});
}

std::optional<std::string> bag_by_volume(const std::filesystem::path& file,
                                         const std::vector<std::string>& overrides, bool quiet,
                                         LadderPlan& plan) {
  try {
    const auto volume = bag_volume(load_variant(file, overrides, {}), quiet);
    return volume ? std::optional(curve_text(*volume)) : std::nullopt;
  } catch (const std::runtime_error& error) {
    plan.left_out.push_back(fmt::format("volume by pressure: {}", error.what()));
    return {};
  }
}

void add_no_membrane(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const Scene& scene, const CaseSettings& settings, const std::string& quantity,
                     LadderPlan& plan) {
  try {
    plan.design_volume = design_volume(*scene.bag);
    plan.no_membrane = taken_out(scene, settings);
    if (const Scene tank = load_variant(file, overrides, without_membrane(plan, "1"));
        !has_quantity(tank, quantity))
      throw CaseError(fmt::format("a volume of gas alone has no {}", quantity));
  } catch (const CaseError& error) {
    plan.no_membrane.reset();
    plan.left_out.push_back(fmt::format("without membrane: {}", error.what()));
  }
}

}  // namespace driver
