// SPDX-License-Identifier: Apache-2.0
// The surface and the fabric of a Radioss deck: LAW19, LAW58, LAW1 and void parts, with their properties.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bag_fabric.hpp"
#include "deck_reader.hpp"
#include "radioss_tables.hpp"

namespace driver::imported {

void map_surface(RadiossContext& c) {
  take_nodes(c.tables.nodes, c.units.length, c.bag, c.report);
  const DeckFields f = c.tens(c.volume, 1);
  RadiossSurface surface = c.surface(f.whole(0, "surf_IDex"), f.at());
  for (const long part : surface.parts) {
    if (c.panels.contains(part)) continue;
    const auto found = c.tables.parts.find(part);
    c.panels[part] = panel_name(found == c.tables.parts.end() ? "" : found->second.title, part, c.panels);
  }
  for (const DeckShell& shell : c.tables.shells)
    if (surface.parts.contains(shell.part))
      c.bag.facets.push_back({shell.nodes, c.panels.at(shell.part), shell.at});
  claim_shells(c.tables.shells, c.panels, c.report);
  if (surface.segments.empty()) return;
  if (std::ranges::find(c.bag.null_panels, "segments") == c.bag.null_panels.end())
    c.bag.null_panels.emplace_back("segments");
  c.report.note(fmt::format("{} segments close the control volume as the null panel segments",
                            surface.segments.size()));
  std::ranges::move(surface.segments, std::back_inserter(c.bag.facets));
}

namespace {

/// Reads the fabric of one part after the other.
class RadiossFabricReader {
 public:
  explicit RadiossFabricReader(RadiossContext& context) : c_(context), u_(context.units) {}
  void read(long part, const std::string& panel);
  void finish() { take_law(c_.bag, laws_, c_.volume, c_.report); }

 private:
  void woven(const DeckCard& card, BagFabric& fabric);
  void threads(const DeckCard& card, BagFabric& fabric);
  void elastic(const DeckCard& card, BagFabric& fabric);
  void start_stress(const DeckCard& card, double zeroed);
  void property(const DeckCard& card, bool needs_warp, BagFabric& fabric);
  void density(const DeckCard& card, BagFabric& fabric) {
    fabric.density = c_.twenties(card, 1).real(0, "RHO_I") * u_.density();
    if (!(fabric.density > 0.0)) throw DeckFault(card.at, "RHO_I is 0, allowed: above 0");
  }

