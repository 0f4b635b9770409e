// SPDX-License-Identifier: Apache-2.0
#include "results/bag_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>
#include <vector>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "base/text_file.hpp"
#include "results/frames.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& message) {
  throw CaseError(fmt::format("{}: {}", file.string(), message));
}

// Position of the stored time nearest to `time`.
std::size_t nearest(const std::vector<double>& times, double time, const std::filesystem::path& file) {
  const double slack = 1e-9 * std::abs(times.back());
  if (!(time >= times.front() - slack && time <= times.back() + slack))
    throw CaseError(fmt::format("--time {:g}: {} has times from {:g} to {:g} s", time, file.string(),
                                times.front(), times.back()));
  const auto later = [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); };
  return static_cast<std::size_t>(std::min_element(times.begin(), times.end(), later) - times.begin());
}

// Text of an XML file that this program wrote. Its numbers and attributes are read one after another.
class XmlText {
 public:
  // Throws CaseError for a file of a run that has not ended, or of another run than its folder.
  explicit XmlText(const std::filesystem::path& file) : file_(file), text_(read_text(file)) {
    need("<!-- run: ");
    const auto end = std::min(text_.find(" -->", at_), text_.size());
    require_whole(file, text_.substr(at_, end - at_));
  }

  bool find(std::string_view what) {
    const auto place = text_.find(what, at_);
    if (place == std::string::npos) return false;
    at_ = place + what.size();
    return true;
  }
  void need(std::string_view what) {
    if (!find(what))
      fail(file_, fmt::format("'{}' is missing: the file is damaged, or not from gasjet", what));
  }
  std::string quoted(std::string_view attribute) {
    need(fmt::format(" {}=\"", attribute));
    const auto end = std::min(text_.find('"', at_), text_.size());
    return text_.substr(at_, end - at_);
  }
  template <class Number>
  Number number(std::string_view text) const {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail(file_, fmt::format("'{}' is not a number", text));
    if constexpr (std::is_floating_point_v<Number>)
      if (!std::isfinite(value)) fail(file_, fmt::format("'{}' is not finite", text));
    return value;
  }
  template <class Number>
  Number next() {
    const auto begin = std::min(text_.find_first_not_of(" \n", at_), text_.size());
    at_ = std::min(text_.find_first_of(" \n", begin), text_.size());
    return number<Number>(std::string_view(text_).substr(begin, at_ - begin));
  }
  // Moves to the numbers of an array.
  void array(std::string_view name) {
    need(fmt::format("Name=\"{}\"", name));
    need(">");
  }
  // A count of items that each need at least two characters.
  int count(std::string_view attribute) {
    const int value = number<int>(quoted(attribute));
    if (value < 1 || static_cast<std::size_t>(value) > text_.size() / 2)
      fail(file_, fmt::format("{} is {}, more than the file can contain", attribute, value));
    return value;
  }

 private:
  std::filesystem::path file_;
  std::string text_;
  std::size_t at_ = 0;
};

// Names the panels by the header of the run's frames, if it has the same elements.
void name_panels(mesh::Mesh& mesh, const Json& header) {
  const auto elements = static_cast<std::size_t>(mesh.element_count());
  const auto list = [&](const char* key) {
    const bool is_list = header.is_object() && header.contains(key) && header[key].is_array();
    return is_list ? header[key] : Json::array();
  };
  const Json panels = list("panels"), names = list("panel_names");
  const auto is_panel = [&](const Json& panel) {
    return panel.is_number_unsigned() && panel.get<std::size_t>() < names.size();
  };
  if (panels.size() == elements && std::ranges::all_of(panels, is_panel) &&
      std::ranges::all_of(names, &Json::is_string)) {
    mesh.panel = panels.get<std::vector<int>>();
    mesh.panel_names = names.get<std::vector<std::string>>();
    return;
  }
  mesh.panel.resize(elements, 0);
  const int count = 1 + *std::max_element(mesh.panel.begin(), mesh.panel.end());
  for (int i = 0; i < count; ++i) mesh.panel_names.push_back(fmt::format("panel_{}", i));
}

