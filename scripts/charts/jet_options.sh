#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What each option of a jet contributes: runs the small jet cases as they are, then with one option changed at a time
# (a sed expression on the case file), and writes the table as Markdown.
# usage: scripts/charts/jet_options.sh [FILE]      (docs/charts/jet_options.md by default)
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:-docs/charts/jet_options.md}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

scripts/setup_debian12.sh >/dev/null
cmake --preset release >/dev/null
cmake --build --preset release --target gasjet -j "$(nproc)" >/dev/null

# case | what is changed | sed expression
variants=(
  "plate_jet|as it is: force (1 + e) mdot V0|"
  "plate_jet|\`restitution = 0\`: deflection into the plate|s/^restitution = .*/restitution = 0.0/"
  "plate_jet|\`outlet_type = \"contracting_nozzle\"\`: a wide plate takes the same momentum|s/^outlet_type = .*/outlet_type = \"contracting_nozzle\"/"
  "plate_jet|\`temperature = \"stagnation\"\`|s/^shape = .*/&\ntemperature = \"stagnation\"/"
  "jet_slot_plate|as it is|"
  "jet_slot_plate|\`spread = \"momentum\"\` (default)|s/^spread = .*/spread = \"momentum\"/; /^cone_/d"
  "jet_slot_plate|\`direction = \"axial\"\` (default)|s/^direction = .*/direction = \"axial\"/"
  "jet_slot_plate|\`restitution = 1\` (default)|s/^restitution = .*/restitution = 1.0/"
  "jet_slot_plate|\`subdivisions = 1\` (default): the centroid speaks for the element|s/^subdivisions = .*/subdivisions = 1/"
  "jet_slot_plate|\`outlet_type = \"plane_nozzle\"\`|s/^outlet_type = .*/outlet_type = \"plane_nozzle\"/"
  "jet_bag|as it is|"
  "jet_bag|\`outlet = \"sonic\"\` (default)|s/^outlet = .*/outlet = \"sonic\"/"
  "jet_bag|\`outlet = \"sonic\"\`, \`temperature = \"static\"\`, \`jet_work = \"external\"\` (defaults)|/^outlet = /d; /^temperature = \"/d; /^jet_work/d"
  "jet_bag|\`jet_work = \"external\"\` (default)|s/^jet_work = .*/jet_work = \"external\"/"
  "jet_bag|\`relative_to_skin = false\` (default)|s/^relative_to_skin = .*/relative_to_skin = false/"
  "jet_bag|second inflator at once: its jet follows its flow|/^start_time/d"
  "jet_bag|without the second jet|/the second jet/,/^relative_to_skin/d"
  "passenger_pendulum|first 30 ms|s/^end_time = .*/end_time = 0.03/"
  "passenger_pendulum|first 30 ms, \`occlusion = false\`|s/^end_time = .*/end_time = 0.03/; s/^restitution/occlusion = false\n&/"
)

# column FILE NAME HOW: last value of a column, or its integral over time (integral).
column() {
  awk -F, -v name="$2" -v how="$3" '
    /^#/ { next }
    !at { for (i = 1; i <= NF; ++i) { if ($i == name) at = i; if ($i == "time_s") time = i } if (!at) { print "-"; exit } next }
    { if (seen) integral += ($time - t) * ($at + last) / 2
      last = $at; t = $time; seen = 1 }
    END { if (seen) printf "%.5g", how == "last" ? last : integral }' "$1"
}

# Peak of the force of all jets together over all steps; rows of the history may miss it.
peak() {
  sed -nE 's/.*"jet_force_N": ([^,]*),?$/\1/p' "$1" | awk '{ printf "%.5g", $1 }'
}

{
  echo "<!-- SPDX-License-Identifier: Apache-2.0 -->"
  echo "# What each option of a jet contributes"
  echo
  echo "Written by \`scripts/charts/jet_options.sh\` from the cases of that name, one option changed at a time, by $(build/gasjet --version)."
  echo "One coupled run each: what a change does to the bag's motion is in its row. \`passenger_pendulum\` is [chaotic](../ensembles.md), so that"
  echo "its differences are trends. Peak: of the force of all jets together, over all steps (\`summary.json\`). Impulse: by trapezoids over the rows of the history."
  echo "For the force of the same frozen states with and without hidden elements see [jet](../theory/jet.md#overpressure)."
  echo
  echo "| case | change | peak jet force [N] | jet impulse [N s] | external jet work [J] | end pressure [Pa] |"
  echo "|---|---|---|---|---|---|"
  for variant in "${variants[@]}"; do
    IFS='|' read -r name change expression <<<"$variant"
    sed -e "$expression" "cases/$name.toml" >"$work/$name.toml"
    build/gasjet run "$work/$name.toml" --out "$work/run" --quiet >/dev/null
    work_done=-
    [[ ! -f $work/run/energy.csv ]] || work_done=$(column "$work/run/energy.csv" jet_work_J last)
    echo "| $name | $change | $(peak "$work/run/summary.json") | $(column "$work/run/history.csv" jet_force_N integral) | $work_done | $(column "$work/run/history.csv" pressure_Pa last) |"
    rm -rf "$work/run"
  done
} >"$work/table.md"
mkdir -p "$(dirname "$out")"
cp "$work/table.md" "$out"
cat "$out"
