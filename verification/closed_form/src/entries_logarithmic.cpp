// SPDX-License-Identifier: Apache-2.0
#include "closed_form/logarithmic.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

const char* const kLogarithmicLaw =
    "derived here (Cauchy stress linear in logarithmic strain, constant thickness)";
const char* const kLogarithmicValidity = "overpressure >= 0, stretches up to exp(1/2)";

Parameters logarithmic_parameters(double radius) {
  return joined({sheet_parameters(false), {{"radius", "R0", "m", radius, "unstretched radius"}}});
}

Entry logarithmic_sphere_entry() {
  return {"sphere_inflation_hencky",
          "Spherical balloon of the Hencky law over overpressure",
          "p R0 = 2 h E/(1-nu) ln(lambda)/lambda; W = E/(1-nu) (lambda^2 (ln(lambda) - 1/2) + 1/2)",
          kLogarithmicLaw,
          kLogarithmicValidity,
          14,
          logarithmic_parameters(0.3),
          {"overpressure_Pa", "stretch", "cauchy_stress_Pa", "energy_density_J_m3"},
          range(0.0, 8e4, 80),
          [](const ParameterMap& v, double p) {
            const LogarithmicBag s = logarithmic_sphere({sheet_of(v, false), get(v, "radius")}, p);
            return Row{s.hoop_stretch, s.hoop_stress, s.energy_density};
          }};
}

Row logarithmic_row(const LogarithmicBag& s) {
  return {s.hoop_stretch, s.axial_stretch, s.hoop_stress, s.axial_stress, s.energy_density};
}

std::vector<std::string> logarithmic_columns() {
  return {"overpressure_Pa",       "hoop_stretch",           "axial_stretch",
          "hoop_cauchy_stress_Pa", "axial_cauchy_stress_Pa", "energy_density_J_m3"};
}

Entry logarithmic_fixed_cylinder_entry() {
  return {"cylinder_fixed_length_hencky",
          "Cylindrical balloon of the Hencky law and of fixed length over overpressure",
          "p R0 lambda = h (K m + G m^2 + G m), m = ln(lambda)/2, K = E/(1-nu), G = E/(1+nu)",
          kLogarithmicLaw,
          kLogarithmicValidity,
          14,
          logarithmic_parameters(0.15),
          logarithmic_columns(),
          range(0.0, 6e4, 60),
          [](const ParameterMap& v, double p) {
            return logarithmic_row(logarithmic_fixed_cylinder({sheet_of(v, false), get(v, "radius")}, p));
          }};
}

Entry logarithmic_closed_cylinder_entry() {
  return {"cylinder_closed_ends_hencky",
          "Long cylindrical balloon of the Hencky law with closed ends over overpressure",
          "sigma_h = 2 sigma_z = p R0 lambda_h/h; sigma = K m + G r^2 +- G r, ln(lambda) = m +- r",
          kLogarithmicLaw,
          kLogarithmicValidity,
          14,
          logarithmic_parameters(0.15),
          logarithmic_columns(),
          range(0.0, 6e4, 60),
          [](const ParameterMap& v, double p) {
            return logarithmic_row(logarithmic_closed_cylinder({sheet_of(v, false), get(v, "radius")}, p));
          }};
}

Entry logarithmic_strip_entry() {
  return {"strip_hencky",
          "Strip of the Hencky law pulled along one axis, over its stretch",
          "sigma = E e 2/(1 + sqrt(1 - (1 - nu^2) e)), e = ln(stretch); free to wrinkle",
          kLogarithmicLaw,
          "stretch from 1 to exp(1/2)",
          14,
          {{"young_modulus", "E", "Pa", 60e6, "Young's modulus"},
           {"poisson_ratio", "nu", "1", 0.3, "Poisson's ratio"}},
          {"stretch", "transverse_stretch", "cauchy_stress_Pa", "energy_density_J_m3"},
          range(1.0, 1.5, 50),
          [](const ParameterMap& v, double stretch) {
            const LogarithmicStrip s =
                logarithmic_strip({get(v, "young_modulus"), get(v, "poisson_ratio"), 1.0, 1.0}, stretch);
            return Row{s.transverse_stretch, s.stress, s.energy_density};
          }};
}

}  // namespace

void add_logarithmic_bags(std::vector<Entry>& list) {
  for (Entry (*entry)() : {logarithmic_sphere_entry, logarithmic_fixed_cylinder_entry,
                           logarithmic_closed_cylinder_entry, logarithmic_strip_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
