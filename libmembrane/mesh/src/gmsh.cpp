// SPDX-License-Identifier: Apache-2.0
#include "mesh/gmsh.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "gmsh_numbers.hpp"
#include "gmsh_parts.hpp"
#include "mesh/merge.hpp"
#include "mesh_builder.hpp"
#include "mesh_text.hpp"
#include "mesh_tokens.hpp"

namespace mesh {
namespace {

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
  std::size_t line;  // 0 in a binary file
  long long number;
  std::string panel;
};

std::string name_of(const Element& element) {
  if (element.line == 0) return "element " + std::to_string(element.number);
  return "the element of line " + std::to_string(element.line);
}

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
      words.fail({{}, again.line, 1}, name_of(first) + " is repeated because it is in two physical groups, " +
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
    numbers_.set_item_size(is_new_ ? 8 : 4);
    if (!is_new_ && version.text != "2.2" && version.text != "2.1" && version.text != "2")
      words_.fail(version, "version " + shown(version.text) + " is not supported; allowed: 2.2 and 4.1");
    const MeshWord binary = words_.word("0");
    if (binary.text != "0" && binary.text != "1")
      words_.fail(binary, shown(binary.text) + " is found instead of 0 for ASCII or 1 for binary");
    const MeshWord size = words_.word("the size of a number");
    if (binary.text == "1") {
      if (size.text != "8") words_.fail(size, "numbers of " + shown(size.text) + " bytes, allowed: 8");
      numbers_.set_binary();
    }
    words_.expect("$EndMeshFormat");
  }

  void section() {
    const MeshWord begin = words_.word("a section");
    if (!begin.text.starts_with('$') || begin.text.starts_with("$End"))
      words_.fail(begin, shown(begin.text) + " is found instead of a section such as $Nodes");
    const std::string end = "$End" + std::string(begin.text.substr(1));
    if (begin.text == "$ParametricNodes")
      words_.fail(begin, "nodes with parameters; write the file without them (Mesh.SaveParametric = 0)");
    if (begin.text == "$PhysicalNames") {
      groups_.read_names();
    } else if (begin.text == "$Entities" && is_new_) {
      groups_.read_entities();
    } else if (begin.text == "$Nodes") {
      is_new_ ? node_blocks() : nodes();
    } else if (begin.text == "$Elements") {
      is_new_ ? element_blocks() : elements();
    } else if (numbers_.is_binary()) {
      words_.find_line(end);
    } else {
      while (words_.peek(end.c_str()).text != end) words_.word("");
    }
    words_.expect(end);
  }

  void nodes() {
    const std::size_t count = words_.count("the number of nodes");
    numbers_.begin();
    for (std::size_t i = 0; i < count; ++i) {
      const MeshWord at = numbers_.place("a node");
      const long long node = numbers_.item("the node's number");
      nodes_.read(at, node);
    }
  }

  // What stands before the blocks of nodes or elements: their number, and that of all items.
  std::pair<std::size_t, std::size_t> block_counts(const char* what) {
    numbers_.begin();
    const std::size_t blocks = numbers_.count("the number of blocks"), all = numbers_.count(what);
    numbers_.integer("the least number", 0, GmshNumbers::most, 8);
    numbers_.integer("the greatest number", 0, GmshNumbers::most, 8);
    return {blocks, all};
  }

  void node_blocks() {
    const auto [blocks, all] = block_counts("the number of nodes");
    for (std::size_t block = 0; block < blocks; ++block) {
      const long long dimension = numbers_.integer("a dimension", 0, 3);
      numbers_.tag("an entity");
      const long long parameters = numbers_.integer("0 or 1", 0, 1) * dimension;
      const std::size_t count = numbers_.count("the number of nodes");
      std::vector<std::pair<MeshWord, long long>> read;
      for (std::size_t i = 0; i < count; ++i) {
        const MeshWord at = numbers_.place("a node");
        read.emplace_back(at, numbers_.item("the node's number"));
      }
      for (const auto& [at, node] : read) {
        nodes_.read(at, node);
        for (long long k = 0; k < parameters; ++k) numbers_.number("a parameter");
      }
    }
    require_count(nodes_.positions.size(), all, "nodes");
  }

