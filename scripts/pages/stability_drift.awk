# SPDX-License-Identifier: Apache-2.0
# Differences between two versions of the tables of docs/stability.md, OLD then NEW, as lines; the rules are those that its
# head states.
BEGIN { FS = " \\| " }
FNR == 1 { ++file }
NF != 8 || /^\| failure: case / { next }
{
  name = substr($1, 3)
  key = $1 FS $8
  text = $2 FS $6 FS $7
}
file == 1 { old[key] = name; predicted[key] = $3; ratio[key] = $5; texts[key] = text; next }
{ seen[key] }
!(key in old) { print name ": not in the atlas"; next }
text != texts[key] { print name ": formula, band or what is past it reads otherwise: " text }
apart($3 + 0, predicted[key] + 0, 1e-3) { print name ": predicted is " $3 ", in the atlas " predicted[key] }
apart($5, ratio[key], 5e-3) { print name ": ratio is " $5 ", in the atlas " ratio[key] }

function apart(a, b, share,   difference) {
  difference = a - b
  if (difference < 0) difference = -difference
  return difference > share * (b < 0 ? -b : b)
}
END { for (key in old) if (!(key in seen)) print old[key] ": no test says this any more" }
