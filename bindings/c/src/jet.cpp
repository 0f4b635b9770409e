// SPDX-License-Identifier: Apache-2.0
#include "jet/jet.hpp"

#include <gasjet/jet.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "arrays.hpp"
#include "jet/field.hpp"
#include "jet/subdivision.hpp"
#include "jet/visibility.hpp"

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

jet::RaySource source_of(const gasjet_source* pointer) {
  const gasjet_source& given = needed(pointer, "source");
  jet::RaySource source;
  source.centre = vector_of(given.centre, "source.centre");
  source.axis = vector_of(given.axis, "source.axis");
  source.half_long = number(given.half_long, "source.half_long", 0.0);
  if (source.half_long > 0.0)
    source.long_direction = vector_of(given.long_direction, "source.long_direction");
  return source;
}

void write_counters(const jet::VisibilityCounters& from, gasjet_visibility* to) {
  if (to == nullptr) return;
  *to = {static_cast<int64_t>(from.candidates), static_cast<int64_t>(from.lit),
         static_cast<int64_t>(from.hidden), static_cast<int64_t>(from.facing_away)};
}

/// Input of jet and surface.
struct Skin {
  /// Checks the count first: a wrong one could use up the memory.
  static int64_t checked(int64_t nodes, int64_t triangle_count) {
    const int64_t most =
        3 * std::clamp<int64_t>(triangle_count, 0, std::numeric_limits<int>::max()) + kOtherNodes;
    if (nodes > most)
      refuse("node_count", "is " + std::to_string(nodes) + ", allowed: at most " + std::to_string(most) +
                               " for this number of triangles");
    return nodes;
  }
  static constexpr int64_t kOtherNodes = 20'000'000;  // nodes of other parts of the user's model

  Skin(const int32_t* data, int64_t count, const int64_t* stride, int64_t nodes, const int32_t* null_elements,
       int64_t null_count, const int32_t* attachment_elements, int64_t attachment_count)
      : triangles(triangles_of(data, count, stride, checked(nodes, count))),
        roles{numbers_of(null_elements, null_count, count, "null_elements"),
              numbers_of(attachment_elements, attachment_count, count, "attachment_elements")},
        named(triangles.data(), triangles.data() + triangles.size()),
        node_count(nodes) {
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
  }

  /// A call reads only the nodes of triangles.
  Points points(const double* nodes, int64_t count, const int64_t* stride, bool finite) const {
    require_count(count, node_count, "nodes");
    return {nodes, count, stride, "nodes", named, finite};
  }

  Eigen::Matrix3Xi triangles;
  jet::SurfaceRoles roles;
  std::vector<int> named;  // nodes of triangles
  int64_t node_count;
};

struct Surface : Object {
  explicit Surface(Skin given)
      : skin(std::move(given)),
        query(skin.triangles, static_cast<int>(skin.node_count), skin.roles),
        all(static_cast<std::size_t>(skin.triangles.cols())) {
    std::iota(all.begin(), all.end(), 0);
  }
  static constexpr const char* name = "a surface";
  static constexpr bool shared = false;

  Skin skin;
  jet::VisibilityQuery query;
  std::vector<int> all;  // all elements
};

struct Jet : Object {
  Jet(const jet::JetModel& model, Skin given)
      : skin(std::move(given)),
        field(model, static_cast<int>(skin.triangles.cols()), skin.roles.null_elements),
        source(jet::ray_source(field.model())),
        query(skin.triangles, static_cast<int>(skin.node_count), skin.roles),
        state(field.make_state()),
        area_vectors(3, skin.triangles.cols()),
        centroids(3, skin.triangles.cols()),
        lit(static_cast<std::size_t>(skin.triangles.cols())) {}
  static constexpr const char* name = "a jet";
  static constexpr bool shared = false;

  /// Area vectors and centroids of the elements.
  void measure(const Points::View& nodes) {
    for (Eigen::Index e = 0; e < skin.triangles.cols(); ++e) {
      const Eigen::Vector3d a = nodes.col(skin.triangles(0, e));
      const Eigen::Vector3d ab = nodes.col(skin.triangles(1, e)) - a,
                            ac = nodes.col(skin.triangles(2, e)) - a;
      area_vectors.col(e) = 0.5 * ab.cross(ac);
    }
    jet::corner_means(nodes, skin.triangles, centroids);
  }
  jet::VisibilityCounters hide(const Points::View& nodes, double displacement_bound) {
    const std::span seen(lit.data(), state.candidates.size());
    const auto counters =
        query.query(jet::VisibilityRoute::fast, nodes, source, state.candidates, seen, displacement_bound);
    jet::apply_mask(seen, state);
    return counters;
  }

