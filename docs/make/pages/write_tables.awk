# SPDX-License-Identifier: Apache-2.0
# A page with its tables written anew from docs/tables.tsv, which says how. After csv_number.awk. Faults go to standard error, with exit
# code 1.
# usage: awk -f docs/make/pages/csv_number.awk -f docs/make/pages/write_tables.awk -v page=PAGE PAGE

function fault(what) {
  print page ": table " name ": " what >"/dev/stderr"
  faulty = 1
}

# relative(FILE): the way to it from the page.
function relative(file,   here) {
  here = page
  while (index(here, "/") && substr(here, 1, index(here, "/")) == substr(file, 1, index(here, "/"))) {
    file = substr(file, index(here, "/") + 1)
    here = substr(here, index(here, "/") + 1)
  }
  while (sub(/^[^\/]*\//, "", here)) file = "../" file
  return file
}

function read_tables(   line, field, of) {
  while ((getline line < "docs/tables.tsv") > 0) {
    split(line, field, "\t")
    if (field[1] == "table") {
      name = of = field[2]
      if (of in csv) fault("named twice in docs/tables.tsv")
      csv[of] = field[3]
      cells = ""
    } else if (field[1] == "columns") columns[of] = substr(line, 9)
    else if (field[1] == "cells") cells = substr(line, 7)
    else if (field[1] == "row") { row[of, ++rows[of]] = substr(line, 5); cells_of[of, rows[of]] = cells }
    else if (line !~ /^(#.*)?$/) fault("docs/tables.tsv has a line of no kind: " line)
  }
}

# used(FILE): it belongs below the table.
function used(file) {
  if (index(files, "\n" file "\n") == 0) files = files file "\n"
  return file
}

# number_of(INSIDE): what `{INSIDE}` of a cell stands for.
function number_of(inside,   n, part, file, text) {
  n = split(inside, part, "|")
  if (n < 2) { fault("{" inside "}: ROW|COLUMN is needed"); return inside }
  if (++numbers <= formats) format = given_format[numbers]
  file = used(n > 3 ? part[4] : csv[name])
  text = formatted(file, part[1], part[2], n > 2 && part[3] != "" ? part[3] : factor, format)
  if (failed) fault("{" inside "} of " file ": " failed)
  return text
}

# filled(TEXT): with numbers in place of its {...}.
function filled(text,   start, stop, result) {
  while ((start = index(text, "{"))) {
    stop = index(text, "}")
    if (!stop) { fault("no } in " text); break }
    result = result substr(text, 1, start - 1) number_of(substr(text, start + 1, stop - start - 1))
    text = substr(text, stop + 1)
  }
  return result text
}

# with_key(TEXT, KEY): @1, @2, ... are the key's parts, @ is the key.
function with_key(text, key,   n, part, i) {
  n = split(key, part, "; ")
  for (i = 1; i <= n && n > 1; ++i) gsub("@" i, part[i], text)
  gsub(/@/, key, text)
  return text
}

function print_row(text, cells,   n, field, heading, i, cell, line) {
  if (split(text, field, "\t") != 4) { fault("row " field[1] ": label, key, factor and formats are needed"); return }
  factor = field[3]
  formats = split(field[4], given_format, " ")
  numbers = 0
  line = "| " field[1] " |"
  format = ""
  n = split(cells, cell, "\t")
  if (n + 1 != split(columns[name], heading, "\t")) fault("row " field[1] ": " n " cells behind its label, columns: " columns[name])
  for (i = 1; i <= n; ++i) line = line " " filled(with_key(cell[i], field[2])) " |"
  if (numbers < formats) fault("row " field[1] ": " formats " formats for " numbers " numbers")
  print line
}

# made_at(): the commits of the CSVs used, each with its files; a page says nothing of a commit: CI compares it with its tests.
function made_at(   n, file, i, commit, order, of, commits, pages, text) {
  n = split(substr(files, 2), file, "\n") - 1
  for (i = 1; i <= n; ++i) {
    commit = commit_of[file[i]]
    if (commit == "") { pages = pages (pages ? ", " : "Taken from ") link(file[i]); continue }
    if (!(commit in of)) order[++commits] = commit
    of[commit] = of[commit] (of[commit] ? ", " : "") link(file[i])
  }
  for (i = 1; i <= commits; ++i) text = text (i > 1 ? ", " : "Made at commit ") "`" order[i] "` (" of[order[i]] ")"
  return text (text && pages ? ". " : "") pages "."
}

function print_table(   n, heading, i, head, rule) {
  files = "\n"
  n = split(columns[name], heading, "\t")
  for (i = 1; i <= n; ++i) { head = head "| " heading[i] " "; rule = rule "|---" }
  gsub(/  +/, " ", head)
  print "\n" head "|\n" rule "|"
  for (i = 1; i <= rows[name]; ++i) print_row(row[name, i], cells_of[name, i])
  print "\n" made_at() "\n"
}

function link(file,   parts, part) {
  parts = split(file, part, "/")
  return "[" part[parts] "](" relative(file) ")"
}

BEGIN { read_tables() }
/^<!-- end of table / { inside = 0 }
!inside
/^<!-- table [a-z0-9_]+ -->$/ {
  if (inside) fault("no line <!-- end of table " name " -->")
  name = $3
  if (name in csv) print_table(); else fault("docs/tables.tsv has none of that name")
  inside = 1
}
END {
  if (inside) fault("no line <!-- end of table " name " -->")
  exit faulty
}
