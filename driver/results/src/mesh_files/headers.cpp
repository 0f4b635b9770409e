// SPDX-License-Identifier: Apache-2.0
#include "headers.hpp"

#include <cstdint>
#include <cstring>
#include <set>
#include <sstream>

#include "mesh/mesh_file.hpp"

namespace driver {
namespace {

class Header {
 public:
  Header(const std::filesystem::path& path, const std::string& bytes)
      : path_(path), bytes_(bytes), text_(bytes) {}

  void binary_stl() const {
    constexpr std::size_t header = 84, facet = 50;
    if (bytes_.size() < header)
      fail(0, "neither STL text, which begins with solid, nor binary: it is too short");
    std::uint32_t count = 0;
    std::memcpy(&count, bytes_.data() + 80, sizeof count);
    const std::size_t rest = bytes_.size() - header;
    if (rest != facet * std::size_t{count})
      fail(0, "binary STL announces " + std::to_string(count) + " facets, but has " +
                  std::to_string(rest / facet) + (rest % facet == 0 ? "" : " and a part of one"));
  }

  void ply() {
    for (std::string line; std::getline(text_, line);) {
      ++line_;
      std::istringstream words(line);
      std::string word, second;
      words >> word >> second;
      if (line_ <= 2) {
        begin_ply(word, second);
      } else if (word == "end_header") {
        return end_ply();
      } else if (word == "element") {
        element_ = second;
        count(words, "the number of elements is missing");
        announced_ += (announced_.empty() ? "" : ", ") + line;
      } else if (word == "property") {
        property(words, second);
      }
    }
    fail(0, "the file ends before end_header");
  }

  // The counts in the header of a PLY file.
  const std::string& announced() const { return announced_; }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& message) const {
    throw mesh::MeshFileError(path_.string(), line, line == 0 ? 0 : 1, message);
  }

  void begin_ply(const std::string& word, const std::string& second) const {
    if (line_ == 1 && word != "ply") fail(1, "a PLY file begins with ply");
    if (line_ == 2 && word != "format") fail(2, "the format is missing, such as format ascii 1.0");
    if (line_ == 2 && second != "ascii" && second != "binary_little_endian" && second != "binary_big_endian")
      fail(2, "the format is not ascii, binary_little_endian or binary_big_endian");
  }

  // Every item needs at least one byte.
  void count(std::istringstream& words, const char* missing) const {
    double number = -1.0;
    if (!(words >> number)) fail(line_, missing);
    if (!(number >= 0.0 && number <= static_cast<double>(bytes_.size())))
      fail(line_, "more items are announced than the file can hold");
  }

  void property(std::istringstream& words, const std::string& second) {
    static const std::set<std::string> real = {"float", "float32", "double", "float64"};
    static const std::set<std::string> index = {"int", "int32", "uint", "uint32"};
    // A damaged length of four bytes could fill the memory.
    static const std::set<std::string> small = {"char",  "int8",  "uchar",  "uint8",
                                                "short", "int16", "ushort", "uint16"};
    std::string type = second, name;
    if (second == "list") {
      std::string length;
      words >> length >> type;
      if (!small.contains(length)) fail(line_, "the length of a list must be uchar or ushort");
    }
    words >> name;
    if (!words) fail(line_, "a property has a type and a name");
    if (!real.contains(type) && !index.contains(type) && !small.contains(type))
      fail(line_, "type " + type + " is not one of PLY");
    if (second != "list" && element_.starts_with("vert") && real.contains(type)) coordinates_.insert(name);
    if (second == "list" && element_.starts_with("face") && index.contains(type)) lists_.insert(name);
  }

  void end_ply() const {
    for (const char* name : {"x", "y", "z"})
      if (!coordinates_.contains(name))
        fail(line_, std::string("the header has no property ") + name + " of a vertex, float or double");
    if (!lists_.contains("vertex_indices") && !lists_.contains("vertex_index"))
      fail(line_, "the header has no list vertex_indices of a face, int or uint");
  }

  const std::filesystem::path& path_;
  const std::string& bytes_;
  std::istringstream text_;
  std::size_t line_ = 0;
  std::string announced_;
  std::string element_;                        // to which the properties belong
  std::set<std::string> coordinates_, lists_;  // properties of vertices and faces
};

}  // namespace

std::string check_header(const std::filesystem::path& path, SoupFormat format, const std::string& bytes) {
  Header header(path, bytes);
  if (format == SoupFormat::stl) header.binary_stl();
  if (format == SoupFormat::ply) header.ply();
  return header.announced();
}

}  // namespace driver
