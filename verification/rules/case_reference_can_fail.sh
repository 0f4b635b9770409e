#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The check of docs/case_files.md tells a wrong unit, range and default, a row without a key and a key without a row.
# usage: case_reference_can_fail.sh GASJET
set -euo pipefail
root=$(cd "${BASH_SOURCE[0]%/*}/../.." && pwd)
page=$(mktemp --suffix=.md)
trap 'rm -f "$page"' EXIT

# tells WORDS SED: with the page changed so, the check fails and says the words
tells() {
  local report status=0
  sed "$2" "$root/docs/case_files.md" >"$page"
  report=$(/usr/bin/python3 "$root/docs/make/pages/case_keys.py" --check "$gasjet" "$page") || status=$?
  if ((status != 1)) || [[ $report != *"$1"* ]]; then
    printf 'changed by %s the check ends with %d and says:\n%s\n' "$2" "$status" "$report"
    exit 1
  fi
}

gasjet=$1
tells 'rad/s |' '/^| `initial_angular_velocity`/s:rad/s:rad:'
tells '| above 0 |' '/^| `long_side`/s/above 0/0 or more/'
tells '| 293.15 |' 's/293.15/300/'
tells 'no case asks for pendulum.colour' 's/^| `pivot`/| `colour` | of it | | | |\n&/'
tells 'no row for the key pendulum.pivot' '/^| `pivot`/d'
tells 'the program says' 's/theory.membrane.md#laws/theory\/membrane.md#meshes/'
