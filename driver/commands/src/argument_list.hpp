// SPDX-License-Identifier: Apache-2.0
// Words and lists of a command line.
#pragma once

#include <string>
#include <vector>

namespace driver::commands {

/// The words of a command line without the first, reversed for CLI11. "--name=" has an empty value; it does
/// not take the next word.
std::vector<std::string> words(int argc, char** argv);

/// The parts of a list between separators, including empty ones.
std::vector<std::string> split(const std::string& text, char separator);

/// The names of all lists with commas, including empty ones.
std::vector<std::string> names_of(const std::vector<std::string>& lists);

}  // namespace driver::commands
