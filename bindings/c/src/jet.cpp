// SPDX-License-Identifier: Apache-2.0
#include "jet/jet.hpp"

#include <gasjet/jet.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "jet_object.hpp"

using namespace border;

namespace {

/// Refuses sizes that the shape does not use.
void check_sizes(const gasjet_jet_model& given) {
  const bool round = !std::isnan(given.radius);
  const bool sides = !std::isnan(given.short_side) || !std::isnan(given.long_side);
  const bool cone = !std::isnan(given.cone_initial_width);
  if (!round && !sides) refuse("radius", "is not given, allowed: radius, or short_side and long_side");
  if (round && sides)
    refuse("radius", "is given with short_side or long_side, allowed: radius, or short_side and long_side");
  if (!cone && !std::isnan(given.cone_half_angle))
    refuse("cone_half_angle", "is given without cone_initial_width, allowed: both, or neither");
}

jet::JetModel model_of(const gasjet_jet_model* pointer) {
  const gasjet_jet_model& given = needed(pointer, "model");
  check_sizes(given);
  jet::JetModel model;
  model.shape = std::isnan(given.radius) ? jet::OutletShape::rectangular : jet::OutletShape::round;
  model.centre = Eigen::Map<const Eigen::Vector3d>(given.centre);
  model.axis = Eigen::Map<const Eigen::Vector3d>(given.axis);
  model.long_direction = Eigen::Map<const Eigen::Vector3d>(given.long_direction);
  model.radius = given.radius;
  model.short_side = given.short_side;
  model.long_side = given.long_side;
  model.decay_coefficient = given.decay_coefficient;
  model.spread = std::isnan(given.cone_initial_width) ? jet::Spread::momentum : jet::Spread::cone;
  model.cone_initial_width = given.cone_initial_width;
  model.cone_half_angle = given.cone_half_angle;
  model.direction = given.radial != 0 ? jet::Direction::radial : jet::Direction::axial;
  model.restitution = given.restitution;
  model.cut_off = given.cut_off;
  return jet::validated(model);
}

// Long side of an outlet that turns from one axis to another: as given, or turned with it.
Eigen::Vector3d turned(const jet::JetModel& model, const Eigen::Vector3d& axis, const double* given) {
  if (given == nullptr) return Eigen::Quaterniond::FromTwoVectors(model.axis, axis) * model.long_direction;
  const Eigen::Vector3d along = vector_of(given, "long_direction");
  const double cosine = along.dot(axis) / (along.norm() * axis.norm());
  if (!(std::abs(cosine) <= 1e-9))
    refuse("long_direction", "is not normal to the axis, allowed: a cosine of at most 1e-9 between them");
  return along;
}

/// Rest of a call, once its arrays of vectors are known.
struct Rest {
  double velocity, density;
  int occlusion;
  double displacement_bound;
  const int32_t* elements;
  int64_t element_count;
  double* overpressure;
  int64_t overpressure_count;
  double* force;
  double* power;
  gasjet_visibility* counters;
};

std::optional<std::span<const int>> elements_of(const Jet& jet, const int32_t* elements, int64_t count) {
  if (elements == nullptr && count == 0) return {};
  static_assert(std::is_same_v<int32_t, int>);
  const auto asked = static_cast<std::size_t>(count_of(count, "element_count"));
  needed(elements, "elements");
  const std::span<const int> list(elements, asked);
  const auto below = jet.skin.triangles.cols();
  for (const int element : list)
    if (element < 0 || element >= below)
      refuse("elements",
             "has the number " + std::to_string(element) + ", allowed: 0 to " + std::to_string(below - 1));
  return list;
}

void check_velocities(const Jet& jet, const Points::View* velocities, const double* power) {
  if (velocities != nullptr) return;
  if (power != nullptr) refuse("power", "is asked for without velocities, allowed: NULL, or velocities");
  if (jet.model().relative_to_skin)
    refuse("velocities",
           "are missing, needed: those of the nodes, after gasjet_jet_relative_to_skin, "
           "by gasjet_jet_pressure_of");
}

void press(Jet& jet, const Points& nodes, const Points* velocities, const Rest& rest) {
  JetCall call;
  call.nodes = &nodes.view();
  if (velocities != nullptr) call.velocities = &velocities->view();
  call.elements = elements_of(jet, rest.elements, rest.element_count);
  const int64_t wanted =
      call.elements ? static_cast<int64_t>(call.elements->size()) : jet.skin.triangles.cols();
  const auto out = output(rest.overpressure, rest.overpressure_count, wanted, "overpressure");
  needed(rest.force, "force");
  if (rest.power != nullptr) needed(rest.power, "power");
  check_velocities(jet, call.velocities, rest.power);
  call.displacement_bound = bound_of(rest.displacement_bound);
  call.outlet = {number(rest.velocity, "velocity", 0.0), number(rest.density, "density", 0.0)};
  call.outlet.area_ratio = jet.area_ratio;
  call.outlet.reflected = jet.reflected;
  call.occlusion = rest.occlusion != 0;
  const JetLoad load = jet.load(call, out);
  write_vector(load.force, rest.force);
  if (rest.power != nullptr) *rest.power = load.power;
  write_counters(load.counters, rest.counters);
}

}  // namespace

int gasjet_jet_defaults(gasjet_jet_model* model) {
  return call([&] {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const jet::JetModel defaults;
    needed(model, "model") = {
        {nan, nan, nan},      {nan, nan, nan},  nan, nan, nan, {nan, nan, nan}, nan, nan, nan,
        defaults.restitution, defaults.cut_off, 0};
  });
}

