#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Python package by pip in an environment of its own, without a network, and runs a case there to the bits of the command.
# usage: pip_test.sh build|WHEEL PYTHON BUILD      build: makes the wheel of what BUILD has compiled
set -euo pipefail
from=$1 python=$2 build=$3
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
"$python" -c "import ensurepip, venv" 2>/dev/null || { echo "SKIPPED: no python3-venv"; exit 77; }
command -v patchelf >/dev/null || { echo "SKIPPED: no patchelf"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $*" && exit 1; }

"$python" -m venv --system-site-packages "$scratch/venv"
cd "$scratch"
unset PYTHONPATH LD_LIBRARY_PATH
export PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1 PYTHONDONTWRITEBYTECODE=1

if [[ $from == build ]]; then
  venv/bin/pip wheel --no-build-isolation --no-deps --config-settings build-dir="$build" "$source"
  from=$(echo ./*.whl)
fi
(($(stat -c %s "$from") <= 15000000)) || fail "the wheel has $(stat -c %s "$from") bytes, allowed: 15 MB"
venv/bin/pip install "$from"

module=$(venv/bin/python -c "import gasjet; print(gasjet._gasjet.__file__)")
[[ $module == "$scratch"/venv/* ]] || fail "$module is not what pip installed"
package=$(dirname "$module")
outside='linux-vdso|ld-linux|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+)\.so'
for file in "$package"/*.so* "$package/gasjet"; do
  ldd "$file" >ldd.txt
  ! grep -vE "$outside" ldd.txt | grep -vF "$package/" || fail "$file does not take the libraries beside it"
done
export GASJET=$build/gasjet GASJET_SOURCE_DIR=$source
for test in Runs.test_run_has_the_bits_of_the_command ClosedForms.test_exact_and_catalogue; do
  PYTHONPATH=$source/verification/bindings venv/bin/python -m unittest "python_test.$test"
done
venv/bin/pip uninstall -y gasjet
[[ ! -e $module ]] || fail "pip does not remove all that it installed"
