// SPDX-License-Identifier: Apache-2.0
// Resolutions that a case has, and the overrides that change them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ladder_plan.hpp"

namespace driver {
namespace {

using Overrides = std::vector<std::string>;

// Each from coarse to fine, the case's own in between.
class Resolutions {
 public:
  Resolutions(const Scene& scene, const CaseSettings& settings, LadderPlan& plan)
      : scene_(scene), case_(settings), plan_(plan) {}

  // On a target the mesh does what pieces do.
  void pieces() {
    if (scene_.jets.empty() || !scene_.bag) return;
    int most = 1;
    const auto own = [&](const JetPart& jet) {
      return std::stoi(case_.value(case_.jet_key(jet, "subdivisions")));
    };
    for (const JetPart& jet : scene_.jets) most = std::max(most, own(jet));
    LadderAxis axis{"pieces", AxisKind::halving, {}, 0, 0, true};
    const auto add = [&](auto&& count) {
      LadderChoice choice{fmt::format("pieces {}", count(most)), {}};
      for (const JetPart& jet : scene_.jets)
        case_.set(choice.overrides, case_.jet_key(jet, "subdivisions"), fmt::format("{}", count(own(jet))));
      axis.choices.push_back(std::move(choice));
    };
    if (most > 1) add([](int) { return 1; });
    axis.base = axis.first = axis.choices.size();
    constexpr int allowed = 64;
    for (int factor = 1; factor <= 4 && factor * most <= allowed; factor *= 2)
      add([factor](int n) { return factor * n; });
    plan_.axes.push_back(std::move(axis));
  }

  void mesh() {
    if (scene_.target) return target_mesh();
    if (!scene_.bag) return;
    const bool sphere = case_.value("membrane.mesh.generator") == "\"icosphere\"";
    const std::string key = sphere ? "membrane.mesh.levels" : "membrane.mesh.refine";
    const int own = std::stoi(case_.value(key)), low = sphere ? 1 : 0, high = sphere ? 8 : 6;
    LadderAxis axis{"mesh", AxisKind::halving, {}, 0, 0};
    for (int level = std::max(low, own - 1); level <= std::min(own + plan_.finer, high); ++level) {
      if (level > own && !layers_fit(level - own)) {
        plan_.left_out.emplace_back("finer meshes: membrane.self_contact.thickness is above their elements");
        break;
      }
      LadderChoice choice{fmt::format("mesh {} {}", sphere ? "levels" : "refine", level), {}};
      if (level == own) axis.base = axis.choices.size();
      if (level != own) {
        case_.set(choice.overrides, key, fmt::format("{}", level));
        keep_stiffness(choice.overrides);
      }
      axis.choices.push_back(std::move(choice));
    }
    plan_.axes.push_back(std::move(axis));
  }

  // By halves from the case's own; the cheaper choice is twice a fixed step, or 0.95 of the bound.
  void step() {
    if (!scene_.moves()) return;
    const bool fixed = scene_.time.step.has_value();
    const std::string key = fixed ? "time.step" : "time.safety";
    const double own = fixed ? *scene_.time.step : scene_.time.safety;
    constexpr double largest_share = 0.95, least_share = 1e-3;
    LadderAxis axis{"step", AxisKind::halving, {}, 0, 0, !fixed};
    const auto add = [&](double value) {
      LadderChoice choice{fmt::format("step {:g}", value), {}};
      if (value != own) choice.overrides.push_back(fmt::format("{}={}", key, value));
      axis.choices.push_back(std::move(choice));
    };
    if (fixed) add(2.0 * own);
    if (!fixed && own < largest_share) add(largest_share);
    axis.base = axis.choices.size();
    axis.first = fixed ? 0 : axis.base;
    for (double value = own; value >= own / 4.0 && (fixed || value >= least_share); value /= 2.0) add(value);
    plan_.axes.push_back(std::move(axis));
  }

