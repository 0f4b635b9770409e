// SPDX-License-Identifier: Apache-2.0
// frames.bin as the page takes it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace driver {

/// Header and base64 of frames.bin, and how many of its frames are kept: every k-th, so that they have at
/// most `most_bytes`. Null if there is no such file. Throws as load_frames.
nlohmann::ordered_json read_frames(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace driver