mesh::Mesh read_polydata(const std::filesystem::path& file) {
  XmlText text(file);
  mesh::Mesh mesh;
  mesh.nodes.resize(3, text.count("NumberOfPoints"));
  mesh.elements.resize(3, text.count("NumberOfPolys"));
  text.array("Points");
  for (double& x : mesh.nodes.reshaped()) x = text.next<double>();
  text.array("connectivity");
  for (int& node : mesh.elements.reshaped()) {
    node = text.next<int>();
    if (node < 0 || node >= mesh.node_count()) fail(file, fmt::format("node {} is out of range", node));
  }
  text.array("panel");
  for (int e = 0; e < mesh.element_count(); ++e) {
    mesh.panel.push_back(static_cast<int>(text.next<double>()));
    if (mesh.panel.back() < 0 || mesh.panel.back() >= mesh.element_count())
      fail(file, "a panel is out of range");
  }
  return mesh;
}

BagShape of_fields(const std::filesystem::path& collection, double time) {
  XmlText text(collection);
  std::vector<double> times;
  std::vector<std::string> files;
  while (text.find("<DataSet")) {
    const double at = text.number<double>(text.quoted("timestep"));
    if (text.quoted("part") != "0") continue;
    times.push_back(at);
    files.push_back(text.quoted("file"));
  }
  if (times.empty()) fail(collection, "names no bag");
  const std::size_t i = nearest(times, time, collection);
  if (files[i].find('/') != std::string::npos) fail(collection, "names a file of another folder");
  BagShape shape{read_polydata(collection.parent_path() / files[i]), times[i], files[i], 0.0};
  std::string header;
  std::getline(std::ifstream(collection.parent_path() / "frames.bin"), header);
  name_panels(shape.mesh, Json::parse(header, nullptr, false));
  return shape;
}

double scalar(const Frames& frames, std::size_t frame, const char* name) {
  const Json& names = frames.header["scalars"];
  const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (place == names.size()) throw CaseError(fmt::format("frames.bin: its header lacks {}", name));
  double value;
  const auto size = frames.header["frame_bytes"].get<std::size_t>();
  std::memcpy(&value, frames.data.data() + frame * size + 8 * place, sizeof value);
  return value;
}

BagShape of_frames(const std::filesystem::path& file, double time) {
  const Frames frames = load_frames(file);
  if (frames.header.value("rigid", false)) fail(file, "is of a rigid target, needed: a run with a bag");
  const auto size = frames.header["frame_bytes"].get<std::size_t>();
  std::vector<double> times;
  for (std::size_t i = 0; i < frames.data.size() / size; ++i) times.push_back(scalar(frames, i, "time_s"));
  const std::size_t frame = nearest(times, time, file);
  const double step = scalar(frames, frame, "position_step_m");
  const Eigen::Vector3d low(scalar(frames, frame, "x_m"), scalar(frames, frame, "y_m"),
                            scalar(frames, frame, "z_m"));
  BagShape shape{{}, times[frame], file.filename().string(), 0.5 * step};
  shape.mesh.nodes.resize(3, frames.header["nodes"].get<Eigen::Index>());
  const char* positions = frames.data.data() + frame * size + 8 * frames.header["scalars"].size();
  for (Eigen::Index i = 0; i < shape.mesh.nodes.size(); ++i) {
    std::uint16_t steps;
    std::memcpy(&steps, positions + 2 * i, sizeof steps);
    shape.mesh.nodes(i % 3, i / 3) = low(i % 3) + step * steps;
  }
  const Json& triangles = frames.header["triangles"];
  shape.mesh.elements.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (Eigen::Index e = 0; e < shape.mesh.elements.cols(); ++e)
    for (Eigen::Index k = 0; k < 3; ++k)
      shape.mesh.elements(k, e) =
          triangles[static_cast<std::size_t>(e)].at(static_cast<std::size_t>(k)).get<int>();
  name_panels(shape.mesh, frames.header);
  return shape;
}

}  // namespace

BagShape read_bag_shape(const std::filesystem::path& results, double time) {
  std::error_code ignored;
  const auto fields = results / "fields.pvd", frames = results / "frames.bin";
  if (std::filesystem::exists(fields, ignored)) return of_fields(fields, time);
  if (std::filesystem::exists(frames, ignored)) return of_frames(frames, time);
  fail(results, "has neither fields.pvd nor frames.bin of a run with a bag");
}

}  // namespace driver
