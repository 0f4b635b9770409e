// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "forecast/bag_volume.hpp"
#include "ladder/parts.hpp"
#include "results/load_scene.hpp"

namespace driver {
namespace {

std::string text_of(const gas::Curve& curve) {
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
                     law == LeakLaw::table ? fmt::format("leak_law=\"table\", velocity={}",
                                                         text_of(*scene.gas->model.fabrics.front().velocity))
                                           : "porosity=1");
}

std::vector<std::string> without_membrane(const Scene& scene, const CaseSettings& settings) {
  std::vector<std::string> list;
  if (auto fabric = tank_fabric(scene); !fabric.empty()) list.push_back(std::move(fabric));
  for (const char* key :
       {"membrane", "fabric", "pendulum", "scene.gravity", "time.safety", "time.step", "time.unsafe_step",
        "output.fields_every", "output.frames", "output.channel_classes"})
    settings.unset(list, key);
  if (scene.contact) list.emplace_back("unset contact");
  for (const JetPart& jet : scene.jets) list.push_back(fmt::format("unset inflator.{}.jet", jet.inflator));
  return list;
}

LadderChoice with_volume(const LadderPlan& plan, const char* name, const std::string& volume) {
  LadderChoice choice{name, *plan.no_membrane};
  choice.overrides.push_back("tank.volume=" + volume);
  return choice;
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

std::string CaseSettings::value(const std::string& path) const {
  for (const Setting& setting : settings_)
    if (setting.path == path) return setting.value;
  return {};
}

bool CaseSettings::has(const std::string& path) const {
  return std::any_of(settings_.begin(), settings_.end(), [&](const Setting& s) {
    return !s.is_default && (s.path == path || s.path.starts_with(path + '.'));
  });
}

void CaseSettings::set(std::vector<std::string>& overrides, const std::string& path,
                       const std::string& value) const {
  if (this->value(path) != value) overrides.push_back(path + '=' + value);
}

void CaseSettings::unset(std::vector<std::string>& overrides, const std::string& path) const {
  if (has(path)) overrides.push_back(std::string(unset_prefix) + path);
}

std::string CaseSettings::jet_key(const JetPart& jet, const char* key) {
  return fmt::format("inflator.{}.jet.{}", jet.inflator, key);
}

std::optional<LadderChoice> rigid_tank(LadderPlan& plan) {
  constexpr const char* name = "rigid tank";
  if (plan.design_volume > 0.0) return with_volume(plan, name, fmt::format("{}", plan.design_volume));
  plan.left_out.push_back(fmt::format("{}: the design shape is flat", name));
  return {};
}

std::optional<LadderChoice> bag_by_volume(const std::filesystem::path& file,
                                          const std::vector<std::string>& overrides, bool quiet,
                                          LadderPlan& plan, Journal& journal) {
  constexpr const char* name = "volume by pressure";
  if (const auto* before = journal.find(name); before && before->is_string())
    return with_volume(plan, name, before->get<std::string>());
  try {
    CaseDocument document(file, overrides);
    const auto volume = bag_volume(load_scene(document), quiet);
    if (!volume) return {};
    const std::string text = text_of(*volume);
    journal.add(name, nlohmann::json(text).dump());
    return with_volume(plan, name, text);
  } catch (const std::runtime_error& error) {
    plan.left_out.push_back(fmt::format("{}: {}", name, error.what()));
    return {};
  }
}

void add_no_membrane(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const Scene& scene, const CaseSettings& settings, const std::string& quantity,
                     LadderPlan& plan) {
  try {
    plan.design_volume = design_volume(*scene.bag);
    plan.no_membrane = without_membrane(scene, settings);
    auto all = overrides;
    const auto any = with_volume(plan, "of any volume", "1").overrides;
    all.insert(all.end(), any.begin(), any.end());
    CaseDocument document(file, all);
    if (const Scene tank = load_scene(document); !has_quantity(tank, quantity))
      throw CaseError(fmt::format("a volume of gas alone has no {}", quantity));
  } catch (const CaseError& error) {
    plan.no_membrane.reset();
    plan.left_out.push_back(fmt::format("without membrane: {}", error.what()));
  }
}

}  // namespace driver
