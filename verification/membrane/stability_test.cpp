// SPDX-License-Identifier: Apache-2.0
// Where the method fails: the largest stable step by bisection, pressure of the wrong level, a bag with
// hardly any volume, and fabric that carries compression.
#include "closed_form/stability.hpp"

#include <gtest/gtest.h>

#include "bags.hpp"
#include "bisection.hpp"
#include "claim.hpp"
#include "dense.hpp"
#include "mesh/passenger_bag.hpp"

using membrane::Compression;
using scenes::Bag;
using scenes::icosahedron;
using scenes::kAmbient;
using scenes::kGamma;

namespace {

// Between 0.5 and 2 times the estimate. A thousandth past the limit a mode grows by
// 1 + sqrt(8e-3) a step, e^34 in 400; a thousandth below a kick grows to 1 / sin(theta) = 12 of it at most,
// and rigid motion to the number of steps.
double measured_limit(const Bag& bag, double estimate) {
  return claim::largest_passing(0.5 * estimate, 2.0 * estimate, 2e-4,
                                [&](double dt) { return scenes::growth(bag, dt) < scenes::kBlownUp; });
}
const char* const kBisected = "bisection to 2e-4; a thousandth off the limit decides within 400 steps";

std::string percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + " %";
}

Bag triangle(double base, double apex, double height) {
  mesh::Mesh mesh;
  mesh.nodes.resize(3, 3);
  mesh.nodes << 0.0, base, apex, 0.0, 0.0, height, 0.0, 0.0, 0.0;
  mesh.elements.resize(3, 1);
  mesh.elements << 0, 1, 2;
  return {make_model(scenes::describe(mesh, Compression::linear)), mesh.nodes};
}

// Growth per step of the breathing mode u: u_n^2 - u_(n-1) u_(n+1) is multiplied by |z|^2 in each step.
double breathing_growth(const Bag& bag, double dt, bool lagged) {
  constexpr int steps = 40;
  auto state = membrane::make_state(bag.model, bag.x);
  state.velocity.map() = 1e-7 / dt * bag.x;
  double u[steps + 3] = {}, gauge = bag.gauge(bag.volume);
  for (int i = 0; i < steps + 2; ++i) {
    membrane::update_skin(bag.model, state);
    const double fresh = bag.gauge(state.surface.volume);
    membrane::pressure_forces(state, lagged ? gauge : fresh);
    gauge = fresh;
    membrane::advance(bag.model, state, dt, dt);
    u[i + 1] = (state.position.map() - bag.x).cwiseProduct(bag.x).sum() / bag.x.squaredNorm();
  }
  const auto invariant = [&](int n) { return u[n] * u[n] - u[n - 1] * u[n + 1]; };
  return std::pow(invariant(steps + 1) / invariant(1), 0.5 / steps);
}

}  // namespace

TEST(Stability, largest_step_of_single_triangles_eq_closed_form) {
  const auto sheet = closed_form::paper_fabric();
  struct Shape {
    const char *failure, *name;
    double base, apex, height;
  };
  const Shape shapes[] = {
      {"membrane critical step", "equilateral, side 10 mm", 0.01, 0.005, 0.0086602540378443865},
      {"membrane critical step", "right, legs 10 mm", 0.01, 0.0, 0.01},
      {"sliver", "needle, base 1 mm, height 20 mm", 0.001, 0.0005, 0.02},
      {"sliver", "cap, base 20 mm, height 1 mm", 0.02, 0.011, 0.001}};
  for (const auto& s : shapes) {
    const double exact =
        closed_form::critical_time_step(closed_form::triangle_frequency(sheet, s.base, s.apex, s.height));
    claim::expect_threshold(
        {"M.10", s.name, kBisected},
        {s.failure, "Δt = 2/ω_e, one free triangle", exact,
         measured_limit(triangle(s.base, s.apex, s.height), exact), "s",
         "Δt follows; a fixed step: exit 3 before the first step, naming element, limit and shares"},
        1.0 - 1e-3, 1.0 + 1e-3);
  }
}

// The assembled bag with gas, pressure of the same positions: its limit is that of the dense eigenvalue, and
// the step from added stiffnesses is below it.
TEST(Stability, largest_step_of_a_gas_filled_bag_eq_dense_eigenvalue) {
  for (const double stretch : {1.02, 1.1, 1.25}) {
    const Bag bag = icosahedron(stretch);
    const double exact =
        2.0 / std::sqrt(scenes::greatest_frequency(
                  bag.model, bag.x, [&](const Eigen::Matrix3Xd& at) { return bag.force(at); }));
    claim::expect_threshold(
        {"M.12", "icosahedron full of gas, stretched by " + percent(stretch - 1.0), kBisected},
        {"assembled bag with gas", "Δt = 2/ω, greatest eigenvalue of M⁻¹K", exact, measured_limit(bag, exact),
         "s", "the added bound stays below it at any stretch"},
        1.0 - 1e-3, 1.0 + 1e-3);
    const auto state = scenes::evaluated(bag.model, bag.x);
    const double bound =
        membrane::critical_time_step(membrane::stiffness_shares(bag.model, state, kGamma, bag.pressure));
    EXPECT_LT(bound, exact) << stretch;
  }
}

