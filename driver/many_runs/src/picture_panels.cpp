// SPDX-License-Identifier: Apache-2.0
#include "picture_panels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "results/gnuplot.hpp"

namespace driver {
namespace {

constexpr int all_width = 900, title_height = 34;  // [pixels]

// The text at a tic is a format of its place.
std::string as_tic(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '%' ? "%%" : std::string(1, c);
  return text;
}

}  // namespace

std::string key_above(Panels& all, std::size_t entries) {
  all.top += 17 * static_cast<int>(entries) + 6;
  return fmt::format("set key at screen 0.5, screen 0.995 center top vertical maxrows {}\n", entries);
}

std::string open_panels(const std::string& name, const Panels& all, const std::string& settings) {
  const int rows = (static_cast<int>(all.count) + all.columns - 1) / all.columns;
  const int height = all.top + rows * (title_height + all.height + all.below);
  const double w = all_width, h = height;
  return gnuplot_head(name, all_width, height) + R"(set style fill solid 1 noborder
set style line 1 linecolor rgb '#0072b2' linewidth 2 pointtype 7 pointsize 0.6
set style line 2 linecolor rgb '#d55e00' linewidth 2 dashtype 2 pointtype 5 pointsize 0.6
set style line 3 linecolor rgb '#009e73' linewidth 2 dashtype 4 pointtype 9 pointsize 0.7
set style line 4 linecolor rgb '#222222' linewidth 2 dashtype 3 pointtype 6 pointsize 0.7
set style line 5 linecolor rgb '#aa4499' linewidth 2 dashtype 5 pointtype 4 pointsize 0.7
set style line 6 linecolor rgb '#56b4e9' linewidth 2 pointtype 8 pointsize 0.7
set style line 7 linecolor rgb '#767676' linewidth 2 dashtype 2 pointtype 10 pointsize 0.7
set style line 8 linecolor rgb '#e69f00' linewidth 2 dashtype 4 pointtype 11 pointsize 0.7
set key noautotitle font ',11'
set title offset 0,-0.6
set xlabel offset 0,0.5
set xtics rotate by 25 right
set format xy '%g'
)" + settings +
         fmt::format("set multiplot layout {},{} margins {:.4f},{:.4f},{:.4f},{:.4f} spacing {:.4f},{:.4f}\n",
                     rows, all.columns, all.left / w, 1.0 - all.right / w, all.below / h,
                     1.0 - (all.top + title_height) / h, (all.left + all.right) / w,
                     (title_height + all.below) / h);
}

std::string panel(const std::string& title, const std::vector<std::string>& plots) {
  return fmt::format("set title {}\nplot {}\n", gnuplot_text(title), fmt::join(plots, ", \\\n  "));
}

std::string named_tics(const char* axis, const std::vector<std::string>& names,
                       const std::vector<double>& places) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list.push_back(fmt::format("{} {}", gnuplot_text(as_tic(names[i])), places[i]));
  return fmt::format("set {} ({})\n", axis, fmt::join(list, ", "));
}

std::string named_rows(Panels& all, const std::vector<std::string>& names) {
  constexpr std::size_t letter_width = 8, most_letters = 60, narrow = 26;
  std::size_t letters = 1;
  for (const auto& name : names)
    letters = std::max(letters, static_cast<std::size_t>(
                                    std::ranges::count_if(name, [](char c) { return (c & 0xc0) != 0x80; })));
  all.columns = all.count > 1 && letters <= narrow ? 2 : 1;
  all.left = static_cast<int>(letter_width * std::min(letters, most_letters)) + 20;
  all.height = 30 * static_cast<int>(names.size()) + 10;
  std::vector<double> places;
  for (std::size_t i = 0; i < names.size(); ++i) places.push_back(static_cast<double>(i));
  return fmt::format("set yrange [{}:-0.6]\nset ytics scale 0\nset grid noytics\n",
                     static_cast<double>(names.size()) - 0.4) +
         named_tics("ytics", names, places);
}

}  // namespace driver
