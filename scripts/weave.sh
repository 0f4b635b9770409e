#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What the weave does: the driver bag of woven and of isotropic fabric on two meshes, docs/charts/weave.csv.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=charts/provenance.sh
source scripts/charts/provenance.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Fabrics: name and options. Isotropic: a weft as the warp, and the shear modulus E/(2 (1 + nu)).
fabrics() {
  cat <<'TABLE'
woven
isotropic 60 MPa|--set fabric.weave.young_modulus_weft=60e6 --set fabric.weave.shear_modulus=23.076923e6
isotropic 52 MPa|--set fabric.young_modulus=51.961524e6 --set fabric.weave.young_modulus_weft=51.961524e6 --set fabric.weave.shear_modulus=19.985202e6
TABLE
}

peak() { sed -nE "s/^ *\"$1\": ([-+.e0-9]+),?$/\1/p" "$work/run/summary.json" | tail -n 1; }

{
  provenance
  echo "fabric,refine,peak_overpressure_Pa,peak_volume_m3,peak_strap_force_N"
  while IFS='|' read -r name options; do
    for refine in 0 1; do
      # shellcheck disable=SC2086  # options are words
      build/gasjet run cases/driver_bag.toml --quiet --out "$work/run" --set membrane.mesh.refine=$refine $options
      awk -F, -v name="$name,$refine" -v pressure="$(peak pressure_Pa)" -v volume="$(peak volume_m3)" '
        /^#/ { next }
        !head { head = 1; for (i = 1; i <= NF; ++i) at[$i] = i; next }
        ambient == "" { ambient = $(at["pressure_Pa"]) }  # the gas starts at it
        { if ($(at["strap_force_N"]) > most) most = $(at["strap_force_N"]) }
        END { printf "%s,%.6g,%.6g,%.6g\n", name, pressure - ambient, volume, most }' "$work/run/history.csv"
    done
  done < <(fabrics)
} >"$work/weave.csv"
cp "$work/weave.csv" docs/charts/weave.csv
tail -n +2 docs/charts/weave.csv
