// SPDX-License-Identifier: Apache-2.0
// Vibration of stretched sheets and breathing of a gas-filled sphere, against the discrete and the continuous
// frequencies.
#include <gtest/gtest.h>

#include <numbers>

#include "claim.hpp"
#include "closed_form/membrane.hpp"
#include "closed_form/stability.hpp"
#include "statics.hpp"

using membrane::Compression;
using std::numbers::pi;

namespace {

// A sheet stretched by the same ratio in all directions, its edge fixed, to the tension 1000 N/m.
constexpr double kTension = 1000.0;  // second Piola-Kirchhoff stress x thickness [N/m]
constexpr closed_form::TensionedMembrane kSheet{kTension, 620.0 * 0.5e-3};
const double kStretch = std::sqrt(1.0 + 2.0 * kTension / 0.5e-3 * (1.0 - 0.3) / 60e6);

membrane::BagModel clamped(const mesh::Mesh& mesh, const std::vector<int>& edge) {
  auto d = scenes::describe(mesh, Compression::none);
  d.fixed_nodes = edge;
  return make_model(d);
}

// The amplitude a_n = sum m u . (x_n - x_0) of a small motion, watched over some steps. Central difference
// gives a_n+1 - 2 a_n + a_n-1 = -(omega dt)^2 a_n for each mode, omega that of the mesh without any error of
// the step.
class Amplitude {
 public:
  Amplitude(const membrane::BagModel& model, Eigen::Matrix3Xd rest, Eigen::Matrix3Xd shape)
      : rest_(std::move(rest)), weight_(std::move(shape)) {
    for (int n = 0; n < model.node_count; ++n) weight_.col(n) *= model.node_mass[static_cast<std::size_t>(n)];
  }
  void watch(const membrane::BagState& state) {
    const double now = weight_.cwiseProduct(state.position.map() - rest_).sum();
    if (++count_ > 2) {
      product_ += last_ * ((now - last_) - (last_ - before_last_));
      square_ += last_ * last_;
    }
    before_last_ = last_;
    last_ = now;
  }
  double last() const { return last_; }
  double mesh_frequency(double dt) const { return std::sqrt(-product_ / square_) / dt; }
  double step_frequency(double dt) const { return std::acos(1.0 + 0.5 * product_ / square_) / dt; }

