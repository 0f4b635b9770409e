// SPDX-License-Identifier: Apache-2.0
#include "closed_form/membrane.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

const char* const kStVK = "derived here (St. Venant-Kirchhoff, plane stress, reference thickness)";

Parameters radius_parameter(double value, const char* meaning) {
  return {{"radius", "R0", "m", value, meaning}};
}

Entry icosphere_entry() {
  return {"icosphere",
          "Volume and area of a refined icosahedron against its sphere",
          "V = (1/6) sum a.(b x c); midpoints pushed to the sphere at each level",
          "pure geometry, computed here",
          "whole level, 0 to 8",
          14,
          {},
          {"level", "faces", "volume_ratio", "area_ratio"},
          range(0.0, 5.0, 5),
          [](const ParameterMap&, double level) {
            const IcosphereRatios r = icosphere_ratios(whole_abscissa("level", level));
            return Row{static_cast<double>(r.faces), r.volume_ratio, r.area_ratio};
          }};
}

Entry icosahedron_entry() {
  return {"icosahedron_volume",
          "Volume of the regular icosahedron",
          "V = 5 (3 + sqrt 5)/12 edge^3",
          "textbook result",
          "edge > 0",
          15,
          {{"edge", "a", "m", 1.0, "edge"}},
          {"volume_m3"},
          {},
          [](const ParameterMap& v, double) { return Row{icosahedron_volume(get(v, "edge"))}; }};
}

Entry sphere_inflation_entry() {
  return {"sphere_inflation",
          "Spherical balloon over overpressure",
          "p = E h/((1-nu) R0) (lambda - 1/lambda); S = E/(1-nu) (lambda^2 - 1)/2",
          kStVK,
          "overpressure >= 0",
          15,
          joined({sheet_parameters(false), radius_parameter(0.3, "unstretched radius")}),
          {"overpressure_Pa", "stretch", "stress_Pa", "volume_m3", "strain_energy_J"},
          range(0.0, 1e5, 100),
          [](const ParameterMap& v, double p) {
            const SphereStretch s = stretched_sphere({sheet_of(v, false), get(v, "radius")}, p);
            return Row{s.stretch, s.stress, s.volume, s.strain_energy};
          }};
}

Entry sphere_breathing_entry() {
  return {"sphere_breathing",
          "Small breathing of an inflated sphere over overpressure",
          "omega^2 = (2 h P'/R0^2 - 2 p lambda/R0 + 3 gamma p_abs lambda/R0)/(rho h)",
          kStVK,
          "overpressure >= 0; gamma = 0 leaves out the gas",
          15,
          joined({sheet_parameters(true),
                  radius_parameter(0.30598317419458695, "unstretched radius"),
                  {ambient_pressure_parameter(),
                   {"heat_capacity_ratio", "gamma", "1", 1.4, "of the gas; 0 for none"}}}),
          {"overpressure_Pa", "angular_frequency_rad_s"},
          range(0.0, 1e5, 50),
          [](const ParameterMap& v, double p) {
            return Row{sphere_breathing_frequency({sheet_of(v, true), get(v, "radius")}, p,
                                                  get(v, "ambient_pressure"), get(v, "heat_capacity_ratio"))};
          }};
}

Entry sphere_decay_entry() {
  return {"sphere_breathing_decay",
          "Rate at which that breathing decays with stiffness-proportional damping, over overpressure",
          "beta E lambda^2/((1-nu) rho R0^2); lambda of sphere_inflation",
          kStVK,
          "overpressure >= 0, constant; below critical damping",
          15,
          joined({sheet_parameters(true),
                  radius_parameter(0.3, "unstretched radius"),
                  {{"stiffness_damping", "beta", "s", 1e-4, "stress beta dS/dt"}}}),
          {"overpressure_Pa", "decay_rate_1_s"},
          range(0.0, 1e5, 50),
          [](const ParameterMap& v, double p) {
            return Row{sphere_breathing_decay({sheet_of(v, true), get(v, "radius")}, p,
                                              get(v, "stiffness_damping"))};
          }};
}

Row cylinder_row(const CylinderStretch& s) {
  return {s.hoop_stretch, s.axial_stretch, s.hoop_stress, s.axial_stress};
}

Entry fixed_cylinder_entry() {
  return {"cylinder_fixed_length",
          "Cylindrical balloon of fixed length over overpressure",
          "lambda = sqrt(1 + 2 (1-nu^2) p R/(E h)); S_z = nu S",
          kStVK,
          "overpressure >= 0",
          15,
          joined({sheet_parameters(false), radius_parameter(0.15, "unstretched radius")}),
          {"overpressure_Pa", "hoop_stretch", "axial_stretch", "hoop_stress_Pa", "axial_stress_Pa"},
          range(0.0, 1e5, 50),
          [](const ParameterMap& v, double p) {
            return cylinder_row(fixed_length_cylinder({sheet_of(v, false), get(v, "radius")}, p));
          }};
}

