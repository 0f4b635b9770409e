// SPDX-License-Identifier: Apache-2.0
#include "checks.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "mesh/mesh.hpp"

namespace mesh {

std::string shown(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

std::string three_digits(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

void reject(std::string_view where, const std::string& field, double value, const std::string& allowed) {
  throw std::invalid_argument(std::string(where) + ": " + field + " = " + shown(value) +
                              ", allowed: " + allowed);
}

void require_positive(std::string_view where, const char* field, double value) {
  if (!(std::isfinite(value) && value > 0.0)) reject(where, field, value, "finite and > 0");
}

void require_nodes(std::string_view where, const Eigen::Ref<const Eigen::Matrix3Xi>& elements,
                   Eigen::Index node_count) {
  if (elements.cols() == 0) return;
  const int low = elements.minCoeff(), high = elements.maxCoeff();
  if (low < 0 || high >= node_count)
    reject(where, "node number", low < 0 ? low : high, "0 to " + std::to_string(node_count - 1));
}

void require_panels(std::string_view where, const Mesh& mesh) {
  if (mesh.panel.size() != static_cast<std::size_t>(mesh.element_count()))
    reject(where, "number of panel indices", static_cast<double>(mesh.panel.size()),
           "one for each of the " + std::to_string(mesh.element_count()) + " elements");
  for (const int index : mesh.panel)
    if (index < 0 || static_cast<std::size_t>(index) >= mesh.panel_names.size())
      reject(where, "panel index", index,
             "one of the " + std::to_string(mesh.panel_names.size()) + " panels");
}

}  // namespace mesh
