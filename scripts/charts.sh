#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the tables and pictures of docs/charts and docs/figures: those of the plans of cases/studies, and
#   ladders       all of: ladder_passenger, the paper's scene, each rung the mean of 16 runs; ladder_passenger_5, to 5 % with a mesh four
#                 times as fine; ladder_passenger_effects, its effects alone on its own mesh to 5 %, more runs where a
#                 verdict is open; ladder_sharp and ladder_sharp_5, the scene with friction to 2 and to 5 %,
#                 a mesh four times as fine
#   jet_cost      what the jet and the other parts of the scene cost: the one source of such numbers in README and docs
#   jet_effect    README's figure and table: ensembles with and without jet, 32 runs each
#   figure_3      Fig. 3 of the paper: mass flow of nitrogen at 673 K through 8.5 dm2 of hole, (G.6), and of porous fabric, (G.7). It
#                 states neither ambient pressure nor porosity: 101325 Pa, and the fabric for the 0.05 of its scene and over eta^2
#   jet_decay     centreline decay, spreading and entrainment of the jet model against bands of measured jets (docs/theory/jet.md)
#   damaged       what damaged input does: an hour of the fuzzers, and 10,000 damaged cases by class
#   frames        the scene with and without jet at the same times, as the paper's Figures 10 and 11
#   concepts      drawings of what words say poorly
#   examples      pictures that the programs of docs/examples draw; needs a build with bindings, scipy and matplotlib
#   forecast, detection, ablation and the work-precision charts: see forecast.sh, detection.sh, ablation.sh and benchmarks.sh in
#                 docs/make/charts
# Runs that results/studies has are not computed again.
# usage: scripts/charts.sh [--threads N] [--out FOLDER] NAME...      1, docs/charts; GASJET names the program; `--list` tells the names
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=../docs/make/charts/common.sh
source docs/make/charts/common.sh
# shellcheck source-path=SCRIPTDIR source=../docs/make/charts/benchmarks.sh
source docs/make/charts/benchmarks.sh
threads=1 out=docs/charts gasjet=${GASJET:-build/gasjet}
[[ ! -d $gasjet ]] || gasjet+=/build/gasjet # a clone, as the tutorials set it

# draw NAME [COMMANDS]: its picture, of its table
draw() {
  gnuplot -e "data=$(gnuplot_file "$out/$1.csv"); out=$(gnuplot_file "$out/$1.svg")${2:+; $2}" "docs/charts/gnuplot/${3:-$1}.gp"
}

# --- plans

# rows NAME FOLDER: the table of the study in FOLDER: its means, or what is made of them
rows() {
  case $1 in
    what_to_measure) grep -v '^#' "$2/sobol.csv" ;;
    coupled_work_precision | speed_accuracy) awk -F, -v study="$1" -f docs/make/charts/studies.awk "$2"/{timing,means}.csv ;;
    ensemble_convergence | jet_map | impulse_limits | first_contact_seed | weave | runs_needed | mesh_parts)
      awk -F, -v study="$1" -f docs/make/charts/studies.awk "$2/means.csv"
      ;;
    *) grep -v '^#' "$2/means.csv" ;;
  esac
}

# further NAME: tables that follow from that of NAME
further() {
  case $1 in
    impulse_limits) awk -F, -v of=impulse -f docs/make/charts/limits.awk "$out/$1.csv" >"$out/$1_fits.csv" ;;
    ensemble_convergence | first_contact_seed)
      [[ ! -f $out/ensemble_convergence.csv || ! -f $out/first_contact_seed.csv ]] ||
        awk -F, -v of=mesh -f docs/make/charts/limits.awk "$out"/{ensemble_convergence,first_contact_seed}.csv >"$out/mesh_limits.csv"
      ;;
  esac
}