// The passenger bag, 2744 elements: its measured limit is that of the greatest eigenvalue, and the step that
// a run takes is below it.
TEST(Stability, largest_step_of_the_passenger_bag_eq_eigenvalue) {
  const auto mesh = mesh::passenger_bag().mesh;
  const Bag bag{make_model(scenes::describe_shipped(mesh, {"vent"})), mesh.nodes};
  const double estimate = 2.0 / std::sqrt(scenes::power_estimate(bag.model, bag.x));
  const double limit = measured_limit(bag, estimate);
  const auto state = scenes::evaluated(bag.model, bag.x);
  const double bound = membrane::critical_time_step({.element = state.forces.element_frequency});
  EXPECT_LT(bound, limit);
  claim::expect_threshold({"M.15", "passenger bag, 2744 elements, against power iteration",
                           "power steps come from below in omega^2, within a percent"},
                          {"membrane critical step", "Δt = 2/ω, greatest eigenvalue of M⁻¹K", estimate, limit,
                           "s", "the bound of a run is below it: safe without being asked"},
                          1.0 - 5e-3, 1.0 + 5e-3);
}

TEST(Stability, pressure_lagged_by_one_step_grows_at_every_step_size) {
  const Bag bag = icosahedron(1.05);
  const auto shares =
      membrane::stiffness_shares(bag.model, scenes::evaluated(bag.model, bag.x), kGamma, bag.pressure);
  for (const double fraction : {0.5, 0.1, 0.02}) {
    const double dt = fraction * membrane::critical_time_step(shares);
    // While the mode oscillates the growth does not depend on the fabric's stiffness.
    const double exact = closed_form::lagged_pressure_growth(0.1, dt * std::sqrt(shares.gas));
    EXPECT_GT(exact, 1.0 + 1e-5);
    // Linear to the displacement, up to 2e-5 of the radius, over 40 steps: 1e-6 of the growth.
    const double slack = 1e-6 / (exact - 1.0);
    claim::expect_threshold(
        {"M.20", "growth a step, less 1, at " + percent(fraction) + " of the bound's step",
         "1e-6 of the growth: displacements up to 2e-5 of the radius"},
        {"pressure lagged by a step", "√(1 + ω_gas² Δt²): unstable at every Δt", exact - 1.0,
         breathing_growth(bag, dt, true) - 1.0, "",
         "pressure and forces belong to the same positions: no growth"},
        1.0 - slack, 1.0 + slack);
    EXPECT_NEAR(breathing_growth(bag, dt, false), 1.0, 1e-6) << fraction;
  }
}

// A bag that holds hardly any gas: the gas sets the limit, 2 / omega_gas (M.11), and the fabric's stiffness
// takes off no more than its share.
TEST(Stability, bag_with_a_tiny_volume_fails_where_the_gas_bound_says) {
  const auto mesh = mesh::icosphere(0.3, 1);
  Bag bag{make_model(scenes::describe(mesh, Compression::none)), mesh.nodes, kAmbient};
  bag.x.row(2) *= 1e-3;  // slack everywhere
  const auto state = scenes::evaluated(bag.model, bag.x);
  bag.volume = state.surface.volume;
  const auto shares = membrane::stiffness_shares(bag.model, state, kGamma, kAmbient);
  EXPECT_GT(shares.gas, 10.0 * shares.element);
  const double gas_alone = 2.0 / std::sqrt(shares.gas);
  // Between the bound with all shares and the gas alone; bisection to 2e-4.
  claim::expect_threshold(
      {"M.11", "icosphere flattened to a thousandth of its depth",
       "slack fabric takes off its share at most"},
      {"gas stiffness of a small volume", "Δt = 2/ω_gas", gas_alone, measured_limit(bag, gas_alone), "s",
       "the gas is a share of the bound: the step falls with the volume; V ≤ 0: exit 3"},
      membrane::critical_time_step(shares) / gas_alone - 1e-3, 1.0 + 1e-3);
}

// Fabric that carries compression, flattened to a tenth of its depth: it holds energy that no gas put in, its
// lowest mode has a negative stiffness, and it springs open by itself. Fabric that does not stays where it
// is.
TEST(Stability, linear_compression_springs_a_flattened_bag_open) {
  const auto mesh = mesh::icosphere(0.3, 1);
  Eigen::Matrix3Xd flat = mesh.nodes;
  flat.row(2) *= 0.1;
  for (const auto compression : {Compression::linear, Compression::none}) {
    const Bag bag{make_model(scenes::describe(mesh, compression)), flat};
    auto state = scenes::evaluated(bag.model, flat);
    const double stored = state.forces.strain_energy;
    const double softest = scenes::greatest_frequency(bag.model, flat, [&](const Eigen::Matrix3Xd& at) {
      return Eigen::Matrix3Xd(-bag.force(at));
    });  // of -K
    const double dt = 0.5 * membrane::critical_time_step({.element = state.forces.element_frequency});
    for (int i = 0; i < 40; ++i) {
      membrane::update_skin(bag.model, state);
      membrane::advance(bag.model, state, i == 0 ? 0.0 : dt, dt);
    }
    if (compression == Compression::linear) {
      EXPECT_GT(stored, 10.0);  // [J]
      EXPECT_GT(softest, 0.05 * state.forces.element_frequency);
      EXPECT_GT(state.advance.kinetic_after, 0.1 * stored);
    } else {
      // Slack but for strains of rounding: 60 MPa (10 eps)^2 on 0.6 litres of fabric.
      EXPECT_LT(stored, 1e-25);
      EXPECT_LT(state.advance.kinetic_after, 1e-25);
    }
  }
}
