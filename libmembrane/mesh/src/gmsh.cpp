// SPDX-License-Identifier: Apache-2.0
#include "mesh/gmsh.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh/merge.hpp"
#include "mesh_text.hpp"
#include "mesh_tokens.hpp"

namespace mesh {
namespace {

constexpr long long kMostTag = 2'000'000'000;
constexpr const char* kOneGroup = "; remove it from one of them";

// Number of corners of a first-order element that is read or skipped; 0 for other types.
std::size_t corners_of(long long type) {
  switch (type) {
    case 1:
      return 2;  // line
    case 2:
      return 3;  // triangle
    case 3:
      return 4;  // quad
    case 15:
      return 1;  // point
    default:
      return 0;
  }
}

std::size_t known_corners(const TokenReader& words, const MeshWord& at, long long type) {
  const std::size_t corners = corners_of(type);
  if (corners == 0)
    words.fail(at, "element type " + std::to_string(type) +
                       " is not supported; allowed: 2 triangle, 3 quad (1 line and 15 point are skipped)");
  return corners;
}

struct Element {
  std::vector<int> nodes;
  std::size_t line;
  std::string panel;
};

// Version 2 writes an element once for each of its groups.
void require_one_group(const TokenReader& words, const std::vector<Element>& elements) {
  std::vector<std::pair<std::vector<int>, const Element*>> sorted;
  for (const Element& element : elements) {
    sorted.emplace_back(element.nodes, &element);
    std::ranges::sort(sorted.back().first);
  }
  std::ranges::sort(sorted);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const Element &first = *sorted[i - 1].second, &again = *sorted[i].second;
    if (sorted[i].first == sorted[i - 1].first && first.panel != again.panel)
      words.fail({{}, again.line, 1}, "the element of line " + std::to_string(first.line) +
                                          " is repeated because it is in two physical groups, " +
                                          first.panel + " and " + again.panel + kOneGroup);
  }
}

class GmshParser {
 public:
  GmshParser(std::string_view text, const std::string& name) : words_(text, name) {}

  Mesh parse() {
    format();
    while (!words_.at_end()) section();
    if (elements_.empty()) throw MeshFileError(words_.name(), 0, 0, "the file has no triangles and no quads");
    return build();
  }

 private:
  void format() {
    words_.expect("$MeshFormat");
    const MeshWord version = words_.word("the version");
    is_new_ = version.text == "4.1";
    if (!is_new_ && version.text != "2.2" && version.text != "2.1" && version.text != "2")
      words_.fail(version, "version " + shown(version.text) + " is not supported; allowed: 2.2 and 4.1");
    const MeshWord binary = words_.word("0");
    if (binary.text != "0") words_.fail(binary, "a binary file; write it as ASCII (Mesh.Binary = 0)");
    words_.integer("the size of a number", 1, 64);
    words_.expect("$EndMeshFormat");
  }

  void section() {
    const MeshWord begin = words_.word("a section");
    if (!begin.text.starts_with('$') || begin.text.starts_with("$End"))
      words_.fail(begin, shown(begin.text) + " is found instead of a section such as $Nodes");
    const std::string end = "$End" + std::string(begin.text.substr(1));
    if (begin.text == "$PhysicalNames") {
      physical_names();
    } else if (begin.text == "$Entities" && is_new_) {
      entities();
    } else if (begin.text == "$Nodes") {
      is_new_ ? node_blocks() : nodes();
    } else if (begin.text == "$Elements") {
      is_new_ ? element_blocks() : elements();
    } else {
      while (words_.peek(end.c_str()).text != end) words_.word("");
    }
    words_.expect(end);
  }

  long long tag(const char* what) { return words_.integer(what, -kMostTag, kMostTag); }

  void physical_names() {
    const std::size_t count = words_.count("the number of names");
    for (std::size_t i = 0; i < count; ++i) {
      const long long dimension = words_.integer("a dimension", 0, 3), number = tag("a physical group");
      const MeshWord at = words_.peek("a name in quotes");
      const std::string_view rest = words_.rest_of_line();
      if (rest.size() < 2 || rest.front() != '"' || rest.back() != '"')
        words_.fail(at, shown(rest) + " is not a name in quotes");
      if (dimension == 2) names_[number] = panel_name(rest.substr(1, rest.size() - 2));
    }
  }

