// SPDX-License-Identifier: Apache-2.0
// Pendulum, joint and contact of a Radioss deck.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>

#include "radioss_blocks.hpp"

namespace driver {
namespace {

/// Writes the pendulum, one method a block.
class RadiossPendulum : private RadiossIds {
 public:
  RadiossPendulum(const Deck& deck, RadiossCards& out)
      : deck_(deck), u_(out.units()), ids_(deck), out_(out) {}
  void write();

 private:
  void body(int id, std::string_view name, int main, Group nodes, double mass, double inertia);
  void joint(const coupling::PendulumParameters& p);
  void contact();

  const Deck& deck_;
  const Units& u_;
  DeckIds ids_;
  RadiossCards& out_;
};

void RadiossPendulum::body(int id, std::string_view name, int main, Group nodes, double mass,
                           double inertia) {
  constexpr int as_given = 4;  // mass and inertia as on the card; the main node does not move
  out_.title(fmt::format("/RBODY/{}", id), name);
  out_.line(
      "#  node_ID   sens_ID   Skew_ID    Ispher                Mass   grnd_ID     Ikrem      ICoG   surf_ID");
  out_.card({whole(main, 10), whole(0, 10), whole(0, 10), whole(0, 10), real(mass / u_.mass, 20),
             whole(nodes, 10), whole(0, 10), whole(as_given, 10), whole(0, 10)});
  out_.line("#                Jxx                 Jyy                 Jzz");
  const Field J = real(inertia / u_.inertia(), 20);
  out_.card({J, J, J});
  out_.line("#                Jxy                 Jyz                 Jxz");
  out_.card({real(0.0, 20), real(0.0, 20), real(0.0, 20)});
  out_.line("#  Ioptoff   Iexpams     Ifail");
  out_.card({whole(0, 10), whole(0, 10), whole(0, 10)});
}

void RadiossPendulum::write() {
  const PendulumPart& part_of = *deck_.scene->pendulum;
  const coupling::PendulumParameters& p = part_of.model.parameters();
  const double angle = part_of.initial.angle, rate = part_of.initial.angular_velocity;
  const Eigen::Vector3d centre = part_of.model.impactor_centre(angle), cg = part_of.model.cg_position(angle);
  const Eigen::Vector3d arm = (centre - p.pivot).normalized() * p.impactor_distance;
  out_.line("/NODE");
  for (int i = 0; i < deck_.sphere.node_count(); ++i)
    out_.node(ids_.sphere_node + i, centre + deck_.sphere.nodes.col(i));
  out_.node(ids_.cg, cg);
  out_.node(ids_.pivot, p.pivot);
  out_.node(ids_.along, p.pivot + p.impactor_distance * p.axis);
  out_.node(ids_.across, p.pivot + arm);
  out_.node(ids_.support, p.pivot);
  out_.node(ids_.support + 1, p.pivot);
  out_.part(ids_.sphere_part, "impactor", void_property, void_law);
  std::vector<int> elements(static_cast<std::size_t>(deck_.sphere.element_count()));
  for (std::size_t e = 0; e < elements.size(); ++e) elements[e] = static_cast<int>(e);
  out_.triangles(ids_.sphere_part, ids_.sphere_element, ids_.sphere_node, deck_.sphere.elements, elements);
  std::vector<int> nodes = sphere_nodes(deck_, ids_);
  for (const int extra : {ids_.pivot, ids_.along, ids_.across}) nodes.push_back(extra);
  out_.group(pendulum_nodes, "pendulum", nodes);
  out_.group(pendulum_main, "centre of gravity", {ids_.cg});
  out_.group(support_nodes, "support", {ids_.support + 1});
  out_.group(support_main, "support", {ids_.support});
  body(1, "pendulum", ids_.cg, pendulum_nodes, p.mass, deck_.inertia);
  body(2, "support", ids_.support, support_nodes, p.mass, p.mass * p.impactor_distance * p.impactor_distance);
  out_.hold(2, "111 111", support_main);
  joint(p);
  if (rate != 0.0) {
    const Eigen::Vector3d v = rate * p.axis.cross(cg - p.pivot) / u_.velocity(), w = rate * p.axis * u_.time;
    for (const auto& [kind, value] : {std::pair{"TRA/1", v}, std::pair{"ROT/2", w}}) {
      out_.title(fmt::format("/INIVEL/{}", kind), "pendulum");
      out_.line("#                 Vx                  Vy                  Vz   Gnod_id   Skew_id");
      out_.card({real(value.x(), 20), real(value.y(), 20), real(value.z(), 20), whole(pendulum_main, 10),
                 whole(0, 10)});
    }
  }
  if (deck_.scene->contact) contact();
}

void RadiossPendulum::joint(const coupling::PendulumParameters& p) {
  out_.title("/SKEW/MOV/1", "joint, x along the axis");
  out_.line("#       N1        N2        N3       DIR");
  out_.card({whole(ids_.pivot, 10), whole(ids_.along, 10), whole(ids_.across, 10), word("X", 10)});
  // A stiffness at which the pendulum's mass would swing a hundred times within the run.
  const double rate = 200.0 * std::numbers::pi / deck_.scene->time.end;
  constexpr int revolute = 2;
  out_.title(fmt::format("/PROP/KJOINT2/{}", joint_property), "revolute joint");
  out_.line(
      "#     Type                  Kn                 ScF                  Cr   sens_ID  Skew_ID1  Skew_ID2");
  out_.card({whole(revolute, 10), real(p.mass * rate * rate / u_.stiffness(), 20), real(0.0, 20),
             real(0.0, 20), whole(0, 10), whole(1, 10), whole(0, 10)});
  out_.line("#                Krx   fct_Krx                SAx-                SAx+");
  out_.card({real(0.0, 20), whole(0, 10), real(0.0, 20), real(0.0, 20)});
  out_.line("#                Crx   fct_Crx");
  out_.card({real(0.0, 20), whole(0, 10)});
  out_.line("#               Kfrx                 FMx   fct_fmx");
  out_.card({real(0.0, 20), real(0.0, 20), whole(0, 10)});
  out_.part(ids_.joint_part, "joint", joint_property, 0);
  out_.line(fmt::format("/SPRING/{}", ids_.joint_part));
  out_.line("#sprg_ID   node_ID1  node_ID2");
  out_.card({whole(ids_.joint_element, 10), whole(ids_.pivot, 10), whole(ids_.support + 1, 10)});
}

void RadiossPendulum::contact() {
  out_.title("/SURF/PART/2", "impactor");
  out_.list({ids_.sphere_part}, 10);
  out_.contact({.id = 1,
                .name = "impactor against bag",
                .surface = 2,
                .friction = deck_.scene->contact->parameters().friction,
                .gap = deck_.contact_gap});
}

}  // namespace

void write_radioss_pendulum(const Deck& deck, RadiossCards& out) {
  RadiossPendulum(deck, out).write();
}

}  // namespace driver
