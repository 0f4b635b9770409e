// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"

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

}  // namespace driver::commands
