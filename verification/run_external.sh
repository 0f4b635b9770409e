#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Judges a foreign program by the reference set: hands it each scene as JSON, reads its history back as CSV and compares all columns,
# row by row, with the reference (docs/compare.md).
# usage: run_external.sh [--tolerance SHARE] [--tolerances FILE] [--timeout SECONDS] [--scenes NAME,...] [--out FOLDER] COMMAND [ARGUMENT...]
#   called as COMMAND ARGUMENT... SCENE.json HISTORY.csv; exit code 77: it does not do this scene. SCENE.json follows
#   schemas/scene.schema.json: `settings` (those of the case file, defaults too, SI units), `times` of the reference and its `columns` that
#   have a band, and files of the mesh if there is one: `mesh` (OBJ) and `mesh_keyword`, the design shape, and `mesh_initial`, the shape at the start.
#   HISTORY.csv: a header row with `time_s` and the columns, then rows.
#   --tolerance SHARE  what the program may be off by itself, of each column's largest magnitude (0 by default)
#   --tolerances FILE  the same of single columns: CSV with the header scene,column,tolerance; * stands for all; the last row that fits counts
#   --timeout SECONDS  what it may take for a scene (3600 by default)
#   --out FOLDER       keeps what was handed over and read back, both histories in one table (SCENE.rows.csv), the verdicts (SCENE.txt), and
#                      writes report.json (schemas/report.schema.json) and junit.xml
# environment: GASJET, the program `gasjet` that compares, or a tree with build/gasjet (by default that of this tree or installation,
#   else the one in PATH)
# Exit code: 0 inside the bands in all scenes that it does; 1 outside in one; 2 bad arguments, or the program or its file failed; 4 undecided.
set -uo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$here # installed, beside the cases; in the source tree one folder below
[[ -d $root/cases/reference ]] || root=$(dirname "$here")
reference=$root/cases/reference

fail() {
  echo "run_external.sh: $*" >&2
  exit 2
}

# is_share TEXT: a number from 0 to 1, or of per cent
is_share() {
  [[ $1 =~ ^[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?%?$ ]] && ! awk -v share="$1" 'BEGIN { exit share + 0 <= (share ~ /%$/ ? 100 : 1) }'
}

tolerance=0 tolerances='' limit=3600 scenes='' out=''
while [[ ${1:-} == -* ]]; do
  case $1 in
    --help)
      sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --tolerance | --tolerances | --timeout | --scenes | --out) (($# > 1)) || fail "$1 needs a value" ;;
    *) fail "unknown option $1; allowed before the command: --tolerance, --tolerances, --timeout, --scenes, --out" ;;
  esac
  case $1 in
    --tolerance) tolerance=$2 ;;
    --tolerances) tolerances=$2 ;;
    --timeout) limit=$2 ;;
    --scenes) scenes=${2//,/ } ;;
    --out) out=$2 ;;
  esac
  shift 2
