// SPDX-License-Identifier: Apache-2.0
// Pictures of results, by gnuplot; colours and lines are those of docs/charts/gnuplot/style.gp.
#pragma once

#include <string>

#include "base/result_folder.hpp"

namespace driver {

/// Opens the commands of NAME.svg of this size [pixels].
std::string gnuplot_head(const std::string& name, int width, int height);

/// An expression of gnuplot's whose value is this text: within single quotes nothing is a command, an escape
/// or a variable. Control characters become spaces.
std::string gnuplot_text(const std::string& text);

/// Data block $NAME of `rows`, each with its line end; one of no rows draws nothing.
std::string gnuplot_block(const std::string& name, const std::string& rows);

/// Writes `commands` to NAME.gp and lets gnuplot draw NAME.svg. What kept it from that; empty: nothing.
std::string draw_picture(ResultFolder& folder, const std::string& name, const std::string& commands);

}  // namespace driver
