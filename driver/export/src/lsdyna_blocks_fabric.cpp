// SPDX-License-Identifier: Apache-2.0
// Fabric and straps of an LS-DYNA deck.
#include <fmt/format.h>

#include "lsdyna_blocks.hpp"

namespace driver {
namespace {

/// Writes the fabric, one method a block.
class LsDynaFabric {
 public:
  LsDynaFabric(const Deck& deck, LsDynaCards& out) : deck_(deck), u_(out.units()), out_(out) {}
  void write();

 private:
  const BagPart& bag() const { return *deck_.scene->bag; }
  void section(int id, double thickness);
  void null_material(const DeckPart& p);
  void material(const DeckPart& p);
  void reference();
  void thread_curves();
  /// [Pa] modulus of warp or weft; for a curve the steepest slope, which determines the time step.
  double modulus(std::size_t thread, double linear) const {
    return threads_[thread] ? deck_.threads[thread].steepest : linear;
  }

  const Deck& deck_;
  const Units& u_;
  std::vector<int> leak_curves_;      // curves of the parts that leak by a table
  std::array<int, 2> threads_{0, 0};  // curves of warp and weft, of fabric by measured curves
  LsDynaCards& out_;
};

void LsDynaFabric::section(int id, double thickness) {
  // Fully integrated. If its third and fourth node are the same, it is the constant-strain triangle.
  constexpr int membrane = 9;
  out_.keyword("SECTION_SHELL");
  out_.row({{"SECID", whole(id, 10)},
            {"ELFORM", whole(membrane, 10)},
            {"SHRF", narrow(1.0)},
            {"NIP", whole(1, 10)}});
  const Field t = narrow(thickness / u_.length);
  out_.row({{"T1", t}, {"T2", t}, {"T3", t}, {"T4", t}});
}

void LsDynaFabric::write() {
  for (const DeckLeak& leak : deck_.leaks) {
    leak_curves_.push_back(leak.velocity ? out_.next_curve() : 0);
    if (leak.velocity)
      out_.curve_of_pressure(leak_curves_.back(), *leak.velocity, deck_.scene->ambient.pressure,
                             u_.velocity());
  }
  thread_curves();
  std::vector<int> parts;
  for (const DeckPart& p : deck_.parts) {
    p.null_panel ? null_material(p) : material(p);
    out_.part(p.id, p.name);
    out_.triangles(p.id, 1, 1, bag().mesh.elements, p.elements);
    parts.push_back(p.id);
  }
  out_.set("PART", LsDynaIds::bag_parts, parts);
  reference();
}

void LsDynaFabric::thread_curves() {
  if (deck_.threads[0].curve.empty()) return;
  constexpr int intervals = 1000;
  out_.line("$ warp and weft: second Piola-Kirchhoff stress over Green-Lagrange strain");
  for (std::size_t i = 0; i < 2; ++i) {
    threads_[i] = out_.next_curve();
    out_.curve(threads_[i], deck_.threads[i].curve, 1.0, u_.pressure(), intervals);
  }
}

void LsDynaFabric::null_material(const DeckPart& p) {
  const membrane::ElementProperties& f = a_fabric(deck_);
  constexpr double weightless = 1e-6;  // share of the fabric's density
  out_.keyword("MAT_NULL");
  out_.row({{"MID", whole(p.id, 10)},
            {"RO", narrow(weightless * f.density / u_.density())},
            {"PC", narrow(0.0)},
            {"MU", narrow(0.0)},
            {"TEROD", narrow(0.0)},
            {"CEROD", narrow(0.0)},
            {"YM", narrow(f.young_modulus / u_.pressure())},
            {"PR", narrow(f.poisson)}});
  section(p.id, f.thickness);
}

void LsDynaFabric::material(const DeckPart& p) {
  const membrane::ElementProperties& f = p.fabric;
  const double weft = f.weave ? f.weave->young_modulus_weft : f.young_modulus;
  const double shear = f.weave ? f.weave->shear : 0.5 * f.young_modulus / (1.0 + f.poisson);
  const auto& description = bag().model.description;
  const bool green = description.law == "saint_venant_kirchhoff";
  constexpr double green_lagrange = 12.0, invariant = 1.0, by_curves = 14.0;
  constexpr double by_share = 3.0, by_velocity = 7.0;  // by share uses Graefe's formula, which never chokes
  double coefficient = 0.0, factor = 0.0, option = 0.0;
  for (std::size_t i = 0; i < deck_.leaks.size(); ++i) {
    const DeckLeak& leak = deck_.leaks[i];
    if (leak.part != p.id) continue;
    coefficient = leak.velocity ? 1.0 : leak.share;
    factor = leak.velocity ? -leak_curves_[i] : 1.0;  // negative: the curve of that number
    option = leak.velocity ? by_velocity : by_share;
  }
  out_.keyword("MAT_FABRIC");
  out_.row({{"MID", whole(p.id, 10)},
            {"RO", narrow(f.density / u_.density())},
            {"EA", narrow(modulus(0, f.young_modulus) / u_.pressure())},
            {"EB", narrow(modulus(1, weft) / u_.pressure())},
            {"", blank(10)},
            {"PRBA", narrow(f.poisson * weft / f.young_modulus)},
            {"PRAB", narrow(f.poisson)}});
  const Field G = narrow(shear / u_.pressure());
  out_.row({{"GAB", G},
            {"GBC", G},
            {"GCA", G},
            {"CSE", narrow(description.compression == membrane::Compression::none ? 1.0 : 0.0)},
            {"EL", narrow(0.0)},
            {"PRL", narrow(0.0)},
            {"LRATIO", narrow(0.0)},
            {"DAMP", narrow(0.0)}});
  constexpr double by_vector = 2.0;
  out_.row({{"AOPT", narrow(f.weave ? by_vector : 0.0)},
            {"FLC", narrow(coefficient)},
            {"FAC", narrow(factor)},
            {"ELA", narrow(0.0)},
            {"LNRC", narrow(0.0)},
            {"FORM", narrow(threads_[0] ? by_curves
                            : green     ? green_lagrange
                                        : invariant)},
            {"FVOPT", narrow(option)},
            {"TSRFAC", narrow(0.0)}});
  const Eigen::Vector3d warp = f.weave ? f.weave->warp.normalized() : Eigen::Vector3d::Zero();
  out_.row({{"", blank(10)},
            {"RGBRTH", narrow(0.0)},
            {"A0REF", narrow(0.0)},
            {"A1", narrow(warp.x())},
            {"A2", narrow(warp.y())},
            {"A3", narrow(warp.z())},
            {"X0", narrow(0.0)},
            {"X1", narrow(0.0)}});
  out_.row({{"V1", narrow(0.0)},
            {"V2", narrow(0.0)},
            {"V3", narrow(0.0)},
            {"", blank(10)},
            {"", blank(10)},
            {"", blank(10)},
            {"BETA", narrow(0.0)},
            {"ISREFG", whole(green ? 1 : 0, 10)}});
  if (threads_[0])
    out_.row({{"LCA", whole(threads_[0], 10)},
              {"LCB", whole(threads_[1], 10)},
              {"LCAB", whole(0, 10)},
              {"LCUA", whole(0, 10)},
              {"LCUB", whole(0, 10)},
              {"LCUAB", whole(0, 10)},
              {"RL", narrow(0.0)}});
  section(p.id, f.thickness);
}

void LsDynaFabric::reference() {
  std::vector<int> elements;
  for (const DeckPart& p : deck_.parts)
    if (!p.null_panel) elements.insert(elements.end(), p.elements.begin(), p.elements.end());
  out_.keyword("AIRBAG_REFERENCE_GEOMETRY");
  out_.line("$    NID               X               Y               Z");
  for (const int n : corners_of(deck_, elements)) out_.node(n, bag().mesh.nodes.col(n - 1));
}

}  // namespace

void write_lsdyna_fabric(const Deck& deck, LsDynaCards& out) {
  LsDynaFabric(deck, out).write();
}

void write_lsdyna_straps(const Deck& deck, LsDynaCards& out) {
  const auto& straps = deck.scene->bag->model.description.straps;
  const Units& u = out.units();
  const DeckIds ids(deck);
  for (std::size_t i = 0; i < straps.size(); ++i) {
    const membrane::Strap& strap = straps[i];
    const int number = static_cast<int>(i), id = ids.strap_part + number, force = out.next_curve();
    out.curve(force, force_of(deck, strap), u.length, u.force());
    out.keyword("MAT_SPRING_NONLINEAR_ELASTIC");
    out.row({{"MID", whole(id, 10)}, {"LCD", whole(force, 10)}});
    out.discrete(id, "strap", ids.strap_element + number, {strap.node_a + 1, strap.node_b + 1});
  }
}

}  // namespace driver
