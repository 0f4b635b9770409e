// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "closed_form/weave.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

Parameters weave_parameters() {
  return {{"warp_modulus", "E1", "Pa", 60e6, "Young's modulus along the warp"},
          {"weft_modulus", "E2", "Pa", 45e6, "Young's modulus along the weft"},
          {"poisson_ratio", "nu12", "1", 0.3, "contraction of the weft in tension along the warp"},
          {"shear_modulus", "G", "Pa", 2e6, "shear modulus"}};
}

WovenSheet weave_of(const ParameterMap& v) {
  return {get(v, "warp_modulus"), get(v, "weft_modulus"), get(v, "poisson_ratio"), get(v, "shear_modulus")};
}

Entry off_axis_entry() {
  return {"off_axis_modulus",
          "Young's modulus of a woven strip over the angle of its cut to the warp",
          "1/E = c^4/E1 + s^4/E2 + (1/G - 2 nu12/E1) c^2 s^2",
          "textbook result (Jones, Mechanics of Composite Materials)",
          "nu12^2 < E1/E2",
          15,
          weave_parameters(),
          {"angle_deg", "modulus_Pa"},
          range(0.0, 90.0, 6),
          [](const ParameterMap& v, double angle) {
            return Row{off_axis_modulus(weave_of(v), angle * std::numbers::pi / 180.0)};
          }};
}

Entry tension_field_entry() {
  return {"woven_tension_field",
          "Stress and energy of a woven sheet that carries no compression",
          "S = C E if that has no compression, else W = max over angles of E(a) <t E t>^2/2, S = E(a) <t E "
          "t> t t",
          "relaxed energy of Pipkin 1986; dual form derived here",
          "nu12^2 < E1/E2; the default strain is wrinkled",
          13,
          joined({weave_parameters(),
                  {{"e11", "", "1", 0.02, "Green-Lagrange strain along the warp"},
                   {"e22", "", "1", -0.03, "along the weft"},
                   {"e12", "", "1", 0.02, "shear, tensor component"}}}),
          {"s11_Pa", "s22_Pa", "s12_Pa", "energy_density_J_m3"},
          {},
          [](const ParameterMap& v, double) {
            const WovenState s =
                woven_tension_field(weave_of(v), get(v, "e11"), get(v, "e22"), get(v, "e12"));
            return Row{s.s11, s.s22, s.s12, s.energy_density};
          }};
}

Entry two_slopes_entry() {
  return {
      "cylinder_two_slopes",
      "Cylinder of fixed length, its hoop of threads by a curve of two straight pieces, over overpressure",
      "h P(lambda - 1) = p R lambda; P = E1 e up to the knee e_k, then E1 e_k + E2 (e - e_k)",
      "derived here (nominal stress, thickness as sewn)",
      "strain up to 1",
      15,
      {{"first_modulus", "E1", "Pa", 20e6, "slope up to the knee"},
       {"second_modulus", "E2", "Pa", 60e6, "slope past it"},
       {"knee_strain", "e_k", "1", 0.05, "strain of the knee"},
       {"thickness", "h", "m", 0.5e-3, "thickness"},
       {"radius", "R", "m", 0.15, "radius as sewn"}},
      {"overpressure_Pa", "hoop_stretch"},
      range(0.0, 20e3, 40),
      [](const ParameterMap& v, double p) {
        const double knee = get(v, "knee_strain"), middle = get(v, "first_modulus") * knee;
        const StripCurve curve{{0.0, knee, 1.0},
                               {0.0, middle, middle + get(v, "second_modulus") * (1.0 - knee)}};
        return Row{cylinder_by_curve(curve, get(v, "thickness"), get(v, "radius"), p)};
      }};
}

}  // namespace

void add_weave(std::vector<Entry>& list) {
  list.insert(list.end(), {off_axis_entry(), tension_field_entry(), two_slopes_entry()});
}

}  // namespace closed_form::entries
