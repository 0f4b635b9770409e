#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the wheel in an empty Debian 12 that has python3-venv and python3-numpy and no development package, and uses it there: no file
# of a build or a clone can help. Needs root, network and debootstrap.
# usage: wheel_in_empty_debian_test.sh PYTHON BUILD      BUILD: what is compiled already
set -euo pipefail
python=$1 build=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$here/../.." && pwd)
for tool in debootstrap patchelf; do
  command -v "$tool" >/dev/null || { echo "SKIPPED: no $tool"; exit 77; }
done
((EUID == 0)) || { echo "SKIPPED: chroot needs root"; exit 77; }
# shellcheck source=../../scripts/tests/debian_root.sh
source "$source/scripts/tests/debian_root.sh"
root=$(mktemp -d)
trap 'rm -rf "$root" "$root.wheel"' EXIT

"$python" -m venv --system-site-packages "$root.wheel"
"$root.wheel/bin/pip" wheel --no-build-isolation --no-index --no-deps --config-settings build-dir="$build" --wheel-dir "$root.wheel" "$source"
make_root "$root"
mkdir "$root/try"
cp "$root.wheel"/*.whl "$here/wheel_user.py" "$source/verification/rules/outside/consumer.py" "$root/try"
in_root "$root" 'cd /try
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -q >/dev/null
  apt-get install -q -y --no-install-recommends python3-venv python3-numpy >/dev/null
  if dpkg-query -W -f "\${Package}\n" | grep -E -- "-dev$|^(gcc|g\+\+|cmake|git|patchelf)$"; then
    echo "FAILED: the root is not empty"
    exit 1
  fi
  python3 -m venv --system-site-packages venv
  venv/bin/pip install --no-index ./*.whl
  venv/bin/pip check
  export PATH=/try/venv/bin:$PATH
  gasjet --version
  python consumer.py
  python wheel_user.py'
