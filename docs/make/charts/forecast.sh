#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What `gasjet check` forecasts beside what ladders measure: docs/charts/forecast.csv, and the table of it in
# docs/theory/forecast.md; and what those ladders say of a bag without a membrane: docs/charts/without_membrane.csv. Ladders
# that results/forecast has are not run again; that of the paper's scene is the committed one.
# usage: docs/make/charts/forecast.sh [--check [CSV]]
#   --check  compare the table and the counts of the page, and the totals, with the rows of docs/charts/forecast.csv
#            (or CSV); exit code 1 if they differ, 2 without rows
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
# shellcheck source-path=SCRIPTDIR source=common.sh
source docs/make/charts/common.sh
page=docs/theory/forecast.md csv=docs/charts/forecast.csv folder=results/forecast

# Cases, and the quantity of the ladder.
scenes() {
  cat <<'TABLE'
rigid_tank pressure
tank_triggers peak_pressure
tank_blowdown temperature
tank_backflow temperature
tank_stiff peak_pressure
plate_jet jet_force
jet_slot_plate jet_force
sphere_inflation peak_pressure
jet_bag peak_pressure
bag_leak_table peak_pressure
bag_from_files peak_pressure
driver_bag peak_pressure
ball_impact contact_impulse
contact_vent pendulum_angle
passenger_pendulum pendulum_angle
TABLE
}

# ladder_of CASE QUANTITY: its table; undecided is an answer too.
ladder_of() {
  local table=$folder/$1/ladder.csv code=0
  if [[ $1 == passenger_pendulum ]]; then
    table=docs/charts/ladder_passenger.csv
  elif [[ ! -f $table ]]; then
    build/gasjet ladder "cases/$1.toml" --quantity "$2" --threads "$(nproc)" --quiet --out "$folder/$1" >&2 || code=$?
    ((code == 0 || code == 4))
  fi
  echo "$table"
}

# without_membrane: the rungs of that kind of five bags, the last the paper's as it is, where only the jet is varied.
without_membrane() {
  local scene paper=$folder/passenger_pendulum_pressure
  [[ -f $paper/ladder.csv ]] ||
    build/gasjet ladder cases/passenger_pendulum.toml --quantity peak_pressure --tolerance 10% --quiet --threads "$(nproc)" \
      --hold mesh,pieces,step,gas,outlet,occlusion,compression,porosity,cp --out "$paper" >&2
  provenance
  echo "scene,rung,overpressure_Pa,change_percent,change_se_percent,cost_ratio"
  for scene in sphere_inflation jet_bag bag_leak_table driver_bag passenger_pendulum_pressure; do
    awk -F, -v scene="${scene%_pressure}" '
      /^# counted from: / { zero = substr($0, 17) + 0 }
      /^# reference: / { size = substr($0, 14) - zero }
      /^#/ { next }
      !head { head = 1; for (i = 1; i <= NF; ++i) at[$i] = i; next }
      $1 ~ /^(full|volume by pressure|rigid tank)$/ {
        printf "%s,%s,%.6g,%.3g,%.2g,%.3g\n", scene, $1, $(at["value"]) - zero, 100 * $(at["change"]) / size,
          100 * $(at["change_se"]) / size, $(at["cost_ratio"]) }' "$folder/$scene/ladder.csv"
  done
}

write_csv() {
  local scene quantity table json
  provenance
  echo "scene,quantity,effect,group,size,forecast,change_percent,change_se_percent,ladder,agree"
  while read -r scene quantity; do
    table=$(ladder_of "$scene" "$quantity")
    json=$(build/gasjet check "cases/$scene.toml" --format json)
    awk -v scene="$scene" -f docs/make/charts/forecast.awk <(echo "$json") "$table"
  done < <(scenes)
}

rows() { grep -v '^#\|^scene,\|^all' "$1"; }

# totals CSV: its last four lines, from its rows.
totals() {
  rows "$1" | awk -F, '
    { sum += $NF; count += $NF != "" }
    $4 != "gas_relaxation" { sizes += $NF; of_sizes += $NF != "" }
    END { printf "all that agree,,,,,,,,,%d\nall,,,,,,,,,%d\nall sizes that agree,,,,,,,,,%d\nall sizes,,,,,,,,,%d\n", sum, count, sizes, of_sizes }'
}

