// SPDX-License-Identifier: Apache-2.0
// Pictures of results, by gnuplot; colours and lines are those of docs/charts/gnuplot/style.gp.
#pragma once

#include <string>

#include "base/result_folder.hpp"

namespace driver {

/// The first commands for NAME.svg of this size [pixels].
std::string gnuplot_head(const std::string& name, int width, int height);

/// A gnuplot expression with this text as value, in single quotes: they contain no commands, escapes or
/// variables. Control characters become spaces.
std::string gnuplot_text(const std::string& text);

/// Data block $NAME of `rows`, each with its end of line. A block without rows draws nothing.
std::string gnuplot_block(const std::string& name, const std::string& rows);

/// Writes `commands` to NAME.gp and lets gnuplot draw NAME.svg. Returns what failed; empty if nothing did.
std::string draw_picture(ResultFolder& folder, const std::string& name, const std::string& commands);

}  // namespace driver
