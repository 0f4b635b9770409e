// SPDX-License-Identifier: Apache-2.0
#include "membrane/keyword.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "keyword_cards.hpp"
#include "mesh_text.hpp"

namespace membrane {
namespace {

using Id = long long;

// Widths of the columns that are read: the standard and the long format.
using Widths = std::vector<std::size_t>;
const std::array<Widths, 2> kNodeWidths = {Widths{8, 16, 16, 16}, Widths(4, 20)};
const std::array<Widths, 2> kShellWidths = {Widths(10, 8), Widths(10, 20)};
const std::array<Widths, 2> kPartWidths = {Widths{10}, Widths{20}};

struct Corner {
  Id node;
  std::size_t line, column;
};

struct Shell {
  Id part;
  std::vector<Corner> corners;  // 3 or 4
};

struct Node {
  Id id;
  Eigen::Vector3d position;
};

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

std::string untitled(Id part) {
  return std::string("part_").append(std::to_string(part));
}

class KeywordParser {
 public:
  KeywordParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Mesh parse() {
    while (!text_.empty() && section_ != Section::end) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      ++line_;
      std::string_view line = text_.substr(0, end);
      if (line.ends_with('\r')) line.remove_suffix(1);
      read(line);
      text_.remove_prefix(std::min(end + 1, text_.size()));
    }
    if (line_ == 0 || section_ == Section::start)
      fail_file("the file is empty; a keyword file begins with *KEYWORD");
    if (section_ != Section::end) fail_file("the file does not end with *END: it is truncated");
    if (shells_.empty()) fail_file("the file has no elements (*ELEMENT_SHELL)");
    return build();
  }

 private:
  enum class Section { start, skipped, node, shell, part_title, part_data, end };

  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    throw MeshFileError(name_, line_, column, message);
  }
  [[noreturn]] void fail_file(const std::string& message) const { throw MeshFileError(name_, 0, 0, message); }

  void read(std::string_view line) {
    if (line.starts_with('$')) return;
    if (line.starts_with('*')) return keyword(line);
    const bool blank = line.find_first_not_of(" \t") == std::string_view::npos;
    if (section_ == Section::start && !blank) fail(1, shown(line) + ": a keyword file begins with *KEYWORD");
    if (section_ == Section::part_title) return title(line);  // may be blank
    if (blank) return;
    if (section_ == Section::node) node(line);
    if (section_ == Section::shell) shell(line);
    if (section_ == Section::part_data) part(line);
  }

  void keyword(std::string_view line) {
    std::string word = upper(line.substr(0, line.find_first_of(" \t,")));
    if (section_ == Section::start) return first_keyword(word, line);
    is_long_ = word.ends_with('+') || (file_is_long_ && !word.ends_with('-'));
    const std::size_t rest = line.find_first_not_of(" \t", word.size());
    if (word.ends_with('+') || word.ends_with('-')) word.pop_back();
    const bool element = word.starts_with("*ELEMENT"), nodes = word.starts_with("*NODE");
    if (word == "*NODE")
      section_ = Section::node;
    else if (word == "*ELEMENT_SHELL")
      section_ = Section::shell;
    else if (word == "*PART")
      section_ = Section::part_title;
    else if (word == "*END")
      section_ = Section::end;
    else if (element || nodes || word.starts_with("*INCLUDE"))
      fail(1, shown(word) + " is not read here; allowed are *NODE, *ELEMENT_SHELL and *PART in one file");
    else
      section_ = Section::skipped;
    // Such as *NODE %, other columns: what they would give is no mesh, or worse, one.
    if (section_ != Section::skipped && section_ != Section::end && rest < line.size())
      fail(rest + 1, shown(line.substr(rest)) + " after " + word + " is not read here; allowed: nothing");
  }

  void first_keyword(const std::string& word, std::string_view line) {
    if (word != "*KEYWORD") fail(1, shown(word) + ": a keyword file begins with *KEYWORD");
    section_ = Section::skipped;
    const std::string options = upper(line.substr(word.size()));
    file_is_long_ = options.find("LONG=Y") != std::string::npos;
    const auto at = std::min(options.find("I10"), file_is_long_ ? std::string::npos : options.find("LONG"));
    if (at < options.size() && !options.substr(at).starts_with("LONG=S"))
      fail(word.size() + at + 1, shown(options.substr(at)) +
                                     " is not read here; allowed: LONG=Y (20 columns), "
                                     "LONG=S or nothing");
  }

  Id id(const CardField& field, const char* what) const {
    Id value = 0;
    const char* last = field.text.data() + field.text.size();
    const auto [end, error] = std::from_chars(field.text.data(), last, value);
    if (field.text.empty() || error != std::errc() || end != last || value <= 0)
      fail(field.column, std::string(what) + " is " + (field.text.empty() ? "blank" : shown(field.text)) +
                             "; a whole number above 0 is allowed");
    return value;
  }

