// SPDX-License-Identifier: Apache-2.0
#include <span>

#include "argument_list.hpp"
#include "base/build_info.hpp"
#include "commands/command.hpp"
#include "commands/program.hpp"
#include "identify_options.hpp"
#include "import_options.hpp"
#include "manual.hpp"
#include "mesh_options.hpp"
#include "validators.hpp"

namespace driver::commands {
namespace {

// Parsed immediately, so that overrides act in the order of the command line.
void add_override(CLI::App& command, std::vector<std::string>& overrides, const char* name,
                  std::string_view prefix, const char* meaning) {
  command
      .add_option_function<std::string>(
          name,
          [&overrides, prefix](const std::string& text) { overrides.push_back(std::string(prefix) + text); },
          meaning)
      ->trigger_on_parse();
}

void add_case(CLI::App& command, CaseArguments& arguments) {
  command.add_option("CASE", arguments.file, "case file (TOML)")->required();
  add_override(command, arguments.overrides, "--set", "",
               "key.path=value, replaces or adds a value of the case; may be repeated");
  add_override(command, arguments.overrides, "--unset", unset_prefix,
               "key.path of a value or table to remove from the case; may be repeated");
}

void add_threads(CLI::App& command, int& threads, bool& quiet) {
  command.add_option("--threads", threads, "threads; the results do not depend on it")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--quiet", quiet, "print only warnings and errors");
}

struct Arguments {
  RunArguments run;
  CaseArguments check;
  std::string check_format = "text";
  EnsembleArguments ensemble;
  LadderArguments ladder;
  CostArguments cost;
  MeshArguments mesh;
  ExactArguments exact;
  EncloseArguments enclose;
  IdentifyArguments identify;
  CompareArguments compare;
  ReportArguments report;
  StudyArguments study;
  ExportArguments export_deck;
  ImportArguments import_deck;
  std::filesystem::path manual;  // folder
};

void add_run(CLI::App& app, Arguments& all) {
  auto* run = app.add_subcommand("run", "simulate a case");
  add_case(*run, all.run.scene);
  add_threads(*run, all.run.threads, all.run.quiet);
  run->add_option("--out", all.run.out, "result folder (results/<case> by default)")->check(named);
}

void add_ensemble(CLI::App& app, Arguments& all) {
  auto* ensemble =
      app.add_subcommand("ensemble", "perturbed runs of a chaotic scene: means and standard errors");
  add_case(*ensemble, all.ensemble.scene);
  add_threads(*ensemble, all.ensemble.threads, all.ensemble.quiet);
  ensemble
      ->add_option("--out", all.ensemble.out,
                   "result folder (results/ensemble_<case> by default), a folder in it for each case")
      ->check(named);
  ensemble->add_option("--runs", all.ensemble.runs, "number of runs")->check(CLI::Range(2, 100000));
  ensemble->add_option("--amplitude", all.ensemble.amplitude, "largest displacement of the initial nodes [m]")
      ->check(within(1e-18, 1e-3, "1e-18 to 1e-3 m"));
  ensemble->add_option("--first-seed", all.ensemble.first_seed, "first seed of the displacements")
      ->check(CLI::Range(1, 999000000));
  ensemble->add_option("--share", all.ensemble.share, "NUMBER/COUNT: only this share of the runs")
      ->check(named);
  ensemble->add_option("--against", all.ensemble.against, "a second case: report the difference of the means")
      ->check(named);
}

void add_ladder(CLI::App& app, LadderArguments& a) {
  auto* ladder = app.add_subcommand(
      "ladder", "error and cost of simpler forms of a scene; the cheapest within a tolerance");
  add_case(*ladder, a.scene);
  add_threads(*ladder, a.threads, a.quiet);
  ladder
      ->add_option("--quantity", a.quantity, "column of the history at the end, or a quantity of `ensemble`")
      ->required()
      ->check(named);
  ladder->add_option("--tolerance", a.tolerance, "of the quantity; default: 2%")->type_name("SHARE");
  ladder->add_option("--hold", a.hold, "axes that keep the case's choice, separated by commas")
      ->allow_extra_args(false);
  ladder->add_option("--runs", a.runs, "of each rung if the scene is chaotic")->check(CLI::Range(2, 100000));
  ladder->add_option("--most-runs", a.most_runs, "of a rung whose verdict stays open; default: --runs")
      ->check(CLI::Range(2, 100000));
  ladder->add_option("--error-rate", a.error_rate, "of wrong verdicts by scatter; default: 0.025")
      ->check(CLI::Range(1e-6, 0.5));
  ladder->add_option("--finer", a.finer, "finer levels of the mesh than the case's own; default: 1")
      ->check(CLI::Range(1, 3));
  ladder->add_option("--out", a.out, "result folder (results/ladder_<case> by default)")->check(named);
}

void add_cost(CLI::App& app, CostArguments& a) {
  auto* cost = app.add_subcommand("cost", "cost of jet, hidden-element test, contact, gas and files");
  add_case(*cost, a.scene);
  add_threads(*cost, a.threads, a.quiet);
  cost->get_option("--quiet")->description("no progress is printed");
  cost->add_option("--runs", a.runs, "of each variant; the fastest counts")->check(CLI::Range(3, 1000));
  cost->add_option("--format", a.format, "text or json")->check(CLI::IsMember({"text", "json"}));
  cost->add_option("--out", a.out, "folder for cost.csv, cost.json and cost.txt")->check(named);
}

void add_others(CLI::App& app, Arguments& all) {
  auto* check = app.add_subcommand("check", "validate a case, print its settings and derived values");
  add_case(*check, all.check);
  check
      ->add_option("--format", all.check_format,
                   "text, json for other programs, or keys: all possible settings")
      ->check(CLI::IsMember({"text", "json", "keys"}));
  auto* exact = app.add_subcommand("exact", "print a closed form of the verification suite");
  exact->add_option("NAME", all.exact.name, "closed form, see --list");
  exact->add_flag("--list", all.exact.list, "the catalogue");
  exact->add_option("--set", all.exact.parameters, "name=value, one --set for each")->allow_extra_args(false);
  exact->add_option("--times", all.exact.times, "abscissae, first:last:step")
      ->check(not_empty("first:last:step"));
  exact->add_flag("--proved", all.exact.proved,
                  "lower and upper bounds of the formula, by ball arithmetic; with --list, of which forms");
  exact->add_option("--format", all.exact.format, "csv or json; of --list markdown or json")
      ->check(CLI::IsMember({"csv", "json", "markdown"}));
}

void add_enclose(CLI::App& app, EncloseArguments& a) {
  auto* c = app.add_subcommand("enclose", "proved bounds of a tank, as CSV");
  add_case(*c, a.scene);
  c->add_option("--times", a.times, "times [s], first:last:step; eleven from 0 to the end by default")
      ->check(not_empty("first:last:step"));
  c->add_option("--width", a.width, "of the bounds, as a share of the value; default: 1e-12")
      ->check(within(1e-25, 0.1, "1e-25 to 0.1"));
  c->add_option("--longest", a.longest, "seconds of computing, then exit code 3; default: 600")
      ->check(positive);
  c->add_flag("--literal", a.literal, "the laws without a laminar range near ambient pressure");
}

void add_compare(CLI::App& app, CompareArguments& a) {
  auto* c = app.add_subcommand(
      "compare", "difference of two histories, or means of many runs, against the reference's error band");
  c->add_option("MINE", a.mine, "history to judge")->required();
  c->add_option("REFERENCE", a.reference,
                "history (CSV) with a column <name>_band for each band, or ensemble.csv")
      ->required();
  c->add_flag("--enclosure", a.enclosure,
              "REFERENCE has proved bounds, of `gasjet enclose` or `exact --proved`");
  c->add_option("--map", a.map, "names, units and offsets of MINE's columns (TOML)")->check(named);
  c->add_option("--columns", a.columns, "quantities to compare, separated by commas; all by default")
      ->allow_extra_args(false);
  c->add_option("--tolerance", a.tolerance,
                "error allowed to mine, as a share of the reference's largest magnitude; COLUMN=SHARE for "
                "one column; may be repeated")
      ->allow_extra_args(false);
  c->add_option("--rows", a.rows, "CSV to write: both histories and band at common times")->check(named);
  c->add_option("--format", a.format, "text or json")->check(CLI::IsMember({"text", "json"}));
}

void add_report(CLI::App& app, ReportArguments& a) {
  auto* c =
      app.add_subcommand("report", "one HTML page of results: the bag in motion, charts, balances, settings");
  c->add_option("RESULTS", a.results, "folders of run, ensemble or ladder, or CSV files with a column time_s")
      ->required();
  c->add_option("--out", a.out, "HTML file to write")->required()->check(named);
  c->add_option("--against", a.reference, "reference (CSV) to judge the runs by, as compare does")
      ->check(named);
}

void add_study(CLI::App& app, StudyArguments& a) {
  auto* study = app.add_subcommand("study", "many runs of one case: factors, points, seeds, shares");
  study->require_subcommand(1);
  auto* run = study->add_subcommand("run", "compute the missing runs of a plan");
  run->add_option("PLAN", a.plan, "plan of the study (TOML)")->required();
  run->add_option("--out", a.out, "folder of the study (results/<name> by default)")->check(named);
  run->add_option("--share", a.share, "NUMBER/COUNT: only this share, on any machine; then `merge`")
      ->check(named);
  run->add_flag("--check", a.only_check,
                "read the plan; print the number of runs, and their cost from two runs");
  add_threads(*run, a.threads, a.quiet);
  auto* merge = study->add_subcommand("merge", "tables of all shares in a folder");
  merge->add_option("DIR", a.folder, "folder of the study")->required()->check(named);
}

int dispatch_study(const CLI::App& study, const StudyArguments& a, const MakeCrew& crew) {
  return study.got_subcommand("run") ? study_run(a, crew) : study_merge(a.folder);
}

void add_export(CLI::App& app, ExportArguments& a) {
  auto* c = app.add_subcommand("export", "write a scene with a bag as a deck of another program");
  add_case(*c, a.scene);
  c->add_option("--format", a.format, "program")->required()->check(CLI::IsMember({"radioss", "lsdyna"}));
  c->add_option("--units", a.units, "of mass, length and time in the deck")
      ->required()
      ->check(CLI::IsMember({"kg-m-s", "t-mm-s", "kg-mm-ms"}));
  c->add_option("--out", a.out, "folder of the deck, with export.md and export.json")
      ->required()
      ->check(named);
  c->add_flag("--any-size", a.any_size, "accept a bag below 0.02 m or above 10 m");
}

// Names an unknown command; CLI11 would only say that a command is missing.
void refuse_unknown_command(const CLI::App& app, std::span<char*> words) {
  if (words.empty() || words[0][0] == '-') return;
  std::string allowed;
  for (const auto* command : app.get_subcommands({})) {
    if (command->get_name() == words[0]) return refuse_unknown_command(*command, words.subspan(1));
    allowed += (allowed.empty() ? "" : ", ") + command->get_name();
  }
  if (allowed.empty()) return;  // a command without commands of its own
  throw CaseError(std::string("'") + words[0] + "' is not a command of " + app.get_name() +
                  ", allowed: " + allowed + " (see --help)");
}

int dispatch(const CLI::App& app, const Arguments& all, const MakeCrew& crew) {
  if (app.got_subcommand("run")) return run(all.run);
  if (app.got_subcommand("check")) return check(all.check, all.check_format);
  if (app.got_subcommand("ensemble")) return ensemble(all.ensemble, crew);
  if (app.got_subcommand("ladder")) return ladder(all.ladder, crew);
  if (app.got_subcommand("cost")) return cost(all.cost);
  if (app.got_subcommand("mesh")) return dispatch_mesh(*app.get_subcommand("mesh"), all.mesh);
  if (app.got_subcommand("identify")) return identify(all.identify);
  if (app.got_subcommand("compare")) return compare(all.compare);
  if (app.got_subcommand("report")) return report(all.report);
  if (app.got_subcommand("study")) return dispatch_study(*app.get_subcommand("study"), all.study, crew);
  if (app.got_subcommand("exact")) return all.exact.proved ? prove(all.exact) : exact(all.exact);
  if (app.got_subcommand("enclose")) return enclose(all.enclose);
  if (app.got_subcommand("export")) return export_deck(all.export_deck);
  if (app.got_subcommand("import")) return import_deck(all.import_deck);
  write_manual(app, all.manual);
  return exit_done;
}

}  // namespace

int run_command_line(int argc, char** argv, const MakeCrew& crew) {
  CLI::App app("Gasjet: inflating airbags with an analytical gas jet", "gasjet");
  app.set_version_flag("--version", std::string("gasjet ") + build_info::version + " (" + build_info::commit +
                                        ", " + build_info::compiler + ", " + build_info::flags + ")");
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 of compare: outside the band; 2 the command line or an input is wrong, nothing "
      "is written; 3 the computation left its domain or ended inaccurate, results so far are kept; 4 of "
      "compare and ladder: undecided, of study merge: incomplete; 130 ended by Ctrl-C, results so far are "
      "kept.");
  Arguments all;
  add_run(app, all);
  add_ensemble(app, all);
  add_ladder(app, all.ladder);
  add_cost(app, all.cost);
  add_mesh(app, all.mesh);
  add_others(app, all);
  add_identify(app, all.identify);
  add_report(app, all.report);
  add_study(app, all.study);
  add_enclose(app, all.enclose);
  add_compare(app, all.compare);
  add_export(app, all.export_deck);
  add_import(app, all.import_deck);
  add_manual(app, all.manual);
  refuse_unknown_command(app, std::span(argv, static_cast<std::size_t>(argc)).subspan(argc > 0));
  try {
    app.parse(words(argc, argv));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    throw CaseError(std::string(error.what()) + "; --help lists the options");
  }
  return dispatch(app, all, crew);
}

}  // namespace driver::commands
