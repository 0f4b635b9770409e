// SPDX-License-Identifier: Apache-2.0
// A Radioss deck: starter file bag_0000.rad and engine file bag_0001.rad.
#include "export/radioss.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "radioss_blocks.hpp"

namespace driver {
namespace {

/// Writes the starter file, one method a block.
class RadiossStarter : private RadiossIds {
 public:
  RadiossStarter(const Deck& deck, const Units& units) : deck_(deck), u_(units), out_(units) {}
  std::string text();

 private:
  const BagPart& bag() const { return *deck_.scene->bag; }
  void head();
  void nodes();
  void supports();
  void surfaces();
  void self_contact();
  void pressure();
  void loads();
  void requests();
  void request(std::string_view header, std::string_view variables, int object);

  const Deck& deck_;
  const Units& u_;
  RadiossCards out_;
};

std::string RadiossStarter::text() {
  head();
  nodes();
  write_radioss_fabric(deck_, out_);
  write_radioss_straps(deck_, out_);
  supports();
  if (deck_.impactor) write_radioss_impactor(deck_, out_);
  surfaces();
  if (deck_.scene->skin_contact) self_contact();
  if (deck_.scene->gas) write_radioss_airbag(deck_, out_);
  loads();
  requests();
  out_.line("/END");
  return out_.text();
}

void RadiossStarter::head() {
  out_.line("#RADIOSS STARTER");
  out_.title("/BEGIN", deck_.scene->name);
  constexpr int format = 2022;
  out_.card({whole(format, 10), whole(0, 10)});
  for (int i = 0; i < 2; ++i)
    out_.card({word(u_.mass_code, 20), word(u_.length_code, 20), word(u_.time_code, 20)});
  out_.function("one", {{0.0, 1.0}, {2.0 * deck_.scene->time.end, 1.0}}, u_.time, 1.0);
}

void RadiossStarter::nodes() {
  out_.line("/NODE");
  out_.line("#  node_ID                  Xc                  Yc                  Zc");
  for (int i = 0; i < bag().mesh.node_count(); ++i) out_.node(i + 1, bag().initial_position.col(i));
}

void RadiossStarter::supports() {
  out_.group(all_nodes, "bag", bag_nodes(deck_, false));
  const auto free = bag_nodes(deck_, true);
  if (!free.empty()) out_.group(free_nodes, "free nodes of the bag", free);
  int id = first_held_nodes;
  for (const HeldNodes& held : held_nodes(deck_)) {
    out_.group(static_cast<Group>(id), held.fixed() ? "fixed nodes" : "sliding nodes", held.nodes);
    const auto code = fmt::format("{:d}{:d}{:d} 000", held.along[0], held.along[1], held.along[2]);
    out_.hold(id, code, static_cast<Group>(id));
    ++id;
  }
  for (const membrane::Plate& plate : bag().model.description.plates) {
    if (free.empty()) break;
    out_.title("/RWALL/PLANE/1", "plate");
    out_.line("#  node_ID     Slide  grnd_ID1  grnd_ID2");
    out_.card({whole(0, 10), whole(0, 10), whole(free_nodes, 10), whole(0, 10)});
    out_.line("#                  d                fric            Diameter");
    out_.card({real(0.0, 20), real(0.0, 20), real(0.0, 20)});
    out_.line("#                 XM                  YM                  ZM");
    out_.point(plate.point);
    out_.line("#                XM1                 YM1                 ZM1");
    out_.point(plate.point + plate.normal.normalized());
  }
  const double alpha = bag().model.description.mass_damping, beta = bag().model.description.stiffness_damping;
  if (alpha > 0.0 || beta > 0.0) {
    out_.title("/DAMP/1", "damping");
    out_.line(
        "#              Alpha                Beta  grnod_ID   skew_ID              Tstart               "
        "Tstop");
    out_.card({real(alpha * u_.time, 20), real(beta / u_.time, 20), whole(all_nodes, 10), whole(0, 10),
               real(0.0, 20), real(1e20, 20)});
  }
}

void RadiossStarter::surfaces() {
  std::vector<int> parts;
  for (const DeckPart& p : deck_.parts) parts.push_back(p.id);
  out_.title("/SURF/PART/1", "bag");
  out_.list(parts, 10);
}

void RadiossStarter::self_contact() {
  constexpr int surface = 3, softer_side = 4, gap_of_start = 6;  // 6: as (K.45), with a little room
  std::vector<int> fabric;
  for (const DeckPart& p : deck_.parts)
    if (!p.null_panel) fabric.push_back(p.id);
  out_.title(fmt::format("/SURF/PART/{}", surface), "fabric");
  out_.list(fabric, 10);
  const coupling::SkinContactParameters& p = deck_.scene->skin_contact->parameters();
  out_.contact({.id = 2,
                .name = "bag against itself",
                .surface = surface,
                .friction = p.friction,
                .gap = p.thickness,
                .stiffness = softer_side,
                .at_start = gap_of_start});
}

void RadiossStarter::pressure() {
  const int curve = out_.function("overpressure", *deck_.overpressure, u_.time, u_.pressure());
  constexpr int without_end = 2;
  out_.title("/PLOAD/1", "overpressure, along the normals of the elements");
  out_.line(
      "#  surf_ID  functIDT sensor_ID    Ipinch      Idel                      Ascale_x            Fscale_y");
  out_.card({whole(bag_surface, 10), whole(curve, 10), whole(0, 10), whole(0, 10), whole(without_end, 10),
             blank(10), real(1.0, 20), real(1.0, 20)});
}

void RadiossStarter::loads() {
  if (deck_.overpressure) pressure();
  const Eigen::Vector3d g = deck_.scene->gravity / u_.acceleration();
  const auto is_zero = [](const DeckCurve& curve) { return curve.empty(); };
  if (g.isZero(0.0) && std::ranges::all_of(deck_.field, is_zero)) return;
  std::vector<int> heavy = bag_nodes(deck_, false);
  if (deck_.impactor) heavy.push_back(DeckIds(deck_).cg);
  out_.group(heavy_nodes, "nodes with weight", heavy);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    int curve = constant_one;
    double scale = g[static_cast<Eigen::Index>(axis)];
    if (!deck_.field[axis].empty()) {
      curve = out_.function("gravity over time", deck_.field[axis], u_.time, u_.acceleration());
      scale = 1.0;
    }
    if (scale == 0.0) continue;
    out_.title(fmt::format("/GRAV/{}", axis + 1), "gravity");
    out_.line(
        "#funct_IDT       DIR   skew_ID sensor_ID  grnod_ID                      Ascale_x            "
        "Fscale_Y");
    out_.card({whole(curve, 10), word(std::string(1, "XYZ"[axis]), 10), whole(0, 10), whole(0, 10),
               whole(heavy_nodes, 10), blank(10), real(1.0, 20), real(scale, 20)});
  }
}

void RadiossStarter::request(std::string_view header, std::string_view variables, int object) {
  out_.title(std::string(header), "history");
  out_.line(variables);
  out_.card({whole(object, 10)});
}

void RadiossStarter::requests() {
  if (deck_.scene->gas) request("/TH/MONV/1", "MASS      VOL       P         A         T         ", 1);
  if (deck_.scene->body)
    request("/TH/RBODY/5", "DX        DY        DZ        VX        VY        VZ        ", 1);
  if (deck_.impactor)
    request("/TH/RBODY/2",
            "RX        RY        RZ        VRX       VRY       VRZ       AX        AY        AZ        ", 1);
  if (deck_.scene->contact) request("/TH/INTER/3", "DEF       ", 1);
  if (!bag().model.description.plates.empty() && !bag_nodes(deck_, true).empty())
    request("/TH/RWALL/4", "DEF       ", 1);
}

std::string engine(const Deck& deck, const Units& u, const std::string& name) {
  Cards out;
  const Scene& scene = *deck.scene;
  out.line(fmt::format("/RUN/{}/1", name));
  out.card({real(run_end(scene) / u.time, 20)});
  out.line("/TFILE/4");
  out.card({real(scene.output.history_every / u.time, 20)});
  out.line("/TH/TITLE");
  out.line("/PRINT/-1000");
  out.line("/DT");
  out.card({real(0.8, 20), real(0.0, 20)});
  out.line("/ANIM/DT");
  out.card({real(0.0, 20), real(scene.time.end / std::max(1, scene.output.frames) / u.time, 20)});
  return out.text();
}

}  // namespace

DeckFiles write_radioss(const Deck& deck, const Units& units) {
  const std::string name = "bag";
  return {{name + "_0000.rad", RadiossStarter(deck, units).text()},
          {name + "_0001.rad", engine(deck, units, name)}};
}

}  // namespace driver
