#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The default of the gas, method and tolerance, is what the chart of work against precision says, and the chart is whole: for
# each run of another method that is as accurate as the page says, the recommended one has a run, or a place on the line between
# two of its runs, that is within a tenth no worse and no slower (scatter of times, and a method that hands over to another).
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
chart=$root/docs/charts/gas_work_precision.csv page=$root/docs/charts/README.md header=$root/libgas/include/gas/integrator.hpp
fail() {
  echo "$*"
  exit 1
}

section=$(sed -n '/^## Gas: /,/^## Tank test/p' "$page")
(($(grep -o '\*\*[^*]*\*\*' <<<"$(tr '\n' ' ' <<<"$section")" | wc -l) == 2)) || fail "$page: two sentences in bold are needed"
below=$(sed -nE 's/.*\*\*Use Dormand-Prince 5, the default, for every error below ([0-9e.-]+):.*/\1/p' <<<"$section")
[[ $below ]] || fail "$page: does not say from which error on the default costs least"
grep -q '  Method method = Method::dormand_prince_5;' "$header" || fail "$header: the default is not the method of $page"
tolerance=$(sed -nE 's/.*\*\*The default tolerance of ([0-9e.-]+) takes.*/\1/p' <<<"$section")
[[ $tolerance ]] || fail "$page: does not say what the default tolerance costs"
[[ $(tr -s '[:space:]' ' ' <"$header") == *"double relative_tolerance = $tolerance;"* ]] || fail "$header: the default tolerance is not '$tolerance', that of $page"

found=$(awk -F, -v below="$below" '
  /^#/ { next }
  $1 == "problem" { next }
  {
    tanks[$1]; ++runs[$1, $2]
    if ($3 == "1e-02" || $3 == "1e-12") ++ends[$1, $2]
    n = ++count[$1]; solver[$1, n] = $2; time[$1, n] = $4; error[$1, n] = $5
    if (!(($1, $2) in least) || $5 < least[$1, $2]) least[$1, $2] = $5
  }
  END {
    best = "dormand_prince"
    for (tank in tanks) {
      ++number
      if (runs[tank, best] != 11 || ends[tank, best] != 2) print tank ": " best " needs tolerances from 1e-2 to 1e-12"
      if (tank == "filled_sealed") continue  # nothing is stepped
      for (i = 1; i <= count[tank]; ++i) {
        # Within twice the least error of the recommended method lies the rounding of the reference.
        if (solver[tank, i] == best || error[tank, i] >= below || error[tank, i] < 2 * least[tank, best]) continue
        found = 0
        wanted = 1.1 * error[tank, i]
        last = 0
        for (j = 1; j <= count[tank]; ++j) {
          if (solver[tank, j] != best) continue
          needed = time[tank, j]
          if (last && error[tank, last] > wanted && error[tank, j] < wanted && error[tank, j] > 0) {
            share = log(error[tank, last] / wanted) / log(error[tank, last] / error[tank, j])
            needed = time[tank, last] * exp(share * log(time[tank, j] / time[tank, last]))
          }
          found += error[tank, j] <= wanted && needed <= 1.1 * time[tank, i]
          last = j
        }
        if (!found) print tank ": " solver[tank, i] " has " error[tank, i] " in " time[tank, i] " us, " best " not"
      }
    }
    if (number < 6) print number + 0 " tanks, of six"
  }' "$chart")
[[ -z $found ]] || fail "$found"
echo "the chart, its sentences and the default agree"
