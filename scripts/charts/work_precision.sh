#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Work against precision, the charts of docs/charts/README.md that benchmarks measure: CSV with machine, compiler, flags and
# commit, and SVG, in docs/charts. Times are CPU time on one core; some ten minutes in all, on an idle machine.
# usage: scripts/charts/work_precision.sh [CHART...]      gas, tank_test, bag, jet; all of them by default
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

chart_jet() {
  scripts/charts/jet_fidelity.sh >&2
  scripts/charts/jet_cost.sh >&2
}

charts=("$@")
((${#charts[@]})) || charts=(gas tank_test bag jet)
for chart in "${charts[@]}"; do
  [[ $(type -t "chart_$chart") == function ]] || { say "no chart '$chart'; there are gas, tank_test, bag, jet"; exit 2; }
done
scripts/setup_debian12.sh libsundials-dev libembree-dev >&2 # the peers
for chart in "${charts[@]}"; do
  say "$chart ..."
  start=$SECONDS
  "chart_$chart"
  say "$chart done in $((SECONDS - start)) s"
done
