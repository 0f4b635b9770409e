#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes docs/gallery.md: each case with the first sentence of its file and pictures of its run, in docs/gallery. Needs build/gasjet.
# usage: docs/make/pages/gallery.sh [--check]    --check: only compare the page with the cases, run nothing
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

page=docs/gallery.md pictures=docs/gallery
cases=(cases/*.toml cases/reference/*.toml)
# What a picture may show, the first three that a case has and that change in it: column | factor | label
quantities=(
  'pressure_Pa|1e-3|Pressure [kPa]' 'pendulum_angle_rad|180/pi|Pendulum angle [°]' 'jet_force_N|1e-3|Jet force [kN]'
  'contact_force_N|1e-3|Contact force [kN]' 'strap_force_N|1e-3|Strap force [kN]' 'volume_m3|1e3|Volume [l]'
  'vent_outflow_kg_s|1e3|Outflow, vents [g/s]' 'fabric_outflow_kg_s|1e3|Outflow, fabric [g/s]' 'temperature_K|1|Temperature [K]'
  'jet_lit_elements|1|Elements that the jet meets' 'overpressure_Pa|1e-3|Overpressure [kPa]' 'skin_displacement_m|1e3|Largest displacement [mm]'
)

# first_sentence CASE: of the comment at the top of the file.
first_sentence() {
  sed -n '2,${/^#/!q;s/^# *//;p}' "$1" | paste -sd ' ' | sed -E 's/([a-z)"])\. .*/\1./; s/[:.]?$/./'
}

has_bag() { grep -q '^\[membrane\]' "$1"; }

write_page() {
  echo '# Gallery'
  echo
  echo "Each case of the repository, with the first sentence of its file, histories of its run and, where it has one, its bag at the end."
  echo 'The bag is drawn to no common scale; a history shows at most 120 of its rows. `docs/make/pages/gallery.sh` writes this page and its pictures.'
  echo "The paper's scene at six times, with and without jet, is [above the table of the README](../README.md#what-the-jet-does-and-what-it-costs)."
  echo '[`gasjet report`](report.md) shows any run in motion, in a browser.'
  echo '[Programs](examples/README.md) in Python, Fortran and C that use Gasjet have pages of their own.'
  local file name bag
  for file in "${cases[@]}"; do
    name=$(basename "$file" .toml)
    bag=
    ! has_bag "$file" || bag=" ![$name: the bag at the end](gallery/$name.png)"
    printf '\n## [%s](../%s)\n\n%s\n\n![%s: histories](gallery/%s.svg)%s\n' "$name" "$file" "$(first_sentence "$file")" "$name" "$name" "$bag"
  done
}

# shown_columns HISTORY: the columns that change in it; if none of the quantities above does, all of them.
shown_columns() {
  awk -F, -v quantities="${quantities[*]}" '/^#/ { next }
    !n { n = NF; for (i = 1; i <= n; i++) name[i] = $i; next }
    !rows++ { for (i = 1; i <= n; i++) first[i] = $i; next }
    { for (i = 1; i <= n; i++) if ($i != first[i]) changes[i] = 1 }
    END { for (i = 1; i <= n; i++) any += changes[i] && index(quantities, name[i] "|")
          for (i = 1; i <= n; i++) if (changes[i] || !any) print name[i] }' "$1"
}

# draw_history HISTORY OUT: ticks at a round quarter to half of the range; what gnuplot writes is thinned of what does not show.
draw_history() {
  local present quantity column factor label value commands='' shown=0 rows
  present=$(shown_columns "$1")
  rows=$(grep -vc '^#' "$1")
  for quantity in "${quantities[@]}"; do
    IFS='|' read -r column factor label <<<"$quantity"
    if ((shown == 3)) || ! grep -qx "$column" <<<"$present"; then continue; fi
    value="($factor*column('$column'))"
    commands+="set yrange [*:*]
stats '$1' using $value nooutput
constant = STATS_max <= STATS_min
if (constant && STATS_max > 0) set yrange [0:2*STATS_max]
set ytics tick(constant ? 0 : STATS_min, constant ? 2*STATS_max : STATS_max)
set title '$label'
plot '$1' every $((rows / 120 + 1)) using (1e3*column('time_s')):$value with lines linestyle 1 linewidth 1.4 notitle
"
    shown=$((shown + 1))
  done
  gnuplot 2>&1 >"$2.long" <<END | grep -v 'empty . range' >&2 || true
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 600,180 font small_face background paper
set datafile columnheaders
unset label 1 # the page has the name of the case
set xlabel 'Time [ms]'
decade(range) = 10**floor(log10(range))
round_part(range) = decade(range) * (range / decade(range) > 4 ? 2 : range / decade(range) > 2 ? 1 : 0.5)
tick(low, high) = high > low ? round_part(high - low) : 1
stats '$1' using (1e3*column('time_s')) nooutput
set xtics tick(STATS_min, STATS_max)
set multiplot layout 1,3
$commands
unset multiplot
END
  sed -E '/<defs>/,/<\/defs>/d; s/^[ \t]+//; s/ *<tspan[^>]*>|<\/tspan>//g; /<text/!s/(\.[0-9])[0-9]\b/\1/g' "$2.long" >"$2"
  rm "$2.long"
}

