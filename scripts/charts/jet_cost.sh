#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What the jet costs on the paper's scene, one thread. First whole runs without jet, without occlusion, and with exact
# occlusion by two routes, side by side in one process (jet_cost.csv). Then single stages from 700 to a million elements,
# folded and inflated, each visibility route and Embree side by side in one process (jet_overhead.csv and .svg). The CSV
# files say machine, compiler, flags and commit.
# usage: scripts/charts/jet_cost.sh [FOLDER]      (docs/charts by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
# shellcheck source-path=SCRIPTDIR source=gnuplot_text.sh
source scripts/charts/gnuplot_text.sh
folder=${1:-docs/charts}
csv=$folder/jet_cost.csv
log=$(mktemp)
trap 'rm -f "$log" "$log.csv"' EXIT

scripts/setup_debian12.sh libembree-dev # the peer to beat
cmake --preset release >/dev/null
cmake --build --preset release --target step_benchmark jet_overhead -j "$(nproc)" >/dev/null
build/benchmarks/step_benchmark --benchmark_format=csv --benchmark_repetitions=16 \
  --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true 2>"$log" >"$log.csv"

mkdir -p "$folder"
{
  machine "one thread used"
  grep -E '^(version|commit|compiler|flags|date): ' "$log" | sed 's/^/# /'
  echo "# least of 16 interleaved repetitions of whole runs of 100 ms: what other programs on the machine add is left out"
  echo "case,us_per_step,ns_per_element,jet_us_per_step,jet_over_step,step_over_no_jet,steps,drift_rel,hidden_per_step,exact_calls,jet_us_while_blowing"
  awk -F, '
    /^name,/ { for (i = 1; i <= NF; ++i) { gsub(/"/, "", $i); column[$i] = i } next }
    /_least"/ {
      name = $1; gsub(/"|\/.*|_least/, "", name)
      if (name == "no_jet") base = $column["us_per_step"]
      order[++n] = name; row[name] = $0
    }
    END {
      for (k = 1; k <= n; ++k) {
        split(row[order[k]], f, ",")
        jet = f[column["jet_us_per_step"]]
        printf "%s,%.2f,%.2f,%.2f,%.3f,%.3f,%d,%.2e,%.1f,%d,%.2f\n", order[k], f[column["us_per_step"]], f[column["ns_per_element"]],
          jet, jet / base, f[column["us_per_step"]] / base, f[column["steps"]], f[column["drift_rel"]], f[column["hidden_per_step"]], f[column["exact_calls"]], f[column["jet_us_while_blowing"]]
      }
    }' "$log.csv"
} >"$csv"
cat "$csv"

{
  machine "one thread used"
  build/benchmarks/jet_overhead
} >"$log.csv"
cp "$log.csv" "$folder/jet_overhead.csv"
cat "$folder/jet_overhead.csv"
gnuplot -e "data=$(gnuplot_file "$folder/jet_overhead.csv"); out=$(gnuplot_file "$folder/jet_overhead.svg")" scripts/charts/jet_overhead.gp
