// SPDX-License-Identifier: Apache-2.0
// rcforc: one line for each side and time, of alternate words and numbers. nodout: blocks with a heading,
// nodes in fields of 10 and 12 characters. rbdout: blocks with a heading, bodies in lines `displacements:
// ...`.
#include "lsdyna_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <elementary/hypot.hpp>
#include <limits>
#include <set>
#include <span>
#include <sstream>

#include "base/case_reader.hpp"
#include "base/number_text.hpp"
#include "base/text_file.hpp"

namespace driver {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct Word {
  std::string_view text;
  std::size_t column;  // from 1
};

std::vector<Word> words_of(std::string_view line) {
  std::vector<Word> words;
  constexpr const char* blanks = " \t\r";
  for (auto begin = line.find_first_not_of(blanks); begin != line.npos;) {
    const auto end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back({line.substr(begin, end - begin), begin + 1});
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

// Collects the rows of one object.
class Rows {
 public:
  Rows(const std::filesystem::path& file, std::vector<std::string> names, std::optional<int> number)
      : table_{file, std::move(names), {}, {}, {}}, number_(number) {
    table_.names.insert(table_.names.begin(), "time");
    table_.values.resize(table_.names.size());
    table_.positions.resize(table_.names.size());
  }

  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw CaseError(fmt::format("{}:{}:{}: {}", table_.file.string(), line_, column, what));
  }
  void next_line() { ++line_; }

  double number(const Word& word) const {
    const auto value = file_number_of(word.text);
    if (!value) fail(word.column, fmt::format("'{}' is not a finite number", word.text));
    return *value;
  }

  // True if the rows of this object are wanted.
  bool wants(const Word& word) {
    const double value = number(word);
    if (!(value >= 1.0 && value <= 2e9 && value == std::floor(value)))
      fail(word.column, fmt::format("'{}' is not a whole number of 1 or more", word.text));
    present_.insert(static_cast<int>(value));
    return value == number_.value_or(*present_.begin());
  }

  void begin_row(double time) {
    table_.lines.push_back(static_cast<std::uint32_t>(line_));
    for (std::size_t c = 0; c < table_.names.size(); ++c) {
      table_.values[c].push_back(c == 0 ? time : kMissing);
      table_.positions[c].push_back(1);
    }
  }
  bool has_row_at(double time) const { return !table_.lines.empty() && table_.values[0].back() == time; }

  // Sets values of the last row, in the column `first` and those after it.
  void put(std::string_view first, std::span<const Word> words) {
    const auto at = static_cast<std::size_t>(std::find(table_.names.begin(), table_.names.end(), first) -
                                             table_.names.begin());
    for (std::size_t i = 0; i < words.size(); ++i) {
      table_.values[at + i].back() = number(words[i]);
      table_.positions[at + i].back() = static_cast<std::uint32_t>(words[i].column);
    }
  }

  // Adds the magnitude of three columns.
  void add_magnitude(const std::string& name, std::string_view first) {
    const auto at = static_cast<std::size_t>(std::find(table_.names.begin(), table_.names.end(), first) -
                                             table_.names.begin());
    std::vector<double> sizes;
    for (std::size_t i = 0; i < table_.rows(); ++i)
      sizes.push_back(elementary::hypot(elementary::hypot(table_.values[at][i], table_.values[at + 1][i]),
                                        table_.values[at + 2][i]));
    table_.names.push_back(name);
    table_.values.push_back(std::move(sizes));
    table_.positions.push_back(table_.positions[at]);
  }

  // The table, without columns that the file does not have.
  CsvTable finish(const char* what) {
    if (present_.empty())
      throw CaseError(fmt::format("{}:1:1: no {} in the file", table_.file.string(), what));
    if (number_ && !present_.contains(*number_))
      throw CaseError(fmt::format("{}:1:1: number {}: no such {}, the file has {}", table_.file.string(),
                                  *number_, what, fmt::join(present_, ", ")));
    if (!number_ && present_.size() > 1)
      throw CaseError(fmt::format("{}:1:1: number: is missing in the map, the file has {} of {}",
                                  table_.file.string(), what, fmt::join(present_, ", ")));
    for (std::size_t c = table_.names.size(); c-- > 0;) {
      const auto gap = std::ranges::find_if(table_.values[c], [](double v) { return std::isnan(v); });
      if (gap == table_.values[c].end()) continue;
      if (std::ranges::any_of(table_.values[c], [](double v) { return !std::isnan(v); }))
        table_.fail(c, static_cast<std::size_t>(gap - table_.values[c].begin()),
                    fmt::format("the state has no {}, but others have", table_.names[c]));
      const auto i = static_cast<std::ptrdiff_t>(c);
      table_.names.erase(table_.names.begin() + i);
      table_.values.erase(table_.values.begin() + i);
      table_.positions.erase(table_.positions.begin() + i);
    }
    return std::move(table_);
  }

 private:
  CsvTable table_;
  std::optional<int> number_;
  std::set<int> present_;
  std::size_t line_ = 0;
};

bool contains(std::string_view line, std::string_view text) {
  return line.find(text) != line.npos;
}

template <class Line>
void for_lines(const std::filesystem::path& file, Rows& rows, Line&& on_line) {
  std::istringstream stream(read_text(file));
  for (std::string line; std::getline(stream, line);) {
    rows.next_line();
    on_line(std::string_view(line));
  }
}

// `slave 1 time 0.1E-02 x 0.5E+01 y ... z ... mass ...`; later versions call the sides surfa and surfb.
CsvTable read_rcforc(const std::filesystem::path& file, std::optional<int> number) {
  Rows rows(file, {"x", "y", "z"}, number);
  constexpr std::size_t kTime = 3, kFirst = 5, kNeeded = 10;
  std::string side;
  for_lines(file, rows, [&](std::string_view line) {
    const auto words = words_of(line);
    if (words.size() < 3 || words[2].text != "time" || !number_of(words[1].text)) return;  // the legend
    if (words.size() < kNeeded || words[4].text != "x" || words[6].text != "y" || words[8].text != "z")
      rows.fail(1, "the row has no x, y and z");
    if (!rows.wants(words[1])) return;
    if (side.empty()) side = words[0].text;
    if (words[0].text != side) return;
    rows.begin_row(rows.number(words[kTime]));
    const Word force[] = {words[kFirst], words[kFirst + 2], words[kFirst + 4]};
    rows.put("x", force);
  });
  rows.add_magnitude("force", "x");
  return rows.finish("contact");
}

std::vector<std::string> motion_columns() {
  std::vector<std::string> names;
  for (const char* what : {"disp", "vel", "accl", "coor", "rot", "rvel", "racc"})
    for (const char axis : {'x', 'y', 'z'}) names.push_back(fmt::format("{}_{}", axis, what));
  return names;
}

void add_motion_magnitudes(Rows& rows) {
  for (const char* what : {"disp", "vel", "accl"}) rows.add_magnitude(what, fmt::format("x_{}", what));
}

// The number after a word such as `time` or `time=`.
double number_after(const Rows& rows, std::string_view line, std::string_view word) {
  const auto begin = line.find(word) + word.size();
  const auto words = words_of(line.substr(begin));
  if (words.empty()) rows.fail(begin + 1, "ends before the number of the time");
  return rows.number({words[0].text, words[0].column + begin});
}

// Fields of 12 characters after the node's number. Full fields have no blanks in between.
std::vector<Word> fields_of(const Rows& rows, std::string_view line, std::size_t count) {
  constexpr std::size_t kNode = 10, kWidth = 12;
  std::vector<Word> fields;
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = kNode + i * kWidth;
    if (line.size() < begin + kWidth)
      rows.fail(begin + 1, fmt::format("the row ends in field {} of {}", i + 1, count));
    const auto words = words_of(line.substr(begin, kWidth));
    if (words.size() != 1) rows.fail(begin + 1, "is not one number in a field of 12 characters");
    fields.push_back({words[0].text, words[0].column + begin});
  }
  return fields;
}

CsvTable read_nodout(const std::filesystem::path& file, std::optional<int> number) {
  Rows rows(file, motion_columns(), number);
  enum class Block { none, translation, rotation } block = Block::none;
  double time = 0.0;
  for_lines(file, rows, [&](std::string_view line) {
    if (contains(line, "n o d a l   p r i n t   o u t")) {
      time = number_after(rows, line, "at time");
      block = Block::none;
      return;
    }
    if (contains(line, "nodal point")) {
      block = contains(line, "x-disp") ? Block::translation : Block::rotation;
      return;
    }
    const auto words = words_of(line);
    if (block == Block::none || words.empty()) return;
    constexpr std::size_t kNode = 10, kTranslations = 12, kRotations = 9;
    const auto node = words_of(line.substr(0, std::min(kNode, line.size())));
    if (node.size() != 1) rows.fail(1, "is not a node's number in ten characters");
    if (!rows.wants(node[0])) return;
    if (block == Block::translation) rows.begin_row(time);
    if (block == Block::rotation && !rows.has_row_at(time))
      rows.fail(1, "rotations of a state without translations");
    const bool moves = block == Block::translation;
    rows.put(moves ? "x_disp" : "x_rot", fields_of(rows, line, moves ? kTranslations : kRotations));
  });
  add_motion_magnitudes(rows);
  return rows.finish("node");
}

CsvTable read_rbdout(const std::filesystem::path& file, std::optional<int> number) {
  Rows rows(file, motion_columns(), number);
  double time = 0.0;
  bool wanted = false;
  for_lines(file, rows, [&](std::string_view line) {
    if (contains(line, "r i g i d   b o d y   m o t i o n")) {
      time = number_after(rows, line, "time=");
      wanted = false;
      return;
    }
    const auto words = words_of(line);
    for (std::size_t i = 0; i + 2 < words.size() && i < 2; ++i)
      if (words[i].text == "rigid" && words[i + 1].text == "body") {
        wanted = rows.wants(words[i + 2]);
        if (wanted) rows.begin_row(time);
        return;
      }
    if (contains(line, "principal or user defined")) wanted = false;  // the same in axes of the body
    if (!wanted || words.empty()) return;
    const auto row = [&](std::string_view name, std::size_t count, auto&& put) {
      if (words[0].text != name) return;
      if (words.size() != count + 1)
        rows.fail(1, fmt::format("has {} numbers, needed: {}", words.size() - 1, count));
      put(std::span(words).subspan(1));
    };
    row("coordinates:", 3, [&](auto values) { rows.put("x_coor", values); });
    const auto motion = [&](const char* along, const char* about) {
      return [&rows, along, about](auto values) {
        rows.put(along, values.subspan(0, 3));
        rows.put(about, values.subspan(3, 3));
      };
    };
    row("displacements:", 6, motion("x_disp", "x_rot"));
    row("velocities:", 6, motion("x_vel", "x_rvel"));
    row("accelerations:", 6, motion("x_accl", "x_racc"));
  });
  add_motion_magnitudes(rows);
  return rows.finish("rigid body");
}

}  // namespace

CsvTable read_lsdyna_text(const std::filesystem::path& file, LsDynaText kind, std::optional<int> number) {
  return kind == LsDynaText::rcforc   ? read_rcforc(file, number)
         : kind == LsDynaText::nodout ? read_nodout(file, number)
                                      : read_rbdout(file, number);
}

}  // namespace driver
