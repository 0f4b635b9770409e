// SPDX-License-Identifier: Apache-2.0
// How far all shares of a study are, while one of them is computed.
#include <algorithm>
#include <charconv>
#include <fstream>

#include "study/parts.hpp"

namespace driver {
namespace {

using Clock = std::chrono::steady_clock;
// Looks are this far apart at least, and take at most a hundredth of the time: a folder of many shares may be
// slow.
constexpr std::chrono::seconds shortest_pause{1};
constexpr int pauses_of_a_look = 100;

// The number in a share's line of a run, without reading the rest.
std::optional<long> number_of_line(std::string_view line) {
  constexpr std::string_view key = "\"run\":";
  const std::size_t at = line.find(key);
  long number = 0;
  if (!line.starts_with("{\"cpu_s\":") || at == std::string_view::npos) return std::nullopt;
  const auto [end, error] = std::from_chars(line.data() + at + key.size(), line.data() + line.size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

// What stands in a file behind `from`, up to its last whole line.
std::string whole_lines(const std::filesystem::path& file, std::uintmax_t from) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(from));
  std::string text(std::istreambuf_iterator<char>(stream), {});
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  return text;
}

}  // namespace

StudyWatch::StudyWatch(const StudyPlan& plan, const std::filesystem::path& folder, const Share& own)
    : folder_(folder / shares_folder),
      own_(own.name()),
      is_ended_(static_cast<std::size_t>(plan.end_of_numbers())),
      next_look_(Clock::now() + shortest_pause) {
  for_each_file([](const auto& file, std::uintmax_t& read) {
    std::error_code error;
    if (const auto size = std::filesystem::file_size(file, error); !error) read = size;
  });
}

template <class Action>
void StudyWatch::for_each_file(const Action& action) {
  std::error_code error;  // a folder that cannot be listed shows no progress
  for (std::filesystem::directory_iterator entry(folder_, error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename() != own_) action(entry->path() / journal_file, read_[entry->path()]);
}

void StudyWatch::add(long run) {
  if (run < 0 || run >= static_cast<long>(is_ended_.size()) || is_ended_[static_cast<std::size_t>(run)])
    return;
  is_ended_[static_cast<std::size_t>(run)] = true;
  ++ended_;
}

long StudyWatch::ended() {
  const auto begin = Clock::now();
  if (begin < next_look_) return ended_;
  for_each_file([&](const auto& file, std::uintmax_t& read) {
    std::error_code error;
    if (const auto size = std::filesystem::file_size(file, error); error || size <= read) return;
    const std::string text = whole_lines(file, read);
    read += text.size();
    for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
      end = text.find('\n', at);
      if (const auto number = number_of_line(std::string_view(text).substr(at, end - at))) add(*number);
    }
  });
  const auto now = Clock::now();
  next_look_ = now + std::max<Clock::duration>(shortest_pause, pauses_of_a_look * (now - begin));
  return ended_;
}

}  // namespace driver
