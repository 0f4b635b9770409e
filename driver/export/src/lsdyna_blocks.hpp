// SPDX-License-Identifier: Apache-2.0
// Keywords of an LS-DYNA deck, and the writers of its blocks.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "export/cards.hpp"
#include "export/deck_ids.hpp"
#include "export/units.hpp"

namespace driver {

/// Numbers of single objects of an LS-DYNA deck.
struct LsDynaIds {
  enum Set {
    bag_parts = 1,
    fabric_parts,
    bag_shells = 1,
    bag_set = 1,
    free_set,
    first_held_set
  };                                      // parts; shells; nodes
  static constexpr int constant_one = 1;  // curve
  static constexpr int local_system = 1;  // of coordinates
};

/// A contact by its first three cards; their numbers stand in the program's manual.
struct LsDynaContact {
  std::string_view kind;  // the keyword's end
  int id;
  std::string_view name;
  int first, first_kind;            // SSID, SSTYP
  int second = 0, second_kind = 0;  // MSID, MSTYP
  double friction = 0.0;            // [-]
  double thickness = 0.0;           // [m] SST
};

/// Cards in an LS-DYNA deck's units, with the keywords that several blocks use.
class LsDynaCards : public Cards {
 public:
  /// A field with its name, which stands above it in a comment.
  struct Entry {
    const char* name;
    Field field;
  };
  explicit LsDynaCards(const Units& units) : u_(units) {}
  const Units& units() const { return u_; }
  int next_curve() { return next_curve_++; }
  void keyword(std::string_view name);
  void row(std::initializer_list<Entry> entries);
  /// `intervals`: even steps on which the program resamples the curve; 0 is its default, a hundred.
  void curve(int id, const DeckCurve& points, double x_unit, double y_unit, int intervals = 0,
             const std::string& title = {});
  /// A curve of overpressure as one of absolute pressure.
  void curve_of_pressure(int id, const DeckCurve& points, double ambient, double y_unit);
  void node(int id, const Eigen::Vector3d& x);
  void set(const char* kind, int id, const std::vector<int>& members);
  void part(int id, std::string_view name);
  /// The part of a discrete element, with its section and the element itself between two nodes. The material
  /// has the part's number.
  void discrete(int id, std::string_view name, int element, std::array<int, 2> nodes);
  void contact(const LsDynaContact& contact);
  void triangles(int part_id, int first_element, int first_node, const Eigen::Matrix3Xi& corners,
                 const std::vector<int>& elements);

 private:
  const Units& u_;
  int next_curve_ = LsDynaIds::constant_one + 1;
};

/// The one opening of an LS-DYNA airbag, with a coefficient over time and an area over pressure, and the
/// second opening that is free if no fabric leaks.
struct LsDynaVents {
  double area = 0.0;                         // [m2] with the discharge coefficient
  std::optional<DeckCurve> of_time;          // [-] of time [s], a factor
  std::optional<DeckCurve> of_overpressure;  // [m2] of overpressure [Pa], instead of `area`
  double opens_at_overpressure = 0.0;        // [Pa]
  std::optional<DeckCurve> second;           // [m2] of overpressure [Pa]
  std::vector<DeckOmission> omissions;
};
LsDynaVents lsdyna_vents(const Deck& deck);

/// Parts with their materials and elements, and the design shape.
void write_lsdyna_fabric(const Deck& deck, LsDynaCards& out);
void write_lsdyna_straps(const Deck& deck, LsDynaCards& out);
void write_lsdyna_airbag(const Deck& deck, LsDynaCards& out);
/// The impactor with what carries it, its load and its contact.
void write_lsdyna_impactor(const Deck& deck, LsDynaCards& out);

}  // namespace driver
