// SPDX-License-Identifier: Apache-2.0
// frames.bin: the moving bag, or a rigid target, in one compact file, for `gasjet report` (docs/results.md
// has the format).
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/result_folder.hpp"
#include "engine/scene.hpp"
#include "engine/state.hpp"

namespace driver {

class TargetPicture;

/// Value of the header's key "file"; its "format" is that of the results (formats.hpp).
inline constexpr const char* frames_file = "gasjet frames";

/// Bytes of a frame: doubles, then 16-bit numbers for nodes (three coordinates, speed) and elements
/// (overpressure of the jets, strain), then a byte for each element (jet mask), filled up to a multiple of 8.
constexpr std::size_t frame_bytes(std::size_t scalars, std::size_t nodes, std::size_t elements) {
  return (8 * scalars + 8 * nodes + 5 * elements + 7) / 8 * 8;
}

/// A line of JSON with constant data and the layout of a frame, then frames of equal size, little-endian.
/// Positions, speeds, strains and overpressures are 16-bit multiples of a step that each frame states, so
/// their error is at most half a step.
class FrameWriter {
 public:
  /// Writes frames.bin of the folder's run. Precondition: the scene has a bag or a target. Throws OutputError
  /// when the file cannot be opened.
  FrameWriter(ResultFolder& folder, const Scene& scene);
  ~FrameWriter();
  /// Writes level n; call it when the forces of n are complete (LevelView::show). Throws WriteError.
  void write(const State& state);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
  const Scene& scene_;
  std::unique_ptr<const TargetPicture> target_;  // null for a bag
};

/// Content of frames.bin.
struct Frames {
  nlohmann::ordered_json header;  // its first line
  std::string data;               // whole frames of header["frame_bytes"] bytes, at least one
};
/// Reads frames.bin. Throws CaseError if the file is of another kind, or if it is not made of whole frames of
/// the size in its header.
Frames load_frames(const std::filesystem::path& file);

}  // namespace driver
