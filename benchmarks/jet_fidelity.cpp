// SPDX-License-Identifier: Apache-2.0
// Rungs of fidelity of the hidden-element test on the paper's scene: none, centroid, n x n pieces an element,
// by the default route; and the other routes, which give the same answers. Error of the total jet force over
// instants from 11 to 43 ms against cost. One thread. Writes CSV to standard output.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "jet/field.hpp"
#include "jet_surface.hpp"
#include "jet_tree/tree_route.hpp"
#include "results/results.hpp"

namespace {

using benchmarks::JetState;
using benchmarks::JetSurface;
using Route = jet::VisibilityRoute;
using Forces = std::vector<Eigen::Vector3d>;  // [N] of each state

struct Rung {
  Forces forces;
  double cost = 0.0;  // [us] of field and visibility, mean over the states of each one's best round
};

// Without a route no element is hidden.
Rung evaluate(const driver::Scene& scene, const std::vector<JetState>& states, int n,
              std::optional<Route> route) {
  const auto& model = scene.jets.front().field.model();
  JetSurface surface(scene, n);
  const jet::JetField field(model, surface.element_count(), surface.roles().null_elements);
  jet::FieldState load = field.make_state();
  jet::VisibilityQuery query(surface.triangles(), static_cast<int>(surface.nodes().cols()), surface.roles());
  std::vector<std::uint8_t> lit(static_cast<std::size_t>(surface.element_count()));
  Rung rung;
  for (const JetState& state : states) {
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < (n > 8 ? 1 : 5); ++round) {
      surface.place(state, 1e-9 * round);  // each query sees a new shape
      const double time = benchmarks::microseconds([&] {
        field.evaluate(surface.area_vectors(), surface.centroids(), state.outlet, load);
        if (!route) return;
        const std::span<std::uint8_t> mask(lit.data(), load.candidates.size());
        query.query(*route, surface.nodes(), jet::ray_source(model), load.candidates, mask);
        jet::apply_mask(mask, load);
      });
      best = std::min(best, time);
    }
    rung.forces.push_back(jet::jet_force(load, surface.area_vectors()));
    rung.cost += best / static_cast<double>(states.size());
  }
  return rung;
}

struct Errors {
  double rms = 0.0, impulse = 0.0;  // [-] of the force; of its sum over the states
};

Errors errors(const Forces& forces, const Forces& exact) {
  double squares = 0.0, scale = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), exact_sum = sum;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    squares += (forces[i] - exact[i]).squaredNorm();
    scale += exact[i].squaredNorm();
    sum += forces[i], exact_sum += exact[i];
  }
  return {std::sqrt(squares / scale), (sum - exact_sum).norm() / exact_sum.norm()};
}

void print(const char* name, int n, const Rung& rung, const Forces& exact) {
  const Errors e = errors(rung.forces, exact);
  fmt::print("{},{},{:.2f},{:.3e},{:.3e}\n", name, n, rung.cost, e.rms, e.impulse);
  std::fflush(stdout);
}

}  // namespace

int main() {
  jet::add_tree_route();
  for (const auto& [key, value] : driver::provenance("cases/passenger_pendulum.toml", {}))
    if (key != "options") fmt::print("# {}: {}\n", key, value);
  const driver::Scene scene = benchmarks::passenger_scene({});
  std::vector<double> times;
  for (int i = 0; i < 17; ++i) times.push_back(0.011 + 0.002 * i);
  const auto states = benchmarks::jet_states(scene, times);
  const Rung none = evaluate(scene, states, 1, std::nullopt);
  std::vector<Rung> rungs;
  const std::vector<int> sizes{1, 2, 4, 8, 16, 32};
  for (const int n : sizes) rungs.push_back(evaluate(scene, states, n, Route::fast));
  // Shadow edges make the finest pieces' error of first order at worst, without shadows it is of second: the
  // reference extrapolates as if it were second, and its own error is at most its distance from the finest.
  const Forces &fine = rungs[5].forces, &half = rungs[4].forces;
  Forces exact;
  for (std::size_t i = 0; i < fine.size(); ++i) exact.push_back(fine[i] + (fine[i] - half[i]) / 3.0);
  fmt::print("# reference: extrapolated from n = 16 and 32, off n = 32 by {:.1e} r.m.s.\n",
             errors(fine, exact).rms);
  fmt::print("rung,n,us_per_step,force_error_rms,impulse_error\n");
  print("no_occlusion", 1, none, exact);
  for (std::size_t i = 0; i + 1 < sizes.size(); ++i) print("pieces", sizes[i], rungs[i], exact);
  for (const int n : {1, 2, 4}) print("cgal_tree", n, evaluate(scene, states, n, Route::cgal_tree), exact);
  print("brute_force", 1, evaluate(scene, states, 1, Route::brute_force), exact);
  return 0;
}
