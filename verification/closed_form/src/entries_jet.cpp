// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"
#include "closed_form/jet.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

const char* const kAbramovich =
    "G. N. Abramovich, The Theory of Turbulent Jets (textbook result); width derived here";

Parameters outlet_parameters(double spread) {
  return {{"spread", "a", "1", spread, "turbulence structure coefficient"},
          {"outlet_velocity", "V0", "m/s", 400.0, "velocity at the outlet"},
          {"outlet_density", "rho0", "kg/m3", 1.0, "density at the outlet"}};
}

std::vector<std::string> section_columns() {
  return {"distance_m",        "centreline_velocity_m_s", "width_m",     "momentum_flux_N",
          "volume_flux_ratio", "energy_flux_ratio",       "velocity_m_s"};
}

Row section_row(const JetSection& s, double velocity) {
  return {s.centreline_velocity, s.width, s.momentum_flux, s.volume_flux_ratio,
          s.energy_flux_ratio,   velocity};
}

Entry round_jet_entry() {
  return {"round_jet",
          "Round jet over axial distance",
          "Vm/V0 = min(1, 0.96/(a z/R0 + 0.29)); R = sqrt 2 R0 V0/Vm; V = Vm exp(-r^2/R^2)",
          kAbramovich,
          "z >= 0",
          15,
          joined({outlet_parameters(0.08),
                  {{"radius", "R0", "m", 0.05, "radius of the outlet"},
                   {"offset", "r", "m", 0.0, "distance from the axis of the last column"}}}),
          section_columns(),
          range(0.0, 2.0, 40),
          [](const ParameterMap& v, double z) {
            const RoundJet jet{get(v, "radius"), get(v, "spread"), get(v, "outlet_velocity"),
                               get(v, "outlet_density")};
            return section_row(round_jet_section(jet, z), round_jet_velocity(jet, z, get(v, "offset")));
          }};
}

Entry plane_jet_entry() {
  return {"plane_jet",
          "Plane jet over axial distance",
          "Vm/V0 = min(1, 1.2/sqrt(a z/b0 + 0.41)); b = 2 sqrt(2/pi) b0 (V0/Vm)^2; V = Vm exp(-y^2/b^2)",
          kAbramovich,
          "z >= 0",
          15,
          joined({outlet_parameters(0.11),
                  {{"half_width", "b0", "m", 0.01, "half the short side of the outlet"},
                   {"length", "L", "m", 0.2, "long side of the outlet"},
                   {"offset", "y", "m", 0.0, "distance from the mid plane of the last column"}}}),
          section_columns(),
          range(0.0, 1.0, 40),
          [](const ParameterMap& v, double z) {
            const PlaneJet jet{get(v, "half_width"), get(v, "length"), get(v, "spread"),
                               get(v, "outlet_velocity"), get(v, "outlet_density")};
            return section_row(plane_jet_section(jet, z), plane_jet_velocity(jet, z, get(v, "offset")));
          }};
}

Entry far_field_entry() {
  return {"jet_far_field",
          "Constants that experiments report, over the spread a",
          "round: core 0.67/a, B = 0.48/a, S = sqrt(2 ln 2) a/0.96, entrainment 4 a/0.96; plane: core "
          "1.03/a, K = 2 a/1.44",
          "derived here from the centreline laws",
          "a > 0",
          15,
          {},
          {"spread", "round_core_over_radius", "round_decay_constant", "round_half_width_slope",
           "round_entrainment_slope", "plane_core_over_half_width", "plane_decay_constant",
           "plane_half_width_slope"},
          {0.066, 0.076, 0.08, 0.089, 0.1, 0.108, 0.11, 0.12},
          [](const ParameterMap&, double a) {
            const RoundFarField r = round_far_field(a);
            const PlaneFarField p = plane_far_field(a);
            return Row{round_core_length(a), r.decay_constant, r.half_width_slope, r.entrainment_slope,
                       plane_core_length(a), p.decay_constant, p.half_width_slope};
          }};
}

Row tollmien_row(const TollmienConstants& c) {
  return {c.edge, c.half_velocity, c.momentum_integral, c.flux_integral, c.decay_constant};
}

std::vector<std::string> tollmien_columns() {
  return {"edge", "half_velocity", "momentum_integral", "flux_integral", "decay_constant"};
}

Entry tollmien_round_entry() {
  return {"tollmien_round",
          "Mixing-length similarity of the round jet",
          "(F'' - F'/phi)^2 = F F', f = F'/phi",
          "W. Tollmien (1926); integrated here",
          "far field",
          12,
          {},
          tollmien_columns(),
          {},
          [](const ParameterMap&, double) { return tollmien_row(tollmien_round()); }};
}

Entry tollmien_plane_entry() {
  return {"tollmien_plane",
          "Mixing-length similarity of the plane jet",
          "F''^2 = F F', f = F': F^(3/2) = 1 - f^(3/2)",
          "W. Tollmien (1926); Beta functions derived here",
          "far field",
          14,
          {},
          tollmien_columns(),
          {},
          [](const ParameterMap&, double) { return tollmien_row(tollmien_plane()); }};
}

Entry sonic_outlet_entry() {
  return {"sonic_outlet",
          "Sonic outlet state over mass flow",
          "V0 = sqrt((gamma-1) cp T_s), times sqrt(2/(gamma+1)) for stagnation T_s; rho0 = mdot/(A V0)",
          "Gas Jet Model for Airbag Inflators; textbook result",
          "does not fix the outlet pressure",
          15,
          joined({gas_parameters(),
                  {{"temperature", "T_s", "K", 406.0, "static, or stagnation"},
                   {"stagnation", "", "1", 0.0, "0: T_s is static; 1: stagnation"},
                   {"area", "A", "m2", 5e-3, "area of the outlet"}}}),
          {"inflow_kg_s", "velocity_m_s", "density_kg_m3", "momentum_flux_N", "static_pressure_Pa"},
          range(0.5, 4.0, 7),
          [](const ParameterMap& v, double mass_flow) {
            const bool stagnation = check::integer_within("stagnation", whole(v, "stagnation"), 0, 1) == 1;
            const OutletState s =
                sonic_outlet({gas_of(v), get(v, "temperature"), stagnation, mass_flow, get(v, "area")});
            return Row{s.velocity, s.density, s.momentum_flux, s.static_pressure};
          }};
}

}  // namespace

void add_jets(std::vector<Entry>& list) {
  for (Entry (*entry)() : {round_jet_entry, plane_jet_entry, far_field_entry, tollmien_round_entry,
                           tollmien_plane_entry, sonic_outlet_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