# What a plan needs beside its case: the meshes of mesh_parts.
prepare() {
  local part folder=results/studies/mesh_parts
  [[ $1 == mesh_parts ]] || return 0
  mkdir -p "$folder"
  "$gasjet" mesh case cases/passenger_pendulum_no_jet.toml --initial "$folder/initial.obj" --out "$folder/design.obj" >/dev/null
  for part in none front rest main,attachment side_left,side_right all; do
    python3 docs/make/charts/refine_part.py "$folder"/{design,initial}.obj "$folder/${part//,/+}"_{design,initial}.obj "$part"
  done
}

study() {
  local folder=results/studies/$1
  prepare "$1"
  "$gasjet" study run "cases/studies/$1.toml" --out "$folder" --threads "$threads" || [[ $? == 3 ]] # 3: some runs are in no mean
  { provenance; grep '^# status: ' "$folder/means.csv"; rows "$1" "$folder"; } >"$folder/table.csv.new"
  mv "$folder/table.csv.new" "$out/$1.csv"
  further "$1"
  [[ ! -f docs/charts/gnuplot/$1.gp ]] || draw "$1"
  echo "$out/$1.csv"
}

# --- what no plan says

# ladder TABLE CASE TOLERANCE OPTION...: undecided is an answer too.
ladder() {
  local code=0 folder=results/ladders/$1
  "$gasjet" ladder "cases/$2.toml" --quantity pendulum_angle --tolerance "$3" --threads "$threads" --out "$folder" "${@:4}" || code=$?
  ((code == 0 || code == 4))
  cp "$folder/ladder.csv" "$out/$1.csv"
}

chart_ladder_passenger() {
  ladder ladder_passenger passenger_pendulum 10%
  draw ladder_passenger
}

chart_ladder_passenger_5() { ladder ladder_passenger_5 passenger_pendulum 5% --finer 2 --most-runs 256; }

chart_ladder_passenger_effects() {
  ladder ladder_passenger_effects passenger_pendulum 5% --hold mesh,pieces,step,gas --most-runs 512
}

chart_ladder_sharp() { ladder ladder_sharp passenger_sharp 2% --finer 2 --most-runs 32; }
chart_ladder_sharp_5() { ladder ladder_sharp_5 passenger_sharp 5% --finer 2 --most-runs 128; }

chart_ladders() {
  chart_ladder_passenger
  chart_ladder_passenger_5
  chart_ladder_passenger_effects
  chart_ladder_sharp
  chart_ladder_sharp_5
}

chart_jet_cost() {
  "$gasjet" cost cases/passenger_pendulum.toml --runs 9 --quiet --out results/cost >/dev/null
  { machine "one thread used"; build_version; grep -v '^#' results/cost/cost.csv; } >"$out/jet_cost.csv"
}

chart_jet_effect() {
  local folder=results/figures figure=docs/figures
  "$gasjet" ensemble cases/passenger_pendulum.toml --against cases/passenger_pendulum_no_jet.toml --runs 32 --threads "$threads" --out "$folder"
  { provenance; cat "$folder/effects.csv"; } >"$figure/jet_effect.csv"
  scripts/plot.sh ensemble --title 'The gas jet swings the pendulum more than twice as far' \
    --name 'with jet' --name 'without jet' "$folder/plot" "$folder"/passenger_pendulum{,_no_jet}
  cp "$folder/plot.svg" "$figure/passenger_pendulum.svg"
}

# of_flow NAME ARGUMENTS...: a closed form at 0 to 100 kPa. It rises like a root: finely spaced to 1 kPa.
of_flow() {
  local times
  for times in 0:980:20 1000:100000:1000; do
    "$gasjet" exact "$1" --times "$times" --set temperature=673 --set ambient_pressure=101325 "${@:2}" |
      awk -F, '!/^#/ && header++ { print $2 }'
  done
}