  double coordinate(const CardField& field) const {
    if (field.text.empty()) fail(field.column, "a coordinate is blank; a node needs x, y and z");
    double value = 0.0;
    if (const std::string fault = number_fault(field.text, value); !fault.empty()) fail(field.column, fault);
    return value;
  }

  void node(std::string_view line) {
    const auto fields = card_fields(line, kNodeWidths[is_long_]);
    const Id number = id(fields[0], "the node's number");
    const auto [known, is_new] = line_of_node_.try_emplace(number, line_);
    if (!is_new)
      fail(fields[0].column,
           "node " + std::to_string(number) + " is repeated; first in line " + std::to_string(known->second));
    nodes_.push_back({number, {coordinate(fields[1]), coordinate(fields[2]), coordinate(fields[3])}});
  }

  static bool absent(const CardField& field) { return field.text.empty() || field.text == "0"; }

  void shell(std::string_view line) {
    const auto fields = card_fields(line, kShellWidths[is_long_]);
    const Id number = id(fields[0], "the element's number");
    if (!shell_numbers_.insert(number).second)
      fail(fields[0].column, "element " + std::to_string(number) + " is repeated");
    Shell shell{id(fields[1], "the part's number"), {}};
    for (std::size_t i = 2; i < 5; ++i)
      shell.corners.push_back({id(fields[i], "a corner"), line_, fields[i].column});
    if (!absent(fields[5]) && id(fields[5], "a corner") != shell.corners[2].node)
      shell.corners.push_back({id(fields[5], "a corner"), line_, fields[5].column});
    for (std::size_t i = 6; i < fields.size(); ++i)
      if (!absent(fields[i])) fail(fields[i].column, "shells of more than 4 nodes are not read here");
    for (std::size_t i = 1; i < shell.corners.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (shell.corners[k].node == shell.corners[i].node)
          fail(shell.corners[i].column,
               "node " + std::to_string(shell.corners[i].node) + " is repeated in this element");
    shells_.push_back(std::move(shell));
  }

  void title(std::string_view line) {
    title_ = line.substr(0, line.find_last_not_of(" \t") + 1);
    title_.erase(0, title_.find_first_not_of(" \t"));
    for (char& c : title_)
      if (static_cast<unsigned char>(c) <= ' ' || c == '#') c = '_';
    section_ = Section::part_data;
  }

  void part(std::string_view line) {
    const CardField field = card_fields(line, kPartWidths[is_long_])[0];
    const Id number = id(field, "the part's number");
    std::string name = title_.empty() ? untitled(number) : title_;
    if (!used_titles_.insert(name).second) name.append("_").append(std::to_string(number));
    if (!part_names_.try_emplace(number, name).second)
      fail(field.column, "part " + std::to_string(number) + " is repeated");
    section_ = Section::part_title;
  }

  // Nodes in the order of the file, those that a shell uses.
  Mesh build() const {
    std::unordered_map<Id, int> index;
    for (const Shell& shell : shells_)
      for (const Corner& corner : shell.corners) {
        if (!line_of_node_.contains(corner.node))
          throw MeshFileError(name_, corner.line, corner.column,
                              "node " + std::to_string(corner.node) + " is in no *NODE of this file");
        index.try_emplace(corner.node, -1);
      }
    MeshBuilder mesh;
    for (const Node& node : nodes_)
      if (const auto used = index.find(node.id); used != index.end()) {
        used->second = mesh.node_count();
        mesh.add_node(node.position);
      }
    for (const Shell& shell : shells_) {
      std::vector<int> corners;
      for (const Corner& corner : shell.corners) corners.push_back(index.at(corner.node));
      const auto named = part_names_.find(shell.part);
      mesh.add_polygon(corners, named == part_names_.end() ? untitled(shell.part) : named->second,
                       shell.corners.front().line);
    }
    return std::move(mesh).finish();
  }

  std::string_view text_;  // what is still to be read
  std::string name_;
  std::size_t line_ = 0;
  Section section_ = Section::start;
  bool file_is_long_ = false, is_long_ = false;  // the file by default, the present keyword
  std::vector<Node> nodes_;
  std::unordered_map<Id, std::size_t> line_of_node_;
  std::vector<Shell> shells_;
  std::set<Id> shell_numbers_;
  std::string title_;  // of the part whose data card comes next
  std::set<std::string> used_titles_;
  std::map<Id, std::string> part_names_;
};

}  // namespace

Mesh parse_keyword(std::string_view text, const std::string& name) {
  return KeywordParser(text, name).parse();
}

}  // namespace membrane
