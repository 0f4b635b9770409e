// SPDX-License-Identifier: Apache-2.0
// Field output for ParaView: fields.pvd and one .vtp (XML PolyData) per output time.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result_folder.hpp"
#include "engine/scene.hpp"
#include "engine/state.hpp"

namespace driver {

/// A mesh as VTK XML text, with the panel number of each element.
std::string polydata_of(const mesh::Mesh& mesh);

/// Writes the field files.
/// - bag_*.vtp: nodes with velocity; elements with panel, larger principal stress [Pa] and strain,
///   overpressure of gas and jets together and of the jets alone [Pa], and jet mask (0 outside, 1 in a jet
///   but hidden, 2 lit).
/// - pendulum_*.vtp: a line from the pivot to the impactor's centre, with the impactor's radius [m].
///
/// All members throw WriteError.
class FieldWriter {
 public:
  FieldWriter(ResultFolder& folder, const Scene& scene);
  /// Writes level n. Call it when the forces of n are complete (LevelView::show).
  void write(const State& state);

 private:
  void write_collection() const;

  ResultFolder& folder_;
  const Scene& scene_;
  std::vector<std::pair<double, std::string>> files_;  // time [s], file
};

}  // namespace driver
