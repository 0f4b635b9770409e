// SPDX-License-Identifier: Apache-2.0
// Words and lists of a command line.
#pragma once

#include <string>
#include <vector>

namespace driver::commands {

/// The words of a command line without the first, in reverse, as CLI11 takes them. "--name=" has the empty
/// value, not what stands after it.
std::vector<std::string> words(int argc, char** argv);

/// The parts of a list between separators, empty ones too.
std::vector<std::string> split(const std::string& text, char separator);

/// The names of every list with commas, empty ones too.
std::vector<std::string> names_of(const std::vector<std::string>& lists);

}  // namespace driver::commands