 private:
  Eigen::Matrix3Xd rest_, weight_;
  double last_ = 0.0, before_last_ = 0.0, product_ = 0.0, square_ = 0.0;
  int count_ = 0;
};

// Vibration from rest at `shape` (heights of the nodes) times 1e-9 m, where strains of second order are below
// round-off.
struct Vibration {
  double frequency;  // of the mesh [Hz]
  double last;       // amplitude after `steps` steps of dt [s], over the first
  double dt;
  int steps;
};
Vibration vibrate(const membrane::BagModel& model, const mesh::Mesh& mesh, const Eigen::VectorXd& shape,
                  double frequency) {
  Eigen::Matrix3Xd rest = kStretch * mesh.nodes, unit = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
  unit.row(2) = 1e-9 * shape.transpose();
  auto state = membrane::make_state(model, rest + unit);
  Amplitude amplitude(model, rest, unit);
  amplitude.watch(state);
  const double first = amplitude.last();
  membrane::membrane_forces(model, state);
  const double dt = 0.5 * membrane::critical_time_step(membrane::stiffness_shares(model, state, 0.0, 0.0));
  const int steps = static_cast<int>(1.3 / (frequency * dt));
  for (int i = 0; i < steps; ++i) {
    membrane::membrane_forces(model, state);
    membrane::advance(model, state, i == 0 ? 0.0 : dt, dt);
    amplitude.watch(state);
  }
  return {amplitude.mesh_frequency(dt) / (2.0 * pi), amplitude.last() / first, dt, steps};
}

// Mode (m, n) of the square of side 0.6 m in N x N cells.
Vibration vibrate_square(int divisions, int m, int n) {
  const double side = 0.6;
  const auto mesh = mesh::rectangle(divisions, divisions, side, side, mesh::Diagonals::uniform);
  std::vector<int> edge;
  Eigen::VectorXd shape(mesh.node_count());
  for (int k = 0; k < mesh.node_count(); ++k) {
    const int i = k % (divisions + 1), j = k / (divisions + 1);
    const bool on_edge = i == 0 || j == 0 || i == divisions || j == divisions;
    shape[k] = on_edge ? 0.0 : std::sin(m * pi * i / divisions) * std::sin(n * pi * j / divisions);
    if (on_edge) edge.push_back(k);
  }
  return vibrate(clamped(mesh, edge), mesh, shape,
                 closed_form::rectangle_frequency(kSheet, side, side, m, n));
}

// Mode with `diameters` nodal diameters and no nodal circle but the edge, on the drum of radius 0.3 m.
double drum_frequency(int rings, int diameters) {
  const double radius = 0.3;
  const auto mesh = scenes::disc(radius, rings);
  std::vector<int> edge;
  for (int k = mesh.node_count() - 6 * rings; k < mesh.node_count(); ++k) edge.push_back(k);
  const double frequency = closed_form::drum_frequency(kSheet, radius, diameters, 1);
  const double wave_number = 2.0 * pi * frequency / closed_form::transverse_wave_speed(kSheet);
  Eigen::VectorXd shape(mesh.node_count());
  for (int k = 0; k < mesh.node_count(); ++k) {
    const double angle = std::atan2(mesh.nodes(1, k), mesh.nodes(0, k));
    shape[k] = std::cyl_bessel_j(diameters, wave_number * mesh.nodes.col(k).norm()) *
               std::cos(diameters * (angle - 0.2));
  }
  for (const int k : edge) shape[k] = 0.0;
  return vibrate(clamped(mesh, edge), mesh, shape, frequency).frequency;
}

// A sphere of 120 litres of fabric in equilibrium, adiabatic gas inside, that breathes.
struct Sphere {
  double overpressure, ambient_pressure;  // [Pa]
  Compression compression;
  double exact() const {
    return closed_form::sphere_breathing_frequency({closed_form::paper_fabric(), kRadius}, overpressure,
                                                   ambient_pressure, kGamma);
  }
  static constexpr double kRadius = 0.30598317419458695, kGamma = 1.4;
};
const Sphere kInflated{2e4, 101325.0, Compression::none};
const Sphere kUnstressed{0.0, 121325.0, Compression::linear};

// Breathing over two periods from a radial kick at equilibrium: swings of 1e-5 of the radius change the
// frequency by their square.
Amplitude breathe(const Sphere& sphere, int level, double dt) {
  const auto mesh = mesh::icosphere(Sphere::kRadius, level);
  const auto model = make_model(scenes::describe(mesh, sphere.compression));
  auto state = membrane::make_state(model, (1.0 + 3.7e-6 * sphere.overpressure) * mesh.nodes);
  // 1e-10 of the force of the gas on a node displaces it by 1e-11 of the radius, against swings of 1e-5.
  const double tolerance = 1e-11 * 121325.0 * 4.0 * pi * Sphere::kRadius * Sphere::kRadius / model.node_count;
  scenes::relax(model, state, sphere.overpressure, tolerance);
  const Eigen::Matrix3Xd rest = state.position.map(), outward = rest.colwise().normalized();
  const double omega = sphere.exact(), volume = state.surface.volume;
  const double pressure = sphere.ambient_pressure + sphere.overpressure;
  state.velocity.map() = 1e-5 * Sphere::kRadius * omega * outward;
  Amplitude amplitude(model, rest, outward);
  amplitude.watch(state);
  const int steps = static_cast<int>(4.0 * pi / (omega * dt));
  for (int i = 0; i < steps; ++i) {
    membrane::update_skin(model, state);
    const double gas = pressure * std::pow(volume / state.surface.volume, Sphere::kGamma);
    membrane::pressure_forces(state, gas - sphere.ambient_pressure);
    membrane::advance(model, state, i == 0 ? 0.0 : dt, dt);
    amplitude.watch(state);
  }
  return amplitude;
}

}  // namespace

