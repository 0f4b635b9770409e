# SPDX-License-Identifier: Apache-2.0
# Numbers out of CSV files and out of the tables of pages (used by write_tables.awk, write.sh and rules.sh).
#
# formatted(FILE, ROW, COLUMN, FACTOR, FORMAT): that number as text; where there is none, why, which `failed` then says too.
#   ROW     column=value,... that fits exactly one row; in a page one pair. Of a CSV also two such rows, "A - B", "A / B" or
#           "A % B" (A/B - 1), or three that halve a length, "A ~ B ~ C" (the order that they show) or "A > B > C" (their limit by it).
#   COLUMN  its name, names joined by + (their sum), or "one/other"
#   FACTOR  numbers and names joined by * and /; names are pi, reference (what a ladder's table says above its columns, from where
#           the quantity counts) and root_runs (of the row's column `runs`)
#   FORMAT  of printf; %s gives the column as it is written

function failure(why) { failed = why; return 0 }

function load(file,   line, before, is_page, n, name, i, head) {
  if (file in rows_of) return
  rows_of[file] = 0
  is_page = file ~ /[.]md$/
  separator[file] = is_page ? " *[|] *" : ","
  while ((getline line < file) > 0) {
    if (line ~ /^# reference: /) reference[file] = substr(line, 14) + 0
    if (line ~ /^# counted from: /) zero[file] = substr(line, 17) + 0
    if (line ~ /^# (commit: |gasjet [^ ]+ [(])/ && !(file in commit_of)) {
      commit_of[file] = line
      gsub(/^# (commit: |gasjet [^ ]+ [(])|,.*/, "", commit_of[file])
    }
    if (line ~ /^#/) continue
    if (is_page ? line ~ /^[|]-/ : !head) {
      ++head
      n = split(is_page ? before : line, name, separator[file])
      for (i = 1; i <= n; ++i) at[file, head, name[i]] = i
      if (!is_page) continue
    }
    before = line
    if (head) { row_text[file, ++rows_of[file]] = line; head_of[file, rows_of[file]] = head }
  }
  close(file)
}

# find(FILE, WANTED, CELL): splits the only row that fits into CELL and returns its head; 0 with `found` rows otherwise.
function find(file, wanted, cell,   n, want, i, k, sign, fits, row) {
  if (separator[file] == ",") n = split(wanted, want, ","); else { n = 1; want[1] = wanted }
  found = 0
  for (k = 1; k <= rows_of[file]; ++k) {
    split(row_text[file, k], cell, separator[file])
    fits = 1
    for (i = 1; i <= n && fits; ++i) {
      sign = index(want[i], "=")
      fits = ((file, head_of[file, k], substr(want[i], 1, sign - 1)) in at) && \
        cell[at[file, head_of[file, k], substr(want[i], 1, sign - 1)]] == substr(want[i], sign + 1)
    }
    if (fits) { ++found; row = k }
  }
  split(row_text[file, row], cell, separator[file])
  return found == 1 ? head_of[file, row] : 0
}

function is_number(text) { return text ~ /^[-+]?[0-9.]+(e[-+]?[0-9]+)?( |$)/ }

function sum_of(file, head, cell, names,   n, name, i, sum) {
  n = split(names, name, "+")
  for (i = 1; i <= n; ++i) {
    if (!((file, head, name[i]) in at)) return failure("no column " name[i])
    if (!is_number(cell[at[file, head, name[i]]])) return failure("no number in column " name[i])
    sum += cell[at[file, head, name[i]]]
  }
  return sum
}

function factor_of(file, name) {
  if (name == "pi") return 3.141592653589793
  if (name == "reference") return reference[file] > zero[file] ? reference[file] - zero[file] : zero[file] - reference[file]
  if (name == "root_runs") return sqrt(runs)
  return is_number(name) ? name + 0 : failure("no factor " name)
}

function product(file, text,   result, i, n, name) {
  n = split(text, name, "[*/]")
  result = factor_of(file, name[1])
  for (i = 2; i <= n; ++i) {
    text = substr(text, length(name[i - 1]) + 1)
    result = text ~ /^[*]/ ? result * factor_of(file, name[i]) : result / factor_of(file, name[i])
    text = substr(text, 2)
  }
  return result
}

function of_three(how, a, b, c,   first, second) {
  first = a - b
  second = b - c
  return how == "~" ? log(first / second) / log(2) : c - second * second / (first - second)
}

# value_of(FILE, ROW, COLUMN): of one row
function value_of(file, row, column,   head, cell, over, value) {
  head = find(file, row, cell)
  if (!head) return failure(found " rows " row)
  runs = ((file, head, "runs") in at) ? cell[at[file, head, "runs"]] : 0
  over = index(column, "/")
  value = sum_of(file, head, cell, over ? substr(column, 1, over - 1) : column)
  return over && !failed ? value / sum_of(file, head, cell, substr(column, over + 1)) : value
}

function text_of(file, row, column,   head, cell) {
  head = find(file, row, cell)
  if (!head) return failure(found " rows " row)
  return (file, head, column) in at ? cell[at[file, head, column]] : failure("no column " column)
}

function formatted(file, row, column, factor, format,   i, n, part, value, how, result) {
  load(file)
  failed = ""
  if (format !~ /^%([+]?([.][0-9]+)?[defg]|s)$/) return failed = "no format " format
  if (format == "%s") {
    result = text_of(file, row, column)
    return failed ? failed : result
  }
  n = split(row, part, separator[file] == "," ? " [-/%~>] " : "\n")
  how = n > 1 ? substr(row, length(part[1]) + 2, 1) : ""
  for (i = 1; i <= n; ++i) {
    value[i] = value_of(file, part[i], column)
    if (failed) return failed
  }
  result = n == 3 ? of_three(how, value[1], value[2], value[3]) : how == "-" ? value[1] - value[2] : \
    how == "/" ? value[1] / value[2] : how == "%" ? value[1] / value[2] - 1 : value[1]
  result *= product(file, factor)
  return failed ? failed : sprintf(format, result)
}
