#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Decks of `gasjet export` in the real program: OpenRadioss runs scenes, in its own format and as LS-DYNA decks by its reader of those,
# and `gasjet compare` judges its time histories. OpenRadioss is built outside this repository, and nothing of it enters here.
# usage: run.sh [--scenes NAME,...] [--formats radioss,lsdyna] [--out FOLDER] STARTER ENGINE
#   The scenes are those of scenes.csv beside this script: each has a limit for the columns that are wanted at its end.
#   Prints a table as Markdown. --out keeps decks, listings and histories, and writes table.md and table.csv with what made them.
# environment: GASJET, the program `gasjet` (by default build/gasjet of this tree); what OpenRadioss itself needs, such as
#   LD_LIBRARY_PATH and RAD_CFG_PATH; OPENRADIOSS, what the table calls the program (a commit, say); TIMEOUT [s] of a run (3600)
# Exit code: 0 all within their limits; 1 one is not, or a run has no normal end; 2 bad arguments; 77 no OpenRadioss.
set -uo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$(cd "$here/../.." && pwd)
gasjet=${GASJET:-$root/build/gasjet} scenes='' formats=radioss,lsdyna out='' bad=0

fail() {
  echo "run.sh: $*" >&2
  exit 2
}

while [[ ${1:-} == -* ]]; do
  (($# > 1)) || fail "$1 needs a value"
  case $1 in
    --scenes) scenes=,$2, ;;
    --formats) formats=$2 ;;
    --out) out=$2 ;;
    *) fail "unknown option $1; allowed are --scenes, --formats, --out" ;;
  esac
  shift 2
done
programs=()
for what in starter engine; do
  program=$(command -v "${1:-}" 2>/dev/null) || {
    echo "run.sh: no OpenRadioss $what '${1:-}': name starter and engine as arguments" >&2
    exit 77
  }
  programs+=("$(readlink -f "$program")")
  shift
done
[[ -x $gasjet ]] || fail "no program $gasjet: build it first, or name it by the variable GASJET"
gasjet=$(readlink -f "$gasjet")
if [[ -z $out ]]; then
  out=$(mktemp -d)
  trap 'rm -rf "$out"' EXIT
fi
mkdir -p "$out" || fail "no folder $out"
out=$(cd "$out" && pwd)
ulimit -s unlimited 2>/dev/null # both programs have arrays on the stack
export OMP_NUM_THREADS=1 OMP_STACKSIZE=${OMP_STACKSIZE:-400m}

# radioss_run FOLDER: from a Radioss deck, or an LS-DYNA deck that a starter file includes, to histories.csv
# The reader of LS-DYNA decks asks for no history of *AIRBAG_HYBRID, so that the file that includes the deck does.
radioss_run() (
  cd "$1" || exit 1
  sed -i 's#^/RUN/bag/1#/RUN/run/1#; /^\/ANIM/,+1d' run_0001.rad # no pictures
  if [[ -f bag.k ]]; then
    {
      printf '#RADIOSS STARTER\n/BEGIN\nrun\n      2022         0\n'
      for _ in 1 2; do printf '%20s%20s%20s\n' Mg mm s; done
      printf '/INCLUDE_LS-DYNA/\nbag.k\n/TH/MONV/1\nhistory\nDEF       \n         1\n/END\n'
    } >run_0000.rad
  else
    mv bag_0000.rad run_0000.rad
  fi
  timeout "${TIMEOUT:-3600}" "${programs[0]}" -i run_0000.rad -np 1 >starter.txt 2>&1
  grep -qE '^ *0 +ERROR\(S\)' run_0000.out || exit 1
  timeout "${TIMEOUT:-3600}" "${programs[1]}" -i run_0001.rad -nt 1 >engine.txt 2>&1
  grep -aq 'NORMAL TERMINATION' engine.txt || exit 1
  python3 -B "$here/time_history.py" runT01 >histories.csv
)

while IFS=';' read -r name case settings limits; do
  [[ $name != '#'* && (-z $scenes || $scenes == *,$name,*) ]] || continue
  options=()
  for setting in $settings; do
    if [[ $setting == -* ]]; then options+=(--unset "${setting#-}"); else options+=(--set "$setting"); fi
  done
  "$gasjet" run "$root/$case" "${options[@]}" --quiet --out "$out/$name" >"$out/$name.txt" 2>&1 || fail "$name: $(tail -1 "$out/$name.txt")"
  for format in ${formats//,/ }; do
    folder=$out/$name.$format
    rm -rf "$folder"
    # The engine file of a Radioss deck serves both.
    "$gasjet" export "$root/$case" "${options[@]}" --format radioss --units t-mm-s --out "$folder" >/dev/null || exit 2
    mv "$folder/bag_0001.rad" "$folder/run_0001.rad" # the next export takes away what it did not write
    if [[ $format == lsdyna ]]; then
      "$gasjet" export "$root/$case" "${options[@]}" --format lsdyna --units t-mm-s --out "$folder" >/dev/null || exit 2
    fi
    if radioss_run "$folder"; then
      "$gasjet" compare "$folder/histories.csv" "$out/$name/history.csv" --map "$root/cases/maps/openradioss_t_mm_s.toml" \
        --rows "$folder/rows.csv" --format json >"$folder/compare.json"
    fi
    python3 -B "$here/table.py" row "$name" "$format" "$folder" "$limits" >>"$out/rows.$$" || bad=1
  done
done <"$here/scenes.csv"
[[ -s $out/rows.$$ ]] || fail "no scene of this name; scenes.csv has $(grep -v '^#' "$here/scenes.csv" | cut -d';' -f1 | tr '\n' ' ')"
mv "$out/rows.$$" "$out/rows.csv"
python3 -B "$here/table.py" whole "$out/rows.csv" "$("$gasjet" --version | tail -1)" "${OPENRADIOSS:-OpenRadioss}" "$out"
cat "$out/table.md"
exit $bad