  Skin skin;
  jet::JetField field;
  jet::RaySource source;
  jet::VisibilityQuery query;
  jet::FieldState state;
  Eigen::Matrix3Xd area_vectors, centroids;
  std::vector<std::uint8_t> lit;
  double area_ratio = 1.0, reflected = 1.0;  // of the notional nozzle
};

double bound_of(double displacement_bound) {
  if (displacement_bound < 0.0 || std::isinf(displacement_bound))
    refuse("displacement_bound", "is " + shown(displacement_bound) + ", allowed: 0 or more, NaN for unknown");
  return displacement_bound;
}

/// Numbers of candidates of a call, or all elements.
std::span<const int> candidates_of(const Surface& surface, const int32_t* candidates, int64_t count) {
  static_assert(std::is_same_v<int32_t, int>);
  if (candidates == nullptr) return surface.all;
  const std::span<const int> asked(candidates, static_cast<std::size_t>(count_of(count, "candidate_count")));
  const auto last = static_cast<int>(surface.all.size()) - 1;
  for (const int element : asked)
    if (element < 0 || element > last)
      refuse("candidates",
             "has the number " + std::to_string(element) + ", allowed: 0 to " + std::to_string(last));
  return asked;
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
    if (!std::isnan(restitution)) use->state.restitution = restitution;
    use->area_ratio = area_ratio;
    use->reflected = reflected;
  });
}

int gasjet_jet_pressure(gasjet_handle jet, const double nodes[], int64_t node_count,
                        const int64_t node_stride[], double velocity, double density, int occlusion,
                        double displacement_bound, double overpressure[], int64_t overpressure_count,
                        double force[3], gasjet_visibility* counters) {
  return call([&] {
    const Use<Jet> use(jet, "jet");
    const Points points = use->skin.points(nodes, node_count, node_stride, true);
    const auto out = output(overpressure, overpressure_count, use->skin.triangles.cols(), "overpressure");
    needed(force, "force");
    bound_of(displacement_bound);
    jet::OutletState outlet{number(velocity, "velocity", 0.0), number(density, "density", 0.0)};
    outlet.area_ratio = use->area_ratio;
    outlet.reflected = use->reflected;
    use->measure(points.view());
    use->field.evaluate(use->area_vectors, use->centroids, outlet, use->state, nullptr, displacement_bound);
    jet::VisibilityCounters seen;
    seen.candidates = seen.lit = use->state.candidates.size();
    if (occlusion != 0) seen = use->hide(points.view(), displacement_bound);
    std::copy(use->state.overpressure.begin(), use->state.overpressure.end(), out.begin());
    write_vector(jet::jet_force(use->state, use->area_vectors), force);
    write_counters(seen, counters);
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

int gasjet_surface_create(const int32_t triangles[], int64_t triangle_count, const int64_t triangle_stride[],
                          int64_t node_count, const int32_t null_elements[], int64_t null_count,
                          const int32_t attachment_elements[], int64_t attachment_count,
                          gasjet_handle* surface) {
  return call([&] {
    needed(surface, "surface");
    *surface = keep(
        std::make_shared<Surface>(Skin(triangles, triangle_count, triangle_stride, node_count, null_elements,
                                       null_count, attachment_elements, attachment_count)));
  });
}

int gasjet_surface_visible(gasjet_handle surface, const double nodes[], int64_t node_count,
                           const int64_t node_stride[], const gasjet_source* source,
                           const int32_t candidates[], int64_t candidate_count, double displacement_bound,
                           uint8_t lit[], int64_t lit_count, gasjet_visibility* counters) {
  return call([&] {
    const Use<Surface> use(surface, "surface");
    const Points points =
        use->skin.points(nodes, node_count, node_stride, false);  // the query checks the nodes that it needs
    const auto from = source_of(source);
    const auto asked = candidates_of(*use, candidates, candidate_count);
    const auto out = output(lit, lit_count, static_cast<int64_t>(asked.size()), "lit");
    write_counters(use->query.query(jet::VisibilityRoute::fast, points.view(), from, asked, out,
                                    bound_of(displacement_bound)),
                   counters);
  });
}
