// SPDX-License-Identifier: Apache-2.0
// The starter file of a Radioss deck.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "export/writers.hpp"

namespace driver {

/// Numbers of what a Radioss deck has once.
struct RadiossIds {
  enum Group {
    all_nodes = 1,
    free_nodes,
    heavy_nodes,
    pendulum_nodes,
    pendulum_main,
    support_nodes,
    support_main,
    first_held_nodes  // the last: there may be several
  };
  static constexpr int void_law = 901, void_property = 901, joint_property = 902, strap_property = 300;
  static constexpr int constant_one = 1;  // function
};

/// Writes the starter file, one method a block.
class RadiossStarter : private RadiossIds {
 public:
  RadiossStarter(const Deck& deck, const Units& units) : deck_(deck), u_(units), ids_(deck) {}
  std::string text();

 private:
  const BagPart& bag() const { return *deck_.scene->bag; }
  void title(const std::string& header, std::string_view text);
  void head();
  void node(int id, const Eigen::Vector3d& x);
  void nodes();
  void part(int id, std::string_view name, int property, int law);
  void triangles(int part_id, int first_element, int first_node, const Eigen::Matrix3Xi& corners,
                 const std::vector<int>& elements);
  void void_material();
  void fabric();
  void fabric_material(const DeckPart& p);
  void porous(const DeckLeak& leak);
  void fabric_property(const DeckPart& p);
  void reference(const DeckPart& p);
  void straps();
  void group(Group id, std::string_view name, const std::vector<int>& nodes);
  void hold(int id, std::string_view code, Group nodes);
  void supports();
  void point(const Eigen::Vector3d& x);
  void surfaces();
  void pendulum();
  void body(int id, std::string_view name, int main, Group nodes, double mass, double inertia);
  void joint(const coupling::PendulumParameters& p);
  void contact();
  void loads();
  void requests();
  void request(std::string_view header, std::string_view variables, int object);
  const Deck& deck_;
  const Units& u_;
  DeckIds ids_;
  int function_ = constant_one + 1;
  Cards out_;
};

}  // namespace driver
