// SPDX-License-Identifier: Apache-2.0
// An LS-DYNA keyword deck.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "export/writers.hpp"

namespace driver {

/// The one opening of an LS-DYNA airbag, with a coefficient of time and an area of pressure, and the second
/// one that it has if no fabric leaks.
struct LsDynaVents {
  double area = 0.0;                         // [m2] with the discharge coefficient
  std::optional<DeckCurve> of_time;          // [-] of time [s], a factor
  std::optional<DeckCurve> of_overpressure;  // [m2] of overpressure [Pa], instead of `area`
  double opens_at_overpressure = 0.0;        // [Pa]
  std::optional<DeckCurve> second;           // [m2] of overpressure [Pa]
  std::vector<DeckNote> notes;               // of vents that are left out
};
LsDynaVents lsdyna_vents(const Deck& deck);

/// Writes the deck, one method a block.
class LsDynaDeck {
 public:
  LsDynaDeck(const Deck& deck, const Units& units) : deck_(deck), u_(units), ids_(deck) {}
  std::string text();

 private:
  /// A field with its name, which stands above it in a comment.
  struct Entry {
    const char* name;
    Field field;
  };
  enum Set { bag_parts = 1, bag_set = 1, free_set, first_held_set };  // of parts; of nodes
  static constexpr int constant_one = 1;                              // curve
  const BagPart& bag() const { return *deck_.scene->bag; }
  void row(std::initializer_list<Entry> entries);
  void keyword(std::string_view name);
  void curve(int id, const DeckCurve& points, double x_unit, double y_unit);
  /// A curve of overpressure as one of absolute pressure.
  void curve_of_pressure(int id, const DeckCurve& points, double y_unit);

  void head();
  void node(int id, const Eigen::Vector3d& x);
  void nodes();
  void set(const char* kind, int id, const std::vector<int>& members);
  void part(int id, std::string_view name);
  void membrane_section(int id, double thickness);
  void triangles(int part_id, int first_element, int first_node, const Eigen::Matrix3Xi& corners,
                 const std::vector<int>& elements);
  void fabric();
  void fabric_material(const DeckPart& p);
  void null_material(const DeckPart& p);
  void reference();
  void straps();
  void supports();
  void plate(const membrane::Plate& wall);
  void damping();
  void airbag();
  void gas(const DeckGas& mixture, double initial, int mass_flow, int temperature);
  void pendulum();
  void pendulum_part(const Eigen::Vector3d& cg, double rate);
  void rigid_material(int id, bool held);
  void contact();
  void loads();
  void requests();

  const Deck& deck_;
  const Units& u_;
  DeckIds ids_;
  int next_curve_ = constant_one + 1;
  std::vector<int> leak_curves_;  // of the parts that leak by a table
  Cards out_;
};

}  // namespace driver
