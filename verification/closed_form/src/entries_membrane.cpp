// SPDX-License-Identifier: Apache-2.0
#include "closed_form/disc.hpp"
#include "closed_form/logarithmic.hpp"
#include "closed_form/membrane.hpp"
#include "entries.hpp"
#include "fields.hpp"

namespace closed_form::entries {
namespace {

const char* const kStVK = "derived here (St. Venant-Kirchhoff, plane stress, reference thickness)";
const char* const kLogarithmicLaw =
    "derived here (Cauchy stress linear in logarithmic strain, constant thickness)";
const char* const kLogarithmicValidity = "overpressure >= 0, stretches up to exp(1/2)";

Columns<CylinderStretch> cylinder_columns() {
  return {{"hoop_stretch", &CylinderStretch::hoop_stretch},
          {"axial_stretch", &CylinderStretch::axial_stretch},
          {"hoop_stress_Pa", &CylinderStretch::hoop_stress},
          {"axial_stress_Pa", &CylinderStretch::axial_stress}};
}

Columns<LogarithmicBag> logarithmic_cylinder_columns() {
  return {{"hoop_stretch", &LogarithmicBag::hoop_stretch},
          {"axial_stretch", &LogarithmicBag::axial_stretch},
          {"hoop_cauchy_stress_Pa", &LogarithmicBag::hoop_stress},
          {"axial_cauchy_stress_Pa", &LogarithmicBag::axial_stress},
          {"energy_density_J_m3", &LogarithmicBag::energy_density}};
}

double mylar_height(double flat_radius, double x_over_equator) {
  return mylar_profile(flat_radius, x_over_equator * mylar_balloon(flat_radius).equator_radius);
}

auto flat_disc() {
  return [](Form<CircularMembrane>& form) {
    form.fields(sheet()).field(&CircularMembrane::radius, "radius", "a", "m", 0.3, "radius of the flat disc");
  };
}

}  // namespace

std::vector<Entry> polyhedra() {
  return {Form<Nothing>("icosahedron_volume", "Volume of the regular icosahedron",
                        "V = 5 (3 + sqrt 5)/12 edge^3", "textbook result", "edge > 0", 15)
              .number("edge", "a", "m", 1.0, "edge")
              .result("volume_m3", with(icosahedron_volume, "edge")),
          Form<Nothing>("icosphere", "Volume and area of a refined icosahedron against its sphere",
                        "V = (1/6) sum a.(b x c); midpoints pushed to the sphere at each level",
                        "pure geometry, computed here", "whole level, 0 to 8", 14)
              .over("level", range(0.0, 5.0, 5))
              .results(with(icosphere_ratios, abscissa), {{"faces", &IcosphereRatios::faces},
                                                          {"volume_ratio", &IcosphereRatios::volume_ratio},
                                                          {"area_ratio", &IcosphereRatios::area_ratio}})};
}

std::vector<Entry> inflated_shapes() {
  return {Form<StretchedSphere>("sphere_inflation", "Spherical balloon over overpressure",
                                "p = E h/((1-nu) R0) (lambda - 1/lambda); S = E/(1-nu) (lambda^2 - 1)/2",
                                kStVK, "overpressure >= 0", 15)
              .fields(sheet(), radius(0.3))
              .over("overpressure_Pa", range(0.0, 1e5, 100))
              .results(stretched_sphere, {{"stretch", &SphereStretch::stretch},
                                          {"stress_Pa", &SphereStretch::stress},
                                          {"volume_m3", &SphereStretch::volume},
                                          {"strain_energy_J", &SphereStretch::strain_energy}}),
          Form<StretchedSphere>("sphere_breathing", "Small breathing of an inflated sphere over overpressure",
                                "omega^2 = (2 h P'/R0^2 - 2 p lambda/R0 + 3 gamma p_abs lambda/R0)/(rho h)",
                                kStVK, "overpressure >= 0; gamma = 0 leaves out the gas", 15)
              .fields(sheet(), density(), radius(0.30598317419458695), ambient_pressure())
              .number("heat_capacity_ratio", "gamma", "1", 1.4, "of the gas; 0 for none")
              .over("overpressure_Pa", range(0.0, 1e5, 50))
              .result("angular_frequency_rad_s", with(sphere_breathing_frequency, itself, abscissa,
                                                      "ambient_pressure", "heat_capacity_ratio")),
          Form<StretchedSphere>(
              "sphere_breathing_decay",
              "Rate at which that breathing decays with stiffness-proportional damping, over overpressure",
              "beta E lambda^2/((1-nu) rho R0^2); lambda of sphere_inflation", kStVK,
              "overpressure >= 0, constant; below critical damping", 15)
              .fields(sheet(), density(), radius(0.3))
              .number("stiffness_damping", "beta", "s", 1e-4, "stress beta dS/dt")
              .over("overpressure_Pa", range(0.0, 1e5, 50))
              .result("decay_rate_1_s", with(sphere_breathing_decay, itself, abscissa, "stiffness_damping")),
          Form<StretchedCylinder>(
              "cylinder_fixed_length", "Cylindrical balloon of fixed length over overpressure",
              "lambda = sqrt(1 + 2 (1-nu^2) p R/(E h)); S_z = nu S", kStVK, "overpressure >= 0", 15)
              .fields(sheet(), radius(0.15))
              .over("overpressure_Pa", range(0.0, 1e5, 50))
              .results(fixed_length_cylinder, cylinder_columns()),
          Form<StretchedCylinder>(
              "cylinder_closed_ends", "Long cylindrical balloon with closed ends over overpressure",
              "S_h = p R lambda_z/h; lambda_z S_z = p R lambda_h^2/(2 h)", kStVK, "moderate stretch", 13)
              .fields(sheet(), radius(0.15))
              .over("overpressure_Pa", range(0.0, 4e4, 40))
              .results(closed_cylinder, cylinder_columns())};
}

std::vector<Entry> flat_membranes() {
  return {
      Form<CircularMembrane>(
          "hencky_membrane", "Clamped circular membrane over overpressure (Hencky)",
          "N = (E h q^(2/3)/4) sum b_2n rho^2n; B^2 (x B'' + 2 B') = -2; q = p a/(E h)",
          "H. Hencky (1915), textbook result; coefficients derived here",
          "fixed load direction, small slope: q <= 0.1 (deflection 0.1 % low at q = 1e-3, 0.4 % at 1e-2)", 14)
          .fields(sheet(), radius(0.3, "radius a of the clamped edge"))
          .over("overpressure_Pa", range(100.0, 1000.0, 9), &CircularMembrane::overpressure)
          .results(hencky_membrane, {{"centre_deflection_m", &HenckyMembrane::centre_deflection},
                                     {"volume_m3", &HenckyMembrane::volume},
                                     {"centre_resultant_N_m", &HenckyMembrane::centre_resultant},
                                     {"edge_resultant_N_m", &HenckyMembrane::edge_resultant}}),
      Form<CircularMembrane>("hencky_profile",
                             "Deflection of the clamped circular membrane over radius (Hencky)",
                             "w = a q^(1/3) int_x^1 dx/B(x), x = (r/a)^2",
                             "H. Hencky (1915), textbook result", "abscissa r/a, 0 to 1; q <= 0.1", 14)
          .fields(sheet(), radius(0.3, "radius a of the clamped edge"))
          .field(&CircularMembrane::overpressure, "overpressure", "p", "Pa", 100.0, "overpressure")
          .over("radius_over_edge", range(0.0, 1.0, 50))
          .result("deflection_m",
                  [](const CircularMembrane& m, double rho) { return hencky_deflection(m, rho * m.radius); }),
      Form<Nothing>(
          "mylar_balloon", "Inextensible balloon of two flat discs over their radius",
          "a/r = Gamma(1/4)^2/(4 sqrt(2 pi)); thickness = 2 r Gamma(3/4)^2/sqrt(2 pi); V = (2 pi/3) a r^2",
          "W. H. Paulsen (1994)", "no hoop stress: needs wrinkling; stiff limit", 14)
          .over("flat_radius_m", range(0.1, 1.0, 9))
          .results(mylar_balloon, {{"equator_radius_m", &MylarBalloon::equator_radius},
                                   {"thickness_m", &MylarBalloon::thickness},
                                   {"volume_m3", &MylarBalloon::volume}}),
      Form<Nothing>("mylar_profile", "Half height of the inextensible balloon over radius",
                    "z(x) = int_x^r s^2/sqrt(r^4 - s^4) ds", "W. H. Paulsen (1994)", "abscissa x/r, 0 to 1",
                    14)
          .number("flat_radius", "a", "m", 1.0, "radius of the flat discs")
          .over("radius_over_equator", range(0.0, 1.0, 50))
          .result("half_height_m", with(mylar_height, "flat_radius", abscissa))};
}

std::vector<Entry> logarithmic_bags() {
  return {Form<StretchedSphere>(
              "sphere_inflation_hencky", "Spherical balloon of the Hencky law over overpressure",
              "p R0 = 2 h E/(1-nu) ln(lambda)/lambda; W = E/(1-nu) (lambda^2 (ln(lambda) - 1/2) + 1/2)",
              kLogarithmicLaw, kLogarithmicValidity, 13)
              .fields(sheet(), radius(0.3))
              .over("overpressure_Pa", range(0.0, 8e4, 80))
              .results(logarithmic_sphere, {{"stretch", &LogarithmicBag::hoop_stretch},
                                            {"cauchy_stress_Pa", &LogarithmicBag::hoop_stress},
                                            {"energy_density_J_m3", &LogarithmicBag::energy_density}}),
          Form<StretchedCylinder>(
              "cylinder_fixed_length_hencky",
              "Cylindrical balloon of the Hencky law and of fixed length over overpressure",
              "p R0 lambda = h (K m + G m^2 + G m), m = ln(lambda)/2, K = E/(1-nu), G = E/(1+nu)",
              kLogarithmicLaw, kLogarithmicValidity, 13)
              .fields(sheet(), radius(0.15))
              .over("overpressure_Pa", range(0.0, 6e4, 60))
              .results(logarithmic_fixed_cylinder, logarithmic_cylinder_columns()),
          Form<StretchedCylinder>(
              "cylinder_closed_ends_hencky",
              "Long cylindrical balloon of the Hencky law with closed ends over overpressure",
              "sigma_h = 2 sigma_z = p R0 lambda_h/h; sigma = K m + G r^2 +- G r, ln(lambda) = m +- r",
              kLogarithmicLaw, kLogarithmicValidity, 13)
              .fields(sheet(), radius(0.15))
              .over("overpressure_Pa", range(0.0, 6e4, 60))
              .results(logarithmic_closed_cylinder, logarithmic_cylinder_columns()),
          Form<Sheet>("strip_hencky", "Strip of the Hencky law pulled along one axis, over its stretch",
                      "sigma = E e 2/(1 + sqrt(1 - (1 - nu^2) e)), e = ln(stretch); free to wrinkle",
                      kLogarithmicLaw, "stretch from 1 to exp(1/2)", 14)
              .fields(sheet())
              .fixed("thickness", 1.0)
              .over("stretch", range(1.0, 1.5, 50))
              .results(logarithmic_strip, {{"transverse_stretch", &LogarithmicStrip::transverse_stretch},
                                           {"cauchy_stress_Pa", &LogarithmicStrip::stress},
                                           {"energy_density_J_m3", &LogarithmicStrip::energy_density}})};
}

std::vector<Entry> discs() {
  return {
      Form<CircularMembrane>("clamped_disc", "Clamped disc under pressure that follows it, over overpressure",
                             "s T1 sin(phi) = -p x^2/2; d(s T1 cos(phi))/ds = T2 + p x z'", kStVK,
                             "1e-6 <= p a/(E h) <= 0.2; nu >= 0", 11)
          .fields(flat_disc())
          .over("overpressure_Pa", range(100.0, 1000.0, 2), &CircularMembrane::overpressure)
          .results(clamped_disc, {{"centre_deflection_m", &InflatedDisc::centre_deflection},
                                  {"volume_m3", &InflatedDisc::volume},
                                  {"centre_stretch", &InflatedDisc::centre_stretch}}),
      Form<CircularMembrane>(
          "sealed_discs",
          "Balloon of two elastic discs sewn at the edge, without compression, over overpressure",
          "as clamped_disc, T2 = 0 where it would be < 0; edge free, its tangent vertical", kStVK,
          "1e-6 <= p a/(E h) <= 0.2; nu >= 0; tends to mylar_balloon", 9)
          .fields(flat_disc())
          .over("overpressure_Pa", range(100.0, 1000.0, 2), &CircularMembrane::overpressure)
          .results(sealed_disc,
                   {{"equator_radius_m", &InflatedDisc::edge_radius},
                    {"thickness_m", [](const InflatedDisc& disc) { return 2.0 * disc.centre_deflection; }},
                    {"volume_m3", [](const InflatedDisc& disc) { return 2.0 * disc.volume; }},
                    {"centre_stretch", &InflatedDisc::centre_stretch}}),
      Form<TwistedRing>("twisted_ring", "Wrinkled ring, inner edge turned against the outer, over the angle",
                        "stress A/sqrt(r^2 - c^2) on rays; A = E c angle/L; L = ln((b^2-c^2)/(a^2-c^2))/2; "
                        "c: greatest c^2/L",
                        "E. Reissner, On tension field theory (1938); c derived here",
                        "small angle; wrinkled up to the outer edge, c^2/(b^2 - c^2) >= nu", 14)
          .fields(sheet())
          .field(&TwistedRing::inner_radius, "inner_radius", "a", "m", 0.1, "turned edge")
          .field(&TwistedRing::outer_radius, "outer_radius", "b", "m", 0.15, "fixed edge")
          .over("angle_rad", range(0.0, 0.01, 10))
          .results(twisted_ring, {{"torque_Nm", &RingTwist::torque},
                                  {"strain_energy_J", &RingTwist::strain_energy},
                                  {"ray_radius_m", &RingTwist::ray_radius},
                                  {"wrinkle_margin", &RingTwist::margin}})};
}

}  // namespace closed_form::entries