  void require_count(std::size_t found, std::size_t announced, const char* what) {
    if (found != announced)
      words_.fail(
          numbers_.place("the end of the section"),
          std::to_string(found) + " " + what + ", not the " + std::to_string(announced) + " announced");
  }

  std::size_t line() { return numbers_.is_binary() ? 0 : words_.peek("an element").line; }

  // `group` is that of version 2; in version 4 the entity has groups.
  void add_element(std::size_t corners, long long element_number, std::string panel, std::size_t line,
                   std::optional<long long> group, long long entity) {
    Element element{{}, line, element_number, std::move(panel)};
    for (std::size_t k = 0; k < corners; ++k) {
      const MeshWord at = numbers_.place("a node");
      const long long node = numbers_.item("a node");
      element.nodes.push_back(nodes_.index_of(at, node));
    }
    if (corners == 2) groups_.add_line(group, entity, element.nodes);
    if (corners >= 3) elements_.push_back(std::move(element));
  }

  std::pair<MeshWord, long long> element_type(const char* what) {
    const MeshWord at = numbers_.place(what);
    return {at, numbers_.integer(what, 1, 1000)};
  }

  // An element of version 2, behind its type.
  void tagged_element(std::size_t corners, std::size_t tags, long long element_number, std::size_t line) {
    long long tag_of[2] = {0, 0};
    for (std::size_t k = 0; k < tags; ++k) {
      const long long value = numbers_.tag("a tag");
      if (k < 2) tag_of[k] = value;
    }
    add_element(corners, element_number, groups_.panel_of(std::abs(tag_of[0]), tag_of[1]), line, tag_of[0],
                tag_of[1]);
  }

  void elements() {
    const std::size_t count = words_.count("the number of elements");
    if (numbers_.is_binary()) return element_runs(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at_line = line();
      const long long element_number = numbers_.item("the element's number");
      const auto [at, type] = element_type("the element's type");
      const std::size_t corners = known_corners(words_, at, type), tags = words_.count("the number of tags");
      tagged_element(corners, tags, element_number, at_line);
    }
  }

  // In a binary file of version 2 elements of one type follow their type.
  void element_runs(std::size_t count) {
    numbers_.begin();
    for (std::size_t found = 0; found < count;) {
      const auto [at, type] = element_type("the elements' type");
      const std::size_t corners = known_corners(words_, at, type);
      const auto most = static_cast<long long>(count - found);
      const auto run = static_cast<std::size_t>(numbers_.integer("the number of elements", 1, most)),
                 tags = static_cast<std::size_t>(numbers_.integer("the number of tags", 0, 1000));
      for (std::size_t i = 0; i < run; ++i)
        tagged_element(corners, tags, numbers_.item("the element's number"), 0);
      found += run;
    }
  }

  void element_blocks() {
    const auto [blocks, all] = block_counts("the number of elements");
    std::size_t found = 0;
    for (std::size_t block = 0; block < blocks; ++block) {
      numbers_.integer("a dimension", 0, 3);
      const long long entity = numbers_.tag("an entity");
      const auto [at, type] = element_type("the elements' type");
      const std::size_t corners = known_corners(words_, at, type),
                        count = numbers_.count("the number of elements");
      const std::string panel = groups_.panel_of(corners < 3 ? 0 : groups_.group_of(at, entity), entity);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at_line = line();
        const long long element_number = numbers_.item("the element's number");
        add_element(corners, element_number, panel, at_line, {}, entity);
      }
      found += count;
    }
    require_count(found, all, "elements");
  }

  Mesh build() const {
    require_one_group(words_, elements_);
    MeshBuilder mesh;
    for (const Eigen::Vector3d& x : nodes_.positions) mesh.add_node(x);
    for (const Element& e : elements_) mesh.add_polygon(e.nodes, e.panel, e.line);
    Mesh result = std::move(mesh).finish(words_.name());
    result.node_sets = groups_.node_sets();
    return used_nodes(std::move(result));
  }

  TokenReader words_;
  GmshNumbers numbers_{words_};
  bool is_new_ = false;  // version 4
  GmshGroups groups_{words_, numbers_};
  GmshNodes nodes_{words_, numbers_};
  std::vector<Element> elements_;
};

}  // namespace

Mesh parse_gmsh(std::string_view text, const std::string& name) {
  return GmshParser(text, name).parse();
}

}  // namespace mesh
