#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Work against precision, all charts of docs/charts/README.md: CSV with machine, compiler, flags and commit, and SVG, in
# docs/charts. Times are CPU time on one core; some ten minutes in all, on an idle machine.
# usage: scripts/charts/work_precision.sh [CHART...]      gas, tank_test, bag, jet, coupled; all of them by default
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
folder=docs/charts

say() { echo "work_precision: $*" >&2; }

build() {
  cmake --preset release >/dev/null
  cmake --build --preset release --target "$@" -j "$(nproc)" >/dev/null
}

header() {
  machine "one used"
  build_version
  printf '# %s\n' "$@"
}

# measure PROGRAM REPETITIONS SECONDS COLUMNS [FILTER]: rows of a google-benchmark program, one a benchmark: the parts of its
# name, its least CPU time [us] over the repetitions of SECONDS each, and the counters COLUMNS; failed ones are left out.
measure() {
  "build/benchmarks/$1" --benchmark_format=csv --benchmark_repetitions="$2" --benchmark_min_time="$3" \
    --benchmark_filter="${5:-.}" 2>/dev/null |
    awk -F, -v wanted="$4" '
      { gsub(/"/, "") }
      /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; n = split(wanted, counter, ","); next }
      !column["name"] || $column["error_occurred"] == "true" || $1 ~ /_(mean|median|stddev|cv)$/ { next }
      {
        name = $1
        sub(/\/(iterations|repeats|min_time):.*/, "", name)
        gsub("/", ",", name)
        if (!(name in least)) order[++rows] = name
        if (!(name in least) || $column["cpu_time"] < least[name]) {
          least[name] = $column["cpu_time"]
          values[name] = ""
          for (i = 1; i <= n; ++i) values[name] = values[name] sprintf(",%.4g", $column[counter[i]])
        }
      }
      END { for (i = 1; i <= rows; ++i) printf "%s,%.4g%s\n", order[i], least[order[i]] / 1e3, values[order[i]] }'
}

draw() { gnuplot -e "data='$folder/$1.csv'; out='$folder/$1.svg'" "scripts/charts/$1.gp"; }

chart_gas() {
  build gas_tank_benchmark gasjet
  {
    header "CPU time: least mean of 5 times 20 ms; error: largest relative one of p and T (tiny volume: of p - p_a and T)"
    echo "problem,solver,tolerance,cpu_us,error,evaluations,substeps"
    measure gas_tank_benchmark 5 0.02 error,evaluations,substeps
  } >"$folder/gas_work_precision.csv"
  draw gas_work_precision
}

chart_tank_test() {
  build tank_test_benchmark gasjet
  {
    header "8 records; CPU time of one analysis, mean; error: r.m.s. over the points that are not masked, of the mass flow over its mean" \
      "(average: of the product mdot T_s) and of the temperature (average: of the mean)"
    echo "method,noise,readings,cpu_us,flow_error,temperature_error"
    measure tank_test_benchmark 1 0 flow_error,temperature_error
  } >"$folder/tank_test_work_precision.csv"
  draw tank_test_work_precision
}

chart_bag() {
  build bag_benchmark gasjet
  {
    header "two periods; CPU time: least of 5; error of the frequency against the closed form"
    echo "scene,mesh,share_of_critical_step,cpu_us,error,elements,steps"
    measure bag_benchmark 5 0 error,elements,steps
  } >"$folder/bag_work_precision.csv"
  draw bag_work_precision
}

cells="--set membrane.mesh.depth_cells=14 --set membrane.mesh.width_cells=6 --set membrane.mesh.height_cells=11"
panels="--set membrane.mesh.attachment_width_cells=4 --set membrane.mesh.attachment_height_cells=3"
panels+=" --set membrane.mesh.vent_depth_cell=4 --set membrane.mesh.vent_height_cell=5"

# Ensembles of the paper's scene, 16 runs each: varied | value | options. The last of each group is what the others are held
# against, for `gas` that of `step`. On meshes other than the scene's own contact is as stiff per area as on that.
ensembles() {
  local stiffness # [N/m3]
  stiffness="--set contact={stiffness=$(build/gasjet check cases/passenger_pendulum.toml |
    sed -n 's/^contact stiffness: \([^ ]*\).*/\1/p')}"
  cat <<TABLE
