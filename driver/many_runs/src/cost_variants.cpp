// SPDX-License-Identifier: Apache-2.0
// What a case can be run without, to see what it costs.
#include <fmt/format.h>

#include <algorithm>

#include "case_settings.hpp"
#include "jet/visibility.hpp"
#include "many_runs/cost.hpp"

namespace driver {
namespace {

class Variants {
 public:
  Variants(const Scene& scene, const CaseDocument& document, CostResult& result)
      : scene_(scene), case_(document), result_(result) {}

  void jet() {
    if (scene_.jets.empty()) return leave_out(cost_no_jet, "the scene has none");
    if (scene_.target) return leave_out(cost_no_jet, "the scene is nothing else");
    std::vector<std::string> off;
    for (auto& jets : CaseSettings::without_jets(scene_)) off.push_back(std::move(jets));
    add(cost_no_jet, std::move(off));
  }

  void occlusion() {
    std::vector<std::string> off, other;
    std::string name;
    for (const JetPart& jet : scene_.jets) {
      if (!jet.occlusion) continue;
      const bool fast = jet.route == jet::VisibilityRoute::fast;
      name = fast ? "hidden elements by CGAL's tree" : "hidden elements by the fast route";
      case_.set(off, case_.jet_key(jet, "occlusion"), "false");
      case_.unset(off, case_.jet_key(jet, "visibility"));
      case_.set(other, case_.jet_key(jet, "visibility"), fast ? "\"cgal_tree\"" : "\"fast\"");
    }
    if (name.empty()) return leave_out(cost_no_occlusion, "the scene has no jet with that test");
    add(cost_no_occlusion, std::move(off));
    add(name, std::move(other));
  }

  void contact() {
    if (!scene_.contact) return leave_out(cost_no_contact, "the scene has no contact");
    if (scene_.gas && !scene_.gas->contact_sensors.empty())
      return leave_out(cost_no_contact, "a sensor waits for the contact");
    std::vector<std::string> off{
        scene_.pendulum && case_.value("impactor.motion.type").empty() ? "unset pendulum" : "unset impactor",
        "unset contact"};
    case_.unset(off, "output.channel_classes");
    add(cost_no_contact, std::move(off));
  }

  void self_contact() {
    if (scene_.skin_contact) add(cost_no_self_contact, {"unset membrane.self_contact"});
  }

  void gas() {
    if (!scene_.has_volume() || !case_.value("time.gas_step").empty())
      return leave_out("gas to 1e-6", "the scene has no gas that is integrated to a tolerance");
    add("gas to 1e-6", {"time.gas_tolerance=1e-6"});
  }

  void files() {
    add(cost_no_files, {});
    result_.variants.back().writes_files = false;
  }

 private:
  void add(const std::string& name, std::vector<std::string> overrides) {
    result_.variants.push_back({.name = name, .overrides = std::move(overrides)});
  }
  void leave_out(const char* name, const char* reason) {
    result_.left_out.push_back(fmt::format("{}: {}", name, reason));
  }

  const Scene& scene_;
  CaseSettings case_;
  CostResult& result_;
};

}  // namespace

void add_variants(const Scene& scene, const CaseDocument& document, CostResult& result) {
  result.variants.push_back({.name = cost_base});
  Variants variants(scene, document, result);
  variants.jet();
  variants.occlusion();
  variants.contact();
  variants.self_contact();
  variants.gas();
  variants.files();
}

}  // namespace driver
