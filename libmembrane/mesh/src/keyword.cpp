// SPDX-License-Identifier: Apache-2.0
#include "mesh/keyword.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "deck_card.hpp"
#include "deck_files.hpp"
#include "keyword_reference.hpp"
#include "keyword_sets.hpp"

namespace mesh {
namespace {

// Widths of columns in the standard and the long format.
using Widths = std::vector<std::size_t>;
const std::array<Widths, 2> kNodeWidths = {Widths{8, 16, 16, 16}, Widths(4, 20)};
const std::array<Widths, 2> kShellWidths = {Widths(10, 8), Widths(10, 20)};
const std::array<Widths, 2> kPartWidths = {Widths{10}, Widths{20}};

constexpr std::string_view kShell = "*ELEMENT_SHELL";

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

// Number of cards after a shell's own, by the options of *ELEMENT_SHELL; -1 for unknown options.
int cards_of_options(std::string_view options) {
  int of_shape = 0, offset = 0;
  while (!options.empty()) {
    options.remove_prefix(1);  // _
    const std::string_view option = options.substr(0, options.find('_'));
    if (option == "THICKNESS" || option == "BETA" || option == "MCID")
      of_shape = 1;  // all three on one card
    else if (option == "OFFSET")
      offset = 1;
    else
      return -1;
    options.remove_prefix(option.size());
  }
  return of_shape + offset;
}

// Keywords that move the nodes or stress the shells at the start. They are not read.
bool changes_bag(std::string_view word) {
  constexpr std::array<std::string_view, 5> starts{"*PART_MOVE", "*INITIAL_STRESS_SHELL",
                                                   "*INITIAL_STRAIN_SHELL", "*INITIAL_VELOCITY",
                                                   "*AIRBAG_SHELL_REFERENCE"};
  return std::ranges::any_of(starts, [&](auto start) { return word.starts_with(start); }) ||
         word.starts_with("*AIRBAG_REFERENCE");
}

// True for *PART with options that only add cards after title and number.
bool is_part_with_options(std::string_view word) {
  for (std::string_view rest = word.substr(std::min(word.size(), std::size_t{5})); !rest.empty();) {
    rest.remove_prefix(1);  // _
    const std::string_view option = rest.substr(0, rest.find('_'));
    constexpr std::array options{"INERTIA", "CONTACT", "REPOSITION", "PRINT", "COMPOSITE"};
    if (std::ranges::find(options, option) == options.end()) return false;
    rest.remove_prefix(option.size());
  }
  return word.starts_with("*PART_");
}

class KeywordParser {
 public:
  explicit KeywordParser(const IncludedFile& included) : files_(included) {}

  Mesh parse(std::string_view text, const std::string& name) {
    read_file(text, name);
    const auto fail = [&](const char* what) { throw MeshFileError(name, 0, 0, what); };
    if (at_.section == Section::start) fail("the file is empty; a keyword file begins with *KEYWORD");
    if (at_.section != Section::end) fail("the file does not end with *END: it is truncated");
    if (!deck_.has_shells()) fail("the file has no elements (*ELEMENT_SHELL)");
    return deck_.build();
  }

 private:
  enum class Section {
    start,
    skipped,
    elements,
    node,
    shell,
    part_title,
    part_data,
    include,
    more_includes,
    reference,
    set,
    end
  };

  // Position in a file.
  struct Cursor {
    int file = 0;
    std::size_t line = 0;
    Section section = Section::start;
    bool file_is_long = false, is_long = false;  // format by default, and after the present keyword
  };

  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    deck_.fail({at_.file, at_.line, column}, what);
  }
  DeckCard card(std::string_view line, const std::array<Widths, 2>& widths) const {
    return {deck_, at_.file, at_.line, line, widths[at_.is_long]};
  }

  void read_file(std::string_view text, const std::string& name) {
    at_ = {.file = deck_.open(name)};
    while (!text.empty() && at_.section != Section::end) {
      const std::string_view line = take_line(text);
      ++at_.line;
      read(line);
    }
  }

  void read(std::string_view line) {
    if (line.starts_with('$')) return;
    if (line.starts_with('*')) return keyword(line);
    if (at_.section == Section::part_title) {  // may be blank
      title_ = line;
      at_.section = Section::part_data;
      return;
    }
    if (at_.section == Section::shell && cards_left_ > 0) return card_of_option(line);
    if (at_.section == Section::set) return sets_.read(line, at_.file, at_.line, at_.is_long);
    if (at_.section == Section::reference) return reference_.read(line, at_.file, at_.line, at_.is_long);
    if (line.find_first_not_of(" \t") == std::string_view::npos) return;
    if (at_.section == Section::start) fail(1, shown(line) + ": a keyword file begins with *KEYWORD");
    if (at_.section == Section::node) node(line);
    if (at_.section == Section::shell) shell(line);
    if (at_.section == Section::part_data) part(line);
    if (at_.section == Section::include || at_.section == Section::more_includes) include(line);
    if (at_.section == Section::elements) deck_.skip(word_, true);
  }

