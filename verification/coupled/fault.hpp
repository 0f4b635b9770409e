// SPDX-License-Identifier: Apache-2.0
// A shipped case with one fault in it, and the place where it is refused.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "case_folder.hpp"

namespace coupled {

struct Fault {
  const char* name;
  const char* base;            // shipped case
  const char* find;            // text in it ...
  const char* replacement;     // ... and what a user might have written instead
  const char* key;             // named in the message
  const char* says;            // part of the message
  const char* mark = nullptr;  // the message names the first place of this text: where the faulty key stands,
                               // the table's head for a missing key, the file's start (empty) for a missing
                               // table; without it, where the replacement begins
};

inline void PrintTo(const Fault& fault, std::ostream* out) {
  *out << fault.name;
}

/// `file:line:column` of the character `at`.
inline std::string place_of(const fs::path& file, const std::string& text, std::size_t at) {
  const std::string before = text.substr(0, at);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const auto start = before.rfind('\n');
  const auto column = at - (start == std::string::npos ? 0 : start + 1) + 1;
  return file.string() + ":" + std::to_string(line) + ":" + std::to_string(column);
}

inline void expect_refused_where_it_stands(const Fault& fault) {
  std::string text = read(std::string(GASJET_SOURCE_DIR "/cases/") + fault.base + ".toml");
  const auto at = text.find(fault.find);
  ASSERT_NE(at, std::string::npos) << fault.find;
  text.replace(at, std::string(fault.find).size(), fault.replacement);
  const Folder folder;
  const fs::path file = folder.path / "bad.toml";
  std::ofstream(file) << text;

  const std::string message = message_of(file);
  EXPECT_NE(message.find(fault.key), std::string::npos) << message;
  EXPECT_NE(message.find(fault.says), std::string::npos) << message;
  const auto marked = fault.mark ? text.find(fault.mark) : at;
  ASSERT_NE(marked, std::string::npos) << fault.mark;
  EXPECT_EQ(message.substr(0, message.find(": ")), place_of(file, text, marked)) << message;
}

}  // namespace coupled
