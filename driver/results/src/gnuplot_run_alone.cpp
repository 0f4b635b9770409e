// SPDX-License-Identifier: Apache-2.0
// For a program that starts no other (cmake/alone).
#include "gnuplot_run.hpp"

namespace driver {

std::string run_gnuplot(const std::filesystem::path&, const std::string&) {
  return "gnuplot: this program starts no other program";
}

}  // namespace driver
