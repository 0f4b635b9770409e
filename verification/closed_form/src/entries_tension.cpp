// SPDX-License-Identifier: Apache-2.0
#include "closed_form/membrane.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

Parameters tension_parameters() {
  return {{"tension", "N", "N/m", 1000.0, "uniform tension"},
          {"area_density", "rho_h", "kg/m2", 0.31, "mass per area"}};
}

TensionedMembrane tensioned_of(const ParameterMap& v) {
  return {get(v, "tension"), get(v, "area_density")};
}

Parameters half_waves() {
  return {{"m", "", "1", 1.0, "half waves along x"}, {"n", "", "1", 1.0, "half waves along y"}};
}

Entry drum_entry() {
  return {"drum_frequency",
          "Frequency of the circular drum",
          "f = c j_mn/(2 pi a), c = sqrt(N/(rho h))",
          "textbook result (Rayleigh, The Theory of Sound)",
          "0 <= m <= 20; 1 <= n <= 20",
          13,
          joined({tension_parameters(),
                  {{"radius", "a", "m", 0.3, "radius"},
                   {"diameters", "m", "1", 0.0, "nodal diameters"},
                   {"order", "n", "1", 1.0, "order of the Bessel zero"}}}),
          {"frequency_Hz", "wave_speed_m_s"},
          {},
          [](const ParameterMap& v, double) {
            const TensionedMembrane membrane = tensioned_of(v);
            return Row{drum_frequency(membrane, get(v, "radius"), whole(v, "diameters"), whole(v, "order")),
                       transverse_wave_speed(membrane)};
          }};
}

Entry rectangle_entry() {
  return {"rectangle_frequency",
          "Frequency of the rectangular membrane",
          "f = (c/2) sqrt(m^2/a^2 + n^2/b^2)",
          "textbook result",
          "m, n >= 1",
          15,
          joined({tension_parameters(),
                  {{"a", "", "m", 0.6, "side along x"}, {"b", "", "m", 0.6, "side along y"}},
                  half_waves()}),
          {"frequency_Hz"},
          {},
          [](const ParameterMap& v, double) {
            return Row{
                rectangle_frequency(tensioned_of(v), get(v, "a"), get(v, "b"), whole(v, "m"), whole(v, "n"))};
          }};
}

Entry lattice_square_entry() {
  return {"lattice_square_frequency",
          "Exact discrete frequency of the square of split squares over divisions",
          "f = (c/(pi h)) sqrt(sin^2(m pi/2N) + sin^2(n pi/2N)), h = L/N",
          "derived here (5-point Laplacian)",
          "uniform diagonals, lumped mass; 1 <= m, n < N",
          15,
          joined({tension_parameters(), {{"side", "L", "m", 0.6, "side"}}, half_waves()}),
          {"divisions", "frequency_Hz"},
          {8.0, 16.0, 32.0, 64.0},
          [](const ParameterMap& v, double divisions) {
            return Row{lattice_square_frequency(tensioned_of(v), get(v, "side"),
                                                whole_abscissa("divisions", divisions), whole(v, "m"),
                                                whole(v, "n"))};
          }};
}

Entry square_deflection_entry() {
  return {"square_deflection",
          "Tensioned square membrane under uniform pressure, continuum and lattice",
          "n lap(w) = -p; w_c = C p a^2/n; V = C_V p a^4/n",
          "Fourier series, textbook result; lattice derived here",
          "small slope; even number of divisions, up to 4096",
          14,
          {},
          {"divisions", "lattice_centre_coefficient", "lattice_volume_coefficient", "centre_coefficient",
           "volume_coefficient"},
          {8.0, 16.0, 32.0, 64.0},
          [](const ParameterMap&, double divisions) {
            const SquareDeflection lattice =
                lattice_square_deflection(whole_abscissa("divisions", divisions));
            const SquareDeflection exact = square_deflection();
            return Row{lattice.centre_coefficient, lattice.volume_coefficient, exact.centre_coefficient,
                       exact.volume_coefficient};
          }};
}

Entry circle_deflection_entry() {
  return {"circle_deflection",
          "Tensioned circular membrane under uniform pressure",
          "w_c = p a^2/(4 n)",
          "textbook result",
          "small slope",
          15,
          {{"tension", "n", "N/m", 1000.0, "uniform tension"}, {"radius", "a", "m", 0.3, "radius"}},
          {"overpressure_Pa", "centre_deflection_m"},
          range(0.0, 100.0, 10),
          [](const ParameterMap& v, double p) {
            return Row{circle_deflection(get(v, "tension"), get(v, "radius"), p)};
          }};
}

