// SPDX-License-Identifier: Apache-2.0
#include "mesh/radioss.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "deck_card.hpp"
#include "deck_files.hpp"
#include "radioss_reference.hpp"

namespace mesh {
namespace {

constexpr std::array<std::size_t, 4> kNodeColumns = {10, 20, 20, 20};
constexpr std::array<std::size_t, 5> kCornerColumns = {10, 10, 10, 10, 10};
constexpr std::array<std::size_t, 10> kSetColumns = {10, 10, 10, 10, 10, 10, 10, 10, 10, 10};

// Blocks of elements other than shells.
constexpr std::string_view kOtherElements[] = {"BEAM",   "BRIC20", "BRICK",  "PENTA6",  "QUAD",
                                               "SHEL16", "SPHCEL", "SPRING", "TETRA10", "TETRA4",
                                               "TRIA",   "TRUSS",  "XELEM"};

// Blocks that move the nodes or stress the shells at the start. They are not read.
constexpr std::string_view kChanges[] = {"INISHE", "INISH3", "INIVEL", "INISTA", "MERGE"};

class RadiossParser {
 public:
  explicit RadiossParser(const IncludedFile& included) : files_(included) {}

  Mesh parse(std::string_view text, const std::string& name) {
    // A deck for both programs begins with the engine's part.
    if (const auto engine = text.find("/END/ENGINE"); engine < text.find("/BEGIN")) block_ = Block::engine;
    read_file(text, name);
    reference_.finish();
    const auto fail = [&](const char* what) { throw MeshFileError(name, 0, 0, what); };
    if (block_ == Block::start) fail("the file is empty; a Radioss starter deck begins with /BEGIN");
    if (block_ != Block::end) fail("the file does not end with /END: it is truncated");
    if (!deck_.has_shells()) fail("the file has no elements (/SHELL, /SH3N)");
    return deck_.build();
  }

 private:
  enum class Block {
    engine,
    start,
    skipped,
    elements,
    node,
    shell,
    triangle,
    part_title,
    set_title,
    set,
    reference,
    end
  };

  Place place(std::size_t column) const { return {file_, line_, column}; }

  void read_file(std::string_view text, const std::string& name) {
    file_ = deck_.open(name);
    line_ = 0;
    while (!text.empty() && block_ != Block::end) {
      const std::string_view line = take_line(text);
      ++line_;
      read(line);
    }
  }

  void read(std::string_view line) {
    constexpr std::string_view include = "#include ";
    if (block_ == Block::engine) {
      if (line.starts_with("/END/ENGINE")) block_ = Block::start;
      return;
    }
    if (line.starts_with(include)) return included(line.substr(include.size()));
    if (line.starts_with('#') || line.starts_with('$')) return;
    if (line.starts_with('/')) return block(line);
    if (block_ == Block::part_title) return title(line);  // may be blank
    if (block_ == Block::set_title) return set_title(line);
    if (block_ == Block::reference) return reference_.read(line, file_, line_);
    if (line.find_first_not_of(" \t") == std::string_view::npos) return;
    if (block_ == Block::start)
      deck_.fail(place(1), shown(line) + ": a Radioss starter deck begins with /BEGIN");
    if (block_ == Block::node) node(line);
    if (block_ == Block::shell || block_ == Block::triangle) shell(line);
    if (block_ == Block::elements) deck_.skip(word_, true);
    if (block_ == Block::set) set(line);
  }

