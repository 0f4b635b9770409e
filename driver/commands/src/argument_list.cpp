// SPDX-License-Identifier: Apache-2.0
#include "argument_list.hpp"

#include <algorithm>

namespace driver::commands {

std::vector<std::string> words(int argc, char** argv) {
  std::vector<std::string> list;
  for (int i = argc - 1; i > 0; --i) {
    std::string word = argv[i];
    if (word.starts_with("--") && word.find('=') + 1 == word.size()) {
      list.emplace_back();
      word.pop_back();
    }
    list.push_back(std::move(word));
  }
  return list;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<std::string> names_of(const std::vector<std::string>& lists) {
  std::vector<std::string> names;
  for (const auto& list : lists)
    for (auto& name : split(list, ',')) names.push_back(std::move(name));
  return names;
}

}  // namespace driver::commands
