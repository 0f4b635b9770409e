// SPDX-License-Identifier: Apache-2.0
// The subcommands of `gasjet`, one source each. They return exit codes and throw CaseError or OutputError for
// code 2.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare.hpp"
#include "many_runs/crew.hpp"
#include "many_runs/ensemble.hpp"

namespace driver::commands {

inline constexpr int exit_done = 0;
inline constexpr int exit_outside = 1;        // compare: outside the band
inline constexpr int exit_input = 2;          // the command line or an input is wrong; nothing written
inline constexpr int exit_domain = 3;         // the computation left its domain; what was computed is kept
inline constexpr int exit_undecided = 4;      // compare, ladder: neither inside nor outside is certain
inline constexpr int exit_interrupted = 130;  // Ctrl-C, as shells report it; what was computed is kept

int exit_code(Verdict verdict);

/// Prints likely mistakes of a case, including its jets, before it runs.
void tell_warnings(Scene& scene);
/// Prints that many runs were interrupted and that the same command continues from the folder `kept`. Returns
/// exit_interrupted.
int tell_interrupted(const std::filesystem::path& kept);

struct CaseArguments {
  std::filesystem::path file;
  std::vector<std::string> overrides;  // in the order given: key.path=value, or unset key.path
};

struct RunArguments {
  CaseArguments scene;
  std::filesystem::path out;  // empty: results/<case file's stem>
  int threads = 1;
  bool quiet = false;
};
int run(const RunArguments& arguments);

int check(const CaseArguments& arguments, const std::string& format = "text");

struct EnsembleArguments {
  CaseArguments scene;
  std::filesystem::path against;  // a second case to compare with, or empty
  std::filesystem::path out;
  int runs = 16;
  double amplitude = default_amplitude;  // [m] random displacement of the initial nodes
  int first_seed = 1;                    // seed of the first run's displacements
  std::string share;                     // NUMBER/COUNT; empty: all
  int threads = 1;
  bool quiet = false;
};
int ensemble(const EnsembleArguments& arguments, const MakeCrew& crew);

struct LadderArguments {
  CaseArguments scene;
  std::string quantity;
  std::string tolerance = "2%";
  std::vector<std::string> hold;  // axes that keep the case's value, lists with commas
  std::filesystem::path out;
  int runs = 16;              // runs of each rung of a chaotic scene
  int most_runs = 0;          // most runs of a rung whose verdict is open
  double error_rate = 0.025;  // error rate of a verdict
  int finer = 1;              // levels of the mesh beyond the case's own
  int threads = 1;
  bool quiet = false;
};
int ladder(const LadderArguments& arguments, const MakeCrew& crew);

struct CostArguments {
  CaseArguments scene;
  std::filesystem::path out;  // if empty, nothing is written
  std::string format = "text";
  int runs = 9;
  int threads = 1;
  bool quiet = false;
};
int cost(const CostArguments& arguments);

/// One fold of `gasjet mesh fold`, as [[membrane.fold]] has it.
struct FoldArguments {
  bool press = false, letter = false, accordion = false, roll = false;
  std::string axis;                // x, y or z
  std::vector<double> at;          // [m] fold lines
  double gap = 0.0;                // [m] least distance between layers
  std::optional<double> easing;    // element lengths
  std::optional<double> flatten;   // factor of x, for a mesh file
  std::vector<std::string> fixed;  // panels that stay, for a mesh file
  std::filesystem::path design;    // stress-free shape of a mesh file, or empty
};

struct MeshArguments {
  std::filesystem::path file;                    // file to convert, or a case, or the results of a run
  double time = 0.0;                             // time in those results [s]
  double length_unit = 1.0;                      // length unit of that file [m]
  std::optional<double> merge;                   // join nodes within this distance [m]
  bool outward = false;                          // turn elements outward
  bool report = false;                           // an open or inside-out surface is not an error
  std::vector<std::string> panels, null_panels;  // panels of that file
  std::vector<std::string> caps;                 // NAME, NAME=HOLE or NAME=SET
  std::optional<double> cap_length;              // longest hole to close [m]
  std::filesystem::path out;                     // design shape, format by the ending; or empty
  std::filesystem::path initial;                 // initial shape, or empty
  std::vector<std::string> overrides;            // generator option, or key of the case = value
  int refine = 0;                                // number of refinements
  FoldArguments fold;
};
int mesh_driver(const MeshArguments& arguments);
int mesh_passenger(const MeshArguments& arguments);
int mesh_convert(const MeshArguments& arguments);
int mesh_of_case(const MeshArguments& arguments);
int mesh_of_state(const MeshArguments& arguments);
int mesh_fold(const MeshArguments& arguments);

struct ImportArguments {
  std::filesystem::path deck;
  std::filesystem::path out;
  std::optional<long> bag;           // number of the airbag, if the deck has several
  std::optional<std::string> units;  // of a deck that does not state them
  bool merge_chambers = false;       // all monitored volumes are one chamber
};
int import_deck(const ImportArguments& arguments);

struct ExactArguments {
  std::string name;
  bool list = false;
  std::vector<std::string> parameters;  // name=value
  std::string times;                    // first:last:step
  std::string format;                   // csv (the default) or json; of the list markdown or json
  bool proved = false;                  // bounds, which prove() prints
};
int exact(const ExactArguments& arguments);
int prove(const ExactArguments& arguments);

struct EncloseArguments {
  CaseArguments scene;
  std::string times;     // first:last:step [s]; empty: eleven times from 0 to the end
  double width = 1e-12;  // [-] of the bounds
  double longest = 600;  // [s] of computing
  bool literal = false;  // the laws without the laminar range (G.22)
};
int enclose(const EncloseArguments& arguments);

struct CompareArguments {
  std::filesystem::path mine, reference;
  std::filesystem::path map;           // map of the columns of mine, or empty
  std::vector<std::string> columns;    // columns to compare, lists with commas; empty: all of the reference
  std::vector<std::string> tolerance;  // tolerance of mine: SHARE of the reference's largest magnitude, or
                                       // COLUMN=SHARE
  std::filesystem::path rows;          // CSV of what was compared, or empty
  bool enclosure = false;              // the reference has proved bounds, of `gasjet enclose`
  std::string format = "text";         // or "json"
};
int compare(const CompareArguments& arguments);

struct ReportArguments {
  std::vector<std::filesystem::path> results;  // folders of run, ensemble, ladder; CSV files over time
  std::filesystem::path out;
  std::filesystem::path reference;  // history to judge runs by, or empty
};
int report(const ReportArguments& arguments);

struct StudyArguments {
  std::filesystem::path plan;
  std::filesystem::path out;     // empty: results/<name of the plan>
  std::string share;             // NUMBER/COUNT; empty: all
  std::filesystem::path folder;  // folder of shares to merge
  bool only_check = false;
  int threads = 1;
  bool quiet = false;
};
int study_run(const StudyArguments& arguments, const MakeCrew& crew);
int study_merge(const std::filesystem::path& folder);

struct ExportArguments {
  CaseArguments scene;
  std::string format;     // radioss or lsdyna
  std::string units;      // units of the deck
  bool any_size = false;  // true: accept a bag of any size
  std::filesystem::path out;
};
int export_deck(const ExportArguments& arguments);

struct IdentifyArguments {
  std::filesystem::path file;
  std::filesystem::path out;
  std::string method;            // "average" or "dual"
  double volume = 0.0;           // [m3]
  double mass = 0.0;             // [kg]
  std::string gas;               // gas of the inflator: NAME or NAME=FRACTION,......
  std::string tank_gas = "air";  // gas of the tank before firing
  std::string by = "mass";       // fractions by "mass" or "mole"
  std::string thermodynamics = "nasa7";
  std::filesystem::path species;        // a case whose [[gas.species]] may be used; empty: none
  double initial_temperature = 293.15;  // [K] of the tank's gas
  std::string time_column = "time_s";
  std::string tank_column = "tank_pressure_Pa";
  std::string chamber_column = "chamber_pressure_Pa";
  std::string time_unit = "s";
  std::string tank_unit = "Pa";
  std::optional<std::string> chamber_unit;  // empty: Pa
  std::optional<double> ambient_pressure;   // [Pa] that gauge pressures count from; empty: the standard one
  std::string noise = "reading";  // the gauges' noise is a share of the "reading" or of "full-scale"
  std::string heat_loss = "0";    // [W/K] of the walls, or "fit"
  double threshold = 0.05;        // share of the largest K
  int points = 501;               // rows of the curve
  int draws = 400;                // draws for the bands
};
int identify(const IdentifyArguments& arguments);

}  // namespace driver::commands
