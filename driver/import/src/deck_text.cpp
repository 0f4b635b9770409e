// SPDX-License-Identifier: Apache-2.0
#include "import/deck_text.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "base/text_file.hpp"
#include "deck_reader.hpp"

namespace driver::imported {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{256} << 20;  // [bytes]
constexpr int most_nested = 16;
constexpr std::size_t most_files = 1000;

std::string slurp(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw FileError(fmt::format("{}: is a folder, needed: a deck", file.string()));
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(fmt::format("{}: cannot be read", file.string()));
  if (std::filesystem::is_regular_file(file, error) && std::filesystem::file_size(file, error) > largest_file)
    throw FileError(fmt::format("{}: has more than 256 MiB", file.string()));
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

// True if the path leaves the folder that it is relative to.
bool leaves(const std::filesystem::path& path) {
  const auto normal = path.lexically_normal();
  return path.is_absolute() || (!normal.empty() && *normal.begin() == "..");
}

}  // namespace

std::string DeckText::where(Place at) const {
  const auto& file = files[static_cast<std::size_t>(at.file)];
  const auto relative = file.lexically_relative(files.front().parent_path());
  const std::string name = relative.empty() ? file.filename().string() : relative.string();
  return at.line > 0 ? fmt::format("{}:{}", name, at.line) : name;
}

void DeckReader::count_after_end(char mark, std::string_view text, Place end) {
  std::size_t count = text.starts_with(mark) ? 1 : 0;
  for (auto at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
    if (text.substr(at + 1).starts_with(mark)) ++count;
  if (count > 0)
    lose(end, std::string(1, mark) + "END",
         fmt::format("ends the file: {} cards after it are not read", count));
}

void DeckReader::read_file(const std::filesystem::path& file,
                           const std::function<bool(const DeckLine&)>& read) {
  const int number = static_cast<int>(deck_.files.size());
  deck_.texts.push_back(slurp(file));
  deck_.files.push_back(file);
  std::string_view text = deck_.texts.back();
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  for (int line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view whole = text.substr(0, end);
    if (whole.ends_with('\r')) whole.remove_suffix(1);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!read({whole, {number, line}})) return count_after_end(whole[0], text, {number, line});
  }
}

bool DeckReader::include(std::string_view name, const std::string& card, Place at,
                         const std::function<bool(const DeckLine&)>& read) {
  const std::filesystem::path path{std::string(without_blanks(name))};
  const auto fail = [&](const std::string& what) {
    lose(at, card, fmt::format("the file {} {}", path.string(), what));
    return false;
  };
  if (path.empty()) return fail("has no name");
  if (depth_ >= most_nested || deck_.files.size() >= most_files)
    return fail("is not read: files include each other more than 16 deep, or there are more than 1000");
  if (leaves(path)) return fail("is not read: it is not in the folder of the deck or below; copy it there");
  auto places = folders;
  places.insert(places.begin(), deck_.files.front().parent_path());
  places.insert(places.begin(), deck_.files[static_cast<std::size_t>(at.file)].parent_path());
  for (const auto& folder : places) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(folder / path, error)) continue;
    ++depth_;
    try {
      read_file(folder / path, read);
    } catch (const FileError& fault) {
      --depth_;
      return fail(fmt::format("is not read: {}", fault.what()));
    }
    --depth_;
    return true;
  }
  return fail("is not there");
}

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::string in_capitals(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

std::string in_small_letters(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

bool is_remark(std::string_view comment) {
  comment.remove_prefix(std::min<std::size_t>(1, comment.size()));
  if (comment.starts_with('#') || comment.starts_with('-')) return false;
  std::size_t letters = 0, words = 0;
  bool in_word = false;
  for (const char c : comment) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (letter) ++letters;
    if (letter && !in_word) ++words;
    in_word = c != ' ' && c != '\t';
  }
  // Headers are words far apart, each above its column.
  const bool spaced = comment.find("   ") != std::string_view::npos &&
                      without_blanks(comment).find("   ") != std::string_view::npos;
  return letters > 3 && words > 0 && !spaced;
}

DeckFormat program_of(const std::filesystem::path& deck) {
  const std::string ending = in_small_letters(deck.extension().string());
  if (ending == ".rad") return DeckFormat::radioss;
  if (ending == ".k" || ending == ".key" || ending == ".dyn") return DeckFormat::lsdyna;
  std::ifstream stream(deck);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("*KEYWORD")) return DeckFormat::lsdyna;
    if (line.starts_with("#RADIOSS") || line.starts_with("/BEGIN")) return DeckFormat::radioss;
  }
  throw CaseError(fmt::format(
      "{}: is not a deck, allowed: a file .k, .key or .dyn of LS-DYNA, or a starter file .rad of Radioss",
      deck.string()));
}

DeckText read_deck_text(const std::filesystem::path& deck) {
  DeckText text;
  text.program = program_of(deck);
  if (text.program == DeckFormat::lsdyna)
    read_lsdyna_text(deck, text);
  else
    read_radioss_text(deck, text);
  return text;
}

}  // namespace driver::imported
