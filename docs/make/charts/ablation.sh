#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What each heuristic of the fast visibility route is worth: builds benchmarks/jet_ablation.cpp of HEAD as it is and once for each name
# in benchmarks/ablation.tsv with that heuristic turned off, demands the same masks of all, and lets them run in turns on one core.
# Writes FOLDER/jet_ablation.csv: for each heuristic and state the time of a query with it and without [us], medians over the turns, the
# median of their ratios in a turn, and half of what the quartiles of these differ by.
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
  echo "# medians of $turns turns; without: this heuristic alone turned off, with the same masks; ratio: of the two programs of a turn; spread: half of what its quartiles differ by"
  echo "heuristic,state,elements,query_us,without_us,ratio,spread"
  for name in "${names[@]}"; do
    awk -F, -v name="$name" -v turns="$turns" '
      FNR == 1 { turn = FILENAME; sub(/.*\//, "", turn); without = turn !~ /^[0-9]+[.]as it is$/; turn += 0 }
      /^#/ || /^state,/ { next }
      {
        key = $1 "," $2
        if (!without && turn == 0) order[++n] = key
        steps = split($6, time, " ")
        sum = 0
        for (k = 1; k <= steps; ++k) sum += time[k]
        mean[key, without, turn] = sum / steps
      }
      # quantile(OF, SHARE): of that value over the turns
      function quantile(of, key, share,   i, j, x, sorted) {
        for (i = 0; i < turns; ++i) {
          x = of == "ratio" ? mean[key, 1, i] / mean[key, 0, i] : mean[key, of, i]
          for (j = i; j > 0 && sorted[j - 1] > x; --j) sorted[j] = sorted[j - 1]
          sorted[j] = x
        }
        return sorted[int(share * (turns - 1) + 0.5)]
      }
      END {
        for (i = 1; i <= n; ++i) {
          key = order[i]
          printf "%s,%s,%.3f,%.3f,%.3f,%.3f\n", name, key, quantile(0, key, 0.5), quantile(1, key, 0.5), quantile("ratio", key, 0.5),
            (quantile("ratio", key, 0.75) - quantile("ratio", key, 0.25)) / 2
        }
      }' "$times/"*".as it is" "$times/"*".$name"
  done
}

build_all
take_turns
table >"$scratch/table"
cp "$scratch/table" "$out/jet_ablation.csv"
echo "$out/jet_ablation.csv"
