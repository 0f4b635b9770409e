# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# An empty Debian 12 in a folder of its own (sourced by scripts that try things there). Needs root, network and debootstrap
# (installed if missing). environment: DEBIAN_MIRROR, where debootstrap takes packages from (its own default)

# make_root FOLDER: Debian's minimal base in that folder
make_root() {
  if ((EUID != 0)); then
    echo "$(basename "$0"): debootstrap and chroot need root; run it as root or with sudo" >&2
    exit 2
  fi
  command -v debootstrap >/dev/null || "$(dirname "${BASH_SOURCE[0]}")/../setup_debian12.sh" debootstrap
  chmod 755 "$1"
  debootstrap --variant=minbase bookworm "$1" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"} >"$1.log" 2>&1 ||
    { tail -n 20 "$1.log" >&2; exit 1; }
  rm -f "$1.log"
}

# in_root FOLDER COMMANDS: runs them by bash in that root. The mounts live in a namespace of their own and end with it, so that
# removing the root cannot reach the machine's devices.
in_root() {
  unshare --mount --pid --fork --kill-child bash -euo pipefail -c '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    exec env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 CI="${CI:-}" \
      chroot "$1" bash -euo pipefail -c "$2"' bash "$1" "$2" </dev/null
}
