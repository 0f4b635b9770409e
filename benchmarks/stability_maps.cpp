// SPDX-License-Identifier: Apache-2.0
// Stable or not over two parameters, each point a run; scripts/charts.py draws them.
// usage: stability_maps sliver|gas|lagged     CSV: x,dt_s,stable,formula_dt_s
#include <cmath>
#include <cstdio>
#include <string_view>

#include "bags.hpp"

namespace {

constexpr int kPoints = 15;  // along each axis

// Point `i` of a logarithmic axis.
double on_axis(double low, double high, int i) {
  return low * std::pow(high / low, i / (kPoints - 1.0));
}

void print_point(double x, double dt, bool stable, double formula) {
  std::printf("%.5g,%.5g,%d,%.5g\n", x, dt, stable ? 1 : 0, formula);
}

double bound(const scenes::Bag& bag) {
  const double gamma = bag.pressure > 0.0 ? scenes::kGamma : 0.0;
  return membrane::critical_time_step(
      membrane::stiffness_shares(bag.model, scenes::evaluated(bag.model, bag.x), gamma, bag.pressure));
}

// Sphere of 80 elements with one node moved along a side until that is the share `side` of what it was.
scenes::Bag with_sliver(double side) {
  auto mesh = mesh::icosphere(0.3, 1);
  const int from = mesh.elements(0, 0), to = mesh.elements(1, 0);
  mesh.nodes.col(from) = mesh.nodes.col(to) + side * (mesh.nodes.col(from) - mesh.nodes.col(to)).eval();
  return {make_model(scenes::describe(mesh, membrane::Compression::linear)), mesh.nodes};
}

// Sphere of 80 elements, slack, flattened to the share `depth` of its depth and so of its volume, with air at
// rest inside.
scenes::Bag flattened(double depth) {
  const auto mesh = mesh::icosphere(0.3, 1);
  scenes::Bag bag{make_model(scenes::describe(mesh, membrane::Compression::none)), mesh.nodes,
                  scenes::kAmbient};
  bag.x.row(2) *= depth;
  bag.volume = scenes::evaluated(bag.model, bag.x).surface.volume;
  return bag;
}

double gas_omega_squared(const scenes::Bag& bag) {
  return membrane::stiffness_shares(bag.model, scenes::evaluated(bag.model, bag.x), scenes::kGamma,
                                    bag.pressure)
      .gas;
}

// Points of a bag for each x: dt from `low` to `high`, stable over 400 steps or not, and the bound of a run
// (M.12).
template <class MakeBag>
void bag_map(double x_low, double dt_low, double dt_high, MakeBag&& make_bag) {
  for (int i = 0; i < kPoints; ++i) {
    const double x = on_axis(x_low, 1.0, i);
    const scenes::Bag bag = make_bag(x);
    const double limit = bound(bag);
    for (int j = 0; j < kPoints; ++j) {
      const double dt = on_axis(dt_low, dt_high, j);
      print_point(x, dt, scenes::growth(bag, dt) < scenes::kBlownUp, limit);
    }
  }
}

// Pressure of the step before: x is the time simulated [s]. A run is over where a disturbance has grown
// 1e5-fold; by (M.20) that takes t = ln(1e5) dt/ln sqrt(1 + omega^2 dt^2). dt(t) of that by bisection, on its
// falling side.
void lagged_map() {
  const scenes::Bag bag = flattened(0.1);
  const double omega_squared = gas_omega_squared(bag), longest = 0.1;
  const auto formula = [&](double t) {
    double low = 1e-9, high = 1.0 / std::sqrt(omega_squared);
    for (int i = 0; i < 60; ++i) {
      const double dt = std::sqrt(low * high);
      const double time = std::log(scenes::kBlownUp) * dt / (0.5 * std::log1p(omega_squared * dt * dt));
      (time > t ? low : high) = dt;
    }
    return low;
  };
  for (int j = 0; j < kPoints; ++j) {
    const double dt = on_axis(5e-6, 2e-4, j);
    int steps = 0;
    const bool stable =
        scenes::growth(bag, dt, static_cast<int>(longest / dt), true, &steps) < scenes::kBlownUp;
    for (int i = 0; i < kPoints; ++i) {
      const double t = on_axis(8e-3, longest, i);
      print_point(t, dt, stable || steps * dt > t, formula(t));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view name = argc == 2 ? argv[1] : "";
  if (name != "sliver" && name != "gas" && name != "lagged") {
    std::fprintf(stderr, "usage: stability_maps sliver|gas|lagged\n");
    return 2;
  }
  std::printf("x,dt_s,stable,formula_dt_s\n");
  if (name == "sliver") bag_map(0.01, 5e-6, 2e-3, with_sliver);
  if (name == "gas") bag_map(1e-4, 5e-6, 2e-3, flattened);
  if (name == "lagged") lagged_map();
  return 0;
}
