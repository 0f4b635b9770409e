// SPDX-License-Identifier: Apache-2.0
#include "mesh/obj.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>
#include <vector>

#include "mesh_builder.hpp"
#include "mesh_text.hpp"

namespace mesh {
namespace {

struct Token {
  std::string_view text;
  std::size_t line, column;  // from 1
};

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// Appends the words of a line. True if a backslash at its end continues the statement.
bool split(std::string_view line, std::size_t number, std::vector<Token>& tokens) {
  line = line.substr(0, line.find('#'));
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  const bool goes_on = line.ends_with('\\');
  if (goes_on) line.remove_suffix(1);
  for (std::size_t i = 0; i < line.size();) {
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    const std::size_t start = i;
    while (i < line.size() && !is_blank(line[i])) ++i;
    tokens.push_back({line.substr(start, i - start), number, start + 1});
  }
  return goes_on;
}

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Mesh parse() {
    while (!text_.empty()) {
      std::vector<Token> tokens;
      bool goes_on = true;
      while (goes_on && !text_.empty()) {
        const std::string_view line = next_line();
        goes_on = split(line, line_, tokens);
      }
      statement(tokens);
    }
    if (mesh_.empty()) throw MeshFileError(name_, 0, 0, "the file has no elements (f)");
    return std::move(mesh_).finish(name_);
  }

 private:
  std::string_view next_line() {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_;
    return line;
  }

  [[noreturn]] void fail(const Token& at, const std::string& message) const {
    throw MeshFileError(name_, at.line, at.column, message);
  }

  void statement(const std::vector<Token>& tokens) {
    static constexpr std::array<std::string_view, 8> skipped = {"vt", "vn", "vp",     "s",
                                                                "l",  "p",  "usemtl", "mtllib"};
    if (tokens.empty()) return;
    const std::string_view keyword = tokens[0].text;
    if (keyword == "v") return node(tokens);
    if (keyword == "f") return polygon(tokens);
    if (keyword == "g" || keyword == "o") return panel(tokens);
    if (std::find(skipped.begin(), skipped.end(), keyword) == skipped.end())
      fail(tokens[0], shown(keyword) +
                          " is not a supported statement; allowed: v, f, g, o (vt, vn, vp, s, l, p, usemtl, "
                          "mtllib are skipped)");
  }

  void node(const std::vector<Token>& tokens) {
    if (tokens.size() != 4 && tokens.size() != 5 && tokens.size() != 7)
      fail(tokens[0], "v needs 3 coordinates (and at most a weight, or 3 colours), has " +
                          std::to_string(tokens.size() - 1));
    if (mesh_.node_count() == std::numeric_limits<int>::max() / 3) fail(tokens[0], "too many nodes");
    mesh_.add_node({number(tokens[1]), number(tokens[2]), number(tokens[3])});
    for (std::size_t i = 4; i < tokens.size(); ++i) number(tokens[i]);
  }

  double number(const Token& token) const {
    double value = 0.0;
    if (const std::string fault = number_fault(token.text, value); !fault.empty()) fail(token, fault);
    return value;
  }

  void panel(const std::vector<Token>& tokens) {
    panel_name_.clear();
    for (std::size_t i = 1; i < tokens.size(); ++i)
      panel_name_.append(i > 1 ? "_" : "").append(tokens[i].text);
    if (panel_name_.empty()) panel_name_ = "default";
  }

  void polygon(const std::vector<Token>& tokens) {
    const std::size_t count = tokens.size() - 1;
    if (count < 3) fail(tokens[0], "f needs 3 corners or more, has " + std::to_string(count));
    std::vector<int> corners;
    for (std::size_t i = 1; i <= count; ++i) corners.push_back(corner(tokens[i]));
    mesh_.add_polygon(corners, panel_name_, tokens[0].line);
  }

  int corner(const Token& token) const {
    const std::string_view text = token.text;
    const int node = index(token, text.substr(0, text.find('/')));
    std::size_t slash = text.find('/');
    for (int part = 1; slash != std::string_view::npos; ++part) {
      const std::size_t next = text.find('/', slash + 1);
      const std::string_view field = text.substr(slash + 1, next == text.npos ? text.npos : next - slash - 1);
      const bool may_be_empty = part == 1 && next != text.npos;  // i//k
      if (part > 2) fail(token, shown(text) + " has more than the three fields i/j/k");
      if (!(field.empty() && may_be_empty)) integer(token, field);
      slash = next;
    }
    return node;
  }

  long long integer(const Token& token, std::string_view field) const {
    long long value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (field.empty() || error != std::errc() || end != field.data() + field.size())
      fail(token, shown(token.text) + " is not a corner; allowed: i, i/j, i//k, i/j/k with whole numbers");
    return value;
  }

  int index(const Token& token, std::string_view field) const {
    const long long value = integer(token, field);
    const long long size = mesh_.node_count();
    if (value == 0) fail(token, "node index 0; indices count from 1, or back from -1");
    if (value > size || value < -size)
      fail(token, "node index " + std::to_string(value) + " is out of range: " + std::to_string(size) +
                      " nodes above this line");
    return static_cast<int>(value > 0 ? value - 1 : size + value);
  }

  std::string_view text_;  // text still to be read
  std::string name_;
  std::size_t line_ = 0;  // number of the last line read
  MeshBuilder mesh_;
  std::string panel_name_ = "default";
};

}  // namespace

Mesh parse_obj(std::string_view text, const std::string& name) {
  return ObjParser(text, name).parse();
}

}  // namespace mesh
