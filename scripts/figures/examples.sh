#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the pages of docs/examples and keeps the pictures that their programs draw. Needs a build with bindings, gnuplot, and Debian's
# python3-scipy and python3-matplotlib.
# usage: scripts/figures/examples.sh [PAGE...]       names without .md, all by default
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
pages=("$@")
if ((!$#)); then mapfile -t pages < <(basename -s .md -a docs/examples/*.md | grep -vx README); fi
export MATPLOTLIBRC=$PWD/scripts/figures/examples.mplstyle SOURCE_DATE_EPOCH=0 MPLBACKEND=Agg
for page in "${pages[@]}"; do
  verification/rules/tutorial_test.sh "docs/examples/$page.md" "$PWD/build/gasjet" "$PWD" docs/examples
  ls docs/examples/"$page".[spg]*
done
