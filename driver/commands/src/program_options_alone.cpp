// SPDX-License-Identifier: Apache-2.0
// The command line of a program that is to be small (cmake/alone): the commands that its page needs, without
// help.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <span>

#include "base/build_info.hpp"
#include "base/case_reader.hpp"
#include "base/number_text.hpp"
#include "commands/command.hpp"
#include "commands/program.hpp"

namespace driver::commands {
namespace {

struct Option {
  std::string name;
  std::function<void(const std::string&)> take;
  bool has_value = true;
};

// Options take the next word; other words are given to `rest`.
void parse(std::span<char*> words, const std::vector<Option>& options,
           const std::function<void(const std::string&)>& rest) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i];
    if (!word.starts_with("--")) {
      rest(word);
      continue;
    }
    const auto found = std::ranges::find(options, word, &Option::name);
    if (found == options.end()) throw CaseError(word + ": is not an option of this command");
    if (found->has_value && i + 1 == words.size()) throw CaseError(word + ": needs a value");
    found->take(found->has_value ? words[++i] : "");
  }
}

std::function<void(const std::string&)> to(std::filesystem::path& path) {
  return [&path](const std::string& word) {
    if (!path.empty()) throw CaseError(word + ": is one file too many");
    path = word;
  };
}
std::function<void(const std::string&)> to(std::string& text) {
  return [&text](const std::string& word) { text = word; };
}
std::function<void(const std::string&)> to(int& number) {
  return [&number](const std::string& word) {
    const auto value = number_of(word);
    if (!value || !(*value >= 1.0 && *value <= 100000.0) || *value != std::floor(*value))
      throw CaseError(word + ": is no number of runs or seed, allowed: a whole number from 1 to 100000");
    number = static_cast<int>(*value);
  };
}

std::vector<Option> of_case(CaseArguments& scene, std::vector<Option> others) {
  others.push_back({"--set", [&](const std::string& word) { scene.overrides.push_back(word); }});
  others.push_back({"--unset", [&](const std::string& word) {
                      scene.overrides.push_back(std::string(unset_prefix) + word);
                    }});
  return others;
}

Option quiet(bool& is_quiet) {
  return {"--quiet", [&](const std::string&) { is_quiet = true; }, false};
}

int run_words(std::span<char*> words) {
  RunArguments a;
  parse(words, of_case(a.scene, {{"--out", to(a.out)}, quiet(a.quiet)}), to(a.scene.file));
  return run(a);
}

int check_words(std::span<char*> words) {
  CaseArguments a;
  std::string format = "text";
  parse(words, of_case(a, {{"--format", to(format)}}), to(a.file));
  return check(a, format);
}

int report_words(std::span<char*> words) {
  ReportArguments a;
  parse(words, {{"--out", to(a.out)}, {"--against", to(a.reference)}},
        [&](const std::string& word) { a.results.emplace_back(word); });
  return report(a);
}

int compare_words(std::span<char*> words) {
  CompareArguments a;
  parse(words, {{"--format", to(a.format)}, {"--rows", to(a.rows)}, {"--map", to(a.map)}},
        [&](const std::string& word) { (a.mine.empty() ? a.mine : a.reference) = word; });
  return compare(a);
}

int ensemble_words(std::span<char*> words, const MakeCrew& crew) {
  EnsembleArguments a;
  parse(words,
        of_case(a.scene, {{"--out", to(a.out)},
                          {"--runs", to(a.runs)},
                          {"--first-seed", to(a.first_seed)},
                          {"--share", to(a.share)},
                          {"--against", to(a.against)},
                          quiet(a.quiet)}),
        to(a.scene.file));
  return ensemble(a, crew);
}

int ladder_words(std::span<char*> words, const MakeCrew& crew) {
  LadderArguments a;
  parse(words,
        of_case(a.scene, {{"--out", to(a.out)},
                          {"--quantity", to(a.quantity)},
                          {"--tolerance", to(a.tolerance)},
                          {"--runs", to(a.runs)},
                          {"--finer", to(a.finer)},
                          quiet(a.quiet)}),
        to(a.scene.file));
  return ladder(a, crew);
}

}  // namespace

int run_command_line(int argc, char** argv, const MakeCrew& crew) {
  const auto words = std::span(argv, static_cast<std::size_t>(argc)).subspan(argc > 0);
  const std::string command = words.empty() ? "" : words[0];
  const auto rest = words.subspan(words.empty() ? 0 : 1);
  if (command == "run") return run_words(rest);
  if (command == "check") return check_words(rest);
  if (command == "report") return report_words(rest);
  if (command == "compare") return compare_words(rest);
  if (command == "ensemble") return ensemble_words(rest, crew);
  if (command == "ladder") return ladder_words(rest, crew);
  if (command == "--version") {
    fmt::print("gasjet {} ({}, {}, {})\n", build_info::version, build_info::commit, build_info::compiler,
               build_info::flags);
    return exit_done;
  }
  throw CaseError(
      fmt::format("'{}' is not a command of this program, allowed: run, check, report, compare, ensemble, "
                  "ladder",
                  command));
}

}  // namespace driver::commands
