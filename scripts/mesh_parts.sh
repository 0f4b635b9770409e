#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Which part of the bag makes the contact impulse of the paper's scene without jet move with the mesh: ensembles with one part
# of the bag refined at a time, contact as stiff as before. Writes OUT.csv.
# usage: scripts/mesh_parts.sh [RUNS] [OUT]      (8 runs, docs/charts/mesh_parts by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=ensemble_common.sh
source scripts/ensemble_common.sh
runs=${1:-8} out=${2:-docs/charts/mesh_parts}
build_gasjet
name=passenger_pendulum_no_jet work=results/mesh_parts
stiffness=$(build/gasjet check "cases/$name.toml" | sed -n 's/^contact stiffness: \([^ ]*\).*/\1/p')
mkdir -p "$work"
build/gasjet mesh case "cases/$name.toml" --initial "$work/initial.obj" --out "$work/design.obj" >/dev/null

# The generator's straps, which a mesh from a file has to be told: [m] of the design shape.
strap() { echo "from=[0.0,0.0,$1], to=[0.68,0.0,$1], stiffness=4500.0, free_length=0.62"; }

{
  echo "part,elements,contact_impulse_Ns,standard_error_Ns,final_angle_rad,standard_error_rad,runs"
  for part in none front rest main,attachment side_left,side_right all; do
    label=${part//,/+}
    python3 scripts/refine_part.py "$work"/{design,initial}.obj "$work/$label"_{design,initial}.obj "$part"
    sed -e "s/^mesh = .*/mesh = { file = \"${label}_design.obj\", initial_file = \"${label}_initial.obj\" }/" -e '/^flatten/d' \
      -e '/^\[\[membrane.strap/,/^\[pendulum/{/^\[pendulum/!d}' -e "s/^\[membrane\]/&\nstrap = [{$(strap 0.0740781698089253)}, {$(strap -0.0740781698089253)}]/" \
      "cases/$name.toml" >"$work/$label.toml"
    build/gasjet ensemble "$work/$label.toml" --runs "$runs" --threads "$(nproc)" --quiet --out "$work/$label" \
      --set "contact={stiffness=$stiffness}" >/dev/null
    awk -F, -v part="$label" -v elements="$(grep -c '^f' "$work/${label}_design.obj")" '{ mean[$1] = $2; error[$1] = $3; runs = $6 }
      END { printf "%s,%d,%.6g,%.3g,%.6g,%.3g,%d\n", part, elements, mean["contact_impulse_Ns"], error["contact_impulse_Ns"],
            mean["final_angle_rad"], error["final_angle_rad"], runs }' "$work/$label"/*/quantities.csv
  done
} >"$out.csv"
