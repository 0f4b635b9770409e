#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the sh blocks of tutorials in order, as a reader does: in one shell, which begins in a clone with the block of
# docs/tutorials/README.md. Each line of a text block has to be a line that the block before it printed; `...` in it stands
# for any characters.
# usage: tutorial_test.sh TUTORIALS GASJET SOURCE_DIR [FOLDER]
# TUTORIALS: one or several, blanks between them. FOLDER: where the pictures go that the blocks draw.
set -euo pipefail
read -ra tutorials <<<"$1"
build=$(dirname "$2")
source=$3
pictures=${4:+$(realpath "$4")}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/blocks" "$scratch/clone"
for file in "$source"/*; do [[ $file == */build* ]] || ln -s "$file" "$scratch/clone"; done
ln -s "$build" "$scratch/clone/build"

awk -v folder="$scratch/blocks" '
  /^```/ && inside { inside = 0; next }
  /^```(sh|text)$/ { inside = 1; file = sprintf("%s/%03d.%s", folder, ++n, substr($0, 4)); next }
  inside { print >file }' "$source/docs/tutorials/README.md" "${tutorials[@]}"

# shellcheck disable=SC2016 # the inner shell expands these
(cd "$scratch/clone" && bash -euo pipefail -c '
  for block; do
    [[ $block == *.sh ]] || continue
    . "$block" >"$block.output" 2>&1 </dev/null
  done
' bash "$scratch"/blocks/*) || {
  last=$(find "$scratch/blocks" -name '*.output' | sort | tail -1)
  cat "${last%.output}" "$last"
  echo "this block fails"
  exit 1
}

ran=0 shown=0
for block in "$scratch"/blocks/*; do
  case $block in
    *.sh) output=$block.output ran=$((ran + 1)) ;;
    *.text)
      while IFS= read -r line; do
        pattern=$(sed 's/[][\\.*^$+?(){}|]/\\&/g; s/\\\.\\\.\\\./.*/g' <<<"$line")
        grep -qxE -- "$pattern" "$output" || { cat "$output"; echo "not printed: $line"; exit 1; }
        shown=$((shown + 1))
      done <"$block"
      ;;
  esac
done
((ran > 1 && shown)) || { echo "$1: no commands, or nothing shown of what they print"; exit 1; }
[[ -z $pictures ]] || find "$scratch/tutorials" -maxdepth 1 -regex '.*\.\(svg\|png\|gif\)' -exec cp {} "$pictures" \;
echo "$1: $ran blocks run, $shown lines as shown"
