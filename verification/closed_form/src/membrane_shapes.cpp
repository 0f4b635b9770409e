// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "check.hpp"
#include "closed_form/membrane.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;
using Vector = std::array<double, 3>;
using Face = std::array<std::size_t, 3>;

struct Mesh {
  std::vector<Vector> vertices;
  std::vector<Face> faces;
};

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

// Regular icosahedron on the unit sphere: a vertex at each pole, five at each of two latitudes.
Mesh icosahedron() {
  Mesh mesh;
  const double height = 1.0 / std::sqrt(5.0);
  const double ring = 2.0 / std::sqrt(5.0);
  mesh.vertices.push_back({0.0, 0.0, 1.0});
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 5; ++i) {
      const double angle = (2 * i + row) * pi / 5.0;
      mesh.vertices.push_back({ring * std::cos(angle), ring * std::sin(angle), row == 0 ? height : -height});
    }
  mesh.vertices.push_back({0.0, 0.0, -1.0});
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t next = (i + 1) % 5;
    mesh.faces.push_back({0, 1 + i, 1 + next});
    mesh.faces.push_back({1 + i, 6 + i, 1 + next});
    mesh.faces.push_back({1 + next, 6 + i, 6 + next});
    mesh.faces.push_back({11, 6 + next, 6 + i});
  }
  return mesh;
}

Mesh refined(const Mesh& mesh) {
  Mesh fine;
  fine.vertices = mesh.vertices;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
  const auto midpoint = [&](std::size_t i, std::size_t j) {
    const auto [it, inserted] = midpoints.try_emplace(std::minmax(i, j), fine.vertices.size());
    if (inserted) {
      const Vector& a = mesh.vertices[i];
      const Vector& b = mesh.vertices[j];
      fine.vertices.push_back(unit({a[0] + b[0], a[1] + b[1], a[2] + b[2]}));
    }
    return it->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const std::size_t ab = midpoint(a, b);
    const std::size_t bc = midpoint(b, c);
    const std::size_t ca = midpoint(c, a);
    for (const Face& face : {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}})
      fine.faces.push_back(face);
  }
  return fine;
}

double mylar_equator(double flat_radius) {
  const double quarter = std::tgamma(0.25);
  return check::positive("flat_radius", flat_radius) * 4.0 * std::sqrt(2.0 * pi) / (quarter * quarter);
}

}  // namespace

double icosahedron_volume(double edge) {
  check::positive("edge", edge);
  return 5.0 * (3.0 + std::sqrt(5.0)) / 12.0 * edge * edge * edge;
}

IcosphereRatios icosphere_ratios(int level) {
  check::integer_within("level", level, 0, 8);
  Mesh mesh = icosahedron();
  for (int i = 0; i < level; ++i) mesh = refined(mesh);
  double volume = 0.0;
  double area = 0.0;
  for (const auto& [ia, ib, ic] : mesh.faces) {
    const Vector& a = mesh.vertices[ia];
    const Vector& b = mesh.vertices[ib];
    const Vector& c = mesh.vertices[ic];
    volume += dot(a, cross(b, c)) / 6.0;
    const Vector normal =
        cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]});
    area += 0.5 * std::sqrt(dot(normal, normal));
  }
  return {mesh.faces.size(), volume / (4.0 / 3.0 * pi), area / (4.0 * pi)};
}

MylarBalloon mylar_balloon(double flat_radius) {
  const double r = mylar_equator(flat_radius);
  const double three_quarters = std::tgamma(0.75);
  const double b = three_quarters * three_quarters / std::sqrt(2.0 * pi);
  return {r, 2.0 * b * r, 2.0 * pi / 3.0 * flat_radius * r * r};
}

double mylar_profile(double flat_radius, double x) {
  const double r = mylar_equator(flat_radius);
  check::within("x", x, 0.0, r);
  // s = r cos(t) removes the singularity at the equator.
  const auto integrand = [](double t) {
    const double c2 = std::cos(t) * std::cos(t);
    return c2 / std::sqrt(1.0 + c2);
  };
  return r * quadrature::integrate(integrand, 0.0, std::acos(x / r), 4);
}

}  // namespace closed_form
