// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <numbers>
#include <utility>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "commands/command.hpp"
#include "engine/bag_holes.hpp"
#include "engine/bag_mesh.hpp"
#include "input_files.hpp"
#include "mesh/merge.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/turn_outward.hpp"
#include "mesh_caps.hpp"
#include "results/bag_shape.hpp"
#include "results/fields.hpp"
#include "results/load_scene.hpp"
#include "results/mesh_reader.hpp"
#include "results/results.hpp"

namespace driver::commands {
namespace {

// Sets the member named `key`; false if there is none.
template <class Options, class Number>
bool assign(Options& options, const std::vector<std::pair<const char*, Number Options::*>>& names,
            const std::string& key, const std::string& text, const std::string& value) {
  for (const auto& [name, member] : names) {
    if (key != name) continue;
    const char* end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, options.*member);
    if (error != std::errc{} || stop != end)
      throw CaseError(fmt::format("--set {}: allowed: a {}", text,
                                  std::is_integral_v<Number> ? "whole number" : "number"));
    return true;
  }
  return false;
}

template <class Options>
BagMesh generate_with(const std::vector<std::string>& overrides) {
  Options options;
  const auto& names = option_names(options);
  for (const auto& text : overrides) {
    const auto equals = std::min(text.find('='), text.size());
    const std::string key = text.substr(0, equals), value = text.substr(std::min(equals + 1, text.size()));
    if (assign(options, names.lengths, key, text, value) || assign(options, names.counts, key, text, value))
      continue;
    std::string allowed;
    for (const auto& entry : names.lengths) allowed += fmt::format("{} [m], ", entry.first);
    for (const auto& entry : names.counts) allowed += fmt::format("{}, ", entry.first);
    throw CaseError(
        fmt::format("--set {}: unknown option, allowed: {}", text, allowed.substr(0, allowed.size() - 2)));
  }
  return generate(options);
}

void print_quality(const char* shape, const Eigen::Matrix3Xd& nodes, const Eigen::Matrix3Xi& elements) {
  const auto q = mesh::element_quality(nodes, elements);
  fmt::print(
      "{}: smallest angle {:.1f} degrees, largest aspect {:.3g}, altitudes from {:.4g} m (mean {:.4g} m), "
      "areas {:.4g} to "
      "{:.4g} m2\n",
      shape, q.min_angle * 180.0 / std::numbers::pi, q.max_aspect, q.min_altitude, q.mean_altitude,
      q.min_area, q.max_area);
}

// Throws CaseError for a bad shape before anything is written.
void check_quality(const BagMesh& bag, const std::filesystem::path& file) {
  try {
    mesh::element_quality(bag.mesh.nodes, bag.mesh.elements);
    if (bag.initial) mesh::element_quality(*bag.initial, bag.mesh.elements);
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("{}: {}", file.empty() ? "--set" : file.string(), error.what()));
  }
}

void print_report(const BagMesh& bag) {
  const mesh::Mesh& mesh = bag.mesh;
  const auto surface = mesh::check_closed_surface(bag.shape(), mesh.elements);
  fmt::print("{} elements, {} nodes{}\n", mesh.element_count(), mesh.node_count(),
             surface.has_volume() ? fmt::format(", volume {:.5g} m3", surface.volume) : "");
  const Eigen::VectorXd areas = mesh::panel_areas(mesh);
  std::vector<int> counts(mesh.panel_names.size(), 0);
  for (const int panel : mesh.panel) ++counts[static_cast<std::size_t>(panel)];
  for (std::size_t i = 0; i < mesh.panel_names.size(); ++i)
    fmt::print("panel {}: {} elements, {:.5g} m2\n", mesh.panel_names[i], counts[i],
               areas(static_cast<Eigen::Index>(i)));
  print_quality("design shape", mesh.nodes, mesh.elements);
  if (bag.initial) print_quality("initial shape", *bag.initial, mesh.elements);
  for (const auto& [back, front] : bag.strap_anchors)
    fmt::print("strap anchors: nodes {} and {}\n", back, front);
  if (const auto extent = unlikely_extent(mesh))
    fmt::print("longest extent: {:.3g} m; set --length-unit to the file's unit, 1e-3 for millimetres\n",
               *extent);
  const auto faults = surface.describe(mesh.line);
  fmt::print("{}", faults.empty() ? "closed control volume: yes\n" : "closed control volume: no\n" + faults);
  if (!surface.boundary_edges.empty()) fmt::print("{}", list_of_holes(mesh));
}

