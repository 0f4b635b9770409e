#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Which part of the bag makes the contact impulse of the paper's scene without jet move with the mesh: ensembles with one part
# of the bag refined at a time, contact as stiff as before. Writes OUT.csv.
# usage: scripts/charts/mesh_parts.sh [RUNS] [OUT]      (8 runs, docs/charts/mesh_parts by default)
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
runs=${1:-8} out=${2:-docs/charts/mesh_parts}
scripts/setup_debian12.sh python3
cmake --preset release >/dev/null
cmake --build --preset release --target gasjet -j "$(nproc)" >/dev/null
name=passenger_pendulum_no_jet work=results/mesh_parts
stiffness=$(build/gasjet check "cases/$name.toml" | sed -n 's/^contact stiffness: \([^ ]*\).*/\1/p') # [N/m3]
mkdir -p "$work"
build/gasjet mesh case "cases/$name.toml" --initial "$work/initial.obj" --out "$work/design.obj" >/dev/null

# The generator's straps, which a mesh from a file has to be told; stiffness and length are the case's.
mapfile -t straps < <(build/gasjet check "cases/$name.toml" | sed -n 's/^strap [0-9]*: //p')
with_straps() {
  awk -v first="${straps[0]}" -v second="${straps[1]}" '{ print }
    /^\[\[membrane.strap\]\]/ { ends = n++ ? second : first; sub(/, to/, "\nto", ends); print ends }'
}

{
  provenance
  echo "part,elements,contact_impulse_Ns,standard_error_Ns,final_angle_rad,standard_error_rad,runs"
  for part in none front rest main,attachment side_left,side_right all; do
    label=${part//,/+}
    python3 scripts/charts/refine_part.py "$work"/{design,initial}.obj "$work/$label"_{design,initial}.obj "$part"
    sed -e "s/^mesh = .*/mesh = { file = \"${label}_design.obj\", initial_file = \"${label}_initial.obj\" }/" -e '/^flatten/d' \
      "cases/$name.toml" | with_straps >"$work/$label.toml"
    build/gasjet ensemble "$work/$label.toml" --runs "$runs" --threads "$(nproc)" --quiet --out "$work/$label" \
      --set "contact={stiffness=$stiffness}" >/dev/null
    awk -F, -v part="$label" -v elements="$(grep -c '^f' "$work/${label}_design.obj")" '{ mean[$1] = $2; error[$1] = $3; runs = $6 }
      END { printf "%s,%d,%.6g,%.3g,%.6g,%.3g,%d\n", part, elements, mean["contact_impulse_Ns"], error["contact_impulse_Ns"],
            mean["final_angle_rad"], error["final_angle_rad"], runs }' "$work/$label"/*/quantities.csv
  done
} >"$out.csv"
