// SPDX-License-Identifier: Apache-2.0
// Keywords of a Radioss deck, and the writers of its blocks.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "export/cards.hpp"
#include "export/deck_ids.hpp"
#include "export/units.hpp"

namespace driver {

/// Numbers of single objects of a Radioss deck.
struct RadiossIds {
  enum Group {
    all_nodes = 1,
    free_nodes,
    heavy_nodes,
    rigid_nodes,
    rigid_main,
    support_nodes,
    support_main,
    first_held_nodes  // last, because there may be several
  };
  static constexpr int bag_surface = 1;
  static constexpr int void_law = 901, void_property = 901, joint_property = 902, strap_property = 300,
                       rail_property = 903;
  static constexpr int joint_axes = 1, local_axes = 2;
  static constexpr int constant_one = 1;  // function
};

/// Contact of the bag's nodes with a surface.
struct RadiossContact {
  int id;
  std::string_view name;
  int surface;
  double friction;    // [-]
  double gap;         // [m]
  int stiffness = 0;  // Istf
  int at_start = 0;   // Inacti
};

/// A spring between two nodes by a curve of force over elongation.
struct RadiossSpring {
  int property, part, element;
  std::string_view name;
  std::array<int, 2> nodes;
  double mass;           // [kg]
  double stiffness;      // [N/m] for the time step
  double damping = 0.0;  // [N s/m]
  DeckCurve force;       // [N] over elongation [m]
};

/// Cards in a Radioss deck's units, with the keywords that several blocks use.
class RadiossCards : public Cards, public RadiossIds {
 public:
  explicit RadiossCards(const Units& units) : u_(units) {}
  const Units& units() const { return u_; }
  void title(const std::string& header, std::string_view text);
  void node(int id, const Eigen::Vector3d& x);
  void point(const Eigen::Vector3d& x);
  void part(int id, std::string_view name, int property, int law);
  void group(Group id, std::string_view name, const std::vector<int>& nodes);
  void contact(const RadiossContact& contact);
  void hold(int id, std::string_view code, Group nodes, int axes = 0);
  /// The spring with its function, property and part.
  void spring(const RadiossSpring& spring);
  void triangles(int part_id, int first_element, int first_node, const Eigen::Matrix3Xi& corners,
                 const std::vector<int>& elements);
  /// Returns the function's number.
  int function(std::string_view name, const DeckCurve& curve, double x_unit, double y_unit);

 private:
  const Units& u_;
  int functions_ = 0;
};

/// Parts with their materials, properties and elements, and the design shape.
void write_radioss_fabric(const Deck& deck, RadiossCards& out);
void write_radioss_straps(const Deck& deck, RadiossCards& out);
/// /MONVOL, its gases, inflators and functions.
void write_radioss_airbag(const Deck& deck, RadiossCards& out);
/// The impactor with what carries it, its load and its contact.
void write_radioss_impactor(const Deck& deck, RadiossCards& out);

}  // namespace driver