// Writes a mesh. If the format cannot represent it, the error names the option of the file.
void write_as(const char* option, const mesh::Mesh& mesh, const std::filesystem::path& file) {
  try {
    mesh::write_mesh(mesh, file);
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("{} {}: {}", option, file.string(), error.what()));
  }
}

void write(const BagMesh& bag, const MeshArguments& arguments) {
  if (!arguments.out.empty()) write_as("--out", bag.mesh, arguments.out);
  if (arguments.initial.empty()) return;
  mesh::Mesh shape = bag.mesh;
  shape.nodes = bag.shape();
  write_as("--initial", shape, arguments.initial);
}

void check_outputs(const MeshArguments& arguments, const mesh::Mesh& mesh) {
  for (const auto& out : {arguments.out, arguments.initial}) refuse_same_file("--out", out, mesh.included);
  refuse_same_file("--out", arguments.out, {arguments.file});
  refuse_same_file("--initial", arguments.initial, {arguments.file, arguments.out});
  for (const auto& file : {arguments.out, arguments.initial})
    if (!file.empty()) mesh::check_mesh_ending(file);
}

void finish(BagMesh bag, const MeshArguments& arguments, const std::vector<std::string>& null_panels) {
  try {
    check_outputs(arguments, bag.mesh);
    for (const auto& name : null_panels) mesh::panel_elements(bag.mesh, name);  // throws for an unknown name
    refine(bag, arguments.refine, null_panels);
    check_quality(bag, arguments.file);
    write(bag, arguments);
  } catch (const mesh::MeshFileError& error) {
    throw OutputError(error.what());
  }
  print_report(bag);
}

// Prints the content of the file, and the effect of merging nodes.
void print_reading(BagMesh& bag, const MeshArguments& arguments) {
  mesh::Mesh& mesh = bag.mesh;
  for (const auto& [what, list] :
       {std::pair("elements other than shells", &mesh.other_elements), std::pair("not read", &mesh.skipped),
        std::pair("not read, and changes the bag", &mesh.neglected)})
    if (!list->empty()) fmt::print("{}: {}\n", what, fmt::join(*list, ", "));
  if (mesh.split_quads > 0) fmt::print("quads split in two: {}\n", mesh.split_quads);
  if (mesh.split_polygons > 0)
    fmt::print("polygons split, of up to {} corners: {}\n", mesh.most_corners, mesh.split_polygons);
  drop_collapsed(bag, arguments.file);
  if (bag.collapsed > 0) fmt::print("{}\n", collapsed_text(bag));
  if (arguments.merge) {
    const auto merged = mesh::merge_nodes(mesh, *arguments.merge);
    fmt::print("nodes merged within {:g} m: {}\n", *arguments.merge, merged.nodes);
    if (merged.elements > 0)
      fmt::print("elements left out because two corners became one: {}\n", merged.elements);
    if (mesh.element_count() == 0)
      throw CaseError(fmt::format("--merge {:g} leaves no element", *arguments.merge));
  }
  const int before = mesh.node_count();
  mesh = mesh::used_nodes(std::move(mesh));
  if (mesh.node_count() < before)
    fmt::print("nodes that no element uses, left out: {}\n", before - mesh.node_count());
}

// Only a closed surface shows its inside for certain: it may turn elements back. Prints how many run
// differently than those of the file; caps have none there.
void turn_closed(mesh::Mesh& mesh, const Eigen::Matrix3Xi& read) {
  mesh::turn_outward(mesh);
  const auto second = mesh.elements.row(1).head(read.cols());
  fmt::print("elements turned: {}\n", (second.array() != read.row(1).array()).count());
}

