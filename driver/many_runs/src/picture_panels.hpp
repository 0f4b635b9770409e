// SPDX-License-Identifier: Apache-2.0
// Panels of a picture, and the texts in it. Names of a plan reach gnuplot as texts only.
#pragma once

#include <string>
#include <vector>

namespace driver {

inline constexpr std::size_t most_lines = 8;       // that a reader tells apart: line styles
inline constexpr std::size_t most_marks = 20'000;  // beyond that a picture is a blot

/// Panels in columns, with room for what stands around each [pixels].
struct Panels {
  std::size_t count = 0;
  int columns = 1, height = 220;  // of a panel
  int left = 90, right = 20, below = 84, top = 6;
};

/// Settings of a key above all panels: that of the first one.
std::string key_above(Panels& all, std::size_t entries);
/// Opens the commands of a picture: its panels follow.
std::string open_panels(const std::string& name, const Panels& all, const std::string& settings);
/// A panel of plots.
std::string panel(const std::string& title, const std::vector<std::string>& plots);
/// Settings of an axis with texts at its places.
std::string named_tics(const char* axis, const std::vector<std::string>& names,
                       const std::vector<double>& places);
/// Settings of panels with rows that have names, from 0 downwards. Makes room for them and for `count`.
std::string named_rows(Panels& all, const std::vector<std::string>& names);

}  // namespace driver
