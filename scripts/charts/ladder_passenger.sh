#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Ladders of the paper's scene for the pendulum's angle, each rung the mean of 16 runs: over all that the scene names
# (docs/charts/ladder_passenger.csv and .svg), and over its effects alone, on its own mesh (ladder_passenger_effects.csv). Some
# ten minutes of one core.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# ladder OPTION...: undecided is an answer too.
ladder() {
  local code=0
  build/gasjet ladder cases/passenger_pendulum.toml --quantity pendulum_angle --tolerance 10% --threads "$(nproc)" --out "$work" "$@" || code=$?
  ((code == 0 || code == 4))
}

ladder
cp "$work/ladder.csv" docs/charts/ladder_passenger.csv
gnuplot -e "data='docs/charts/ladder_passenger.csv'; out='docs/charts/ladder_passenger.svg'" scripts/charts/ladder_passenger.gp
ladder --hold mesh,pieces,step,gas
cp "$work/ladder.csv" docs/charts/ladder_passenger_effects.csv