  void gas() {
    if (!scene_.has_volume()) return;
    const auto& options = scene_.gas->integrator;
    LadderAxis axis{"gas", options.fixed_step > 0.0 ? AxisKind::halving : AxisKind::tightening, {}, 0, 0};
    const auto add = [&](const std::string& name, Overrides overrides) {
      axis.choices.push_back({"gas " + name, std::move(overrides)});
    };
    if (axis.kind == AxisKind::halving) {
      for (const double factor : {2.0, 1.0, 0.5, 0.25})
        add(fmt::format("step {:g}", factor * options.fixed_step),
            factor == 1.0 ? Overrides{}
                          : Overrides{fmt::format("time.gas_step={}", factor * options.fixed_step)});
      axis.base = 1;
    } else {
      tolerances(options, axis, add);
    }
    plan_.axes.push_back(std::move(axis));
  }

 private:
  // The thickness of layers may be as large as the smallest altitude of an element, which halves with each
  // level; on a sphere a little more.
  bool layers_fit(int levels) const {
    if (!scene_.skin_contact) return true;
    constexpr double of_sphere = 0.9;
    const mesh::Mesh& mesh = scene_.bag->mesh;
    const double smallest = mesh::element_quality(mesh.nodes, mesh.elements).min_altitude;
    return scene_.skin_contact->parameters().thickness <= of_sphere * std::ldexp(smallest, -levels);
  }

  // Defaults that follow the elements' size would make another scene of a finer mesh.
  void keep_stiffness(Overrides& overrides) const {
    const auto& plates = scene_.bag->model.description.plates;
    if (!plates.empty() && !case_.has("membrane.plate.stiffness"))
      overrides.push_back(fmt::format("membrane.plate.stiffness={}", *plates.front().stiffness));
    if (scene_.contact && !case_.has("contact.stiffness")) {
      case_.unset(overrides, "contact.stiffness_share");
      overrides.push_back(fmt::format("contact.stiffness={}", scene_.contact->parameters().stiffness));
    }
    if (scene_.skin_contact && !case_.has("membrane.self_contact.stiffness")) {
      case_.unset(overrides, "membrane.self_contact.stiffness_share");
      overrides.push_back(
          fmt::format("membrane.self_contact.stiffness={}", scene_.skin_contact->parameters().stiffness));
    }
  }

  void target_mesh() {
    const int columns = std::stoi(case_.value("target.columns")),
              rows = std::stoi(case_.value("target.rows"));
    LadderAxis axis{"mesh", AxisKind::halving, {}, 0, 0};
    const auto add = [&](int c, int r) {
      LadderChoice choice{fmt::format("mesh {} x {}", c, r), {}};
      case_.set(choice.overrides, "target.columns", fmt::format("{}", c));
      case_.set(choice.overrides, "target.rows", fmt::format("{}", r));
      axis.choices.push_back(std::move(choice));
    };
    if (columns % 2 == 0 && rows % 2 == 0) add(columns / 2, rows / 2);
    axis.base = axis.choices.size();
    constexpr int allowed = 2000;
    for (int factor = 1; factor <= 1 << plan_.finer && factor * std::max(columns, rows) <= allowed;
         factor *= 2)
      add(factor * columns, factor * rows);
    plan_.axes.push_back(std::move(axis));
  }

  template <class Add>
  void tolerances(const gas::IntegratorOptions& options, LadderAxis& axis, Add&& add) {
    const double own = options.relative_tolerance;
    constexpr double tightest = 1e-13, implicit = 1e-6;
    const auto text = [](double tolerance) { return fmt::format("time.gas_tolerance={:g}", tolerance); };
    for (const double coarse : {1e-3, implicit})
      if (own < coarse) add(fmt::format("tolerance {:g}", coarse), {text(coarse)});
    if (!scene_.bag && options.method != gas::Method::rosenbrock_4 && own < implicit)
      add("rosenbrock", {"time.gas_method=\"rosenbrock\"", text(implicit)});
    axis.base = axis.first = axis.choices.size();
    add(fmt::format("tolerance {:g}", own), {});
    if (own > tightest) {
      const double finer = std::max(tightest, own / 100.0);
      add(fmt::format("tolerance {:g}", finer), {text(finer)});
    }
  }

  const Scene& scene_;
  const CaseSettings& case_;
  LadderPlan& plan_;
};

}  // namespace

void add_resolutions(const Scene& scene, const CaseSettings& settings, LadderPlan& plan) {
  Resolutions resolutions(scene, settings, plan);
  resolutions.pieces();
  resolutions.mesh();
  resolutions.step();
  resolutions.gas();
}

}  // namespace driver
