// SPDX-License-Identifier: Apache-2.0
// An LS-DYNA deck: bag.k.
#include <fmt/format.h>

#include <algorithm>

#include "export/lsdyna_deck.hpp"

namespace driver {
namespace {

const char* time_name(const Units& u) {
  return u.time == 1.0 ? "sec" : "ms";
}

const char* mass_name(const Units& u) {
  return u.mass == 1.0 ? "kg" : "mtrc_ton";
}

}  // namespace

std::string LsDynaDeck::text() {
  head();
  nodes();
  fabric();
  straps();
  supports();
  if (deck_.scene->pendulum) pendulum();
  airbag();
  loads();
  requests();
  keyword("END");
  return out_.text();
}

void LsDynaDeck::keyword(std::string_view name) {
  out_.line(fmt::format("*{}", name));
}

void LsDynaDeck::row(std::initializer_list<Entry> entries) {
  std::vector<Field> names, fields;
  for (const Entry& entry : entries) {
    names.push_back(word(entry.name, entry.field.width));
    fields.push_back(entry.field);
  }
  Field& first = names.front();
  first.text = fmt::format("${:>{}}", first.text, first.width - 1);
  out_.card(names);
  out_.card(fields);
}

void LsDynaDeck::head() {
  keyword("KEYWORD");
  keyword("TITLE");
  out_.label(deck_.scene->name, 80);
  keyword("CONTROL_UNITS");
  out_.line(fmt::format("{:<10}{:<10}{:<10}{:<10}", u_.length_code, time_name(u_), mass_name(u_), "k"));
  keyword("CONTROL_TERMINATION");
  row({{"ENDTIM", narrow(deck_.scene->time.end / u_.time)}});
  keyword("CONTROL_TIMESTEP");
  row({{"DTINIT", narrow(0.0)}, {"TSSFAC", narrow(0.8)}});
  keyword("CONTROL_ENERGY");
  row({{"HGEN", whole(2, 10)}, {"RWEN", whole(2, 10)}, {"SLNTEN", whole(2, 10)}, {"RYLEN", whole(2, 10)}});
  curve(constant_one, {{0.0, 1.0}, {2.0 * deck_.scene->time.end, 1.0}}, u_.time, 1.0);
}

void LsDynaDeck::curve(int id, const DeckCurve& points, double x_unit, double y_unit) {
  keyword("DEFINE_CURVE");
  row({{"LCID", whole(id, 10)},
       {"SIDR", whole(0, 10)},
       {"SFA", narrow(1.0)},
       {"SFO", narrow(1.0)},
       {"OFFA", narrow(0.0)},
       {"OFFO", narrow(0.0)},
       {"DATTYP", whole(0, 10)}});
  for (const auto& [x, y] : points) out_.card({real(x / x_unit, 20), real(y / y_unit, 20)});
}

void LsDynaDeck::curve_of_pressure(int id, const DeckCurve& points, double y_unit) {
  const double ambient = deck_.scene->ambient.pressure;
  DeckCurve absolute;
  for (const auto& [pressure, value] : points) absolute.push_back({ambient + pressure, value});
  // Some programs read curves again on a hundred even steps: the last knot, which only holds the value,
  // stands near the others, and a first one at zero.
  const double last = absolute[absolute.size() - 2][0];
  absolute.back()[0] = std::max(last, 0.0) + ambient;
  while (absolute.size() > 1 && absolute[1][0] <= 0.0) absolute.erase(absolute.begin());
  absolute.front()[0] = std::max(absolute.front()[0], 0.0);
  curve(id, absolute, u_.pressure(), y_unit);
}

void LsDynaDeck::node(int id, const Eigen::Vector3d& x) {
  out_.card(
      {whole(id, 8), real(x.x() / u_.length, 16), real(x.y() / u_.length, 16), real(x.z() / u_.length, 16)});
}

void LsDynaDeck::nodes() {
  keyword("NODE");
  out_.line("$    NID               X               Y               Z");
  for (int i = 0; i < bag().mesh.node_count(); ++i) node(i + 1, bag().initial_position.col(i));
}

void LsDynaDeck::set(const char* kind, int id, const std::vector<int>& members) {
  keyword(fmt::format("SET_{}_LIST", kind));
  row({{"SID", whole(id, 10)}});
  constexpr std::size_t width = 10, per_line = 8;
  out_.list(members, width, per_line);
}

void LsDynaDeck::supports() {
  set("NODE", bag_set, bag_nodes(deck_, false));
  const auto free = bag_nodes(deck_, true);
  if (!free.empty()) set("NODE", free_set, free);
  int next_set = first_held_set;
  for (const HeldNodes& held : held_nodes(deck_)) {
    set("NODE", next_set, held.nodes);
    keyword("BOUNDARY_SPC_SET");
    row({{"NSID", whole(next_set++, 10)},
         {"CID", whole(0, 10)},
         {"DOFX", whole(held.along[0], 10)},
         {"DOFY", whole(held.along[1], 10)},
         {"DOFZ", whole(held.along[2], 10)},
         {"DOFRX", whole(0, 10)},
         {"DOFRY", whole(0, 10)},
         {"DOFRZ", whole(0, 10)}});
  }
  if (!free.empty())
    for (const membrane::Plate& wall : bag().model.description.plates) plate(wall);
  damping();
}

void LsDynaDeck::plate(const membrane::Plate& wall) {
  const Eigen::Vector3d tail = wall.point / u_.length,
                        head = (wall.point + wall.normal.normalized()) / u_.length;
  keyword("RIGIDWALL_PLANAR_ID");
  out_.line(fmt::format("{:>10}{}", 1, "plate"));
  row({{"NSID", whole(free_set, 10)}, {"NSIDEX", whole(0, 10)}, {"BOXID", whole(0, 10)}});
  row({{"XT", narrow(tail.x())},
       {"YT", narrow(tail.y())},
       {"ZT", narrow(tail.z())},
       {"XH", narrow(head.x())},
       {"YH", narrow(head.y())},
       {"ZH", narrow(head.z())},
       {"FRIC", narrow(0.0)}});
}

void LsDynaDeck::damping() {
  const membrane::BagDescription& d = bag().model.description;
  const double rate = d.mass_damping * u_.time, beta = d.stiffness_damping / u_.time;
  const bool of_parts = deck_.scene->pendulum.has_value();  // of the bag alone, not of the pendulum
  if (rate > 0.0 && !of_parts) {
    keyword("DAMPING_GLOBAL");
    row({{"LCID", whole(0, 10)}, {"VALDMP", narrow(rate)}});
  }
  for (const DeckPart& p : deck_.parts) {
    if (rate > 0.0 && of_parts) {
      keyword("DAMPING_PART_MASS");
      row({{"PID", whole(p.id, 10)}, {"LCID", whole(constant_one, 10)}, {"SF", narrow(rate)}});
    }
    if (beta > 0.0 && !p.null_panel) {
      keyword("DAMPING_PART_STIFFNESS");
      row({{"PID", whole(p.id, 10)}, {"COEF", narrow(-beta)}});  // below zero: the coefficient itself
    }
  }
}

void LsDynaDeck::loads() {
  const Eigen::Vector3d g = deck_.scene->gravity / u_.acceleration();
  for (int axis = 0; axis < 3; ++axis) {
    if (g(axis) == 0.0) continue;
    keyword(fmt::format("LOAD_BODY_{}", "XYZ"[axis]));
    // The card is the acceleration of the frame, the load points the other way.
    row({{"LCID", whole(constant_one, 10)}, {"SF", narrow(-g(axis))}});
  }
}

void LsDynaDeck::requests() {
  const Scene& scene = *deck_.scene;
  constexpr int text_and_binary = 3;
  std::vector<const char*> histories{"GLSTAT", "MATSUM", "ABSTAT"};
  if (scene.pendulum)
    for (const char* name : {"RBDOUT", "JNTFORC", "NODOUT"}) histories.push_back(name);
  if (scene.contact) histories.push_back("RCFORC");
  if (!bag().model.description.plates.empty() && !bag_nodes(deck_, true).empty())
    histories.push_back("RWFORC");
  if (!bag().model.description.straps.empty()) histories.push_back("DEFORC");
  for (const char* name : histories) {
    keyword(fmt::format("DATABASE_{}", name));
    row({{"DT", narrow(scene.output.history_every / u_.time)}, {"BINARY", whole(text_and_binary, 10)}});
  }
  keyword("DATABASE_BINARY_D3PLOT");
  row({{"DT", narrow(scene.time.end / std::max(1, scene.output.frames) / u_.time)}});
  if (!scene.pendulum) return;
  keyword("DATABASE_HISTORY_NODE");
  row({{"ID1", whole(ids_.across, 10)}, {"ID2", whole(ids_.pivot, 10)}});
}

DeckFiles write_lsdyna(const Deck& deck, const Units& units) {
  return {{"bag.k", LsDynaDeck(deck, units).text()}};
}

}  // namespace driver
