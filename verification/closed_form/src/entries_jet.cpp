// SPDX-License-Identifier: Apache-2.0
#include "closed_form/jet.hpp"
#include "closed_form/occlusion.hpp"
#include "entries.hpp"
#include "fields.hpp"

namespace closed_form::entries {
namespace {

const char* const kAbramovich =
    "G. N. Abramovich, The Theory of Turbulent Jets (textbook result); width derived here";

auto outlet(double spread) {
  return [spread]<class S>(Form<S>& form) {
    form.field(&S::spread, "spread", "a", "1", spread, "turbulence structure coefficient")
        .field(&S::outlet_velocity, "outlet_velocity", "V0", "m/s", 400.0, "velocity at the outlet")
        .field(&S::outlet_density, "outlet_density", "rho0", "kg/m3", 1.0, "density at the outlet");
  };
}

Columns<JetSection> section_columns() {
  return {{"centreline_velocity_m_s", &JetSection::centreline_velocity},
          {"width_m", &JetSection::width},
          {"momentum_flux_N", &JetSection::momentum_flux},
          {"volume_flux_ratio", &JetSection::volume_flux_ratio},
          {"energy_flux_ratio", &JetSection::energy_flux_ratio}};
}

Columns<TollmienConstants> tollmien_columns() {
  return {{"edge", &TollmienConstants::edge},
          {"half_velocity", &TollmienConstants::half_velocity},
          {"momentum_integral", &TollmienConstants::momentum_integral},
          {"flux_integral", &TollmienConstants::flux_integral},
          {"decay_constant", &TollmienConstants::decay_constant}};
}

auto width() {
  return [](Form<Nothing>& form) {
    form.number("width", "R", "m", 1.0, "width of exp(-(r/R)^2) at the target");
  };
}

}  // namespace

std::vector<Entry> jets() {
  return {
      Form<RoundJet>("round_jet", "Round jet over axial distance",
                     "Vm/V0 = min(1, 0.96/(a z/R0 + 0.29)); R = sqrt 2 R0 V0/Vm; V = Vm exp(-r^2/R^2)",
                     kAbramovich, "z >= 0", 12)
          .fields(outlet(0.08), radius(0.05, "radius of the outlet"))
          .number("offset", "r", "m", 0.0, "distance from the axis of the last column")
          .over("distance_m", range(0.0, 2.0, 40))
          .results(round_jet_section, section_columns())
          .result("velocity_m_s", with(round_jet_velocity, itself, abscissa, "offset")),
      Form<PlaneJet>(
          "plane_jet", "Plane jet over axial distance",
          "Vm/V0 = min(1, 1.2/sqrt(a z/b0 + 0.41)); b = 2 sqrt(2/pi) b0 (V0/Vm)^2; V = Vm exp(-y^2/b^2)",
          kAbramovich, "z >= 0", 12)
          .fields(outlet(0.11))
          .field(&PlaneJet::half_width, "half_width", "b0", "m", 0.01, "half the short side of the outlet")
          .field(&PlaneJet::length, "length", "L", "m", 0.2, "long side of the outlet")
          .number("offset", "y", "m", 0.0, "distance from the mid plane of the last column")
          .over("distance_m", range(0.0, 1.0, 40))
          .results(plane_jet_section, section_columns())
          .result("velocity_m_s", with(plane_jet_velocity, itself, abscissa, "offset")),
      Form<Nothing>(
          "jet_far_field", "Constants that experiments report, over the spread a",
          "round: core 0.67/a, B = 0.48/a, S = sqrt(2 ln 2) a/0.96, entrainment 4 a/0.96; plane: core "
          "1.03/a, K = 2 a/1.44",
          "derived here from the centreline laws", "a > 0", 15)
          .over("spread", {0.066, 0.076, 0.08, 0.089, 0.1, 0.108, 0.11, 0.12})
          .result("round_core_over_radius", round_core_length)
          .results(round_far_field, {{"round_decay_constant", &RoundFarField::decay_constant},
                                     {"round_half_width_slope", &RoundFarField::half_width_slope},
                                     {"round_entrainment_slope", &RoundFarField::entrainment_slope}})
          .result("plane_core_over_half_width", plane_core_length)
          .results(plane_far_field, {{"plane_decay_constant", &PlaneFarField::decay_constant},
                                     {"plane_half_width_slope", &PlaneFarField::half_width_slope}}),
      Form<Nothing>("tollmien_round", "Mixing-length similarity of the round jet",
                    "(F'' - F'/phi)^2 = F F', f = F'/phi", "W. Tollmien (1926); integrated here", "far field",
                    12)
          .results(tollmien_round, tollmien_columns()),
      Form<Nothing>("tollmien_plane", "Mixing-length similarity of the plane jet",
                    "F''^2 = F F', f = F': F^(3/2) = 1 - f^(3/2)",
                    "W. Tollmien (1926); Beta functions derived here", "far field", 14)
          .results(tollmien_plane, tollmien_columns()),
      Form<CompressibleJet>(
          "witze_decay", "Centreline of a compressible round jet, over z/D",
          "Vm/V0 = 1 - exp(-1/t), t = 2 kappa (z/D) sqrt(rho_inf/rho0) - 0.70 > 0; kappa = 0.08 (1 - 0.16 M) "
          "(rho0/rho_inf)^0.22",
          "P. O. Witze, AIAA J. 12(4), 1974, pp. 417-418, at second hand (Franquet and others, Prog. Aerosp. "
          "Sci. 77, 2015; the sign of 0.22 from a published program alone)",
          "0 <= M <= 1, given for M <= 0.81; not underexpanded; three measured jets to 4 to 10 % (r.m.s., 6 "
          "to "
          "20 D), one with M = 0.985",
          15)
          .field(&CompressibleJet::mach, "mach", "M", "1", 1.0, "Mach number of the outlet")
          .field(&CompressibleJet::density_ratio, "density_ratio", "q", "1", 1.2,
                 "density of the outlet over that of the surroundings; 1.2: sonic air from a supply as warm "
                 "as they are")
          .over("distance_over_diameter", range(0.0, 20.0, 20))
          .result("centreline_ratio", witze_centreline_ratio)
          .constant("core_over_diameter", witze_core_length)
          .constant("decay_constant", witze_decay_constant),
      Form<SonicOutlet>(
          "sonic_outlet", "Sonic outlet state over mass flow",
          "V0 = sqrt((gamma-1) cp T_s), times sqrt(2/(gamma+1)) for stagnation T_s; rho0 = mdot/(A V0)",
          "Gas Jet Model for Airbag Inflators; textbook result", "does not fix the outlet pressure", 15)
          .fields(gas())
          .field(&SonicOutlet::temperature, "temperature", "T_s", "K", 406.0, "static, or stagnation")
          .field(&SonicOutlet::stagnation, "stagnation", "", "1", 0.0, "0: T_s is static; 1: stagnation")
          .field(&SonicOutlet::area, "area", "A", "m2", 5e-3, "area of the outlet")
          .over("inflow_kg_s", range(0.5, 4.0, 7), &SonicOutlet::mass_flow)
          .results(sonic_outlet, {{"velocity_m_s", &OutletState::velocity},
                                  {"density_kg_m3", &OutletState::density},
                                  {"momentum_flux_N", &OutletState::momentum_flux},
                                  {"static_pressure_Pa", &OutletState::static_pressure}}),
      Form<ExpandedOutlet>(
          "expanded_outlet", "Notional nozzle of an underexpanded outlet over n = pe/p",
          "V = V0 + (pe - p) A/mdot; T = T_s - V^2/(2 cp); rho = p/(R T); mdot = rho V A_n; load on a plate "
          "mdot V0 + (pe - p) A + e mdot V0",
          "derived here from mass, momentum and energy", "n >= 1; sonic outlet; e >= -1", 15)
          .fields(gas())
          .field(&ExpandedOutlet::stagnation_temperature, "stagnation_temperature", "T_s", "K", 700.0,
                 "of the inflator's gas")
          .field(&ExpandedOutlet::area, "area", "A", "m2", 5e-3, "area of the outlet")
          .field(&ExpandedOutlet::bag_pressure, "bag_pressure", "p", "Pa", 101325.0,
                 "absolute, around the outlet")
          .number("restitution", "e", "1", 1.0, "1 reflection, 0 deflection into the plate")
          .over("pressure_ratio", range(1.0, 5.0, 8), &ExpandedOutlet::pressure_ratio)
          .results(expanded_outlet, {{"mass_flow_kg_s", &NotionalNozzle::mass_flow},
                                     {"velocity_m_s", &NotionalNozzle::velocity},
                                     {"density_kg_m3", &NotionalNozzle::density},
                                     {"temperature_K", &NotionalNozzle::temperature},
                                     {"area_ratio", &NotionalNozzle::area_ratio},
                                     {"thrust_N", &NotionalNozzle::thrust}})
          .result("plate_load_N", with(plate_load, itself, "restitution"))};
}

std::vector<Entry> jet_targets() {
  return {
      Form<Nothing>("plate_force", "Force on an unbounded plate normal to the jet, over the momentum flux",
                    "F = c J", "momentum balance, textbook result", "1 <= c <= 2; J >= 0", 15)
          .number("reflection", "c", "1", 2.0, "1 deflection into the plane, 2 complete reflection")
          .over("momentum_flux_N", {100.0, 821.46483795717026, 1600.0})
          .result("jet_force_N", with(plate_force, "reflection", abscissa)),
      Form<Nothing>(
          "inclined_plate", "Normal force on a plate inclined to a round jet, over F = c J, over the angle",
          "cos(theta) sqrt(2/pi) int exp(-2 w^2)/(1 - s w) dw, s = R' tan(theta); cos(theta) without "
          "spreading",
          "derived here", "|s| extent < 1", 14)
          .number("width_slope", "R'", "1", 0.11785113019775793, "growth dR/dz of the width")
          .number("extent", "", "1", 3.0, "half width of the plate over R")
          .over("angle_rad", range(0.0, 1.1, 22))
          .result("force_fraction",
                  with([](double theta, double slope,
                          double extent) { return inclined_plate_fraction(theta, slope, extent); },
                       abscissa, "width_slope", "extent"))
          .result("force_fraction_constant_width",
                  [](double theta) { return inclined_plate_fraction(theta); }),
      Form<Nothing>("disc_target", "Momentum fraction caught by a disc over its radius",
                    "1 - exp(-2 rho^2/R^2) on the axis; 1 - Q1(2 d/R, 2 rho/R) at offset d (Marcum Q)",
                    "derived here", "disc normal to the axis, radius > 0", 13)
          .fields(width())
          .number("offset", "d", "m", 0.5, "of the disc's centre from the axis")
          .over("disc_radius_m", range(0.1, 2.0, 19))
          .result("coaxial_fraction", with(disc_fraction, abscissa, "width"))
          .result("offset_fraction", with(off_axis_disc_fraction, abscissa, "offset", "width")),
      Form<Nothing>("square_target", "Momentum fraction caught by a square over half its side",
                    "erf(sqrt 2 L/R)^2", "derived here", "coaxial, normal to the axis", 15)
          .fields(width())
          .over("half_side_m", range(0.0, 2.0, 20))
          .result("fraction", with(square_fraction, abscissa, "width")),
      Form<Nothing>("half_plane_target", "Momentum fraction caught by a half plane over its edge's distance",
                    "Phi(2 d/R)", "derived here", "d > 0: the axis hits the target", 15)
          .fields(width())
          .over("edge_distance_m", range(-1.0, 1.0, 20))
          .result("fraction", with(half_plane_fraction, abscissa, "width")),
      Form<Nothing>("lattice_quadrature",
                    "Error of centre-of-element pressure on a square lattice over spacing/width",
                    "(1 + e)^2 - 1, e = 2 sum (-1)^k exp(-k^2 pi^2 R^2/(2 h^2))",
                    "derived here (Poisson summation)", "lattice corner on the axis; 0 < h/R <= 10", 13)
          .over("spacing_over_width", {0.25, 0.5, 0.75, 1.0, 1.5})
          .result("relative_error", lattice_quadrature_error)};
}

std::vector<Entry> shadows() {
  return {
      Form<Nothing>("hidden_disc", "Part of a disc hidden behind a disc over the occluder's offset",
                    "(r1 z2/(z1 r2))^2 coaxial; lens area of shadow and target over the target's",
                    "derived here", "parallel discs, point source on the target's axis; z2 > z1 > 0", 14)
          .number("occluder_radius", "r1", "m", 0.3, "of the occluder")
          .number("occluder_distance", "z1", "m", 1.0, "source to occluder")
          .number("target_radius", "r2", "m", 1.0, "of the target")
          .number("target_distance", "z2", "m", 2.0, "source to target")
          .over("offset_m", range(0.0, 0.8, 16))
          .result("hidden_fraction", with(hidden_disc_fraction, "occluder_radius", "occluder_distance",
                                          "target_radius", "target_distance", abscissa))
          .result("hidden_fraction_coaxial", with(hidden_coaxial_disc_fraction, "occluder_radius",
                                                  "occluder_distance", "target_radius", "target_distance")),
      Form<Nothing>("sphere_shadow",
                    "Opaque sphere between a source and a concentric shell, over the source's distance",
                    "shadow cap asin(r/D) + asin(r/R); visible part (1 - r/D)/2; solid angle 2 pi (1 - "
                    "sqrt(1 - (r/D)^2))",
                    "derived here", "r < D < R", 15)
          .number("sphere_radius", "r", "m", 0.5, "opaque sphere")
          .number("shell_radius", "R", "m", 2.0, "shell")
          .over("source_distance_m", range(0.6, 1.8, 12))
          .result("shadow_half_angle_rad",
                  with(sphere_shadow_half_angle, "sphere_radius", abscissa, "shell_radius"))
          .result("visible_fraction", with(visible_sphere_fraction, "sphere_radius", abscissa))
          .result("solid_angle_sr", with(sphere_solid_angle, "sphere_radius", abscissa)),
      Form<Nothing>("icosahedron_faces", "Faces of an icosahedron seen from a vertex axis, over the distance",
                    "20 inside, 5 up to 2 + sqrt 5 circumradii, 10 beyond", "derived here",
                    "distance >= 0, not 1", 2)
          .over("distance_over_circumradius", {0.0, 1.01, 2.0, 4.0, 5.0, 100.0})
          .result("visible_faces", icosahedron_visible_faces)};
}

}  // namespace closed_form::entries
