// SPDX-License-Identifier: Apache-2.0
#include "results/gnuplot.hpp"

#include <fmt/format.h>

#include "gnuplot_run.hpp"

namespace driver {

std::string gnuplot_head(const std::string& name, int width, int height) {
  return fmt::format(R"(
set terminal svg size {},{} font 'sans-serif,13' background '#ffffff' noenhanced
set output '{}.svg'
set encoding utf8
set border 3 linecolor rgb '#222222'
set tics nomirror
set grid linecolor rgb '#c8c8c8' linewidth 0.5 dashtype 3
)",
                     width, height, name);
}

std::string gnuplot_block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << EOD\n{}EOD\n", name, rows.empty() ? "NaN NaN NaN\n" : rows);
}

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    // Not '', which gnuplot rejects at the ends of a string.
    if (c == '\'')
      quoted += "'.\"'\".'";
    else
      quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return quoted + "'";
}

std::string draw_picture(ResultFolder& folder, const std::string& name, const std::string& commands) {
  const std::string picture = name + ".svg";
  folder.write(name + ".gp", fmt::format("# run: {}\n", folder.run()) + commands);
  folder.add(picture);
  std::string problem = run_gnuplot(folder.path(), name);
  if (!problem.empty()) folder.remove(picture);  // half a picture
  return problem;
}

}  // namespace driver
