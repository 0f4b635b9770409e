// SPDX-License-Identifier: Apache-2.0
// What the jet's stages cost on the paper's scene, flat, folded and inflated, from 700 to a million elements:
// outlet, field, and visibility by every route and by Embree, side by side. One thread. Writes CSV to
// standard output.
// usage: jet_overhead [LARGEST]      largest number of elements, a million by default
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>

#include "jet/field.hpp"
#include "jet_surface.hpp"
#include "jet_tree/tree_route.hpp"
#include "results/results.hpp"
#ifdef GASJET_EMBREE
#include "embree_visibility.hpp"
#endif

namespace {

using benchmarks::JetState;
using benchmarks::JetSurface;
using benchmarks::microseconds;

struct Mesh {
  std::vector<std::string> overrides;  // cell counts of the bag's generator
  int pieces;                          // n: n^2 of them an element
};

// 4 (10 6 + 6 7 + 7 10) = 688 elements, with a stiffer contact as they are large; 2744, and each of these
// cut.
const Mesh kMeshes[] = {
    {{"membrane.mesh.depth_cells=10", "membrane.mesh.width_cells=6", "membrane.mesh.height_cells=7",
      "membrane.mesh.attachment_width_cells=4", "membrane.mesh.attachment_height_cells=3",
      "membrane.mesh.vent_depth_cell=3", "membrane.mesh.vent_height_cell=3", "contact.stiffness_share=4.0"},
     1},
    {{}, 1},
    {{}, 2},
    {{}, 4},
    {{}, 8},
    {{}, 12},
    {{}, 19}};

// At 3 ms the bag is still flat; it has most hidden elements about 15 ms; at 55 ms it is full and the jet
// still blows.
struct Shape {
  const char* name;
  double time;  // [s]
};
const Shape kShapes[] = {{"flat", 0.003}, {"folded", 0.015}, {"inflated", 0.055}};

/// One way to the mask, with what it took [us].
struct Route {
  std::string name;
  std::function<jet::VisibilityCounters(const JetSurface&, const std::vector<int>&, std::span<std::uint8_t>)>
      ask;
  double round = 0.0;                                     // sum over the steps of this round
  double best = std::numeric_limits<double>::infinity();  // smallest mean over a round
  jet::VisibilityCounters counters{};                     // of the last step
  std::size_t differs = 0;                                // elements, over the steps of the last round
};

Route library_route(const char* name, jet::VisibilityRoute way, const JetSurface& surface,
                    const jet::RaySource& source) {
  auto query = std::make_shared<jet::VisibilityQuery>(
      surface.triangles(), static_cast<int>(surface.nodes().cols()), surface.roles());
  return {name, [=](const JetSurface& now, const std::vector<int>& candidates, std::span<std::uint8_t> lit) {
            return query->query(way, now.nodes(), source, candidates, lit);
          }};
}

#ifdef GASJET_EMBREE
Route embree_route(const JetSurface& surface, const jet::RaySource& source) {
  auto embree = std::make_shared<benchmarks::EmbreeVisibility>(
      surface.triangles(), static_cast<int>(surface.nodes().cols()), surface.roles());
  return {"embree",
          [=](const JetSurface& now, const std::vector<int>& candidates, std::span<std::uint8_t> lit) {
            embree->refit(now.nodes());
            embree->query(source, now.area_vectors(), now.centroids(), candidates, lit);
            jet::VisibilityCounters counters;
            counters.candidates = candidates.size();
            counters.lit = static_cast<std::size_t>(std::count(lit.begin(), lit.end(), 1));
            counters.hidden = candidates.size() - counters.lit;  // those facing away among them
            return counters;
          }};
}
#endif

std::vector<Route> routes(const JetSurface& surface, const jet::RaySource& source) {
  std::vector<Route> list{library_route("fast", jet::VisibilityRoute::fast, surface, source),
                          library_route("cgal_tree", jet::VisibilityRoute::cgal_tree, surface, source)};
  if (surface.element_count() < 5000)
    list.push_back(library_route("brute_force", jet::VisibilityRoute::brute_force, surface, source));
#ifdef GASJET_EMBREE
  list.push_back(embree_route(surface, source));
#endif
  return list;
}

/// Jet stages over consecutive steps of a moving skin, there and back, so that each query sees a new shape.
/// One route after the other goes through the steps, as it would in a run: none clears the caches of another.
class Measurement {
 public:
  Measurement(const driver::Scene& scene, const JetState& state, JetSurface& surface, double step)
      : part_(scene.jets.front()),
        field_(part_.field.model(), surface.element_count(), surface.roles().null_elements),
        pressure_(field_.make_state()),
        state_(state),
        surface_(surface),
        step_(step),
        routes_(routes(surface, jet::ray_source(part_.field.model()))) {}

