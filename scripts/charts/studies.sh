#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs plans of cases/studies and writes their tables and charts. Runs that results/studies has are not computed again.
# usage: scripts/charts/studies.sh [--threads N] [--out FOLDER] [NAME...]      (1, docs/charts, all plans; GASJET names the program)
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=gnuplot_text.sh
source scripts/charts/gnuplot_text.sh
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
threads=1 out=docs/charts gasjet=${GASJET:-build/gasjet}
while [[ ${1:-} == --* ]]; do
  case $1 in
    --threads | --out) declare "${1#--}=${2:?studies.sh: $1 needs a value}" ;;
    *) echo "studies.sh: unknown argument '$1'; allowed: --threads N, --out FOLDER, NAME..." >&2; exit 2 ;;
  esac
  shift 2
done
names=("$@")
((${#names[@]})) || mapfile -t names < <(basename -s .toml cases/studies/*.toml)
for name in "${names[@]}"; do
  [[ -f cases/studies/$name.toml ]] || { echo "studies.sh: no plan cases/studies/$name.toml" >&2; exit 2; }
done
[[ -x $gasjet ]] || { echo "studies.sh: $gasjet is missing: scripts/run_main_case.sh builds it" >&2; exit 2; }

# rows NAME FOLDER: the table of the study in FOLDER: its means, or what is made of them
rows() {
  case $1 in
    ensemble_convergence) awk -F, -v first=varied -f scripts/charts/jet_effects.awk "$2/means.csv" ;;
    jet_map) awk -F, -v first=input -f scripts/charts/jet_effects.awk "$2/means.csv" ;;
    impulse_limits | first_contact_seed | weave | runs_needed) awk -F, -f "scripts/charts/$1_rows.awk" "$2/means.csv" ;;
    coupled_work_precision) awk -F, -f "scripts/charts/$1_rows.awk" "$2"/{timing,means}.csv ;;
    what_to_measure) grep -v '^#' "$2/sobol.csv" ;;
    *) grep -v '^#' "$2/means.csv" ;;
  esac
}

# further NAME: tables that follow from that of NAME
further() {
  case $1 in
    impulse_limits) awk -F, -f scripts/charts/impulse_limits.awk "$out/$1.csv" >"$out/$1_fits.csv" ;;
    ensemble_convergence | first_contact_seed)
      [[ ! -f $out/ensemble_convergence.csv || ! -f $out/first_contact_seed.csv ]] ||
        awk -F, -f scripts/charts/mesh_limits.awk "$out"/{ensemble_convergence,first_contact_seed}.csv >"$out/mesh_limits.csv"
      ;;
  esac
}

mkdir -p "$out"
for name in "${names[@]}"; do
  folder=results/studies/$name
  "$gasjet" study run "cases/studies/$name.toml" --out "$folder" --threads "$threads" || [[ $? == 3 ]] # 3: some runs are in no mean
  { provenance; grep '^# status: ' "$folder/means.csv"; rows "$name" "$folder"; } >"$folder/table.csv.new"
  mv "$folder/table.csv.new" "$out/$name.csv"
  further "$name"
  [[ ! -f scripts/charts/$name.gp ]] ||
    gnuplot -e "data=$(gnuplot_file "$out/$name.csv"); out=$(gnuplot_file "$out/$name.svg")" "scripts/charts/$name.gp"
  echo "$out/$name.csv"
done
