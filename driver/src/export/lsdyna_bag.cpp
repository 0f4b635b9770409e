// SPDX-License-Identifier: Apache-2.0
// Fabric and straps of an LS-DYNA deck.
#include <fmt/format.h>

#include "export/lsdyna_deck.hpp"

namespace driver {

void LsDynaDeck::part(int id, std::string_view name) {
  keyword("PART");
  out_.label(name, 70);
  row({{"PID", whole(id, 10)}, {"SECID", whole(id, 10)}, {"MID", whole(id, 10)}});
}

void LsDynaDeck::membrane_section(int id, double thickness) {
  // Fully integrated: with its third and fourth node the same it is the triangle of constant strain.
  constexpr int membrane = 9;
  keyword("SECTION_SHELL");
  row({{"SECID", whole(id, 10)},
       {"ELFORM", whole(membrane, 10)},
       {"SHRF", narrow(1.0)},
       {"NIP", whole(1, 10)}});
  const Field t = narrow(thickness / u_.length);
  row({{"T1", t}, {"T2", t}, {"T3", t}, {"T4", t}});
}

void LsDynaDeck::triangles(int part_id, int first_element, int first_node, const Eigen::Matrix3Xi& corners,
                           const std::vector<int>& elements) {
  keyword("ELEMENT_SHELL");
  out_.line("$    EID     PID      N1      N2      N3      N4");
  for (const int e : elements) {
    const Field last = whole(first_node + corners(2, e), 8);
    out_.card({whole(first_element + e, 8), whole(part_id, 8), whole(first_node + corners(0, e), 8),
               whole(first_node + corners(1, e), 8), last, last});
  }
}

void LsDynaDeck::fabric() {
  for (const DeckLeak& leak : deck_.leaks) {
    leak_curves_.push_back(leak.velocity ? next_curve_++ : 0);
    if (leak.velocity) curve_of_pressure(leak_curves_.back(), *leak.velocity, u_.velocity());
  }
  std::vector<int> parts;
  for (const DeckPart& p : deck_.parts) {
    p.null_panel ? null_material(p) : fabric_material(p);
    part(p.id, p.name);
    triangles(p.id, 1, 1, bag().mesh.elements, p.elements);
    parts.push_back(p.id);
  }
  set("PART", bag_parts, parts);
  reference();
}

void LsDynaDeck::null_material(const DeckPart& p) {
  const membrane::ElementProperties& f = a_fabric(deck_);
  constexpr double weightless = 1e-6;  // share of the fabric's density
  keyword("MAT_NULL");
  row({{"MID", whole(p.id, 10)},
       {"RO", narrow(weightless * f.density / u_.density())},
       {"PC", narrow(0.0)},
       {"MU", narrow(0.0)},
       {"TEROD", narrow(0.0)},
       {"CEROD", narrow(0.0)},
       {"YM", narrow(f.young_modulus / u_.pressure())},
       {"PR", narrow(f.poisson)}});
  membrane_section(p.id, f.thickness);
}

void LsDynaDeck::fabric_material(const DeckPart& p) {
  const membrane::ElementProperties& f = p.fabric;
  const double weft = f.weave ? f.weave->young_modulus_weft : f.young_modulus;
  const double shear = f.weave ? f.weave->shear : 0.5 * f.young_modulus / (1.0 + f.poisson);
  const auto& description = bag().model.description;
  const bool green = description.law == membrane::FabricLaw::saint_venant_kirchhoff;
  constexpr double green_lagrange = 12.0, invariant = 1.0;
  constexpr double by_share = 3.0, by_velocity = 7.0;  // by share: Graefe's formula, which never chokes
  double coefficient = 0.0, factor = 0.0, option = 0.0;
  for (std::size_t i = 0; i < deck_.leaks.size(); ++i) {
    const DeckLeak& leak = deck_.leaks[i];
    if (leak.part != p.id) continue;
    coefficient = leak.velocity ? 1.0 : leak.share;
    factor = leak.velocity ? -leak_curves_[i] : 1.0;  // negative: the curve of that number
    option = leak.velocity ? by_velocity : by_share;
  }
  keyword("MAT_FABRIC");
  row({{"MID", whole(p.id, 10)},
       {"RO", narrow(f.density / u_.density())},
       {"EA", narrow(f.young_modulus / u_.pressure())},
       {"EB", narrow(weft / u_.pressure())},
       {"", blank(10)},
       {"PRBA", narrow(f.poisson * weft / f.young_modulus)},
       {"PRAB", narrow(f.poisson)}});
  const Field G = narrow(shear / u_.pressure());
  row({{"GAB", G},
       {"GBC", G},
       {"GCA", G},
       {"CSE", narrow(description.compression == membrane::Compression::none ? 1.0 : 0.0)},
       {"EL", narrow(0.0)},
       {"PRL", narrow(0.0)},
       {"LRATIO", narrow(0.0)},
       {"DAMP", narrow(0.0)}});
  constexpr double by_vector = 2.0;
  row({{"AOPT", narrow(f.weave ? by_vector : 0.0)},
       {"FLC", narrow(coefficient)},
       {"FAC", narrow(factor)},
       {"ELA", narrow(0.0)},
       {"LNRC", narrow(0.0)},
       {"FORM", narrow(green ? green_lagrange : invariant)},
       {"FVOPT", narrow(option)},
       {"TSRFAC", narrow(0.0)}});
  const Eigen::Vector3d warp = f.weave ? f.weave->warp.normalized() : Eigen::Vector3d::Zero();
  row({{"", blank(10)},
       {"RGBRTH", narrow(0.0)},
       {"A0REF", narrow(0.0)},
       {"A1", narrow(warp.x())},
       {"A2", narrow(warp.y())},
       {"A3", narrow(warp.z())},
       {"X0", narrow(0.0)},
       {"X1", narrow(0.0)}});
  row({{"V1", narrow(0.0)},
       {"V2", narrow(0.0)},
       {"V3", narrow(0.0)},
       {"", blank(10)},
       {"", blank(10)},
       {"", blank(10)},
       {"BETA", narrow(0.0)},
       {"ISREFG", whole(green ? 1 : 0, 10)}});
  membrane_section(p.id, f.thickness);
}

void LsDynaDeck::reference() {
  std::vector<int> elements;
  for (const DeckPart& p : deck_.parts)
    if (!p.null_panel) elements.insert(elements.end(), p.elements.begin(), p.elements.end());
  keyword("AIRBAG_REFERENCE_GEOMETRY");
  out_.line("$    NID               X               Y               Z");
  for (const int n : corners_of(deck_, elements)) node(n, bag().mesh.nodes.col(n - 1));
}

void LsDynaDeck::straps() {
  const auto& straps = bag().model.description.straps;
  for (std::size_t i = 0; i < straps.size(); ++i) {
    const membrane::Strap& strap = straps[i];
    const int number = static_cast<int>(i), id = ids_.strap_part + number, force = next_curve_++;
    curve(force, force_of(deck_, strap), u_.length, u_.force());
    keyword("MAT_SPRING_NONLINEAR_ELASTIC");
    row({{"MID", whole(id, 10)}, {"LCD", whole(force, 10)}});
    keyword("SECTION_DISCRETE");
    row({{"SECID", whole(id, 10)},
         {"DRO", whole(0, 10)},
         {"KD", narrow(0.0)},
         {"V0", narrow(0.0)},
         {"CL", narrow(0.0)},
         {"FD", narrow(0.0)}});
    row({{"CDL", narrow(0.0)}, {"TDL", narrow(0.0)}});
    part(id, "strap");
    keyword("ELEMENT_DISCRETE");
    row({{"EID", whole(ids_.strap_element + number, 8)},
         {"PID", whole(id, 8)},
         {"N1", whole(strap.node_a + 1, 8)},
         {"N2", whole(strap.node_b + 1, 8)},
         {"VID", whole(0, 8)},
         {"S", real(1.0, 16)},
         {"PF", whole(0, 8)},
         {"OFFSET", real(0.0, 16)}});
  }
}

}  // namespace driver
