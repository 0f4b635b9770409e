// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/case_reader.hpp"
#include "base/formats.hpp"
#include "base/result_folder.hpp"
#include "results/frames.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

double number_at(std::string_view frame, std::size_t place) {
  double number;
  std::memcpy(&number, frame.data() + 8 * place, sizeof number);
  return number;
}

// True if every corner of every triangle and strap is a node.
bool within(const Json& lists, std::size_t nodes) {
  for (const Json& list : lists)
    for (const Json& node : list)
      if (node.get<std::size_t>() >= nodes) return false;
  return true;
}

std::string fault(const Json& header, std::string_view frames) {
  const auto nodes = header.at("nodes").get<std::size_t>(),
             elements = header.at("elements").get<std::size_t>();
  const auto scalars = header.at("scalars").size(), size = header.at("frame_bytes").get<std::size_t>();
  if (size != frame_bytes(scalars, nodes, elements) || header.at("triangles").size() != elements ||
      !within(header.at("triangles"), nodes) || !within(header.at("straps"), nodes) ||
      !header.at("jets").is_array() || !header.at("plates").is_array())
    return "its header contradicts itself";
  if (frames.empty() || frames.size() % size != 0)
    return fmt::format("has {} bytes of frames, needed: whole frames of {} bytes", frames.size(), size);
  for (std::size_t begin = 0; begin < frames.size(); begin += size)
    for (std::size_t k = 0; k < scalars; ++k) {
      const double number = number_at(frames.substr(begin), k);
      if (!std::isfinite(number))
        return fmt::format("frame {} has a number that is not finite", begin / size);
      if (k == 0 && begin > 0 && !(number > number_at(frames.substr(begin - size), 0)))
        return fmt::format("the time of frame {} does not rise", begin / size);
    }
  return {};
}

}  // namespace

Frames load_frames(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  std::string frames{std::istreambuf_iterator<char>(stream), {}};
  const auto fail = [&](const std::string& message) { throw CaseError(file.string() + ": " + message); };
  Json header = Json::parse(line, nullptr, false);
  if (!header.is_object() || header.value("file", Json()) != frames_file ||
      header.value("format", Json()) != formats::results)
    fail(fmt::format("does not begin as \"{}\" of format {}", frames_file, formats::results));
  try {
    require_whole(file, header.value("run", std::string()));
    if (const std::string message = fault(header, frames); !message.empty()) fail(message);
  } catch (const Json::exception&) {
    fail("its header is incomplete for this version of gasjet");
  }
  return {std::move(header), std::move(frames)};
}

}  // namespace driver
