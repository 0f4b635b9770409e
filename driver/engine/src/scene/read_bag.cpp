// SPDX-License-Identifier: Apache-2.0
// [membrane] -> BagPart.
#include "scene/read_bag.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/bag_mesh.hpp"
#include "mesh/icosphere.hpp"
#include "mesh/surface_check.hpp"
#include "scene/bag_file.hpp"
#include "scene/bag_start.hpp"
#include "scene/bag_supports.hpp"
#include "scene/gas_curve.hpp"
#include "scene/read_fabric.hpp"
#include "scene/read_fold.hpp"
#include "scene/read_openings.hpp"
#include "scene/read_skin_contact.hpp"

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

BagMesh generated_mesh(TableReader& table) {
  enum class Generator { driver, passenger, icosphere };
  const auto generator = table.at("generator")
                             .choice<Generator>({{"driver", Generator::driver},
                                                 {"passenger", Generator::passenger},
                                                 {"icosphere", Generator::icosphere}});
  if (generator == Generator::driver) return generate_with<mesh::DriverBagOptions>(table);
  if (generator == Generator::passenger) return generate_with<mesh::PassengerBagOptions>(table);
  return {mesh::icosphere(table.at("radius").number(positive.in("m")), table.at("levels").integer(0, 8, 3)),
          std::nullopt,
          {}};
}

BagMesh read_bag_mesh(TableReader table, const MeshReader& read_mesh, std::vector<std::string>& null_panels,
                      const Needs& needs, Scene& scene) {
  BagMesh source;
  table.located("", [&] {
    source = table.has("file") ? mesh_of_files(table, read_mesh, needs, scene) : generated_mesh(table);
    for (const auto& cap : source.caps)
      if (std::ranges::find(null_panels, cap) == null_panels.end()) null_panels.push_back(cap);
    const int times = table.at("refine").integer(0, 6, 0);
    table.located("refine", [&] { check_refinement(source.mesh.element_count(), times); });
    const auto report = surface_report(source.shape(), source.mesh.elements, needs);
    if (needs.closed) mesh::require_closed_surface(report);
    refine(source, times, null_panels);
    order_nodes(source);
  });
  table.finish();
  return source;
}

