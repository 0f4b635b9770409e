// SPDX-License-Identifier: Apache-2.0
// What names a computation: the lines that open its files, and its id.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace driver {

/// Lines `# key: value` that open each result file.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// Version, commit, compiler and flags of this build, as the results name them.
Provenance build_lines();

/// Tells the results of one computation from those of another: 16 hexadecimal digits of what the results
/// follow from, which are `facts`, the contents of `files`, and the build. Equal computations have equal ids.
std::string run_id(const std::vector<std::string>& facts, const std::vector<std::filesystem::path>& files);

/// Tells a text from others: 16 hexadecimal digits.
std::string digits_of(std::string_view text);
/// The same of what a file holds; nothing if it cannot be read. All pipes have the same.
std::optional<std::string> digits_of_file(const std::filesystem::path& file);

/// `text` in UTF-8 on one line, whatever bytes it holds: control characters stand as \xNN.
std::string one_line(const std::string& text);
/// `lines` as `# key: value` in UTF-8, each on one line whatever bytes the value holds.
std::string comment_lines(const Provenance& lines);

}  // namespace driver
