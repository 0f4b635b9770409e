// SPDX-License-Identifier: Apache-2.0
// The tables of how decks represent each key.
#include "feature_outcomes.hpp"

namespace driver {
namespace {

using outcomes::in_deck, outcomes::own_penalty, outcomes::same;
constexpr Outcome no_inflow{Mapping::none, "no gas flows in from outside"};
constexpr Outcome adiabatic{Mapping::none, "the walls are adiabatic"};
constexpr Outcome lost_heat{Mapping::none, "the walls are adiabatic", true};
constexpr Outcome stiff_wall{Mapping::none, "the wall is infinitely stiff", true};
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
                          "triggers by time and signals become times; pressure opens a vent"};
constexpr Outcome law{
    Mapping::approximated,
    "linear law of logarithmic strain, woven fabric of linear strain: exact for Hencky while taut, for St. "
    "Venant-Kirchhoff to first order of strain"};
constexpr Outcome shape{Mapping::exact, "start shape as nodes, design shape as reference geometry"};
constexpr Outcome fabric_law{Mapping::approximated,
                             "the program's fabric in Green-Lagrange strain (FORM 12) for St. "
                             "Venant-Kirchhoff, in its invariant frame "
                             "(FORM 1) for Hencky: all agree to first order of strain"};
constexpr Outcome curve_of_thread{Mapping::exact,
                                  "function of nominal stress over stretch minus 1, as in the case"};
constexpr Outcome green_curve_of_thread{
    Mapping::approximated,
    "curve of second Piola-Kirchhoff stress over Green-Lagrange strain: exact at its points, between them by "
    "the size below"};
constexpr Outcome one_area{Mapping::approximated, "leaks by the area that the program takes for its fabric"};
constexpr Outcome one_opening{
    Mapping::approximated,
    "one opening with a coefficient of time and an area of pressure: exact unless a vent is named below"};

std::vector<Feature> with_impactors(std::vector<Feature> table) {
  table.insert(table.end(), features_of_impactors().begin(), features_of_impactors().end());
  return table;
}

}  // namespace

