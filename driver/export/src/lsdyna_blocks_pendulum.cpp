// SPDX-License-Identifier: Apache-2.0
// Pendulum, joint and contact of an LS-DYNA deck.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numeric>

#include "lsdyna_blocks.hpp"

namespace driver {
namespace {

/// Writes the pendulum, one method a block.
class LsDynaPendulum {
 public:
  LsDynaPendulum(const Deck& deck, LsDynaCards& out) : deck_(deck), u_(out.units()), ids_(deck), out_(out) {}
  void write();

 private:
  void body(const Eigen::Vector3d& cg, double rate);
  void rigid_material(int id, bool held);
  void contact();

  const Deck& deck_;
  const Units& u_;
  DeckIds ids_;
  LsDynaCards& out_;
};

void LsDynaPendulum::rigid_material(int id, bool held) {
  // Density and modulus only affect contact and time step; the part gives the pendulum's mass.
  constexpr double density = 1000.0, modulus = 1e9, poisson = 0.3;  // [kg/m3], [Pa], [-]
  constexpr int all_directions = 7;
  out_.keyword("MAT_RIGID");
  out_.row({{"MID", whole(id, 10)},
            {"RO", narrow(density / u_.density())},
            {"E", narrow(modulus / u_.pressure())},
            {"PR", narrow(poisson)}});
  out_.row({{"CMO", narrow(held ? 1.0 : 0.0)},
            {"CON1", whole(held ? all_directions : 0, 10)},
            {"CON2", whole(held ? all_directions : 0, 10)}});
  out_.row({{"LCO", narrow(0.0)}});
  constexpr int shell = 2;
  out_.keyword("SECTION_SHELL");
  out_.row(
      {{"SECID", whole(id, 10)}, {"ELFORM", whole(shell, 10)}, {"SHRF", narrow(1.0)}, {"NIP", whole(2, 10)}});
  const Field t = narrow(2.0 * deck_.contact_gap / u_.length);  // half of the thickness is outside the
                                                                // sphere's radius
  out_.row({{"T1", t}, {"T2", t}, {"T3", t}, {"T4", t}});
}

void LsDynaPendulum::body(const Eigen::Vector3d& cg, double rate) {
  const coupling::PendulumParameters& p = deck_.scene->pendulum->model.parameters();
  const Eigen::Vector3d x = cg / u_.length, v = rate * p.axis.cross(cg - p.pivot) / u_.velocity(),
                        w = rate * p.axis * u_.time;
  const Field J = narrow(deck_.inertia / u_.inertia()), none = narrow(0.0);
  out_.keyword("PART_INERTIA");
  out_.line("pendulum");
  out_.row({{"PID", whole(ids_.sphere_part, 10)},
            {"SECID", whole(ids_.sphere_part, 10)},
            {"MID", whole(ids_.sphere_part, 10)}});
  out_.row({{"XC", narrow(x.x())},
            {"YC", narrow(x.y())},
            {"ZC", narrow(x.z())},
            {"TM", narrow(p.mass / u_.mass)},
            {"IRCS", whole(0, 10)},
            {"NODEID", whole(0, 10)}});
  out_.row({{"IXX", J}, {"IXY", none}, {"IXZ", none}, {"IYY", J}, {"IYZ", none}, {"IZZ", J}});
  out_.row({{"VTX", narrow(v.x())},
            {"VTY", narrow(v.y())},
            {"VTZ", narrow(v.z())},
            {"VRX", narrow(w.x())},
            {"VRY", narrow(w.y())},
            {"VRZ", narrow(w.z())}});
}

void LsDynaPendulum::write() {
  const PendulumPart& part_of = *deck_.scene->pendulum;
  const coupling::PendulumParameters& p = part_of.model.parameters();
  const double angle = part_of.initial.angle;
  const Eigen::Vector3d centre = part_of.model.impactor_centre(angle);
  const Eigen::Vector3d along = p.pivot + p.impactor_distance * p.axis;
  out_.keyword("NODE");
  for (int i = 0; i < deck_.sphere.node_count(); ++i)
    out_.node(ids_.sphere_node + i, centre + deck_.sphere.nodes.col(i));
  out_.node(ids_.pivot, p.pivot);
  out_.node(ids_.along, along);
  out_.node(ids_.across, centre);
  out_.node(ids_.support, p.pivot);
  out_.node(ids_.support + 1, along);
  out_.node(ids_.support + 2, centre);
  rigid_material(ids_.sphere_part, false);
  body(part_of.model.cg_position(angle), part_of.initial.angular_velocity);
  std::vector<int> elements(static_cast<std::size_t>(deck_.sphere.element_count()));
  std::iota(elements.begin(), elements.end(), 0);
  out_.triangles(ids_.sphere_part, ids_.sphere_element, ids_.sphere_node, deck_.sphere.elements, elements);
  out_.keyword("CONSTRAINED_EXTRA_NODES_NODE");
  for (const int extra : {ids_.pivot, ids_.along, ids_.across})
    out_.card({whole(ids_.sphere_part, 10), whole(extra, 10)});
  rigid_material(ids_.joint_part, true);
  out_.part(ids_.joint_part, "support");
  out_.triangles(ids_.joint_part, ids_.joint_element, ids_.support, Eigen::Vector3i(0, 1, 2), {0});
  out_.keyword("CONSTRAINED_JOINT_REVOLUTE_ID");
  out_.line(fmt::format("{:>10}{}", 1, "pivot"));
  out_.row({{"N1", whole(ids_.pivot, 10)},
            {"N2", whole(ids_.support, 10)},
            {"N3", whole(ids_.along, 10)},
            {"N4", whole(ids_.support + 1, 10)},
            {"N5", whole(0, 10)},
            {"N6", whole(0, 10)},
            {"RPS", narrow(1.0)},
            {"DAMP", narrow(1.0)}});
  if (deck_.scene->contact) contact();
}

void LsDynaPendulum::contact() {
  constexpr int by_part = 3, by_nodes = 4;
  constexpr int by_mass_and_step = 1;  // stiffness from mass and step, as fabric is soft against a rigid body
  out_.contact({.kind = "AUTOMATIC_NODES_TO_SURFACE",
                .id = 1,
                .name = "impactor against bag",
                .first = LsDynaIds::bag_set,
                .first_kind = by_nodes,
                .second = ids_.sphere_part,
                .second_kind = by_part,
                .friction = deck_.scene->contact->parameters().friction});
  out_.row({{"SOFT", whole(by_mass_and_step, 10)}});
}

}  // namespace

void write_lsdyna_pendulum(const Deck& deck, LsDynaCards& out) {
  LsDynaPendulum(deck, out).write();
}

}  // namespace driver
