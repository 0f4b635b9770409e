// SPDX-License-Identifier: Apache-2.0
// The bag of a run at one time, from the files of its results.
#pragma once

#include <filesystem>
#include <string>

#include "mesh/mesh.hpp"

namespace driver {

/// A shape that a run stored.
struct BagShape {
  mesh::Mesh mesh;    // elements as in the run; panels are named panel_0, panel_1, ...
  double time = 0.0;  // [s]
  std::string file;   // the results file that it comes from
  /// [m] largest error of the coordinates; 0 for the doubles of fields.pvd.
  double error = 0.0;
};

/// File name endings of shapes, for help and messages.
inline constexpr const char* shape_endings = ".obj, .stl, .vtp, or LS-DYNA keyword .k, .key, .dyn";

/// Shape at the stored time nearest to `time` [s], from fields.pvd if the run wrote it, else from frames.bin.
/// Throws CaseError if
/// - the folder has neither, or the file is damaged,
/// - the run has not ended,
/// - `time` is before the first stored time or after the last.
BagShape read_bag_shape(const std::filesystem::path& results, double time);

}  // namespace driver
