#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Recomputes the README's figure and the table of the jet's effect: ensembles of the paper's scene with and without jet.
# usage: scripts/figures/jet_effect.sh [RUNS]      (32 by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=../charts/provenance.sh
source scripts/charts/provenance.sh
scripts/setup_debian12.sh
cmake --preset release >/dev/null
cmake --build --preset release --target gasjet -j "$(nproc)" >/dev/null
build/gasjet ensemble cases/passenger_pendulum.toml --against cases/passenger_pendulum_no_jet.toml \
  --runs "${1:-32}" --threads "$(nproc)" --out results/figures
mkdir -p docs/figures
{ provenance; cat results/figures/effects.csv; } >docs/figures/jet_effect.csv
scripts/plot_ensemble.sh --title 'The gas jet swings the pendulum more than twice as far' \
  --name 'with jet' --name 'without jet' results/figures/plot results/figures/passenger_pendulum results/figures/passenger_pendulum_no_jet
cp results/figures/plot.svg docs/figures/passenger_pendulum.svg
