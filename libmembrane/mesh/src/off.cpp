// SPDX-License-Identifier: Apache-2.0
#include "mesh/off.hpp"

#include <vector>

#include "mesh/merge.hpp"
#include "mesh_builder.hpp"
#include "mesh_text.hpp"
#include "mesh_tokens.hpp"

namespace mesh {
namespace {

std::string without_comments(std::string_view text) {
  std::string result(text);
  bool is_comment = false;
  for (char& c : result) {
    is_comment = c != '\n' && (is_comment || c == '#');
    if (is_comment) c = ' ';
  }
  return result;
}

// Whether each vertex or face has its own line.
enum class Layout { lines, words };

class OffParser {
 public:
  OffParser(std::string_view text, const std::string& name, Layout layout)
      : words_(text, name), layout_(layout) {}

  Mesh parse() {
    header();
    for (std::size_t i = 0; i < vertices_; ++i) vertex(i);
    for (std::size_t i = 0; i < faces_; ++i) face(i);
    end();
    if (mesh_.empty()) throw MeshFileError(words_.name(), 0, 0, "the file has no elements");
    return used_nodes(std::move(mesh_).finish(words_.name()));
  }
  bool has_faces() const { return !mesh_.empty(); }

 private:
  void header() {
    const MeshWord begin = words_.word("OFF");
    if (begin.text != "off" && !begin.text.ends_with("OFF"))
      words_.fail(begin, "an OFF file begins with OFF");
    const std::string_view prefix = begin.text.substr(0, begin.text.size() - 3);
    if (prefix.find_first_of("4n") != std::string_view::npos)
      words_.fail(begin, shown(begin.text) + " is not supported; vertices of three coordinates are");
    if (layout_ == Layout::words && !prefix.empty())
      words_.fail(begin, shown(begin.text) + " needs a line for each vertex");
    const MeshWord first = words_.peek("the number of vertices");
    if (first.text == "BINARY") words_.fail(first, "binary OFF is not supported; write the file as text");
    header_line_ = first.line;
    vertices_ = words_.count("the number of vertices");
    const std::size_t line = words_.peek("the number of faces").line;
    faces_ = words_.count("the number of faces");
    // The number of edges may be missing.
    if (layout_ == Layout::lines)
      words_.rest_of_line();
    else if (line != header_line_ || words_.peek("a vertex").line == line)
      words_.count("the number of edges");
  }

  // Begins an item, in its own line or at the next word.
  void begin(const std::string& what) {
    if (words_.at_end())
      throw MeshFileError(words_.name(), words_.line(), 1,
                          "the file ends here, " + what + " of the header in line " +
                              std::to_string(header_line_) + " is missing");
    item_ = words_.peek("");
  }
  void stay(const char* what) {
    if (layout_ == Layout::lines && words_.peek(what).line != item_.line)
      words_.fail(item_, std::string("the line ends before ") + what);
  }
  void end_item() {
    if (layout_ == Layout::lines) words_.rest_of_line();
  }

  void vertex(std::size_t i) {
    begin("vertex " + std::to_string(i + 1) + " of the " + std::to_string(vertices_));
    Eigen::Vector3d x;
    for (double& coordinate : x) {
      stay("the third coordinate");
      coordinate = words_.number("a coordinate");
    }
    mesh_.add_node(x);
    end_item();
  }

  void face(std::size_t i) {
    begin("face " + std::to_string(i + 1) + " of the " + std::to_string(faces_));
    const std::size_t line = words_.peek("the number of corners").line;
    std::vector<int> corners(words_.count("the number of corners"));
    if (corners.size() < 3)
      words_.fail(item_, "a face of " + std::to_string(corners.size()) + " corners, allowed: 3 or more");
    for (int& corner : corners) {
      stay("the last corner");
      corner = static_cast<int>(words_.integer("a corner", 0, static_cast<long long>(vertices_) - 1));
    }
    mesh_.add_polygon(corners, "default", line);
    end_item();
  }

  void end() {
    if (words_.at_end()) return;
    const MeshWord more = words_.peek("");
    std::size_t lines = 0;
    for (; !words_.at_end(); words_.rest_of_line()) ++lines;
    words_.fail(more, "the header in line " + std::to_string(header_line_) + " announces " +
                          std::to_string(vertices_) + " vertices and " + std::to_string(faces_) +
                          " faces, but the file continues for " + std::to_string(lines) +
                          (lines == 1 ? " line" : " lines") + " here; correct the header");
  }

  TokenReader words_;
  Layout layout_;
  MeshBuilder mesh_;
  std::size_t header_line_ = 0, vertices_ = 0, faces_ = 0;
  MeshWord item_{};
};

}  // namespace

Mesh parse_off(std::string_view text, const std::string& name) {
  const std::string bare = without_comments(text);
  OffParser by_lines(bare, name, Layout::lines);
  try {
    return by_lines.parse();
  } catch (const MeshFileError&) {
    OffParser by_words(bare, name, Layout::words);
    try {
      return by_words.parse();
    } catch (const MeshFileError&) {
      if (by_words.has_faces() && !by_lines.has_faces()) throw;
    }
    throw;
  }
}

}  // namespace mesh
