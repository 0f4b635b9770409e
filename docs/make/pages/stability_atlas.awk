# SPDX-License-Identifier: Apache-2.0
# Threshold rows of verification/support/claim.cpp -> the tables of docs/stability.md. After theory_links.awk.
BEGIN {
  FS = "\t"
  letters = "GMJK"
  split("Gas|Membrane and time step|Jet|Contact and pendulum", titles, "|")
}

$1 != "threshold" { next }
{
  letter = substr($4, 1, 1)
  key = letter FS $7
  if (!(key in rows)) failures[letter, ++count[letter]] = key
  rows[key] = rows[key] line() "\n"
}

function cell(text) { gsub(/\|/, "\\|", text); return text }
function once(name, text) {
  if (last[key, name] == text) return "〃"
  last[key, name] = text
  return cell(text)
}
# A limit of a band; one that is 1 to six digits is told by its distance.
function limit(x,   off) {
  off = x - 1
  return off != 0 && off * off < 1e-11 ? sprintf("1 %s %.2g", off < 0 ? "−" : "+", off < 0 ? -off : off) : sprintf("%.6g", x)
}
function line(   formula, unit) {
  formula = tag($4, $3 ": " $2) " " cell($8)
  unit = $11 == "" ? "" : " " $11
  return sprintf("| %s: %s | %s | %.4g%s | %.4g%s | %.4f | %s to %s: %s | %s | [%s](../%s) |", $7, cell($5), formula, $9, unit,
                 $10, unit, $10 / $9, limit($12), limit($13), cell($6), once("past", $14), $2, $3)
}

END {
  if (bad) exit 1
  for (l = 1; l <= length(letters); ++l) {
    letter = substr(letters, l, 1)
    if (!count[letter]) continue
    print "## " titles[l] "\n"
    print "| failure: case | formula | predicted | measured | ratio | allowed, and why | past it | test |"
    print "|---|---|---|---|---|---|---|---|"
    for (i = 1; i <= count[letter]; ++i) printf "%s", rows[failures[letter, i]]
    print ""
  }
}
