// SPDX-License-Identifier: Apache-2.0
// [fabric] and [[fabric.panel]] -> the properties of each element.
#include "scene/read_fabric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/curve_reader.hpp"
#include "membrane/law_table.hpp"
#include "scene/read_openings.hpp"

namespace driver {
namespace {

// A fabric by curves has no moduli. Decks take those of the chords to the curves' ends.
double chord(const membrane::StressCurve& curve) {
  return curve.stress.back() / curve.strain.back();
}

std::optional<membrane::WeaveProperties> read_weave(TableReader& table, const membrane::BagDescription& bag) {
  auto reader = table.optional_table("weave");
  if (!reader) return std::nullopt;
  membrane::WeaveProperties weave;
  weave.young_modulus_weft = membrane::law_named(bag.law).curves
                                 ? chord(bag.curves[1])
                                 : reader->at("young_modulus_weft").number(positive.in("Pa"));
  weave.shear = reader->at("shear_modulus").number(positive.in("Pa"));
  weave.warp = reader->at("warp").vector("");
  reader->finish();
  return weave;
}

// Replaces the properties that the table names; `number(key, bounds, before)` reads one.
template <class Number>
void read_properties(TableReader& table, const membrane::BagDescription& bag,
                     membrane::ElementProperties& fabric, Number&& number) {
  const membrane::LawTraits& law = membrane::law_named(bag.law);
  if (law.curves) {
    fabric.young_modulus = chord(bag.curves[0]);
    fabric.poisson = 0.0;
  } else {
    fabric.young_modulus = number("young_modulus", positive.in("Pa"), fabric.young_modulus);
    // The limit of a woven fabric depends on both moduli; the library asks for it.
    const Bounds isotropic{-0.999, 0.999, false, "a number from -0.999 to 0.999"};
    fabric.poisson = number("poisson_ratio", table.has("weave") ? any_number : isotropic, fabric.poisson);
  }
  fabric.density = number("density", positive.in("kg/m³"), fabric.density);
  fabric.thickness = number("thickness", positive.in("m"), fabric.thickness);
  if (auto weave = read_weave(table, bag)) fabric.weave = weave;
  fabric.law_constants.resize(static_cast<std::size_t>(law.own_count), membrane::kMustBeGiven);
  for (std::size_t i = 0; i < fabric.law_constants.size(); ++i) {
    const membrane::LawConstant& own = law.own[i];
    const std::string allowed = fmt::format("a number from {} to {}", own.least, own.most);
    fabric.law_constants[i] = number(own.name, Bounds{own.least, own.most, false, allowed.c_str(), own.unit},
                                     fabric.law_constants[i]);
  }
}

// A panel keeps what [fabric] says of it but for what its own table names.
void read_panels(TableReader& table, const mesh::Mesh& mesh, const std::vector<std::string>& null_panels,
                 bool leaks, membrane::BagDescription& bag) {
  std::vector<membrane::ElementProperties>& all = bag.properties;
  const membrane::ElementProperties base = all.front();
  std::vector<bool> named(all.size(), false);
  for (TableReader& reader : table.tables("panel")) {
    membrane::ElementProperties own = base;
    read_properties(reader, bag, own, [&](const char* key, Bounds bounds, double before) {
      return reader.at(key).optional_number(bounds).value_or(before);
    });
    if (leaks) own.porosity = reader.at("porosity").optional_number(fraction).value_or(own.porosity);
    const auto names = reader.at("panels").texts("needed");
    if (names.empty()) reader.fail("panels", "is missing or empty, needed: names of panels");
    reader.located("panels", [&] {
      for (const std::string& name : names) {
        if (std::find(null_panels.begin(), null_panels.end(), name) != null_panels.end())
          throw std::invalid_argument("names \"" + name + "\", a null panel: it has no fabric");
        for (const int element : mesh::panel_elements(mesh, name)) {
          const auto e = static_cast<std::size_t>(element);
          if (named[e]) throw std::invalid_argument("names panel \"" + name + "\" again");
          named[e] = true;
          all[e] = own;
        }
      }
    });
    reader.finish();
  }
}

// The places of faults are those of the key, whatever the library says of the whole.
membrane::StressCurve read_stress_curve(TableReader& table, const char* key) {
  CurveData data = CurveReader(table, key).curve(non_negative.in("Pa"), "strain");
  const auto fail = [&](const std::string& what) { table.fail(key, what); };
  if (data.time.empty()) fail("is a number, allowed: a curve of stress over strain");
  if (data.time.size() > membrane::kMostCurvePoints)
    fail(fmt::format("has {} points, allowed: at most {}", data.time.size(), membrane::kMostCurvePoints));
  if (data.time.front() != 0.0 || data.value.front() != 0.0)
    fail(fmt::format("begins at ({}, {}), allowed: (0, 0)", data.time.front(), data.value.front()));
  for (std::size_t i = 1; i < data.value.size(); ++i)
    if (!(data.value[i] > data.value[i - 1]))
      fail(fmt::format("has the stress {} Pa after {} Pa, allowed: strictly rising stresses (loading only)",
                       data.value[i], data.value[i - 1]));
  return {std::move(data.time), std::move(data.value)};
}

// Law, compression and, of a fabric by curves, these.
void read_law(TableReader& table, membrane::BagDescription& bag) {
  using membrane::Compression;
  bag.compression =
      table.at("compression")
          .choice<Compression>({{"none", Compression::none}, {"linear", Compression::linear}}, "none");
  std::vector<std::pair<std::string, std::string>> laws;
  for (const std::string& name : membrane::law_names()) laws.emplace_back(name, name);
  bag.law = table.at("law").choice(laws, bag.law);
  const membrane::LawTraits& law = membrane::law_named(bag.law);
  if (!law.compression && bag.compression != Compression::none)
    table.fail("compression", fmt::format("is \"linear\", but law = \"{}\" carries no compression; allowed: "
                                          "\"none\"",
                                          bag.law));
  if (law.curves)
    bag.curves = {read_stress_curve(table, "warp_curve"), read_stress_curve(table, "weft_curve")};
}

LeakLaw read_leak(TableReader& table, gas::ControlVolumeModel& model, membrane::ElementProperties& fabric) {
  const auto law = table.at("leak_law")
                       .choice<LeakLaw>({{"none", LeakLaw::none},
                                         {"printed", LeakLaw::printed},
                                         {"screen", LeakLaw::screen},
                                         {"table", LeakLaw::table}},
                                        "printed");
  // A table is measured on the fabric as it is: all of it leaks, unless the case says otherwise.
  fabric.porosity = table.at("porosity").number(fraction, law == LeakLaw::table ? 1.0 : 0.0);
  if (law == LeakLaw::table) model.fabrics = {gas::Fabric{1.0, read_leak_velocity(table)}};
  return law;
}

}  // namespace

LeakLaw read_fabric(TableReader& root, const mesh::Mesh& mesh, const std::vector<std::string>& null_panels,
                    membrane::BagDescription& bag, gas::ControlVolumeModel* model) {
  TableReader table = root.table("fabric");
  read_law(table, bag);
  membrane::ElementProperties fabric;
  read_properties(table, bag, fabric,
                  [&](const char* key, Bounds bounds, double) { return table.at(key).number(bounds); });
  const LeakLaw law = model ? read_leak(table, *model, fabric) : LeakLaw::none;
  bag.properties.assign(static_cast<std::size_t>(bag.elements.cols()), fabric);
  read_panels(table, mesh, null_panels, model != nullptr, bag);
  if (!membrane::find_law(bag.law, true) &&
      std::any_of(bag.properties.begin(), bag.properties.end(), [](const auto& p) { return bool(p.weave); }))
    table.fail("law", fmt::format("is \"{}\", which is for isotropic fabric, without weave", bag.law));
  if (!membrane::find_law(bag.law, false) && !fabric.weave)
    table.fail("weave", fmt::format("is missing: law = \"{}\" needs its shear_modulus and warp", bag.law));
  table.finish();
  return law;
}

double lightest_fabric(const membrane::BagDescription& bag) {
  double lightest = std::numeric_limits<double>::infinity();
  for (const auto& fabric : bag.properties)
    if (!fabric.null_panel) lightest = std::min(lightest, fabric.density * fabric.thickness);
  return lightest;
}

}  // namespace driver
