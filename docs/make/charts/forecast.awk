# SPDX-License-Identifier: Apache-2.0
# One scene: what `gasjet check --format json` says beside what its ladder measured. Files: the JSON, ladder.csv.
# Rows: scene, quantity, effect left out, group, its size, whether that matters (from 0.01 on; relaxations from 1 on),
# change of the quantity [%], its standard error, whether that is 1 % or more, agree (1, 0; empty: undecided).
BEGIN { FS = ","; infinite = 1e300 }

FNR == NR { read_json(); next }
/^# reference: / { reference = substr($0, 14) + 0 }
/^# counted from: / { zero = substr($0, 17) + 0 }
/^# quantity: / { quantity = substr($0, 13) }
/^#/ { next }
!head { head = 1; for (i = 1; i <= NF; ++i) at[$i] = i; next }
$(at["runs"]) > 0 { compare($1, group_of($1)) }

function read_json() {
  if (/^  "forecast": \[/) inside = 1
  else if (/^  \]/) inside = 0
  else if (inside && /"name":/) { name = $0; gsub(/.*: "|",?$/, "", name) }
  else if (inside && /"value":/) { value = $0; gsub(/.*: |,$/, "", value); keep(name, number(value)) }
}
# JSON has no word for infinity; check says "infinite".
function number(value) {
  if (value == "\"infinite\"") return infinite
  if (value !~ /^-?[0-9]/) { print "forecast.awk: value " value " is no number" >"/dev/stderr"; exit 2 }
  return value + 0
}
# Of several jets the largest.
function keep(name, value) {
  sub(/_[0-9]+$/, "", name)
  if (!(name in group) || value > group[name]) group[name] = value
}

# The group that speaks of what a rung leaves out or refines; empty: none does.
function group_of(rung,   on_pendulum) {
  on_pendulum = quantity ~ /angle|contact|cg_acceleration/
  if (rung == "jet off") return on_pendulum ? "jet_on_impactor" : "jet_on_bag"
  if (rung == "outlet sonic") return "below_sonic"
  if (rung == "porosity off") return "fabric_leak"
  if (rung == "pieces 2") return on_pendulum ? "jet_mesh" : ""
  if (rung == "gas tolerance 0.001") return "gas_relaxation"
  if (rung == "rigid tank") return "fabric_stretch"
  return rung ~ /^finest: mesh/ && on_pendulum ? "contact_mesh" : ""
}

function compare(rung, name,   size, share, error, says, seen, agree) {
  if (name == "" || !(name in group) && name != "gas_relaxation") return
  size = group[name] + 0  # no relaxation where nothing flows out
  share = 100 * $(at["change"]) / sqrt((reference - zero) ^ 2)
  error = 100 * $(at["change_se"]) / sqrt((reference - zero) ^ 2)
  says = size >= (name == "gas_relaxation" ? 1 : 0.01) ? "yes" : "no"
  seen = sqrt(share ^ 2) >= 1 ? "yes" : "no"
  agree = sqrt((sqrt(share ^ 2) - 1) ^ 2) < 2 * error ? "" : says == seen
  sub(/^finest: /, "", rung)
  printf "%s,%s,%s,%s,%s,%s,%.3g,%.2g,%s,%s\n", scene, quantity, rung, name, size == infinite ? "infinite" : sprintf("%.3g", size), says, share, error,
    agree == "" ? "undecided" : seen, agree
}
