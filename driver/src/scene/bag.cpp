// SPDX-License-Identifier: Apache-2.0
// [membrane] -> BagPart.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "membrane/icosphere.hpp"
#include "membrane/surface_check.hpp"
#include "mesh_files/mesh_reader.hpp"
#include "scene/bag_mesh.hpp"
#include "scene/parts.hpp"

namespace driver {
namespace {

template <class Options>
BagMesh generate_with(TableReader& table) {
  Options options;
  for (const auto& [name, member] : option_names(options).lengths)
    options.*member = table.at(name).number(positive.in("m"), options.*member);
  for (const auto& [name, member] : option_names(options).counts)
    options.*member = table.at(name).integer(0, 1000, options.*member);
  return generate(options);
}

membrane::Mesh read_mesh_file(const TableReader& table, const char* key, const std::filesystem::path& file,
                              double unit) {
  try {
    membrane::Mesh mesh = read_any_mesh(file);
    for (const auto& included : mesh.included)
      table.beside_case(std::filesystem::absolute(included).string());
    if (!mesh.other_elements.empty())
      table.fail(key,
                 fmt::format("{} has elements that are no shells: {}; `gasjet mesh convert {} --panel NAME "
                             "--out BAG.k` takes the bag alone",
                             file.string(), fmt::join(mesh.other_elements, ", "), file.string()));
    mesh.nodes *= unit;
    return mesh;
  } catch (const membrane::MeshFileError& error) {
    if (error.line() == 0) table.fail(key, error.what());  // the file as a whole
    throw CaseError(error.what());
  }
}

BagMesh mesh_of_files(TableReader& table) {
  const double unit = table.at("length_unit").number(positive.in("m"), 1.0);
  const auto file = table.beside_case(table.at("file").text());
  BagMesh source{read_mesh_file(table, "file", file, unit), std::nullopt, {}};
  if (table.has("initial_file"))
    table.located("initial_file", [&] {
      const auto initial = table.beside_case(table.at("initial_file").text());
      set_initial(source, read_mesh_file(table, "initial_file", initial, unit));
    });
  require_areas(source.mesh, file);
  const auto report = membrane::check_closed_surface(source.shape(), source.mesh.elements);
  if (!report.ok())
    throw CaseError(fmt::format("{}: mesh: is not a closed control volume: {}",
                                place_of_element(source.mesh, file, report.first_element()),
                                report.describe(source.mesh.line)));
  return source;
}

BagMesh generated_mesh(TableReader& table) {
  enum class Generator { driver, passenger, icosphere };
  const auto generator = table.at("generator")
                             .choice<Generator>({{"driver", Generator::driver},
                                                 {"passenger", Generator::passenger},
                                                 {"icosphere", Generator::icosphere}});
  if (generator == Generator::driver) return generate_with<membrane::DriverBagOptions>(table);
  if (generator == Generator::passenger) return generate_with<membrane::PassengerBagOptions>(table);
  return {
      membrane::icosphere(table.at("radius").number(positive.in("m")), table.at("levels").integer(0, 8, 3)),
      std::nullopt,
      {}};
}

BagMesh read_mesh(TableReader table, const std::vector<std::string>& null_panels) {
  BagMesh source;
  table.located("", [&] {
    source = table.has("file") ? mesh_of_files(table) : generated_mesh(table);
    const int times = table.at("refine").integer(0, 6, 0);
    table.located("refine", [&] { check_refinement(source.mesh.element_count(), times); });
    membrane::require_closed_surface(source.shape(), source.mesh.elements);
    refine(source, times, null_panels);
    order_nodes(source);
  });
  table.finish();
  return source;
}

std::vector<int> nodes_of_panels(TableReader& table, const std::string& key, const membrane::Mesh& mesh) {
  std::vector<int> nodes;
  const auto names = table.at(key).texts();
  table.located(key, [&] {
    for (const auto& name : names)
      for (const int node : membrane::panel_nodes(mesh, name)) nodes.push_back(node);
  });
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// The node nearest to a point of the design shape; a point further off than the mesh is coarse is a slip.
int anchor(TableReader& reader, const char* key, const membrane::Mesh& mesh) {
  const Eigen::Vector3d point = reader.at(key).vector("m");
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

void read_straps(TableReader& table, const BagMesh& source, std::vector<membrane::Strap>& straps) {
  for (auto& reader : table.tables("strap")) {
    membrane::Strap strap;
    if (reader.has("from") || reader.has("to") || straps.size() >= source.strap_anchors.size()) {
      strap.node_a = anchor(reader, "from", source.mesh);
      strap.node_b = anchor(reader, "to", source.mesh);
    } else {
      strap.node_a = source.strap_anchors[straps.size()][0];
      strap.node_b = source.strap_anchors[straps.size()][1];
    }
    strap.stiffness = reader.at("stiffness").number(positive.in("N/m"));
    strap.free_length = reader.at("free_length").number(positive.in("m"));
    reader.finish();
    straps.push_back(strap);
  }
}

void read_plate(TableReader& table, membrane::BagDescription& bag) {
  auto reader = table.optional_table("plate");
  if (!reader) return;
  membrane::Plate plate;
  plate.point = reader->at("point").vector("m");
  plate.normal = reader->at("normal").vector("");
  plate.stiffness = reader->at("stiffness").optional_number(positive.in("Pa/m"));
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

std::vector<int> set_null_panels(TableReader& table, const std::vector<std::string>& names,
                                 const membrane::Mesh& mesh, membrane::BagDescription& bag) {
  std::vector<int> elements;
  table.located("null_panels", [&] {
    for (const auto& name : names)
      for (const int element : membrane::panel_elements(mesh, name)) elements.push_back(element);
    std::sort(elements.begin(), elements.end());
    if (std::adjacent_find(elements.begin(), elements.end()) != elements.end())
      throw std::invalid_argument("names a panel twice");
  });
  for (const int element : elements) {
    bag.properties[static_cast<std::size_t>(element)].null_panel = true;
    bag.properties[static_cast<std::size_t>(element)].porosity = 0.0;
  }
  return elements;
}

// The shape at the start: the mesh's own, or the design shape pressed flat.
Eigen::Matrix3Xd initial_shape(TableReader& table, const BagMesh& source) {
  if (source.initial && table.has("flatten"))
    table.fail("flatten", "this mesh has an initial shape of its own; allowed for meshes without one");
  if (source.initial) return *source.initial;
  return membrane::flatten(source.mesh, table.at("flatten").number(positive_fraction, 1.0));
}

void warn_of_leaks(const membrane::BagDescription& bag, LeakLaw law, Scene& scene) {
  warn_of_screen("fabric", law, scene);
  const bool porous = std::any_of(bag.properties.begin(), bag.properties.end(),
                                  [](const auto& fabric) { return fabric.porosity > 0.0; });
  if (law == LeakLaw::none && porous)
    scene.warnings.emplace_back("fabric.porosity has no effect with leak_law = \"none\"");
}

// Millimetres read as metres run, and give numbers that look like results.
void warn_of_size(const membrane::Mesh& mesh, Scene& scene) {
  constexpr double smallest = 0.02, largest = 10.0;  // [m] no airbag is
  const double extent = (mesh.nodes.rowwise().maxCoeff() - mesh.nodes.rowwise().minCoeff()).maxCoeff();
  if (extent < smallest || extent > largest)
    scene.warnings.push_back(
        fmt::format("membrane.mesh: the bag's longest extent is {:.3g} m; of a mesh from a file length_unit "
                    "says what its coordinates mean",
                    extent));
}

}  // namespace

void displace_nodes(Scene& scene, double amplitude, int seed) {
  if (!scene.bag) throw std::invalid_argument("the scene has no membrane whose nodes could be displaced");
  std::vector<int> fixed;
  const auto& inverse_mass = scene.bag->model.inverse_mass;
  for (std::size_t node = 0; node < inverse_mass.size(); ++node)
    if (inverse_mass[node] == 0.0) fixed.push_back(static_cast<int>(node));
  perturb(scene.bag->initial_position, fixed, amplitude, seed);
}

void read_bag(TableReader& root, Scene& scene) {
  auto table = root.optional_table("membrane");
  if (!table) {
    if (root.has("fabric")) root.fail("fabric", "needs a table [membrane]");
    return;
  }
  if (!scene.gas) root.fail("gas", "is missing: a bag ([membrane]) is filled by a gas");
  const auto null_panels = table->at("null_panels").texts();
  BagMesh source = read_mesh(table->table("mesh"), null_panels);
  membrane::BagDescription bag;
  bag.reference = source.mesh.nodes;
  bag.elements = source.mesh.elements;
  bag.gravity = scene.gravity;
  const LeakLaw law = read_fabric(root, source.mesh, null_panels, bag, scene.gas->model);
  std::vector<int> null_elements = set_null_panels(*table, null_panels, source.mesh, bag);
  bag.fixed_nodes = nodes_of_panels(*table, "fixed_panels", source.mesh);
  bag.mass_damping = table->at("mass_damping").number(non_negative.in("1/s"), 0.0);
  read_straps(*table, source, bag.straps);
  read_plate(*table, bag);

  warn_of_leaks(bag, law, scene);
  warn_of_size(source.mesh, scene);
  Eigen::Matrix3Xd position = initial_shape(*table, source);
  const double amplitude = table->at("perturbation").number(Bounds{0.0, 1e-3, false, "0 to 1e-3", "m"}, 0.0);
  if (table->has("perturbation_seed") && !table->has("perturbation"))
    table->fail("perturbation_seed", "is given without perturbation: what it seeds is needed");
  const int seed = table->at("perturbation_seed").integer(0, 1'000'000'000, 0);
  perturb(position, bag.fixed_nodes, amplitude, seed);
  table->located("", [&] {
    scene.bag.emplace(BagPart{std::move(source.mesh), membrane::make_model(bag), std::move(position), law,
                              std::move(null_elements)});
  });
  table->finish();
}

}  // namespace driver
