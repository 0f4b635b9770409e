#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What each heuristic of the fast visibility route is worth: builds benchmarks/jet_ablation.cpp of HEAD as it is and once for each name
# in benchmarks/ablation.tsv with that heuristic turned off, demands the same masks of all, and lets them run in turns on one core.
# Writes FOLDER/jet_ablation.csv: for each heuristic and state the time of a query with it and without [us], their ratio, and by
# how much the ratios of the odd and of the even turns differ.
# usage: docs/make/charts/ablation.sh FOLDER [TURNS [SCRATCH]]      12 turns; programs that SCRATCH has are not built again
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source-path=SCRIPTDIR source=common.sh
source docs/make/charts/common.sh
out=${1:?usage: ablation.sh FOLDER [TURNS [SCRATCH]]} turns=${2:-12} scratch=${3:-}
list=$PWD/benchmarks/ablation.tsv commit=$(git rev-parse HEAD) core=$(($(nproc) - 1))
if [[ ! $scratch ]]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
fi
mkdir -p "$scratch"
scratch=$(cd "$scratch" && pwd)
programs=$scratch/programs times=$scratch/times
mapfile -t names < <(awk -F'\t' '!/^#/ && NF && !seen[$1]++ { print $1 }' "$list")

# lines NAME: those of the list
lines() { awk -F'\t' -v name="$1" '$1 == name' "$list"; }

# build NAME: the program of the source as it now is. Warnings stay warnings: a variable may be unused. Files are compiled together as
# in a release, ccache or not.
build() {
  if [[ ! -f $scratch/build/CMakeCache.txt ]]; then
    cmake -S "$scratch/source" -B "$scratch/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DGASJET_WERROR=OFF \
      -DGASJET_BENCHMARKS=ON -DGASJET_TESTS=OFF -DGASJET_BINDINGS=OFF >"$scratch/log"
  fi
  if ! cmake --build "$scratch/build" --target jet_ablation -j "$(nproc)" >"$scratch/log" 2>&1; then
    tail -40 "$scratch/log" >&2
    echo "ablation.sh: does not build: $1" >&2
    return 1
  fi
  cp "$scratch/build/benchmarks/jet_ablation" "$programs/$1"
}

# An archive names its commit, whatever is changed in it: the driver is compiled once.
build_all() {
  local name file expression
  mkdir -p "$programs" "$scratch/source"
  [[ -x "$programs/as it is" ]] || { git archive "$commit" | tar -xm -C "$scratch/source"; build "as it is"; }
  for name in "${names[@]}"; do
    [[ ! -x $programs/$name ]] || continue
    while IFS=$'\t' read -r _ file expression _; do
      sed -i -e "$expression" "$scratch/source/$file"
    done < <(lines "$name")
    build "$name"
    lines "$name" | cut -f2 | sort -u | xargs git archive "$commit" | tar -xm -C "$scratch/source"
  done
}

run() { taskset -c "$core" "$programs/$1"; }

# masks: of a run's rows, all but the time
masks() { awk -F, '!/^#/ { print $1 "," $2 "," $3 "," $4 "," $5 }' "$@"; }

take_turns() {
  local turn name
  rm -rf "$times"
  mkdir -p "$times"
  for ((turn = 0; turn < turns; ++turn)); do
    for name in "as it is" "${names[@]}"; do
      run "$name" >"$times/$turn.$name"
      if ! cmp -s <(masks "$times/0.as it is") <(masks "$times/$turn.$name"); then
        diff <(masks "$times/0.as it is") <(masks "$times/$turn.$name") >&2 || true
        echo "ablation.sh: other masks without: $name" >&2
        return 1
      fi
    done
  done
}

table() {
  local name
  machine "one used"
  grep '^#' "$times/0.as it is"
  echo "# mean over the steps of a state, each the least of $turns turns; without: this heuristic alone turned off, with the same masks"
  echo "heuristic,state,elements,query_us,without_us,ratio,spread"
  for name in "${names[@]}"; do
    awk -F, -v name="$name" '
      FNR == 1 { turn = FILENAME; sub(/.*\//, "", turn); without = turn !~ /^[0-9]+[.]as it is$/; turn += 0 }
      /^#/ || /^state,/ { next }
      {
        key = $1 "," $2
        if (!(key in steps)) order[++n] = key
        steps[key] = split($6, time, " ")
        for (i = 0; i < 2; ++i) {
          part = i ? 2 : turn % 2
          for (k in time)
            if (!((key, without, part, k) in least) || time[k] + 0 < least[key, without, part, k]) least[key, without, part, k] = time[k] + 0
        }
      }
      function mean(key, without, part,   k, sum) {
        for (k = 1; k <= steps[key]; ++k) sum += least[key, without, part, k]
        return sum / steps[key]
      }
      function ratio(key, part) { return mean(key, 1, part) / mean(key, 0, part) }
      END {
        for (i = 1; i <= n; ++i) {
          spread = turn ? ratio(order[i], 0) - ratio(order[i], 1) : 0
          printf "%s,%s,%.3f,%.3f,%.3f,%.3f\n", name, order[i], mean(order[i], 0, 2), mean(order[i], 1, 2), ratio(order[i], 2),
            spread < 0 ? -spread : spread
        }
      }' "$times/"*".as it is" "$times/"*".$name"
  done
}

build_all
take_turns
table >"$scratch/table"
cp "$scratch/table" "$out/jet_ablation.csv"
echo "$out/jet_ablation.csv"
