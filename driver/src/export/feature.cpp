// SPDX-License-Identifier: Apache-2.0
#include "export/feature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "driver/result_folder.hpp"

namespace driver {
namespace {

constexpr Outcome same{Mapping::exact, "as in the case"};
constexpr Outcome in_deck{Mapping::exact, "part of what the deck's numbers come from"};
constexpr Outcome solver{Mapping::none,
                         "of this program's own solution; the other program has its own settings"};
constexpr Outcome output{Mapping::none, "of this program's own results; the other program has its own"};
constexpr Outcome tank{Mapping::none, "of scenes without a bag, which are not exported"};
constexpr Outcome jet{Mapping::none, "no jet is written: see below"};
constexpr Outcome polynomial{Mapping::approximated,
                             "one polynomial: exact to 1000 K, above by the size below"};
constexpr Outcome molar{
    Mapping::approximated,
    "a parabola of molar cp, by least squares from 250 K up: exact if cp is constant, else "
    "by the size below"};
constexpr Outcome trigger{Mapping::approximated,
                          "sensors of time become times; what else fires is left out, see below"};
constexpr Outcome law{
    Mapping::approximated,
    "linear law of another strain: with St. Venant-Kirchhoff it agrees to first order of strain"};
constexpr Outcome shape{Mapping::exact, "start shape as nodes, design shape as reference geometry"};
constexpr Outcome sphere{Mapping::approximated, "a sphere of flat triangles, by the size below"};
constexpr Outcome contact{Mapping::approximated, "contact by node with the program's own penalty"};
constexpr Outcome fabric_law{Mapping::approximated,
                             "the program's fabric in Green-Lagrange strain (FORM 12) for St. "
                             "Venant-Kirchhoff, in its invariant frame "
                             "(FORM 1) for Hencky: all agree to first order of strain"};
constexpr Outcome chord{Mapping::approximated, "linear, by the chord to the curve's end: size below"};
constexpr Outcome one_area{Mapping::approximated, "leaks by the area that the program takes for its fabric"};
constexpr Outcome one_opening{
    Mapping::approximated,
    "one opening with a coefficient of time and an area of pressure: exact unless a vent is named below"};

// A cell of a table.
std::string markdown_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

}  // namespace

const char* name_of(Mapping mapping) {
  return mapping == Mapping::exact          ? "exact"
         : mapping == Mapping::approximated ? "approximated"
                                            : "no counterpart";
}

const std::vector<Feature>& features() {
  static const std::vector<Feature> table{
      {"scene.name", same, same},
      {"scene.end_time", same, same},
      {"scene.gravity", same, same},
      {"scene.format", solver, solver},
      {"ambient.pressure", same, same},
      {"ambient.temperature", in_deck, in_deck},
      {"ambient.composition",
       {Mapping::none, "no gas flows in from outside"},
       {Mapping::none, "no gas flows in from outside"}},
      {"ambient.composition_by", in_deck, in_deck},
      {"gas.thermodynamics", polynomial, molar},
      {"gas.reference_temperature", in_deck, in_deck},
      {"gas.initial.composition",
       {Mapping::exact, "one gas with the mixture's molar mass and cp"},
       {Mapping::exact, "one gas with the mixture's molar mass and cp"}},
      {"gas.initial.composition_by", in_deck, in_deck},
      {"gas.initial.pressure",
       {Mapping::approximated, "exact at ambient pressure; else an inflator of its own, see below"},
       {Mapping::approximated, "exact at ambient pressure; else an inflator of its own, see below"}},
      {"gas.initial.temperature", same, same},
      {"gas.species.name", in_deck, in_deck},
      {"gas.species.molar_mass", same, same},
      {"gas.species.gas_constant", in_deck, in_deck},
      {"gas.species.cp", same, same},
      {"gas.species.nasa7", polynomial, molar},
      {"gas.species.nasa7.low", polynomial, molar},
      {"gas.species.nasa7.high", polynomial, molar},
      {"gas.species.nasa7.range", solver, solver},
      {"gas.species.nasa7.middle", solver, solver},
      {"gas.heat_loss",
       {Mapping::none, "the walls are adiabatic"},
       {Mapping::none, "the walls are adiabatic"}},
      {"gas.heat_loss.coefficient",
       {Mapping::none, "the walls are adiabatic"},
       {Mapping::none, "the walls are adiabatic"}},
      {"gas.heat_loss.outside_temperature",
       {Mapping::none, "the walls are adiabatic"},
       {Mapping::none, "the walls are adiabatic"}},
      {"tank", tank, tank},
      {"tank.volume", tank, tank},
      {"tank.mean", tank, tank},
      {"tank.amplitude", tank, tank},
      {"tank.frequency", tank, tank},
      {"tank.phase", tank, tank},
      {"inflator.mass_flow", same, same},
      {"inflator.mass_flow.time_column", in_deck, in_deck},
      {"inflator.mass_flow.column", in_deck, in_deck},
      {"inflator.temperature", same, same},
      {"inflator.composition",
       {Mapping::exact, "one gas with the mixture's molar mass and cp"},
       {Mapping::exact, "one gas with the mixture's molar mass and cp"}},
      {"inflator.composition_by", in_deck, in_deck},
      {"inflator.start_time",
       {Mapping::exact, "the curves are shifted"},
       {Mapping::exact, "the curves are shifted"}},
      {"inflator.trigger", trigger, trigger},
      {"inflator.jet", jet, jet},
      {"inflator.jet.shape", jet, jet},
      {"inflator.jet.centre", jet, jet},
      {"inflator.jet.axis", jet, jet},
      {"inflator.jet.radius", jet, jet},
      {"inflator.jet.long_direction", jet, jet},
      {"inflator.jet.long_side", jet, jet},
      {"inflator.jet.short_side", jet, jet},
      {"inflator.jet.decay_coefficient", jet, jet},
      {"inflator.jet.outlet_type", jet, jet},
      {"inflator.jet.spread", jet, jet},
      {"inflator.jet.cone_initial_width", jet, jet},
      {"inflator.jet.cone_half_angle", jet, jet},
      {"inflator.jet.direction", jet, jet},
      {"inflator.jet.restitution", jet, jet},
      {"inflator.jet.cut_off", jet, jet},
      {"inflator.jet.relative_to_skin", jet, jet},
      {"inflator.jet.subdivisions", jet, jet},
      {"inflator.jet.outlet", jet, jet},
      {"inflator.jet.temperature", jet, jet},
      {"inflator.jet.attachment_panels", jet, jet},
      {"inflator.jet.occlusion", jet, jet},
      {"inflator.jet.visibility", jet, jet},
      {"inflator.jet.jet_work", jet, jet},
      {"vent.area",
       {Mapping::exact, "isentropic flow, choked above the critical ratio, by area and coefficient"},
       one_opening},
      {"vent.discharge_coefficient", {Mapping::exact, "factor of the area"}, one_opening},
      {"vent.backflow", {Mapping::none, "no gas flows in"}, {Mapping::none, "no gas flows in"}},
      {"vent.trigger", trigger, trigger},
      {"sensor.name", in_deck, in_deck},
      {"sensor.time",
       {Mapping::exact, "shift of a curve, or time at which a vent opens"},
       {Mapping::exact, "shift of a curve"}},
      {"sensor.signal", trigger, trigger},
      {"sensor.above", trigger, trigger},
      {"sensor.overpressure",
       {Mapping::approximated, "pressure at which a vent opens, and stays open"},
       {Mapping::approximated,
        "pressure at which a single vent opens; of several it is left out, see below"}},
      {"sensor.reset", trigger, trigger},
      {"sensor.contact", trigger, trigger},
      {"trigger.name", in_deck, in_deck},
      {"trigger.all", trigger, trigger},
      {"trigger.any", trigger, trigger},
      {"trigger.not", trigger, trigger},
      {"trigger.delay", trigger, trigger},
      {"trigger.latch", trigger, trigger},
      {"fabric.law", law, fabric_law},
      {"fabric.warp_curve", chord, chord},
      {"fabric.weft_curve", chord, chord},
      {"fabric.young_modulus", law, fabric_law},
      {"fabric.poisson_ratio", law, fabric_law},
      {"fabric.density", same, same},
      {"fabric.thickness", same, same},
      {"fabric.porosity", {Mapping::exact, "share of the area of the panel that leaks"}, one_area},
      {"fabric.leak_law", {Mapping::exact, "share or velocity by panel"}, one_area},
      {"fabric.velocity",
       {Mapping::exact, "velocity against overpressure"},
       {Mapping::approximated,
        "velocity against absolute pressure (FVOPT 7), over the area that the program takes"}},
      {"fabric.compression",
       {Mapping::approximated,
        "none: compressive principal stress is cut to 1e-3, and the tensile one keeps the Poisson effect of "
        "the wrinkled direction"},
       {Mapping::approximated, "none: the program leaves compressive stress out"}},
      {"fabric.weave.young_modulus_weft", law, fabric_law},
      {"fabric.weave.shear_modulus", law, fabric_law},
      {"fabric.weave.warp",
       {Mapping::exact, "vector of the property"},
       {Mapping::exact, "vector of the material"}},
      {"fabric.panel.panels", {Mapping::exact, "a part a panel"}, {Mapping::exact, "a part a panel"}},
      {"fabric.panel.young_modulus", law, fabric_law},
      {"fabric.panel.poisson_ratio", law, fabric_law},
      {"fabric.panel.density", same, same},
      {"fabric.panel.thickness", same, same},
      {"fabric.panel.porosity", same, one_area},
      {"fabric.panel.weave", law, fabric_law},
      {"membrane.mesh.file", shape, shape},
      {"membrane.mesh.initial_file", shape, shape},
      {"membrane.mesh.length_unit", in_deck, in_deck},
      {"membrane.mesh.generator", shape, shape},
      {"membrane.mesh", shape, shape},
      {"membrane.flatten", shape, shape},
      {"membrane.perturbation", shape, shape},
      {"membrane.perturbation_seed", shape, shape},
      {"membrane.fixed_panels", same, same},
      {"membrane.roller", same, same},
      {"membrane.roller.directions", same, same},
      {"membrane.null_panels",
       {Mapping::exact, "parts without stress that close the volume"},
       {Mapping::exact, "parts without stress that close the volume"}},
      {"membrane.mass_damping", same, same},
      {"membrane.stiffness_damping",
       {Mapping::approximated, "Beta of /DAMP, which the program applies to its nodal forces"},
       {Mapping::approximated, "COEF of *DAMPING_PART_STIFFNESS below zero, the coefficient itself"}},
      {"membrane.overpressure", tank, tank},
      {"membrane.plate.point",
       {Mapping::approximated, "rigid wall, infinitely stiff"},
       {Mapping::approximated, "rigid wall, infinitely stiff"}},
      {"membrane.plate.normal", same, same},
      {"membrane.plate.stiffness",
       {Mapping::none, "the wall is infinitely stiff"},
       {Mapping::none, "the wall is infinitely stiff"}},
      {"membrane.strap.from", same, same},
      {"membrane.strap.to", same, same},
      {"membrane.strap.stiffness",
       {Mapping::exact, "spring by a curve: no force below its free length"},
       {Mapping::exact, "spring by a curve: no force below its free length"}},
      {"membrane.strap.free_length", same, same},
      {"target", tank, tank},
      {"pendulum.pivot",
       {Mapping::approximated, "joint by a penalty"},
       {Mapping::approximated, "joint by a penalty"}},
      {"pendulum.axis", same, same},
      {"pendulum.rest_direction", same, same},
      {"pendulum.mass", same, same},
      {"pendulum.inertia_cg", same, same},
      {"pendulum.cg_distance", same, same},
      {"pendulum.impactor_distance", same, same},
      {"pendulum.impactor_radius", sphere, sphere},
      {"pendulum.initial_angle", same, same},
      {"pendulum.initial_angular_velocity", same, same},
      {"pendulum.driving_moment",
       {Mapping::none, "load the rigid body by hand"},
       {Mapping::none, "load the rigid body by hand"}},
      {"contact.stiffness", contact, contact},
      {"contact.stiffness_share", contact, contact},
      {"contact.friction", same, same},
      {"time", solver, solver},
      {"output.history_every", same, same},
      {"output.history_exact", output, output},
      {"output.streams", output, output},
      {"output.frames",
       {Mapping::exact, "intervals between pictures"},
       {Mapping::exact, "intervals between pictures"}},
      {"output.fields_every", output, output},
  };
  return table;
}

const Feature* feature_of(const std::string& path) {
  std::string key;
  for (const PathPart& part : split_path(path))
    if (!part.index) key += fmt::format("{}{}", key.empty() ? "" : ".", part.key);
  const Feature* longest = nullptr;
  for (const Feature& feature : features()) {
    const std::string_view name = feature.key;
    if (!key.starts_with(name) || (key.size() > name.size() && key[name.size()] != '.')) continue;
    if (longest == nullptr || name.size() > std::string_view(longest->key).size()) longest = &feature;
  }
  return longest;
}

std::vector<UsedFeature> used_features(const CaseDocument& document, DeckFormat format) {
  std::vector<UsedFeature> used;
  for (const Setting& setting : document.settings()) {
    const Feature* feature = feature_of(setting.path);
    if (feature == nullptr)
      throw std::logic_error(fmt::format("the table of export has no row for the key {}", setting.path));
    used.push_back({setting.path, setting.value, feature->in(format)});
  }
  return used;
}

std::string export_markdown(const Deck& deck, const std::vector<UsedFeature>& used,
                            const std::string& title) {
  std::string text = fmt::format("# {}\n\n", one_line(title));
  for (const Mapping mapping : {Mapping::none, Mapping::approximated, Mapping::exact}) {
    text += fmt::format("## {}\n\n| key | value | how |\n|---|---|---|\n", name_of(mapping));
    for (const UsedFeature& feature : used)
      if (feature.outcome.mapping == mapping)
        text += fmt::format("| `{}` | `{}` | {} |\n", markdown_cell(feature.path),
                            markdown_cell(feature.value), feature.outcome.how);
    text += '\n';
  }
  text += "## In this scene\n\n";
  for (const DeckNote& note : deck.notes) text += fmt::format("- `{}`: {}\n", note.key, note.text);
  if (deck.notes.empty()) text += "Nothing more.\n";
  return text;
}

}  // namespace driver
