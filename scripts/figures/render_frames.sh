#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Draws the paper's scene with and without jet at the same times, as its Figures 10 and 11 do, in
# docs/figures/frames.jpg. VTK draws, on a display in memory.
# usage: scripts/figures/render_frames.sh [TIME_MS...]      (5 10 20 30 50 90 by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

times=("$@")
(($#)) || times=(5 10 20 30 50 90)
scripts/setup_debian12.sh python3-vtk9 xvfb xauth libgl1-mesa-dri
cmake --preset release >/dev/null
cmake --build --preset release --target gasjet -j "$(nproc)" >/dev/null
cases=(passenger_pendulum passenger_pendulum_no_jet)
for case in "${cases[@]}"; do
  build/gasjet run "cases/$case.toml" --out "results/frames/$case" --quiet --set output.fields_every=5e-3
done
xvfb-run -a -s "-screen 0 1600x1200x24" /usr/bin/python3 -B scripts/figures/render_frames.py docs/figures/frames.jpg \
  "with jet=results/frames/${cases[0]}" "without jet=results/frames/${cases[1]}" "${times[@]}"
echo docs/figures/frames.jpg
