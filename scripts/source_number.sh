# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by write_numbers.sh and by the rule that compares (verification/rules/rules.sh numbers): what a row of docs/numbers.tsv
# says that its document has to say.

# source_number FILE ROW COLUMN SCALE FORMAT: that number of a CSV table (comment lines aside) or of a table of a page,
# formatted. ROW: column=value,..., in a page one pair. Of a CSV also two rows, "A - B", "A / B" or "A % B" (A/B - 1), or three that halve
# a length, "A ~ B ~ C" (the order that they show) or "A > B > C" (their limit by that).
# COLUMN: its name, or "one/other". SCALE: numbers and names joined by * and /; names are pi, reference (what a ladder's table
# says above its columns, from where the quantity counts) and root_runs (of the row's column `runs`).
source_number() {
  local separator=,
  [[ $1 != *.md ]] || separator=' *[|] *'
  awk -F"$separator" -v row="$2" -v column="$3" -v scale="$4" -v format="$5" '
    function head(line,   i, n, name) { split("", at); n = split(line, name); for (i = 1; i <= n; ++i) at[name[i]] = i }
    function fits(wanted,   i, n, want, sign) {
      if (FS != ",") { n = 1; want[1] = wanted } else n = split(wanted, want)
      for (i = 1; i <= n; ++i) {
        sign = index(want[i], "=")
        if ($(at[substr(want[i], 1, sign - 1)]) != substr(want[i], sign + 1)) return 0
      }
      return 1
    }
    function factor(name) {
      if (name == "pi") return 3.141592653589793
      if (name == "reference") return reference > zero ? reference - zero : zero - reference
      return name == "root_runs" ? sqrt(runs) : name
    }
    function product(text,   result, i, n, name) {
      n = split(text, name, "[*/]")
      result = factor(name[1])
      for (i = 2; i <= n; ++i) {
        text = substr(text, length(name[i - 1]) + 1)
        result = text ~ /^[*]/ ? result * factor(name[i]) : result / factor(name[i])
        text = substr(text, 2)
      }
      return result
    }
    BEGIN {
      rows = split(row, part, FS == "," ? " [-/%~>] " : "\n")
      columns = split(column, ratio, "/")
      how = rows > 1 ? substr(row, length(part[1]) + 2, 1) : ""
    }
    /^# reference: / { reference = substr($0, 14) + 0 }
    /^# counted from: / { zero = substr($0, 17) + 0 }
    /^#/ { next }
    FS == "," && !started++ { head($0); next }
    /^[|]-/ { head(before) }
    { before = $0 }
    !(ratio[1] in at) || !(ratio[columns] in at) { next }
    { for (i = 1; i <= rows; ++i)
        if (fits(part[i])) { ++found[i]; runs = "runs" in at ? $(at["runs"]) : 0; value[i] = columns == 2 ? $(at[ratio[1]]) / $(at[ratio[2]]) : $(at[column]) } }
    function levels(   first, second) {
      first = value[1] - value[2]; second = value[2] - value[3]
      return how == "~" ? log(first / second) / log(2) : value[3] - second * second / (first - second)
    }
    END {
      for (i = 1; i <= rows; ++i) if (found[i] != 1) { print found[i] + 0 " rows " part[i]; exit }
      number = rows == 3 ? levels() : how == "-" ? value[1] - value[2] : how == "/" ? value[1] / value[2] : how == "%" ? value[1] / value[2] - 1 : value[1]
      printf format "\n", number * product(scale)
    }' "$1"
}
