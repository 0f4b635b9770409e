// SPDX-License-Identifier: Apache-2.0
// Case files made by a test, and what reading them says.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "engine/state.hpp"
#include "results/load_scene.hpp"

namespace coupled {

namespace fs = std::filesystem;

inline std::string read(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// A folder of its own for each test, removed at the end.
struct Folder {
  fs::path path;
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "gasjet_case_XXXXXX").string();
    path = mkdtemp(pattern.data());
  }
  ~Folder() { fs::remove_all(path); }
};

inline std::string message_of(const fs::path& file, const std::vector<std::string>& overrides = {}) {
  try {
    driver::CaseDocument document(file, overrides);
    driver::make_state(driver::load_scene(document));
  } catch (const driver::CaseError& error) {
    return error.what();
  }
  return "accepted";
}

inline driver::Scene scene_of_text(const Folder& folder, const std::string& text,
                                   const std::vector<std::string>& overrides) {
  std::ofstream(folder.path / "case.toml") << text;
  driver::CaseDocument document(folder.path / "case.toml", overrides);
  return driver::load_scene(document);
}

}  // namespace coupled
