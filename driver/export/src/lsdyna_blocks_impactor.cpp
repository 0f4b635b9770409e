// SPDX-License-Identifier: Apache-2.0
// The impactor of an LS-DYNA deck, what carries it, its load and its contact.
#include <fmt/format.h>

#include <numeric>

#include "lsdyna_blocks.hpp"

namespace driver {
namespace {

/// Writes the impactor, one method a block.
class LsDynaImpactor : private LsDynaIds {
 public:
  LsDynaImpactor(const Deck& deck, LsDynaCards& out)
      : deck_(deck), impactor_(*deck.impactor), u_(out.units()), ids_(deck), out_(out) {}
  void write();

 private:
  enum class Held { no, whole, off_rail };
  void nodes();
  void rigid_material(int id, Held held);
  void body();
  void system();
  void joint();
  void springs();
  void load();
  void contact();

  const Deck& deck_;
  const DeckImpactor& impactor_;
  const Units& u_;
  DeckIds ids_;
  LsDynaCards& out_;
};

void LsDynaImpactor::write() {
  nodes();
  if (impactor_.on_rail || !impactor_.load.empty()) system();
  rigid_material(ids_.impactor_part, impactor_.on_rail ? Held::off_rail : Held::no);
  body();
  std::vector<int> elements(static_cast<std::size_t>(impactor_.surface.element_count()));
  std::iota(elements.begin(), elements.end(), 0);
  out_.triangles(ids_.impactor_part, ids_.impactor_element, ids_.impactor_node, impactor_.surface.elements,
                 elements);
  out_.keyword("CONSTRAINED_EXTRA_NODES_NODE");
  out_.card({whole(ids_.impactor_part, 10), whole(ids_.centre, 10)});
  if (deck_.scene->pendulum) joint();
  if (impactor_.on_rail) springs();
  if (!impactor_.load.empty()) load();
  if (deck_.scene->contact) contact();
}

void LsDynaImpactor::nodes() {
  out_.keyword("NODE");
  for (int i = 0; i < impactor_.surface.node_count(); ++i)
    out_.node(ids_.impactor_node + i, impactor_.surface.nodes.col(i));
  out_.node(ids_.centre, impactor_.centre);
}

void LsDynaImpactor::rigid_material(int id, Held held) {
  // Density and modulus only affect contact and time step; the part gives the impactor's mass.
  constexpr double density = 1000.0, modulus = 1e9, poisson = 0.3;  // [kg/m3], [Pa], [-]
  constexpr int all_directions = 7;
  out_.keyword("MAT_RIGID");
  out_.row({{"MID", whole(id, 10)},
            {"RO", narrow(density / u_.density())},
            {"E", narrow(modulus / u_.pressure())},
            {"PR", narrow(poisson)}});
  if (held == Held::off_rail)  // in the local system: free along its x alone
    out_.row({{"CMO", narrow(-1.0)}, {"CON1", whole(local_system, 10)}, {"CON2", word("011111", 10)}});
  else
    out_.row({{"CMO", narrow(held == Held::whole ? 1.0 : 0.0)},
              {"CON1", whole(held == Held::whole ? all_directions : 0, 10)},
              {"CON2", whole(held == Held::whole ? all_directions : 0, 10)}});
  out_.row({{"LCO", narrow(0.0)}});
  constexpr int shell = 2;
  out_.keyword("SECTION_SHELL");
  out_.row(
      {{"SECID", whole(id, 10)}, {"ELFORM", whole(shell, 10)}, {"SHRF", narrow(1.0)}, {"NIP", whole(2, 10)}});
  const Field t = narrow(2.0 * impactor_.gap / u_.length);  // half of the thickness is outside the mesh
  out_.row({{"T1", t}, {"T2", t}, {"T3", t}, {"T4", t}});
}

void LsDynaImpactor::body() {
  const Eigen::Vector3d x = impactor_.cg / u_.length, v = impactor_.velocity / u_.velocity(),
                        w = impactor_.angular_velocity * u_.time;
  const auto J = [&](int i, int j) { return narrow(impactor_.inertia(i, j) / u_.inertia()); };
  out_.keyword("PART_INERTIA");
  out_.line(deck_.scene->pendulum ? "pendulum" : "impactor");
  out_.row({{"PID", whole(ids_.impactor_part, 10)},
            {"SECID", whole(ids_.impactor_part, 10)},
            {"MID", whole(ids_.impactor_part, 10)}});
  out_.row({{"XC", narrow(x.x())},
            {"YC", narrow(x.y())},
            {"ZC", narrow(x.z())},
            {"TM", narrow(impactor_.mass / u_.mass)},
            {"IRCS", whole(0, 10)},
            {"NODEID", whole(0, 10)}});
  out_.row({{"IXX", J(0, 0)},
            {"IXY", J(0, 1)},
            {"IXZ", J(0, 2)},
            {"IYY", J(1, 1)},
            {"IYZ", J(1, 2)},
            {"IZZ", J(2, 2)}});
  out_.row({{"VTX", narrow(v.x())},
            {"VTY", narrow(v.y())},
            {"VTZ", narrow(v.z())},
            {"VRX", narrow(w.x())},
            {"VRY", narrow(w.y())},
            {"VRZ", narrow(w.z())}});
}

// Axes with x along the rail, or the pendulum's axis.
void LsDynaImpactor::system() {
  const Eigen::Matrix3d& axes = impactor_.axes;
  out_.keyword("DEFINE_COORDINATE_VECTOR");
  out_.row({{"CID", whole(local_system, 10)},
            {"XX", narrow(axes(0, 0))},
            {"YX", narrow(axes(1, 0))},
            {"ZX", narrow(axes(2, 0))},
            {"XV", narrow(axes(0, 1))},
            {"YV", narrow(axes(1, 1))},
            {"ZV", narrow(axes(2, 1))}});
}

void LsDynaImpactor::joint() {
  const coupling::PendulumParameters& p = deck_.scene->pendulum->model.parameters();
  const Eigen::Vector3d along = p.pivot + p.impactor_distance * p.axis;
  out_.keyword("NODE");
  out_.node(ids_.pivot, p.pivot);
  out_.node(ids_.along, along);
  out_.node(ids_.support, p.pivot);
  out_.node(ids_.support + 1, along);
  out_.node(ids_.support + 2, impactor_.centre);
  out_.keyword("CONSTRAINED_EXTRA_NODES_NODE");
  for (const int extra : {ids_.pivot, ids_.along})
    out_.card({whole(ids_.impactor_part, 10), whole(extra, 10)});
  rigid_material(ids_.carrier_part, Held::whole);
  out_.part(ids_.carrier_part, "support");
  out_.triangles(ids_.carrier_part, ids_.carrier_element, ids_.support, Eigen::Vector3i(0, 1, 2), {0});
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
}

void LsDynaImpactor::springs() {
  if (impactor_.springs.empty()) return;
  out_.keyword("NODE");
  out_.node(ids_.support, impactor_.anchor);
  out_.keyword("BOUNDARY_SPC_NODE");
  const Field held = whole(1, 10);
  out_.row({{"NID", whole(ids_.support, 10)},
            {"CID", whole(0, 10)},
            {"DOFX", held},
            {"DOFY", held},
            {"DOFZ", held},
            {"DOFRX", held},
            {"DOFRY", held},
            {"DOFRZ", held}});
  int part = ids_.carrier_part, element = ids_.carrier_element;
  for (const DeckSpring& spring : impactor_.springs) {
    const int force = out_.next_curve();
    out_.curve(force, spring.force, u_.length, u_.force());
    out_.keyword("MAT_SPRING_NONLINEAR_ELASTIC");
    out_.row({{"MID", whole(part, 10)}, {"LCD", whole(force, 10)}});
    out_.discrete(part++, "spring of the rail", element++, {ids_.support, ids_.centre});
    if (spring.damping == 0.0) continue;
    out_.keyword("MAT_DAMPER_VISCOUS");
    out_.row({{"MID", whole(part, 10)}, {"DC", narrow(spring.damping / (u_.force() / u_.velocity()))}});
    out_.discrete(part++, "damper of the rail", element++, {ids_.support, ids_.centre});
  }
}

void LsDynaImpactor::load() {
  constexpr int force_along_x = 1, moment_about_x = 5;
  const bool is_moment = deck_.scene->pendulum.has_value();
  const int curve = out_.next_curve();
  out_.curve(curve, impactor_.load, u_.time, is_moment ? u_.energy() : u_.force());
  out_.keyword("LOAD_RIGID_BODY");
  out_.row({{"PID", whole(ids_.impactor_part, 10)},
            {"DOF", whole(is_moment ? moment_about_x : force_along_x, 10)},
            {"LCID", whole(curve, 10)},
            {"SF", narrow(1.0)},
            {"CID", whole(local_system, 10)}});
}

void LsDynaImpactor::contact() {
  constexpr int by_part = 3, by_nodes = 4;
  constexpr int by_mass_and_step = 1;  // stiffness from mass and step, as fabric is soft against a rigid body
  out_.contact({.kind = "AUTOMATIC_NODES_TO_SURFACE",
                .id = 1,
                .name = "impactor against bag",
                .first = bag_set,
                .first_kind = by_nodes,
                .second = ids_.impactor_part,
                .second_kind = by_part,
                .friction = deck_.scene->contact->parameters().friction});
  out_.row({{"SOFT", whole(by_mass_and_step, 10)}});
}

}  // namespace

void write_lsdyna_impactor(const Deck& deck, LsDynaCards& out) {
  LsDynaImpactor(deck, out).write();
}

}  // namespace driver
