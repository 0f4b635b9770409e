#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the sh blocks of a tutorial in order, in one scratch folder; each line of a text block has to be in what the block
# before it printed. usage: tutorial_test.sh TUTORIAL GASJET SOURCE_DIR [FOLDER]
# FOLDER: where the pictures go that the blocks draw.
set -euo pipefail
tutorial=$1
program=$2
export GASJET=$3
pictures=${4:+$(realpath "$4")}
BUILD=$(dirname "$program")
export BUILD
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/blocks" "$scratch/bin" "$scratch/work"
ln -s "$program" "$scratch/bin/gasjet"
export PATH=$scratch/bin:$PATH

awk -v folder="$scratch/blocks" '
  /^```/ && inside { inside = 0; next }
  /^```(sh|text)$/ { inside = 1; file = sprintf("%s/%03d.%s", folder, ++n, substr($0, 4)); next }
  inside { print >file }' "$tutorial"

cd "$scratch/work"
ran=0 shown=0
for block in "$scratch"/blocks/*; do
  if [[ $block == *.sh ]]; then
    bash -euo pipefail "$block" >"$scratch/output" 2>&1 </dev/null || { cat "$block" "$scratch/output"; echo "this block fails"; exit 1; }
    ran=$((ran + 1))
  else
    while IFS= read -r line; do
      grep -qF -- "$line" "$scratch/output" || { cat "$scratch/output"; echo "not printed: $line"; exit 1; }
      shown=$((shown + 1))
    done <"$block"
  fi
done
((ran && shown)) || { echo "$tutorial: no commands, or nothing shown of what they print"; exit 1; }
[[ -z $pictures ]] || find . -maxdepth 1 -regex '.*\.\(svg\|png\|gif\)' -exec cp {} "$pictures" \;
echo "$tutorial: $ran blocks run, $shown lines as shown"