  void run(int rounds, int steps) {
    exact_.resize(static_cast<std::size_t>(steps));
    for (int round = 0; round < rounds; ++round) {
      for (Route& route : routes_) {
        double field_sum = 0.0;
        route.round = 0.0, route.differs = 0;
        for (int k = 0; k < steps; ++k) field_sum += one_step(route, round % 2 == 0 ? k : steps - 1 - k);
        field_best_ = std::min(field_best_, field_sum / steps);
        route.best = std::min(route.best, route.round / steps);
      }
    }
  }

  double field_time() const { return field_best_; }
  const std::vector<Route>& result() const { return routes_; }

 private:
  double one_step(Route& route, int k) {
    surface_.place(state_, k * step_);
    const double time = microseconds(
        [&] { field_.evaluate(surface_.area_vectors(), surface_.centroids(), state_.outlet, pressure_); });
    auto& exact = exact_[static_cast<std::size_t>(k)];
    auto& lit = &route == &routes_.front() ? exact : lit_;
    lit.resize(pressure_.candidates.size());
    route.round += microseconds([&] { route.counters = route.ask(surface_, pressure_.candidates, lit); });
    for (std::size_t i = 0; i < lit.size(); ++i) route.differs += lit[i] != exact[i];
    return time;
  }

  const driver::JetPart& part_;
  jet::JetField field_;
  jet::FieldState pressure_;
  const JetState& state_;
  JetSurface& surface_;
  double step_;  // [s]
  std::vector<Route> routes_;
  std::vector<std::vector<std::uint8_t>> exact_;  // by the fast route, of each step
  std::vector<std::uint8_t> lit_;
  double field_best_ = std::numeric_limits<double>::infinity();
};

double outlet_time(const driver::Scene& scene) {
  const auto& part = scene.jets.front();
  double sum = 0.0;  // kept so that the calls are not left out
  const int count = 10000;
  const double time = microseconds([&] {
    for (int i = 0; i < count; ++i) {
      const auto point = gas::inflator_point(scene.gas->model, part.inflator, 0.01 + 1e-6 * i);
      sum += jet::outlet_state(part.outlet,
                               {point.mass_flow, point.temperature, point.cp, point.gas_constant, 120e3})
                 .velocity;
    }
  });
  return sum > 0.0 ? time / count : 0.0;
}

bool print(const Shape& shape, const JetSurface& surface, const Measurement& m,
           const benchmarks::BagTimes& bag, double outlet, int steps) {
  bool agree = true;
  for (const Route& r : m.result()) {
    const double jet = outlet + m.field_time() + r.best;
    fmt::print("{},{},{},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{:.3f},{},{},{},{},{},{},{:.2f}\n",
               shape.name, surface.element_count(), r.name, bag.surface, bag.forces, bag.advance, outlet,
               m.field_time(), r.best, jet / bag.total(), r.counters.candidates, r.counters.lit,
               r.counters.candidates - r.counters.lit, r.counters.exact_calls, r.counters.fallbacks,
               r.counters.tree_builds, static_cast<double>(r.differs) / steps);
    agree = agree && (r.differs == 0 || r.name == "embree");
  }
  std::fflush(stdout);
  return agree;
}

bool measure(const Mesh& mesh, int largest) {
  const driver::Scene scene = benchmarks::passenger_scene(mesh.overrides);
  if (scene.bag->model.element_count * mesh.pieces * mesh.pieces > largest) return true;
  JetSurface surface(scene, mesh.pieces);
  std::vector<double> times;
  for (const Shape& shape : kShapes) times.push_back(shape.time);
  const auto states = benchmarks::jet_states(scene, times);
  bool agree = true;
  for (std::size_t s = 0; s < states.size(); ++s) {
    surface.place(states[s], 0.0);
    const auto bag = benchmarks::time_bag(scene, surface);
    const int steps = std::clamp(100'000 / surface.element_count(), 4, 16);
    Measurement m(scene, states[s], surface, 25e-6 / mesh.pieces);  // a step shrinks with the elements
    m.run(surface.element_count() < 50'000 ? 6 : 2, steps);
    agree = print(kShapes[s], surface, m, bag, outlet_time(scene), steps) && agree;
  }
  return agree;
}

}  // namespace

int main(int argc, char** argv) {
  jet::add_tree_route();
  const int largest = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  for (const auto& [key, value] : driver::provenance("cases/passenger_pendulum.toml", {}))
    if (key != "options") fmt::print("# {}: {}\n", key, value);
  fmt::print(
      "shape,elements,route,bag_surface_us,bag_forces_us,bag_advance_us,outlet_us,field_us,visibility_us,jet_"
      "over_bag,"
      "candidates,lit,not_lit,exact_calls,fallbacks,tree_builds,differs\n");
  bool agree = true;
  for (const Mesh& mesh : kMeshes) agree = measure(mesh, largest) && agree;
  if (!agree) fmt::print(stderr, "jet_overhead: the exact routes disagree\n");
  return agree ? EXIT_SUCCESS : EXIT_FAILURE;
}
