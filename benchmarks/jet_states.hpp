// SPDX-License-Identifier: Apache-2.0
// The paper's scene at instants of its run: what a jet is asked at each step.
#pragma once

#include <string>
#include <vector>

#include "engine/scene.hpp"
#include "jet/outlet.hpp"

namespace benchmarks {

struct JetState {
  double time;                // [s]
  Eigen::Matrix3Xd position;  // [m] of the nodes
  Eigen::Matrix3Xd velocity;  // [m/s]
  jet::OutletState outlet;
};

/// cases/passenger_pendulum.toml with these overrides.
driver::Scene passenger_scene(const std::vector<std::string>& overrides);

/// Runs the scene; the states at the first levels at or past the times [s], in rising order.
std::vector<JetState> jet_states(const driver::Scene& scene, const std::vector<double>& times);

}  // namespace benchmarks