  void block(std::string_view line) {
    const std::size_t slash = std::min(line.find_first_of("/ \t", 1), line.size());
    const std::string_view word = line.substr(1, slash - 1);
    word_ = line.substr(0, slash);
    if (block_ == Block::start && word != "BEGIN")
      deck_.fail(place(1), shown(line) + ": a Radioss starter deck begins with /BEGIN");
    if (word == "TRANSFORM" || word == "SUBMODEL" || word.empty())
      deck_.fail(place(1), shown(line) + " is not supported: it would change nodes or numbers");
    if (word == "NODE" && line.substr(slash).find_first_not_of("/ \t") != std::string_view::npos)
      deck_.fail(place(1), shown(line) + ": nodes in units of their own are not supported");
    if (word == "XREF" && std::ranges::count(line, '/') > 2)
      deck_.fail(place(1), shown(line) + ": nodes in units of their own are not supported");
    const bool is_reference = reference_.begins(line, [&] { return part_number(line, slash + 1); });
    const bool is_element = std::ranges::find(kOtherElements, word) != std::end(kOtherElements);
    block_ = word == "NODE"                     ? Block::node
             : word == "SHELL"                  ? Block::shell
             : word == "SH3N"                   ? Block::triangle
             : word == "PART"                   ? Block::part_title
             : word == "END"                    ? Block::end
             : line.starts_with("/GRNOD/NODE/") ? Block::set_title
             : is_reference                     ? Block::reference
             : is_element                       ? Block::elements
                                                : Block::skipped;
    if (block_ == Block::shell || block_ == Block::triangle || block_ == Block::part_title)
      part_ = part_number(line, slash + 1);
    if (block_ == Block::set_title) part_ = part_number(line, std::string_view("/GRNOD/NODE/").size());
    if (block_ == Block::skipped && word != "BEGIN") deck_.skip(word_, false);
    if (std::ranges::find(kChanges, word) != std::end(kChanges)) deck_.neglect(word_);
  }

  // The first word from `begin` on, up to a slash.
  DeckMesh::Id part_number(std::string_view line, std::size_t begin) const {
    begin = std::min(line.find_first_not_of("/ \t", begin), line.size());
    const std::size_t end = std::min(line.find_first_of("/ \t", begin), line.size());
    const std::string text = std::string(begin, ' ').append(line.substr(begin, end - begin));
    return DeckCard(deck_, file_, line_, text, std::array{text.size()}).id(0, "the part's number");
  }

  void title(std::string_view line) {
    deck_.name_part(part_, std::string(line), place(1));
    block_ = Block::skipped;
  }

  void set_title(std::string_view line) {
    deck_.sets.begin(std::string(line), part_);
    block_ = Block::set;
  }

  // Text that is no node number is not read.
  void set(std::string_view line) {
    const DeckCard card(deck_, file_, line_, line, kSetColumns);
    for (std::size_t i = 0; i < kSetColumns.size(); ++i)
      if (const auto node = card.whole(i)) deck_.sets.add(*node);
  }

  void node(std::string_view line) {
    const DeckCard card(deck_, file_, line_, line, kNodeColumns);
    deck_.add_node(card.id(0, "the node's number"), card.point(1), card.place(0));
  }

  void shell(std::string_view line) {
    const DeckCard card(deck_, file_, line_, line, kCornerColumns);
    std::vector<DeckMesh::Corner> corners{card.corner(1), card.corner(2), card.corner(3)};
    if (block_ == Block::shell && !card.blank_or_zero(4)) corners.push_back(card.corner(4));
    deck_.add_shell(card.id(0, "the element's number"), part_, std::move(corners), card.place(0));
    // After the corners come an angle and a thickness of this shell alone.
    constexpr std::size_t corners_end = 50;
    if (line.substr(std::min(corners_end, line.size())).find_first_of("123456789") == line.npos) return;
    deck_.skip("angles and thicknesses in " + word_, false);
    deck_.neglect("angles and thicknesses in " + word_);
  }

  void included(std::string_view name) {
    files_.include(deck_, place(1), name, [&](const std::string& text, const std::string& file) {
      const auto [outer, line] = std::pair(file_, line_);
      read_file(text, file);
      if (block_ == Block::end) block_ = Block::skipped;  // end of an included file
      file_ = outer;
      line_ = line;
    });
  }

  DeckMesh deck_;
  DeckFiles files_;
  RadiossReference reference_{deck_, files_};
  int file_ = 0;
  std::size_t line_ = 0;
  Block block_ = Block::start;
  std::string word_;       // the present block
  DeckMesh::Id part_ = 0;  // number of the present block's part or set
};

}  // namespace

Mesh parse_radioss(std::string_view text, const std::string& name, const IncludedFile& included) {
  return RadiossParser(included).parse(text, name);
}

}  // namespace mesh
