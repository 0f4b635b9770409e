// SPDX-License-Identifier: Apache-2.0
#include "scene/read_jet.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/supply.hpp"
#include "jet/centreline.hpp"
#include "scene/gas_curve.hpp"
#include "scene/outlet_place.hpp"
#include "scene/outlet_ring.hpp"

namespace driver {
namespace {

const Bounds above_zero_or_type{positive.low, positive.high, true, "a number above 0 (or outlet_type)"};
// Of a case that names neither.
const Bounds round_or_type{positive.low, positive.high, true,
                           "a number above 0 (0.06 to 0.12 are usual), or outlet_type = "
                           "\"contracting_nozzle\", \"cylindrical_tube\" or \"guide_vane_fan\","},
    plane_or_type{positive.low, positive.high, true,
                  "a number above 0 (0.09 to 0.16 are usual), or outlet_type = \"plane_nozzle\", "
                  "\"sharp_slot\" or \"rounded_slot\","};
const Bounds below_one{0.0, std::nextafter(1.0, 0.0), false, "a number from 0 to below 1"};
const Bounds restitution_range{-0.5, 4.0, false, "a number from -0.5 to 4"};
const Bounds below_right_angle{0.0, std::nextafter(0.5 * std::numbers::pi, 0.0), false, "0 to below pi/2",
                               "rad"};

// The coefficient of a kind of outlet, or a number.
double read_decay_coefficient(TableReader& table, jet::OutletShape shape) {
  using Type = jet::OutletType;
  const bool has_number = table.has("decay_coefficient");
  if (!table.has("outlet_type"))
    return table.at("decay_coefficient")
        .number(has_number                         ? above_zero_or_type
                : shape == jet::OutletShape::round ? round_or_type
                                                   : plane_or_type);
  if (has_number) table.fail("outlet_type", "is given with decay_coefficient: leave out one of the two");
  return jet::decay_coefficient(shape == jet::OutletShape::round
                                    ? table.at("outlet_type")
                                          .choice<Type>({{"contracting_nozzle", Type::contracting_nozzle},
                                                         {"cylindrical_tube", Type::cylindrical_tube},
                                                         {"guide_vane_fan", Type::guide_vane_fan}})
                                    : table.at("outlet_type")
                                          .choice<Type>({{"plane_nozzle", Type::plane_nozzle},
                                                         {"sharp_slot", Type::sharp_slot},
                                                         {"rounded_slot", Type::rounded_slot}}));
}

jet::JetModel read_model(TableReader& table) {
  jet::JetModel model;
  model.shape = table.at("shape").choice<jet::OutletShape>(
      {{"round", jet::OutletShape::round}, {"rectangular", jet::OutletShape::rectangular}});
  model.centre = table.at("centre").vector("m");
  model.axis = table.at("axis").vector("");
  if (model.shape == jet::OutletShape::round) {
    model.radius = table.at("radius").number(positive.in("m"));
  } else {
    model.long_direction = table.at("long_direction").vector("");
    model.long_side = table.at("long_side").number(positive.in("m"));
    model.short_side = table.at("short_side").number(positive.in("m"));
    if (model.short_side > model.long_side) table.fail("short_side", "is longer than long_side");
  }
  model.decay_coefficient = read_decay_coefficient(table, model.shape);
  model.spread = table.at("spread").choice<jet::Spread>(
      {{"momentum", jet::Spread::momentum}, {"cone", jet::Spread::cone}}, "momentum");
  if (model.spread == jet::Spread::cone) {
    model.cone_initial_width = table.at("cone_initial_width").number(positive.in("m"));
    model.cone_half_angle = table.at("cone_half_angle").number(below_right_angle);
  }
  model.direction = table.at("direction")
                        .choice<jet::Direction>(
                            {{"axial", jet::Direction::axial}, {"radial", jet::Direction::radial}}, "axial");
  model.cut_off = table.at("cut_off").number(below_one, model.cut_off);
  model.relative_to_skin = table.at("relative_to_skin").flag(false);
  return model;
}

// A number goes to the model; a curve is returned, with its first value in the model.
std::optional<gas::Curve> read_restitution(TableReader& table, bool has_volume, jet::JetModel& model) {
  const CurveData data =
      CurveReader(table, "restitution").curve(restitution_range, "mass_ratio", model.restitution);
  if (!data.time.empty() && data.time.front() < 0.0)
    table.fail("restitution",
               fmt::format("begins at a mass_ratio of {:.3g}, allowed: 0 or more: injected over "
                           "contained mass",
                           data.time.front()));
  const gas::Curve curve = to_gas_curve(data, gas::Outside::held);
  model.restitution = curve.value(0.0);
  if (curve.is_constant()) return {};
  if (!has_volume)
    table.fail("restitution",
               "is a curve over injected by contained mass, but the scene has no volume of gas; a number is "
               "allowed");
  return curve;
}

jet::OutletModel read_outlet(TableReader& table, const jet::JetModel& model, const Scene& scene) {
  jet::OutletModel outlet;
  outlet.law =
      table.at("outlet").choice<jet::OutletLaw>({{"sonic", jet::OutletLaw::sonic},
                                                 {"pressure_matched", jet::OutletLaw::pressure_matched},
                                                 {"expanded", jet::OutletLaw::expanded}},
                                                "sonic");
  if (outlet.law == jet::OutletLaw::expanded && model.spread == jet::Spread::cone)
    table.fail("spread",
               "is \"cone\", whose force is not the outlet's momentum; with outlet = \"expanded\" "
               "\"momentum\" is allowed");
  outlet.temperature =
      table.at("temperature")
          .choice<jet::OutletTemperature>({{"static", jet::OutletTemperature::static_value},
                                           {"stagnation", jet::OutletTemperature::stagnation}},
                                          "static");
  if (outlet.law != jet::OutletLaw::sonic && outlet.temperature == jet::OutletTemperature::static_value)
    table.fail(
        "temperature",
        "is \"static\", the default; outlet = \"pressure_matched\" or \"expanded\" needs \"stagnation\": the "
        "inflator's temperature is then that of the gas at rest");
  const double around = scene.has_volume() ? scene.gas->initial_pressure : scene.ambient.pressure;
  if (outlet.law != jet::OutletLaw::sonic && !(around > 0.0))
    table.fail("outlet", fmt::format("needs a pressure around the outlet, but {} is 0; allowed: \"sonic\"",
                                     scene.has_volume() ? "gas.initial.pressure" : "ambient.pressure"));
  outlet.area = jet::outlet_area(model);
  if (!(outlet.area > 0.0 && std::isfinite(outlet.area)))
    table.fail(model.shape == jet::OutletShape::round ? "radius" : "short_side",
               fmt::format("makes an outlet of {:.3g} m2, allowed: a finite area above 0", outlet.area));
  table.located("temperature", [&] { jet::validate(outlet); });
  return outlet;
}

// The jet at its inflator's peak: an expanded one is wider than its outlet.
jet::JetModel at_peak(const Scene& scene, const JetPart& part) {
  const gas::InflatorPoint gas = outlet_peak(scene, part).point;
  const jet::OutletState outlet = jet::outlet_state(
      part.outlet, {gas.mass_flow, gas.temperature, gas.cp, gas.gas_constant, pressure_around(scene)});
  return jet::widened(part.field.model(), outlet.area_ratio);
}

void warn_of_square_nozzle(const jet::JetModel& model, const std::string& name,
                           std::vector<std::string>& warnings) {
  if (model.shape == jet::OutletShape::rectangular && model.short_side > model.long_side)
    warnings.push_back(fmt::format(
        "jet of inflator {}: its expansion makes the short side {:.3g} m at the peak, more than the long "
        "side of "
        "{:.3g} m, along which a wedge stays as it is: a round outlet of the same area spreads to all sides",
        name, model.short_side, model.long_side));
}

// Elements wider than the jet at its outlet sample it by chance; those of null panels do not.
void warn_if_coarse(const jet::JetModel& model, const JetPart& part, const Eigen::Matrix3Xd& nodes,
                    const Eigen::Matrix3Xi& elements, const std::vector<int>& null_elements, int subdivisions,
                    std::vector<std::string>& warnings) {
  double longest = 0.0;
  for (int e = 0; e < elements.cols(); ++e)
    for (int i = 0; i < 3 && !std::ranges::binary_search(null_elements, e); ++i)
      longest = std::max(longest, (nodes.col(elements(i, e)) - nodes.col(elements((i + 1) % 3, e))).norm());
  longest /= subdivisions;
  const double width = jet::section(model, 0.0).width;
  if (longest > 1.5 * width)
    warnings.push_back(fmt::format(
        "jet of inflator {}: element sides of up to {:.3g} m are too coarse for its width of {:.3g} m (1/e) "
        "at the outlet, so its force depends on where nodes happen to lie: use finer elements or "
        "{}.subdivisions",
        part.name, longest, width, part.path));
}

// A target behind the outlet, or facing the wrong way, would feel nothing: a slip.
void require_target_ahead(const TableReader& table, const jet::JetModel& model, const TargetPart& target) {
  const Eigen::Vector3d a = target.nodes.col(target.triangles(0, 0)),
                        b = target.nodes.col(target.triangles(1, 0)),
                        c = target.nodes.col(target.triangles(2, 0));
  if (!((b - a).cross(c - a).dot(model.axis) > 0.0))
    table.fail("axis", "does not meet the target's face: turn the target's normal away from the jet");
  if (!((model.axis.transpose() * (target.nodes.colwise() - model.centre)).maxCoeff() > 0.0))
    table.fail("centre", "lies behind the whole target: the jet would not reach it");
}

std::vector<int> attachment_elements(TableReader& table, const Scene& scene) {
  std::vector<int> elements;
  const auto panels = table.at("attachment_panels").texts();
  if (!panels.empty() && !scene.bag) table.fail("attachment_panels", "the scene has no membrane");
  table.located("attachment_panels", [&] {
    for (const auto& name : panels)
      for (const int element : mesh::panel_elements(scene.bag->mesh, name)) elements.push_back(element);
  });
  return elements;
}

// What warns, warns once for a ring.
void check_jet(TableReader& table, const JetPart& part, int subdivisions, bool first, Scene& scene) {
  const auto& elements = scene.bag ? scene.bag->mesh.elements : scene.target->triangles;
  const auto& nodes = scene.bag ? scene.bag->mesh.nodes : scene.target->nodes;
  const jet::JetModel& model = part.field.model();
  const jet::JetModel widest = at_peak(scene, part);
  if (first) {
    warn_of_square_nozzle(widest, part.name, scene.warnings);
    warn_if_coarse(widest, part, nodes, elements, scene.bag ? scene.bag->null_elements : std::vector<int>{},
                   subdivisions, scene.warnings);
  }
  if (scene.target) require_target_ahead(table, model, *scene.target);
  if (!scene.bag) return;
  table.located("centre", [&] {
    if (const auto thickness = require_outlet_inside(model, *scene.bag); thickness && first)
      scene.warnings.push_back(
          fmt::format("jet of inflator {}: its outlet is wider than the bag at the start, {:.3g} m thick "
                      "there: what blows beside the skin pushes nothing until the bag has opened",
                      part.name, *thickness));
  });
}

// All jets of a scene work alike.
void read_jet_work(TableReader& table, const jet::OutletModel& outlet, Scene& scene) {
  const auto work =
      table.at("jet_work")
          .choice<JetWork>({{"external", JetWork::external}, {"from_gas", JetWork::from_gas}}, "external");
  if (work == JetWork::from_gas && outlet.temperature != jet::OutletTemperature::stagnation)
    table.fail("jet_work",
               "\"from_gas\" needs temperature = \"stagnation\": with a static temperature the inflator's "
               "enthalpy does not include the jet's kinetic energy");
  if (!scene.jets.empty() && work != scene.jet_work)
    table.fail("jet_work",
               fmt::format("differs from that of {}: all jets need the same", scene.jets.front().path));
  scene.jet_work = work;
}

// An outlet, or a ring.
void read_outlets(TableReader& table, std::size_t inflator, const std::string& name, double share,
                  Scene& scene) {
  if (!scene.bag && !scene.target) table.fail("", "needs a [membrane] or a [target]");
  jet::JetModel model = read_model(table);
  std::optional<gas::Curve> restitution = read_restitution(table, scene.bag.has_value(), model);
  std::vector<jet::JetModel> ring = read_ring(table, model);
  table.located("", [&] {
    for (jet::JetModel& of_hole : ring) of_hole = jet::validated(of_hole);
  });
  const std::vector<int> attachment = attachment_elements(table, scene);
  const std::vector<int> null_elements = scene.bag ? scene.bag->null_elements : std::vector<int>{};
  const auto& elements = scene.bag ? scene.bag->mesh.elements : scene.target->triangles;
  const auto nodes = static_cast<int>((scene.bag ? scene.bag->mesh.nodes : scene.target->nodes).cols());
  const int subdivisions = table.at("subdivisions").integer(1, 64, 1);
  std::optional<jet::Subdivision> pieces;
  if (subdivisions > 1) table.located("subdivisions", [&] { pieces.emplace(elements, nodes, subdivisions); });
  jet::SurfaceRoles roles{null_elements, attachment};
  if (pieces) roles = {pieces->pieces_of(null_elements), pieces->pieces_of(attachment)};
  const Eigen::Matrix3Xi seen = pieces ? pieces->triangles() : elements;
  std::optional<JetPart> part;
  table.located("", [&] {
    const jet::OutletModel outlet = read_outlet(table, ring.front(), scene);
    auto query =
        std::make_shared<const jet::VisibilityQuery>(seen, pieces ? pieces->node_count() : nodes, roles);
    jet::JetField field(ring.front(), static_cast<int>(seen.cols()), roles.null_elements);
    part.emplace(JetPart{inflator, name, table.path(), share / static_cast<double>(ring.size()),
                         std::move(pieces), std::move(field), outlet, std::move(restitution),
                         std::move(roles), std::move(query)});
  });
  part->occlusion = table.at("occlusion").flag(true);
  part->route = table.at("visibility")
                    .choice<jet::VisibilityRoute>({{"fast", jet::VisibilityRoute::fast},
                                                   {"cgal_tree", jet::VisibilityRoute::cgal_tree},
                                                   {"brute_force", jet::VisibilityRoute::brute_force}},
                                                  "fast");
  if (!jet::has_route(part->route))
    table.fail("visibility",
               "\"cgal_tree\" is not part of this program (the command gasjet has it), allowed: \"fast\" "
               "and \"brute_force\"");
  read_jet_work(table, part->outlet, scene);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    JetPart hole = *part;
    hole.field = jet::JetField(ring[k], static_cast<int>(seen.cols()), hole.roles.null_elements);
    if (ring.size() > 1) hole.name += fmt::format(".{}", k);
    check_jet(table, hole, subdivisions, k == 0, scene);
    scene.jets.push_back(std::move(hole));
  }
  table.finish();
}

}  // namespace

void read_jets(TableReader& inflator, std::size_t index, Scene& scene) {
  if (!inflator.has("jet") || inflator.is_table("jet")) {
    if (auto table = inflator.optional_table("jet"))
      read_outlets(*table, index, std::to_string(index), 1.0, scene);
    return;
  }
  std::vector<TableReader> tables = inflator.tables("jet");
  std::vector<double> shares;
  for (TableReader& table : tables) shares.push_back(table.at("share").number(positive_fraction));
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(std::abs(sum - 1.0) <= 1e-6))
    tables.back().fail("share", fmt::format("the shares of all outlets sum to {:.6g}, needed: 1", sum));
  for (std::size_t k = 0; k < tables.size(); ++k)
    read_outlets(tables[k], index, fmt::format("{}.{}", index, k), shares[k] / sum, scene);
}

}  // namespace driver
