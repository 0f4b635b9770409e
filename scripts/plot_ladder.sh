#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Error against CPU time of the rungs of one ladder, both logarithmic: filled what lies on the front (nothing cheaper is
# as exact), bars of two standard errors, a dashed line for the tolerance, and grey below the reference's uncertainty.
# usage: scripts/plot_ladder.sh OUT LADDER.csv; writes OUT.svg and OUT.png
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=plot_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/plot_common.sh"

(($# == 2)) || fail "usage: plot_ladder.sh OUT LADDER.csv"
out=$1 table=$2
[[ -f $table ]] || fail "no file $table"
for name in rung error error_se cpu_s; do has_column "$table" $name || fail "$table: no column $name"; done

header() { sed -n "s/^# $1: //p" "$table"; }
reference=$(header reference) tolerance=$(header tolerance) uncertainty=$(header uncertainty) quantity=$(header quantity)
zero=$(header 'counted from') # of pressures: the ambient one
[[ -n $reference ]] || fail "$table: no line '# reference:'; was the ladder interrupted?"
size=$(awk -v value="$reference" -v zero="${zero:-0}" 'BEGIN { s = value - zero; printf "%.17g", s < 0 ? -s : s }')

# rows: name|cost [s]|error|low|high|number on the front, 1 there; errors in per cent of the reference, not below the floor
# of a thousandth of the tolerance. By cost, so that the front is where the error falls.
rows() {
  awk -F, -v OFS='|' -v size="$size" -v floor="$tolerance" '
    function at_least(value, least) { return value > least ? value : least }
    /^#/ { next }
    !head { for (i = 1; i <= NF; i++) c[$i] = i; head = 1; next }
    $c["error"] != "" {
      e = 100 * $c["error"] / size; e = e < 0 ? -e : e; s = 200 * $c["error_se"] / size; f = 0.1 * floor
      print $c["rung"], $c["cpu_s"], at_least(e, f), at_least(e - s, f), at_least(e + s, f)
    }' "$table" | LC_ALL=C sort -t'|' -k2,2g |
    awk -F'|' -v OFS='|' 'NR == 1 || $3 < best { best = $3; print $0, ++n, 1; next } { print $0, "", 0 }'
}

data=$(rows)
[[ -n $data ]] || fail "$table: no rung has an error"
list=$(awk -F'|' '$7 { printf "%s%d  %s", n++ ? "\\n" : "", n, $1 }' <<<"$data" | tr _ ' ')
mkdir -p "$(dirname "$out")"
for terminal in "svg size 900,560 font 'sans,12' background 'white'" "pngcairo size 1800,1120 font 'sans,12' fontscale 2 linewidth 2"; do
  gnuplot <<END
set terminal $terminal
set output '$out.${terminal:0:3}'
set datafile separator '|'
set border 3
set tics nomirror
set logscale xy
set rmargin 32
set format xy '%g'
set label 2 'on the front, the cheapest first' at graph 1.03, graph 0.98
set label 1 "$list" at graph 1.03, graph 0.92 font ',10'
set xlabel 'CPU time of a run [s]'
set ylabel 'Error of ${quantity//_/ } [%]'
set key bottom left at graph 1.03, graph 0.02 Left reverse samplen 2 font ',10'
set offsets graph 0.05, graph 0.05, 0, 0
\$rungs << EOD
$data
EOD
set style fill solid 1 noborder
u = 100.0 * $uncertainty / $size
set yrange [*:*]
plot (u > 0 ? u : NaN) with filledcurves y1=1e-30 fillcolor 'gray90' title 'uncertainty of the reference', \
  100.0 * $tolerance with lines linecolor 'black' dashtype 2 title 'tolerance', \
  \$rungs using 2:3:4:5 with yerrorbars linecolor 'gray50' pointtype 6 title 'rung, ± 2 s.e.', \
  \$rungs using 2:(\$7 == 1 ? \$3 : NaN) with points linecolor 'black' pointtype 7 title 'on the front', \
  \$rungs using 2:3:6 with labels offset 0.9,0.6 font ',10' notitle
END
  echo "$out.${terminal:0:3}"
done