int gasjet_jet_create(const gasjet_jet_model* model, const int32_t triangles[], int64_t triangle_count,
                      const int64_t triangle_stride[], int64_t node_count, const int32_t null_elements[],
                      int64_t null_count, const int32_t attachment_elements[], int64_t attachment_count,
                      gasjet_handle* jet) {
  return call([&] {
    needed(jet, "jet");
    const auto checked = model_of(model);
    *jet = keep(std::make_shared<Jet>(
        checked, Skin(triangles, triangle_count, triangle_stride, node_count, null_elements, null_count,
                      attachment_elements, attachment_count)));
  });
}

int gasjet_jet_expansion(gasjet_handle jet, double area_ratio, double reflected, double restitution) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    positive(area_ratio, "area_ratio");
    if (positive(reflected, "reflected") > 1.0)
      refuse("reflected", "is " + shown(reflected) + ", allowed: above 0, at most 1");
    if (restitution < -0.5 || restitution > 4.0)
      refuse("restitution", "is " + shown(restitution) + ", allowed: -0.5 to 4, NaN to keep it");
    if (!std::isnan(restitution)) use->restitution = restitution;
    use->area_ratio = area_ratio;
    use->reflected = reflected;
  });
}

int gasjet_jet_place(gasjet_handle jet, const double centre[3], const double axis[3],
                     const double long_direction[3]) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    const Eigen::Vector3d at = vector_of(centre, "centre"), along = vector_of(axis, "axis");
    if (!(along.norm() > 0.0)) refuse("axis", "is zero, allowed: any other length");
    const bool round = use->model().shape == jet::OutletShape::round;
    use->place(at, along, round ? use->model().long_direction : turned(use->model(), along, long_direction));
  });
}

int gasjet_jet_set_elements(gasjet_handle jet, const uint8_t on[], int64_t on_count) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    needed(on, "on");
    require_count(on_count, use->skin.triangles.cols(), "on");
    use->set_elements({on, static_cast<std::size_t>(on_count)});
  });
}

int gasjet_jet_subdivide(gasjet_handle jet, int n) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    if (n < 1 || n > 64) refuse("n", "is " + std::to_string(n) + ", allowed: 1 to 64");
    use->subdivide(n);
  });
}

int gasjet_jet_relative_to_skin(gasjet_handle jet, int relative) {
  return call([&] { Use<Jet>(jet, "jet")->set_relative(relative != 0); });
}

int gasjet_jet_pressure(gasjet_handle jet, const double nodes[], int64_t node_count,
                        const int64_t node_stride[], double velocity, double density, int occlusion,
                        double displacement_bound, double overpressure[], int64_t overpressure_count,
                        double force[3], gasjet_visibility* counters) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    const Points points = use->skin.points(nodes, node_count, node_stride, true);
    press(*use, points, nullptr,
          {velocity, density, occlusion, displacement_bound, nullptr, 0, overpressure, overpressure_count,
           force, nullptr, counters});
  });
}

int gasjet_jet_pressure_of(gasjet_handle jet, const double nodes[], int64_t node_count,
                           const int64_t node_stride[], const double velocities[],
                           const int64_t velocity_stride[], double velocity, double density, int occlusion,
                           double displacement_bound, const int32_t elements[], int64_t element_count,
                           double overpressure[], int64_t overpressure_count, double force[3], double* power,
                           gasjet_visibility* counters) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    const Points points = use->skin.points(nodes, node_count, node_stride, true);
    const Rest rest{velocity, density,       occlusion,    displacement_bound,
                    elements, element_count, overpressure, overpressure_count,
                    force,    power,         counters};
    if (velocities == nullptr) return press(*use, points, nullptr, rest);
    const Points moving = use->skin.points(velocities, node_count, velocity_stride, true, "velocities");
    press(*use, points, &moving, rest);
  });
}

int gasjet_jet_pressure_float(gasjet_handle jet, const float nodes[], int64_t node_count,
                              const int64_t node_stride[], const float velocities[],
                              const int64_t velocity_stride[], double velocity, double density, int occlusion,
                              double displacement_bound, const int32_t elements[], int64_t element_count,
                              double overpressure[], int64_t overpressure_count, double force[3],
                              double* power, gasjet_visibility* counters) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    const Points points = use->skin.points(nodes, node_count, node_stride, use->node_copy, "nodes");
    const Rest rest{velocity, density,       occlusion,    displacement_bound,
                    elements, element_count, overpressure, overpressure_count,
                    force,    power,         counters};
    if (velocities == nullptr) return press(*use, points, nullptr, rest);
    const Points moving =
        use->skin.points(velocities, node_count, velocity_stride, use->velocity_copy, "velocities");
    press(*use, points, &moving, rest);
  });
}

int gasjet_jet_velocity(const gasjet_jet_model* model, const double points[], int64_t point_count,
                        const int64_t point_stride[], double velocity[], int64_t velocity_count) {
  return call([&] {
    const auto checked = model_of(model);
    const Points at(points, point_count, point_stride, "points");
    const auto out = output(velocity, velocity_count, 3 * point_count, "velocity");
    Eigen::Matrix3Xd found(3, at.view().cols());
    for (Eigen::Index i = 0; i < at.view().cols(); ++i)
      found.col(i) = jet::relative_velocity(checked, at.view().col(i));
    if (!found.allFinite()) throw Failure(GASJET_DOMAIN, not_finite("velocity"));
    std::copy(found.data(), found.data() + found.size(), out.begin());
  });
}
