#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of the plot scripts: columns are found by name (any order gives the same picture), a quantity that a scene
# does not have is left out, a table without any is refused, and all charts share one style sheet.
set -euo pipefail
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"

# table FILE COLUMN...: ten rows, each column a different smooth curve that depends on its name alone.
table() {
  mkdir -p "$(dirname "$1")"
  awk -v names="${*:2}" 'BEGIN {
    n = split(names, name, " ")
    print "# case: synthetic, for the test"
    for (i = 1; i <= n; i++) printf "%s%s", name[i], i < n ? "," : "\n"
    for (row = 0; row < 10; row++)
      for (i = 1; i <= n; i++) printf "%.6f%s", name[i] == "time_s" ? row / 100 : row ^ 2 / length(name[i]), i < n ? "," : "\n"
  }' >"$1"
}

fail() {
  echo "$*"
  exit 1
}

# panels FILE: how many panels the picture has.
panels() { grep -c 'Time \[ms\]' "$1"; }

angle=pendulum_angle_rad acceleration=pendulum_cg_acceleration_m_s2 pressure=pressure_Pa
table a/jet/history.csv time_s $pressure volume_m3 $angle $acceleration
table b/jet/history.csv $acceleration volume_m3 $angle time_s $pressure
table tank/history.csv time_s $pressure
table bare/history.csv time_s volume_m3

"$scripts/plot.sh" history a/plot a/jet tank >/dev/null
[[ -s a/plot.png && $(panels a/plot.svg) == 1 ]] || fail "a run and a tank share the pressure alone"
for run in a b; do "$scripts/plot.sh" history $run/plot $run/jet >/dev/null; done
[[ $(panels a/plot.svg) == 3 ]] || fail "a bag with pendulum has three panels"
cmp a/plot.svg b/plot.svg || fail "the order of the columns changed the picture"
if "$scripts/plot.sh" history c/plot bare 2>/dev/null; then fail "a table without the plotted columns was accepted"; fi

table a/jet/ensemble.csv time_s {"$pressure","$angle"}_{mean,standard_error}
table b/jet/ensemble.csv {"$angle","$pressure"}_{standard_error,mean} time_s
for run in a b; do "$scripts/plot.sh" ensemble $run/ensemble $run/jet >/dev/null; done
[[ $(panels a/ensemble.svg) == 2 ]] || fail "an ensemble of two quantities has two panels"
cmp a/ensemble.svg b/ensemble.svg || fail "the order of the columns changed the picture of the ensemble"
# Curves of a tank test: every fifth row masked.
curves() { awk -F, -v OFS=, '/^#/ { print; next } !n++ { print $0, "masked"; next } { print $0, n % 5 == 0 }' "$1" >"$2"; }
quantities=(mass_flow_kg_s mass_flow_low_kg_s mass_flow_high_kg_s temperature_K temperature_low_K temperature_high_K)
table a/plain.csv time_s "${quantities[@]}"
table b/plain.csv "${quantities[@]}" time_s
for run in a b; do
  curves $run/plain.csv $run/curves.csv
  "$scripts/plot.sh" identify $run/tank_test $run/curves.csv >/dev/null
done
[[ $(panels a/tank_test.svg) == 2 ]] || fail "a tank test has two panels"
cmp a/tank_test.svg b/tank_test.svg || fail "the order of the columns changed the picture of the tank test"
if "$scripts/plot.sh" identify c/tank_test a/plain.csv 2>/dev/null; then fail "curves without the column masked were accepted"; fi
table a/rows.csv time_s "$pressure"{,_reference,_band} volume_m3{,_reference}
table b/rows.csv "$pressure"{_band,_reference,} time_s volume_m3{,_reference}
for run in a b; do "$scripts/plot.sh" compare $run/rows $run/rows.csv >/dev/null; done
[[ $(panels a/rows.svg) == 2 && $(grep -c '>band<' a/rows.svg) == 1 ]] || fail "a comparison of two quantities, one with a band"
grep -q "pressure \[Pa\]" a/rows.svg && grep -q "volume \[m³\]" a/rows.svg || fail "units of the comparison"
cmp a/rows.svg b/rows.svg || fail "the order of the columns changed the picture of the comparison"
if "$scripts/plot.sh" compare c/rows tank/history.csv 2>/dev/null; then fail "a history without reference was accepted"; fi
# Each script that draws loads the one style sheet, and brings no fonts or frames of its own.
for script in "$scripts"/../docs/charts/gnuplot/*.gp $(grep -rlE --include='*.sh' 'gnuplot( 2>&1.*)? <<' "$scripts" "$scripts/../docs/make"); do
  [[ -f $script ]] || continue
  case ${script##*/} in style.gp | rows.gp) continue ;; esac
  grep -qE "^load (\\\$style|'docs/charts/gnuplot/style.gp')" "$script" || fail "$script does not load docs/charts/gnuplot/style.gp"
  if grep -nE "font 'sans[,']|set border 3|background 'white'" "$script"; then fail "$script has a style of its own"; fi
done
# The legend stands once, above the first panel.
"$scripts/plot.sh" history --name 'the run' a/named a/jet >/dev/null
[[ $(grep -c '>the run<' a/named.svg) == 1 ]] || fail "three panels need one legend"
if "$scripts/plot.sh" history --colour red a/named a/jet 2>/dev/null; then fail "an unknown option was accepted"; fi
# The known curve of a tank test is drawn beside the found one.
table a/known.csv time_s inflow_kg_s inflow_temperature_K
"$scripts/plot.sh" identify a/known a/curves.csv a/known.csv >/dev/null
grep -q 'known, to be found' a/known.svg || fail "the known curve is missing"
if "$scripts/plot.sh" identify c/known a/curves.csv tank/history.csv 2>/dev/null; then fail "known curves without flow were accepted"; fi
echo "plot scripts: columns by name, absent quantities left out, empty tables refused"
