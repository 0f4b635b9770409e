#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs README's two commands as on a fresh Debian 12 machine: a clone of HEAD in an empty root made by debootstrap,
# in which nothing is installed but what Debian's minimal base has. Run it before a release: a machine on which somebody worked hides
# missing packages. Needs root, network and debootstrap (installed if missing).
# usage: scripts/test_bare_machine.sh [--keep] [COMMAND...]
#   --keep    leave the root behind and say where
#   COMMAND   to run in the clone instead of `scripts/run_main_case.sh && scripts/test_all.sh`
# environment: DEBIAN_MIRROR, where debootstrap takes packages from (its own default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

keep=0
if [[ ${1:-} == --keep ]]; then
  keep=1
  shift
fi
command="scripts/run_main_case.sh && scripts/test_all.sh"
if (($#)); then command=$(printf '%q ' "$@"); fi
if ((EUID != 0)); then
  echo "test_bare_machine.sh: debootstrap and chroot need root; run it as root or with sudo" >&2
  exit 2
fi
command -v debootstrap >/dev/null || scripts/setup_debian12.sh debootstrap

root=$(mktemp -d)
cleanup() {
  if ((keep)); then echo "kept: $root"; else rm -rf "$root"; fi
}
trap cleanup EXIT
chmod 755 "$root"
start=$SECONDS
debootstrap --variant=minbase bookworm "$root" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"} >"$root.log" 2>&1 ||
  { tail -n 20 "$root.log" >&2; exit 1; }
rm -f "$root.log"
git clone -q . "$root/gasjet"
chown -R root: "$root/gasjet"
echo "=== empty Debian 12 root with a clone of $(git rev-parse --short HEAD): $((SECONDS - start)) s"

# The mounts live in a namespace of their own and end with it, so that removing the root cannot reach the machine's devices.
unshare --mount --pid --fork --kill-child bash -euo pipefail -c '
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
  exec env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 CI="${CI:-}" \
    chroot "$1" bash -euo pipefail -c "cd /gasjet && $2"' bash "$root" "$command" </dev/null
