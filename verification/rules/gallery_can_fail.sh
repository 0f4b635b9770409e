#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Proves that docs/make/pages/gallery.sh --check fails, and names the place, where the page lacks a case, says something else than its file,
# or lacks a picture. usage: gallery_can_fail.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fresh() {
  rm -rf "${scratch:?}"/*
  (cd "$root" && cp --parents -r docs/make/pages/gallery.sh cases docs/gallery docs/gallery.md "$scratch")
}

# refuses WHAT: the check fails, and its report says WHAT.
refuses() {
  if "$scratch/docs/make/pages/gallery.sh" --check >"$scratch/log" 2>&1; then
    echo "let pass: $1"
    exit 1
  fi
  grep -qF -e "$1" "$scratch/log" || { echo "failed, but not by: $1"; cat "$scratch/log"; exit 1; }
}

fresh
cp "$scratch/cases/rigid_tank.toml" "$scratch/cases/new_tank.toml"
refuses '> ## [new_tank](../cases/new_tank.toml)'
fresh
sed -i '2s/.*/# Another tank./' "$scratch/cases/rigid_tank.toml"
refuses '> Another tank.'
fresh
rm "$scratch/docs/gallery/driver_bag.png"
refuses 'docs/gallery.md: no picture docs/gallery/driver_bag.png'