chart_figure_3() {
  local figure=docs/figures
  {
    provenance
    echo "# N2 (R = 296.8 J/(kg K), gamma = 1.4), T = 673 K, A = 0.085 m2, Cd = 1, p_a = 101325 Pa (assumed)"
    echo "overpressure_Pa,hole_kg_s,fabric_over_eta2_kg_s,fabric_eta_0.05_kg_s"
    paste -d, <(seq 0 20 980 && seq 1000 1000 100000) <(of_flow orifice_flow --set area=0.085 --set discharge_coefficient=1) \
      <(of_flow porous_flow --set fabric_area=0.085 --set porosity=1) <(of_flow porous_flow --set fabric_area=0.085 --set porosity=0.05)
  } >"$figure/figure_3.csv"
  out=$figure draw figure_3
}

chart_jet_decay() {
  local a folder=results/jet_decay
  mkdir -p "$folder"
  for a in 0.066 0.08; do # R0 = 1/2: distances are in diameters
    "$gasjet" exact round_jet --set radius=0.5 --set spread=$a --set outlet_velocity=1 --times 0:40:0.5 >"$folder/round_$a.csv"
  done
  "$gasjet" exact jet_far_field --times 0.06:0.125:0.001 >"$folder/constants.csv"
  gnuplot -e "data=$(gnuplot_file "$folder"); out=$(gnuplot_file "$out/jet_decay.svg")" docs/charts/gnuplot/jet_decay.gp
}

chart_damaged() {
  scripts/tests/fuzz.sh 450
  { provenance; grep -v '^#' build-fuzz/fuzz.csv; } >"$out/fuzz.csv"
  { provenance; verification/fuzz/damaged_cases.py "$gasjet" . 10000 | tr '\t' ','; } >"$out/damaged_cases.csv"
}

chart_frames() {
  local case
  scripts/setup_debian12.sh python3-vtk9 xvfb xauth libgl1-mesa-dri
  for case in passenger_pendulum{,_no_jet}; do
    "$gasjet" run "cases/$case.toml" --out "results/frames/$case" --quiet --set output.fields_every=5e-3
  done
  xvfb-run -a -s "-screen 0 1600x1200x24" /usr/bin/python3 -B docs/make/figures/render_frames.py docs/figures/frames.jpg \
    "with jet=results/frames/passenger_pendulum" "without jet=results/frames/passenger_pendulum_no_jet" 5 10 20 30 50 90
}

chart_concepts() { GASJET=$gasjet python3 docs/make/figures/draw_concepts.py; }

chart_examples() {
  local page
  export MATPLOTLIBRC=$PWD/docs/examples/examples.mplstyle SOURCE_DATE_EPOCH=0 MPLBACKEND=Agg
  for page in docs/examples/*.md; do
    [[ $page != */README.md ]] || continue
    verification/rules/tutorial_test.py --pictures docs/examples "$gasjet" "$page"
  done
}

chart_forecast() { docs/make/charts/forecast.sh; }
chart_detection() { docs/make/charts/detection.sh "$threads" "$out"; }
chart_ablation() { docs/make/charts/ablation.sh "$out"; }

# ---

names() {
  basename -s .toml cases/studies/*.toml
  declare -F | sed -n 's/^declare -f chart_//p'
}

while [[ ${1:-} == --* ]]; do
  case $1 in
    --list) names; exit ;;
    --threads | --out) declare "${1#--}=${2:?charts.sh: $1 needs a value}" ;;
    *) echo "charts.sh: unknown argument '$1'; allowed: --threads N, --out FOLDER, --list, NAME..." >&2; exit 2 ;;
  esac
  shift 2
done
(($#)) || { echo "charts.sh: no name; --list tells them" >&2; exit 2; }
for name in "$@"; do
  grep -qxF -- "$name" <<<"$(names)" || { echo "charts.sh: no chart '$name'; --list tells them" >&2; exit 2; }
done
[[ -x $gasjet ]] || { echo "charts.sh: $gasjet is missing: scripts/run_main_case.sh builds it" >&2; exit 2; }
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for name in "$@"; do
  if [[ -f cases/studies/$name.toml ]]; then study "$name"; else "chart_$name"; fi
done
