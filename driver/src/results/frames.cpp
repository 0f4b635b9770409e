// SPDX-License-Identifier: Apache-2.0
#include "driver/frames.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "driver/formats.hpp"
#include "driver/results.hpp"
#include "jet/jet.hpp"
#include "results/jet_loads.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "frames.bin is little-endian");
constexpr double kTop = 65535.0;  // largest 16-bit number

// Numbers of a frame, in this order, then one velocity [m/s] for each jet.
constexpr const char* kScalars[] = {"time_s",       "overpressure_Pa", "x_m",          "y_m",
                                    "z_m",          "position_step_m", "impactor_x_m", "impactor_y_m",
                                    "impactor_z_m", "speed_step_m_s",  "jet_step_Pa",  "strain_low",
                                    "strain_step"};

Json point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

// Sections of a jet along its axis, as far as the skin can be: distance and half width at the cut-off [m].
Json jet_json(const jet::JetModel& model, double reach) {
  constexpr int sections = 24;
  const bool round = model.shape == jet::OutletShape::round;
  const Eigen::Vector3d across = round ? model.axis.unitOrthogonal().eval() : model.long_direction;
  Json json{{"centre_m", point(model.centre)},
            {"axis", point(model.axis)},
            {"across", point(across)},
            {"half_length_m", round ? 0.0 : 0.5 * model.long_side},
            {"half_width_m", round ? model.radius : 0.5 * model.short_side}};
  for (int i = 0; i <= sections; ++i) {
    const double z = reach * i / sections;
    const double edge = model.cut_off > 0.0 ? std::sqrt(std::log(1.0 / model.cut_off)) : 1.0;
    json["sections_m"].push_back({z, jet::section(model, z).width * edge});
  }
  return json;
}

Json header(const Scene& scene, const std::string& run) {
  const BagPart& bag = *scene.bag;
  const int nodes = bag.model.node_count, elements = bag.model.element_count;
  const Eigen::Vector3d size = bag.mesh.nodes.rowwise().maxCoeff() - bag.mesh.nodes.rowwise().minCoeff();
  Json json{{"file", frames_file}, {"format", formats::results}, {"run", run}, {"scene", scene.name},
            {"nodes", nodes},      {"elements", elements}};
  json["scalars"] = kScalars;
  for (std::size_t j = 0; j < scene.jets.size(); ++j) json["scalars"].push_back(fmt::format("jet_{}_m_s", j));
  json["jets"] = json["straps"] = json["plates"] = Json::array();
  for (const JetPart& jet : scene.jets) json["jets"].push_back(jet_json(jet.field.model(), size.norm()));
  for (const auto& strap : bag.model.description.straps)
    json["straps"].push_back({strap.node_a, strap.node_b});
  for (const auto& plate : bag.model.description.plates)
    json["plates"].push_back({{"point_m", point(plate.point)}, {"normal", point(plate.normal)}});
  if (scene.pendulum) {
    const auto& pendulum = scene.pendulum->model.parameters();
    json["pendulum"] = {{"pivot_m", point(pendulum.pivot)}, {"radius_m", pendulum.impactor_radius}};
  }
  json["frame_bytes"] = frame_bytes(json["scalars"].size(), static_cast<std::size_t>(nodes),
                                    static_cast<std::size_t>(elements));
  for (int e = 0; e < elements; ++e)
    json["triangles"].push_back({bag.mesh.elements(0, e), bag.mesh.elements(1, e), bag.mesh.elements(2, e)});
  return json;
}

/// The bytes of a frame, filled from the front.
class Bytes {
 public:
  explicit Bytes(std::size_t size) : bytes_(size, '\0') {}
  template <typename Number>
  void put_number(Number number) {
    std::memcpy(bytes_.data() + at_, &number, sizeof number);
    at_ += sizeof number;
  }
  /// (value - low) / step of each, rounded.
  template <typename Value>
  void put_steps(std::size_t count, double low, double step, const Value& value) {
    const double scale = step > 0.0 ? 1.0 / step : 0.0;
    char* const to = bytes_.data() + at_;
    for (std::size_t i = 0; i < count; ++i) {
      const auto steps = static_cast<std::uint16_t>(static_cast<int>((value(i) - low) * scale + 0.5));
      std::memcpy(to + sizeof steps * i, &steps, sizeof steps);
    }
    at_ += sizeof(std::uint16_t) * count;
  }
  void put_bytes(std::span<const std::uint8_t> bytes) {
    std::memcpy(bytes_.data() + at_, bytes.data(), bytes.size());
    at_ += bytes.size();
  }
  const std::string& all() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

double step_of(std::span<const double> values) {
  return values.empty() ? 0.0 : *std::ranges::max_element(values) / kTop;
}

}  // namespace

FrameWriter::FrameWriter(ResultFolder& folder, const Scene& scene)
    : file_(folder.add("frames.bin")), stream_(file_, std::ios::binary), scene_(scene) {
  if (!stream_) throw OutputError(fmt::format("{}: not writable", file_.string()));
  stream_ << header(scene, folder.run()).dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
}

void FrameWriter::write(const State& state) {
  const auto position = state.bag->position.map();
  const auto velocity = state.bag->velocity.map();
  const auto nodes = static_cast<std::size_t>(position.cols());
  const auto elements = static_cast<std::size_t>(scene_.bag->model.element_count);
  const Eigen::Vector3d low = position.rowwise().minCoeff(), high = position.rowwise().maxCoeff();
  const double step = (high - low).maxCoeff() / kTop;
  std::vector<double> strain(elements);
  membrane::largest_strains(scene_.bag->model, *state.bag, strain);
  const auto [least, largest] = std::ranges::minmax(strain);
  const double strain_step = (largest - least) / kTop;
  const JetLoads jets = jet_loads(state, elements);
  std::vector<double> speed(nodes);
  for (std::size_t n = 0; n < nodes; ++n) speed[n] = velocity.col(static_cast<Eigen::Index>(n)).norm();
  const Eigen::Vector3d impactor = state.pendulum ? state.pendulum->centre : Eigen::Vector3d::Zero();
  const double gauge = state.bag->gauge_pressure;
  const double speed_step = step_of(speed), jet_step = step_of(jets.overpressure);
  Bytes out(frame_bytes(std::size(kScalars) + state.jets.size(), nodes, elements));
  for (const double number : {state.time, gauge, low.x(), low.y(), low.z(), step, impactor.x(), impactor.y(),
                              impactor.z(), speed_step, jet_step, least, strain_step})
    out.put_number(number);
  for (const JetRun& run : state.jets) out.put_number(run.outlet.velocity);
  for (Eigen::Index n = 0; n < position.cols(); ++n)
    out.put_steps(3, 0.0, step, [&](std::size_t c) {
      const auto axis = static_cast<Eigen::Index>(c);
      return position(axis, n) - low(axis);
    });
  out.put_steps(nodes, 0.0, speed_step, [&](std::size_t n) { return speed[n]; });
  out.put_steps(elements, 0.0, jet_step, [&](std::size_t e) { return jets.overpressure[e]; });
  out.put_steps(elements, least, strain_step, [&](std::size_t e) { return strain[e]; });
  out.put_bytes(jets.mask);
  stream_.write(out.all().data(), static_cast<std::streamsize>(out.all().size())).flush();
  if (!stream_) throw WriteError(fmt::format("{}: write failed (disk full?)", file_.string()));
}

}  // namespace driver
