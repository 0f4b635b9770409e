// SPDX-License-Identifier: Apache-2.0
#include "membrane/obj.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace membrane {
namespace {

struct Token {
  std::string_view text;
  std::size_t column;  // from 1
};

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::vector<Token> split(std::string_view line) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == '#') break;
    if (is_blank(line[i])) {
      ++i;
      continue;
    }
    const std::size_t start = i;
    while (i < line.size() && !is_blank(line[i]) && line[i] != '#') ++i;
    tokens.push_back({line.substr(start, i - start), start + 1});
  }
  return tokens;
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...\"" : "\"");
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Mesh parse() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      ++line_;
      statement(split(text_.substr(0, end)));
      text_.remove_prefix(std::min(end + 1, text_.size()));
    }
    if (elements_.empty()) throw MeshFileError(name_, 0, 0, "the file has no elements (f)");
    return finish();
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    throw MeshFileError(name_, line_, column, message);
  }

  void statement(const std::vector<Token>& tokens) {
    static constexpr std::array<std::string_view, 6> skipped = {"vt", "vn", "vp", "s", "usemtl", "mtllib"};
    if (tokens.empty()) return;
    const std::string_view keyword = tokens[0].text;
    if (keyword == "v") return node(tokens);
    if (keyword == "f") return polygon(tokens);
    if (keyword == "g" || keyword == "o") return panel(tokens);
    if (std::find(skipped.begin(), skipped.end(), keyword) == skipped.end())
      fail(tokens[0].column, shown(keyword) +
                                 " is not a statement read here; allowed: v, f, g, o (vt, vn, vp, s, "
                                 "usemtl, mtllib are skipped)");
  }

  void node(const std::vector<Token>& tokens) {
    if (tokens.size() != 4 && tokens.size() != 5)
      fail(tokens[0].column,
           "v needs 3 coordinates (and at most a weight), has " + std::to_string(tokens.size() - 1));
    if (nodes_.size() == std::numeric_limits<int>::max() / 3) fail(tokens[0].column, "too many nodes");
    nodes_.emplace_back(number(tokens[1]), number(tokens[2]), number(tokens[3]));
    if (tokens.size() == 5) number(tokens[4]);
  }

  double number(const Token& token) const {
    std::string_view text = token.text;
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range)
      fail(token.column, shown(token.text) + " is beyond double range");
    if (error != std::errc() || end != text.data() + text.size())
      fail(token.column, shown(token.text) + " is not a number");
    if (!std::isfinite(value)) fail(token.column, shown(token.text) + " is not finite");
    return value;
  }

  void panel(const std::vector<Token>& tokens) {
    if (tokens.size() > 2)
      fail(tokens[2].column, "one name only: an element belongs to one panel, and names have no blanks");
    panel_name_ = tokens.size() == 2 ? std::string(tokens[1].text) : "default";
    panel_.reset();
  }

  void polygon(const std::vector<Token>& tokens) {
    const std::size_t count = tokens.size() - 1;
    if (count != 3 && count != 4)
      fail(tokens[0].column, "f needs 3 or 4 corners, has " + std::to_string(count));
    std::vector<int> corners;
    for (std::size_t i = 1; i <= count; ++i) {
      const int index = corner(tokens[i]);
      if (std::find(corners.begin(), corners.end(), index) != corners.end())
        fail(tokens[i].column, "node " + std::to_string(index + 1) + " is repeated in this element");
      corners.push_back(index);
    }
    if (count == 4 && second_diagonal_shorter(corners))
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    if (!panel_) panel_ = current_panel();
    for (std::size_t i = 2; i < count; ++i) {
      elements_.emplace_back(corners[0], corners[i - 1], corners[i]);
      element_panels_.push_back(*panel_);
    }
  }

  int corner(const Token& token) const {
    const std::string_view text = token.text;
    const int node = index(token, text.substr(0, text.find('/')), nodes_.size());
    std::size_t slash = text.find('/');
    for (int part = 1; slash != std::string_view::npos; ++part) {
      const std::size_t next = text.find('/', slash + 1);
      const std::string_view field = text.substr(slash + 1, next == text.npos ? text.npos : next - slash - 1);
      const bool may_be_empty = part == 1 && next != text.npos;  // i//k
      if (part > 2) fail(token.column, shown(text) + " has more than the three fields i/j/k");
      if (!(field.empty() && may_be_empty)) integer(token, field);
      slash = next;
    }
    return node;
  }

  long long integer(const Token& token, std::string_view field) const {
    long long value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (field.empty() || error != std::errc() || end != field.data() + field.size())
      fail(token.column,
           shown(token.text) + " is not a corner; allowed: i, i/j, i//k, i/j/k with whole numbers");
    return value;
  }

  int index(const Token& token, std::string_view field, std::size_t count) const {
    const long long value = integer(token, field);
    const long long size = static_cast<long long>(count);
    if (value == 0) fail(token.column, "node index 0; indices count from 1, or back from -1");
    if (value > size || value < -size)
      fail(token.column, "node index " + std::to_string(value) + " is out of range: " + std::to_string(size) +
                             " nodes above this line");
    return static_cast<int>(value > 0 ? value - 1 : size + value);
  }

  bool second_diagonal_shorter(const std::vector<int>& quad) const {
    const auto x = [&](std::size_t i) -> const Eigen::Vector3d& {
      return nodes_[static_cast<std::size_t>(quad[i])];
    };
    return (x(3) - x(1)).norm() < (x(2) - x(0)).norm();
  }

  int current_panel() {
    const auto [entry, is_new] =
        panel_of_name_.try_emplace(panel_name_, static_cast<int>(panel_names_.size()));
    if (is_new) panel_names_.push_back(panel_name_);
    return entry->second;
  }

  Mesh finish() {
    Mesh mesh;
    mesh.nodes.resize(3, static_cast<Eigen::Index>(nodes_.size()));
    for (std::size_t i = 0; i < nodes_.size(); ++i) mesh.nodes.col(static_cast<Eigen::Index>(i)) = nodes_[i];
    mesh.elements.resize(3, static_cast<Eigen::Index>(elements_.size()));
    for (std::size_t e = 0; e < elements_.size(); ++e)
      mesh.elements.col(static_cast<Eigen::Index>(e)) = elements_[e];
    mesh.panel = std::move(element_panels_);
    mesh.panel_names = std::move(panel_names_);
    return mesh;
  }

  std::string_view text_;  // what is still to be read
  std::string name_;
  std::size_t line_ = 0;
  std::vector<Eigen::Vector3d> nodes_;
  std::vector<Eigen::Vector3i> elements_;
  std::vector<int> element_panels_;
  std::vector<std::string> panel_names_;
  std::unordered_map<std::string, int> panel_of_name_;
  std::string panel_name_ = "default";
  std::optional<int> panel_;  // index of panel_name_ once an element uses it
};

std::string location(const std::string& file, std::size_t line, std::size_t column) {
  return line == 0 ? file : file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

}  // namespace

MeshFileError::MeshFileError(const std::string& file, std::size_t line, std::size_t column,
                             const std::string& message)
    : std::runtime_error(location(file, line, column) + ": " + message), line_(line), column_(column) {}

Mesh parse_obj(std::string_view text, const std::string& name) {
  return Parser(text, name).parse();
}

Mesh read_obj(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, ignored))
    throw MeshFileError(path.string(), 0, 0, "cannot be opened for reading");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw MeshFileError(path.string(), 0, 0, "cannot be read");
  return parse_obj(text, path.string());
}

}  // namespace membrane
