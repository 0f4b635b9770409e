# SPDX-License-Identifier: Apache-2.0
# Rows of verification/support/claim.cpp -> the tables of docs/verification.md. After theory_links.awk.
BEGIN { FS = "\t"; count = split("gas membrane jet coupling coupled", families, " ") }

$1 == "threshold" { next }
tag($4, $3 ": " $2) ~ /\(\)/ { next }

# A sweep shows its worst row: by the share of the tolerance, or of the half band, that it uses.
{
  test = $2
  if (test ~ /^[^.]*\//) sub(/^[^\/]*\//, "", test)  # instance and parameter of a parametrised test
  sub(/\/[^\/]*$/, "", test)
  key = $1 FS $3 FS $4 FS $5 FS test
  used = $1 == "near" ? share(abs($7 - $8), $9) : order_share($8, $9, $10)
  if (!(key in row)) keys[++number] = key
  if (!(key in row) || used > worst[key]) { row[key] = $0; worst[key] = used }
  members[key]++
  split($3, part, "/")
  seen[part[2]]
}

function abs(x) { return x < 0 ? -x : x }
function share(error, tolerance) { return tolerance > 0 ? error / tolerance : error > 0 ? 1e300 : 0 }
function order_share(orders, low, high,   list, n, i, most, one) {
  n = split(orders, list, " ")
  for (i = 1; i <= n; ++i) { one = abs(2 * list[i] - low - high) / (high - low); if (one > most) most = one }
  return most
}
function each(format, values,   list, n, i, text) {
  n = split(values, list, " ")
  for (i = 1; i <= n; ++i) text = text (i > 1 ? " " : "") sprintf(format, list[i])
  return text
}
function where(field, key,   test) {
  split(key, test, FS)
  return "[" test[5] "](../" field[3] ")"
}

# near: error and tolerance as shares of the exact value, unless that is smaller than the tolerance (marked abs.).
function near_line(field, key,   scale, mark) {
  scale = abs(field[8]) > field[9] ? abs(field[8]) : 1
  mark = scale == 1 && field[8] != 1 ? " abs." : ""
  return sprintf("| %s | %s | %.9g | %.9g | %.1e%s | %.1e%s | %s | %d | %s |", tag(field[4]), field[5], field[7], field[8],
                 abs(field[7] - field[8]) / scale, mark, field[9] / scale, mark, field[6], members[key], where(field, key))
}
function order_line(field, key) {
  return sprintf("| %s | %s | %s | %s | %g to %g | %s | %d | %s |", tag(field[4]), field[5], each("%.2e", field[7]),
                 each("%.2f", field[8]), field[9], field[10], field[6], members[key], where(field, key))
}

function table(kind, family, head,   i, field, lines) {
  for (i = 1; i <= number; ++i) {
    split(row[keys[i]], field, FS)
    if (field[1] != kind || index(field[3], "verification/" family "/") != 1) continue
    if (!lines++) print head
    print kind == "near" ? near_line(field, keys[i]) : order_line(field, keys[i])
  }
  if (lines) print ""
}

END {
  if (bad) exit 1
  for (f = 1; f <= count; ++f) {
    if (!(families[f] in seen)) continue
    print "## " toupper(substr(families[f], 1, 1)) substr(families[f], 2) "\n"
    table("near", families[f], "| equation | what | computed | exact | error | allowed | why this much | checks | test |\n" \
      "|---|---|---|---|---|---|---|---|---|")
    table("order", families[f], "| equation | what | errors | orders | band | why this band | checks | test |\n" \
      "|---|---|---|---|---|---|---|---|")
  }
}