std::vector<int> set_null_panels(TableReader& table, const std::vector<std::string>& names,
                                 const mesh::Mesh& mesh, membrane::BagDescription& bag) {
  std::vector<int> elements;
  table.located("null_panels", [&] {
    for (const auto& name : names)
      for (const int element : mesh::panel_elements(mesh, name)) elements.push_back(element);
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
    table.fail("flatten", "the mesh has its own initial shape; allowed: a mesh without one");
  if (source.initial) return *source.initial;
  return mesh::flatten(source.mesh, table.at("flatten").number(positive_fraction, 1.0));
}

void warn_of_leaks(const membrane::BagDescription& bag, LeakLaw law, Scene& scene) {
  warn_of_screen("fabric", law, scene);
  const bool porous = std::any_of(bag.properties.begin(), bag.properties.end(),
                                  [](const auto& fabric) { return fabric.porosity > 0.0; });
  if (law == LeakLaw::none && porous)
    scene.warnings.emplace_back("fabric.porosity has no effect with leak_law = \"none\"");
}

void warn_of_size(const mesh::Mesh& mesh, bool from_file, Scene& scene) {
  if (const auto extent = unlikely_extent(mesh))
    scene.warnings.push_back(
        fmt::format("membrane.mesh: the bag's longest extent is {:.3g} m, usual are {:g} to {:g} m: {}",
                    *extent, smallest_bag, largest_bag,
                    from_file ? "set length_unit to the file's unit, 1e-3 for millimetres"
                              : "the lengths of a generator are in metres"));
}

// A sliver sets the step of the whole bag.
void warn_of_slivers(const mesh::Mesh& mesh, Scene& scene) {
  constexpr double least = 1e-3;  // of the mean
  const auto quality = mesh::element_quality(mesh.nodes, mesh.elements);
  if (quality.min_altitude < least * quality.mean_altitude)
    scene.warnings.push_back(fmt::format(
        "membrane.mesh: an element has an altitude of {:.2g} m, the mean is {:.2g} m: it makes steps short "
        "and the energy inexact; gasjet mesh convert --merge joins nodes that nearly meet",
        quality.min_altitude, quality.mean_altitude));
}

std::vector<double> element_masses(const membrane::BagModel& model) {
  std::vector<double> masses;
  for (std::size_t e = 0; e < model.reference_area.size(); ++e) {
    const membrane::ElementProperties& fabric = model.description.properties[e];
    masses.push_back(fabric.density * fabric.thickness * model.reference_area[e]);
  }
  return masses;
}

std::optional<gas::Curve> read_overpressure(TableReader& table, const Scene& scene) {
  if (scene.gas && table.has("overpressure"))
    table.fail("overpressure", "is for sheets without gas; [gas] has its own pressure");
  std::optional<gas::Curve> curve;
  if (!scene.gas)
    table.located("overpressure", [&] {
      curve = to_gas_curve(CurveReader(table, "overpressure").curve(any_number.in("Pa")), gas::Outside::held);
    });
  return curve;
}

}  // namespace

void read_bag(TableReader& root, const MeshReader& read_mesh, Scene& scene) {
  auto table = root.optional_table("membrane");
  if (!table) {
    if (root.has("fabric")) root.fail("fabric", "needs a table [membrane]");
    return;
  }
  if (table->has("self_contact") && !table->is_table("mesh"))
    table->fail("self_contact", "needs membrane.mesh, the fabric whose layers touch");
  if (!scene.gas && !table->has("overpressure"))
    root.fail("gas", "is missing: a [membrane] needs [gas] for a bag, or overpressure for a sheet");
  const auto overpressure = read_overpressure(*table, scene);
  auto null_panels = table->at("null_panels").texts();
  BagMesh source = read_bag_mesh(table->table("mesh"), read_mesh, null_panels,
                                 Needs{!overpressure, !table->has("fold")}, scene);
  warn_of_size(source.mesh, table->has_in_table("mesh", "file"), scene);
  if (source.collapsed > 0) scene.warnings.push_back("membrane.mesh: " + collapsed_text(source));
  membrane::BagDescription bag;
  bag.reference = source.mesh.nodes;
  bag.elements = source.mesh.elements;
  bag.gravity = scene.gravity;
  const LeakLaw law =
      read_fabric(root, source.mesh, null_panels, bag, scene.gas ? &scene.gas->model : nullptr);
  std::vector<int> null_elements = set_null_panels(*table, null_panels, source.mesh, bag);
  read_supports(*table, source, bag);
  bag.mass_damping = table->at("mass_damping").number(non_negative.in("1/s"), 0.0);
  bag.stiffness_damping = table->at("stiffness_damping").number(non_negative.in("s"), 0.0);

  warn_of_leaks(bag, law, scene);
  table->located("mesh", [&] { warn_of_slivers(source.mesh, scene); });
  Eigen::Matrix3Xd position = initial_shape(*table, source);
  const auto folding = read_folds(*table, source.mesh, position, bag);
  if (folding) {
    position = folding->nodes();
    if (mesh::check_closed_surface(position, source.mesh.elements).flat)
      table->fail("fold", "leaves the sheets on each other, without a volume; begin with type = \"press\"");
    for (auto& text : tight_straps(bag.straps, position)) scene.warnings.push_back(std::move(text));
  }
  const double amplitude = table->at("perturbation").number(Bounds{0.0, 1e-3, false, "0 to 1e-3", "m"}, 0.0);
  if (table->has("perturbation_seed") && !table->has("perturbation"))
    table->fail("perturbation_seed", "needs perturbation");
  const int seed = table->at("perturbation_seed").integer(0, 1'000'000'000, 0);
  table->located("", [&] {
    membrane::BagModel model = membrane::make_model(bag);
    std::vector<double> masses = element_masses(model);
    scene.bag.emplace(BagPart{std::move(source.mesh),
                              std::move(model),
                              std::move(position),
                              law,
                              std::move(null_elements),
                              overpressure,
                              std::move(masses),
                              {},
                              {}});
    for (const auto& hole : source.closed_holes) scene.warnings.push_back("membrane.mesh.cap: " + hole);
    if (folding) {
      scene.bag->fold_lines = folding->lines();
      scene.bag->gathered = folding->gathered();
    }
  });
  require_before_plates(*table, *scene.bag);
  if (!table->has("flatten")) warn_of_strained_start(scene);
  displace_nodes(scene, amplitude, seed);
  read_skin_contact(*table, scene);
  table->finish();
}

}  // namespace driver
