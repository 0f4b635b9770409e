// SPDX-License-Identifier: Apache-2.0
// The bag of a run at one time, from the files of its results.
#pragma once

#include <filesystem>
#include <string>

#include "mesh/mesh.hpp"

namespace driver {

/// A shape that a run kept.
struct BagShape {
  mesh::Mesh mesh;    // elements as in the run; panels are called panel_0, panel_1, ...
  double time = 0.0;  // [s]
  std::string file;   // of the results that it is from
  /// [m] Coordinates are off by this at most; 0 for the doubles of fields.pvd.
  double error = 0.0;
};

/// Endings of the files that a shape is written to, for help and messages.
inline constexpr const char* shape_endings = ".obj, .stl, .vtp, or LS-DYNA keyword .k, .key, .dyn";

/// Shape of the kept time that is nearest to `time` [s], from fields.pvd if the run wrote it, else from
/// frames.bin. Throws CaseError if
/// - the folder has neither, or the file is damaged,
/// - the run has not ended,
/// - `time` is before the first kept one or after the last.
BagShape read_bag_shape(const std::filesystem::path& results, double time);

}  // namespace driver
