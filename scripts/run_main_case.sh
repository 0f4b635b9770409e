#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets up the machine, builds the release preset and runs the passenger-bag pendulum case.
# usage: scripts/run_main_case.sh [options of `gasjet run`, such as --threads 2]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case_name=passenger_pendulum
results=results/$case_name

scripts/setup_debian12.sh
cmake --preset release
cmake --build --preset release --target gasjet
build/gasjet run "cases/$case_name.toml" --out "$results" "$@"
cat "$results/summary.json"
echo
echo "Results: $results/history.csv, energy.csv, summary.json"
echo "Plot:    scripts/plot.py history $results/plot $results"
