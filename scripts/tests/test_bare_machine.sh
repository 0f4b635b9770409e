#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs README's two commands as on a fresh Debian 12 machine: a clone of HEAD in an empty root made by debootstrap,
# in which nothing is installed but what Debian's minimal base has. Run it before a release: a machine on which somebody worked hides
# missing packages. Needs root, network and debootstrap (installed if missing).
# usage: scripts/tests/test_bare_machine.sh [--keep] [COMMAND...]
#   --keep    leave the root behind and say where
#   COMMAND   to run in the clone instead of `scripts/run_main_case.sh && scripts/test_all.sh`
# environment: DEBIAN_MIRROR, where debootstrap takes packages from (its own default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source=debian_root.sh
source scripts/tests/debian_root.sh

keep=0
if [[ ${1:-} == --keep ]]; then
  keep=1
  shift
fi
command="scripts/run_main_case.sh && scripts/test_all.sh"
if (($#)); then command=$(printf '%q ' "$@"); fi
root=$(mktemp -d)
cleanup() {
  if ((keep)); then echo "kept: $root"; else rm -rf "$root"; fi
}
trap cleanup EXIT
start=$SECONDS
make_root "$root"
git clone -q . "$root/gasjet"
chown -R root: "$root/gasjet"
echo "=== empty Debian 12 root with a clone of $(git rev-parse --short HEAD): $((SECONDS - start)) s"

in_root "$root" "cd /gasjet && $command"
