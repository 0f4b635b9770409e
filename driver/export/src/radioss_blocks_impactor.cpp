// SPDX-License-Identifier: Apache-2.0
// The impactor of a Radioss deck, what carries it, its load and its contact.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>

#include "radioss_blocks.hpp"

namespace driver {
namespace {

/// Writes the impactor, one method a block.
class RadiossImpactor : private RadiossIds {
 public:
  RadiossImpactor(const Deck& deck, RadiossCards& out)
      : deck_(deck), impactor_(*deck.impactor), u_(out.units()), ids_(deck), out_(out) {}
  void write();

 private:
  void nodes();
  void rigid_body(int id, std::string_view name, int main, Group nodes, double mass,
                  const Eigen::Matrix3d& inertia);
  void velocity(std::string_view kind, const Eigen::Vector3d& value);
  void axes();
  void joint();
  void rail();
  void spring(const DeckSpring& given, int number);
  void load();
  void contact();

  const Deck& deck_;
  const DeckImpactor& impactor_;
  const Units& u_;
  DeckIds ids_;
  RadiossCards& out_;
};

void RadiossImpactor::write() {
  nodes();
  rigid_body(1, deck_.scene->pendulum ? "pendulum" : "impactor", ids_.cg, rigid_nodes, impactor_.mass,
             impactor_.inertia);
  if (!impactor_.velocity.isZero(0.0)) velocity("TRA/1", impactor_.velocity / u_.velocity());
  if (!impactor_.angular_velocity.isZero(0.0)) velocity("ROT/2", impactor_.angular_velocity * u_.time);
  if (impactor_.on_rail || !impactor_.load.empty()) axes();
  if (deck_.scene->pendulum) joint();
  if (impactor_.on_rail) rail();
  if (!impactor_.load.empty()) load();
  if (deck_.scene->contact) contact();
}

void RadiossImpactor::nodes() {
  out_.line("/NODE");
  for (int i = 0; i < impactor_.surface.node_count(); ++i)
    out_.node(ids_.impactor_node + i, impactor_.surface.nodes.col(i));
  out_.node(ids_.cg, impactor_.cg);
  out_.node(ids_.centre, impactor_.centre);
  out_.part(ids_.impactor_part, "impactor", void_property, void_law);
  std::vector<int> elements(static_cast<std::size_t>(impactor_.surface.element_count()));
  std::iota(elements.begin(), elements.end(), 0);
  out_.triangles(ids_.impactor_part, ids_.impactor_element, ids_.impactor_node, impactor_.surface.elements,
                 elements);
  std::vector<int> nodes = impactor_nodes(deck_, ids_);
  nodes.push_back(ids_.centre);
  if (deck_.scene->pendulum) nodes.insert(nodes.end(), {ids_.pivot, ids_.along});
  out_.group(rigid_nodes, "impactor", nodes);
  out_.group(rigid_main, "centre of gravity", {ids_.cg});
}

void RadiossImpactor::rigid_body(int id, std::string_view name, int main, Group nodes, double mass,
                                 const Eigen::Matrix3d& inertia) {
  constexpr int as_given = 4;  // mass and inertia as on the card; the main node does not move
  const auto J = [&](int i, int j) { return real(inertia(i, j) / u_.inertia(), 20); };
  out_.title(fmt::format("/RBODY/{}", id), name);
  out_.line(
      "#  node_ID   sens_ID   Skew_ID    Ispher                Mass   grnd_ID     Ikrem      ICoG   surf_ID");
  out_.card({whole(main, 10), whole(0, 10), whole(0, 10), whole(0, 10), real(mass / u_.mass, 20),
             whole(nodes, 10), whole(0, 10), whole(as_given, 10), whole(0, 10)});
  out_.line("#                Jxx                 Jyy                 Jzz");
  out_.card({J(0, 0), J(1, 1), J(2, 2)});
  out_.line("#                Jxy                 Jyz                 Jxz");
  out_.card({J(0, 1), J(1, 2), J(0, 2)});
  out_.line("#  Ioptoff   Iexpams     Ifail");
  out_.card({whole(0, 10), whole(0, 10), whole(0, 10)});
}

void RadiossImpactor::velocity(std::string_view kind, const Eigen::Vector3d& value) {
  out_.title(fmt::format("/INIVEL/{}", kind), "impactor");
  out_.line("#                 Vx                  Vy                  Vz   Gnod_id   Skew_id");
  out_.card(
      {real(value.x(), 20), real(value.y(), 20), real(value.z(), 20), whole(rigid_main, 10), whole(0, 10)});
}

// Axes with x along the rail, or the pendulum's axis.
void RadiossImpactor::axes() {
  const Eigen::Matrix3d& axes = impactor_.axes;
  const auto card = [&](const Eigen::Vector3d& v) {
    out_.card({real(v.x(), 20), real(v.y(), 20), real(v.z(), 20)});
  };
  out_.title(fmt::format("/SKEW/FIX/{}", local_axes),
             impactor_.on_rail ? "x along the rail" : "x along the axis");
  out_.line("#                 Ox                  Oy                  Oz");
  out_.point(impactor_.centre);
  out_.line("#                 X1                  Y1                  Z1");
  card(axes.col(1));
  out_.line("#                 X2                  Y2                  Z2");
  card(axes.col(2));
}

void RadiossImpactor::joint() {
  const coupling::PendulumParameters& p = deck_.scene->pendulum->model.parameters();
  out_.line("/NODE");
  out_.node(ids_.pivot, p.pivot);
  out_.node(ids_.along, p.pivot + p.impactor_distance * p.axis);
  out_.node(ids_.support, p.pivot);
  out_.node(ids_.support + 1, p.pivot);
  out_.group(support_nodes, "support", {ids_.support + 1});
  out_.group(support_main, "support", {ids_.support});
  rigid_body(2, "support", ids_.support, support_nodes, p.mass,
             p.mass * p.impactor_distance * p.impactor_distance * Eigen::Matrix3d::Identity());
  out_.hold(2, "111 111", support_main);
  out_.title(fmt::format("/SKEW/MOV/{}", joint_axes), "joint, x along the axis");
  out_.line("#       N1        N2        N3       DIR");
  out_.card({whole(ids_.pivot, 10), whole(ids_.along, 10), whole(ids_.centre, 10), word("X", 10)});
  // A stiffness at which the pendulum's mass would swing a hundred times within the run.
  const double rate = 200.0 * std::numbers::pi / deck_.scene->time.end;
  constexpr int revolute = 2;
  out_.title(fmt::format("/PROP/KJOINT2/{}", joint_property), "revolute joint");
  out_.line(
      "#     Type                  Kn                 ScF                  Cr   sens_ID  Skew_ID1  Skew_ID2");
  out_.card({whole(revolute, 10), real(p.mass * rate * rate / u_.stiffness(), 20), real(0.0, 20),
             real(0.0, 20), whole(0, 10), whole(joint_axes, 10), whole(0, 10)});
  out_.line("#                Krx   fct_Krx                SAx-                SAx+");
  out_.card({real(0.0, 20), whole(0, 10), real(0.0, 20), real(0.0, 20)});
  out_.line("#                Crx   fct_Crx");
  out_.card({real(0.0, 20), whole(0, 10)});
  out_.line("#               Kfrx                 FMx   fct_fmx");
  out_.card({real(0.0, 20), real(0.0, 20), whole(0, 10)});
  out_.part(ids_.carrier_part, "joint", joint_property, 0);
  out_.line(fmt::format("/SPRING/{}", ids_.carrier_part));
  out_.line("#sprg_ID   node_ID1  node_ID2");
  out_.card({whole(ids_.carrier_element, 10), whole(ids_.pivot, 10), whole(ids_.support + 1, 10)});
}

void RadiossImpactor::rail() {
  out_.hold(3, "011 111", rigid_main, local_axes);  // free along x alone
  if (impactor_.springs.empty()) return;
  out_.line("/NODE");
  out_.node(ids_.support, impactor_.anchor);
  out_.group(support_main, "end of the rail's springs", {ids_.support});
  out_.hold(2, "111 111", support_main);
  int number = 0;
  for (const DeckSpring& each : impactor_.springs) spring(each, number++);
}

void RadiossImpactor::spring(const DeckSpring& given, int number) {
  // The impactor's mass gives the spring a time step; neither of its nodes feels it. A damper alone needs
  // some stiffness for its step, which its curve lacks.
  const double end = deck_.scene->time.end;
  out_.spring({.property = RadiossIds::rail_property + number,
               .part = ids_.carrier_part + number,
               .element = ids_.carrier_element + number,
               .name = "spring of the rail",
               .nodes = {ids_.support, ids_.centre},
               .mass = impactor_.mass,
               .stiffness = std::max(given.stiffness, impactor_.mass / (end * end)),
               .damping = given.damping,
               .force = given.force});
}

void RadiossImpactor::load() {
  const bool is_moment = deck_.scene->pendulum.has_value();
  const int curve = out_.function(is_moment ? "driving moment" : "force along the rail", impactor_.load,
                                  u_.time, is_moment ? u_.energy() : u_.force());
  out_.title("/CLOAD/1", "impactor");
  out_.line(
      "#funct_IDT       Dir   skew_ID sensor_ID  grnod_ID                       Ascalex             Fscaley");
  out_.card({whole(curve, 10), word(is_moment ? "XX" : "X", 10), whole(local_axes, 10), whole(0, 10),
             whole(rigid_main, 10), blank(10), real(1.0, 20), real(1.0, 20)});
}

void RadiossImpactor::contact() {
  out_.title("/SURF/PART/2", "impactor");
  out_.list({ids_.impactor_part}, 10);
  out_.contact({.id = 1,
                .name = "impactor against bag",
                .surface = 2,
                .friction = deck_.scene->contact->parameters().friction,
                .gap = impactor_.gap});
}

}  // namespace

void write_radioss_impactor(const Deck& deck, RadiossCards& out) {
  RadiossImpactor(deck, out).write();
}

}  // namespace driver
