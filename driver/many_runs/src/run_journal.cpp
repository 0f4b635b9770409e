// SPDX-License-Identifier: Apache-2.0
#include "run_journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/case_reader.hpp"

namespace driver {
namespace {

using RunJson = nlohmann::json;

CaseError damaged(const std::string& place) {
  return CaseError(fmt::format(
      "{}: is damaged, not a run of the plan: remove the line and run the same command to compute it again",
      place));
}

// What stands in a file behind `from`, up to its last whole line.
std::string whole_lines(const std::filesystem::path& file, std::uintmax_t from) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(from));
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad()) throw CaseError(fmt::format("{}: cannot be read", file.string()));
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  return text;
}

std::string head_line(const Provenance& build, const std::vector<RunInput>& inputs) {
  RunJson list = RunJson::array();
  for (const auto& [file, digits] : inputs) list.push_back({file.string(), digits});
  return RunJson{{"build", build}, {"inputs", std::move(list)}}.dump(-1, ' ', false,
                                                                     RunJson::error_handler_t::replace);
}

}  // namespace

void RunJournal::read_shares(const std::filesystem::path& folder, const std::string& run) {
  shares_ = folder / shares_folder;
  for (const auto& share : shares_in(folder, run)) read(share / journal_file);
}

void RunJournal::open(ResultFolder& folder) {
  own_ = folder.add(journal_file);
  read(own_);
  file_ = std::make_unique<GrowingFile>(own_, true);
  // On a line of its own, whatever a kill has torn before.
  file_->append('\n' + head_line(folder.lines(), inputs_) + '\n');
}

const RunRecord* RunJournal::find(long number) const {
  const auto found = runs_.find(number);
  return found == runs_.end() ? nullptr : &found->second;
}

const RunRecord& RunJournal::keep(CrewResult result) {
  if (file_) file_->append(result.line + '\n');
  auto* known = std::any_cast<RunRecord>(&result.object);
  RunRecord run = known ? std::move(*known) : record_of_line(result.line, shape_).value();
  const long number = run.number;
  return runs_.try_emplace(number, std::move(run)).first->second;
}

void RunJournal::read(const std::filesystem::path& file) {
  Place& place = read_[file];
  const std::string text = whole_lines(file, place.bytes);
  place.bytes += text.size();
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = text.find('\n', at);
    ++place.lines;
    read_line(text.substr(at, end - at), file, place);
  }
}

void RunJournal::read_line(const std::string& line, const std::filesystem::path& file, Place& read) {
  const auto place = [&] { return fmt::format("{}:{}:1", file.string(), read.lines); };
  if (line.starts_with("{\"build\":") && RunJson::accept(line)) {
    read.has_head = read_head(line, place()) || read.has_head;
  } else if (auto run = record_of_line(line, shape_)) {
    if (!read.has_head)
      throw CaseError(
          fmt::format("{}: is a run without a line before it that names its files, from an earlier "
                      "version: use another folder",
                      place()));
    const long number = run->number;
    runs_.try_emplace(number, std::move(*run));
  } else if (RunJson::accept(line)) {
    throw damaged(place());
  }
}

bool RunJournal::read_head(const std::string& line, const std::string& place) {
  std::vector<std::pair<std::string, std::string>> inputs;
  try {
    const RunJson json = RunJson::parse(line);
    auto build = json.at("build").get<Provenance>();
    if (build_.empty()) build_ = std::move(build);
    if (!json.contains("inputs")) return false;
    inputs = json.at("inputs");
  } catch (const RunJson::exception&) {
    throw damaged(place);
  }
  if (inputs.size() != inputs_.size())
    throw CaseError(
        fmt::format("{}: its runs have read {} files, not the {} of the plan: another build or plan has "
                    "computed them; use another folder",
                    place, inputs.size(), inputs_.size()));
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].second != inputs_[i].digits)
      throw CaseError(
          fmt::format("{}: is not as it was when the runs of {} read it (as {}): put it back, or use another "
                      "folder",
                      inputs_[i].file.string(), place, inputs[i].first));
  return true;
}

void RunJournal::look_at_shares() {
  using Clock = std::chrono::steady_clock;
  // Looks are this far apart at least, and take at most a hundredth of the time: a folder of many shares may
  // be slow.
  constexpr std::chrono::seconds shortest_pause{1};
  constexpr int pauses_of_a_look = 100;
  const auto begin = Clock::now();
  if (begin < next_look_) return;
  std::error_code error;  // a folder that cannot be listed shows no progress
  for (std::filesystem::directory_iterator entry(shares_, error), end; !error && entry != end;
       entry.increment(error))
    if (const auto file = entry->path() / journal_file; file != own_) try {
        read(file);
      } catch (const CaseError&) {
      }
  const auto now = Clock::now();
  next_look_ = now + std::max<Clock::duration>(shortest_pause, pauses_of_a_look * (now - begin));
}

}  // namespace driver
