// SPDX-License-Identifier: Apache-2.0
#include "forecast/bag_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <stdexcept>

#include "base/progress.hpp"
#include "engine/step.hpp"
#include "forecast/full_state.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"

namespace driver {
namespace {

constexpr double first_overpressure =
    100.0;  // [Pa] a thousandth of the ambient one: a limp bag is open by then
constexpr double factor = 2.0;
constexpr double at_rest = 1e-5;    // kinetic energy divided by p V
constexpr double settled = 1e-4;    // relative change of the volume within a span
constexpr double step_share = 0.9;  // share of the critical step
constexpr int most_spans = 200;

/// The bag under a prescribed overpressure p. In a span of sqrt(m / (p sqrt(A))) the pressure moves the skin
/// by about its own size; the damping rate is one over the span.
class BagAtRest {
 public:
  explicit BagAtRest(const Scene& scene)
      : model_(scene.bag->model), state_(membrane::make_state(model_, scene.bag->initial_position)) {
    model_.description.gravity.setZero();
    membrane::update_skin(model_, state_);
    for (const double mass : model_.node_mass) mass_ += mass;
    for (const double area : model_.reference_area) area_ += area;
  }

  double volume() const { return state_.surface.volume; }

  double volume_at(double overpressure) {
    const double span = std::sqrt(mass_ / (overpressure * std::sqrt(area_)));
    model_.description.mass_damping = 1.0 / span;
    for (int i = 0; i < most_spans && !interrupted(); ++i) {
      const double before = volume(), kinetic = move(overpressure, span);
      if (kinetic <= at_rest * overpressure * volume() && std::abs(volume() - before) <= settled * volume())
        return volume();
    }
    if (interrupted()) return volume();
    throw std::runtime_error(fmt::format("the bag does not come to rest at {:.3g} Pa", overpressure));
  }

 private:
  /// Returns the kinetic energy [J] after `span` [s].
  double move(double overpressure, double span) {
    double kinetic = 0.0;
    for (double time = 0.0; time < span;) {
      membrane::pressure_forces(state_, overpressure);
      membrane::support_forces(model_, state_);
      const double next =
          step_share * membrane::critical_time_step(membrane::stiffness_shares(model_, state_, 0.0, 0.0));
      kinetic = membrane::advance(model_, state_, step_, next).kinetic_after;
      membrane::update_skin(model_, state_);
      time += step_ = next;
    }
    return kinetic;
  }

  membrane::BagModel model_;
  membrane::BagState state_;
  double mass_ = 0.0, area_ = 0.0, step_ = 0.0;
};

}  // namespace

std::optional<gas::Curve> bag_volume(const Scene& scene, bool quiet) {
  const State start = state_at_start(scene);
  const double highest = full_state(scene, start, supply_of(scene)).closed_pressure - scene.ambient.pressure;
  BagAtRest bag(scene);
  std::vector<gas::Curve::Knot> knots{{0.0, bag.volume()}};
  const double factors =
      std::ceil(elementary::log(std::max(highest / first_overpressure, 1.0)) / elementary::log(factor));
  Progress progress(scene.name + ", bag at rest", factors + 1.0, quiet);
  for (double i = 0.0; i <= factors && !interrupted(); ++i) {
    // Wrinkles settle in different ways: no volume counts as less than the volume at a lower pressure.
    const double overpressure = first_overpressure * elementary::pow(factor, i);
    knots.push_back({overpressure, std::max(bag.volume_at(overpressure), knots.back().value)});
    progress.update(i + 1.0);
  }
  if (interrupted()) return {};
  return gas::Curve(std::move(knots), gas::Outside::held);
}

}  // namespace driver
