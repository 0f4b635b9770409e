// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bag_volume.hpp"
#include "ladder_parts.hpp"

namespace driver {
namespace {

// Area of the fabric as it is cut.
double fabric_area(const BagPart& bag) {
  double area = 0.0;
  for (std::size_t e = 0; e < bag.model.reference_area.size(); ++e)
    if (!bag.model.description.properties[e].null_panel) area += bag.model.reference_area[e];
  return area;
}

// A leak of one porosity by a law that a tank has too; empty: none needed.
std::string tank_fabric(const Scene& scene, const CaseSettings& settings) {
  const auto& fabric = scene.bag->model.description.properties;
  const double porosity = std::max_element(fabric.begin(), fabric.end(), [](const auto& a, const auto& b) {
                            return a.porosity < b.porosity;
                          })->porosity;
  const LeakLaw law = scene.bag->leak_law;
  if (law == LeakLaw::none || porosity == 0.0) return {};
  if (law == LeakLaw::table || settings.has("fabric.panel"))
    throw CaseError("its fabric leaks by a table or by panels");
  return fmt::format("tank.fabric={{area={}, porosity={}, leak_law={}}}", fabric_area(*scene.bag), porosity,
                     settings.value("fabric.leak_law"));
}

std::vector<std::string> tank_overrides(const Scene& scene, const CaseSettings& settings) {
  std::vector<std::string> list;
  if (auto fabric = tank_fabric(scene, settings); !fabric.empty()) list.push_back(std::move(fabric));
  for (const char* key : {"membrane", "fabric", "pendulum", "scene.gravity", "time.safety", "time.step",
                          "time.unsafe_dt", "output.fields_every"})
    settings.unset(list, key);
  if (scene.contact) list.emplace_back("unset contact");
  for (const JetPart& jet : scene.jets) list.push_back(fmt::format("unset inflator.{}.jet", jet.inflator));
  const double volume = membrane::enclosed_volume(scene.bag->mesh.nodes, scene.bag->mesh.elements);
  list.push_back(fmt::format("tank.volume={}", volume));
  return list;
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

std::optional<LadderChoice> bag_by_volume(const std::filesystem::path& file,
                                          const std::vector<std::string>& overrides, bool quiet,
                                          LadderPlan& plan) {
  LadderChoice bag{"volume by pressure", plan.tank->overrides};
  try {
    CaseDocument document(file, overrides);
    const gas::Curve volume = bag_volume(read_scene(document), quiet);
    std::vector<double> overpressure, value;
    for (const gas::Curve::Knot& knot : volume.knots()) {
      overpressure.push_back(knot.time);
      value.push_back(knot.value);
    }
    bag.overrides.back() = fmt::format("tank.volume={{overpressure={}, value={}}}", overpressure, value);
    return bag;
  } catch (const std::runtime_error& error) {
    plan.left_out.push_back(fmt::format("{}: {}", bag.name, error.what()));
    return {};
  }
}

void add_tank(const std::filesystem::path& file, const std::vector<std::string>& overrides,
              const Scene& scene, const CaseSettings& settings, const std::string& quantity,
              LadderPlan& plan) {
  try {
    LadderChoice tank{"rigid tank", tank_overrides(scene, settings)};
    auto all = overrides;
    all.insert(all.end(), tank.overrides.begin(), tank.overrides.end());
    CaseDocument document(file, all);
    quantity_name(read_scene(document), quantity);
    plan.tank = std::move(tank);
  } catch (const CaseError& error) {
    plan.left_out.push_back(fmt::format("rigid tank: {}", error.what()));
  }
}

}  // namespace driver
