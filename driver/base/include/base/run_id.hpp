// SPDX-License-Identifier: Apache-2.0
// Identification of a computation: the first lines of its files, and its id.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace driver {

/// The first lines, `# key: value`, of each result file.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// Version, commit, compiler and flags of this build, as the results name them.
Provenance build_lines();

/// Id of a computation: 16 hexadecimal digits that depend on everything that determines the results: `facts`,
/// the contents of `files`, and the build. Equal computations have equal ids.
std::string run_id(const std::vector<std::string>& facts, const std::vector<std::filesystem::path>& files);

/// Hash of a text: 16 hexadecimal digits.
std::string digits_of(std::string_view text);
/// Hash of a file's content; empty if it cannot be read. All pipes have the same hash.
std::optional<std::string> digits_of_file(const std::filesystem::path& file);

/// `text`, of any bytes, in UTF-8 on one line: control characters become \xNN.
std::string one_line(const std::string& text);
/// `lines` as `# key: value`, each made one line by one_line.
std::string comment_lines(const Provenance& lines);

}  // namespace driver
