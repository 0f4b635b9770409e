// SPDX-License-Identifier: Apache-2.0
// [fabric] and [[fabric.panel]] -> the properties of each element.
#include <algorithm>
#include <limits>

#include "scene/parts.hpp"

namespace driver {
namespace {

std::optional<membrane::WeaveProperties> read_weave(TableReader& table) {
  auto reader = table.optional_table("weave");
  if (!reader) return std::nullopt;
  membrane::WeaveProperties weave;
  weave.young_modulus_weft = reader->at("young_modulus_weft").number(positive.in("Pa"));
  weave.shear = reader->at("shear_modulus").number(positive.in("Pa"));
  weave.warp = reader->at("warp").vector("");
  reader->finish();
  return weave;
}

// Replaces the properties that the table names; `number(key, bounds, before)` reads one.
template <class Number>
void read_properties(TableReader& table, membrane::ElementProperties& fabric, Number&& number) {
  fabric.young_modulus = number("young_modulus", positive.in("Pa"), fabric.young_modulus);
  // The limit of a woven fabric depends on both moduli; the library asks for it.
  const Bounds isotropic{-0.999, 0.999, false, "a number from -0.999 to 0.999"};
  fabric.poisson = number("poisson_ratio", table.has("weave") ? any_number : isotropic, fabric.poisson);
  fabric.density = number("density", positive.in("kg/m³"), fabric.density);
  fabric.thickness = number("thickness", positive.in("m"), fabric.thickness);
  if (auto weave = read_weave(table)) fabric.weave = weave;
}

// A panel keeps what [fabric] says of it but for what its own table names.
void read_panels(TableReader& table, const membrane::Mesh& mesh, const std::vector<std::string>& null_panels,
                 std::vector<membrane::ElementProperties>& all) {
  const membrane::ElementProperties base = all.front();
  std::vector<bool> named(all.size(), false);
  for (TableReader& reader : table.tables("panel")) {
    membrane::ElementProperties own = base;
    read_properties(reader, own, [&](const char* key, Bounds bounds, double before) {
      return reader.at(key).optional_number(bounds).value_or(before);
    });
    own.porosity = reader.at("porosity").optional_number(fraction).value_or(own.porosity);
    const auto names = reader.at("panels").texts("needed");
    if (names.empty()) reader.fail("panels", "is missing or empty, names of panels are needed");
    reader.located("panels", [&] {
      for (const std::string& name : names) {
        if (std::find(null_panels.begin(), null_panels.end(), name) != null_panels.end())
          throw std::invalid_argument("names \"" + name + "\", a null panel: it has no fabric");
        for (const int element : membrane::panel_elements(mesh, name)) {
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

}  // namespace

LeakLaw read_fabric(TableReader& root, const membrane::Mesh& mesh,
                    const std::vector<std::string>& null_panels, membrane::BagDescription& bag,
                    gas::ControlVolumeModel& model) {
  TableReader table = root.table("fabric");
  membrane::ElementProperties fabric;
  read_properties(table, fabric,
                  [&](const char* key, Bounds bounds, double) { return table.at(key).number(bounds); });
  const auto law = table.at("leak_law")
                       .choice<LeakLaw>({{"none", LeakLaw::none},
                                         {"printed", LeakLaw::printed},
                                         {"screen", LeakLaw::screen},
                                         {"table", LeakLaw::table}},
                                        "printed");
  // A table is measured on the fabric as it is: all of it leaks, unless the case says otherwise.
  fabric.porosity = table.at("porosity").number(fraction, law == LeakLaw::table ? 1.0 : 0.0);
  if (law == LeakLaw::table) model.fabrics = {gas::Fabric{1.0, read_leak_velocity(table)}};
  using membrane::Compression;
  bag.compression =
      table.at("compression")
          .choice<Compression>({{"none", Compression::none}, {"linear", Compression::linear}}, "none");
  using membrane::FabricLaw;
  bag.law = table.at("law").choice<FabricLaw>(
      {{"saint_venant_kirchhoff", FabricLaw::saint_venant_kirchhoff}, {"hencky", FabricLaw::hencky}},
      "saint_venant_kirchhoff");
  if (bag.law == FabricLaw::hencky && bag.compression != Compression::none)
    table.fail("compression",
               "is \"linear\", but law = \"hencky\" carries no compression; allowed: \"none\"");
  bag.properties.assign(static_cast<std::size_t>(bag.elements.cols()), fabric);
  read_panels(table, mesh, null_panels, bag.properties);
  if (bag.law == FabricLaw::hencky &&
      std::any_of(bag.properties.begin(), bag.properties.end(), [](const auto& p) { return bool(p.weave); }))
    table.fail("law", "is \"hencky\", which is for isotropic fabric, without weave");
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
