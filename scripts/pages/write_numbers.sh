#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes each number that docs/numbers.tsv lists into its document, from the table that it comes from. Run it when a
# table was made anew, then read what `git diff` shows: a sentence may no longer hold with its new numbers.
# usage: scripts/pages/write_numbers.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=source_number.sh
source scripts/pages/source_number.sh

changed=0
while IFS=$'\t' read -r page pattern source row column scale format; do
  [[ -n $page && $page != \#* ]] || continue
  number=$(source_number "$source" "$row" "$column" "$scale" "$format")
  [[ $number =~ ^[-+]?[0-9.]+(e[-+]?[0-9]+)?$ ]] || { echo "$page: '$pattern': $source says '$number'" >&2; continue; }
  before=$(sed -nE "s@.*$pattern.*@\\1@p" "$page")
  [[ $before != "$number" ]] || continue
  PATTERN=$pattern NUMBER=$number perl -i -pe \
    'substr($_, $-[1], $+[1] - $-[1]) = $ENV{NUMBER} if /$ENV{PATTERN}/' "$page"
  changed=$((changed + 1))
  echo "$page: $before -> $number ($source, $row, $column)"
done <docs/numbers.tsv
echo "$changed numbers changed"
