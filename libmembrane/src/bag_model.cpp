// SPDX-License-Identifier: Apache-2.0
#include "membrane/bag_model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <string>

#include "blocks.hpp"
#include "checks.hpp"
#include "kernel_table.hpp"
#include "law_functions.hpp"
#include "membrane/law_table.hpp"
#include "stages_mass_shares.hpp"

namespace membrane {

namespace {

// Reference triangle in its own frame: a at the origin, b on the first axis.
struct ReferenceTriangle {
  double area;                           // [m2]
  Eigen::Matrix<double, 2, 3> gradient;  // corner functions' gradients [1/m]
  Eigen::Matrix<double, 3, 2> axes;      // unit vectors of the frame
};

ReferenceTriangle reference_triangle(const BagDescription& d, Eigen::Index e) {
  const Eigen::Vector3d a = d.reference.col(d.elements(0, e));
  const Eigen::Vector3d ab = d.reference.col(d.elements(1, e)) - a;
  const Eigen::Vector3d ac = d.reference.col(d.elements(2, e)) - a;
  const double length = ab.norm();
  const double twice_area = ab.cross(ac).norm();
  if (!has_area(ab, ac))
    reject("element " + std::to_string(e), "reference area", 0.5 * twice_area,
           "more than rounding of its corners, 1e-14 of a side squared");
  ReferenceTriangle t{0.5 * twice_area, {}, {}};
  t.axes << ab / length, ab.cross(ac).cross(ab) / (twice_area * length);
  const double c1 = ab.dot(ac) / length, c2 = twice_area / length;
  t.gradient.col(1) << 1.0 / length, -c1 / (length * c2);
  t.gradient.col(2) << 0.0, 1.0 / c2;
  t.gradient.col(0) = -(t.gradient.col(1) + t.gradient.col(2));
  return t;
}

// Warp in the element's frame, (cos, sin) of its angle; the first axis for an element without weave.
Eigen::Vector2d warp_direction(const ReferenceTriangle& t, const ElementProperties& p, Eigen::Index e) {
  if (!p.weave) return Eigen::Vector2d::UnitX();
  const Eigen::Vector2d in_plane = t.axes.transpose() * p.weave->warp.normalized();
  // Closer to the normal than this, the direction is only rounding of the element's corners.
  constexpr double least = 1e-6;
  if (!(in_plane.norm() > least))
    reject("element " + std::to_string(e), "part of the warp in the element's plane", in_plane.norm(),
           "more than 1e-6 of it");
  return in_plane.normalized();
}

YarnCurve yarn_curve(const StressCurve& curve) {
  YarnCurve ramps{};
  double before = 0.0;
  for (std::size_t i = 1; i < curve.strain.size(); ++i) {
    const double slope = (curve.stress[i] - curve.stress[i - 1]) / (curve.strain[i] - curve.strain[i - 1]);
    ramps.strain[ramps.count] = curve.strain[i - 1];
    ramps.rise[ramps.count++] = slope - before;
    ramps.steepest = std::max(ramps.steepest, slope);
    before = slope;
  }
  ramps.end = curve.strain.back();
  return ramps;
}

Weave moduli_of(const ElementProperties& p) {
  if (p.weave) return {p.young_modulus, p.weave->young_modulus_weft, p.poisson, p.weave->shear};
  return {p.young_modulus, p.young_modulus, p.poisson, 0.5 * p.young_modulus / (1.0 + p.poisson)};
}

// Plane-stress stiffness in the frame rotated back from the warp by `angle` (cos, sin), for engineering
// shear.
Eigen::Matrix3d elasticity(const Weave& w, const Eigen::Vector2d& angle) {
  const double reciprocal = 1.0 - w.poisson * w.poisson * (w.young_modulus_weft / w.young_modulus_warp);
  Eigen::Matrix3d d, turn;
  const double c12 = w.poisson * w.young_modulus_weft;
  d << w.young_modulus_warp, c12, 0.0, c12, w.young_modulus_weft, 0.0, 0.0, 0.0, w.shear * reciprocal;
  const double c = angle[0], s = angle[1];
  turn << c * c, s * s, c * s, s * s, c * c, -c * s, -2.0 * c * s, 2.0 * c * s, c * c - s * s;
  return turn.transpose() * d * turn / reciprocal;
}

void set_fabric(BagModel& m, Eigen::Index e, const ReferenceTriangle& t, const ElementProperties& p) {
  const auto i = static_cast<std::size_t>(e);
  const auto [group, lane] = place_of(m.elements, i);
  FabricGroup& f = m.elements.fabric[group];
  const Eigen::Vector2d warp = warp_direction(t, p, e);
  const LawInput fabric{moduli_of(p), warp[0] * warp[0] - warp[1] * warp[1], 2.0 * warp[0] * warp[1],
                        &m.yarns, p.law_constants.data()};
  const LawFunctions& law = law_functions(m.law);
  law.write(fabric, f, lane);
  const Eigen::Matrix3d stiffness = elasticity(law.stiffness(fabric), warp);
  m.stiffness[i] = {p.thickness * t.area, t.gradient, stiffness.llt().matrixL()};
  m.elements.group[group].volume[lane] = p.thickness * t.area;
  f.porosity[lane] = p.porosity;
  f.porosity_squared[lane] = p.porosity * p.porosity;
}

void set_element(BagModel& m, Eigen::Index e) {
  const auto i = static_cast<std::size_t>(e);
  const ReferenceTriangle t = reference_triangle(m.description, e);
  const ElementProperties& p = m.description.properties[i];
  const auto [group, lane] = place_of(m.elements, i);
  ElementGroup& g = m.elements.group[group];
  g.gradient_b1[lane] = t.gradient(0, 1);
  g.gradient_b2[lane] = t.gradient(1, 1);
  g.gradient_c2[lane] = t.gradient(1, 2);
  m.reference_area[i] = t.area;
  if (p.null_panel) return;
  set_fabric(m, e, t, p);
  m.gradient_squared[i] = t.gradient.squaredNorm();
  const double mass = p.density * p.thickness * t.area;
  m.shares.mass.col(e).setConstant(mass / 3.0);
  for (const int n : m.description.elements.col(e)) {
    m.node_mass[static_cast<std::size_t>(n)] += mass / 3.0;
    m.node_area[static_cast<std::size_t>(n)] += t.area / 3.0;
    double& steepest = m.node_gradient_squared[static_cast<std::size_t>(n)];
    steepest = std::max(steepest, 3.0 * m.gradient_squared[i]);
  }
}

// Sets the law, and fabrics without stress for elements without effect.
void set_law(BagModel& m) {
  const BagDescription& d = m.description;
  const bool woven = std::any_of(d.properties.begin(), d.properties.end(),
                                 [](const ElementProperties& p) { return !p.null_panel && p.weave; });
  // A bag of null panels only needs no law for isotropic fabric.
  m.law = find_law(d.law, woven).value_or(0);
  if (law_named(d.law).curves) m.yarns = {yarn_curve(d.curves[0]), yarn_curve(d.curves[1])};
  FabricGroup none{};
  for (std::size_t lane = 0; lane < kLanes; ++lane) law_functions(m.law).write_none(none, lane);
  m.elements.fabric.assign(m.elements.group.size(), none);
}

// Stores each distinct fabric once, in the order of the groups.
void share_fabrics(BlockTable& table) {
  const auto before = [](const FabricGroup& a, const FabricGroup& b) {
    return std::memcmp(&a, &b, sizeof a) < 0;
  };
  std::map<FabricGroup, std::int32_t, decltype(before)> places(before);
  AlignedVector<FabricGroup> distinct;
  for (std::size_t g = 0; g < table.group.size(); ++g) {
    const auto [found, is_new] = places.emplace(table.fabric[g], static_cast<std::int32_t>(distinct.size()));
    if (is_new) distinct.push_back(table.fabric[g]);
    table.group[g].fabric = found->second;
  }
  table.fabric = distinct;
}

void set_masses(BagModel& m) {
  for (std::size_t n = 0; n < m.node_mass.size(); ++n) {
    if (m.corners.row_begin[n] == m.corners.row_begin[n + 1])
      reject("node " + std::to_string(n), "belongs to no element");
    if (!(m.node_mass[n] > 0.0))
      reject("node " + std::to_string(n),
             "is inside a null panel, where no fabric holds it; allowed: null panels with rim nodes only");
    m.inverse_mass.map().col(static_cast<Eigen::Index>(n)).setConstant(1.0 / m.node_mass[n]);
    m.fabric_mass += m.node_mass[n];
  }
  for (const int node : m.description.fixed_nodes) m.inverse_mass.map().col(node).setZero();
  for (int axis = 0; axis < 3; ++axis)
    for (const int node : m.description.held_nodes[static_cast<std::size_t>(axis)])
      m.inverse_mass.map()(axis, node) = 0.0;
}

// Largest row sum of |N^T M^-1 N K| over the straps: straps that share a node add up. It also covers the
// transverse (geometric) part, k (1 - L0 / L) < k.
double strap_bound(const BagModel& m) {
  std::vector<double> at_node(m.node_mass.size(), 0.0);
  const auto node = [](int n) { return static_cast<std::size_t>(n); };
  for (const Strap& s : m.description.straps)
    for (const int n : {s.node_a, s.node_b})
      at_node[node(n)] += s.stiffness * m.inverse_mass.map().col(n).maxCoeff();
  double bound = 0.0;
  for (const Strap& s : m.description.straps)
    bound = std::max(bound, at_node[node(s.node_a)] + at_node[node(s.node_b)]);
  return bound;
}

// Smallest mass per area of the fabric [kg/m2]: with it a plate takes at most its share everywhere.
double lightest(const BagModel& m) {
  double least = std::numeric_limits<double>::infinity();
  for (const ElementProperties& p : m.description.properties)
    if (!p.null_panel) least = std::min(least, p.density * p.thickness);
  return least;
}

void set_plates(BagModel& m) {
  for (Plate& plate : m.description.plates) {
    plate.normal.normalize();
    if (!plate.stiffness) plate.stiffness = kDefaultPlateShare * m.fabric_frequency * lightest(m);
  }
}

double plate_bound(const BagModel& m) {
  double stiffness = 0.0, compliance = 0.0;
  for (const Plate& plate : m.description.plates) stiffness += *plate.stiffness;
  for (std::size_t n = 0; n < m.node_mass.size(); ++n)
    compliance = std::max(compliance,
                          m.node_area[n] * m.inverse_mass.map().col(static_cast<Eigen::Index>(n)).maxCoeff());
  return stiffness * compliance;
}

}  // namespace

bool has_area(const Eigen::Vector3d& ab, const Eigen::Vector3d& ac) {
  const double twice_area = ab.cross(ac).norm();
  return std::isfinite(twice_area) && twice_area > 1e-14 * std::max(ab.squaredNorm(), ac.squaredNorm());
}

BagModel make_model(const BagDescription& description) {
  check_description(description);
  kernel_table(description.isa);  // throws for an unavailable instruction set
  BagModel m;
  m.description = description;
  m.node_count = static_cast<int>(description.reference.cols());
  m.element_count = static_cast<int>(description.elements.cols());
  const auto nodes = static_cast<std::size_t>(m.node_count);
  for (auto* values : {&m.node_mass, &m.node_area, &m.node_gradient_squared}) values->assign(nodes, 0.0);
  m.inverse_mass = Vectors(m.node_count);
  for (auto* values : {&m.reference_area, &m.gradient_squared})
    values->assign(static_cast<std::size_t>(m.element_count), 0.0);
  set_corner_table(m);
  set_blocks(m);
  set_law(m);
  m.stiffness.resize(static_cast<std::size_t>(m.element_count));
  m.shares.mass.setZero(3, m.element_count);
  for (Eigen::Index e = 0; e < m.element_count; ++e) set_element(m, e);
  share_fabrics(m.elements);
  set_masses(m);
  tune_shares_as_sewn(m);
  set_plates(m);
  m.strap_frequency = strap_bound(m);
  m.plate_frequency = plate_bound(m);
  return m;
}

}  // namespace membrane