// Split squares with uniform diagonals are the 5-point Laplacian with equal masses.
TEST(Vibration, square_eq_discrete_closed_form_to_round_off) {
  for (const int divisions : {8, 16, 32})
    for (const auto& [m, n] : {std::pair{1, 1}, std::pair{1, 2}, std::pair{2, 2}}) {
      const Vibration v = vibrate_square(divisions, m, n);
      const double exact = closed_form::lattice_square_frequency(kSheet, 0.6, divisions, m, n);
      // The tension comes from strains of 0.023 over cells of 0.02 m at 0.6 m, which carry eps 0.6 / (0.02 *
      // 0.023); second differences over a cell lose as much, (k h)^-2 = 100 eps.
      claim::expect_relative({"M.4", "modes of a stretched square, discrete: frequency [Hz]",
                              "rounding of the strains, 3e-13, and of second differences"},
                             v.frequency, exact, 1e-12);
      const double phase = v.steps * 2.0 * std::asin(pi * exact * v.dt);
      claim::expect_near(
          {"M.9", "modes of a stretched square, central difference: amplitude after 1.3 periods",
           "the frequency's error times the phase, 8 rad"},
          v.last, std::cos(phase), 1e-11);
    }
}

TEST(Vibration, square_frequency_converges_with_order_2) {
  for (const auto& [m, n] : {std::pair{1, 1}, std::pair{1, 2}}) {
    const double exact = closed_form::rectangle_frequency(kSheet, 0.6, 0.6, m, n);
    std::vector<double> error;
    for (const int divisions : {8, 16, 32})
      error.push_back(vibrate_square(divisions, m, n).frequency / exact - 1.0);
    claim::expect_order(
        {"M.4", "stretched square, mode " + std::to_string(m) + std::to_string(n) + ": frequency",
         "the discrete value is the sine of the continuous one"},
        error, 1.95, 2.05);
  }
}

TEST(Vibration, drum_frequency_converges_with_order_2) {
  for (const int diameters : {0, 1, 2}) {
    const double exact = closed_form::drum_frequency(kSheet, 0.3, diameters, 1);
    std::vector<double> error;
    for (const int rings : {4, 8, 16}) error.push_back(drum_frequency(rings, diameters) / exact - 1.0);
    claim::expect_order({"M.4", "drum, mode " + std::to_string(diameters) + "1: frequency",
                         "uneven elements; the first mesh has 4 rings"},
                        error, 1.85, 2.15);
  }
}

TEST(Vibration, breathing_frequency_of_gas_filled_sphere_converges_with_order_2) {
  for (const Sphere& sphere : {kInflated, kUnstressed}) {
    std::vector<double> error;
    for (const int level : {1, 2, 3})
      error.push_back(breathe(sphere, level, 1e-5).mesh_frequency(1e-5) / sphere.exact() - 1.0);
    const char* what = sphere.overpressure > 0.0 ? "gas-filled sphere under 20 kPa: breathing frequency"
                                                 : "gas-filled sphere, unstressed: breathing frequency";
    claim::expect_order({"M.11", what, "the first level has 80 elements"}, error, 1.8, 2.2);
  }
}

// The time step adds (omega dt)^2 / 24, as for any single oscillator.
TEST(Vibration, breathing_frequency_over_time_step_eq_central_difference) {
  const double omega = breathe(kInflated, 1, 1e-5).mesh_frequency(1e-5);
  std::vector<double> error;
  for (const double dt : {8e-5, 4e-5, 2e-5}) {
    const double ratio = breathe(kInflated, 1, dt).step_frequency(dt) / omega;
    error.push_back(ratio - 1.0);
    const double exact = closed_form::central_difference(omega * dt).frequency_ratio;
    claim::expect_near({"M.9", "breathing sphere by step: frequency over that of dt = 0, less 1",
                        "other modes: 4e-4 of the sums, frequencies up to twice this one"},
                       ratio - 1.0, exact - 1.0, 2e-3 * (exact - 1.0));
  }
  claim::expect_order(
      {"M.9", "breathing sphere by step: frequency", "the next term is (omega dt)^2 / 9 of the first"}, error,
      1.9, 2.1);
}
