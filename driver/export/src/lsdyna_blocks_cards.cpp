// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "lsdyna_blocks.hpp"

namespace driver {

void LsDynaCards::keyword(std::string_view name) {
  line(fmt::format("*{}", name));
}

void LsDynaCards::row(std::initializer_list<Entry> entries) {
  std::vector<Field> names, fields;
  for (const Entry& entry : entries) {
    names.push_back(word(entry.name, entry.field.width));
    fields.push_back(entry.field);
  }
  Field& first = names.front();
  first.text = fmt::format("${:>{}}", first.text, first.width - 1);
  card(names);
  card(fields);
}

void LsDynaCards::curve(int id, const DeckCurve& points, double x_unit, double y_unit, int intervals,
                        const std::string& title) {
  keyword(title.empty() ? "DEFINE_CURVE" : "DEFINE_CURVE_TITLE");
  if (!title.empty()) label(title, 80);
  row({{"LCID", whole(id, 10)},
       {"SIDR", whole(0, 10)},
       {"SFA", narrow(1.0)},
       {"SFO", narrow(1.0)},
       {"OFFA", narrow(0.0)},
       {"OFFO", narrow(0.0)},
       {"DATTYP", whole(0, 10)},
       {"LCINT", whole(intervals, 10)}});
  for (const auto& [x, y] : points) card({real(x / x_unit, 20), real(y / y_unit, 20)});
}

void LsDynaCards::curve_of_pressure(int id, const DeckCurve& points, double ambient, double y_unit) {
  DeckCurve absolute;
  for (const auto& [pressure, value] : points) absolute.push_back({ambient + pressure, value});
  // Some programs resample curves on a hundred even steps. Therefore the last knot, which only holds the
  // value, is near the others, and the first is at zero.
  const double last = absolute[absolute.size() - 2][0];
  absolute.back()[0] = std::max(last, 0.0) + ambient;
  while (absolute.size() > 1 && absolute[1][0] <= 0.0) absolute.erase(absolute.begin());
  absolute.front()[0] = std::max(absolute.front()[0], 0.0);
  curve(id, absolute, u_.pressure(), y_unit);
}

void LsDynaCards::node(int id, const Eigen::Vector3d& x) {
  card({whole(id, 8), real(x.x() / u_.length, 16), real(x.y() / u_.length, 16), real(x.z() / u_.length, 16)});
}

void LsDynaCards::set(const char* kind, int id, const std::vector<int>& members) {
  keyword(fmt::format("SET_{}_LIST", kind));
  row({{"SID", whole(id, 10)}});
  constexpr std::size_t width = 10, per_line = 8;
  list(members, width, per_line);
}

void LsDynaCards::part(int id, std::string_view name) {
  keyword("PART");
  label(name, 70);
  row({{"PID", whole(id, 10)}, {"SECID", whole(id, 10)}, {"MID", whole(id, 10)}});
}

void LsDynaCards::discrete(int id, std::string_view name, int element, std::array<int, 2> nodes) {
  keyword("SECTION_DISCRETE");
  row({{"SECID", whole(id, 10)},
       {"DRO", whole(0, 10)},
       {"KD", narrow(0.0)},
       {"V0", narrow(0.0)},
       {"CL", narrow(0.0)},
       {"FD", narrow(0.0)}});
  row({{"CDL", narrow(0.0)}, {"TDL", narrow(0.0)}});
  part(id, name);
  keyword("ELEMENT_DISCRETE");
  row({{"EID", whole(element, 8)},
       {"PID", whole(id, 8)},
       {"N1", whole(nodes[0], 8)},
       {"N2", whole(nodes[1], 8)},
       {"VID", whole(0, 8)},
       {"S", real(1.0, 16)},
       {"PF", whole(0, 8)},
       {"OFFSET", real(0.0, 16)}});
}

void LsDynaCards::triangles(int part_id, int first_element, int first_node, const Eigen::Matrix3Xi& corners,
                            const std::vector<int>& elements) {
  keyword("ELEMENT_SHELL");
  line("$    EID     PID      N1      N2      N3      N4");
  for (const int e : elements) {
    const Field last = whole(first_node + corners(2, e), 8);
    card({whole(first_element + e, 8), whole(part_id, 8), whole(first_node + corners(0, e), 8),
          whole(first_node + corners(1, e), 8), last, last});
  }
}

void LsDynaCards::contact(const LsDynaContact& contact) {
  const Field none = narrow(0.0), friction = narrow(contact.friction), one = narrow(1.0);
  keyword(fmt::format("CONTACT_{}_ID", contact.kind));
  line(fmt::format("{:>10}{}", contact.id, contact.name));
  row({{"SSID", whole(contact.first, 10)},
       {"MSID", whole(contact.second, 10)},
       {"SSTYP", whole(contact.first_kind, 10)},
       {"MSTYP", whole(contact.second_kind, 10)},
       {"SBOXID", whole(0, 10)},
       {"MBOXID", whole(0, 10)},
       {"SPR", whole(1, 10)},
       {"MPR", whole(1, 10)}});
  row({{"FS", friction},
       {"FD", friction},
       {"DC", none},
       {"VC", none},
       {"VDC", none},
       {"PENCHK", whole(0, 10)},
       {"BT", none},
       {"DT", narrow(1e20)}});
  row({{"SFS", one},
       {"SFM", one},
       {"SST", narrow(contact.thickness / u_.length)},
       {"MST", none},
       {"SFST", one},
       {"SFMT", one},
       {"FSF", one},
       {"VSF", one}});
}

}  // namespace driver
