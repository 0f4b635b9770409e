// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "closed_form/membrane.hpp"
#include "closed_form/weave.hpp"
#include "entries.hpp"
#include "fields.hpp"

namespace closed_form::entries {
namespace {

auto tensioned() {
  return [](Form<TensionedMembrane>& form) {
    form.field(&TensionedMembrane::tension, "tension", "N", "N/m", 1000.0, "uniform tension")
        .field(&TensionedMembrane::area_density, "area_density", "rho_h", "kg/m2", 0.31, "mass per area");
  };
}

auto half_waves() {
  return [](Form<TensionedMembrane>& form) {
    form.number("m", "", "1", 1.0, "half waves along x").number("n", "", "1", 1.0, "half waves along y");
  };
}

auto woven_sheet() {
  return [](Form<WovenSheet>& form) {
    form.field(&WovenSheet::warp_modulus, "warp_modulus", "E1", "Pa", 60e6, "Young's modulus along the warp")
        .field(&WovenSheet::weft_modulus, "weft_modulus", "E2", "Pa", 45e6, "Young's modulus along the weft")
        .field(&WovenSheet::poisson_ratio, "poisson_ratio", "nu12", "1", 0.3,
               "contraction of the weft in tension along the warp")
        .field(&WovenSheet::shear_modulus, "shear_modulus", "G", "Pa", 2e6, "shear modulus");
  };
}

double two_slopes(double first_modulus, double second_modulus, double knee_strain, double thickness,
                  double radius, double overpressure) {
  const double middle = first_modulus * knee_strain;
  const StripCurve curve{{0.0, knee_strain, 1.0},
                         {0.0, middle, middle + second_modulus * (1.0 - knee_strain)}};
  return cylinder_by_curve(curve, thickness, radius, overpressure);
}

}  // namespace

std::vector<Entry> vibration() {
  return {Form<TensionedMembrane>(
              "drum_frequency", "Frequency of the circular drum", "f = c j_mn/(2 pi a), c = sqrt(N/(rho h))",
              "textbook result (Rayleigh, The Theory of Sound)", "0 <= m <= 20; 1 <= n <= 20", 13)
              .fields(tensioned())
              .number("radius", "a", "m", 0.3, "radius")
              .number("diameters", "m", "1", 0.0, "nodal diameters")
              .number("order", "n", "1", 1.0, "order of the Bessel zero")
              .result("frequency_Hz", with(drum_frequency, itself, "radius", "diameters", "order"))
              .result("wave_speed_m_s", transverse_wave_speed),
          Form<TensionedMembrane>("rectangle_frequency", "Frequency of the rectangular membrane",
                                  "f = (c/2) sqrt(m^2/a^2 + n^2/b^2)", "textbook result", "m, n >= 1", 15)
              .fields(tensioned())
              .number("a", "", "m", 0.6, "side along x")
              .number("b", "", "m", 0.6, "side along y")
              .fields(half_waves())
              .result("frequency_Hz", with(rectangle_frequency, itself, "a", "b", "m", "n")),
          Form<TensionedMembrane>("lattice_square_frequency",
                                  "Exact discrete frequency of the square of split squares over divisions",
                                  "f = (c/(pi h)) sqrt(sin^2(m pi/2N) + sin^2(n pi/2N)), h = L/N",
                                  "derived here (5-point Laplacian)",
                                  "uniform diagonals, lumped mass; 1 <= m, n < N", 15)
              .fields(tensioned())
              .number("side", "L", "m", 0.6, "side")
              .fields(half_waves())
              .over("divisions", {8.0, 16.0, 32.0, 64.0})
              .result("frequency_Hz", with(lattice_square_frequency, itself, "side", abscissa, "m", "n"))};
}

std::vector<Entry> tension() {
  return {
      Form<Nothing>("square_deflection",
                    "Tensioned square membrane under uniform pressure, continuum and lattice",
                    "n lap(w) = -p; w_c = C p a^2/n; V = C_V p a^4/n",
                    "Fourier series, textbook result; lattice derived here",
                    "small slope; even number of divisions, up to 4096", 14)
          .over("divisions", {8.0, 16.0, 32.0, 64.0})
          .results(with(lattice_square_deflection, abscissa),
                   {{"lattice_centre_coefficient", &SquareDeflection::centre_coefficient},
                    {"lattice_volume_coefficient", &SquareDeflection::volume_coefficient}})
          .results(square_deflection, {{"centre_coefficient", &SquareDeflection::centre_coefficient},
                                       {"volume_coefficient", &SquareDeflection::volume_coefficient}}),
      Form<Nothing>("circle_deflection", "Tensioned circular membrane under uniform pressure",
                    "w_c = p a^2/(4 n)", "textbook result", "small slope", 15)
          .number("tension", "n", "N/m", 1000.0, "uniform tension")
          .number("radius", "a", "m", 0.3, "radius")
          .over("overpressure_Pa", range(0.0, 100.0, 10))
          .result("centre_deflection_m", with(circle_deflection, "tension", "radius", abscissa)),
      Form<PressedStrips>(
          "pressed_strips", "Two tensioned strips that pressure from outside lays on each other",
          "a = L + lambda - sqrt(lambda^2 + 2 T H/p), lambda = sqrt(T/(2 kappa)); F = 2 p (a - lambda)",
          "derived here", "small slope; a above 6 lambda", 5)
          .field(&PressedStrips::tension, "tension", "T", "N/m", 200.0, "uniform tension")
          .field(&PressedStrips::half_width, "half_width", "L", "m", 0.15, "half width between the clamps")
          .field(&PressedStrips::approach, "approach", "H", "m", 1.6e-3, "way of each strip until they touch")
          .field(&PressedStrips::stiffness, "stiffness", "kappa", "N/m3", 1e6, "stiffness of the contact")
          .over("pressure_Pa", range(80.0, 180.0, 10))
          .results(with(pressed_strips, itself, abscissa),
                   {{"contact_half_width_m", &StripPress::contact_half_width},
                    {"contact_force_N_m", &StripPress::force},
                    {"closing_m", &StripPress::closing}}),
      Form<MembraneDent>("membrane_rebound",
                         "Sphere that rebounds from a tensioned circular membrane, over its speed",
                         "M v^2/2 = pi N a^4 (ln(R/a) + 1/4)/r^2; depth a^2 (1 + 2 ln(R/a))/(2 r)",
                         "derived here", "membrane without mass, small slope a/r", 9)
          .field(&MembraneDent::tension, "tension", "N", "N/m", 2e3, "tension")
          .field(&MembraneDent::membrane_radius, "membrane_radius", "R", "m", 0.3,
                 "radius of the clamped rim")
          .field(&MembraneDent::sphere_radius, "sphere_radius", "r", "m", 10.0, "radius of the sphere")
          .number("mass", "M", "kg", 40.0, "mass of the sphere")
          .over("speed_m_s", range(0.005, 0.05, 9))
          .results(with(membrane_rebound, itself, "mass", abscissa),
                   {{"patch_radius_m", &MembraneRebound::patch_radius},
                    {"depth_m", path(&MembraneRebound::turn, &DentState::depth)},
                    {"contact_force_N", path(&MembraneRebound::turn, &DentState::force)},
                    {"duration_s", &MembraneRebound::duration}})};
}

std::vector<Entry> waves() {
  return {Form<Sheet>("wave_speeds", "Waves in a thin elastic sheet",
                      "plane sqrt(E/(rho (1-nu^2))); bar sqrt(E/rho); shear sqrt(G/rho)", "textbook result",
                      "small strain", 15)
              .fields(sheet(), density())
              .fixed("thickness", 1.0)
              .results(wave_speeds, {{"plane_m_s", &WaveSpeeds::plane},
                                     {"bar_m_s", &WaveSpeeds::bar},
                                     {"shear_m_s", &WaveSpeeds::shear}}),
          Form<Sheet>("stretched_wave_speeds",
                      "Small waves on a sheet stretched in one direction, over the stretch",
                      "longitudinal sqrt(E/(rho (1-nu^2)) (3 lambda^2 - 1)/2); transverse sqrt(S/rho)",
                      "derived here (St. Venant-Kirchhoff)", "referential speeds; stretch >= 1, 1 across", 15)
              .fields(sheet(), density())
              .fixed("thickness", 1.0)
              .over("stretch", range(1.0, 1.3, 30))
              .results(stretched_wave_speeds, {{"longitudinal_m_s", &StretchedWaveSpeeds::longitudinal},
                                               {"transverse_m_s", &StretchedWaveSpeeds::transverse}}),
          Form<Sheet>("uniaxial_tension", "Uniaxial tension of a sheet over the stretch",
                      "S = E (lambda^2 - 1)/2; lambda_t = sqrt(1 - nu (lambda^2 - 1)); P = lambda S",
                      "derived here (St. Venant-Kirchhoff)", "nu (lambda^2 - 1) < 1", 15)
              .fields(sheet())
              .fixed("thickness", 1.0)
              .over("stretch", range(1.0, 1.5, 50))
              .results(uniaxial_tension, {{"stress_Pa", &UniaxialState::stress},
                                          {"transverse_stretch", &UniaxialState::transverse_stretch},
                                          {"nominal_stress_Pa", &UniaxialState::nominal_stress}}),
          Form<Sheet>("simple_shear", "Simple shear of a sheet over the shear",
                      "E12 = g/2; E22 = g^2/2; S = plane stress of E", "derived here (St. Venant-Kirchhoff)",
                      "any shear", 15)
              .fields(sheet())
              .fixed("thickness", 1.0)
              .over("shear", range(0.0, 0.5, 50))
              .results(simple_shear, {{"s11_Pa", &PlaneStress::s11},
                                      {"s22_Pa", &PlaneStress::s22},
                                      {"s12_Pa", &PlaneStress::s12}})};
}

std::vector<Entry> weave() {
  return {
      Form<WovenSheet>("off_axis_modulus",
                       "Young's modulus of a woven strip over the angle of its cut to the warp",
                       "1/E = c^4/E1 + s^4/E2 + (1/G - 2 nu12/E1) c^2 s^2",
                       "textbook result (Jones, Mechanics of Composite Materials)", "nu12^2 < E1/E2", 15)
          .fields(woven_sheet())
          .over("angle_deg", range(0.0, 90.0, 6))
          .result("modulus_Pa",
                  [](const WovenSheet& s, double angle) {
                    return off_axis_modulus(s, angle * std::numbers::pi / 180.0);
                  }),
      Form<WovenSheet>(
          "woven_tension_field", "Stress and energy of a woven sheet that carries no compression",
          "S = C E if that has no compression, else W = max over angles of E(a) <t E t>^2/2, S = E(a) <t E "
          "t> t t",
          "relaxed energy of Pipkin 1986; dual form derived here",
          "nu12^2 < E1/E2; the default strain is wrinkled", 13)
          .fields(woven_sheet())
          .number("e11", "", "1", 0.02, "Green-Lagrange strain along the warp")
          .number("e22", "", "1", -0.03, "along the weft")
          .number("e12", "", "1", 0.02, "shear, tensor component")
          .results(with(woven_tension_field, itself, "e11", "e22", "e12"),
                   {{"s11_Pa", &WovenState::s11},
                    {"s22_Pa", &WovenState::s22},
                    {"s12_Pa", &WovenState::s12},
                    {"energy_density_J_m3", &WovenState::energy_density}}),
      Form<Nothing>("cylinder_two_slopes",
                    "Cylinder of fixed length, its hoop of threads by a curve of two straight pieces, over "
                    "overpressure",
                    "h P(lambda - 1) = p R lambda; P = E1 e up to the knee e_k, then E1 e_k + E2 (e - e_k)",
                    "derived here (nominal stress, thickness as sewn)", "strain up to 1", 15)
          .number("first_modulus", "E1", "Pa", 20e6, "slope up to the knee")
          .number("second_modulus", "E2", "Pa", 60e6, "slope past it")
          .number("knee_strain", "e_k", "1", 0.05, "strain of the knee")
          .number("thickness", "h", "m", 0.5e-3, "thickness")
          .number("radius", "R", "m", 0.15, "radius as sewn")
          .over("overpressure_Pa", range(0.0, 20e3, 40))
          .result("hoop_stretch", with(two_slopes, "first_modulus", "second_modulus", "knee_strain",
                                       "thickness", "radius", abscissa))};
}

}  // namespace closed_form::entries