// Throws CaseError for an unsuitable surface before anything is written.
void require_control_volume(const BagMesh& bag, const MeshArguments& arguments) {
  const auto report = mesh::check_closed_surface(bag.shape(), bag.mesh.elements);
  if (report.ok()) return;
  const bool joins = !arguments.merge && !report.boundary_edges.empty(),
             turns = !arguments.outward &&
                     ((report.inward && !report.flat) || !report.inconsistent_edges.empty());
  throw CaseError(
      fmt::format("{}: is not a closed control volume, and nothing is written; allowed: a closed surface "
                  "that is wound outward, or --report{}{}{}\n{}{}",
                  arguments.file.string(), joins ? "; --merge DISTANCE joins nodes that nearly meet" : "",
                  report.boundary_edges.empty() ? "" : "; --cap NAME closes holes",
                  turns ? "; --outward turns elements" : "", report.describe(bag.mesh.line),
                  report.boundary_edges.empty() ? "" : list_of_holes(bag.mesh)));
}

void check_state_ending(const std::filesystem::path& out) {
  try {
    mesh::check_mesh_ending(out);
  } catch (const mesh::MeshFileError&) {
    throw CaseError(fmt::format("--out {}: the name of a state ends with {}", out.string(), shape_endings));
  }
}

// Reports invalid arguments of the library as errors of the command line.
template <class Action>
int reported(Action&& action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    throw CaseError(error.what());
  } catch (const mesh::MeshFileError& error) {
    throw CaseError(error.what());
  }
}

}  // namespace

int mesh_driver(const MeshArguments& arguments) {
  return reported([&] {
    BagMesh bag = generate_with<mesh::DriverBagOptions>(arguments.overrides);
    const auto vents = vent_panels(bag.mesh);
    finish(std::move(bag), arguments, vents);
    return exit_done;
  });
}

int mesh_passenger(const MeshArguments& arguments) {
  return reported([&] {
    BagMesh bag = generate_with<mesh::PassengerBagOptions>(arguments.overrides);
    const auto vents = vent_panels(bag.mesh);
    finish(std::move(bag), arguments, vents);
    return exit_done;
  });
}

int mesh_convert(const MeshArguments& arguments) {
  return reported([&] {
    BagMesh bag{read_any_mesh(arguments.file), std::nullopt, {}};
    if (!arguments.panels.empty()) bag.mesh = mesh::only_panels(bag.mesh, arguments.panels);
    mesh::scale(bag.mesh, arguments.length_unit);
    print_reading(bag, arguments);
    const Eigen::Matrix3Xi read = bag.mesh.elements;
    if (arguments.outward) mesh::turn_outward(bag.mesh);
    std::vector<std::string> null_panels = arguments.null_panels;
    close_holes_of(bag.mesh, arguments, null_panels);
    if (arguments.outward) turn_closed(bag.mesh, read);
    bag.initial = std::exchange(bag.mesh.start, std::nullopt);
    if (bag.initial && arguments.initial.empty() && !arguments.out.empty())
      fmt::print("--out has the stress-free shape of the deck; --initial writes the initial shape\n");
    require_areas(bag.mesh, arguments.file);
    if (!arguments.report) require_control_volume(bag, arguments);
    finish(std::move(bag), arguments, null_panels);
    return exit_done;
  });
}

int mesh_of_case(const MeshArguments& arguments) {
  CaseDocument document(arguments.file, arguments.overrides);
  const Scene scene = load_scene(document);
  refuse_same_file("--out", arguments.out, document.files());
  refuse_same_file("--initial", arguments.initial, document.files());
  if (!scene.bag) throw CaseError(fmt::format("{}: the scene has no membrane", arguments.file.string()));
  finish({scene.bag->mesh, scene.bag->initial_position, {}}, arguments, {});
  return exit_done;
}

int mesh_of_state(const MeshArguments& arguments) {
  return reported([&] {
    const bool is_vtp = arguments.out.extension() == ".vtp" || arguments.out.extension() == ".VTP";
    if (!is_vtp) check_state_ending(arguments.out);
    const BagShape shape = read_bag_shape(arguments.file, arguments.time);
    refuse_same_file("--out", arguments.out, {arguments.file / shape.file});
    fmt::print("time {} s, of {}\n", shape.time, shape.file);
    if (shape.error > 0.0) fmt::print("coordinates have errors of at most {:.2g} m\n", shape.error);
    try {
      if (is_vtp)
        replace_file(arguments.out, polydata_of(shape.mesh));
      else
        write_as("--out", shape.mesh, arguments.out);
    } catch (const mesh::MeshFileError& error) {
      throw OutputError(error.what());
    }
    print_report({shape.mesh, std::nullopt, {}});
    return exit_done;
  });
}

}  // namespace driver::commands
