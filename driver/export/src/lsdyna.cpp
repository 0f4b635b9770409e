// SPDX-License-Identifier: Apache-2.0
// An LS-DYNA deck: bag.k.
#include "export/lsdyna.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "lsdyna_blocks.hpp"

namespace driver {
namespace {

const char* time_name(const Units& u) {
  return u.time == 1.0 ? "sec" : "ms";
}

const char* mass_name(const Units& u) {
  return u.mass == 1.0 ? "kg" : "mtrc_ton";
}

/// Writes the deck, one method a block.
class LsDynaDeck : private LsDynaIds {
 public:
  LsDynaDeck(const Deck& deck, const Units& units) : deck_(deck), u_(units), out_(units) {}
  std::string text();

 private:
  const BagPart& bag() const { return *deck_.scene->bag; }
  void head();
  void nodes();
  void supports();
  void plate(const membrane::Plate& wall);
  void damping();
  void self_contact();
  void pressure();
  void loads();
  void requests();

  const Deck& deck_;
  const Units& u_;
  LsDynaCards out_;
};

std::string LsDynaDeck::text() {
  head();
  nodes();
  write_lsdyna_fabric(deck_, out_);
  write_lsdyna_straps(deck_, out_);
  supports();
  if (deck_.impactor) write_lsdyna_impactor(deck_, out_);
  if (deck_.scene->skin_contact) self_contact();
  if (deck_.scene->gas) write_lsdyna_airbag(deck_, out_);
  loads();
  requests();
  out_.keyword("END");
  return out_.text();
}

void LsDynaDeck::head() {
  out_.keyword("KEYWORD");
  out_.keyword("TITLE");
  out_.label(deck_.scene->name, title_columns);
  out_.keyword("CONTROL_UNITS");
  out_.line(fmt::format("{:<10}{:<10}{:<10}{:<10}", u_.length_code, time_name(u_), mass_name(u_), "k"));
  out_.keyword("CONTROL_TERMINATION");
  out_.row({{"ENDTIM", narrow(run_end(*deck_.scene) / u_.time)}});
  out_.keyword("CONTROL_TIMESTEP");
  out_.row({{"DTINIT", narrow(0.0)}, {"TSSFAC", narrow(0.8)}});
  out_.keyword("CONTROL_ENERGY");
  out_.row(
      {{"HGEN", whole(2, 10)}, {"RWEN", whole(2, 10)}, {"SLNTEN", whole(2, 10)}, {"RYLEN", whole(2, 10)}});
  out_.curve(constant_one, {{0.0, 1.0}, {2.0 * deck_.scene->time.end, 1.0}}, u_.time, 1.0);
}

void LsDynaDeck::nodes() {
  out_.keyword("NODE");
  out_.line("$    NID               X               Y               Z");
  for (int i = 0; i < bag().mesh.node_count(); ++i) out_.node(i + 1, bag().initial_position.col(i));
}

void LsDynaDeck::supports() {
  out_.set("NODE", bag_set, bag_nodes(deck_, false));
  const auto free = bag_nodes(deck_, true);
  if (!free.empty()) out_.set("NODE", free_set, free);
  int next_set = first_held_set;
  for (const HeldNodes& held : held_nodes(deck_)) {
    out_.set("NODE", next_set, held.nodes);
    out_.keyword("BOUNDARY_SPC_SET");
    out_.row({{"NSID", whole(next_set++, 10)},
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
  out_.keyword("RIGIDWALL_PLANAR_ID");
  out_.line(fmt::format("{:>10}{}", 1, "plate"));
  out_.row({{"NSID", whole(free_set, 10)}, {"NSIDEX", whole(0, 10)}, {"BOXID", whole(0, 10)}});
  out_.row({{"XT", narrow(tail.x())},
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
  const bool of_parts = deck_.impactor.has_value();  // acts on the bag only, not on the impactor
  if (rate > 0.0 && !of_parts) {
    out_.keyword("DAMPING_GLOBAL");
    out_.row({{"LCID", whole(0, 10)}, {"VALDMP", narrow(rate)}});
  }
  for (const DeckPart& p : deck_.parts) {
    if (rate > 0.0 && of_parts) {
      out_.keyword("DAMPING_PART_MASS");
      out_.row({{"PID", whole(p.id, 10)}, {"LCID", whole(constant_one, 10)}, {"SF", narrow(rate)}});
    }
    if (beta > 0.0 && !p.null_panel) {
      out_.keyword("DAMPING_PART_STIFFNESS");
      out_.row({{"PID", whole(p.id, 10)}, {"COEF", narrow(-beta)}});  // below zero: the coefficient itself
    }
  }
}

void LsDynaDeck::self_contact() {
  constexpr int by_part_set = 2, of_segments = 2, as_at_start = 1;  // IGNORE: as (K.45)
  std::vector<int> fabric;
  for (const DeckPart& p : deck_.parts)
    if (!p.null_panel) fabric.push_back(p.id);
  out_.set("PART", fabric_parts, fabric);
  const coupling::SkinContactParameters& p = deck_.scene->skin_contact->parameters();
  out_.contact({.kind = "AIRBAG_SINGLE_SURFACE",
                .id = 2,
                .name = "bag against itself",
                .first = fabric_parts,
                .first_kind = by_part_set,
                .friction = p.friction,
                .thickness = p.thickness});
  out_.row({{"SOFT", whole(of_segments, 10)}});
  out_.row({{"PENMAX", narrow(0.0)}});
  out_.row({{"IGAP", whole(1, 10)}, {"IGNORE", whole(as_at_start, 10)}});
}

void LsDynaDeck::pressure() {
  const int curve = out_.next_curve();
  out_.curve(curve, *deck_.overpressure, u_.time, u_.pressure());
  std::vector<int> elements(static_cast<std::size_t>(bag().mesh.element_count()));
  std::iota(elements.begin(), elements.end(), 1);
  out_.set("SHELL", bag_shells, elements);
  constexpr double along_normals = -1.0;  // a positive pressure acts against them
  out_.keyword("LOAD_SHELL_SET_ID");
  out_.line(fmt::format("{:>10}{}", 1, "overpressure"));
  out_.row({{"ESID", whole(bag_shells, 10)},
            {"LCID", whole(curve, 10)},
            {"SF", narrow(along_normals)},
            {"AT", narrow(0.0)}});
}

void LsDynaDeck::loads() {
  if (deck_.overpressure) pressure();
  const Eigen::Vector3d g = deck_.scene->gravity / u_.acceleration();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    int curve = constant_one;
    double scale = g[static_cast<Eigen::Index>(axis)];
    if (!deck_.field[axis].empty()) {
      curve = out_.next_curve();
      out_.curve(curve, deck_.field[axis], u_.time, u_.acceleration());
      scale = 1.0;
    }
    if (scale == 0.0) continue;
    out_.keyword(fmt::format("LOAD_BODY_{}", "XYZ"[axis]));
    // The card gives the acceleration of the frame; the load points the other way.
    out_.row({{"LCID", whole(curve, 10)}, {"SF", narrow(-scale)}});
  }
}

void LsDynaDeck::requests() {
  const Scene& scene = *deck_.scene;
  constexpr int text_and_binary = 3;
  std::vector<const char*> histories{"GLSTAT", "MATSUM"};
  if (scene.gas) histories.push_back("ABSTAT");
  if (scene.has_impactor())
    for (const char* name : {"RBDOUT", "NODOUT"}) histories.push_back(name);
  if (scene.pendulum) histories.push_back("JNTFORC");
  if (scene.contact) histories.push_back("RCFORC");
  if (!bag().model.description.plates.empty() && !bag_nodes(deck_, true).empty())
    histories.push_back("RWFORC");
  const bool springs = deck_.impactor && !deck_.impactor->springs.empty();
  if (!bag().model.description.straps.empty() || springs) histories.push_back("DEFORC");
  for (const char* name : histories) {
    out_.keyword(fmt::format("DATABASE_{}", name));
    out_.row({{"DT", narrow(scene.output.history_every / u_.time)}, {"BINARY", whole(text_and_binary, 10)}});
  }
  out_.keyword("DATABASE_BINARY_D3PLOT");
  out_.row({{"DT", narrow(scene.time.end / std::max(1, scene.output.frames) / u_.time)}});
  if (!scene.has_impactor()) return;
  out_.keyword("DATABASE_HISTORY_NODE");
  const DeckIds ids(deck_);
  out_.row({{"ID1", whole(ids.centre, 10)}, {"ID2", whole(scene.pendulum ? ids.pivot : 0, 10)}});
}

}  // namespace

DeckFiles write_lsdyna(const Deck& deck, const Units& units) {
  return {{"bag.k", LsDynaDeck(deck, units).text()}};
}

}  // namespace driver
