#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Judges a foreign program by the reference set: hands it each scene as JSON, reads its history back as CSV and compares it row by
# row with the reference (docs/compare.md).
# usage: verification/run_external.sh [--tolerance SHARE] [--timeout SECONDS] [--scenes NAME,...] COMMAND [ARGUMENT...]
#   called as COMMAND ARGUMENT... SCENE.json HISTORY.csv; exit code 77: it does not do this scene. The JSON holds `settings` (those of
#   the case file, defaults too, SI units), `times` of the reference and its `columns` that have a band, and files of the mesh if there is one: `mesh` (OBJ) and
#   `mesh_keyword`, the design shape, and `mesh_initial`, the shape at the start.
#   HISTORY.csv: a header row with `time_s` and the columns, then rows.
#   --tolerance SHARE  what the program may be off by itself, of each column's largest magnitude (0 by default)
#   --timeout SECONDS  what it may take for a scene (3600 by default)
# Exit code: 0 inside the bands in all scenes that it does; 1 outside in one; 2 bad arguments, or the program or its file failed; 4 undecided.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
gasjet=${GASJET:-$root/build/gasjet}
reference=$root/cases/reference

fail() {
  echo "run_external.sh: $*" >&2
  exit 2
}

tolerance=0 limit=3600 scenes=
while [[ ${1:-} == -* ]]; do
  case $1 in
    --tolerance | --timeout | --scenes) (($# > 1)) || fail "$1 needs a value" ;;
    *) fail "unknown option $1; allowed before the command: --tolerance, --timeout, --scenes" ;;
  esac
  case $1 in
    --tolerance) tolerance=$2 ;;
    --timeout) limit=$2 ;;
    --scenes) scenes=${2//,/ } ;;
  esac
  shift 2
done
if [[ ! $tolerance =~ ^[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$ ]] || awk -v share="$tolerance" 'BEGIN { exit share + 0 <= 1 }'; then
  fail "--tolerance $tolerance: a share from 0 to 1 is allowed"
fi
[[ $limit =~ ^[1-9][0-9]*$ ]] || fail "--timeout $limit: a whole number of seconds above 0 is allowed"
[[ $scenes =~ ^[a-z_\ ]*$ ]] || fail "--scenes: names of scenes are allowed, such as tank_fill,plate_jet"
(($# > 0)) || fail "needs the command of a program"
command -v "$1" >/dev/null || fail "no program '$1'"
[[ -x $gasjet ]] || fail "no program $gasjet: build it first"
[[ -n $scenes ]] || scenes=$(cd "$reference" && printf '%s\n' *.csv | sed 's/\.csv$//')
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# scene_as_json SCENE: the case's settings, and what the reference asks for, in one object.
scene_as_json() {
  local table=$reference/$1.csv case
  case=$(sed -n 's/^# case: //p' "$table")
  awk -F, -v scene="$1" '/^#/ { next }
    !n++ { for (i = 2; i <= NF; i++) if (sub(/_band$/, "", $i)) columns = columns (columns ? ", " : "") "\"" $i "\""; next }
    { times = times (times ? ", " : "") $1 }
    END { printf "{\n  \"scene\": \"%s\",\n  \"columns\": [%s],\n  \"times\": [%s],\n", scene, columns, times }' "$table"
  cd "$root" || return
  if "$gasjet" mesh case "$case" --out "$work/$1.obj" --initial "$work/$1.initial.obj" >/dev/null 2>&1; then
    "$gasjet" mesh case "$case" --out "$work/$1.k" >/dev/null
    printf '  "mesh": "%s",\n  "mesh_keyword": "%s",\n  "mesh_initial": "%s",\n' "$work/$1."{obj,k,initial.obj}
  fi
  "$gasjet" check "$case" --format json | tail -n +2
}

worst=0 # the worst exit code so far, in the order 0, 4, 1, 2
note() {
  case $1 in 0 | 1 | 4) ;; *) set -- 2 ;; esac # a comparison that died judged nothing
  local rank=(0 2 3 9 1)
  ((rank[$1] > rank[worst])) && worst=$1
  return 0
}

judged=0
for scene in $scenes; do
  [[ -f $reference/$scene.csv ]] || fail "no scene '$scene' in $reference"
  (scene_as_json "$scene") >"$work/$scene.json" || fail "$scene: no JSON"
  timeout "$limit" "$@" "$work/$scene.json" "$work/$scene.csv" </dev/null >"$work/log" 2>&1
  status=$?
  if ((status == 77)); then
    echo "$scene: not done by the program"
    continue
  fi
  judged=$((judged + 1))
  if ((status != 0)); then
    echo "$scene: the program failed with exit code $status: $(tail -1 "$work/log")"
    note 2
    continue
  fi
  "$gasjet" compare "$work/$scene.csv" "$reference/$scene.csv" --tolerance "$tolerance" >"$work/verdict" 2>&1
  note $?
  echo "$scene: $(tail -1 "$work/verdict")"
done
((judged > 0)) || fail "the program does none of the scenes"
exit "$worst"
