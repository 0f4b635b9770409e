// SPDX-License-Identifier: Apache-2.0
// The mesh of a bag as a case or `gasjet mesh` asks for it: generated or from a file, refined.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/driver_bag.hpp"
#include "mesh/passenger_bag.hpp"

namespace driver {

struct BagMesh {
  mesh::Mesh mesh;                                // stress-free design shape
  std::optional<Eigen::Matrix3Xd> initial;        // 3 x nodes [m], if not the design shape
  std::vector<std::array<int, 2>> strap_anchors;  // of the generator: back and front node
  std::vector<std::string> closed_holes = {};     // a line for each
  std::vector<std::string> caps = {};             // names of the panels that close them
  int collapsed = 0;                              // elements of the file that drop_collapsed() left out
  /// Node of each node of the file; -1: left out; empty: all, in the order of the file.
  std::vector<int> node_of_file = {};

  const Eigen::Matrix3Xd& shape() const { return initial ? *initial : mesh.nodes; }
};

/// Names of a generator's options in case files and after --set: lengths [m] and counts.
template <class Options>
struct OptionNames {
  std::vector<std::pair<const char*, double Options::*>> lengths;
  std::vector<std::pair<const char*, int Options::*>> counts;
};
const OptionNames<mesh::PassengerBagOptions>& option_names(const mesh::PassengerBagOptions&);
const OptionNames<mesh::DriverBagOptions>& option_names(const mesh::DriverBagOptions&);

/// The generators throw std::invalid_argument naming the option.
BagMesh generate(const mesh::PassengerBagOptions& options);
BagMesh generate(const mesh::DriverBagOptions& options);

/// Names of the panels that begin with "vent": the generators' null panels.
std::vector<std::string> vent_panels(const mesh::Mesh& mesh);

/// Names of the panels whose elements have this node; several on a seam.
std::vector<std::string> panels_of_node(const mesh::Mesh& mesh, int node);

inline constexpr double smallest_bag = 0.02, largest_bag = 10.0;  // [m] longest extents of airbags
/// Longest extent [m] of a mesh if no airbag has it: millimetres taken for metres run, and give numbers that
/// look like results.
std::optional<double> unlikely_extent(const mesh::Mesh& mesh);

/// `file:line:1` of an element, or `file` if the mesh has no lines.
std::string place_of_element(const mesh::Mesh& mesh, const std::filesystem::path& file, int element);
/// Leaves out elements of both shapes by mesh::drop_collapsed, and counts them. Throws CaseError if none
/// is left.
void drop_collapsed(BagMesh& bag, const std::filesystem::path& file);
/// "2 elements left out, ..." for messages; empty if none was.
std::string collapsed_text(const BagMesh& bag);
/// Throws CaseError at the line of the first element without area of a mesh read from `file`.
void require_areas(const mesh::Mesh& mesh, const std::filesystem::path& file);
/// Throws std::invalid_argument if `times` refinements of so many elements may make more than
/// mesh::kMostElements.
void check_refinement(int elements, int times);
/// Applies mesh::refine `times` to both shapes.
void refine(BagMesh& bag, int times, const std::vector<std::string>& null_panels);

/// Numbers the nodes of a large bag by membrane::node_order, those of both shapes and the anchors.
void order_nodes(BagMesh& bag);

/// Throws std::invalid_argument unless `shape` has the elements of `design`. Quads and polygons of
/// files may be split in another way: the bag has the elements of the design shape.
void require_same_elements(const mesh::Mesh& design, const mesh::Mesh& shape);
/// Takes the nodes as initial shape. Throws std::invalid_argument unless both shapes have areas of the same
/// order.
void set_initial(BagMesh& bag, const Eigen::Matrix3Xd& nodes);

}  // namespace driver