step|0.9|--set time.safety=0.9
step|0.8|
step|0.4|--set time.safety=0.4
step|0.2|--set time.safety=0.2
gas|dormand_prince 1e-2|--set time.gas_tolerance=1e-2
gas|dormand_prince 1e-6|--set time.gas_tolerance=1e-6
gas|dormand_prince 1e-10|
gas|rosenbrock 1e-6|--set time.gas_method=rosenbrock --set time.gas_tolerance=1e-6
gas|euler 1e-4|--set time.gas_method=euler --set time.gas_tolerance=1e-4
mesh|1216|$cells $panels $stiffness
mesh|2744|
mesh|10970|--set membrane.mesh.refine=1 $stiffness
TABLE
}

# ensemble_rows FOLDER VARIED VALUE OPTION...: rows varied, value, quantity, CPU time [s] a run, mean, standard error, runs.
ensemble_rows() {
  local folder=$1 varied=$2 value=$3 runs=16 seconds TIMEFORMAT=%U
  shift 3
  seconds=$({ time build/gasjet ensemble cases/passenger_pendulum.toml --runs "$runs" --threads "$(nproc)" --quiet --out "$folder" \
    "$@" >"$folder.log" 2>&1; } 2>&1) || { cat "$folder.log" >&2; return 1; }
  awk -F, -v head="$varied,$value" -v cpu="$seconds" -v runs="$runs" \
    '$1 == "final_angle_rad" || $1 == "path_impulse_Ns" || $1 == "peak_cg_acceleration_cfc180_m_s2" {
      printf "%s,%s,%.4g,%s,%s,%s\n", head, $1, cpu / runs, $2, $3, $6 }' "$folder"/passenger_pendulum/quantities.csv
}

chart_coupled() {
  build gasjet
  local scratch varied value options i=0
  scratch=$(mktemp -d)
  ensembles >"$scratch/ensembles"
  while IFS='|' read -r varied value options; do
    say "coupled: $varied $value"
    # shellcheck disable=SC2086  # options are words
    ensemble_rows "$scratch/$((++i))" "$varied" "$value" $options >>"$scratch/rows" </dev/null
  done <"$scratch/ensembles"
  {
    header "cases/passenger_pendulum.toml; error: of the mean, against the last of the group (gas: of step), with its standard error"
    echo "varied,value,quantity,cpu_s,mean,standard_error,runs,error,error_standard_error"
    awk -F, -v OFS=, 'NR == FNR { mean[$1, $3] = $5; error[$1, $3] = $6; next }
      { group = $1 == "gas" ? "step" : $1; m = mean[group, $3]; e = error[group, $3]; d = $5 / m - 1
        print $0, sprintf("%.3g", d < 0 ? -d : d), sprintf("%.3g", sqrt($6 ^ 2 + e ^ 2) / m) }' "$scratch/rows" "$scratch/rows"
  } >"$folder/coupled_work_precision.csv"
  rm -r "$scratch"
  draw coupled_work_precision
}

chart_jet() {
  scripts/charts/jet_fidelity.sh >&2
  scripts/charts/jet_cost.sh >&2
}

charts=("$@")
((${#charts[@]})) || charts=(gas tank_test bag jet coupled)
for chart in "${charts[@]}"; do
  [[ $(type -t "chart_$chart") == function ]] || { say "no chart '$chart'; there are gas, tank_test, bag, jet, coupled"; exit 2; }
done
scripts/setup_debian12.sh libsundials-dev libembree-dev >&2 # the peers
for chart in "${charts[@]}"; do
  say "$chart ..."
  start=$SECONDS
  "chart_$chart"
  say "$chart done in $((SECONDS - start)) s"
done