  void keyword(std::string_view line) {
    word_ = upper(line.substr(0, line.find_first_of(" \t,")));
    const std::size_t rest = line.find_first_not_of(" \t", word_.size());
    const bool is_first = at_.section == Section::start;
    if (at_.section == Section::include) fail(1, "the *INCLUDE before it names no file");
    if (cards_left_ > 0) fail(1, "the shell before lacks the card that its keyword requires");
    if (word_ == "*KEYWORD" || word_ == "*KEYWORD_ID" || word_ == "*KEYWORD_JOBID")
      return options_of_file(line);
    if (is_first && at_.file == 0) fail(1, shown(word_) + ": a keyword file begins with *KEYWORD");
    at_.is_long = word_.ends_with('+') || (at_.file_is_long && !word_.ends_with('-'));
    if (word_.ends_with('+') || word_.ends_with('-')) word_.pop_back();
    at_.section = section_of(word_);
    const bool is_read = at_.section != Section::skipped && at_.section != Section::elements;
    if (!is_read && at_.section != Section::elements) deck_.skip(word_, false);
    if (!is_read && changes_bag(word_)) deck_.neglect(word_);
    // Such as *NODE %, which means other columns: reading them could give a wrong mesh.
    if (is_read && at_.section != Section::end && rest < line.size())
      fail(rest + 1, shown(line.substr(rest)) + " after " + word_ + " is not supported; " + word_ +
                         " must be alone on its line");
  }

  Section section_of(const std::string& word) {
    if (word == "*NODE") return Section::node;
    has_one_part_ = is_part_with_options(word);
    if (word == "*PART" || has_one_part_) return Section::part_title;
    if (word == "*END") return Section::end;
    if (word == "*INCLUDE") return Section::include;
    if (reference_.begins(word)) return Section::reference;
    if (sets_.begins(word)) return Section::set;
    cards_of_shell_ =
        word.starts_with(kShell) ? cards_of_options(std::string_view(word).substr(kShell.size())) : -1;
    cards_left_ = 0;
    if (cards_of_shell_ > 0) deck_.skip("what else is in " + word, false);
    if (cards_of_shell_ >= 0) return Section::shell;
    if (word.starts_with(kShell) || word.starts_with("*ELEMENT_GENERATE_SHELL") ||
        word.starts_with("*NODE") || word.starts_with("*INCLUDE"))
      fail(1, shown(word) +
                  " is not supported, allowed: *NODE, *PART, *INCLUDE, and *ELEMENT_SHELL, also with "
                  "_THICKNESS, _BETA, _MCID and _OFFSET");
    return word.starts_with("*ELEMENT") ? Section::elements : Section::skipped;
  }

  void options_of_file(std::string_view line) {
    at_.section = Section::skipped;
    if (word_ != "*KEYWORD") return;  // names of a project or a job
    const std::string options = upper(line.substr(word_.size()));
    at_.file_is_long = options.find("LONG=Y") != std::string::npos;
    const auto at =
        std::min(options.find("I10"), at_.file_is_long ? std::string::npos : options.find("LONG"));
    if (at < options.size() && !options.substr(at).starts_with("LONG=S"))
      fail(word_.size() + at + 1,
           shown(options.substr(at)) + " is not supported; allowed: LONG=Y (20 columns), LONG=S or nothing");
  }

  void node(std::string_view line) {
    const DeckCard fields = card(line, kNodeWidths);
    deck_.add_node(fields.id(0, "the node's number"), fields.point(1), fields.place(0));
  }

  void shell(std::string_view line) {
    const DeckCard fields = card(line, kShellWidths);
    const auto number = fields.id(0, "the element's number"), part = fields.id(1, "the part's number");
    std::vector<DeckMesh::Corner> corners;
    for (std::size_t i = 2; i < 5; ++i) corners.push_back(fields.corner(i));
    if (!fields.blank_or_zero(5)) corners.push_back(fields.corner(5));
    for (std::size_t i = 6; i < 10; ++i)
      if (!fields.blank_or_zero(i))
        deck_.fail(fields.place(i), "shells of more than 4 nodes are not supported");
    deck_.add_shell(number, part, std::move(corners), fields.place(0));
    cards_left_ = cards_of_shell_;
  }

  // If it is missing, the next shell would be skipped instead.
  void card_of_option(std::string_view line) {
    --cards_left_;
    if (line.find_first_of("123456789") != line.npos) deck_.neglect(word_);
    const DeckCard fields = card(line, kShellWidths);
    std::set<DeckMesh::Id> numbers;
    for (std::size_t i = 2; i < 5; ++i) numbers.insert(fields.whole(i).value_or(0));
    const bool is_shell = fields.whole(0) && fields.whole(1) && numbers.size() == 3 && !numbers.contains(0);
    if (is_shell)
      deck_.fail(
          fields.place(0),
          "looks like a shell, but the shell before still needs the card of its option: " + shown(line));
  }

  void part(std::string_view line) {
    const DeckCard fields = card(line, kPartWidths);
    deck_.name_part(fields.id(0, "the part's number"), title_, fields.place(0));
    at_.section = has_one_part_ ? Section::skipped : Section::part_title;
  }

  // A line that ends with ` +` continues in the next.
  void include(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t");
    file_name_ += line.substr(first, last + 1 - first);
    if (file_name_.ends_with(" +")) {
      file_name_.resize(file_name_.find_last_not_of(" \t", file_name_.size() - 2) + 1);
      at_.section = Section::include;
      return;
    }
    const std::string whole = std::exchange(file_name_, {});
    files_.include(deck_, {at_.file, at_.line, 1}, whole,
                   [&](const std::string& text, const std::string& name) {
                     const Cursor here = at_;
                     read_file(text, name);
                     at_ = here;
                   });
    at_.section = Section::more_includes;
  }

  DeckMesh deck_;
  DeckFiles files_;
  KeywordReference reference_{deck_};
  KeywordSets sets_{deck_};
  Cursor at_;
  std::string word_;           // the present keyword
  std::string title_;          // title of the part whose data card comes next
  std::string file_name_;      // name in *INCLUDE so far
  bool has_one_part_ = false;  // the present *PART
  int cards_of_shell_ = 0, cards_left_ = 0;
};

}  // namespace

Mesh parse_keyword(std::string_view text, const std::string& name, const IncludedFile& included) {
  return KeywordParser(included).parse(text, name);
}

}  // namespace mesh
