// SPDX-License-Identifier: Apache-2.0
#include "engine/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <string_view>

#include "base/curve_reader.hpp"
#include "base/formats.hpp"
#include "base/number_text.hpp"
#include "base/progress.hpp"
#include "engine/channel_filter.hpp"
#include "scene/gas_curve.hpp"
#include "scene/plausibility.hpp"
#include "scene/read_bag.hpp"
#include "scene/read_gas.hpp"
#include "scene/read_jet.hpp"
#include "scene/read_pendulum.hpp"
#include "scene/read_target.hpp"

namespace driver {
namespace {

bool will_move(const TableReader& root) {
  return root.has("membrane") || root.has("pendulum") || root.has("impactor");
}

// What a molecule of air flies between two collisions, 68 nm at 464 m/s, takes a seventh of it: no gas flows
// in less.
constexpr Bounds shortest_run{1e-9, any_number.high, false, "1e-9 or more", "s"};

// Of the frame of a module that moves: the sled's deceleration acts on all that rides along.
void read_field(TableReader& scene_table, Scene& scene) {
  TableReader table = scene_table.table("gravity");
  const std::vector<double> times = table.at("time").numbers(any_number.in("s"));
  const std::vector<Eigen::Vector3d> rows = table.at("value").vectors("m/s²");
  if (times.size() != rows.size())
    table.fail("value", fmt::format("has {} rows, time has {}", rows.size(), times.size()));
  table.located("time", [&] {
    const auto component = [&](int c) {
      CurveData curve{times, {}};
      for (const Eigen::Vector3d& row : rows) curve.value.push_back(row[c]);
      return to_gas_curve(curve, gas::Outside::zero);
    };
    scene.field = {component(0), component(1), component(2)};
  });
  table.finish();
}

void read_general(TableReader& root, Scene& scene) {
  TableReader table = root.table("scene");
  table.at("format").integer(1, formats::case_file, 1);  // a file that does not say it is of the first
  scene.name = table.at("name").text();
  scene.time.end = table.at("end_time").number(shortest_run);
  if (table.has("gravity") && !will_move(root))
    table.fail("gravity", "has no effect: nothing moves; it needs [membrane], [pendulum] or [impactor]");
  if (table.is_table("gravity"))
    read_field(table, scene);
  else if (will_move(root))
    scene.gravity = table.at("gravity").vector("m/s²", Eigen::Vector3d::Zero());
  table.finish();
}

/// The table is finished by the gas, which reads the composition. None without gas.
std::optional<TableReader> read_ambient(TableReader& root, Scene& scene) {
  // The standard atmosphere at 20 degrees C where the case does not say.
  scene.ambient = {101325.0, 293.15};
  if (!root.has("gas")) {
    if (const auto table = root.optional_table("ambient")) table->fail("", "has no effect: it needs [gas]");
    return {};
  }
  TableReader table = *root.optional_table("ambient", true);
  scene.ambient.pressure = table.at("pressure").number(non_negative.in("Pa"), scene.ambient.pressure);
  // Before any curve is read.
  CurveReader::set_ambient_pressure(root, scene.ambient.pressure);
  scene.ambient.temperature = table.at("temperature").number(gas_temperature, scene.ambient.temperature);
  return table;
}

/// Method and steps of the gas.
void read_gas_time(TableReader& table, bool has_volume, Scene& scene) {
  for (const char* key : {"gas_tolerance", "gas_method", "gas_step"})
    if (table.has(key) && !has_volume) table.fail(key, "has no effect: the scene has no volume of gas");
  if (!has_volume) return;
  gas::IntegratorOptions& options = scene.gas->integrator;
  options.method = table.at("gas_method")
                       .choice<gas::Method>({{"dormand_prince", gas::Method::dormand_prince_5},
                                             {"runge_kutta", gas::Method::runge_kutta_4},
                                             {"euler", gas::Method::euler},
                                             {"rosenbrock", gas::Method::rosenbrock_4}},
                                            "dormand_prince");
  if (const auto step = table.at("gas_step").optional_number(positive.in("s"))) {
    if (table.has("gas_tolerance"))
      table.fail("gas_tolerance", "has no effect with gas_step: its sub-steps are fixed");
    options.fixed_step = *step;
    return;
  }
  options.relative_tolerance =
      table.at("gas_tolerance")
          .number(Bounds{1e-13, 1e-2, false, "1e-13 to 1e-2"}, options.relative_tolerance);
}

/// Steps of what moves.
void read_motion_time(TableReader& table, bool moves, Scene& scene) {
  for (const char* key : {"step", "safety", "unsafe_step"})
    if (table.has(key) && !moves)
      table.fail(key, "has no effect: nothing moves, and output.history_every is the step");
  if (!moves) return;
  scene.time.step = table.at("step").optional_number(
      Bounds{scene.time.end / 1e9, any_number.high, false, "a step of end_time / 1e9 or more", "s"});
  if (scene.time.step && table.has("safety"))
    table.fail("safety", "has no effect with step, which replaces it: leave out one of the two");
  if (!scene.time.step)
    scene.time.safety = table.at("safety").number(Bounds{1e-3, 1.0, false, "1e-3 to 1"}, scene.time.safety);
  scene.time.unsafe_step = table.at("unsafe_step").flag(false);
  if (scene.time.unsafe_step && !scene.time.step) table.fail("unsafe_step", "needs `step`");
}

void read_time(TableReader& root, Scene& scene) {
  TableReader table = *root.optional_table("time", true);
  read_motion_time(table, will_move(root), scene);
  read_gas_time(table, scene.gas && !root.has("target"), scene);
  table.finish();
}

bool can_name_a_column(const std::string& species) {
  return std::ranges::all_of(species, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           std::string_view("_+-.()").find(c) != std::string_view::npos;
  });
}

void read_streams(TableReader& table, Scene& scene) {
  if (!scene.has_volume()) {
    if (table.has("streams")) table.fail("streams", "has no effect: the scene has no volume of gas");
    return;
  }
  scene.output.streams = table.at("streams").flag(false);
  if (!scene.output.streams) return;
  const gas::Thermo& thermo = scene.gas->model.thermo;
  for (std::size_t k = 0; k < thermo.size(); ++k)
    if (const std::string& name = thermo.species(k).name; !can_name_a_column(name))
      table.fail(
          "streams",
          fmt::format("the species \"{}\" cannot name a column, allowed: letters, digits and _+-.()", name));
}

void read_channel_classes(TableReader& table, Scene& scene) {
  if (!scene.has_impactor()) {
    if (table.has("channel_classes")) table.fail("channel_classes", "the scene has no impactor");
    return;
  }
  scene.output.channel_classes = table.at("channel_classes").some_of(channel_classes);
  for (const int channel_class : scene.output.channel_classes)
    if (scene.time.step && *scene.time.step > widest_interval(channel_class) * (1.0 + 1e-12))
      table.fail("channel_classes",
                 fmt::format("{} needs steps of {:.3g} s or less, time.step is {} s", channel_class,
                             three_digits_below(widest_interval(channel_class)), *scene.time.step));
}

void read_output(TableReader& root, Scene& scene) {
  constexpr int default_rows = 1000;
  scene.output.history_every = scene.time.end / default_rows;
  TableReader table = *root.optional_table("output", true);
  const Bounds rows{scene.time.end / 1e7, any_number.high, false, "an interval of end_time / 1e7 or more",
                    "s"};
  scene.output.history_every =
      table.at("history_every").number(rows, scene.output.history_every, "end_time / 1000");
  scene.output.history_exact = table.at("history_exact").flag(false);
  const Bounds frames{scene.time.end / 1e5, any_number.high, false, "an interval of end_time / 1e5 or more",
                      "s"};
  scene.output.fields_every = table.at("fields_every").optional_number(frames).value_or(0.0);
  if (scene.output.fields_every > 0.0 && !scene.bag) table.fail("fields_every", "the scene has no membrane");
  scene.output.self_intersection_every =
      table.at("self_intersection_every").optional_number(frames).value_or(0.0);
  if (scene.output.self_intersection_every > 0.0 && !scene.bag)
    table.fail("self_intersection_every", "the scene has no membrane");
  const bool shows = scene.bag || scene.target;
  if (table.has("frames") && !shows) table.fail("frames", "the scene has no membrane and no target");
  if (shows) scene.output.frames = table.at("frames").integer(0, 10000, scene.output.frames);
  read_streams(table, scene);
  read_channel_classes(table, scene);
  table.finish();
}

void check_composition(const TableReader& root, const Scene& scene) {
  if (scene.bag && scene.gas && scene.gas->rigid_volume)
    root.fail("tank", "a scene has a [tank] or a [membrane], not both");
  if (scene.gas && !scene.has_volume() && !scene.target)
    root.fail("gas", "needs a volume, [tank] or [membrane], or a [target] for its jet");
  if (scene.target && scene.jets.empty())
    root.fail("target", "needs an inflator with a jet ([inflator.jet])");
  if (!scene.gas && !scene.moves() && !scene.target)
    root.fail("", "has nothing to simulate: add [gas], [membrane], [pendulum] or [impactor]");
  if (scene.gas && !scene.has_volume() && !scene.gas->model.vents.empty())
    root.fail("vent", "needs a volume, [tank] or [membrane]");
  if (scene.gas && !scene.has_volume() && scene.gas->model.triggers.size() > 0)
    root.fail(root.has("sensor") ? "sensor" : "trigger", "needs a volume, [tank] or [membrane]");
  if (scene.gas && !scene.gas->contact_sensors.empty() && !scene.contact)
    root.fail("sensor", "of contact: the scene has no [contact]");
  if (scene.has_impactor() && !scene.bag && !scene.time.step)
    root.fail("time", fmt::format("needs step for {} alone", scene.pendulum ? "a pendulum" : "an impactor"));
}

}  // namespace

