// SPDX-License-Identifier: Apache-2.0
// What the page is put together from.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "driver/report.hpp"

namespace driver {

/// Files of driver/src/report/page and three.js, as they were when this was built; three.js and its controls
/// are empty if the package was not there.
struct PageParts {
  std::string_view html, style, charts, series, scene, main, three, orbit;
};
PageParts page_parts();

/// One result, as page/main.js reads it. Throws as report_page.
std::vector<nlohmann::ordered_json> gather(const std::filesystem::path& result, const ReportOptions& options);

/// What frames.bin holds.
struct Frames {
  nlohmann::ordered_json header;  // its first line
  std::string data;               // whole frames of header["frame_bytes"] bytes, at least one
};
/// Reads frames.bin. Throws CaseError if the file is of another kind, or if it does not hold whole frames of
/// the size in its header.
Frames load_frames(const std::filesystem::path& file);

/// Header and base64 of frames.bin, and how many of its frames are kept: every k-th, so that they have at
/// most `most_bytes`. Null if there is no such file. Throws as load_frames.
nlohmann::ordered_json read_frames(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace driver
