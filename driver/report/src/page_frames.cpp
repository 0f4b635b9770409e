// SPDX-License-Identifier: Apache-2.0
#include "page_frames.hpp"

#include <cstring>
#include <string>
#include <string_view>

#include "deflate.hpp"
#include "results/frames.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= bytes.size() - i ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

double number_at(std::string_view frame, std::size_t place) {
  double number;
  std::memcpy(&number, frame.data() + 8 * place, sizeof number);
  return number;
}

// Every k-th frame, with the least k for at most `most` bytes.
std::string thinned(const std::string& frames, std::size_t size, std::size_t most) {
  const std::size_t every = (frames.size() + most - 1) / most;
  if (every <= 1) return frames;
  std::string kept;
  for (std::size_t begin = 0; begin < frames.size(); begin += every * size) kept.append(frames, begin, size);
  return kept;
}

}  // namespace

Json read_frames(const std::filesystem::path& file, std::size_t most_bytes) {
  if (std::error_code ignored; !std::filesystem::exists(file, ignored)) return {};
  Frames frames = load_frames(file);
  const auto size = frames.header["frame_bytes"].get<std::size_t>();
  const std::string kept = thinned(frames.data, size, most_bytes);
  return {{"header", std::move(frames.header)},
          {"data", base64(deflated(kept))},
          {"end_s", number_at(std::string_view(frames.data).substr(frames.data.size() - size), 0)},
          {"count", kept.size() / size},
          {"total", frames.data.size() / size}};
}

}  // namespace driver
