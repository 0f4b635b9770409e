// SPDX-License-Identifier: Apache-2.0
#include "closed_form/jet.hpp"
#include "closed_form/occlusion.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

Parameters width_parameter() {
  return {{"width", "R", "m", 1.0, "width of exp(-(r/R)^2) at the target"}};
}

Entry plate_force_entry() {
  return {"plate_force",
          "Force on an unbounded plate normal to the jet, over the momentum flux",
          "F = c J",
          "momentum balance, textbook result",
          "1 <= c <= 2; J >= 0",
          15,
          {{"reflection", "c", "1", 2.0, "1 deflection into the plane, 2 complete reflection"}},
          {"momentum_flux_N", "jet_force_N"},
          {100.0, 821.46483795717026, 1600.0},
          [](const ParameterMap& v, double j) { return Row{plate_force(get(v, "reflection"), j)}; }};
}

Entry inclined_plate_entry() {
  return {
      "inclined_plate",
      "Normal force on a plate inclined to a round jet, over F = c J, over the angle",
      "cos(theta) sqrt(2/pi) int exp(-2 w^2)/(1 - s w) dw, s = R' tan(theta); cos(theta) without spreading",
      "derived here",
      "|s| extent < 1",
      14,
      {{"width_slope", "R'", "1", 0.11785113019775793, "growth dR/dz of the width"},
       {"extent", "", "1", 3.0, "half width of the plate over R"}},
      {"angle_rad", "force_fraction", "force_fraction_constant_width"},
      range(0.0, 1.1, 22),
      [](const ParameterMap& v, double theta) {
        return Row{inclined_plate_fraction(theta, get(v, "width_slope"), get(v, "extent")),
                   inclined_plate_fraction(theta)};
      }};
}

Entry disc_entry() {
  return {"disc_target",
          "Momentum fraction caught by a disc over its radius",
          "1 - exp(-2 rho^2/R^2) on the axis; 1 - Q1(2 d/R, 2 rho/R) at offset d (Marcum Q)",
          "derived here",
          "disc normal to the axis, radius > 0",
          13,
          joined({width_parameter(), {{"offset", "d", "m", 0.5, "of the disc's centre from the axis"}}}),
          {"disc_radius_m", "coaxial_fraction", "offset_fraction"},
          range(0.1, 2.0, 19),
          [](const ParameterMap& v, double radius) {
            return Row{disc_fraction(radius, get(v, "width")),
                       off_axis_disc_fraction(radius, get(v, "offset"), get(v, "width"))};
          }};
}

Entry square_entry() {
  return {"square_target",
          "Momentum fraction caught by a square over half its side",
          "erf(sqrt 2 L/R)^2",
          "derived here",
          "coaxial, normal to the axis",
          15,
          width_parameter(),
          {"half_side_m", "fraction"},
          range(0.0, 2.0, 20),
          [](const ParameterMap& v, double side) { return Row{square_fraction(side, get(v, "width"))}; }};
}

Entry half_plane_entry() {
  return {"half_plane_target",
          "Momentum fraction caught by a half plane over its edge's distance",
          "Phi(2 d/R)",
          "derived here",
          "d > 0: the axis hits the target",
          15,
          width_parameter(),
          {"edge_distance_m", "fraction"},
          range(-1.0, 1.0, 20),
          [](const ParameterMap& v, double d) { return Row{half_plane_fraction(d, get(v, "width"))}; }};
}

Entry lattice_quadrature_entry() {
  return {"lattice_quadrature",
          "Error of centre-of-element pressure on a square lattice over spacing/width",
          "(1 + e)^2 - 1, e = 2 sum (-1)^k exp(-k^2 pi^2 R^2/(2 h^2))",
          "derived here (Poisson summation)",
          "lattice corner on the axis; 0 < h/R <= 10",
          14,
          {},
          {"spacing_over_width", "relative_error"},
          {0.25, 0.5, 0.75, 1.0, 1.5},
          [](const ParameterMap&, double h) { return Row{lattice_quadrature_error(h)}; }};
}

Entry hidden_disc_entry() {
  return {"hidden_disc",
          "Part of a disc hidden behind a disc over the occluder's offset",
          "(r1 z2/(z1 r2))^2 coaxial; lens area of shadow and target over the target's",
          "derived here",
          "parallel discs, point source on the target's axis; z2 > z1 > 0",
          14,
          {{"occluder_radius", "r1", "m", 0.3, "of the occluder"},
           {"occluder_distance", "z1", "m", 1.0, "source to occluder"},
           {"target_radius", "r2", "m", 1.0, "of the target"},
           {"target_distance", "z2", "m", 2.0, "source to target"}},
          {"offset_m", "hidden_fraction", "hidden_fraction_coaxial"},
          range(0.0, 0.8, 16),
          [](const ParameterMap& v, double offset) {
            const double r1 = get(v, "occluder_radius");
            const double z1 = get(v, "occluder_distance");
            const double r2 = get(v, "target_radius");
            const double z2 = get(v, "target_distance");
            return Row{hidden_disc_fraction(r1, z1, r2, z2, offset),
                       hidden_coaxial_disc_fraction(r1, z1, r2, z2)};
          }};
}

Entry sphere_shadow_entry() {
  return {
      "sphere_shadow",
      "Opaque sphere between a source and a concentric shell, over the source's distance",
      "shadow cap asin(r/D) + asin(r/R); visible part (1 - r/D)/2; solid angle 2 pi (1 - sqrt(1 - (r/D)^2))",
      "derived here",
      "r < D < R",
      15,
      {{"sphere_radius", "r", "m", 0.5, "opaque sphere"}, {"shell_radius", "R", "m", 2.0, "shell"}},
      {"source_distance_m", "shadow_half_angle_rad", "visible_fraction", "solid_angle_sr"},
      range(0.6, 1.8, 12),
      [](const ParameterMap& v, double d) {
        const double r = get(v, "sphere_radius");
        return Row{sphere_shadow_half_angle(r, d, get(v, "shell_radius")), visible_sphere_fraction(r, d),
                   sphere_solid_angle(r, d)};
      }};
}

Entry icosahedron_faces_entry() {
  return {
      "icosahedron_faces",
      "Faces of an icosahedron seen from a vertex axis, over the distance",
      "20 inside, 5 up to 2 + sqrt 5 circumradii, 10 beyond",
      "derived here",
      "distance >= 0, not 1",
      2,
      {},
      {"distance_over_circumradius", "visible_faces"},
      {0.0, 1.01, 2.0, 4.0, 5.0, 100.0},
      [](const ParameterMap&, double d) { return Row{static_cast<double>(icosahedron_visible_faces(d))}; }};
}

}  // namespace

void add_jet_targets(std::vector<Entry>& list) {
  for (Entry (*entry)() : {plate_force_entry, inclined_plate_entry, disc_entry, square_entry,
                           half_plane_entry, lattice_quadrature_entry})
    list.push_back(entry());
}

void add_shadows(std::vector<Entry>& list) {
  for (Entry (*entry)() : {hidden_disc_entry, sphere_shadow_entry, icosahedron_faces_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
