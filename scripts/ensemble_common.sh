# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Shared by the scripts that compare ensembles with and without jet (sourced, from the repository's top).

# shellcheck source-path=SCRIPTDIR source=charts/gnuplot_text.sh
source scripts/charts/gnuplot_text.sh
# shellcheck source-path=SCRIPTDIR source=charts/provenance.sh
source scripts/charts/provenance.sh

build_gasjet() {
  scripts/setup_debian12.sh
  cmake --preset release >/dev/null
  cmake --build --preset release --target gasjet -j "$(nproc)" >/dev/null
}

# contact_stiffness CASE: [N/m3], what the case's own mesh and share give.
contact_stiffness() {
  build/gasjet check "cases/$1.toml" | sed -n 's/^contact stiffness: \([^ ]*\).*/\1/p'
}

# ensemble_quantities CASE RUNS OPTION...: quantities.csv of the ensemble, run unless results/ has it.
ensemble_quantities() {
  local case=$1 runs=$2 folder code=0
  shift 2
  folder=results/ensembles/$case/$runs$(printf '_%s' "$@" | tr -c 'A-Za-z0-9.\n' '_')
  grep -qx 'status: done' "$folder/$case/gasjet.status" 2>/dev/null ||
    build/gasjet ensemble "cases/$case.toml" --runs "$runs" --threads "$(nproc)" --quiet --out "$folder" "$@" >"$folder.log" 2>&1 || code=$?
  ((code == 0 || code == 3)) || { cat "$folder.log" >&2; return 1; } # 3: some runs have failed, and are in no mean
  grep -v '^#' "$folder/$case/quantities.csv" | tail -n +2
}

# compare WITH WITHOUT: rows quantity, mean and standard error with jet, without, runs, difference, in standard errors,
# decided (more than 5 of them, at least 16 runs either side).
compare() {
  awk -F, 'NR == FNR { mean[$1] = $2; error[$1] = $3; runs[$1] = $6; next }
    $1 in mean {
      s = sqrt(error[$1] ^ 2 + $3 ^ 2); d = mean[$1] - $2; n = s > 0 ? (d < 0 ? -d : d) / s : 0
      fewest = runs[$1] < $6 ? runs[$1] : $6
      verdict = n > 5 && fewest >= 16 ? "yes" : "no"
      printf "%s,%.6g,%.3g,%.6g,%.3g,%d,%.6g,%.3g,%s\n", $1, mean[$1], error[$1], $2, $3, fewest, d, n, verdict
    }' "$1" "$2"
}

# effects RUNS OPTION...: the jet's effect on the paper's scene under these options.
effects() {
  local with without
  mkdir -p results/ensembles/passenger_pendulum results/ensembles/passenger_pendulum_no_jet
  with=$(ensemble_quantities passenger_pendulum "$@")
  without=$(ensemble_quantities passenger_pendulum_no_jet "$@")
  compare <(echo "$with") <(echo "$without")
}
