// SPDX-License-Identifier: Apache-2.0
// frames.bin in the form of the page.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace driver {

/// Header and base64 of frames.bin, with the number of frames kept: every k-th, so that they have at most
/// `most_bytes`. Null if there is no such file. Throws as load_frames.
nlohmann::ordered_json read_frames(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace driver
