#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Python package by pip in an environment of its own, without a network, and runs a case there to the bits of the command.
# usage: pip_test.sh build|clone PYTHON BUILD      build: takes what BUILD has compiled; clone: compiles a copy of the tree
set -euo pipefail
from=$1 python=$2 build=$3
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
"$python" -c "import ensurepip, venv" 2>/dev/null || { echo "SKIPPED: no python3-venv"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

options=(--no-build-isolation --no-index --disable-pip-version-check)
tree=$source
if [[ $from == build ]]; then
  options+=(--config-settings build-dir="$build")
else
  tree=$scratch/tree
  mkdir "$tree"
  tar -C "$source" --exclude='./build*' --exclude=./results --exclude=./.git -c . | tar -C "$tree" -x
fi
"$python" -m venv --system-site-packages "$scratch/venv"
cd "$scratch"
unset PYTHONPATH LD_LIBRARY_PATH
venv/bin/pip install "${options[@]}" "$tree"
rm -rf "$scratch/tree"

module=$(venv/bin/python -c "import gasjet; print(gasjet._gasjet.__file__)")
[[ $module == "$scratch"/venv/* ]] || { echo "FAILED: $module is not what pip installed"; exit 1; }
for file in "$(dirname "$module")"/_*.so; do
  ldd "$file" >ldd.txt
  if grep -E 'not found|libgasjet' ldd.txt | grep -vF "$scratch/venv/"; then
    echo "FAILED: $file does not take the libraries beside it"
    exit 1
  fi
done
export GASJET=$build/gasjet GASJET_SOURCE_DIR=$source PYTHONDONTWRITEBYTECODE=1
for test in Runs.test_run_has_the_bits_of_the_command ClosedForms.test_exact_and_catalogue; do
  PYTHONPATH=$source/verification/bindings venv/bin/python -m unittest "python_test.$test"
done
venv/bin/pip --disable-pip-version-check uninstall -y gasjet
[[ ! -e $module ]] || { echo "FAILED: pip does not remove all that it installed"; exit 1; }