# counts CSV: the same as the page says it.
counts() { totals "$1" | awk -F, '{ n[NR] = $NF } END { printf "It agrees in %d of %d; of the sizes alone in %d of %d.", n[1], n[2], n[3], n[4] }'; }

table() {
  awk -F, '
    /^#/ || /^all/ { next }
    !head { head = 1; print "| scene, quantity | left out or refined | group | forecast | changes by [%] | agree |\n|---|---|---|---|---|---|"; next }
    { sub(/_(rad|Pa|N|Ns|K)$/, "", $2)
      print "| " ($1 == last ? "" : "`" $1 "`, " $2) " | " $3 " | " $4 " | " $5 ", " $6 " | " $7 ($8 > 0 ? " ± " $8 : "") \
        " | " ($10 == "" ? "undecided" : $10 ? "yes" : "**no**") " |"; last = $1 }' "$1"
  sed -nE 's/^# (commit: |gasjet [^ ]+ \()([0-9a-f]+).*/\nMade at commit `\2` ([forecast.csv](..\/charts\/forecast.csv))./p' "$1"
}

# page_with CSV: the page with the counts of CSV and its table between the two marks.
page_with() {
  awk -v table="$(table "$1")" -v counts="$(counts "$1")" '
    { sub(/It agrees in [0-9]+ of [0-9]+; of the sizes alone in [0-9]+ of [0-9]+\./, counts) }
    /^<!-- end of the table -->/ { inside = 0 }
    !inside
    /^<!-- table by docs\/make\/charts\/forecast.sh -->/ { inside = 1; print "\n" table "\n" }' "$page"
}

# paper_rows CSV: those of the paper's scene whose change is not that of its ladder.
paper_rows() {
  awk -F, '
    FNR == 1 { ++file }
    /^# reference: / { reference = substr($0, 14) }
    /^#/ { next }
    file == 1 && !head { head = 1; for (i = 1; i <= NF; ++i) at[$i] = i; next }
    file == 1 { rung = $1; sub(/^finest: /, "", rung)
                change[rung] = sprintf("%.3g %.2g", 100 * $(at["change"]) / reference, 100 * $(at["change_se"]) / reference); next }
    $1 == "passenger_pendulum" && $7 " " $8 != change[$3] { print "passenger_pendulum, " $3 ": " $7 " " $8 ", in its ladder: " change[$3] }' \
    docs/charts/ladder_passenger.csv "$1"
}

# check CSV
check() {
  if [[ ! -f $1 || ! -r $1 ]] || ! rows "$1" >/dev/null; then
    echo "forecast.sh: $1 has no rows, or is not there" >&2
    exit 2
  fi
  diff <(totals "$1") <(grep '^all' "$1") || { echo "the totals of $1 are not those of its rows"; exit 1; }
  [[ -z $(paper_rows "$1") ]] || { echo "$1: $(paper_rows "$1")"; exit 1; }
  { diff <(page_with "$1") "$page" && grep -qF "$(counts "$1")" "$page"; } ||
    { echo "$page is not what $1 says: docs/make/charts/forecast.sh writes it anew"; exit 1; }
  echo "$page holds: $(rows "$1" | wc -l) rows"
}

if [[ ${1:-} == --check && $# -le 2 ]]; then
  check "${2-$csv}"
elif (($#)); then
  echo "forecast.sh: cannot take '$*'; allowed: nothing, --check [CSV]" >&2
  exit 2
else
  mkdir -p "$folder"
  write_csv >"$folder/forecast.csv"
  totals "$folder/forecast.csv" >"$folder/totals"
  cat "$folder/totals" >>"$folder/forecast.csv"
  cp "$folder/forecast.csv" "$csv"
  page_with "$csv" >"$folder/forecast.md"
  cp "$folder/forecast.md" "$page"
  tail -n 4 "$csv"
  without_membrane >"$folder/without_membrane.csv"
  cp "$folder/without_membrane.csv" docs/charts/without_membrane.csv
fi
