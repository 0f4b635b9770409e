// SPDX-License-Identifier: Apache-2.0
#include "checks.hpp"

#include <cmath>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "membrane/bag_model.hpp"
#include "membrane/law_table.hpp"

namespace membrane {

std::string shown(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

void reject(std::string_view where, const std::string& problem) {
  throw std::invalid_argument(std::string(where) + ": " + problem);
}

void reject(std::string_view where, const std::string& field, double value, const std::string& allowed) {
  reject(where, field + " = " + shown(value) + ", allowed: " + allowed);
}

void require_elements(std::string_view where, const BagModel& model, std::span<const int> elements) {
  for (const int e : elements)
    if (e < 0 || e >= model.element_count)
      reject(where, "element", e, "0 to " + std::to_string(model.element_count - 1));
}

void require_positive(std::string_view where, const char* field, double value) {
  if (!(std::isfinite(value) && value > 0.0)) reject(where, field, value, "finite and > 0");
}

void require_not_negative(std::string_view where, const char* field, double value) {
  if (!(std::isfinite(value) && value >= 0.0)) reject(where, field, value, "finite and >= 0");
}

void require_finite(std::string_view where, const char* field, double value) {
  if (!std::isfinite(value)) reject(where, field, value, "finite");
}

void require_node(std::string_view where, const char* field, int node, Eigen::Index node_count) {
  if (node < 0 || node >= node_count)
    reject(where, field, node, "a node number, 0 to " + std::to_string(node_count - 1));
}

namespace {

std::string element_name(Eigen::Index e) {
  return "element " + std::to_string(e);
}

void check_nodes(const BagDescription& d) {
  if (d.reference.cols() == 0) reject("reference", "no nodes");
  for (Eigen::Index n = 0; n < d.reference.cols(); ++n)
    for (int c = 0; c < 3; ++c)
      require_finite("node " + std::to_string(n), "reference coordinate", d.reference(c, n));
  for (const int node : d.fixed_nodes) require_node("fixed_nodes", "node", node, d.reference.cols());
  for (const auto& nodes : d.held_nodes)
    for (const int node : nodes) require_node("held_nodes", "node", node, d.reference.cols());
}

void check_corners(const Eigen::Matrix3Xi& elements, Eigen::Index e, Eigen::Index node_count) {
  const auto corner = elements.col(e);
  for (int k = 0; k < 3; ++k) require_node(element_name(e), "node", corner[k], node_count);
  if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
    reject(element_name(e), "a node is repeated");
}

void check_warp(std::string_view where, const ElementProperties& p) {
  for (int c = 0; c < 3; ++c) require_finite(where, "warp", p.weave->warp[c]);
  require_positive(where, "length of the warp", p.weave->warp.norm());
}

void check_weave(std::string_view where, const ElementProperties& p) {
  require_positive(where, "young_modulus_weft", p.weave->young_modulus_weft);
  require_positive(where, "shear", p.weave->shear);
  const double ratio = p.weave->shear / (std::sqrt(p.young_modulus) * std::sqrt(p.weave->young_modulus_weft));
  if (!(ratio >= 1e-4 && ratio <= 100.0))
    reject(where, "shear / sqrt(young_modulus young_modulus_weft)", ratio, "1e-4 to 100");
  // Slightly inside the limit at which the stiffness becomes singular.
  if (!(p.poisson * p.poisson * (p.weave->young_modulus_weft / p.young_modulus) < 0.998))
    reject(where, "poisson", p.poisson, "poisson^2 < 0.998 young_modulus / young_modulus_weft");
  check_warp(where, p);
}

void check_curve(const char* where, const StressCurve& c) {
  const auto points = static_cast<double>(c.strain.size());
  if (c.strain.size() != c.stress.size())
    reject(where, "stresses", static_cast<double>(c.stress.size()), "one for each strain");
  if (c.strain.size() < 2 || c.strain.size() > kMostCurvePoints)
    reject(where, "points", points, "2 to " + std::to_string(kMostCurvePoints));
  for (std::size_t i = 0; i < c.strain.size(); ++i) {
    require_finite(where, "strain", c.strain[i]);
    require_finite(where, "stress", c.stress[i]);
  }
  if (c.strain[0] != 0.0 || c.stress[0] != 0.0)
    reject(where,
           "the first point is (" + shown(c.strain[0]) + ", " + shown(c.stress[0]) + "), allowed: (0, 0)");
  for (std::size_t i = 1; i < c.strain.size(); ++i)
    for (const auto* values : {&c.strain, &c.stress})
      if (!((*values)[i] > (*values)[i - 1]))
        reject(where, std::string(values == &c.strain ? "strain " : "stress ") + shown((*values)[i]) +
                          " follows " + shown((*values)[i - 1]) + ", allowed: strictly rising");
}

void check_own(std::string_view where, const ElementProperties& p, const LawTraits& law) {
  if (std::ssize(p.law_constants) != law.own_count)
    reject(where, "law_constants", static_cast<double>(p.law_constants.size()),
           std::to_string(law.own_count) + " for the law \"" + law.name + "\"");
  for (int i = 0; i < law.own_count; ++i) {
    const LawConstant& own = law.own[i];
    const double value = p.law_constants[static_cast<std::size_t>(i)];
    if (!(value >= own.least && value <= own.most))
      reject(where, own.name, value, shown(own.least) + " to " + shown(own.most));
  }
}

void check_properties(std::string_view where, const ElementProperties& p, const LawTraits& law) {
  if (!(p.porosity >= 0.0 && p.porosity <= 1.0)) reject(where, "porosity", p.porosity, "0 to 1");
  if (p.null_panel) {
    if (p.porosity != 0.0) reject(where, "porosity", p.porosity, "0 on a null panel");
    return;
  }
  require_positive(where, "thickness", p.thickness);
  require_positive(where, "density", p.density);
  if (!find_law(law.name, p.weave.has_value()))
    reject(where, "the law \"" + std::string(law.name) +
                      (p.weave ? "\" is for isotropic fabric, without weave" : "\" needs a weave"));
  check_own(where, p, law);
  if (law.curves) {
    require_positive(where, "shear", p.weave->shear);
    return check_warp(where, p);
  }
  require_positive(where, "young_modulus", p.young_modulus);
  if (p.weave) return check_weave(where, p);
  if (!(p.poisson > -1.0 && p.poisson < 1.0)) reject(where, "poisson", p.poisson, "-1 < nu < 1");
}

void check_elements(const BagDescription& d) {
  if (d.elements.cols() == 0) reject("elements", "no elements");
  if (d.properties.size() != static_cast<std::size_t>(d.elements.cols()))
    reject("properties", "count", static_cast<double>(d.properties.size()),
           "one per element, " + std::to_string(d.elements.cols()));
  for (Eigen::Index e = 0; e < d.elements.cols(); ++e) {
    check_corners(d.elements, e, d.reference.cols());
    check_properties(element_name(e), d.properties[static_cast<std::size_t>(e)], law_named(d.law));
  }
}

void check_straps(const BagDescription& d) {
  for (std::size_t i = 0; i < d.straps.size(); ++i) {
    const std::string where = "strap " + std::to_string(i);
    require_node(where, "node_a", d.straps[i].node_a, d.reference.cols());
    require_node(where, "node_b", d.straps[i].node_b, d.reference.cols());
    if (d.straps[i].node_a == d.straps[i].node_b) reject(where, "both ends are the same node");
    require_positive(where, "stiffness", d.straps[i].stiffness);
    require_positive(where, "free_length", d.straps[i].free_length);
  }
}

void check_plates(const BagDescription& d) {
  for (std::size_t i = 0; i < d.plates.size(); ++i) {
    const std::string where = "plate " + std::to_string(i);
    for (int c = 0; c < 3; ++c) {
      require_finite(where, "point", d.plates[i].point[c]);
      require_finite(where, "normal", d.plates[i].normal[c]);
    }
    require_positive(where, "length of the normal", d.plates[i].normal.norm());
    if (d.plates[i].stiffness) require_positive(where, "stiffness", *d.plates[i].stiffness);
  }
}

void check_law(const BagDescription& d) {
  const LawTraits& law = law_named(d.law);
  if (!law.compression && d.compression != Compression::none)
    reject("bag", "the law \"" + d.law + "\" carries no compression; allowed with it: Compression::none");
  if (!law.curves) return;
  check_curve("curve of the warp", d.curves[0]);
  check_curve("curve of the weft", d.curves[1]);
}

}  // namespace

void check_description(const BagDescription& d) {
  check_nodes(d);
  check_elements(d);
  check_law(d);
  check_straps(d);
  check_plates(d);
  if (d.compression != Compression::linear && d.compression != Compression::none)
    reject("bag", "compression", static_cast<double>(d.compression), "an enumerator");
  require_not_negative("bag", "mass_damping", d.mass_damping);
  require_not_negative("bag", "stiffness_damping", d.stiffness_damping);
  for (int c = 0; c < 3; ++c) require_finite("bag", "gravity", d.gravity[c]);
}

}  // namespace membrane
