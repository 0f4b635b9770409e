// SPDX-License-Identifier: Apache-2.0
// Work against precision of a bag's motion, over mesh and step: an unstressed sphere of fabric with adiabatic
// gas that breathes, and a stretched circular membrane, clamped, in its lowest mode. Each starts at rest in
// its own shape and is watched over two periods; the error is that of the frequency, which a closed form
// gives. The time is that of the steps alone.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "closed_form/membrane.hpp"
#include "disc_mesh.hpp"
#include "membrane/stages.hpp"
#include "membrane/time_step.hpp"
#include "mesh/icosphere.hpp"

namespace {

using std::numbers::pi;

/// A membrane at rest, the shape in which it swings, and what its gas does.
struct Swing {
  membrane::BagModel model;
  Eigen::Matrix3Xd rest, shape;  // positions; displacement [m] at the start
  double frequency;              // [rad/s], exact
  double pressure = 0.0;         // [Pa] absolute, of the gas inside and of the ambient; 0: no gas
};

constexpr double kGamma = 1.4;

membrane::BagDescription describe(const mesh::Mesh& mesh) {
  membrane::BagDescription d;
  d.reference = mesh.nodes;
  d.elements = mesh.elements;
  d.properties.assign(static_cast<std::size_t>(mesh.element_count()), {0.5e-3, 620.0, 60e6, 0.3, 0.0, false});
  d.compression = membrane::Compression::linear;  // small swings about a state that may be slack
  return d;
}

/// Of 120 litres.
Swing sphere(int level) {
  constexpr double radius = 0.30598317419458695, pressure = 121325.0;
  const auto mesh = mesh::icosphere(radius, level);
  return {
      make_model(describe(mesh)), mesh.nodes, 1e-5 * mesh.nodes,
      closed_form::sphere_breathing_frequency({closed_form::paper_fabric(), radius}, 0.0, pressure, kGamma),
      pressure};
}

/// Of radius 0.3 m, stretched to a tension of 1000 N/m.
Swing drum(int rings) {
  constexpr double radius = 0.3, tension = 1000.0;
  const auto mesh = scenes::disc(radius, rings);
  auto d = describe(mesh);
  for (int k = mesh.node_count() - 6 * rings; k < mesh.node_count(); ++k) d.fixed_nodes.push_back(k);
  const closed_form::TensionedMembrane sheet{tension, 620.0 * 0.5e-3};
  const double frequency = 2.0 * pi * closed_form::drum_frequency(sheet, radius, 0, 1);
  const double wave_number = frequency / closed_form::transverse_wave_speed(sheet);
  Swing swing{make_model(d), std::sqrt(1.0 + 2.0 * tension / 0.5e-3 * 0.7 / 60e6) * mesh.nodes,
              Eigen::Matrix3Xd::Zero(3, mesh.node_count()), frequency};
  for (int k = 0; k < mesh.node_count() - 6 * rings; ++k)
    swing.shape(2, k) = 1e-9 * std::cyl_bessel_j(0, wave_number * mesh.nodes.col(k).norm());
  return swing;
}

/// Frequency [rad/s] of the amplitude a_n = sum m u . shape: least squares of a_n+1 - 2 a_n + a_n-1 = -2 (1 -
/// cos(omega dt)) a_n.
class Watch {
 public:
  explicit Watch(const Swing& swing) : swing_(swing), weight_(swing.shape) {
    for (Eigen::Index n = 0; n < weight_.cols(); ++n)
      weight_.col(n) *= swing.model.node_mass[static_cast<std::size_t>(n)];
  }
  void see(const membrane::BagState& state) {
    const double now = weight_.cwiseProduct(state.position.map() - swing_.rest).sum();
    if (++count_ > 2) {
      product_ += last_ * ((now - last_) - (last_ - before_last_));
      square_ += last_ * last_;
    }
    before_last_ = last_;
    last_ = now;
  }
  double frequency(double dt) const { return std::acos(1.0 + 0.5 * product_ / square_) / dt; }

 private:
  const Swing& swing_;
  Eigen::Matrix3Xd weight_;
  double last_ = 0.0, before_last_ = 0.0, product_ = 0.0, square_ = 0.0;
  int count_ = 0;
};

void forces(const Swing& swing, membrane::BagState& state, double volume) {
  if (swing.pressure == 0.0) return membrane::membrane_forces(swing.model, state), void();
  membrane::update_skin(swing.model, state);
  membrane::pressure_forces(state, swing.pressure * (std::pow(volume / state.surface.volume, kGamma) - 1.0));
}

double critical_step(const Swing& swing, membrane::BagState& state) {
  membrane::update_surface(swing.model, state);
  membrane::membrane_forces(swing.model, state);
  return membrane::critical_time_step(
      membrane::stiffness_shares(swing.model, state, swing.pressure > 0.0 ? kGamma : 0.0, swing.pressure));
}

void run_swing(benchmark::State& run, Swing (*build)(int), int mesh, double share) {
  const Swing swing = build(mesh);
  double frequency = 0.0;
  int steps = 0;
  for (auto _ : run) {
    run.PauseTiming();
    auto state = membrane::make_state(swing.model, swing.rest);
    const double dt = share * critical_step(swing, state), volume = state.surface.volume;
    state.position.map() += swing.shape;
    Watch watch(swing);
    watch.see(state);
    steps = static_cast<int>(4.0 * pi / (swing.frequency * dt));
    run.ResumeTiming();
    for (int i = 0; i < steps; ++i) {
      forces(swing, state, volume);
      membrane::advance(swing.model, state, i == 0 ? 0.0 : dt, dt);
      watch.see(state);
    }
    frequency = watch.frequency(dt);
  }
  run.counters["elements"] = static_cast<double>(swing.model.element_count);
  run.counters["steps"] = steps;
  run.counters["error"] = std::abs(frequency / swing.frequency - 1.0);
}

bool register_all() {
  const auto add = [](const char* name, Swing (*build)(int), int mesh, const char* share) {
    const std::string full = std::string(name) + "/" + std::to_string(mesh) + "/" + share;
    benchmark::RegisterBenchmark(full.c_str(), run_swing, build, mesh, std::stod(share))->Iterations(1);
  };
  for (const char* share : {"0.9", "0.45", "0.225", "0.1125"}) {
    for (const int level : {1, 2, 3, 4}) add("sphere", sphere, level, share);
    for (const int rings : {4, 8, 16, 32}) add("drum", drum, rings, share);
  }
  return true;
}

const bool registered = register_all();

}  // namespace
