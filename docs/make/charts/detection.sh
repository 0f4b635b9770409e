#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Which errors the passenger references catch, and from how many runs on: puts each error of docs/make/charts/detection_changes.tsv into the
# program's case (or source), makes 1, 2, 4, 8 and 16 runs with seeds of their own, and judges them by `gasjet compare`. Four such
# tries of 1 to 4 runs, three of 8 and two of 16; caught are errors that all tries find outside.
# Writes docs/charts/detection.csv: error, reference, number of runs from which on it is caught (none: not by 16), and of those runs
# the column that is farthest outside, in units of what band and chance allow.
# usage: docs/make/charts/detection.sh [THREADS] [OUT]      (1, docs/charts by default; GASJET names the program)
#   Runs are kept in results/detection, and not made again.
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source-path=SCRIPTDIR source=common.sh
source docs/make/charts/common.sh
threads=${1:-1} out=${2:-docs/charts}
gasjet=${GASJET:-build/gasjet}
[[ ! -d $gasjet ]] || gasjet+=/build/gasjet # a clone, as the tutorials set it
work=results/detection
references=(passenger_jet passenger_sharp_jet)
sizes=(1 2 4 8 16)
declare -A tries=([1]=4 [2]=4 [4]=4 [8]=3 [16]=2)
mkdir -p "$work" "$out"

# whole FOLDER: its run has come to its end
whole() { grep -qsE '^status: (done|inaccurate)' "$1/gasjet.status"; }

# history PROGRAM CASE FOLDER RUNS SEED OPTION...: prints the file of this run, or of the mean of runs from this seed on
history() {
  local program=$1 case=$2 folder=$3 runs=$4 seed=$5 file status=0
  shift 5
  if ((runs == 1)); then
    file=$folder/$seed/history.csv
    whole "${file%/*}" || "$program" run "$case" --quiet --out "$folder/$seed" --threads "$threads" --set output.frames=0 \
      --set membrane.perturbation=1e-4 --set "membrane.perturbation_seed=$seed" "$@" >&2 || status=$?
  else
    file=$folder/$runs.$seed/$(basename "$case" .toml)/ensemble.csv
    whole "${file%/*}" || "$program" ensemble "$case" --quiet --out "$folder/$runs.$seed" --threads "$threads" --set output.frames=0 \
      --runs "$runs" --first-seed "$seed" "$@" >&2 || status=$?
  fi
  ((status == 0 || status == 3)) || exit "$status" # 3: a run is inaccurate
  echo "$file"
}

# judge HISTORY REFERENCE: prints the column that is farthest outside and its share; exit code 0 if there is one. Left out are
# the joint's force, which would tell the mass by which the contact force is scaled, and numbers of elements, which are not of physics.
judge() {
  local code=0
  "$gasjet" compare "$1" "$2" --format json >"$work/verdict.json" || code=$?
  ((code == 0 || code == 1 || code == 4)) || exit "$code"
  awk '/^    "[a-z0-9_A-Z]+": \{$/ { name = $1; gsub(/[":]/, "", name) }
    $1 == "\"verdict\":" && name { outside = $2 ~ /outside/ && name !~ /_elements$|joint_force/ }
    $1 == "\"share_of_band\":" && outside { share = $2 == "null," ? 1e9 : $2 + 0; if (share > most) { most = share; column = name } }
    END { if (column) printf "%s,%.2g\n", column, most; exit !column }' "$work/verdict.json"
}

# caught PROGRAM NAME REFERENCE RUNS OPTION...: whether all tries of so many runs find it; prints what the last of them says
caught() {
  local program=$1 name=$2 reference=cases/reference/$3.csv runs=$4 case try file
  case=$(sed -n 's/^# case: //p' "$reference")
  shift 4
  for ((try = 0; try < tries[$runs]; try++)); do
    file=$(history "$program" "$case" "$work/$name" "$runs" $((10000 + 100 * runs + try * runs)) "$@")
    judge "$file" "$reference" >"$work/column" || return 1
  done
}

# detect PROGRAM FOLDER REFERENCE OPTION...: prints runs, column, share
detect() {
  local program=$1 folder=$2 reference=$3 runs
  shift 3
  for runs in "${sizes[@]}"; do
    if caught "$program" "$folder.$reference" "$reference" "$runs" "$@"; then
      echo "$runs,$(cat "$work/column")"
      return
    fi
  done
  echo "none,—,"
}

# changed_program FOLDER FILE SED: a program with this change of the source, built in $work/source.FOLDER
changed_program() {
  local tree=$PWD/$work/source.$1
  if [[ ! -x $tree/build/gasjet ]]; then
    mkdir -p "$tree"
    git ls-files -z | xargs -0 cp --parents -t "$tree"
    sed -i "$3" "$tree/$2"
    ! cmp -s "$2" "$tree/$2" || { echo "detection.sh: the change of $2 does nothing" >&2; return 1; }
    (cd "$tree" && export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 && cmake --preset release -DCMAKE_UNITY_BUILD=ON &&
      cmake --build build --target gasjet -j "$threads") >"$tree.log" 2>&1 || { tail "$tree.log" >&2; return 1; }
  fi
  echo "$tree/build/gasjet"
}

# worse ROW ROW: the one with more runs, of two signs of one error
worse() {
  local a=${1%%,*} b=${2%%,*}
  if [[ $a == none || ($b != none && $a -ge $b) ]]; then echo "$1"; else echo "$2"; fi
}

declare -A row=()
errors=() number=0
while IFS=$'\t' read -r error kind first second; do
  [[ $error != \#* ]] || continue
  number=$((number + 1))
  folder=$(tr -c 'a-zA-Z0-9\n' _ <<<"$error")$number
  program=$gasjet options=()
  [[ " ${errors[*]/%/;} " == *" $error; "* ]] || errors+=("$error")
  case $kind in
    none) ;;
    case) read -ra options <<<"$first" ;;
    source) program=$(changed_program "$folder" "$first" "$second") ;;
    *) echo "detection.sh: unknown kind '$kind' of '$error'" >&2; exit 2 ;;
  esac
  for reference in "${references[@]}"; do
    if [[ $kind == none ]]; then this=not\ made,—,; else this=$(detect "$program" "$folder" "$reference" "${options[@]}"); fi
    [[ -z ${row[$error,$reference]:-} ]] || this=$(worse "${row[$error,$reference]}" "$this")
    row[$error,$reference]=$this
    echo "$error, $reference: $this"
  done
done <docs/make/charts/detection_changes.tsv

{
  provenance
  echo "error,reference,caught_from_runs,column,share_of_chance"
  for error in "${errors[@]}"; do
    for reference in "${references[@]}"; do echo "$error,$reference,${row[$error,$reference]}"; done
  done
} >"$out/detection.csv"
echo "$out/detection.csv"
