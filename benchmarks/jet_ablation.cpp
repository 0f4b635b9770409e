// SPDX-License-Identifier: Apache-2.0
// One query of the fast visibility route in the paper's scene, flat, folded and inflated, with 2744 and
// 175 616 elements. As in a run it follows the skin from step to step and knows how far the nodes moved.
// Writes CSV: for each state what was lit in its last step and what not, a digest of all masks, and the time
// of each step. docs/make/charts/ablation.py compares the library with itself, one heuristic less. One
// thread.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "jet/field.hpp"
#include "jet/visibility.hpp"
#include "jet_surface.hpp"
#include "results/results.hpp"

namespace {

using benchmarks::JetState;
using benchmarks::JetSurface;
// The least of some rounds: what waits for other programs is left out. Processor time takes as long to ask
// for as a tenth of a query.
using Clock = std::chrono::steady_clock;

constexpr double kTimes[] = {0.003, 0.015, 0.055};  // [s] those of jet_overhead.cpp
constexpr const char* kNames[] = {"flat", "folded", "inflated"};
constexpr int kFirst = 2;  // steps before those that are timed: a query looks back two

struct Mesh {
  int pieces;  // n: n^2 of them an element; the steps are n times shorter
  int steps, rounds;
};
constexpr Mesh kMeshes[] = {{1, 48, 20}, {8, 16, 5}};

/// Levels of the run that follow each other, each with the velocity that leads to the next.
std::vector<std::vector<JetState>> levels(const driver::Scene& scene, int count) {
  std::vector<double> times;
  for (const double time : kTimes) times.insert(times.end(), static_cast<std::size_t>(count) + 1, time);
  const auto all = benchmarks::jet_states(scene, times);
  std::vector<std::vector<JetState>> result;
  for (std::size_t first = 0; first < all.size(); first += static_cast<std::size_t>(count) + 1) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    auto& some = result.emplace_back(begin, begin + count + 1);
    for (std::size_t i = 0; i + 1 < some.size(); ++i)
      some[i].velocity = (some[i + 1].position - some[i].position) / (some[i + 1].time - some[i].time);
  }
  return result;
}

/// Of all masks: FNV-1a.
struct Digest {
  std::uint64_t value = 14695981039346656037u;
  void take(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) value = (value ^ byte) * 1099511628211u;
  }
};

/// The queries of one state, round after round.
class Walk {
 public:
  Walk(const driver::Scene& scene, const std::vector<JetState>& states, const Mesh& mesh, JetSurface& surface)
      : states_(states),
        mesh_(mesh),
        surface_(surface),
        field_(scene.jets.front().field.model(), surface.element_count(), surface.roles().null_elements),
        pressure_(field_.make_state()),
        source_(jet::ray_source(field_.model())),
        query_(surface.triangles(), static_cast<int>(surface.nodes().cols()), surface.roles()),
        nodes_(4, surface.nodes().cols()),
        least_(static_cast<std::size_t>(mesh.steps), std::numeric_limits<double>::infinity()) {}

  void run() {
    for (int round = 0; round < mesh_.rounds; ++round) {
      const Digest before = digest_;
      digest_ = {};
      bound_ = 0.0;  // less than before: the query takes the skin for a new one
      for (int k = -kFirst; k < mesh_.steps; ++k) step(k);
      if (round > 0 && digest_.value != before.value) throw std::runtime_error("masks change between rounds");
    }
  }

  const std::vector<double>& times() const { return least_; }  // [us] by step
  const jet::VisibilityCounters& last() const { return counters_; }
  std::uint64_t digest() const { return digest_.value; }

 private:
  void step(int k) {
    const int i = k + kFirst;
    const auto at = static_cast<std::size_t>(i / mesh_.pieces);
    const double length = (states_[at + 1].time - states_[at].time) / mesh_.pieces;
    surface_.place(states_[at], i % mesh_.pieces * length);
    nodes_.topRows<3>() = surface_.nodes();  // written anew, as by a step
    field_.evaluate(surface_.area_vectors(), surface_.centroids(), states_[at].outlet, pressure_);
    lit_.resize(pressure_.candidates.size());
    const Eigen::Map<const Eigen::Matrix3Xd, 0, Eigen::OuterStride<4>> nodes(nodes_.data(), 3, nodes_.cols());
    const auto start = Clock::now();
    counters_ = query_.query(jet::VisibilityRoute::fast, nodes, source_, pressure_.candidates, lit_, bound_);
    const std::chrono::duration<double, std::micro> time = Clock::now() - start;
    if (k >= 0) {
      double& least = least_[static_cast<std::size_t>(k)];
      least = std::min(least, time.count());
    }
    digest_.take(lit_);
    bound_ += 1.001 * length * states_[at].velocity.colwise().norm().maxCoeff();
  }

  const std::vector<JetState>& states_;
  Mesh mesh_;
  JetSurface& surface_;
  jet::JetField field_;
  jet::FieldState pressure_;
  jet::RaySource source_;
  jet::VisibilityQuery query_;
  Eigen::Matrix4Xd nodes_;  // four numbers apart, as a bag has them
  double bound_ = 0.0;      // [m] displacement bound
  std::vector<std::uint8_t> lit_;
  std::vector<double> least_;  // [us] by step, over the rounds
  jet::VisibilityCounters counters_{};
  Digest digest_;
};

}  // namespace

int main() {
  const driver::Scene scene = benchmarks::passenger_scene({});
  int most = 0;
  for (const Mesh& mesh : kMeshes) most = std::max(most, (kFirst + mesh.steps - 1) / mesh.pieces + 1);
  const auto states = levels(scene, most);
  for (const auto& [key, value] : driver::provenance("cases/passenger_pendulum.toml", {}))
    if (key != "options") fmt::print("# {}: {}\n", key, value);
  fmt::print("state,elements,lit,not_lit,masks,steps_us\n");
  for (const Mesh& mesh : kMeshes) {
    JetSurface surface(scene, mesh.pieces);
    for (std::size_t i = 0; i < states.size(); ++i) {
      Walk walk(scene, states[i], mesh, surface);
      walk.run();
      fmt::print("{},{},{},{},{:016x},{:.3f}\n", kNames[i], surface.element_count(), walk.last().lit,
                 walk.last().candidates - walk.last().lit, walk.digest(), fmt::join(walk.times(), " "));
    }
  }
}
