// SPDX-License-Identifier: Apache-2.0
// Fabric of an LS-DYNA deck: *MAT_FABRIC and *MAT_ELASTIC with their sections, and how they leak.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bag_fabric.hpp"
#include "lsdyna_context.hpp"
#include "vent_curves.hpp"
#include "weave_direction.hpp"

namespace driver::imported {
namespace {

/// Reads the fabric of one part after the other.
class LsDynaFabricReader {
 public:
  LsDynaFabricReader(LsDynaContext& context, long leak_option)
      : c_(context), u_(context.units), option_(leak_option) {}
  void read(long part, const std::string& panel);
  void finish();

 private:
  void fabric(long part, const std::string& panel, const LsDynaEntry& material, BagFabric& fabric);
  void elastic(const LsDynaEntry& material, BagFabric& fabric);
  void leak(long part, long material_id, const LsDynaEntry& material, BagFabric& fabric);
  void form(const LsDynaEntry& material, BagFabric& fabric);
  void threads(const LsDynaEntry& material);
  double thickness(long part) const;

  LsDynaContext& c_;
  const Units& u_;
  long option_;
  std::vector<std::string> laws_;
  std::vector<bool> carries_compression_;
};

double LsDynaFabricReader::thickness(long part) const {
  const LsDynaPart& own = c_.tables.parts.at(part);
  const auto section = c_.tables.sections.find(own.section);
  if (section == c_.tables.sections.end() || !section->second.card->keyword.starts_with("*SECTION_SHELL"))
    throw DeckFault(own.card->at, fmt::format("part {} has no *SECTION_SHELL, and so no thickness", part));
  const double value = c_.real(section->second, 1, 0, "T1") * u_.length;
  if (!(value > 0.0)) throw DeckFault(section->second.card->at, "T1, the thickness, is 0, allowed: above 0");
  c_.report.became(*section->second.card, {"fabric.thickness"}, Mapping::exact,
                   "thickness; elements are triangles of constant strain");
  return value;
}

constexpr double five_digits = 2e-4;  // what five digits of a field leave

// A weave needs some shear modulus, or its elements shear without end.
void stiffen_shear(BagFabric& fabric, Place at, LsDynaContext& c) {
  constexpr double least = 1.0001e-4;  // of the geometric mean of both moduli, as the fabric's law needs
  const double floor = least * std::sqrt(fabric.warp_modulus * fabric.weft_modulus);
  if (fabric.shear >= floor) return;
  c.report.note(fmt::format(
      "{}: the shear modulus GAB = {:.3g} Pa is raised to {:.3g} Pa, 1e-4 of the mean of EA and EB, "
      "the least allowed",
      c.text.where(at), fabric.shear, floor));
  fabric.shear = floor;
}

void LsDynaFabricReader::fabric(long part, const std::string& panel, const LsDynaEntry& m,
                                BagFabric& fabric) {
  fabric.density = c_.real(m, 0, 1, "RO") * u_.density();
  fabric.warp_modulus = c_.real(m, 0, 2, "EA") * u_.pressure();
  fabric.weft_modulus = c_.real(m, 0, 3, "EB") * u_.pressure();
  if (fabric.weft_modulus == 0.0) fabric.weft_modulus = fabric.warp_modulus;
  const double minor = c_.real(m, 0, 5, "PRBA"), major = c_.real(m, 0, 6, "PRAB");
  if (!(fabric.warp_modulus > 0.0) || !(fabric.density > 0.0))
    throw DeckFault(m.card->at, "RO and EA are needed, above 0");
  fabric.poisson = minor != 0.0 ? minor * fabric.warp_modulus / fabric.weft_modulus : major;
  fabric.shear = c_.real(m, 1, 0, "GAB") * u_.pressure();
  if (fabric.shear == 0.0) fabric.shear = 0.5 * fabric.warp_modulus / (1.0 + fabric.poisson);
  carries_compression_.push_back(c_.real(m, 1, 3, "CSE") == 0.0);
  if (const double ratio = c_.real(m, 1, 6, "LRATIO"); ratio > 0.0 && c_.real(m, 1, 4, "EL") > 0.0)
    c_.report.note(fmt::format(
        "the liner of the fabric {} (EL, LRATIO {:.3g}) has no counterpart: it carries compression and shear",
        m.card->at.line, ratio));
  if (const double damping = c_.real(m, 1, 7, "DAMP"); damping > 0.0)
    c_.report.note(fmt::format(
        "DAMP = {:g} of the fabric (Rayleigh damping) has no counterpart: it is undamped", damping));
  stiffen_shear(fabric, m.card->at, c_);
  form(m, fabric);
  if (fabric.is_isotropic(five_digits) && laws_.back() != "curve") return;
  const double aopt = c_.real(m, 2, 0, "AOPT");
  if (aopt == 2.0) {
    fabric.warp = Eigen::Vector3d(c_.real(m, 3, 3, "A1"), c_.real(m, 3, 4, "A2"), c_.real(m, 3, 5, "A3"));
    if (!(fabric.warp->norm() > 0.0))
      throw DeckFault(m.card->at, "A1, A2 and A3, the direction of the warp, are 0");
    return;
  }
  if (aopt != 0.0)
    throw DeckFault(m.card->at, fmt::format("AOPT = {:g} has no counterpart, allowed: 0 and 2", aopt));
  const WarpDirection direction = mean_direction(c_.bag, panel, c_.real(m, 4, 6, "BETA"));
  fabric.warp = direction.along;
  c_.report.note(fmt::format(
      "AOPT = 0: the warp of part {} runs along the first side of each element; here it has one direction, "
      "({:.3g}, {:.3g}, "
      "{:.3g}), from which that of the elements differs by {:.0f} degrees in the root mean square",
      part, direction.along.x(), direction.along.y(), direction.along.z(), direction.spread_degrees));
}

void LsDynaFabricReader::form(const LsDynaEntry& m, BagFabric& fabric) {
  const long form = std::lround(c_.real(m, 2, 5, "FORM"));
  const bool linear_of_green = form == 2 || form == 12 || form == 3 || form == 13 || form == 4;
  if (form == 14 || form == -14 || form == 24) {
    threads(m);
    laws_.emplace_back("curve");
  } else {
    laws_.emplace_back(!linear_of_green && fabric.is_isotropic(five_digits) ? "hencky"
                                                                            : "saint_venant_kirchhoff");
  }
  const std::string& law = laws_.back();
  c_.report.became(*m.card, {"fabric.law", "fabric.young_modulus", "fabric.density", "fabric.compression"},
                   Mapping::approximated,
                   fmt::format("FORM {} as law \"{}\": all agree to first order of strain", form, law));
}

// FORM 14: second Piola-Kirchhoff stress over Green-Lagrange strain, as nominal stress over stretch minus 1.
void LsDynaFabricReader::threads(const LsDynaEntry& m) {
  for (std::size_t i = 0; i < 2; ++i) {
    long id = c_.whole(m, 5, i, i == 0 ? "LCA" : "LCB");
    if (id == 0 && i == 1) id = c_.whole(m, 5, 0, "LCA");
    if (id == 0) throw DeckFault(m.card->at, "FORM 14 needs the curve LCA");
    Knots knots =
        c_.curve(id, 1.0, u_.pressure(), i == 0 ? "fabric.warp_curve" : "fabric.weft_curve", m.card->at);
    std::erase_if(knots, [](const auto& knot) { return knot[0] < 0.0; });
    for (auto& [strain, stress] : knots) {
      const double stretch = std::sqrt(1.0 + 2.0 * strain);
      stress *= stretch;
      strain = stretch - 1.0;
    }
    if (knots.empty() || knots.front()[0] > 0.0) knots.insert(knots.begin(), {0.0, 0.0});
    take_thread(c_.bag, i, knots, m.card->at, c_.report);
  }
}

void LsDynaFabricReader::elastic(const LsDynaEntry& m, BagFabric& fabric) {
  fabric.density = c_.real(m, 0, 1, "RO") * u_.density();
  if (!(fabric.density > 0.0)) throw DeckFault(m.card->at, "RO is needed, above 0");
  take_elastic(fabric, c_.real(m, 0, 2, "E") * u_.pressure(), c_.real(m, 0, 3, "PR"), *m.card, c_.report);
  carries_compression_.push_back(true);
  laws_.emplace_back("saint_venant_kirchhoff");
}

// FVOPT: 1, 2 flow through an orifice; 3, 4 Graefe's law; 7, 8 a curve of velocity over pressure.
void LsDynaFabricReader::leak(long part, long material_id, const LsDynaEntry& material, BagFabric& fabric) {
  LsDynaEntry entry = material;
  std::size_t line = 2, flc = 1, fac = 2, kind = 6;
  if (const auto own = c_.tables.leakages.find(material_id); own != c_.tables.leakages.end()) {
    entry = own->second;
    line = 0, flc = 1, fac = 2, kind = 4;
    c_.report.became(*entry.card, {"fabric.porosity", "fabric.leak_law"}, Mapping::approximated,
                     "leak of the material's parts; see below");
  } else if (!material.card->keyword.starts_with("*MAT_FABRIC") &&
             !material.card->keyword.starts_with("*MAT_034")) {
    return;
  }
  const Place at = entry.card->at;
  const double c = c_.real(entry, line, flc, "FLC"), f = c_.real(entry, line, fac, "FAC");
  long law = std::lround(c_.real(entry, line, kind, "FVOPT"));
  if (law == 0) law = option_;
  if (c == 0.0 || f == 0.0 || law == 0) return;
  if (c < 0.0) throw DeckFault(at, "FLC below 0, a curve of time, has no counterpart");
  if (law == 7 || law == 8) {
    Knots velocity =
        f < 0.0 ? c_.curve_of_pressure(std::lround(-f), u_.velocity(), "fabric.velocity", at) : Knots{};
    if (velocity.empty())
      throw DeckFault(at, fmt::format("FVOPT = {} needs FAC below 0, a curve of velocity", law));
    from_rest(velocity);
    velocity.front()[1] = 0.0;
    take_leak(c_.bag, BagLeak::table, velocity, at);
    fabric.open_share = c;
    return;
  }
  if (f < 0.0) throw DeckFault(at, "FAC below 0, a curve of pressure, has no counterpart with this FVOPT");
  const double share = c * f;
  if (law == 1 || law == 2) {
    return take_orifice(
        c_.bag, share * area_of(c_.bag, c_.panels, part), c_.text.where(at) + " FLC, FAC",
        fmt::format("FVOPT = {}: part {}{}", law, part, law == 2 ? ", which contact does not block," : ""),
        c_.report);
  }
  if (law != 3 && law != 4)
    throw DeckFault(at, fmt::format("FVOPT = {} has no counterpart, allowed: 1, 2, 3, 4, 7 and 8", law));
  if (share > 1.0) throw DeckFault(at, fmt::format("FLC FAC = {:g}, allowed: at most 1", share));
  take_leak(c_.bag, BagLeak::screen, {}, at);
  fabric.open_share = share;
}

void LsDynaFabricReader::read(long part, const std::string& panel) {
  const auto own = c_.tables.parts.find(part);
  if (own == c_.tables.parts.end())
    return c_.report.refuse(c_.airbag, fmt::format("part {} of the control volume has no card *PART", part));
  const auto material = c_.tables.materials.find(own->second.material);
  if (material == c_.tables.materials.end())
    return c_.report.refuse(
        *own->second.card,
        fmt::format("part {} has the material {}, which the deck does not have", part, own->second.material));
  const LsDynaEntry& m = material->second;
  const auto is = [&](std::string_view word) { return is_keyword(*m.card, word); };
  try {
    if (is("*MAT_NULL") || is("*MAT_009") || is("*MAT_RIGID") || is("*MAT_020")) {
      c_.bag.null_panels.push_back(panel);
      if (!c_.report.told(*m.card))
        c_.report.became(*m.card, {"membrane.null_panels"}, Mapping::exact,
                         "bounds the volume without stress");
      return;
    }
    BagFabric fabric;
    fabric.source = c_.source(*m.card);
    if (is("*MAT_FABRIC") || is("*MAT_034"))
      this->fabric(part, panel, m, fabric);
    else if (is("*MAT_ELASTIC") || is("*MAT_001"))
      elastic(m, fabric);
    else
      return c_.report.refuse(*m.card,
                              "this material of the bag is not mapped, allowed: *MAT_FABRIC, *MAT_ELASTIC, "
                              "*MAT_NULL and *MAT_RIGID");
    fabric.thickness = thickness(part);
    leak(part, own->second.material, m, fabric);
    c_.bag.fabrics[panel] = fabric;
  } catch (const DeckFault& fault) {
    c_.report.refuse(*m.card, fault);
  }
}

// One law and one kind of compression for the whole bag.
void LsDynaFabricReader::finish() {
  const auto carries = std::ranges::count(carries_compression_, true);
  c_.bag.carries_compression = carries == static_cast<std::ptrdiff_t>(carries_compression_.size());
  if (!c_.bag.carries_compression && carries > 0)
    c_.report.note("some parts carry compression (CSE = 0), others do not: here none does");
  take_law(c_.bag, laws_, c_.airbag, c_.report);
}

}  // namespace

void map_fabric(LsDynaContext& context, long leak_option) {
  LsDynaFabricReader reader(context, leak_option);
  for (const auto& [part, panel] : context.panels) reader.read(part, panel);
  reader.finish();
}

}  // namespace driver::imported
