// SPDX-License-Identifier: Apache-2.0
// gasjet mesh fold
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "commands/command.hpp"
#include "engine/bag_mesh.hpp"
#include "input_files.hpp"
#include "mesh/fold.hpp"
#include "mesh/surface_check.hpp"
#include "results/crossing.hpp"
#include "results/load_scene.hpp"
#include "results/mesh_reader.hpp"

namespace driver::commands {
namespace {

// A bag to be folded, or folded by its case.
struct FoldInput {
  mesh::Mesh mesh;  // stress-free
  Eigen::Matrix3Xd start;
  std::vector<int> fixed;
  std::vector<membrane::Strap> straps;
  std::vector<mesh::FoldLine> lines;
  std::vector<bool> gathered;
  std::vector<std::filesystem::path> files;
};

bool is_case(const std::filesystem::path& file) {
  return file.extension() == ".toml" || file.extension() == ".TOML";
}

FoldInput input_of_case(const MeshArguments& arguments) {
  const FoldArguments& a = arguments.fold;
  if (a.flatten || !a.fixed.empty() || !a.design.empty())
    throw CaseError(
        "--flatten, --fixed and --design are for mesh files; a case has membrane.flatten, "
        "membrane.fixed_panels and its own design shape, to be changed by --set");
  CaseDocument document(arguments.file, arguments.overrides);
  const Scene scene = load_scene(document);
  if (!scene.bag) throw CaseError(fmt::format("{}: the scene has no membrane", arguments.file.string()));
  const membrane::BagDescription& bag = scene.bag->model.description;
  return {scene.bag->mesh,       scene.bag->initial_position, bag.fixed_nodes, bag.straps,
          scene.bag->fold_lines, scene.bag->gathered,         document.files()};
}

// A flat bag is closed although it encloses nothing.
void require_closed(const FoldInput& input, const std::filesystem::path& file) {
  auto report = mesh::check_closed_surface(input.start, input.mesh.elements);
  if (report.flat) report.inward = report.flat = false;
  if (!report.ok())
    throw CaseError(
        fmt::format("{}: is not a closed bag, and nothing is written; gasjet mesh convert repairs "
                    "surfaces\n{}",
                    file.string(), report.describe(input.mesh.line)));
}

FoldInput input_of_mesh(const MeshArguments& arguments) {
  const FoldArguments& a = arguments.fold;
  if (!arguments.overrides.empty()) throw CaseError("--set is for cases, and BAG is a mesh file");
  FoldInput input{read_any_mesh(arguments.file), {}, {}, {}, {}, {}, {arguments.file}};
  input.files.insert(input.files.end(), input.mesh.included.begin(), input.mesh.included.end());
  input.start = input.mesh.start_nodes();
  if (!a.design.empty()) {
    mesh::Mesh design = read_any_mesh(a.design);
    require_same_elements(design, input.mesh);
    input.mesh = std::move(design);
    input.files.push_back(a.design);
  }
  input.mesh.start.reset();
  if (a.flatten) {
    mesh::Mesh shape = input.mesh;
    shape.nodes = input.start;
    input.start = mesh::flatten(shape, *a.flatten);
  }
  for (const auto& name : a.fixed)
    for (const int node : mesh::panel_nodes(input.mesh, name)) input.fixed.push_back(node);
  require_areas(input.mesh, a.design.empty() ? arguments.file : a.design);
  require_closed(input, arguments.file);
  return input;
}

// Folds as the options say, after what the case has folded.
void fold_by_options(FoldInput& input, const FoldArguments& a) {
  const bool folds = a.letter || a.accordion || a.roll;
  if (!folds && (!a.axis.empty() || !a.at.empty() || a.easing))
    throw CaseError("--axis, --at and --easing need --letter, --accordion or --roll");
  if (!folds && !a.press) {
    if (input.lines.empty())
      throw CaseError("needs --press, --letter, --accordion or --roll, or a case with [[membrane.fold]]");
    return;
  }
  if (!(a.gap > 0.0)) throw CaseError("--gap: is missing, needed: the least distance between layers [m]");
  if (folds && (a.axis.empty() || a.at.empty())) throw CaseError("a fold needs --axis and --at");
  mesh::Folding folding(input.mesh, input.start, input.fixed, mesh::thin_side(input.start, input.fixed));
  if (a.press) folding.press(a.gap);
  if (folds) {
    mesh::FoldOptions options;
    options.type = a.letter      ? mesh::FoldType::letter
                   : a.accordion ? mesh::FoldType::accordion
                                 : mesh::FoldType::roll;
    options.axis = a.axis[0] - 'x';
    options.at = a.at;
    options.gap = a.gap;
    options.easing = a.easing.value_or(options.easing);
    folding.fold(options);
  }
  input.start = folding.nodes();
  input.lines.insert(input.lines.end(), folding.lines().begin(), folding.lines().end());
  input.gathered.resize(folding.gathered().size(), false);
  for (std::size_t i = 0; i < input.gathered.size(); ++i)
    if (folding.gathered()[i]) input.gathered[i] = true;
}

struct StrainReport {
  double in_bends = 0.0, elsewhere = 0.0;  // largest tensile strain, of a length
  int stretched = 0;                       // elements with more than 1e-3
  double slack = 0.0;                      // [m2] of fabric outside the bends shortened by more than a tenth
};

StrainReport strain_of(const FoldInput& input) {
  constexpr double little = 1e-3, slack = 0.9;
  StrainReport report;
  const auto stretches = mesh::principal_stretches(input.mesh.nodes, input.start, input.mesh.elements);
  const Eigen::VectorXd areas = mesh::element_areas(input.mesh.nodes, input.mesh.elements);
  for (std::size_t e = 0; e < stretches.size(); ++e) {
    const auto column = static_cast<Eigen::Index>(e);
    const Eigen::Vector3i corners = input.mesh.elements.col(column);
    const bool bent = !input.gathered.empty() && std::ranges::any_of(corners, [&](int node) {
      return bool{input.gathered[static_cast<std::size_t>(node)]};
    });
    const double strain = stretches[e][1] - 1.0;
    double& largest = bent ? report.in_bends : report.elsewhere;
    largest = std::max(largest, strain);
    if (strain > little) ++report.stretched;
    if (!bent && stretches[e][0] < slack) report.slack += areas[column];
  }
  return report;
}

void print_report(const FoldInput& input) {
  const double design = mesh::element_areas(input.mesh.nodes, input.mesh.elements).sum();
  fmt::print("{} elements, {} nodes, volume {:.5g} m3\n", input.mesh.element_count(), input.mesh.node_count(),
             mesh::enclosed_volume(input.start, input.mesh.elements));
  for (const mesh::FoldLine& line : input.lines)
    fmt::print(
        "fold at {:.4g} m: bend {:.3g} mm high, gathers the fabric within {:.3g} mm; elements {:.3g} mm "
        "long{}\n",
        line.at, 1e3 * line.height, 1e3 * line.reach, 1e3 * line.element, line.eased ? ", eased" : "");
  const StrainReport strain = strain_of(input);
  fmt::print("largest tensile strain: {:.2g} in the bends, {:.2g} elsewhere; {} elements above 0.001\n",
             strain.in_bends, strain.elsewhere, strain.stretched);
  fmt::print(
      "slack: the fabric has {:.3g} of {:.3g} m2; {:.3g} m2 outside the bends are shortened by more than "
      "a tenth\n",
      mesh::element_areas(input.start, input.mesh.elements).sum(), design, strain.slack);
  for (std::size_t i = 0; i < input.straps.size(); ++i) {
    const membrane::Strap& strap = input.straps[i];
    const double length = (input.start.col(strap.node_b) - input.start.col(strap.node_a)).norm();
    fmt::print("strap {}: {:.3g} m long, free length {:.3g} m{}\n", i, length, strap.free_length,
               length > strap.free_length ? ": it pulls at the start" : "");
  }
}

void require_no_crossing(const FoldInput& input, const std::filesystem::path& file) {
  const auto pairs = crossing_pairs(input.start, input.mesh.elements);
  if (pairs.empty()) return;
  const Eigen::Vector3d place =
      input.start(Eigen::all, input.mesh.elements.col(pairs.front().first)).rowwise().mean();
  const auto panel = [&](int element) {
    return input.mesh
        .panel_names[static_cast<std::size_t>(input.mesh.panel[static_cast<std::size_t>(element)])];
  };
  throw CaseError(fmt::format(
      "{}: the folded skin passes through itself in {} pairs of elements, the first one at [{:.3g}, {:.3g}, "
      "{:.3g}] m of panels {} and {}, and nothing is written; move the fold lines, take a larger gap, or a "
      "finer mesh",
      file.string(), pairs.size(), place.x(), place.y(), place.z(), panel(pairs.front().first),
      panel(pairs.front().second)));
}

void write_start(const FoldInput& input, const std::filesystem::path& out) {
  mesh::Mesh shape = input.mesh;
  shape.nodes = input.start;
  try {
    mesh::write_mesh(shape, out);
  } catch (const mesh::MeshFileError& error) {
    throw OutputError(error.what());
  }
}

}  // namespace

int mesh_fold(const MeshArguments& arguments) {
  try {
    mesh::check_mesh_ending(arguments.out);
    FoldInput input = is_case(arguments.file) ? input_of_case(arguments) : input_of_mesh(arguments);
    refuse_same_file("--out", arguments.out, input.files);
    fold_by_options(input, arguments.fold);
    require_no_crossing(input, arguments.file);
    write_start(input, arguments.out);
    print_report(input);
    return exit_done;
  } catch (const std::invalid_argument& error) {
    throw CaseError(error.what());
  } catch (const mesh::MeshFileError& error) {
    throw CaseError(error.what());
  }
}

}  // namespace driver::commands
