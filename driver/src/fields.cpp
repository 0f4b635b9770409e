// SPDX-License-Identifier: Apache-2.0
#include "driver/fields.hpp"

#include <fmt/format.h>

#include <functional>

#include "driver/results.hpp"

namespace driver {
namespace {

using Values = std::function<double(int index, int component)>;

void data_array(std::string& out, const char* name, int components, int count, const Values& value) {
  fmt::format_to(std::back_inserter(out),
                 "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
                 name, components);
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < components; ++c) fmt::format_to(std::back_inserter(out), "{} ", value(i, c));
    out += '\n';
  }
  out += "</DataArray>\n";
}

void connectivity(std::string& out, const membrane::Mesh& mesh) {
  out += "<Polys>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for (int e = 0; e < mesh.element_count(); ++e)
    fmt::format_to(std::back_inserter(out), "{} {} {}\n", mesh.elements(0, e), mesh.elements(1, e),
                   mesh.elements(2, e));
  out += "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n";
  for (int e = 1; e <= mesh.element_count(); ++e) fmt::format_to(std::back_inserter(out), "{}\n", 3 * e);
  out += "</DataArray>\n</Polys>\n";
}

void element_data(std::string& out, const Scene& scene, const State& state) {
  const auto& model = scene.bag->model;
  const int count = model.element_count;
  std::vector<membrane::ElementResponse> responses;
  for (int e = 0; e < count; ++e) responses.push_back(membrane::element_response(model, *state.bag, e));
  std::vector<double> overpressure(static_cast<std::size_t>(count), 0.0),
      candidate(static_cast<std::size_t>(count), 0.0);
  for (const JetRun& run : state.jets)
    for (const int element : run.load().candidates) {
      const auto e = static_cast<std::size_t>(element);
      overpressure[e] += run.load().overpressure[e];
      candidate[e] = run.load().overpressure[e] > 0.0 ? 2.0 : 1.0;  // 2 lit, if only in part; 1 hidden
    }
  const auto at = [](const std::vector<double>& v) {
    return [&v](int e, int) { return v[static_cast<std::size_t>(e)]; };
  };
  out += "<CellData>\n";
  data_array(out, "panel", 1, count,
             [&](int e, int) { return scene.bag->mesh.panel[static_cast<std::size_t>(e)]; });
  data_array(out, "principal_stress_Pa", 1, count,
             [&](int e, int) { return responses[static_cast<std::size_t>(e)].response.stress_1; });
  data_array(out, "principal_strain", 1, count,
             [&](int e, int) { return responses[static_cast<std::size_t>(e)].response.strain_1; });
  data_array(out, "jet_overpressure_Pa", 1, count, at(overpressure));
  data_array(out, "jet_mask", 1, count, at(candidate));
  out += "</CellData>\n";
}

void save(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text << std::flush;
  if (!stream) throw WriteError(fmt::format("{}: write failed", file.string()));
}

std::string bag_polydata(const Scene& scene, const State& state) {
  const auto& mesh = scene.bag->mesh;
  const auto position = state.bag->position.map();
  const auto velocity = state.bag->velocity.map();
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<PolyData>\n";
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
std::string pendulum_polydata(const Scene& scene, const State& state) {
  const auto& model = scene.pendulum->model;
  const Eigen::Vector3d pivot = model.parameters().pivot;
  const Eigen::Vector3d centre = model.impactor_centre(state.pendulum->motion.angle);
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<PolyData>\n"
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

}  // namespace

FieldWriter::FieldWriter(const std::filesystem::path& folder, const Scene& scene)
    : folder_(folder), scene_(scene) {}

void FieldWriter::write(const State& state) {
  const auto frame = fmt::format("{:05d}.vtp", files_.size());
  const std::string bag_file = "bag_" + frame;
  save(folder_ / bag_file, bag_polydata(scene_, state));
  files_.emplace_back(state.time, bag_file);
  if (scene_.pendulum) save(folder_ / ("pendulum_" + frame), pendulum_polydata(scene_, state));
  write_collection();
}

void FieldWriter::write_collection() const {
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const auto& [time, file] : files_) {
    fmt::format_to(std::back_inserter(out), "<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                   file);
    if (scene_.pendulum)
      fmt::format_to(std::back_inserter(out), "<DataSet timestep=\"{}\" part=\"1\" file=\"pendulum_{}\"/>\n",
                     time, file.substr(4));
  }
  out += "</Collection>\n</VTKFile>\n";
  save(folder_ / "fields.pvd", out);
}

}  // namespace driver
