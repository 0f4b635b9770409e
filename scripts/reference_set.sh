#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the reference histories of cases/reference with their error bands, their meshes (OBJ and keyword) and SHA256SUMS.
# usage: scripts/reference_set.sh [--work FOLDER] [SCENE...]
#   --work FOLDER  keep the runs there; ensembles that are there already are taken as they are
# Bands are half widths, one for each column, in the reference's own header with their reason:
#   closed form: twice the largest difference to it;
#   refinement: twice the largest change when the step is halved, plus 1.5 times that when each element of the same polyhedron is cut
#   in 16 (of numbers of elements, a 16th of them then): an error of first order is 4/3 of that change, one of second 16/15;
#   chaotic scenes: means of many runs with standard error and scatter; as band the error of the step. Fails unless runs and means of
#   seeds of their own lie inside.
# Fails where a band would be as wide as its signal.
# At least round-off: 1e-12 of the column's largest magnitude, eps times some thousand additions.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
gasjet=${GASJET:-$root/build/gasjet}
[[ ! -d $gasjet ]] || gasjet+=/build/gasjet # a clone, as the tutorials set it
out=${REFERENCE_OUT:-cases/reference}
scenes=(tank_fill two_gas_fill tank_blowdown piston_leak sphere_vent circular_membrane plate_jet plate_jet_shadow
  pendulum_swing cushion_impact passenger_jet passenger_no_jet passenger_sharp_jet passenger_sharp_no_jet)
runs=64 runs_halved=32 # of the means, and of those at half the step