  RadiossContext& c_;
  const Units& u_;
  std::vector<std::string> laws_;
  bool total_strain_ = false;
};

constexpr double rounding = 1e-6;

// A share of the stress that the reference geometry makes at the start is taken away until it has gone.
void RadiossFabricReader::start_stress(const DeckCard& card, double zeroed) {
  if (zeroed != 0.0)
    c_.report.note(fmt::format(
        "{}: ZEROSTRESS = {:g}: that share of the stress of a reference geometry at the start is taken away "
        "there; here it stays",
        c_.text.where(card.at), zeroed));
}

void RadiossFabricReader::woven(const DeckCard& card, BagFabric& fabric) {
  density(card, fabric);
  const DeckFields e = c_.twenties(card, 2);
  fabric.warp_modulus = e.real(0, "E11") * u_.pressure();
  fabric.weft_modulus = e.real(1, "E22") * u_.pressure();
  fabric.poisson = e.real(2, "NU12");
  fabric.shear = c_.twenties(card, 3).real(0, "G12") * u_.pressure();
  if (!(fabric.warp_modulus > 0.0) || !(fabric.weft_modulus > 0.0))
    throw DeckFault(card.at, "E11 and E22 are needed, above 0");
  const double in_compression = c_.twenties(card, 4).real(0, "R_E");
  start_stress(card, c_.twenties(card, 4).real(2, "ZEROSTRESS"));
  constexpr double most_slack = 0.5;
  c_.bag.carries_compression = in_compression == 0.0 || in_compression > most_slack;
  if (!c_.bag.carries_compression)
    c_.report.note(fmt::format("{}: R_E = {:g}: that share of the stress stays in compression; here none",
                               c_.text.where(card.at), in_compression));
  laws_.emplace_back(fabric.is_isotropic(rounding) && !total_strain_ ? "hencky" : "saint_venant_kirchhoff");
  c_.report.became(card, {"fabric.law", "fabric.young_modulus", "fabric.density", "fabric.compression"},
                   Mapping::approximated,
                   fmt::format("law \"{}\": agrees to first order of strain", laws_.back()));
}

// Functions of warp and weft, or moduli. The crimp is left out.
void RadiossFabricReader::threads(const DeckCard& card, BagFabric& fabric) {
  density(card, fabric);
  const DeckFields e = c_.twenties(card, 2), g = c_.twenties(card, 3);
  const DeckFields crimp(c_.text, card, line_or_blank(card, 5), {10, 10, 20, 20, 20, 20});
  start_stress(card, c_.twenties(card, 4).real(3, "ZEROSTRESS"));
  fabric.warp_modulus = e.real(0, "E1") * u_.pressure();
  fabric.weft_modulus = e.real(2, "E2") * u_.pressure();
  fabric.shear = g.real(0, "G0") * u_.pressure();
  if (fabric.shear == 0.0) fabric.shear = g.real(3, "Gsh") * u_.pressure();
  c_.bag.carries_compression = false;
  constexpr double slight = 1e-3;
  if (std::max(crimp.real(2, "S1"), crimp.real(3, "S2")) > slight)
    c_.report.note(
        fmt::format("{}: the crimp S1 = {:g}, S2 = {:g}, which couples warp and weft, has no counterpart",
                    c_.text.where(card.at), crimp.real(2, "S1"), crimp.real(3, "S2")));
  const auto function = [&](std::size_t i) {
    return DeckFields(c_.text, card, line_or_blank(card, 6 + i), {10, 10, 20});
  };
  const long warp = function(0).whole(0, "fct_ID1"), weft = function(1).whole(0, "fct_ID2");
  if (warp == 0) {
    if (!(fabric.warp_modulus > 0.0)) throw DeckFault(card.at, "E1 or a function of the warp is needed");
    if (fabric.weft_modulus == 0.0) fabric.weft_modulus = fabric.warp_modulus;
    laws_.emplace_back("saint_venant_kirchhoff");
    if (e.real(1, "B1") != 0.0 || e.real(3, "B2") != 0.0)
      c_.report.note(fmt::format("{}: B1 and B2, which soften the threads, have no counterpart",
                                 c_.text.where(card.at)));
    return c_.report.became(card, {"fabric.law", "fabric.young_modulus", "fabric.density"},
                            Mapping::approximated,
                            "linear threads and shear: agrees to first order of strain");
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const long id = i == 1 && weft != 0 ? weft : warp;
    Knots knots =
        c_.curve(id, 1.0, u_.pressure(), i == 0 ? "fabric.warp_curve" : "fabric.weft_curve", card.at);
    std::erase_if(knots, [](const auto& knot) { return knot[0] < 0.0; });
    take_thread(c_.bag, i, knots, card.at, c_.report);
  }
  laws_.emplace_back("curve");
  c_.report.became(card, {"fabric.law", "fabric.warp_curve", "fabric.weft_curve", "fabric.density"},
                   Mapping::approximated,
                   "threads exactly by their functions; the shear angle's own law to first order");
}

void RadiossFabricReader::elastic(const DeckCard& card, BagFabric& fabric) {
  density(card, fabric);
  const DeckFields e = c_.twenties(card, 2);
  take_elastic(fabric, e.real(0, "E") * u_.pressure(), e.real(1, "NU"), card, c_.report);
  c_.bag.carries_compression = true;
  laws_.emplace_back("saint_venant_kirchhoff");
}

void RadiossFabricReader::property(const DeckCard& card, bool needs_warp, BagFabric& fabric) {
  const auto words = words_of(card);
  const std::string kind = words.size() > 1 ? words[1] : "";
  const bool orthotropic = kind == "SH_ORTH" || kind == "TYPE9" || kind == "SH_FABR" || kind == "TYPE16";
  if (!orthotropic && kind != "SHELL" && kind != "TYPE1")
    throw DeckFault(
        card.at, "this property of the bag is not mapped, allowed: /PROP/SHELL, SH_ORTH, SH_FABR and VOID");
  const DeckFields f(c_.text, card, line_or_blank(card, 3), {10, 10, 20});
  fabric.thickness = f.real(2, "Thick") * u_.length;
  if (!(fabric.thickness > 0.0)) throw DeckFault(f.at(), "Thick is 0, allowed: above 0");
  total_strain_ = c_.tens(card, 1).whole(1, "Ismstr") == 11;
  c_.report.became(card, {"fabric.thickness"}, Mapping::exact,
                   "thickness and direction of the warp; elements are triangles of constant strain");
  if (!needs_warp) return;
  if (!orthotropic)
    throw DeckFault(card.at, "woven fabric needs a direction, allowed: /PROP/SH_ORTH and SH_FABR");
  const DeckFields v = c_.twenties(card, 4);
  fabric.warp = Eigen::Vector3d(v.real(0, "Vx"), v.real(1, "Vy"), v.real(2, "Vz"));
  if (!(fabric.warp->norm() > 0.0))
    throw DeckFault(v.at(), "Vx, Vy and Vz, the direction of the warp, are 0");
  const bool layers = kind == "SH_FABR" || kind == "TYPE16";
  const double angle = layers ? c_.twenties(card, 5).real(0, "Phi") : v.real(3, "Phi");
  if (angle != 0.0)
    throw DeckFault(
        v.at(),
        fmt::format("Phi = {:g}: an angle to the vector has no counterpart, allowed: 0; turn the vector",
                    angle));
}

void RadiossFabricReader::read(long part, const std::string& panel) {
  const auto own = c_.tables.parts.find(part);
  if (own == c_.tables.parts.end())
    return c_.report.refuse(c_.volume, fmt::format("part {} of the surface has no card /PART", part));
  c_.report.became(*own->second.card, {"membrane.mesh.file"}, Mapping::exact, "panels of the mesh");
  const auto property_of = c_.tables.properties.find(own->second.property);
  const auto material = c_.tables.materials.find(own->second.material);
  const auto is = [&](const DeckCard& card, std::initializer_list<const char*> words) {
    return std::ranges::any_of(words, [&](const char* word) { return card.keyword.starts_with(word); });
  };
  const bool is_void =
      (property_of != c_.tables.properties.end() &&
       is(*property_of->second, {"/PROP/VOID", "/PROP/TYPE0/"})) ||
      (material != c_.tables.materials.end() && is(*material->second, {"/MAT/VOID", "/MAT/LAW0/"}));
  try {
    if (is_void) {
      c_.bag.null_panels.push_back(panel);
      c_.bag.fabrics.erase(panel);
      if (property_of != c_.tables.properties.end())
        c_.report.became(*property_of->second, {"membrane.null_panels"}, Mapping::exact,
                         "bounds the volume without stress");
      if (material != c_.tables.materials.end())
        c_.report.became(*material->second, {"membrane.null_panels"}, Mapping::exact,
                         "bounds the volume without stress");
      return;
    }
    if (material == c_.tables.materials.end() || property_of == c_.tables.properties.end())
      throw DeckFault(own->second.card->at,
                      fmt::format("part {} has no material or no property in this deck", part));
    const DeckCard& law = *material->second;
    BagFabric fabric = c_.bag.fabrics[panel];
    fabric.source = c_.source(law);
    property(*property_of->second, false, fabric);
    if (is(law, {"/MAT/FABRI/", "/MAT/LAW19/"}))
      woven(law, fabric);
    else if (is(law, {"/MAT/FABR_A/", "/MAT/LAW58/"}))
      threads(law, fabric);
    else if (is(law, {"/MAT/ELAST/", "/MAT/LAW1/"}))
      elastic(law, fabric);
    else
      throw DeckFault(law.at, "this material of the bag is not mapped, allowed: LAW1, LAW19, LAW58 and VOID");
    const bool woven = laws_.back() == "curve" || !fabric.is_isotropic(rounding);
    if (woven) property(*property_of->second, true, fabric);
    c_.bag.fabrics[panel] = fabric;
  } catch (const DeckFault& fault) {
    c_.report.refuse(*own->second.card, fault);
  }
}

}  // namespace

void map_fabric(RadiossContext& context) {
  RadiossFabricReader reader(context);
  for (const auto& [part, panel] : context.panels) {
    const bool is_between =
        context.chambers_are_one &&
        std::ranges::find(context.bag.facets, panel, &Facet::panel) == context.bag.facets.end();
    const auto own = context.tables.parts.find(part);
    if (!is_between)
      reader.read(part, panel);
    else if (own != context.tables.parts.end())
      context.report.left_out(*own->second.card, Mapping::left_out, "between chambers that are one here");
  }
  reader.finish();
}

}  // namespace driver::imported
