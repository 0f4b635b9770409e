// SPDX-License-Identifier: Apache-2.0
#include "closed_form/disc.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

const char* const kSource = "derived here (St. Venant-Kirchhoff, plane stress, reference thickness)";

Parameters disc_parameters() {
  return joined({sheet_parameters(false), {{"radius", "a", "m", 0.3, "radius of the flat disc"}}});
}

CircularMembrane disc_of(const ParameterMap& v, double pressure) {
  return {sheet_of(v, false), get(v, "radius"), pressure};
}

Entry clamped_entry() {
  return {"clamped_disc",
          "Clamped disc under pressure that follows it, over overpressure",
          "s T1 sin(phi) = -p x^2/2; d(s T1 cos(phi))/ds = T2 + p x z'",
          kSource,
          "1e-6 <= p a/(E h) <= 0.2; nu >= 0",
          11,
          disc_parameters(),
          {"overpressure_Pa", "centre_deflection_m", "volume_m3", "centre_stretch"},
          range(100.0, 1000.0, 2),
          [](const ParameterMap& v, double p) {
            const InflatedDisc d = clamped_disc(disc_of(v, p));
            return Row{d.centre_deflection, d.volume, d.centre_stretch};
          }};
}

Entry sealed_entry() {
  return {"sealed_discs",
          "Balloon of two elastic discs sewn at the edge, without compression, over overpressure",
          "as clamped_disc, T2 = 0 where it would be < 0; edge free, its tangent vertical",
          kSource,
          "1e-6 <= p a/(E h) <= 0.2; nu >= 0; tends to mylar_balloon",
          9,
          disc_parameters(),
          {"overpressure_Pa", "equator_radius_m", "thickness_m", "volume_m3", "centre_stretch"},
          range(100.0, 1000.0, 2),
          [](const ParameterMap& v, double p) {
            const InflatedDisc d = sealed_disc(disc_of(v, p));
            return Row{d.edge_radius, 2.0 * d.centre_deflection, 2.0 * d.volume, d.centre_stretch};
          }};
}

Entry ring_entry() {
  return {
      "twisted_ring",
      "Wrinkled ring, inner edge turned against the outer, over the angle",
      "stress A/sqrt(r^2 - c^2) on rays; A = E c angle/L; L = ln((b^2-c^2)/(a^2-c^2))/2; c: greatest c^2/L",
      "E. Reissner, On tension field theory (1938); c derived here",
      "small angle; wrinkled up to the outer edge, c^2/(b^2 - c^2) >= nu",
      14,
      joined(
          {sheet_parameters(false),
           {{"inner_radius", "a", "m", 0.1, "turned edge"}, {"outer_radius", "b", "m", 0.15, "fixed edge"}}}),
      {"angle_rad", "torque_Nm", "strain_energy_J", "ray_radius_m", "wrinkle_margin"},
      range(0.0, 0.01, 10),
      [](const ParameterMap& v, double angle) {
        const RingTwist t =
            twisted_ring({sheet_of(v, false), get(v, "inner_radius"), get(v, "outer_radius")}, angle);
        return Row{t.torque, t.strain_energy, t.ray_radius, t.margin};
      }};
}

}  // namespace

void add_discs(std::vector<Entry>& list) {
  for (Entry (*entry)() : {clamped_entry, sealed_entry, ring_entry}) list.push_back(entry());
}

}  // namespace closed_form::entries