namespace {

void read_parts(CaseDocument& document, const MeshReader& read_mesh, Scene& scene) {
  TableReader root = document.root();
  root.allow_only({"ambient", "contact", "fabric", "gas", "impactor", "inflator", "membrane", "output",
                   "pendulum", "scene", "sensor", "tank", "target", "time", "trigger", "vent"});
  read_general(root, scene);
  auto ambient = read_ambient(root, scene);
  auto inflators = root.tables("inflator");
  read_gas(root, ambient, inflators, scene);
  if (ambient) ambient->finish();
  read_time(root, scene);
  read_bag(root, read_mesh, scene);
  read_target(root, scene);
  for (std::size_t i = 0; i < inflators.size(); ++i) {
    read_jets(inflators[i], i, scene);
    inflators[i].finish();
  }
  read_pendulum(root, scene);
  read_output(root, scene);
  root.finish();
  check_composition(root, scene);
}

// What is refused may follow from a number in another unit: so the warnings are told with it.
[[noreturn]] void refuse(const CaseError& error, const Scene& scene) {
  std::string text = error.what();
  for (const std::string& warning : scene.warnings) text += "\nwarning: " + warning;
  throw CaseError(text);
}

Scene scene_of(CaseDocument& document, const MeshReader& read_mesh) {
  Scene scene;
  scene.case_file = document.file();
  try {
    read_parts(document, read_mesh, scene);
  } catch (const CaseError& error) {
    warn_of_units(scene);
    refuse(error, scene);
  }
  warn_of_units(scene);
  warn_of_idle_parts(scene);
  return scene;
}

}  // namespace

Scene read_scene(CaseDocument& document, const MeshReader& read_mesh) {
  try {
    return scene_of(document, read_mesh);
  } catch (const std::bad_alloc& error) {
    const std::string last = document.keys().empty() ? "the case" : document.keys().back().path;
    throw OutOfMemory(fmt::format("{}: {}: {}", document.file().string(), last, text_of(error)));
  }
}

}  // namespace driver