# draw_bag FRAME OUT: the triangles of a .vtp file, as large as the picture allows.
draw_bag() {
  local view
  view=$(awk -v polygons="$1.polygons" '/Name="/ { match($0, /Name="[^"]*"/); part = substr($0, RSTART + 6, RLENGTH - 7); next }
    /^</ { part = ""; next }
    part == "Points" { point[n++] = $1 " " $2 " " $3 }
    part == "connectivity" { for (i = 1; i <= NF; i++) { seen[$i]; print point[$i] >polygons; if (++corner % 3 == 0) printf "\n\n" >polygons } }
    # the bag stands in a cube about its centre, seen turned by 40 and tilted by 65 degrees
    function bound(c, v) { if (!(c in low) || v < low[c]) low[c] = v; if (!(c in high) || v > high[c]) high[c] = v }
    function extent(c) { return high[c] - low[c] }
    END { turn = atan2(1, 1) * 40 / 45; tilt = atan2(1, 1) * 65 / 45
          for (i in seen) { split(point[i], p, " "); for (c = 1; c <= 3; c++) bound(c, p[c]) }
          for (c = 1; c <= 3; c++) if (extent(c) > longest) longest = extent(c)
          for (i in seen) {
            split(point[i], p, " "); for (c = 1; c <= 3; c++) p[c] = (p[c] - (low[c] + high[c]) / 2) / longest
            x = p[1] * cos(turn) + p[2] * sin(turn); y = (p[2] * cos(turn) - p[1] * sin(turn)) * cos(tilt) + p[3] * sin(tilt)
            if (x < 0) x = -x; if (y < 0) y = -y
            if (x > across) across = x; if (y > up) up = y }
          for (c = 1; c <= 3; c++) printf "set %srange [%.9g:%.9g]\n", substr("xyz", c, 1), (low[c] + high[c] - longest) / 2, (low[c] + high[c] + longest) / 2
          printf "set view 65, 40, %.4g\n", 1 / (across > 1.2 * up ? across / 1.76 : up / 1.46) }' "$1")
  gnuplot <<END
load 'docs/charts/gnuplot/style.gp'
set terminal pngcairo size 220,180 background paper
set output '$2'
unset border
unset tics
unset key
unset colorbox
set margins 0, 0, 0, 0
set origin 0.06, -0.05 # gnuplot leaves room for axes
$view
set view equal xyz
set xyplane relative 0
set pm3d depthorder border linecolor rgb '#909090' linewidth 0.2 lighting primary 0.3 specular 0.1
set style fill solid 1
set datafile separator whitespace # style.gp reads tables with commas
splot '$1.polygons' with polygons fillcolor rgb '#e8c890'
END
}

case ${1:-} in
  --check)
    write_page | diff "$page" - || { echo "$page differs from the cases: run docs/make/pages/gallery.sh"; exit 1; }
    for picture in $(grep -oE 'gallery/[a-z0-9_]+\.(svg|png)' "$page"); do
      [[ -s docs/$picture ]] || { echo "$page: no picture docs/$picture"; exit 1; }
    done
    exit 0
    ;;
  '') ;;
  *)
    echo "gallery.sh: unknown argument '$1'; allowed: --check" >&2
    exit 2
    ;;
esac

runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT
mkdir -p "$pictures"
rm -f "$pictures"/*
for file in "${cases[@]}"; do
  name=$(basename "$file" .toml)
  fields=()
  ! has_bag "$file" || fields=(--set "output.fields_every=$(build/gasjet check "$file" | sed -nE 's/^ *scene.end_time = ([^ ]*).*/\1/p')")
  build/gasjet run "$file" --out "$runs/$name" --quiet "${fields[@]}"
  draw_history "$runs/$name/history.csv" "$pictures/$name.svg"
  ! has_bag "$file" || draw_bag "$(find "$runs/$name" -name 'bag_*.vtp' | sort | tail -n 1)" "$pictures/$name.png"
done
write_page >"$page"
echo "$page"
