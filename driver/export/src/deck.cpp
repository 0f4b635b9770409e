// SPDX-License-Identifier: Apache-2.0
#include "export/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <elementary/trigonometric.hpp>
#include <numbers>

#include "deck_gas.hpp"
#include "deck_impactor.hpp"
#include "export/cards.hpp"
#include "export/deck_fabric.hpp"
#include "jet/centreline.hpp"

namespace driver {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;

void add_parts(const BagPart& bag, Deck& deck) {
  const auto areas = mesh::element_areas(bag.mesh.nodes, bag.mesh.elements);
  for (std::size_t p = 0; p < bag.mesh.panel_names.size(); ++p) {
    DeckPart part{static_cast<int>(p) + 1, bag.mesh.panel_names[p], false, {}, {}, 0.0};
    part.elements = mesh::panel_elements(bag.mesh, part.name);
    if (part.elements.empty()) continue;
    part.fabric = bag.model.description.properties[static_cast<std::size_t>(part.elements.front())];
    part.null_panel = part.fabric.null_panel;
    for (const int e : part.elements) part.area += areas(e);
    deck.parts.push_back(std::move(part));
  }
}

void note_self_contact(const Scene& scene, Deck& deck) {
  const coupling::SkinContactParameters& p = scene.skin_contact->parameters();
  deck.notes.push_back(
      {"membrane.self_contact",
       fmt::format(
           "the case's pressure is {:.3g} N/m3 times what the distance of layers is below {:.3g} m; the "
           "program's own penalty is another one{}",
           p.stiffness, p.thickness,
           deck.format == DeckFormat::radioss
               ? ", and acts between nodes and elements: for edges add /INTER/TYPE11 by hand"
               : "")});
}

std::string jetting_of(DeckFormat format) {
  if (format == DeckFormat::lsdyna)
    return "The program's own jetting is a cone with an efficiency. How it loads an element is not published "
           "closely enough to state a misfit";
  const CosineMisfit misfit = cosine_misfit();
  return fmt::format(
      "The program's own jetting is proportional to the cosine of incidence, the jet's load to cos^2: they "
      "differ by {:.3g} of the load in the root mean square over all directions; the ratio is {:.3g}, {:.3g} "
      "and {:.3g} at 30, 45 and 60 degrees",
      misfit.rms, misfit.ratio[0], misfit.ratio[1], misfit.ratio[2]);
}

void note_jets(const Scene& scene, Deck& deck) {
  for (const JetPart& part : scene.jets) {
    const jet::JetModel& model = part.field.model();
    std::string text = fmt::format("jet of inflator {}: not written. ", part.name);
    if (model.shape == jet::OutletShape::round)
      text += fmt::format(
          "Its far field is the product of a function of the angle and a function of the distance, about a "
          "virtual origin {:.3g} m behind the outlet. ",
          jet::round_virtual_origin(model.decay_coefficient) * model.radius);
    deck.notes.push_back({"inflator.jet", text + jetting_of(deck.format)});
  }
}

}  // namespace

CosineMisfit cosine_misfit() {
  // int (c - c^2)^2 dc / int c^4 dc over c from 0 to 1: (1/3 - 2/4 + 1/5) / (1/5)
  return {std::sqrt((1.0 / 3.0 - 0.5 + 0.2) / 0.2),
          {1.0 / elementary::cos(30.0 * degrees), 1.0 / elementary::cos(45.0 * degrees),
           1.0 / elementary::cos(60.0 * degrees)}};
}

double run_end(const Scene& scene) {
  const double step = 0.01 * scene.time.end;  // largest step of the other program
  return scene.time.end + std::min(scene.output.history_every, 0.5 * scene.time.end) + step;
}

Deck make_deck(const Scene& scene, DeckFormat format) {
  if (!scene.bag)
    throw CaseError(fmt::format("{}: has no [membrane]: only scenes with a bag or a sheet can be exported",
                                scene.case_file.string()));
  if (scene.gas && scene.ambient.pressure == 0.0)
    throw CaseError(
        fmt::format("{}: ambient.pressure: is 0, allowed for decks: a number above 0, because their bags "
                    "begin with gas of that pressure",
                    scene.case_file.string()));
  Deck deck;
  deck.scene = &scene;
  deck.format = format;
  add_parts(*scene.bag, deck);
  if (scene.gas) add_gas(scene, deck);
  if (scene.bag->overpressure) deck.overpressure = knots_of(*scene.bag->overpressure, 0.0, scene.time.end);
  add_impactor(scene, deck);
  if (scene.skin_contact) note_self_contact(scene, deck);
  add_fabric(*scene.bag, deck);
  if (scene.name.size() > title_columns)
    deck.notes.push_back(
        {"scene.name", fmt::format("only the first {} bytes are in the title", title_columns)});
  if (scene.bag->overpressure)
    deck.notes.push_back(
        {"membrane.overpressure",
         "no history of displacements is requested: the pictures (output.frames) have them"});
  note_jets(scene, deck);
  return deck;
}

}  // namespace driver