work=
if [[ ${1:-} == --work ]]; then
  work=${2:?--work needs a folder}
  shift 2
  mkdir -p "$work"
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
(($# == 0)) || scenes=("$@")

# run SUFFIX OVERRIDE...: the scene's case, into $work/$scene.SUFFIX
run() {
  local overrides=() text
  for text in "${@:2}"; do overrides+=(--set "$text"); done
  "$gasjet" run "$case" --quiet --out "$work/$scene.$1" "${overrides[@]}"
}

# differences MINE REFERENCE: lines `column largest_difference` of the columns that both have; without a band it is undecided, 4
differences() {
  { "$gasjet" compare "$1" "$2" || [[ $? == 4 ]]; } | awk '$2 + 0 == $2 && NF > 8 && $1 != "quantity" { print $1, $2 }'
}

# sixteenth_of_elements HISTORY: of a mesh whose elements are cut in 16, numbers of elements as of the uncut one
sixteenth_of_elements() {
  awk -F, -v OFS=, '/^#/ { print; next } !n++ { for (i = 1; i <= NF; i++) if ($i ~ /_elements$/) counts[i]; print; next }
    { for (i in counts) $i = sprintf("%.17g", $i / 16); print }' "$1"
}

# widths FACTOR REASON: reads `column difference`, prints `column width reason`
widths() { awk -v factor="$1" -v reason="$2" '{ printf "%s %.4g %s\n", $1, factor * $2, reason }'; }

base=$work # set by each scene
# with_bands STRIDE: the base history with a band beside each column; bands on standard input, `column width reason`, the last of a
# column counts, `+` before its width adds to it.
with_bands() {
  awk -F, -v stride="$1" -v source="$base/history.csv" -v scene="$scene" -v file="$case" -v made="$made" '
    function largest(i,   r, m) { for (r = 1; r <= rows; r++) { m = value[r, i] < 0 ? -value[r, i] : value[r, i]; if (m > peak) peak = m }; return peak }
    function variation(i,   r, low, high) { low = high = value[1, i]; for (r = 2; r <= rows; r++) { if (value[r, i] < low) low = value[r, i]; if (value[r, i] > high) high = value[r, i] }; return high - low }
    { n = split($0, part, " "); name = part[1]; why = part[3]; for (i = 4; i <= n; i++) why = why " " part[i]
      if (part[2] ~ /^\+/) { width[name] += part[2]; reason[name] = reason[name] " + " why } else { width[name] = part[2]; reason[name] = why } }
    END {
      while ((getline line < source) > 0) {
        if (line ~ /^#/) { if (line !~ /^# (run|date|options|case):/) print line; continue }
        n = split(line, part, ",")
        if (!columns) { columns = n; for (i = 1; i <= n; i++) header[i] = part[i]; continue }
        rows++
        for (i = 1; i <= n; i++) { value[rows, i] = part[i] + 0; text[rows, i] = part[i] }
      }
      print "# scene: " scene "\n# case: " file "\n# made by: scripts/reference_set.sh" made
      for (i = 2; i <= columns; i++) {
        name = header[i]; peak = 0; top = largest(i)
        if (!(name in width)) fault = name " has no band"
        if (width[name] < 1e-12 * top) { width[name] = 1e-12 * top; reason[name] = "round-off" }
        if (width[name] >= variation(i) && variation(i) > 1e-6 * top) fault = name " has a band as wide as the signal, " width[name]
        printf "# band %s: %.3g, %s\n", name, width[name], reason[name]
      }
      if (fault) { print scene ": " fault >"/dev/stderr"; exit 1 }
      printf "%s", header[1]
      for (i = 2; i <= columns; i++) printf ",%s,%s_band", header[i], header[i]
      print ""
      for (r = 1; r <= rows; r++) {
        if ((r - 1) % stride && r < rows) continue
        printf "%s", text[r, 1]
        for (i = 2; i <= columns; i++) printf ",%s,%.3g", text[r, i], width[header[i]]
        print ""
      }
    }' >"$out/$scene.csv"
}

# refined STEP MESH: bands from these two overrides (several words each; empty: none), and `exact` if there is one
refined() {
  local step=$1 mesh=$2
  if [[ -n $step ]]; then
    # shellcheck disable=SC2086
    run step $step
    differences "$work/$scene.step/history.csv" "$base/history.csv" | widths 2 "step halved ($step)"
  fi
  if [[ -n $mesh ]]; then
    # shellcheck disable=SC2086
    run mesh $mesh
    sixteenth_of_elements "$work/$scene.mesh/history.csv" >"$work/$scene.cut.csv"
    differences "$work/$scene.cut.csv" "$base/history.csv" | widths 1.5 "elements cut ($mesh)" | sed 's/ / +/'
  fi
  if [[ -s $work/$scene.exact ]]; then
    differences "$work/$scene.exact" "$base/history.csv" | widths 2 "gasjet exact $exact"
  fi
}

# scene_by_refinement CASE STRIDE STEP MESH [EXACT...]: EXACT are the arguments of `gasjet exact`
scene_by_refinement() {
  case=$1 exact=${*:5} base=$work/$scene.base
  run base
  [[ -z $exact ]] || "$gasjet" exact "${@:5}" >"$work/$scene.exact"
  refined "$3" "$4" | with_bands "$2"
  "$gasjet" compare "$base/history.csv" "$out/$scene.csv" >/dev/null
}

# A steady force, as a history of the jet's plate: (1 + e) mdot V0 with e = 1.
exact_plate_force() {
  local flux force
  flux=$("$gasjet" exact sonic_outlet --set temperature=406 --times 2 | tail -1 | cut -d, -f4)
  force=$("$gasjet" exact plate_force --times "$flux" | tail -1 | cut -d, -f2)
  awk -v force="$force" -v end="$1" \
    'BEGIN { print "time_s,jet_force_N"; for (i = 0; i <= 10; i++) printf "%.17g,%s\n", end * i / 10, force }' >"$work/$scene.exact"
}

scene_of_jet() { # CASE END STEP MESH
  case=$1 exact="plate_force" base=$work/$scene.base
  run base
  exact_plate_force "$2"
  refined "$3" "$4" | sed 's/ +/ /' | with_bands 1
  "$gasjet" compare "$base/history.csv" "$out/$scene.csv" >/dev/null
}

# ensemble OUT RUNS OPTION...: into $work/$scene.OUT.csv, unless it is there
ensemble() {
  local stem
  stem=$(basename "$case" .toml)
  [[ -s $work/$scene.$1/$stem/ensemble.csv ]] ||
    "$gasjet" ensemble "$case" --runs "$2" --quiet --threads "$(nproc)" --out "$work/$scene.$1" "${@:3}" >/dev/null
  cp "$work/$scene.$1/$stem/ensemble.csv" "$work/$scene.$1.csv"
}

# scene_by_ensemble CASE: mean of the runs; fails unless 19 of 20 single runs with seeds of their own lie inside, and each of 4
# means of 16. One of a hundred may lie outside by chance.
scene_by_ensemble() {
  local seed inside=0 whole=0
  case=$1 made=", gasjet ensemble"
  ensemble means $runs
  ensemble halved $runs_halved --set time.safety=0.4
  awk -F, -v scene="$scene" -v file="$case" -v made="$made" -f scripts/reference_ensemble.awk \
    "$work/$scene.halved.csv" "$work/$scene.means.csv" >"$out/$scene.csv"
  for seed in {1001..1020}; do
    run seed membrane.perturbation=1e-4 membrane.perturbation_seed="$seed"
    if "$gasjet" compare "$work/$scene.seed/history.csv" "$out/$scene.csv" >/dev/null; then inside=$((inside + 1)); fi
  done
  for seed in 2001 2101 2201 2301; do
    ensemble "$seed" 16 --first-seed "$seed"
    if "$gasjet" compare "$work/$scene.$seed.csv" "$out/$scene.csv" >/dev/null; then whole=$((whole + 1)); fi
  done
  echo "$scene: $inside of 20 further runs are inside, and $whole of 4 means of 16"
  ((inside >= 19 && whole == 4))
}

# meshes [--initial FILE]: the case's mesh in both formats, by way of $work: a case may read the file that is written.
meshes() {
  "$gasjet" mesh case "$case" --out "$work/$scene.obj" "$@" >/dev/null
  "$gasjet" mesh case "$case" --out "$work/$scene.k" >/dev/null
  mv "$work/$scene".{obj,k} "$out"
}
finer="membrane.mesh.refine=2 time.step=6.25e-6" # of the same polyhedron, as programs are handed the mesh; the step by its bound

make_scene() {
  scene=$1 case='' exact='' made=''
  case $scene in
    tank_fill) scene_by_refinement cases/rigid_tank.toml 1 output.history_every=5e-4 "" tank_fill --times 0:0.1:1e-3 ;;
    two_gas_fill) scene_by_refinement $out/two_gas_fill.toml 1 "output.history_every=1.25e-4 time.gas_tolerance=1e-12" "" ;;
    tank_blowdown) scene_by_refinement cases/tank_blowdown.toml 2 output.history_every=5e-4 "" blowdown --times 0:0.35:1e-3 ;;
    # 2e-5 s halves the pieces of the path too, which are 3.9e-5 s
    piston_leak) scene_by_refinement cases/piston_leak.toml 4 "output.history_every=2e-5 time.gas_tolerance=1e-12" "" ;;
    sphere_vent) scene_by_refinement $out/sphere_vent.toml 1 time.step=1.25e-5 "$finer"; meshes ;;
    circular_membrane)
      awk -v shape=disc -v cells=8 -f scripts/reference_meshes.awk >$out/$scene.obj
      scene_by_refinement $out/circular_membrane.toml 1 time.step=1.25e-5 "$finer"
      meshes
      ;;
    plate_jet) scene_of_jet cases/plate_jet.toml 0.02 "" "target.rows=480 target.columns=480" ;;
    plate_jet_shadow)
      awk -v shape=baffle -v cells=10 -f scripts/reference_meshes.awk >$out/$scene.obj
      scene_of_jet $out/plate_jet_shadow.toml 0.002 time.step=1e-5 membrane.mesh.refine=2
      meshes
      ;;
    pendulum_swing) scene_by_refinement cases/pendulum_swing.toml 1 time.step=5e-4 "" pendulum_swing --times 0:2.5:0.01 ;;
    cushion_impact) # of this mesh: another one breathes, and is hit, at other phases
      scene_by_refinement $out/cushion_impact.toml 1 time.step=2.5e-6 ""
      meshes
      ;;
    passenger_jet)
      scene_by_ensemble cases/passenger_pendulum.toml
      # The shape at the start is that of a run which is in no mean.
      meshes --initial $out/passenger_initial.obj --set membrane.perturbation=1e-4 --set membrane.perturbation_seed=1001
      ;;
    passenger_no_jet) scene_by_ensemble cases/passenger_pendulum_no_jet.toml ;;
    passenger_sharp_jet) scene_by_ensemble cases/passenger_sharp.toml ;;
    passenger_sharp_no_jet) scene_by_ensemble cases/passenger_sharp_no_jet.toml ;;
    *)
      echo "reference_set.sh: no scene '$scene'" >&2
      exit 2
      ;;
  esac
  echo "$scene: $(grep -vc '^#' "$out/$scene.csv") rows, $(grep -v '^#' "$out/$scene.csv" | head -1 | tr , '\n' | grep -c '_band$') bands"
}

mkdir -p "$work"
for name in "${scenes[@]}"; do make_scene "$name"; done
# what the folder holds, and the cases beside it
(cd "$out" && { find . -type f ! -name SHA256SUMS ! -name README.md -printf '%P\n'; sed -n 's|^# case: cases/\([^/]*\)$|../\1|p' ./*.csv; } |
  LC_ALL=C sort -u | while IFS= read -r file; do [[ ! -e $file ]] || sha256sum "$file"; done >SHA256SUMS)
