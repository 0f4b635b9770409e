// SPDX-License-Identifier: Apache-2.0
// Options of a jet that a case can name: each reaches its formula, and its step limit is where it is said to
// be.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

#include "bisection.hpp"
#include "claim.hpp"
#include "engine/step.hpp"
#include "jet/jet.hpp"
#include "membrane/time_step.hpp"
#include "run_case.hpp"

namespace {

/// Force on the slot case's plate [N] by its formulas, written out: wedge, cone, radial, averaged over n^2
/// pieces an element. The plate is the case's, 4 x 4 cells with union-jack diagonals from the mesh itself.
double slot_force(const driver::Scene& scene, int n, double restitution, bool cone, bool radial) {
  const double a = 0.118, b0 = 0.0125, half_long = 0.1, mass_flow = 2.0, temperature = 406.0;
  const auto gas = gas::inflator_point(scene.gas->model, 0, 0.0);
  const double gamma = gas.cp / (gas.cp - gas.gas_constant);
  const double v0 = std::sqrt((gamma - 1.0) * gas.cp * temperature);
  const double density = mass_flow / (4.0 * b0 * half_long * v0);
  const Eigen::Vector3d normal(0.8, 0.0, 0.6);
  const auto pressure = [&](const Eigen::Vector3d& p) {  // the slot is along y, its axis along x
    const double decay = std::min(1.0, 1.2 / std::sqrt(a * p.x() / b0 + 0.41));
    const double width =
        cone ? 0.02 + p.x() * std::tan(0.28) : 2.0 * std::sqrt(2.0 / std::numbers::pi) * b0 / (decay * decay);
    const double share = std::pow(decay * std::exp(-std::pow(p.z() / width, 2)), 2);
    if (std::abs(p.y()) > half_long || std::exp(-2.0 * std::pow(p.z() / width, 2)) < 1e-3) return 0.0;
    Eigen::Vector3d direction(1.0, 0.0, 0.0);
    if (radial) direction = Eigen::Vector3d(p.x() + 0.41 * b0 / a, 0.0, p.z()).normalized();
    return (1.0 + restitution) * density * v0 * v0 * share * std::pow(direction.dot(normal), 2);
  };
  double force = 0.0;
  for (Eigen::Index e = 0; e < scene.target->triangles.cols(); ++e) {
    const auto corner = [&](int i) -> Eigen::Vector3d {
      return scene.target->nodes.col(scene.target->triangles(i, e));
    };
    const Eigen::Vector3d p = corner(0), u = corner(1) - p, v = corner(2) - p;
    const double area = 0.5 * u.cross(v).norm() / (n * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        force += area * pressure(p + (3 * i + 1) * u / (3 * n) + (3 * j + 1) * v / (3 * n));
        if (i + j < n - 1)
          force += area * pressure(p + (3 * i + 2) * u / (3 * n) + (3 * j + 2) * v / (3 * n));
      }
  }
  return force;
}

struct Variant {
  std::vector<std::string> overrides;
  int n;
  double restitution;
  bool radial;
};

TEST(jet_options, slot_on_inclined_plate_eq_formulas_written_out) {
  for (const Variant& v :
       {Variant{{}, 4, 0.5, true}, Variant{{"inflator.0.jet.subdivisions=1"}, 1, 0.5, true},
        Variant{{"inflator.0.jet.direction=axial"}, 4, 0.5, false},
        Variant{{"inflator.0.jet.restitution=1.0"}, 4, 1.0, true}}) {
    const auto run = coupled::run_case("jet_slot_plate", v.overrides);
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    const double exact = slot_force(coupled::scene_of("jet_slot_plate"), v.n, v.restitution, true, v.radial);
    claim::expect_relative({"J.6", "case jet_slot_plate, four variants, formulas written out: force [N]",
                            "500 terms, each with exp"},
                           run.history.back().at("jet_force_N"), exact, 1e-12);
  }
}

using Check = std::function<void(const driver::Scene&, const driver::State&)>;

/// Advances the bag case and hands every level with all its forces to `check`, and to `after` once it is
/// left.
void for_each_level(const std::vector<std::string>& overrides, int steps, const Check& check,
                    const Check& after = {}) {
  const driver::Scene scene = coupled::scene_of("jet_bag", overrides);
  driver::State state = driver::make_state(scene);
  for (int i = 0; i < steps; ++i) {
    driver::evaluate_level(scene, state, {});
    check(scene, state);
    driver::advance_level(scene, state, {});
    if (after) after(scene, state);
    state.time += state.step.after;
  }
}

TEST(jet_options, moving_skin_feels_the_relative_velocity) {
  double fastest = 0.0;
  int loaded = 0;
  for_each_level({}, 120, [&](const driver::Scene& scene, const driver::State& state) {
    const auto& run = state.jets.front();
    const auto& model = scene.jets.front().field.model();
    for (const int e : run.load().candidates) {
      const Eigen::Vector3i t = scene.bag->mesh.elements.col(e);
      const auto velocity = state.bag->velocity.map();
      const Eigen::Vector3d skin = (velocity.col(t[0]) + velocity.col(t[1]) + velocity.col(t[2])) / 3.0;
      const Eigen::Vector3d normal = Eigen::Vector3d(state.bag->area_vector.map().col(e)).normalized();
      const Eigen::Vector3d gas =
          run.outlet.velocity * jet::relative_velocity(model, state.bag->centroid.map().col(e));
      const double relative = std::max((gas - skin).dot(normal), 0.0);
      const double exact = 2.0 * run.outlet.density * relative * relative;
      // The field at the centroid is known to 1e-13 at the cut-off, the difference to 1e-13 of 500 m/s.
      EXPECT_NEAR(run.load().overpressure[static_cast<std::size_t>(e)], exact, 1e-9 + 1e-11 * exact);
      fastest = std::max(fastest, std::abs(skin.dot(normal)) / run.outlet.velocity);
      ++loaded;
    }
  });
  EXPECT_GT(loaded, 1000);
  EXPECT_GT(fastest, 0.02) << "the skin has to move for the option to matter";
}

TEST(jet_options, outlet_laws_reach_the_outlet) {
  double lowest_matched = 1e9, lowest_sonic = 1e9;
  const auto lowest = [](double& low) {
    return [&low](const driver::Scene&, const driver::State& state) {
      const auto& outlet = state.jets.front().outlet;
      if (outlet.density > 0.0) low = std::min(low, outlet.pressure / state.gas_point.pressure);
    };
  };
  for_each_level({}, 20, lowest(lowest_matched));
  for_each_level({"inflator.0.jet.outlet=sonic"}, 20, lowest(lowest_sonic));
  EXPECT_GE(lowest_matched, 1.0 - 1e-14);
  EXPECT_LT(lowest_sonic, 0.9) << "early, a sonic outlet carries too little mass to fill the bag's pressure";
}

/// Does x'' = -omega^2 x - c v, stepped as the skin is (force from x_n, damping from v at n-1/2), stay
/// bounded?
bool bounded(double omega, double rate, double dt) {
  double x = 1.0, v = 0.3 * omega;
  for (int i = 0; i < 20000; ++i) {
    v += -dt * (omega * omega * x + rate * v);
    x += dt * v;
    if (std::abs(x) > 1e3) return false;
  }
  return true;
}

TEST(jet_options, lagged_damping_limit_eq_measured_threshold) {
  for (const double omega : {1.0, 4e4})
    for (const double ratio : {0.01, 0.5, 3.0}) {
      const double rate = ratio * omega;
      const double limit = membrane::critical_time_step({.element = omega * omega}, rate);
      const double measured = claim::largest_passing(0.5 * limit, 2.0 * limit, 2e-4,
                                                     [&](double dt) { return bounded(omega, rate, dt); });
      claim::expect_threshold(
          {"J.9",
           "one mode, c/ω = " + std::to_string(ratio).substr(0, 4) +
               (omega > 1.0 ? ", ω = 4e4/s" : ", ω = 1/s"),
           "bisection to 2e-4; past the limit by 1e-3 the amplitude grows by that share a step, e^20 in all"},
          {"jet relative to the skin", "ω²Δt² + 2 c Δt = 4", limit, measured, "s",
           "the rate is part of the bound; a fixed step above it: exit 3, naming the jet"},
          1.0 - 1e-3, 1.0 + 1e-3);
    }
  EXPECT_EQ(membrane::critical_time_step({.element = 4e10}), 1e-5);
}

// A free element in a jet relative to it: 2 (1 + e) rho0 u A / (rho h A0), u its relative normal speed.
double damping_rate(const driver::Scene& scene, const driver::State& state) {
  double sum = 0.0;
  for (const auto& run : state.jets) {
    double largest = 0.0;
    for (const int element : run.load().candidates) {
      const auto e = static_cast<std::size_t>(element);
      const double speed = std::sqrt(run.load().overpressure[e] / (2.0 * run.outlet.density));
      const double stretch =
          state.bag->area_vector.map().col(element).norm() / scene.bag->model.reference_area[e];
      largest = std::max(largest, 4.0 * run.outlet.density * speed * stretch / (620.0 * 0.5e-3));
    }
    sum += largest;
  }
  return sum;
}

TEST(jet_options, step_bound_counts_relative_jets) {
  double rate = 0.0, least = 1.0;
  membrane::StiffnessShares shares;
  for_each_level(
      {}, 150,
      [&](const driver::Scene& scene, const driver::State& state) {
        rate = damping_rate(scene, state);
        shares = membrane::stiffness_shares(scene.bag->model, *state.bag, state.gas_point.gamma,
                                            state.gas_point.pressure);
      },
      [&](const driver::Scene&, const driver::State& state) {
        const double bound = membrane::critical_time_step(shares, rate);
        // The bound takes the loads over a kick after which the step is as long as before it. Steps change by
        // less than 1e-3; the jet starts with the run.
        EXPECT_NEAR(state.step.critical, bound, 1e-3 * bound);
        least = std::min(least, bound / membrane::critical_time_step(shares));
      });
  EXPECT_LT(least, 0.9) << "the jet has to matter";
}

TEST(jet_options, step_above_the_bound_of_a_relative_jet_is_refused) {
  const std::vector<std::string> absolute{"time.step=5e-5", "inflator.0.jet.relative_to_skin=false",
                                          "inflator.1.jet.relative_to_skin=false"};
  EXPECT_EQ(coupled::run_case("jet_bag", absolute).outcome.status, driver::RunStatus::done);
  const auto relative = coupled::run_case("jet_bag", {"time.step=5e-5"});
  EXPECT_EQ(relative.outcome.status, driver::RunStatus::failed);
  EXPECT_NE(relative.outcome.message.find("relative to the skin"), std::string::npos)
      << relative.outcome.message;
}

}  // namespace
