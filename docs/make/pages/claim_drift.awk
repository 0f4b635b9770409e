# SPDX-License-Identifier: Apache-2.0
# Differences between two versions of docs/verification.md or docs/stability.md, OLD then NEW, as lines; the rules are those that the
# page's head states.
BEGIN { FS = " \\| " }
FNR == 1 { ++file }

# A row of docs/verification.md: a number, or orders.
/^\| \[/ && NF == 9 { note($1 FS $2 FS $7 FS $8 FS $9, $1 ": " $2, $3, $4, $5, $6, $8, $9); next }
/^\| \[/ && NF == 8 { note($1 FS $2 FS $5 FS $6 FS $7 FS $8, $1 ": " $2, $3, $4, "", "", $7, $8); next }
# A row of docs/stability.md.
NF != 8 || /^\| failure: case / { next }
{
  name = substr($1, 3)
  key = $1 FS $8
  text = $2 FS $6 FS $7
}
file == 1 { old[key] = name; predicted[key] = $3; ratio[key] = $5; texts[key] = text; next }
{ fresh[key] = 1 }
!(key in old) { print name ": not in the atlas"; next }
text != texts[key] { print name ": formula, band or what is past it reads otherwise: " text }
abs($3 - predicted[key]) > 1e-3 * abs(predicted[key]) { print name ": predicted is " $3 ", in the atlas " predicted[key] }
abs($5 - ratio[key]) > 5e-3 * abs(ratio[key]) { print name ": ratio is " $5 ", in the atlas " ratio[key] }

function note(key, name, a, b, error, allowed, checks, test) {
  if (file == 1) {
    old[key] = name
    first[key] = a; second[key] = b; errors[key] = error; limits[key] = allowed
    is_long[key] = test ~ /(_long_test|ensemble_test)\.cpp/
    return
  }
  fresh[key] = 1
  if (!(key in old)) { print name ": not in the report" ; return }
  if (error == "") compare_orders(key, a, b)
  else compare_numbers(key, b, error + 0, allowed + 0, checks)
}

function abs(x) { return x < 0 ? -x : x }
function compare_numbers(key, exact, error, allowed, checks,   round_off) {
  round_off = allowed < 1e-9
  if (error > allowed) print old[key] ": error " error " is more than allowed " allowed
  if (checks == 1 && abs(exact - second[key]) > 1e-6 * abs(exact) + (round_off ? allowed : 0))
    print old[key] ": exact is " exact ", in the report " second[key]
  if (!(round_off && checks > 1) && abs(allowed - limits[key]) > 0.02 * allowed)
    print old[key] ": allowed is " allowed ", in the report " limits[key]
  if (!round_off && abs(error - errors[key]) > 0.1 * allowed)
    print old[key] ": error is " error ", in the report " errors[key]
}
function compare_orders(key, values, orders,   i, n, now, then) {
  n = split(orders, now, " ")
  if (n != split(second[key], then, " ")) { print old[key] ": has other levels than in the report"; return }
  for (i = 1; i <= n; ++i)
    if (abs(now[i] - then[i]) > 0.05) print old[key] ": orders are " orders ", in the report " second[key]
  split(values, now, " ")
  split(first[key], then, " ")
  for (i = 1; i <= n + 1; ++i)
    if (abs(now[i] - then[i]) > 0.05 * abs(now[i])) print old[key] ": errors are " values ", in the report " first[key]
}

END { for (key in old) if (!(key in fresh) && !is_long[key]) print old[key] ": no test says this any more" }
