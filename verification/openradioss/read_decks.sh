#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Decks of `gasjet export` in the real program: OpenRadioss' starter reads each case with a bag or a sheet, in its own format and as an LS-DYNA
# deck by its reader of that. OpenRadioss is built outside this repository, and nothing of it enters here.
# usage: read_decks.sh STARTER [CASE...]   by default all of them; prints a row for each deck: errors and warnings
# environment: GASJET, the program `gasjet` (by default build/gasjet of this tree); what the starter itself needs, such as
#   LD_LIBRARY_PATH and RAD_CFG_PATH; UNITS, a unit system (by default t-mm-s)
# Exit code: 0 no errors; 1 the starter finds errors in a deck, or does not say that there are none; 2 bad arguments; 77 no starter.
set -uo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
gasjet=${GASJET:-$root/build/gasjet} units=${UNITS:-t-mm-s} bad=0

starter=$(command -v "${1:-}" 2>/dev/null) || {
  echo "read_decks.sh: no OpenRadioss starter '${1:-}': name the program as the first argument" >&2
  exit 77
}
starter=$(readlink -f "$starter")
shift
[[ -x $gasjet ]] || {
  echo "read_decks.sh: no program $gasjet: build it first, or name it by the variable GASJET" >&2
  exit 2
}
cases=("$@")
((${#cases[@]})) || mapfile -t cases < <(grep -l '^\[membrane\]' "$root"/cases/*.toml "$root"/cases/reference/*.toml)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
ulimit -s unlimited 2>/dev/null # the starter has arrays on the stack

# counts FILE: errors and warnings as the listing's last lines have them
counts() {
  grep -aoE '[0-9]+ +(ERROR|WARNING)\(S\) *$' "$1" | awk '/ERROR/ { e = $1; n++ } /WARNING/ { w = $1; n++ } END { if (n < 2) exit 1; print e, w }'
}

echo "| case | deck | errors | warnings |"
echo "|---|---|---|---|"
for case in "${cases[@]}"; do
  for format in radioss lsdyna; do
    name=$(basename "$case" .toml) out=$work/$(basename "$case" .toml).$format input=bag_0000.rad
    [[ $format == radioss ]] || input=bag.k
    "$gasjet" export "$case" --format $format --units "$units" --out "$out" >/dev/null || exit 2
    (cd "$out" && timeout 600 "$starter" -i $input -np 1 >starter.txt 2>&1)
    if read -r errors warnings < <(counts "$out/starter.txt"); then
      ((errors == 0)) || bad=1
    else
      errors="no end" warnings="" bad=1
    fi
    echo "| $name | $format | $errors | $warnings |"
    [[ ! -f $out/bag_0000.out ]] || grep -aA4 -E '^(ERROR|WARNING) ID' "$out/bag_0000.out" | sed 's/^/  /' >&2
  done
done
exit $bad