Entry wave_speeds_entry() {
  return {"wave_speeds",
          "Waves in a thin elastic sheet",
          "plane sqrt(E/(rho (1-nu^2))); bar sqrt(E/rho); shear sqrt(G/rho)",
          "textbook result",
          "small strain",
          15,
          {{"young_modulus", "E", "Pa", 60e6, "Young's modulus"},
           {"poisson_ratio", "nu", "1", 0.3, "Poisson's ratio"},
           {"density", "rho", "kg/m3", 620.0, "density"}},
          {"plane_m_s", "bar_m_s", "shear_m_s"},
          {},
          [](const ParameterMap& v, double) {
            const WaveSpeeds w =
                wave_speeds({get(v, "young_modulus"), get(v, "poisson_ratio"), 1.0, get(v, "density")});
            return Row{w.plane, w.bar, w.shear};
          }};
}

Entry stretched_waves_entry() {
  return {"stretched_wave_speeds",
          "Small waves on a sheet stretched in one direction, over the stretch",
          "longitudinal sqrt(E/(rho (1-nu^2)) (3 lambda^2 - 1)/2); transverse sqrt(S/rho)",
          "derived here (St. Venant-Kirchhoff)",
          "referential speeds; stretch >= 1, 1 across",
          15,
          {{"young_modulus", "E", "Pa", 60e6, "Young's modulus"},
           {"poisson_ratio", "nu", "1", 0.3, "Poisson's ratio"},
           {"density", "rho", "kg/m3", 620.0, "density"}},
          {"stretch", "longitudinal_m_s", "transverse_m_s"},
          range(1.0, 1.3, 30),
          [](const ParameterMap& v, double s) {
            const StretchedWaveSpeeds w = stretched_wave_speeds(
                {get(v, "young_modulus"), get(v, "poisson_ratio"), 1.0, get(v, "density")}, s);
            return Row{w.longitudinal, w.transverse};
          }};
}

Entry uniaxial_entry() {
  return {
      "uniaxial_tension",
      "Uniaxial tension of a sheet over the stretch",
      "S = E (lambda^2 - 1)/2; lambda_t = sqrt(1 - nu (lambda^2 - 1)); P = lambda S",
      "derived here (St. Venant-Kirchhoff)",
      "nu (lambda^2 - 1) < 1",
      15,
      {{"young_modulus", "E", "Pa", 60e6, "Young's modulus"},
       {"poisson_ratio", "nu", "1", 0.3, "Poisson's ratio"}},
      {"stretch", "stress_Pa", "transverse_stretch", "nominal_stress_Pa"},
      range(1.0, 1.5, 50),
      [](const ParameterMap& v, double s) {
        const UniaxialState u = uniaxial_tension({get(v, "young_modulus"), get(v, "poisson_ratio"), 1.0}, s);
        return Row{u.stress, u.transverse_stretch, u.nominal_stress};
      }};
}

Entry simple_shear_entry() {
  return {"simple_shear",
          "Simple shear of a sheet over the shear",
          "E12 = g/2; E22 = g^2/2; S = plane stress of E",
          "derived here (St. Venant-Kirchhoff)",
          "any shear",
          15,
          {{"young_modulus", "E", "Pa", 60e6, "Young's modulus"},
           {"poisson_ratio", "nu", "1", 0.3, "Poisson's ratio"}},
          {"shear", "s11_Pa", "s22_Pa", "s12_Pa"},
          range(0.0, 0.5, 50),
          [](const ParameterMap& v, double g) {
            const PlaneStress s = simple_shear({get(v, "young_modulus"), get(v, "poisson_ratio"), 1.0}, g);
            return Row{s.s11, s.s22, s.s12};
          }};
}

Entry membrane_rebound_entry() {
  return {"membrane_rebound",
          "Sphere that rebounds from a tensioned circular membrane, over its speed",
          "M v^2/2 = pi N a^4 (ln(R/a) + 1/4)/r^2; depth a^2 (1 + 2 ln(R/a))/(2 r)",
          "derived here",
          "membrane without mass, small slope a/r",
          9,
          {{"tension", "N", "N/m", 2e3, "tension"},
           {"membrane_radius", "R", "m", 0.3, "radius of the clamped rim"},
           {"sphere_radius", "r", "m", 10.0, "radius of the sphere"},
           {"mass", "M", "kg", 40.0, "mass of the sphere"}},
          {"speed_m_s", "patch_radius_m", "depth_m", "contact_force_N", "duration_s"},
          range(0.005, 0.05, 9),
          [](const ParameterMap& v, double speed) {
            const MembraneRebound b =
                membrane_rebound({get(v, "tension"), get(v, "membrane_radius"), get(v, "sphere_radius")},
                                 get(v, "mass"), speed);
            return Row{b.patch_radius, b.turn.depth, b.turn.force, b.duration};
          }};
}

}  // namespace

void add_tension_and_waves(std::vector<Entry>& list) {
  for (Entry (*entry)() :
       {drum_entry, rectangle_entry, lattice_square_entry, square_deflection_entry, circle_deflection_entry,
        membrane_rebound_entry, wave_speeds_entry, stretched_waves_entry, uniaxial_entry, simple_shear_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