done
is_share "$tolerance" || fail "--tolerance $tolerance: a share from 0 to 1, such as 0.02 or 2%, is allowed"
[[ $limit =~ ^[1-9][0-9]*$ ]] || fail "--timeout $limit: a whole number of seconds above 0 is allowed"
[[ $scenes =~ ^[a-z_\ ]*$ ]] || fail "--scenes: names of scenes are allowed, such as tank_fill,plate_jet"
(($# > 0)) || fail "needs the command of a program"
command -v "$1" >/dev/null || fail "no program '$1'"
gasjet=${GASJET:-}
if [[ -z $gasjet || -d $gasjet ]]; then
  for place in "$(command -v gasjet)" "$root/../../bin/gasjet" "$root/build/gasjet" "$gasjet/build/gasjet"; do
    [[ ! -f $place || ! -x $place ]] || gasjet=$place
  done
fi
[[ -f $gasjet && -x $gasjet ]] || fail "no program ${gasjet:-gasjet}: build it first, or name it by the variable GASJET"
[[ -n $scenes ]] || scenes=$(cd "$reference" && printf '%s\n' *.csv | sed 's/\.csv$//')
for scene in $scenes; do [[ -f $reference/$scene.csv ]] || fail "no scene '$scene' in $reference"; done
if [[ -n $out ]]; then
  mkdir -p "$out" 2>/dev/null && [[ -w $out ]] || fail "--out $out: the folder is not writable"
  work=$(cd "$out" && pwd)
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi

# columns_of FILE...: a line `scene column` for each column that has a band
columns_of() {
  awk -F, '/^#/ { next }
    { sub(/\r$/, ""); scene = FILENAME; gsub(/^.*\/|[.]csv$/, "", scene)
      for (i = 1; i <= NF; i++) if (sub(/_band$/, "", $i)) print scene, $i
      nextfile }' "$@"
}

# read_tolerances: the rows of --tolerances as lines `scene column share`, or what is wrong with the file
read_tolerances() {
  [[ -f $tolerances && -r $tolerances ]] || fail "--tolerances $tolerances: no such file"
  local known
  known=$(columns_of "$reference"/*.csv)
  awk -F, -v file="$tolerances" '
    function refuse(place, what) { rows = sprintf("%s:%d:%d: %s\n", file, line, place, what); bad = 1; exit }
    NR == FNR { split($0, part, " "); scene[part[1]]; column[part[2]]; pair[part[1], part[2]]; next }
    { line = FNR; sub(/\r$/, ""); gsub(/[ \t]*,[ \t]*/, ","); sub(/^[ \t]+/, ""); sub(/[ \t]+$/, "") }
    /^#/ || /^$/ { next }
    !header { header = 1; if ($0 != "scene,column,tolerance") refuse(1, "the header scene,column,tolerance is needed"); next }
    NF != 3 { refuse(1, "has " NF " fields, three are needed") }
    $1 != "*" && !($1 in scene) { refuse(1, "scene: no scene \047" $1 "\047, those of the reference set and * are allowed") }
    $2 != "*" && ($1 == "*" ? !($2 in column) : !(($1, $2) in pair)) {
      refuse(length($1) + 2, "column: no column \047" $2 "\047 of " ($1 == "*" ? "any scene" : $1) ", those with a band and * are allowed") }
    $3 !~ /^[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?%?$/ || $3 + 0 > ($3 ~ /%$/ ? 100 : 1) {
      refuse(length($1) + length($2) + 3, "tolerance: \047" $3 "\047, a share from 0 to 1, such as 0.02 or 2%, is allowed") }
    { rows = rows $1 " " $2 " " $3 "\n" }
    END { if (!bad && !header) { rows = file ":1:1: is empty, the header scene,column,tolerance is needed"; bad = 1 }; printf "%s", rows; exit bad }' <(echo "$known") "$tolerances"
}
rows=''
if [[ -n $tolerances ]]; then rows=$(read_tolerances) || fail "$rows"; fi

# tolerance_options SCENE: those of `gasjet compare`, one a line
tolerance_options() {
  printf '%s\n' --tolerance "$tolerance"
  [[ -n $rows ]] || return 0
  columns_of "$reference/$1.csv" | awk -v rows="$rows" '
    BEGIN { n = split(rows, row, "\n") }
    { share = ""; for (i = 1; i <= n; i++) { split(row[i], part, " ")
        if ((part[1] == $1 || part[1] == "*") && (part[2] == $2 || part[2] == "*")) share = part[3] }
      if (share != "") printf "--tolerance\n%s=%s\n", $2, share }'
}

# scene_as_json SCENE: the case's settings, and what the reference asks for, in one object.
scene_as_json() {
  local table=$reference/$1.csv case word displaced=()
  case=$(sed -n 's/^# case: //p' "$table")
  awk -F, -v scene="$1" '/^#/ { next }
    !n++ { for (i = 2; i <= NF; i++) if (sub(/_band$/, "", $i)) columns = columns (columns ? ", " : "") "\"" $i "\""; next }
    { times = times (times ? ", " : "") $1 }
    END { printf "{\n  \"scene\": \"%s\",\n  \"columns\": [%s],\n  \"times\": [%s],\n", scene, columns, times }' "$table"
  cd "$root" || return
  for word in $(sed -n 's/^# initial shape: //p' "$table"); do displaced+=(--set "$word"); done
  if "$gasjet" mesh case "$case" --out "$work/$1.obj" --initial "$work/$1.initial.obj" "${displaced[@]}" >/dev/null 2>&1; then
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

# shellcheck source=run_external_report.sh
source "$here/run_external_report.sh"

# compare_scene SCENE: into SCENE.verdict.json, SCENE.txt and SCENE.rows.csv
compare_scene() {
  local options
  mapfile -t options < <(tolerance_options "$1")
  rm -f "$work/$1".{verdict.json,txt,rows.csv} # of an earlier judgement
  "$gasjet" compare "$work/$1.csv" "$reference/$1.csv" "${options[@]}" --format json --rows "$work/$1.rows.csv" >"$work/$1.verdict.json" 2>/dev/null
  "$gasjet" compare "$work/$1.csv" "$reference/$1.csv" "${options[@]}" >"$work/$1.txt" 2>&1
}

judged=0
for scene in $scenes; do
  (scene_as_json "$scene") >"$work/$scene.json" || fail "$scene: no JSON"
  rm -f "$work/$scene.csv" # of an earlier run
  start=$EPOCHREALTIME
  { timeout "$limit" "$@" "$work/$scene.json" "$work/$scene.csv" </dev/null >"$work/$scene.log" 2>&1; } 2>/dev/null
  status=$?
  seconds=$(awk -v from="$start" -v to="$EPOCHREALTIME" 'BEGIN { printf "%.3f", to - from }')
  if ((status == 77)); then
    echo "$scene: not done by the program"
    report_scene "$scene" "$seconds" "not done" ""
    continue
  fi
  judged=$((judged + 1))
  reason=''
  if ((status == 124)); then
    reason="the program took longer than $limit s"
  elif ((status != 0)); then
    reason="the program failed with exit code $status: $(tail -1 "$work/$scene.log")"
  elif [[ ! -e $work/$scene.csv ]]; then
    reason="the program wrote no history: $(tail -1 "$work/$scene.log")"
  fi
  if [[ -n $reason ]]; then
    [[ -n $out ]] || reason+=' (--out keeps what it was given and what it said)'
    echo "$scene: $reason"
    report_scene "$scene" "$seconds" failed "$reason"
    note 2
    continue
  fi
  compare_scene "$scene"
  note $?
  echo "$scene: $(tail -1 "$work/$scene.txt")"
  columns_not_inside "$scene"
  report_scene "$scene" "$seconds" judged "$(tail -1 "$work/$scene.txt")"
done
[[ -z $out ]] || write_reports "$*"
((judged > 0)) || fail "the program does none of the scenes"
exit "$worst"
