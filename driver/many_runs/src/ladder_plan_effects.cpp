// SPDX-License-Identifier: Apache-2.0
// Effects that a case names, and the overrides that change them.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "ladder_plan.hpp"
#include "membrane/law_table.hpp"

namespace driver {
namespace {

using Overrides = std::vector<std::string>;
using Choices = std::vector<LadderChoice>;

// Each from the cheapest way to treat it to the truest, which is the base.
class Effects {
 public:
  Effects(const Scene& scene, const CaseSettings& settings, LadderPlan& plan)
      : scene_(scene), case_(settings), plan_(plan) {}

  void jet() {
    if (scene_.jets.empty() || !scene_.bag) return;
    Overrides off;
    for (auto& jets : CaseSettings::without_jets(scene_)) off.push_back(std::move(jets));
    effect("jet", {{"jet off", off}, {"jet on", {}}});
  }

  void occlusion() {
    if (scene_.jets.empty()) return;
    LadderChoice off{"occlusion off", {}}, on{"occlusion on", {}};
    for (const JetPart& jet : scene_.jets) {
      case_.set(off.overrides, case_.jet_key(jet, "occlusion"), "false");
      case_.set(on.overrides, case_.jet_key(jet, "occlusion"), "true");
    }
    effect("occlusion", {off, on});
  }

  // An outlet at the bag's pressure counts the inflator's temperature as that of the gas at rest. One that
  // expands is truer than both, and stays.
  void outlet() {
    if (scene_.jets.empty() || expands()) return;
    LadderChoice sonic{"outlet sonic", {}}, matched{"outlet pressure_matched", {}};
    for (const JetPart& jet : scene_.jets) {
      case_.set(sonic.overrides, case_.jet_key(jet, "outlet"), "\"sonic\"");
      case_.set(matched.overrides, case_.jet_key(jet, "outlet"), "\"pressure_matched\"");
      case_.set(matched.overrides, case_.jet_key(jet, "temperature"), "\"stagnation\"");
    }
    effect("outlet", {sonic, matched});
  }

  void heat_capacity() {
    if (!scene_.gas) return;
    for (std::size_t i = 0; case_.has(fmt::format("gas.species.{}", i)); ++i)
      if (case_.has(fmt::format("gas.species.{}.cp", i))) {
        plan_.left_out.emplace_back("cp: the case has a species of its own, whose cp is constant");
        return;
      }
    LadderChoice constant{"cp constant", {}}, nasa{"cp nasa7", {}};
    case_.set(constant.overrides, "gas.thermodynamics", "\"constant\"");
    case_.set(nasa.overrides, "gas.thermodynamics", "\"nasa7\"");
    if (!nasa.overrides.empty()) case_.unset(nasa.overrides, "gas.reference_temperature");
    effect("cp", {constant, nasa});
  }

  void porosity() {
    LadderChoice off{"porosity off", {}};
    if (scene_.gas && scene_.gas->tank_leak_area > 0.0) {
      case_.unset(off.overrides, "tank.fabric");
    } else if (scene_.bag && scene_.bag->leak_law != LeakLaw::none && bag_leaks()) {
      case_.set(off.overrides, "fabric.leak_law", "\"none\"");
      case_.unset(off.overrides, "fabric.velocity");
    } else {
      return;
    }
    effect("porosity", {off, {"porosity on", {}}});
  }

  void compression() {
    if (!scene_.bag) return;
    if (!membrane::law_named(scene_.bag->model.description.law).compression) return;  // never carries it
    LadderChoice linear{"compression linear", {}}, none{"compression none", {}};
    case_.set(linear.overrides, "fabric.compression", "\"linear\"");
    case_.set(none.overrides, "fabric.compression", "\"none\"");
    effect("compression", {linear, none});
  }

  void self_contact() {
    if (!scene_.skin_contact) return;
    effect("self_contact", {{"self-contact off", {"unset membrane.self_contact"}}, {"self-contact on", {}}});
  }

