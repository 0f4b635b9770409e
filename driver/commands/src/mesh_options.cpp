// SPDX-License-Identifier: Apache-2.0
#include "mesh_options.hpp"

#include <fmt/format.h>

#include <string>

#include "engine/bag_holes.hpp"
#include "results/bag_shape.hpp"
#include "results/mesh_reader.hpp"
#include "validators.hpp"

namespace driver::commands {

namespace {

void add_fold(CLI::App& mesh, MeshArguments& arguments) {
  auto* fold = mesh.add_subcommand("fold", "fold a bag and report on its strain; write the start shape");
  FoldArguments& a = arguments.fold;
  fold->add_option("BAG", arguments.file, std::string("case file (TOML), or mesh file: ") + mesh_endings)
      ->required();
  fold->add_flag("--press", a.press, "first lay the two sheets of the bag on each other");
  auto* letter = fold->add_flag("--letter", a.letter, "lay one flap of each side over the middle");
  auto* accordion = fold->add_flag("--accordion", a.accordion, "fold panels to and fro");
  auto* roll = fold->add_flag("--roll", a.roll, "lay the outermost panel over the next one, and so on");
  letter->excludes(accordion)->excludes(roll);
  accordion->excludes(roll);
  fold->add_option("--axis", a.axis, "axis across the fold lines: x, y or z")
      ->check(CLI::IsMember({"x", "y", "z"}));
  fold->add_option("--at", a.at, "fold lines along that axis [m], with commas between them")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("POSITIONS");
  fold->add_option("--gap", a.gap, "least distance between layers [m]")->check(positive);
  fold->add_option("--easing", a.easing,
                   "transition between bend and free fabric, in element lengths; default: 2")
      ->check(not_negative);
  fold->add_option("--flatten", a.flatten, "flatten a mesh file first: factor of x")->check(positive);
  fold->add_option("--fixed", a.fixed, "panel of a mesh file that stays; may be repeated")
      ->allow_extra_args(false)
      ->option_text("PANEL");
  fold->add_option("--design", a.design, "stress-free shape, if the mesh file is a start shape")
      ->check(named);
  fold->add_option("--set", arguments.overrides, "key of the case=value; may be repeated")
      ->allow_extra_args(false)
      ->option_text("KEY=VALUE");
  fold->add_option("--out", arguments.out, "start shape, .obj, .stl, or LS-DYNA keyword .k, .key, .dyn")
      ->required()
      ->check(named);
}

}  // namespace

void add_mesh(CLI::App& app, MeshArguments& arguments) {
  auto* mesh = app.add_subcommand("mesh", "generate or convert an airbag mesh and report on it");
  mesh->require_subcommand(1);
  auto* bag =
      mesh->add_subcommand("driver", "driver bag: two discs sewn at the rim, attachment, vents, tethers");
  auto* passenger = mesh->add_subcommand("passenger", "passenger bag: main and side panels, one vent");
  auto* convert =
      mesh->add_subcommand("convert", "read a mesh file and report on it; write it in the format of --out");
  auto* of_case = mesh->add_subcommand("case", "write the mesh that a case runs with");
  add_fold(*mesh, arguments);
  auto* state = mesh->add_subcommand("state", "write the shape of a run's bag at one time");
  state->add_option("RESULTS", arguments.file, "folder of `gasjet run`")->required();
  state->add_option("--time", arguments.time, "time [s]; the nearest stored shape is used")
      ->required()
      ->check(not_negative);
  state->add_option("--out", arguments.out, std::string("file to write: ") + shape_endings)
      ->required()
      ->check(named);
  const char* formats = ".obj, .stl, or LS-DYNA keyword .k, .key, .dyn";
  bag->add_option("--out", arguments.out, std::string("design shape, ") + formats)->required()->check(named);
  bag->add_option("--initial", arguments.initial, "initial shape, of the same formats")->check(named);
  of_case->add_option("CASE", arguments.file, "case file (TOML)")->required();
  of_case->add_option("--initial", arguments.initial, "initial shape, of the same formats")->check(named);
  for (auto* command : {of_case, passenger})
    command->add_option("--out", arguments.out, std::string("design shape, ") + formats)
        ->required()
        ->check(named);
  convert->add_option("FILE", arguments.file, mesh_endings)->required();
  convert
      ->add_option("--panel", arguments.panels,
                   "panel, or part of a deck, to keep; may be repeated; default: all")
      ->allow_extra_args(false)
      ->option_text("NAME");  // and not several
  convert->add_option("--merge", arguments.merge, "join nodes within this distance [m]")->check(not_negative);
  convert->add_flag("--outward", arguments.outward, "turn elements so that the surface is wound outward");
  convert
      ->add_option("--cap", arguments.caps,
                   "close all holes, or the one of this number or node set in the report, by a null panel; "
                   "may be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME[=HOLE|SET]");
  convert
      ->add_option("--cap-length", arguments.cap_length,
                   fmt::format("longest hole to close [m]; default: {}", longest_hole))
      ->check(positive);
  convert->add_flag("--report", arguments.report,
                    "report only: an open or inside-out surface is not an error");
  convert->add_option("--out", arguments.out, "file to write; without it only report")->check(named);
  convert
      ->add_option("--initial", arguments.initial,
                   "file for the initial shape, if a deck also has a stress-free shape")
      ->check(named);
  convert->add_option("--length-unit", arguments.length_unit, "length unit of FILE [m]")->check(positive);
  convert->add_option("--null-panel", arguments.null_panels, "panel that closes a hole; may be repeated")
      ->allow_extra_args(false)
      ->option_text("NAME");
  for (auto* command : {bag, passenger, of_case})
    command
        ->add_option("--set", arguments.overrides,
                     "option=value of the generator or the case; may be repeated")
        ->allow_extra_args(false)
        ->option_text("KEY=VALUE");
  for (auto* command : {bag, passenger, convert})
    command->add_option("--refine", arguments.refine, "number of times that each element is split in four")
        ->check(CLI::Range(0, 6));
}

int dispatch_mesh(const CLI::App& mesh, const MeshArguments& arguments) {
  if (mesh.got_subcommand("driver")) return mesh_driver(arguments);
  if (mesh.got_subcommand("case")) return mesh_of_case(arguments);
  if (mesh.got_subcommand("state")) return mesh_of_state(arguments);
  if (mesh.got_subcommand("fold")) return mesh_fold(arguments);
  return mesh.got_subcommand("passenger") ? mesh_passenger(arguments) : mesh_convert(arguments);
}

}  // namespace driver::commands
