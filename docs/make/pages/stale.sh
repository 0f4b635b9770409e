#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Lists the CSV files, with their tables, and the figures that are older than the code that they depend on (docs/provenance.tsv).
# A file is as old as the commit that its head names, or, if it names none, as the commit that last changed it. One that is
# made from another listed file is older if rows of that have changed since the commit that last changed it.
# usage: docs/make/pages/stale.sh [TREE]      exit code 1 if there are any
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../../..}"
list=docs/provenance.tsv

# paths_of TEXT: its words, one a line, those with @ replaced by the paths of their own line.
paths_of() {
  local word
  local -a words
  read -ra words <<<"$1"
  for word in "${words[@]}"; do
    if [[ $word == @* ]]; then paths_of "$(awk -F'\t' -v name="$word" '$1 == name { print $3 }' "$list")"; else echo "$word"; fi
  done
}

# tables_of FILE: the tables of docs/tables.tsv with numbers from it.
tables_of() {
  awk -F'\t' -v file="$1" '
    $1 == "table" { name = $2 }
    index($0, file) && !(name in seen) { seen[name]; text = text " " name }
    END { if (text) print " (tables" text ")" }' docs/tables.tsv
}

# made_at FILE: the commit that it names.
made_at() { grep -aom 1 -E '(# commit: |gasjet [^ ]+ \()[0-9a-f]{7,}' "$1" | sed 's/.*[ (]//' || true; }

# rows_at COMMIT FILE: without the lines that say what it was made on and by.
rows_at() { git show "$1:$2" 2>/dev/null | grep -v '^#' || true; }

# newer_than FILE SCRIPT PATH...: the commits and the results that it lacks, one a line.
newer_than() {
  local file=$1 made committed path code=()
  committed=$(git log -1 --format=%h -- "$file")
  made=$(made_at "$file")
  [[ -z $made ]] || code+=("$2") # without a commit in its head it may have been made anew with the same bytes
  made=${made:-$committed}
  git cat-file -e "$made^{commit}" 2>/dev/null || { echo "its commit $made is not in this clone"; return; }
  for path in "${@:3}"; do
    if cut -f1 "$list" | grep -qxF -- "$path"; then
      cmp -s <(rows_at "$committed" "$path") <(rows_at HEAD "$path") || echo "$path has other rows since $committed"
    else
      code+=("$path")
    fi
  done
  ((${#code[@]} == 0)) || git log --no-merges --format='%h %s' "$made..HEAD" -- "${code[@]}" ':(exclude)*.md'
}

old=0
while IFS=$'\t' read -r file script paths; do
  [[ $file == [!#@]* ]] || continue
  mapfile -t on < <(paths_of "$paths")
  newer=$(newer_than "$file" "$script" "${on[@]}")
  [[ -n $newer ]] || continue
  old=$((old + 1))
  echo "$file$(tables_of "$file"): changes since: $(wc -l <<<"$newer"), the last: $(head -n 1 <<<"$newer" | cut -c 1-80)"
done <"$list"
echo "$old files are older than the code that they depend on"
((old == 0))
