// SPDX-License-Identifier: Apache-2.0
#include "manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "argument_list.hpp"
#include "base/build_info.hpp"
#include "results/results.hpp"
#include "validators.hpp"

namespace driver::commands {
namespace {

namespace fs = std::filesystem;

void write_file(const fs::path& file, const std::string& text) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  std::ofstream stream(file);
  stream << text;
  stream.close();
  if (!stream) throw OutputError(fmt::format("--out: {} is not writable", file.string()));
}

// The words of a command: "gasjet mesh driver".
std::string full_name(const CLI::App& app) {
  return app.get_parent() ? full_name(*app.get_parent()) + ' ' + app.get_name() : app.get_name();
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_name().empty(); });
}

// The options of `app`; positional arguments, or all others.
std::vector<const CLI::Option*> options_of(const CLI::App& app, bool positional) {
  return app.get_options(
      [positional](const CLI::Option* option) { return option->get_positional() == positional; });
}

// The named values of an option: "{text,json}" in its type.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto begin = type.find('{'), end = type.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

// Text for roff: hyphens as typed, and no line read as a request.
std::string roff(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    const bool begins_line = safe.empty() || safe.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) safe += "\\&";
    if (c == '-') safe += '\\';
    safe += c;
    if (c == '\\') safe += 'e';
  }
  return safe;
}

std::string synopsis(const CLI::App& app) {
  std::string text = "\\fB" + roff(full_name(app)) + "\\fR [\\fIOPTIONS\\fR]";
  for (const auto* option : options_of(app, true)) {
    const std::string name = "\\fI" + roff(option->get_name(true)) + "\\fR";
    text += option->get_required() ? ' ' + name : " [" + name + ']';
  }
  if (!commands_of(app).empty()) text += " \\fICOMMAND\\fR";
  return text + '\n';
}

std::string option_lines(const CLI::Option& option) {
  std::string text = ".TP\n\\fB" + roff(option.get_name(option.get_positional())) + "\\fR";
  if (takes_value(option) && !option.get_positional())
    text += " \\fI" + roff(option.get_type_name()) + "\\fR";
  text += '\n' + roff(option.get_description());
  if (!option.get_default_str().empty()) text += roff(" (" + option.get_default_str() + " by default)");
  if (option.get_required()) text += " (needed)";
  return text + '\n';
}

// Arguments, options and commands of one command.
std::string body(const CLI::App& app) {
  std::string text;
  for (const bool positional : {true, false})
    for (const auto* option : options_of(app, positional)) text += option_lines(*option);
  for (const auto* command : commands_of(app))
    text += ".TP\n\\fB" + roff(full_name(*command)) + "\\fR\n" + roff(command->get_description()) + '\n';
  return text;
}

std::string page(const CLI::App& app) {
  std::string name = full_name(app);
  std::replace(name.begin(), name.end(), ' ', '-');
  std::string text = fmt::format(".\\\" Written by gasjet manual.\n.TH {} 1 \"\" \"Gasjet {}\" \"Gasjet\"\n",
                                 name, build_info::version);
  text +=
      ".SH NAME\n" + roff(name) + " \\- " + roff(app.get_description()) + "\n.SH SYNOPSIS\n" + synopsis(app);
  text += ".SH OPTIONS\n" + body(app);
  if (app.get_parent())
    for (const auto* command : commands_of(app))
      text += ".SH " + roff(full_name(*command)) + '\n' + synopsis(*command) + body(*command);
  const CLI::App& whole = app.get_parent() ? *app.get_parent() : app;
  text += ".SH EXIT STATUS\n" + roff(whole.get_footer()) + "\n.SH SEE ALSO\n\\fBgasjet\\fR(1)";
  for (const auto* command : commands_of(whole))
    text += ", \\fBgasjet\\-" + roff(command->get_name()) + "\\fR(1)";
  return text + '\n';
}

void write_pages(const CLI::App& app, const fs::path& folder) {
  std::string name = full_name(app);
  std::replace(name.begin(), name.end(), ' ', '-');
  write_file(folder / (name + ".1"), page(app));
  if (!app.get_parent())
    for (const auto* command : commands_of(app)) write_pages(*command, folder);
}

// Adds lines of two tables: words that may follow a command; values of an option, "-" if any.
void add_completion(const CLI::App& app, std::string& words, std::string& values) {
  const std::string name = full_name(app);
  words += fmt::format("  ['{}']='", name);
  for (const auto* command : commands_of(app)) words += command->get_name() + ' ';
  for (const auto* option : options_of(app, false)) {
    for (const auto& word : option->get_lnames()) {
      words += "--" + word + ' ';
      if (!takes_value(*option)) continue;
      const auto choices = choices_of(*option);
      values += fmt::format("  ['{} --{}']='{}'\n", name, word,
                            choices.empty() ? "-" : CLI::detail::join(choices, " "));
    }
  }
  words.back() = '\'';
  words += '\n';
  for (const auto* command : commands_of(app)) add_completion(*command, words, values);
}

std::string completion(const CLI::App& app) {
  std::string words, values;
  add_completion(app, words, values);
  return "# bash completion of gasjet. Written by gasjet manual.\ndeclare -gA _gasjet_words=(\n" + words +
         ")\ndeclare -gA _gasjet_values=(\n" + values + R"()
_gasjet() {
  local word=${COMP_WORDS[COMP_CWORD]} command=gasjet i values
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    [[ -z ${_gasjet_words["$command ${COMP_WORDS[i]}"]+known} ]] || command+=" ${COMP_WORDS[i]}"
  done
  values=${_gasjet_values["$command ${COMP_WORDS[COMP_CWORD - 1]}"]-}
  case $values in
    -) ;; # any value: files, by `-o default`
    ?*) mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word") ;;
    *)
      [[ $word != -* && ${_gasjet_words[$command]} == -* ]] || # a command that takes files
        mapfile -t COMPREPLY < <(compgen -W "${_gasjet_words[$command]}" -- "$word")
      ;;
  esac
}
complete -o default -F _gasjet gasjet
)";
}

}  // namespace

void add_manual(CLI::App& app, fs::path& folder) {
  auto* manual = app.add_subcommand("manual", "write man pages and bash completion");
  manual->add_option("--out", folder, "folder, such as /usr/share")->required()->check(named);
}

void write_manual(const CLI::App& app, const fs::path& folder) {
  write_pages(app, folder / "man" / "man1");
  write_file(folder / "bash-completion" / "completions" / "gasjet", completion(app));
}

}  // namespace driver::commands
