// SPDX-License-Identifier: Apache-2.0
#include "scene/bag_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/bag_holes.hpp"
#include "mesh/mesh_file.hpp"
#include "mesh/surface_check.hpp"

namespace driver {
namespace {

mesh::Mesh read_mesh_file(const TableReader& table, const char* key, const MeshReader& read_mesh,
                          const std::filesystem::path& file, double unit) {
  try {
    mesh::Mesh mesh = read_mesh(file);
    for (const auto& included : mesh.included)
      table.beside_case(std::filesystem::absolute(included).string());
    if (!mesh.other_elements.empty())
      table.fail(key, fmt::format("{} has elements other than shells: {}; extract the bag by `gasjet mesh "
                                  "convert {} --panel NAME --out BAG.k`",
                                  file.string(), fmt::join(mesh.other_elements, ", "), file.string()));
    mesh::scale(mesh, unit);
    return mesh;
  } catch (const mesh::MeshFileError& error) {
    if (error.line() == 0) table.fail(key, error.what());  // the file as a whole
    throw CaseError(error.what());
  }
}

void warn_of_neglected(const mesh::Mesh& mesh, const std::filesystem::path& file, Scene& scene) {
  if (!mesh.neglected.empty())
    scene.warnings.push_back(
        fmt::format("membrane.mesh: {} has keywords that change the bag but are not read: {}; give thickness "
                    "and warp in [fabric] or [[panel]] of the case, shapes by nodes",
                    file.string(), fmt::join(mesh.neglected, ", ")));
}

// What a case or `gasjet mesh convert` can do about it.
std::string remedy(const mesh::SurfaceReport& report, const Needs& needs) {
  std::vector<std::string> remedies;
  if (needs.closed && !report.boundary_edges.empty())
    remedies.emplace_back(
        "--merge DISTANCE joins nodes that nearly meet; --cap NAME closes holes, as cap = true does in a "
        "case");
  if ((report.inward && !report.flat) || !report.inconsistent_edges.empty())
    remedies.emplace_back("--outward turns elements");
  if (!report.unused_nodes.empty()) remedies.emplace_back("it leaves out nodes that no element uses");
  return (report.flat ? "([[membrane.fold]] with type = \"press\" parts the sheets by a gap)\n" : "") +
         (remedies.empty() ? "" : fmt::format("(gasjet mesh convert: {})\n", fmt::join(remedies, "; ")));
}

// A start that is wound inward although the shape as cut is wound outward has other nodes than it should.
void require_not_mirrored(const BagMesh& source, const std::filesystem::path& start,
                          const mesh::SurfaceReport& report) {
  if (!source.initial || !report.inward || report.flat) return;
  const double cut = mesh::enclosed_volume(source.mesh.nodes, source.mesh.elements);
  if (cut > 0.0)
    throw CaseError(
        fmt::format("{}: mesh: the initial shape encloses {:.3g} m3, the design shape {:.3g} m3 with the "
                    "same elements: is it mirrored, or are its nodes in another order?",
                    start.string(), mesh::enclosed_volume(*source.initial, source.mesh.elements), cut));
}

std::string holes_of(const mesh::Mesh& mesh, const Needs& needs) {
  return !needs.closed ? "" : list_of_holes(mesh);
}

void require_sound(const BagMesh& source, const std::filesystem::path& file,
                   const std::filesystem::path& start, const Needs& needs) {
  const auto report = surface_report(source.shape(), source.mesh.elements, needs);
  if (report.ok()) return;
  require_not_mirrored(source, start, report);
  const std::string left_out = source.collapsed > 0 ? collapsed_text(source) + "; " : "";
  throw CaseError(fmt::format(
      "{}: mesh: is not a {}: {}{}{}", place_of_element(source.mesh, file, report.first_element()),
      !needs.closed ? "sheet" : "closed control volume", left_out,
      report.describe(source.mesh.line) + holes_of(source.mesh, needs), remedy(report, needs)));
}

// A shape without holes, such as `gasjet mesh state` writes of a bag whose holes were closed, has the
// elements of the caps; one with holes is as the file of the design, and gets its caps.
bool is_state_of_capped(TableReader& table, const mesh::Mesh& shape) {
  return table.at("cap").flag(false) &&
         mesh::check_closed_surface(shape.nodes, shape.elements).boundary_edges.empty();
}

// A null panel for each hole.
void cap_holes(TableReader& table, BagMesh& source) {
  const bool is_asked = table.at("cap").flag(false);
  if (!is_asked && table.has("cap_length")) table.fail("cap_length", "needs cap = true");
  const double longest = table.at("cap_length").number(positive.in("m"), longest_hole);
  if (!is_asked) return;
  table.located("cap", [&] {
    const std::vector<Cap> caps = caps_of_all(source.mesh);
    for (const Cap& cap : caps) source.caps.push_back(cap.panel);
    source.closed_holes = close_holes(source.mesh, caps, longest);
  });
}

}  // namespace

mesh::SurfaceReport surface_report(const Eigen::Matrix3Xd& nodes, const Eigen::Matrix3Xi& elements,
                                   const Needs& needs) {
  auto report = mesh::check_closed_surface(nodes, elements);
  if (!needs.closed) report.boundary_edges.clear();
  if (!needs.volume && report.flat) report.flat = report.inward = false;
  return report;
}

BagMesh mesh_of_files(TableReader& table, const MeshReader& read_mesh, const Needs& needs, Scene& scene) {
  const double unit = table.at("length_unit").number(positive.in("m"), 1.0);
  const auto file = table.beside_case(table.at("file").text());
  auto start = file;
  BagMesh source{read_mesh_file(table, "file", read_mesh, file, unit), std::nullopt, {}};
  warn_of_neglected(source.mesh, file, scene);
  std::optional<mesh::Mesh> shape;
  if (table.has("initial_file")) {
    start = table.beside_case(table.at("initial_file").text());
    table.located("initial_file",
                  [&] { shape = read_mesh_file(table, "initial_file", read_mesh, start, unit); });
  } else if (source.mesh.start) {
    table.located("file", [&] { set_initial(source, *source.mesh.start); });
  }
  source.mesh.start.reset();
  const auto take_shape = [&] {
    table.located("initial_file", [&] {
      require_same_elements(source.mesh, *shape);
      set_initial(source, shape->start_nodes());
    });
  };
  const bool is_capped = shape && is_state_of_capped(table, *shape);
  if (shape && !is_capped) take_shape();
  drop_collapsed(source, file);
  require_areas(source.mesh, file);
  cap_holes(table, source);
  if (is_capped) take_shape();
  require_sound(source, file, start, needs);
  return source;
}

}  // namespace driver
