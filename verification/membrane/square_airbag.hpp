// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "statics.hpp"

namespace scenes {

// Two square sheets of diagonal 1.2 m sewn together, E = 588 MPa, h = 0.6 mm, nu = 0.4, 5 kPa, one eighth by
// its symmetry planes (B. Contri, B. A. Schrefler, A geometrically nonlinear finite element analysis of
// wrinkled membrane surfaces by a no-compression material model, 1988). Height of the middle there and later
// (S. Kang, S. Im 1999; R. Jarasjarungkiat et al. 2009; Z. Zhang, J. Kiendl, arXiv:2504.03400): 0.205 to
// 0.217 m.
struct SquareAirbag {
  double height;     // of the middle over the seam [m]
  double volume;     // of the whole bag [m3]
  double potential;  // of the whole bag [J]
};

// Richardson's value of 8, 16 and 32 divisions; an independent code gives 8 x (-77.73 to -77.77) J at 64.
inline constexpr double kSquareAirbagPotential = -622.15;

inline SquareAirbag square_airbag(int divisions, mesh::Diagonals diagonals, membrane::Compression compression,
                                  double relative_tolerance) {
  const double side = 0.6 / std::numbers::sqrt2, pressure = 5e3;
  const auto mesh = mesh::rectangle(divisions, divisions, side, side, diagonals);
  auto d = describe(mesh, compression);
  for (auto& p : d.properties) p.thickness = 0.6e-3, p.young_modulus = 588e6, p.poisson = 0.4;
  const auto model = make_model(d);
  HeldComponent x_plane{0, {}}, y_plane{1, {}}, seam{2, {}};
  Eigen::Matrix3Xd x = mesh.nodes;
  for (int n = 0; n < mesh.node_count(); ++n) {
    const int i = n % (divisions + 1), j = n / (divisions + 1);
    if (i == 0) x_plane.nodes.push_back(n);
    if (j == 0) y_plane.nodes.push_back(n);
    if (i == divisions || j == divisions) seam.nodes.push_back(n);
    const double quarter_wave = 0.5 * std::numbers::pi / divisions;
    x(2, n) = seam.nodes.empty() || seam.nodes.back() != n
                  ? 0.05 * std::cos(quarter_wave * i) * std::cos(quarter_wave * j)
                  : 0.0;
  }
  auto state = membrane::make_state(model, x);
  const double tolerance = relative_tolerance * pressure * side * side / (divisions * divisions);
  const Rest rest = relax(model, state, pressure, tolerance, sliding({x_plane, y_plane, seam}));
  return {state.position.map()(2, 0), 8.0 * rest.volume, 8.0 * rest.potential};
}

}  // namespace scenes
