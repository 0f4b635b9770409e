// SPDX-License-Identifier: Apache-2.0
#include "results/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>

#include "jet_loads.hpp"
#include "results/impactor_picture.hpp"
#include "results/results.hpp"

namespace driver {
namespace {

using Values = std::function<double(int index, int component)>;

void data_array(std::string& out, const char* name, int components, int count, const Values& value,
                const char* type = "Float64") {
  fmt::format_to(std::back_inserter(out),
                 "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type,
                 name, components);
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < components; ++c) fmt::format_to(std::back_inserter(out), "{} ", value(i, c));
    out += '\n';
  }
  out += "</DataArray>\n";
}

void connectivity(std::string& out, const mesh::Mesh& mesh) {
  out += "<Polys>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for (int e = 0; e < mesh.element_count(); ++e)
    fmt::format_to(std::back_inserter(out), "{} {} {}\n", mesh.elements(0, e), mesh.elements(1, e),
                   mesh.elements(2, e));
  out += "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n";
  for (int e = 1; e <= mesh.element_count(); ++e) fmt::format_to(std::back_inserter(out), "{}\n", 3 * e);
  out += "</DataArray>\n</Polys>\n";
}

// Whole numbers, which `gasjet mesh convert` takes for panels.
void panel_array(std::string& out, const mesh::Mesh& mesh) {
  data_array(
      out, "panel", 1, mesh.element_count(),
      [&](int e, int) { return mesh.panel[static_cast<std::size_t>(e)]; }, "Int32");
}

void element_data(std::string& out, const Scene& scene, const State& state) {
  const auto count = static_cast<std::size_t>(scene.bag->model.element_count);
  std::vector<membrane::PlaneResponse<double>> fabric;
  for (std::size_t e = 0; e < count; ++e)
    fabric.push_back(membrane::element_response(scene.bag->model, *state.bag, static_cast<int>(e)).response);
  const JetLoads jets = jet_loads(state, count);
  const double gauge = state.bag->gauge_pressure;
  const auto add = [&](const char* name, const auto& value) {
    data_array(out, name, 1, static_cast<int>(count),
               [&](int e, int) { return value(static_cast<std::size_t>(e)); });
  };
  out += "<CellData>\n";
  panel_array(out, scene.bag->mesh);
  add("principal_stress_Pa", [&](std::size_t e) { return fabric[e].stress_1; });
  add("principal_strain", [&](std::size_t e) { return fabric[e].strain_1; });
  add("overpressure_Pa", [&](std::size_t e) { return gauge + jets.overpressure[e]; });
  add("jet_overpressure_Pa", [&](std::size_t e) { return jets.overpressure[e]; });
  add("jet_mask", [&](std::size_t e) { return int{jets.mask[e]}; });
  out += "</CellData>\n";
}

// The first lines of a VTK file of a type.
std::string head(const ResultFolder& folder, const char* type) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- run: {} -->\n<VTKFile type=\"{}\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n",
      folder.run(), type);
}

std::string bag_polydata(const std::string& first, const Scene& scene, const State& state) {
  const auto& mesh = scene.bag->mesh;
  const auto position = state.bag->position.map();
  const auto velocity = state.bag->velocity.map();
  std::string out = first + "<PolyData>\n";
  fmt::format_to(std::back_inserter(out), "<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n<Points>\n",
                 mesh.node_count(), mesh.element_count());
  data_array(out, "Points", 3, mesh.node_count(), [&](int n, int c) { return position(c, n); });
  out += "</Points>\n";
  connectivity(out, mesh);
  out += "<PointData>\n";
  data_array(out, "velocity_m_s", 3, mesh.node_count(), [&](int n, int c) { return velocity(c, n); });
  out += "</PointData>\n";
  element_data(out, scene, state);
  out += "</Piece>\n</PolyData>\n</VTKFile>\n";
  return out;
}

// A line from the pivot to the impactor's centre; `radius_m` on its end point scales a sphere glyph.
std::string pendulum_polydata(const std::string& first, const Scene& scene, const State& state) {
  const auto& model = scene.pendulum->model;
  const Eigen::Vector3d pivot = model.parameters().pivot;
  const Eigen::Vector3d centre = model.impactor_centre(state.pendulum->motion.angle);
  std::string out = first +
                    "<PolyData>\n"
                    "<Piece NumberOfPoints=\"2\" NumberOfLines=\"1\">\n<Points>\n";
  data_array(out, "Points", 3, 2, [&](int n, int c) { return n == 0 ? pivot(c) : centre(c); });
  out +=
      "</Points>\n<Lines>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n0 "
      "1\n</DataArray>\n"
      "<DataArray type=\"Int32\" Name=\"offsets\" "
      "format=\"ascii\">\n2\n</DataArray>\n</Lines>\n<PointData>\n";
  data_array(out, "radius_m", 1, 2,
             [&](int n, int) { return n == 0 ? 0.0 : model.parameters().impactor_radius; });
  out += "</PointData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return out;
}

std::string impactor_polydata(const Scene& scene, const State& state) {
  mesh::Mesh picture = impactor_picture(scene.impactor);
  picture.nodes = (state.level.impactor.axes * picture.nodes).colwise() + state.level.impactor.centre;
  return polydata_of(picture);
}

}  // namespace

std::string polydata_of(const mesh::Mesh& mesh) {
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n";
  fmt::format_to(std::back_inserter(out),
                 "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfPolys=\"{}\">\n<Points>\n",
                 mesh.node_count(), mesh.element_count());
  data_array(out, "Points", 3, mesh.node_count(), [&](int n, int c) { return mesh.nodes(c, n); });
  out += "</Points>\n";
  connectivity(out, mesh);
  out += "<CellData>\n";
  panel_array(out, mesh);
  return out + "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

FieldWriter::FieldWriter(ResultFolder& folder, const Scene& scene) : folder_(folder), scene_(scene) {}

void FieldWriter::write(const State& state) {
  const auto frame = fmt::format("{:05d}.vtp", files_.size());
  const std::string bag_file = "bag_" + frame, first = head(folder_, "PolyData");
  folder_.write(bag_file, bag_polydata(first, scene_, state));
  if (scene_.pendulum) folder_.write("pendulum_" + frame, pendulum_polydata(first, scene_, state));
  if (scene_.body) folder_.write("impactor_" + frame, impactor_polydata(scene_, state));
  files_.emplace_back(state.time, bag_file);
  write_collection();
}

void FieldWriter::write_collection() const {
  std::string out = head(folder_, "Collection") + "<Collection>\n";
  for (const auto& [time, file] : files_) {
    fmt::format_to(std::back_inserter(out), "<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                   file);
    if (scene_.has_impactor())
      fmt::format_to(std::back_inserter(out), "<DataSet timestep=\"{}\" part=\"1\" file=\"{}_{}\"/>\n", time,
                     scene_.pendulum ? "pendulum" : "impactor", file.substr(4));
  }
  out += "</Collection>\n</VTKFile>\n";
  folder_.write("fields.pvd", out);
}

}  // namespace driver