  // Version 4: which physical groups each surface is in.
  void entities() {
    std::size_t counts[4];
    for (std::size_t& count : counts) count = words_.count("the number of entities");
    for (std::size_t dimension = 0; dimension < 4; ++dimension)
      for (std::size_t i = 0; i < counts[dimension]; ++i) {
        const long long entity = tag("an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) words_.number("a coordinate");
        const std::size_t groups = words_.count("the number of physical groups");
        for (std::size_t k = 0; k < groups; ++k) {
          const long long group = tag("a physical group");
          if (dimension == 2)
            groups_of_surface_[entity].insert(std::abs(group));  // its sign is an
                                                                 // orientation
        }
        if (dimension == 0) continue;
        const std::size_t bounding = words_.count("the number of bounding entities");
        for (std::size_t k = 0; k < bounding; ++k) tag("an entity");
      }
  }

  std::string panel_of(long long group, long long surface) const {
    if (group == 0) return "surface_" + std::to_string(surface);
    const auto name = names_.find(group);
    return name == names_.end() ? "physical_" + std::to_string(group) : name->second;
  }

  // The one group of a surface; 0 if it is in none.
  long long group_of(const MeshWord& at, long long surface) const {
    const auto found = groups_of_surface_.find(surface);
    if (found == groups_of_surface_.end()) return 0;
    const std::set<long long>& groups = found->second;
    if (groups.size() > 1)
      words_.fail(at, "surface " + std::to_string(surface) + " is in two physical groups, " +
                          panel_of(*groups.begin(), surface) + " and " +
                          panel_of(*std::next(groups.begin()), surface) + kOneGroup);
    return *groups.begin();
  }

  void add_node(const MeshWord& at, long long number, const Eigen::Vector3d& x) {
    if (!index_.try_emplace(number, static_cast<int>(nodes_.size())).second)
      words_.fail(at, "node " + std::to_string(number) + " is repeated");
    nodes_.push_back(x);
  }

  Eigen::Vector3d position() {
    const double x = words_.number("x"), y = words_.number("y");
    return {x, y, words_.number("z")};
  }

  void nodes() {
    const std::size_t count = words_.count("the number of nodes");
    for (std::size_t i = 0; i < count; ++i) {
      const MeshWord at = words_.peek("a node");
      const long long number = words_.integer("the node's number", 1, kMostTag);
      add_node(at, number, position());
    }
  }

  void node_blocks() {
    const std::size_t blocks = words_.count("the number of blocks"),
                      all = words_.count("the number of nodes");
    tag("the least number");
    tag("the greatest number");
    for (std::size_t block = 0; block < blocks; ++block) {
      const long long dimension = words_.integer("a dimension", 0, 3);
      tag("an entity");
      const long long parameters = words_.integer("0 or 1", 0, 1) * dimension;
      const std::size_t count = words_.count("the number of nodes");
      std::vector<std::pair<MeshWord, long long>> numbers;
      for (std::size_t i = 0; i < count; ++i) {
        const MeshWord at = words_.peek("a node");
        numbers.emplace_back(at, words_.integer("the node's number", 1, kMostTag));
      }
      for (const auto& [at, number] : numbers) {
        add_node(at, number, position());
        for (long long k = 0; k < parameters; ++k) words_.number("a parameter");
      }
    }
    require_count(nodes_.size(), all, "nodes");
  }

  void require_count(std::size_t found, std::size_t announced, const char* what) {
    if (found != announced)
      words_.fail(words_.peek("the end of the section"), std::to_string(found) + " " + what + ", not the " +
                                                             std::to_string(announced) + " announced");
  }

  void add_element(std::size_t corners, std::string panel, std::size_t line) {
    Element element{{}, line, std::move(panel)};
    for (std::size_t k = 0; k < corners; ++k) {
      const MeshWord at = words_.peek("a node");
      const long long number = words_.integer("a node", 1, kMostTag);
      if (!index_.contains(number)) words_.fail(at, "node " + std::to_string(number) + " is not in $Nodes");
      element.nodes.push_back(index_.at(number));
    }
    if (corners >= 3) elements_.push_back(std::move(element));
  }

  void elements() {
    const std::size_t count = words_.count("the number of elements");
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t line = words_.peek("an element").line;
      words_.integer("the element's number", 1, kMostTag);
      const MeshWord at = words_.peek("the element's type");
      const long long type = words_.integer("the element's type", 1, 1000);
      const std::size_t corners = known_corners(words_, at, type), tags = words_.count("the number of tags");
      long long tag_of[2] = {0, 0};
      for (std::size_t k = 0; k < tags; ++k) {
        const long long value = tag("a tag");
        if (k < 2) tag_of[k] = value;
      }
      add_element(corners, panel_of(std::abs(tag_of[0]), tag_of[1]), line);
    }
  }

  void element_blocks() {
    const std::size_t blocks = words_.count("the number of blocks"),
                      all = words_.count("the number of elements");
    tag("the least number");
    tag("the greatest number");
    std::size_t found = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
      words_.integer("a dimension", 0, 3);
      const long long entity = tag("an entity");
      const MeshWord at = words_.peek("the elements' type");
      const long long type = words_.integer("the elements' type", 1, 1000);
      const std::size_t corners = known_corners(words_, at, type),
                        count = words_.count("the number of elements");
      const std::string panel = panel_of(corners < 3 ? 0 : group_of(at, entity), entity);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t line = words_.peek("an element").line;
        words_.integer("the element's number", 1, kMostTag);
        add_element(corners, panel, line);
      }
      found += count;
    }
    require_count(found, all, "elements");
  }

  Mesh build() const {
    require_one_group(words_, elements_);
    MeshBuilder mesh;
    for (const Eigen::Vector3d& x : nodes_) mesh.add_node(x);
    for (const Element& e : elements_) mesh.add_polygon(e.nodes, e.panel, e.line);
    return used_nodes(std::move(mesh).finish());
  }

  TokenReader words_;
  bool is_new_ = false;                     // version 4
  std::map<long long, std::string> names_;  // names of the physical surfaces
  std::map<long long, std::set<long long>> groups_of_surface_;
  std::vector<Eigen::Vector3d> nodes_;
  std::unordered_map<long long, int> index_;  // index of each node number
  std::vector<Element> elements_;
};

}  // namespace

Mesh parse_gmsh(std::string_view text, const std::string& name) {
  return GmshParser(text, name).parse();
}

}  // namespace mesh
