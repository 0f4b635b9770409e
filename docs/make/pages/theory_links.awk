# SPDX-License-Identifier: Apache-2.0
# link[TAG]: where docs/theory/*.md, read before all else, define the equation; the anchor is that of its heading.
FILENAME ~ /\.md$/ && /^#+ / {
  anchor = tolower($0)
  sub(/^#+ /, "", anchor)
  gsub(/[^a-z0-9 _-]/, "", anchor)
  gsub(/ /, "-", anchor)
}
FILENAME ~ /theory\/[^\/]*\.md$/ {
  if (match($0, /\\tag\{[A-Z]\.[0-9]+\}/))
    link[substr($0, RSTART + 5, RLENGTH - 6)] = substr(FILENAME, index(FILENAME, "theory/")) "#" anchor
  next
}

# tag(NAME, WHO): the link of an equation; without one an error, and exit code 1 by `bad`.
function tag(name, who) {
  if (!(name in link)) { printf "%s: no equation (%s) in docs/theory\n", who, name >"/dev/stderr"; bad = 1 }
  return "[" name "](" link[name] ")"
}