Entry closed_cylinder_entry() {
  return {"cylinder_closed_ends",
          "Long cylindrical balloon with closed ends over overpressure",
          "S_h = p R lambda_z/h; lambda_z S_z = p R lambda_h^2/(2 h)",
          kStVK,
          "moderate stretch",
          14,
          joined({sheet_parameters(false), radius_parameter(0.15, "unstretched radius")}),
          {"overpressure_Pa", "hoop_stretch", "axial_stretch", "hoop_stress_Pa", "axial_stress_Pa"},
          range(0.0, 4e4, 40),
          [](const ParameterMap& v, double p) {
            return cylinder_row(closed_cylinder({sheet_of(v, false), get(v, "radius")}, p));
          }};
}

CircularMembrane circular_of(const ParameterMap& v, double pressure) {
  return {sheet_of(v, false), get(v, "radius"), pressure};
}

Entry hencky_entry() {
  return {
      "hencky_membrane",
      "Clamped circular membrane over overpressure (Hencky)",
      "N = (E h q^(2/3)/4) sum b_2n rho^2n; B^2 (x B'' + 2 B') = -2; q = p a/(E h)",
      "H. Hencky (1915), textbook result; coefficients derived here",
      "fixed load direction, small slope: q <= 0.1 (deflection 0.1 % low at q = 1e-3, 0.4 % at 1e-2)",
      14,
      joined({sheet_parameters(false), radius_parameter(0.3, "radius a of the clamped edge")}),
      {"overpressure_Pa", "centre_deflection_m", "volume_m3", "centre_resultant_N_m", "edge_resultant_N_m"},
      range(100.0, 1000.0, 9),
      [](const ParameterMap& v, double p) {
        const HenckyMembrane h = hencky_membrane(circular_of(v, p));
        return Row{h.centre_deflection, h.volume, h.centre_resultant, h.edge_resultant};
      }};
}

Entry hencky_profile_entry() {
  return {"hencky_profile",
          "Deflection of the clamped circular membrane over radius (Hencky)",
          "w = a q^(1/3) int_x^1 dx/B(x), x = (r/a)^2",
          "H. Hencky (1915), textbook result",
          "abscissa r/a, 0 to 1; q <= 0.1",
          14,
          joined({sheet_parameters(false),
                  radius_parameter(0.3, "radius a of the clamped edge"),
                  {{"overpressure", "p", "Pa", 100.0, "overpressure"}}}),
          {"radius_over_edge", "deflection_m"},
          range(0.0, 1.0, 50),
          [](const ParameterMap& v, double rho) {
            return Row{hencky_deflection(circular_of(v, get(v, "overpressure")), rho * get(v, "radius"))};
          }};
}

Entry mylar_entry() {
  return {"mylar_balloon",
          "Inextensible balloon of two flat discs over their radius",
          "a/r = Gamma(1/4)^2/(4 sqrt(2 pi)); thickness = 2 r Gamma(3/4)^2/sqrt(2 pi); V = (2 pi/3) a r^2",
          "W. H. Paulsen (1994)",
          "no hoop stress: needs wrinkling; stiff limit",
          14,
          {},
          {"flat_radius_m", "equator_radius_m", "thickness_m", "volume_m3"},
          range(0.1, 1.0, 9),
          [](const ParameterMap&, double a) {
            const MylarBalloon m = mylar_balloon(a);
            return Row{m.equator_radius, m.thickness, m.volume};
          }};
}

Entry mylar_profile_entry() {
  return {"mylar_profile",
          "Half height of the inextensible balloon over radius",
          "z(x) = int_x^r s^2/sqrt(r^4 - s^4) ds",
          "W. H. Paulsen (1994)",
          "abscissa x/r, 0 to 1",
          14,
          {{"flat_radius", "a", "m", 1.0, "radius of the flat discs"}},
          {"radius_over_equator", "half_height_m"},
          range(0.0, 1.0, 50),
          [](const ParameterMap& v, double x) {
            const double a = get(v, "flat_radius");
            return Row{mylar_profile(a, x * mylar_balloon(a).equator_radius)};
          }};
}

}  // namespace

void add_inflated_shapes(std::vector<Entry>& list) {
  for (Entry (*entry)() : {icosahedron_entry, icosphere_entry, sphere_inflation_entry, sphere_breathing_entry,
                           sphere_decay_entry, fixed_cylinder_entry, closed_cylinder_entry, hencky_entry,
                           hencky_profile_entry, mylar_entry, mylar_profile_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
