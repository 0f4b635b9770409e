// SPDX-License-Identifier: Apache-2.0
#include "results/frames.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstring>
#include <elementary/exponential.hpp>
#include <nlohmann/json.hpp>
#include <span>

#include "base/formats.hpp"
#include "jet/jet.hpp"
#include "jet_loads.hpp"
#include "results/impactor_picture.hpp"
#include "results/results.hpp"
#include "target_picture.hpp"

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

// Quaternion of an impactor other than a sphere on a pendulum, after those of the jets.
constexpr const char* kTurn[] = {"impactor_turn_w", "impactor_turn_x", "impactor_turn_y", "impactor_turn_z"};

bool turns(const Scene& scene) {
  return scene.body || (scene.pendulum && !std::holds_alternative<coupling::Sphere>(scene.impactor));
}

Json point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

// Sections of a jet along its axis, up to the farthest possible skin: distance and half width at the cut-off
// [m].
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
    const double edge = model.cut_off > 0.0 ? std::sqrt(elementary::log(1.0 / model.cut_off)) : 1.0;
    json["sections_m"].push_back({z, jet::section(model, z).width * edge});
  }
  return json;
}

double largest_distance(const Eigen::Vector3d& from, const Eigen::Matrix3Xd& points) {
  return (points.colwise() - from).colwise().norm().maxCoeff();
}

// Adds the parts of a bag other than its skin.
void add_bag(Json& json, const BagPart& bag) {
  json["panel_names"] = bag.mesh.panel_names;
  json["panels"] = bag.mesh.panel;  // of each element
  for (const auto& strap : bag.model.description.straps)
    json["straps"].push_back({strap.node_a, strap.node_b});
  for (const auto& plate : bag.model.description.plates)
    json["plates"].push_back({{"point_m", point(plate.point)}, {"normal", point(plate.normal)}});
}

