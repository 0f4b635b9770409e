# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by write_numbers.sh: what a row of docs/numbers.tsv says that its document has to say.
csv_number=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/csv_number.awk

# source_number FILE ROW COLUMN FACTOR FORMAT: that number, formatted (scripts/pages/csv_number.awk says how rows and columns are named).
source_number() {
  awk -f "$csv_number" -f <(echo 'BEGIN { print formatted(ARGV[1], ARGV[2], ARGV[3], ARGV[4], ARGV[5]) }') "$@"
}
