// SPDX-License-Identifier: Apache-2.0
// An independent answer to the visibility question, in rational arithmetic: the point where the ray passes an
// element's plane is computed and located by barycentric coordinates. The symbolic eps of the definition is
// the number 2^-200 here, far below any distance between the sets that the tests' coordinates can separate.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "jet/visibility.hpp"
#include "scenes.hpp"

namespace oracle {

using Number = boost::multiprecision::cpp_rational;
using Vector = std::array<Number, 3>;

inline Vector vector(const Eigen::Vector3d& v) {
  return {Number(v[0]), Number(v[1]), Number(v[2])};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Number dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector along(const Vector& a, const Number& t, const Vector& d) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}

struct Element {
  Vector a, b, c, normal;
  explicit Element(const scenes::Mesh& mesh, std::size_t e)
      : a(vector(mesh.corner(e, 0))), b(vector(mesh.corner(e, 1))), c(vector(mesh.corner(e, 2))) {
    normal = cross(b - a, c - a);
  }
  bool degenerate() const { return dot(normal, normal) == 0; }
  /// A point of the plane lies on the closed triangle.
  bool holds(const Vector& p) const {
    return dot(cross(b - a, p - a), normal) >= 0 && dot(cross(c - b, p - b), normal) >= 0 &&
           dot(cross(a - c, p - c), normal) >= 0;
  }
  bool contains(const Vector& p) const { return !degenerate() && dot(normal, p - a) == 0 && holds(p); }
  /// The open segment from s to g meets the closed triangle and does not lie in its plane.
  bool blocks(const Vector& s, const Vector& g) const {
    const Number slope = dot(normal, g - s);
    if (slope == 0) return false;
    const Number t = dot(normal, a - s) / slope;
    return t > 0 && t < 1 && holds(along(s, t, g - s));
  }
};

inline Eigen::Vector3d centroid(const scenes::Mesh& mesh, std::size_t e) {
  Eigen::Vector3d g;
  for (int i = 0; i < 3; ++i)
    g[i] = ((mesh.corner(e, 0)[i] + mesh.corner(e, 1)[i]) + mesh.corner(e, 2)[i]) / 3.0;
  return g;
}

inline Eigen::Vector3d start(const jet::RaySource& from, const Eigen::Vector3d& g) {
  if (from.half_long == 0.0) return from.centre;
  const Eigen::Vector3d d = g - from.centre;
  const Eigen::Vector3d& l = from.long_direction;
  const double t = std::clamp((d[0] * l[0] + d[1] * l[1]) + d[2] * l[2], -from.half_long, from.half_long);
  return {from.centre[0] + t * l[0], from.centre[1] + t * l[1], from.centre[2] + t * l[2]};
}

/// Mask of all elements. `transparent` elements never block.
inline std::vector<std::uint8_t> lit(const scenes::Mesh& mesh, const jet::RaySource& from,
                                     const std::vector<int>& transparent = {}) {
  std::vector<Element> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) elements.emplace_back(mesh, e);
  std::vector<std::uint8_t> skip(elements.size(), 0);
  for (const int e : transparent) skip[static_cast<std::size_t>(e)] = 1;
  const Number eps = Number(1) / (Number(boost::multiprecision::cpp_int(1) << 200));
  std::vector<std::uint8_t> mask(elements.size());
  for (std::size_t target = 0; target < elements.size(); ++target) {
    const Eigen::Vector3d end = centroid(mesh, target);
    const Vector g = vector(end);
    Vector s = vector(start(from, end));
    bool on = false;
    for (const Element& e : elements) on = on || e.contains(s);
    if (on) s = along(s, eps, vector(from.axis));
    bool seen = dot(elements[target].normal, elements[target].a - s) > 0;
    for (std::size_t e = 0; e < elements.size() && seen; ++e) {
      seen = e == target || skip[e] != 0 || !elements[e].blocks(s, g);
    }
    mask[target] = seen;
  }
  return mask;
}

}  // namespace oracle
