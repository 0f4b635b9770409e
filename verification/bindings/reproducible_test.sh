#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes wheel and Debian packages twice, from copies of the tree in folders of other names and depths, with other time zones, at other
# times: the bytes must be the same. Then installs the wheel, when both trees are gone, and tries it as pip_test.sh does.
# usage: reproducible_test.sh PYTHON BUILD      BUILD: has the program for comparison
set -euo pipefail
python=$1 build=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
"$python" -c "import ensurepip, venv" 2>/dev/null || { echo "SKIPPED: no python3-venv"; exit 77; }
command -v patchelf >/dev/null || { echo "SKIPPED: no patchelf"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export SOURCE_DATE_EPOCH=1700000000 CCACHE_DISABLE=1
unset PYTHONPATH LD_LIBRARY_PATH
"$python" -m venv --system-site-packages "$scratch/venv"

# make NAME FOLDER: wheel and packages, from a copy of the tree in that folder
make() {
  local out=$scratch/$1 tree=$2
  mkdir -p "$out" "$tree"
  tar -C "$here/../.." --exclude='./build*' --exclude=./results --exclude=./.git -c . | tar -C "$tree" -mx
  "$scratch/venv/bin/pip" wheel --no-build-isolation --no-index --no-deps --wheel-dir "$out" "$tree"
  cmake --build "$tree/build/wheel" --parallel "$(nproc)"
  (cd "$tree/build/wheel" && cpack -G DEB && mv packages/*.deb "$out")
  rm -rf "$tree"
}
make first "$scratch/a/gasjet"
(export TZ=Asia/Kolkata LC_ALL=C HOME=/nonexistent && make second "$scratch/b/of/another/depth/gasjet-2")

(cd "$scratch/first" && sha256sum ./*) | tee "$scratch/sums"
(($(wc -l <"$scratch/sums") > 5)) || { echo "FAILED: too few files"; exit 1; }
(cd "$scratch/second" && sha256sum --quiet --strict -c "$scratch/sums") || { echo "FAILED: the bytes differ"; exit 1; }
"$here/pip_test.sh" "$scratch"/first/*.whl "$python" "$build"