Json header(const Scene& scene, const std::string& run, const TargetPicture* target) {
  const Eigen::Matrix3Xd& nodes = target ? target->nodes() : scene.bag->mesh.nodes;
  const Eigen::Matrix3Xi& triangles = target ? target->triangles() : scene.bag->mesh.elements;
  const Eigen::Vector3d size = nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff();
  Json json{{"file", frames_file},         {"format", formats::results}, {"run", run},
            {"scene", scene.name},         {"rigid", target != nullptr}, {"nodes", nodes.cols()},
            {"elements", triangles.cols()}};
  json["scalars"] = kScalars;
  for (std::size_t j = 0; j < scene.jets.size(); ++j) json["scalars"].push_back(fmt::format("jet_{}_m_s", j));
  json["jets"] = json["straps"] = json["plates"] = Json::array();
  for (const JetPart& jet : scene.jets) {
    const jet::JetModel& model = jet.field.model();
    json["jets"].push_back(jet_json(model, target ? largest_distance(model.centre, nodes) : size.norm()));
  }
  if (scene.bag) add_bag(json, *scene.bag);
  if (turns(scene)) {
    for (const char* name : kTurn) json["scalars"].push_back(name);
    const mesh::Mesh picture = impactor_picture(scene.impactor);
    json["impactor"] = {{"nodes_m", Json::array()}, {"triangles", Json::array()}};
    for (const auto& node : picture.nodes.colwise()) json["impactor"]["nodes_m"].push_back(point(node));
    for (const auto& t : picture.elements.colwise())
      json["impactor"]["triangles"].push_back({t[0], t[1], t[2]});
    if (scene.pendulum) json["impactor"]["pivot_m"] = point(scene.pendulum->model.parameters().pivot);
  } else if (scene.pendulum) {
    const auto& pendulum = scene.pendulum->model.parameters();
    json["pendulum"] = {{"pivot_m", point(pendulum.pivot)}, {"radius_m", pendulum.impactor_radius}};
  }
  json["frame_bytes"] = frame_bytes(json["scalars"].size(), static_cast<std::size_t>(nodes.cols()),
                                    static_cast<std::size_t>(triangles.cols()));
  for (Eigen::Index e = 0; e < triangles.cols(); ++e)
    json["triangles"].push_back({triangles(0, e), triangles(1, e), triangles(2, e)});
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
  /// Puts (value - low) / step of each, rounded. A separate loop lets the compiler vectorise it.
  void put_steps(std::span<const double> values, double low, double step) {
    const double scale = step > 0.0 ? 1.0 / step : 0.0;
    std::vector<std::uint16_t> steps(values.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
      steps[i] = static_cast<std::uint16_t>(static_cast<int>((values[i] - low) * scale + 0.5));
    std::memcpy(bytes_.data() + at_, steps.data(), sizeof(std::uint16_t) * steps.size());
    at_ += sizeof(std::uint16_t) * steps.size();
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

// Content of a frame.
struct Surface {
  jet::Points position;               // [m]
  std::vector<double> speed, strain;  // of nodes [m/s], of elements
  JetLoads jets;
  double gauge = 0.0;  // [Pa] of the gas
};

Surface of_bag(const Scene& scene, const State& state) {
  const membrane::BagState& bag = *state.bag;
  const auto elements = static_cast<std::size_t>(scene.bag->model.element_count);
  const auto velocity = bag.velocity.map();
  Surface surface{bag.position.map(), std::vector<double>(static_cast<std::size_t>(velocity.cols())),
                  std::vector<double>(elements), jet_loads(state, elements), bag.gauge_pressure};
  membrane::largest_strains(scene.bag->model, bag, surface.strain);
  for (std::size_t n = 0; n < surface.speed.size(); ++n)
    surface.speed[n] = velocity.col(static_cast<Eigen::Index>(n)).norm();
  return surface;
}

// The target does not move.
Surface of_target(const TargetPicture& target, const State& state) {
  return {target.nodes(), std::vector<double>(static_cast<std::size_t>(target.nodes().cols())),
          std::vector<double>(static_cast<std::size_t>(target.triangles().cols())), target.loads(state), 0.0};
}

// Least and largest, in four independent chains, which the processor can overlap.
std::pair<double, double> range_of(std::span<const double> values) {
  if (values.empty()) return {0.0, 0.0};
  double low[4], high[4];
  std::fill_n(low, 4, values[0]);
  std::fill_n(high, 4, values[0]);
  for (std::size_t i = 0; i < values.size(); ++i) {
    low[i % 4] = std::min(low[i % 4], values[i]);
    high[i % 4] = std::max(high[i % 4], values[i]);
  }
  return {*std::min_element(low, low + 4), *std::max_element(high, high + 4)};
}
double step_of(std::span<const double> values) {
  return range_of(values).second / kTop;
}

}  // namespace

FrameWriter::FrameWriter(ResultFolder& folder, const Scene& scene)
    : file_(folder.add("frames.bin")), stream_(file_, std::ios::binary), scene_(scene) {
  if (!stream_) throw OutputError(fmt::format("{}: not writable", file_.string()));
  if (scene.target) target_ = std::make_unique<TargetPicture>(*scene.target);
  // Flushed, because a run may end before its first frame.
  stream_ << header(scene, folder.run(), target_.get()).dump(-1, ' ', false, Json::error_handler_t::replace)
          << '\n'
          << std::flush;
}

FrameWriter::~FrameWriter() = default;

void FrameWriter::write(const State& state) {
  const Surface surface = target_ ? of_target(*target_, state) : of_bag(scene_, state);
  const jet::Points& position = surface.position;
  const std::size_t nodes = surface.speed.size(), elements = surface.strain.size();
  const Eigen::Vector3d low = position.rowwise().minCoeff(), high = position.rowwise().maxCoeff();
  const double step = (high - low).maxCoeff() / kTop;
  const auto [least, largest] = range_of(surface.strain);
  const double strain_step = (largest - least) / kTop;
  const Eigen::Vector3d impactor = state.level.impactor.centre;
  const double speed_step = step_of(surface.speed), jet_step = step_of(surface.jets.overpressure);
  const bool turn = turns(scene_);
  Bytes out(
      frame_bytes(std::size(kScalars) + state.jets.size() + (turn ? std::size(kTurn) : 0), nodes, elements));
  for (const double number : {state.time, surface.gauge, low.x(), low.y(), low.z(), step, impactor.x(),
                              impactor.y(), impactor.z(), speed_step, jet_step, least, strain_step})
    out.put_number(number);
  // A sonic outlet keeps its speed after the flow has ended.
  for (const JetRun& run : state.jets) out.put_number(run.outlet.density > 0.0 ? run.outlet.velocity : 0.0);
  if (turn) {
    const Eigen::Quaterniond q(state.level.impactor.axes);
    for (const double number : {q.w(), q.x(), q.y(), q.z()}) out.put_number(number);
  }
  const Eigen::Matrix3Xd from_corner = position.colwise() - low;
  out.put_steps({from_corner.data(), 3 * nodes}, 0.0, step);
  out.put_steps(surface.speed, 0.0, speed_step);
  out.put_steps(surface.jets.overpressure, 0.0, jet_step);
  out.put_steps(surface.strain, least, strain_step);
  out.put_bytes(surface.jets.mask);
  stream_.write(out.all().data(), static_cast<std::streamsize>(out.all().size())).flush();
  if (!stream_) throw WriteError(fmt::format("{}: write failed (disk full?)", file_.string()));
}

}  // namespace driver