  // What nobody knows of a jet (docs/theory/jet_push.md).
  void jet_assumptions() {
    if (scene_.jets.empty() || !scene_.bag) return;
    reflection();
    expansion();
    direction();
  }

 private:
  void reflection() {
    Choices choices{{"restitution of the case", {}}};
    for (const double value : {1.0, 0.3, 0.0}) {
      LadderChoice other{fmt::format("restitution {:.1f}", value), {}};
      for (const JetPart& jet : scene_.jets)
        if (jet.restitution || jet.field.model().restitution != value)
          other.overrides.push_back(fmt::format("{}={:.1f}", case_.jet_key(jet, "restitution"), value));
      if (!other.overrides.empty()) choices.push_back(std::move(other));
    }
    assumption("reflection", std::move(choices));
  }

  void expansion() {
    if (expands()) return;
    LadderChoice expanded{"outlet expanded", {}};
    for (const JetPart& jet : scene_.jets) {
      if (jet.field.model().spread == jet::Spread::cone) {
        plan_.left_out.emplace_back("expansion: a cone does not have the outlet's momentum");
        return;
      }
      case_.set(expanded.overrides, case_.jet_key(jet, "outlet"), "\"expanded\"");
      case_.set(expanded.overrides, case_.jet_key(jet, "temperature"), "\"stagnation\"");
    }
    assumption("expansion", {{"outlet of the case", {}}, std::move(expanded)});
  }

  // An axis 5 degrees off to either side. The outlet goes ahead as far as its rim would go back.
  void direction() {
    Choices choices{{"axis of the case", {}}};
    for (const double side : {1.0, -1.0}) {
      LadderChoice off{side > 0.0 ? "axis 5 degrees to one side" : "axis 5 degrees to the other side", {}};
      for (const JetPart& jet : scene_.jets) turn(jet.field.model(), jet, side, off.overrides);
      choices.push_back(std::move(off));
    }
    assumption("direction", std::move(choices));
  }

  void turn(const jet::JetModel& model, const JetPart& jet, double side, Overrides& overrides) const {
    constexpr double sine = 0.08715574274765817, cosine = 0.9961946980917455, beyond = 1.02;
    const bool round = model.shape == jet::OutletShape::round;
    const Eigen::Vector3d across =
        round ? model.axis.unitOrthogonal() : model.axis.cross(model.long_direction).eval();
    const double rim = round ? model.radius : 0.5 * model.short_side;
    set_vector(jet, "axis", cosine * model.axis + side * sine * across, overrides);
    set_vector(jet, "centre", model.centre + beyond * sine * rim * model.axis, overrides);
  }

  void set_vector(const JetPart& jet, const char* key, const Eigen::Vector3d& v, Overrides& overrides) const {
    case_.set(overrides, case_.jet_key(jet, key), fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()));
  }

  bool expands() const {
    return std::ranges::any_of(scene_.jets,
                               [](const JetPart& jet) { return jet.outlet.law == jet::OutletLaw::expanded; });
  }

  void assumption(const char* name, Choices choices) {
    if (choices.size() > 1) plan_.axes.push_back({name, AxisKind::model, std::move(choices), 0, 0});
  }

  void effect(const char* name, Choices choices) {
    const std::size_t base = choices.size() - 1;
    plan_.axes.push_back({name, AxisKind::effect, std::move(choices), base, base});
  }

  bool bag_leaks() const {
    const auto& fabric = scene_.bag->model.description.properties;
    return std::any_of(fabric.begin(), fabric.end(), [](const auto& f) { return f.porosity > 0.0; });
  }

  const Scene& scene_;
  const CaseSettings& case_;
  LadderPlan& plan_;
};

}  // namespace

void add_effects(const Scene& scene, const CaseSettings& settings, LadderPlan& plan) {
  Effects effects(scene, settings, plan);
  effects.jet();
  effects.occlusion();
  effects.outlet();
  effects.heat_capacity();
  effects.porosity();
  effects.compression();
  effects.self_contact();
  effects.jet_assumptions();
}

}  // namespace driver
