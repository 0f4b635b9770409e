// SPDX-License-Identifier: Apache-2.0
// Field output for ParaView: fields.pvd and one .vtp (XML PolyData) per output time.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "driver/scene.hpp"
#include "driver/state.hpp"

namespace driver {

/// Nodes with velocity; elements with overpressure of the jet, gauge pressure, stress, strain and jet mask;
/// the impactor as a point at the end of a line to the pivot stands in pendulum_*.vtp. Throws WriteError.
class FieldWriter {
 public:
  FieldWriter(const std::filesystem::path& folder, const Scene& scene);
  /// Writes level n; call it when the forces of n stand (StepRequest::before_advance).
  void write(const State& state);

 private:
  void write_collection() const;

  std::filesystem::path folder_;
  const Scene& scene_;
  std::vector<std::pair<double, std::string>> files_;  // time [s], file
};

}  // namespace driver