const std::vector<Feature>& features() {
  static const std::vector<Feature> table = with_impactors({
      {"scene.name", same, same},
      {"scene.end_time", same, same},
      {"scene.format", solver, solver},
      {"ambient.pressure", same, same},
      {"ambient.temperature", no_inflow, no_inflow},
      {"ambient.composition", no_inflow, no_inflow},
      {"ambient.composition_by", no_inflow, no_inflow},
      {"gas.thermodynamics", polynomial, molar},
      {"gas.reference_temperature", in_deck, in_deck},
      {"gas.initial.composition",
       {Mapping::exact, "one gas with the mixture's molar mass and cp"},
       {Mapping::exact, "one gas with the mixture's molar mass and cp"}},
      {"gas.initial.composition_by", in_deck, in_deck},
      {"gas.initial.pressure",
       {Mapping::approximated, "exact at ambient pressure; else an additional inflator, see below"},
       {Mapping::approximated, "exact at ambient pressure; else an additional inflator, see below"}},
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
      {"gas.heat_loss", adiabatic, adiabatic},
      {"gas.heat_loss.coefficient", lost_heat, lost_heat},
      {"gas.heat_loss.outside_temperature", adiabatic, adiabatic},
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
      {"inflator.jet.share", jet, jet},
      {"inflator.jet.ring", jet, jet},
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
      {"vent.backflow", {Mapping::none, "no gas flows in", true}, {Mapping::none, "no gas flows in", true}},
      {"vent.trigger", trigger, trigger},
      {"sensor.name", in_deck, in_deck},
      {"sensor.time",
       {Mapping::exact, "shift of a curve, or time at which a vent opens"},
       {Mapping::exact, "shift of a curve"}},
      {"sensor.signal",
       {Mapping::exact, "its crossings become times"},
       {Mapping::exact, "its crossings become times"}},
      {"sensor.above", in_deck, in_deck},
      {"sensor.overpressure",
       {Mapping::approximated, "pressure at which a vent opens, and stays open"},
       {Mapping::approximated, "pressure at which a single vent opens, and stays open"}},
      {"sensor.reset", trigger, trigger},
      {"sensor.contact", trigger, trigger},
      {"sensor.external", trigger, trigger},
      {"trigger.name", in_deck, in_deck},
      {"trigger.all", trigger, trigger},
      {"trigger.any", trigger, trigger},
      {"trigger.not", trigger, trigger},
      {"trigger.delay", trigger, trigger},
      {"trigger.latch", trigger, trigger},
      {"fabric.law", law, fabric_law},
      {"fabric.warp_curve", curve_of_thread, green_curve_of_thread},
      {"fabric.weft_curve", curve_of_thread, green_curve_of_thread},
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
       {Mapping::approximated, "none: the program drops compressive stress"}},
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
      {"membrane.fold", shape, shape},
      {"membrane.fold.at", shape, shape},
      {"membrane.fold.axis", shape, shape},
      {"membrane.fold.easing", shape, shape},
      {"membrane.fold.gap", shape, shape},
      {"membrane.fold.type", shape, shape},
      {"membrane.perturbation", shape, shape},
      {"membrane.perturbation_seed", shape, shape},
      {"membrane.fixed_panels", same, same},
      {"membrane.fixed_nodes", same, same},
      {"membrane.roller", same, same},
      {"membrane.roller.directions", same, same},
      {"membrane.roller.nodes", same, same},
      {"membrane.null_panels",
       {Mapping::exact, "parts without stress that close the volume"},
       {Mapping::exact, "parts without stress that close the volume"}},
      {"membrane.mass_damping", same, same},
      {"membrane.stiffness_damping",
       {Mapping::approximated, "Beta of /DAMP, which the program applies to its nodal forces"},
       {Mapping::approximated, "COEF of *DAMPING_PART_STIFFNESS below zero, the coefficient itself"}},
      {"membrane.overpressure",
       {Mapping::exact, "/PLOAD on all elements, along their normals"},
       {Mapping::exact, "*LOAD_SHELL_SET_ID on all elements, along their normals"}},
      {"membrane.plate.point",
       {Mapping::approximated, "rigid wall, infinitely stiff"},
       {Mapping::approximated, "rigid wall, infinitely stiff"}},
      {"membrane.plate.normal", same, same},
      {"membrane.plate.stiffness", stiff_wall, stiff_wall},
      {"membrane.self_contact", own_penalty, own_penalty},
      {"membrane.self_contact.thickness",
       {Mapping::approximated, "gap of /INTER/TYPE7, of nodes and elements; edges do not touch"},
       {Mapping::approximated, "SST of *CONTACT_AIRBAG_SINGLE_SURFACE, of segments (SOFT 2)"}},
      {"membrane.self_contact.friction", same, same},
      {"membrane.strap.from", same, same},
      {"membrane.strap.from_panel", same, same},
      {"membrane.strap.from_node", same, same},
      {"membrane.strap.to_node", same, same},
      {"membrane.strap.to", same, same},
      {"membrane.strap.to_panel", same, same},
      {"membrane.strap.stiffness",
       {Mapping::exact, "spring by a curve: no force below its free length"},
       {Mapping::exact, "spring by a curve: no force below its free length"}},
      {"membrane.strap.free_length", same, same},
      {"target", tank, tank},
      {"time", solver, solver},
      {"output.history_every", same, same},
      {"output.history_exact", output, output},
      {"output.streams", output, output},
      {"output.channel_classes", output, output},
      {"output.frames",
       {Mapping::exact, "intervals between pictures"},
       {Mapping::exact, "intervals between pictures"}},
      {"output.fields_every", output, output},
      {"output.self_intersection_every", output, output},
  });
  return table;
}

const std::vector<Feature>& features_of_curves() {
  constexpr Outcome shear{Mapping::approximated, "shear stress G tan(angle) (LAW58): by the size below"};
  constexpr Outcome own_shear{Mapping::approximated,
                              "shear modulus GAB, of the program's own strain between the threads"};
  static const std::vector<Feature> table{
      {"fabric.law",
       {Mapping::exact,
        "each thread by its own curve (LAW58), with almost no crimp and so no Poisson effect"},
       {Mapping::approximated,
        "each thread by its own curve (FORM 14), with no Poisson effect; unloading is along the curve"}},
      {"fabric.compression",
       {Mapping::approximated, "none: a thread keeps 1e-6 of its steepest slope, as the program requires"},
       {Mapping::approximated, "none: the program drops compressive stress, including that of shear"}},
      {"fabric.weave.shear_modulus", shear, own_shear},
      {"fabric.panel.weave", shear, own_shear},
      {"fabric.panel.weave.warp", same, same},
  };
  return table;
}

bool is_mapped(std::string_view name) {
  return name == "saint_venant_kirchhoff" || name == "hencky" || name == "curve";
}

const Feature& feature_of_other_laws() {
  constexpr Outcome other{Mapping::none,
                          "not mapped: the deck has the program's linear law with the case's moduli"};
  static const Feature row{"fabric.law", other, other};
  return row;
}

}  // namespace driver
