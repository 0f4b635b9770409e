// SPDX-License-Identifier: Apache-2.0
// [membrane] and [fabric] -> BagPart.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "membrane/icosphere.hpp"
#include "membrane/obj.hpp"
#include "membrane/passenger_bag.hpp"
#include "membrane/surface_check.hpp"
#include "scene_parts.hpp"

namespace driver {
namespace {

// Share of the fabric's own omega^2 that the plate adds by default: stiff, yet a tenth off the step.
constexpr double default_plate_share = 0.25;

struct MeshSource {
  membrane::Mesh mesh;
  std::vector<std::array<int, 2>> strap_anchors;  // of the generator, back and front node
};

MeshSource generate_passenger(TableReader& table) {
  membrane::PassengerBagOptions options;
  options.depth = table.number("depth", positive, options.depth);
  options.width = table.number("width", positive, options.width);
  options.height = table.number("height", positive, options.height);
  options.depth_cells = table.integer("depth_cells", 4, 1000, options.depth_cells);
  options.width_cells = table.integer("width_cells", 4, 1000, options.width_cells);
  options.height_cells = table.integer("height_cells", 4, 1000, options.height_cells);
  auto bag = membrane::passenger_bag(options);
  return {std::move(bag.mesh), {bag.strap_anchors.begin(), bag.strap_anchors.end()}};
}

membrane::Mesh read_mesh_file(TableReader& table) {
  const auto file = table.beside_case(table.text("file"));
  const double unit = table.number("length_unit", positive, 1.0);
  try {
    membrane::Mesh mesh = membrane::read_obj(file);
    mesh.nodes *= unit;
    return mesh;
  } catch (const membrane::MeshFileError& error) {
    throw CaseError(error.what());
  }
}

MeshSource read_mesh(TableReader table) {
  MeshSource source;
  table.located("", [&] {
    if (table.has("file")) {
      source.mesh = read_mesh_file(table);
    } else {
      enum class Generator { passenger, icosphere };
      const auto generator = table.choice<Generator>(
          "generator", {{"passenger", Generator::passenger}, {"icosphere", Generator::icosphere}});
      if (generator == Generator::passenger)
        source = generate_passenger(table);
      else
        source.mesh = membrane::icosphere(table.number("radius", positive), table.integer("levels", 0, 8, 3));
    }
    membrane::require_closed_surface(source.mesh.nodes, source.mesh.elements);
  });
  table.finish();
  return source;
}

std::vector<int> nodes_of_panels(TableReader& table, const std::string& key, const membrane::Mesh& mesh) {
  std::vector<int> nodes;
  const auto names = table.texts(key);
  table.located(key, [&] {
    for (const auto& name : names)
      for (const int node : membrane::panel_nodes(mesh, name)) nodes.push_back(node);
  });
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void read_fabric(TableReader& root, membrane::BagDescription& bag, LeakLaw& law) {
  TableReader table = root.table("fabric");
  membrane::ElementProperties fabric;
  fabric.young = table.number("young_modulus", positive);
  fabric.poisson =
      table.number("poisson_ratio", Bounds{-0.999, 0.999, false, "a number from -0.999 to 0.999"});
  fabric.density = table.number("density", positive);
  fabric.thickness = table.number("thickness", positive);
  fabric.porosity = table.number("porosity", fraction, 0.0);
  law = table.choice<LeakLaw>(
      "leak_law", {{"none", LeakLaw::none}, {"printed", LeakLaw::printed}, {"screen", LeakLaw::screen}},
      "printed");
  using membrane::Compression;
  bag.compression = table.choice<Compression>(
      "compression", {{"none", Compression::none}, {"linear", Compression::linear}}, "none");
  table.finish();
  bag.properties.assign(static_cast<std::size_t>(bag.elements.cols()), fabric);
}

// The node nearest to a point of the design shape; a point further off than the mesh is coarse is a slip.
int anchor(TableReader& reader, const char* key, const membrane::Mesh& mesh) {
  const Eigen::Vector3d point = reader.vector(key);
  const int node = membrane::nearest_node(mesh, point);
  double longest = 0.0;
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int i = 0; i < 3; ++i)
      longest = std::max(
          longest,
          (mesh.nodes.col(mesh.elements(i, e)) - mesh.nodes.col(mesh.elements((i + 1) % 3, e))).norm());
  const double distance = (mesh.nodes.col(node) - point).norm();
  if (distance > longest)
    reader.fail(key, fmt::format("is {} m from the nearest node, {} m (the longest element side) is allowed",
                                 distance, longest));
  return node;
}

void read_straps(TableReader& table, const MeshSource& source, std::vector<membrane::Strap>& straps) {
  for (auto& reader : table.tables("strap")) {
    membrane::Strap strap;
    if (reader.has("from") || straps.size() >= source.strap_anchors.size()) {
      strap.node_a = anchor(reader, "from", source.mesh);
      strap.node_b = anchor(reader, "to", source.mesh);
    } else {
      strap.node_a = source.strap_anchors[straps.size()][0];
      strap.node_b = source.strap_anchors[straps.size()][1];
    }
    strap.stiffness = reader.number("stiffness", positive);
    strap.free_length = reader.number("free_length", positive);
    reader.finish();
    straps.push_back(strap);
  }
}

double largest_material_frequency(const membrane::BagModel& model) {
  const auto& values = model.constants.material_frequency;
  return *std::max_element(values.begin(), values.end());
}

void read_plate(TableReader& table, membrane::BagDescription& bag) {
  auto reader = table.optional_table("plate");
  if (!reader) return;
  membrane::Plate plate;
  plate.point = reader->vector("point");
  plate.normal = reader->vector("normal");
  if (const auto stiffness = reader->optional_number("stiffness", positive)) {
    plate.stiffness = *stiffness;
  } else {
    const auto bare = membrane::make_model(bag);
    const auto& fabric = bag.properties.front();
    plate.stiffness =
        default_plate_share * largest_material_frequency(bare) * fabric.density * fabric.thickness;
  }
  reader->finish();
  bag.plates.push_back(plate);
}

// Random displacements of at most `amplitude`, of the free nodes: the members of an ensemble.
void perturb(Eigen::Matrix3Xd& position, const std::vector<int>& fixed, double amplitude, int seed) {
  if (amplitude == 0.0) return;
  std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
  for (Eigen::Index node = 0; node < position.cols(); ++node)
    for (int axis = 0; axis < 3; ++axis) {
      // By hand: the standard distributions differ between libraries.
      const double unit = static_cast<double>(generator() >> 11) * 0x1p-53;
      if (!std::binary_search(fixed.begin(), fixed.end(), static_cast<int>(node)))
        position(axis, node) += amplitude * (2.0 * unit - 1.0);
    }
}

}  // namespace

void read_bag(TableReader& root, Scene& scene) {
  auto table = root.optional_table("membrane");
  if (!table) {
    if (root.has("fabric")) root.fail("fabric", "needs a table [membrane]");
    return;
  }
  MeshSource source = read_mesh(table->table("mesh"));
  membrane::BagDescription bag;
  bag.reference = source.mesh.nodes;
  bag.elements = source.mesh.elements;
  bag.gravity = scene.gravity;
  LeakLaw law = LeakLaw::none;
  read_fabric(root, bag, law);

  std::vector<int> null_elements;
  const auto null_panels = table->texts("null_panels");
  table->located("null_panels", [&] {
    for (const auto& name : null_panels)
      for (const int element : membrane::panel_elements(source.mesh, name)) null_elements.push_back(element);
    std::sort(null_elements.begin(), null_elements.end());
    if (std::adjacent_find(null_elements.begin(), null_elements.end()) != null_elements.end())
      throw std::invalid_argument("names a panel twice");
  });
  for (const int element : null_elements) {
    bag.properties[static_cast<std::size_t>(element)].null_panel = true;
    bag.properties[static_cast<std::size_t>(element)].porosity = 0.0;
  }
  bag.fixed_nodes = nodes_of_panels(*table, "fixed_panels", source.mesh);
  bag.mass_damping = table->number("mass_damping", non_negative, 0.0);
  read_straps(*table, source, bag.straps);
  table->located("", [&] { read_plate(*table, bag); });

  if (law == LeakLaw::screen)
    scene.warnings.push_back(
        "fabric.leak_law = \"screen\" leaks 1/porosity times as much as the paper's printed law");
  if (law == LeakLaw::none && bag.properties.front().porosity > 0.0)
    scene.warnings.push_back("fabric.porosity has no effect with leak_law = \"none\"");
  Eigen::Matrix3Xd position =
      membrane::flatten(source.mesh, table->number("flatten", positive_fraction, 1.0));
  const double amplitude = table->number("perturbation", Bounds{0.0, 1e-3, false, "0 to 1e-3 m"}, 0.0);
  const int seed = table->integer("perturbation_seed", 0, 1'000'000'000, 0);
  perturb(position, bag.fixed_nodes, amplitude, seed);
  table->located("", [&] {
    scene.bag.emplace(BagPart{std::move(source.mesh), membrane::make_model(bag), std::move(position), law,
                              std::move(null_elements)});
  });
  table->finish();
}

}  // namespace driver
