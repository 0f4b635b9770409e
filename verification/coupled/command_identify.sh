# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Part of command_test.sh (sourced): tank test analysis.

# misses LIMIT COLUMN_A A COLUMN_B B: fails if two tables differ by more than LIMIT (relative) at a time that both have
misses() {
  awk -F, -v limit="$1" -v a="$2" -v b="$4" '
    /^#/ { next }
    FNR == 1 || $1 == "time_s" { for (i = 1; i <= NF; i++) if ($i == (NR == FNR ? a : b)) c = i; next }
    NR == FNR { value[sprintf("%.6f", $1)] = $c; next }
    (k = sprintf("%.6f", $1)) in value { n++; d = $c / value[k] - 1; d = d < 0 ? -d : d; if (d > worst) worst = d }
    END { print "worst", worst, "of", n, "limit", limit; exit !(n < 20 || worst > limit) }' "$3" "$5"
}

# same_rows LIMIT A B: fails unless two tables have the same header and rows, to LIMIT of a column's largest magnitude
same_rows() {
  paste -d '|' <(grep -v '^#' "$2") <(grep -v '^#' "$3") | awk -F'|' -v limit="$1" '
    NR == 1 { if ($1 != $2) bad = "header " $0; next }
    { n = split($1, a, ","); if (split($2, b, ",") != n) bad = "row " NR
      for (i = 1; i <= n; i++) { d = a[i] - b[i]; d = d < 0 ? -d : d; m = b[i] < 0 ? -b[i] : b[i]
        if (d > worst[i]) worst[i] = d; if (m > largest[i]) largest[i] = m } }
    END { for (i in worst) if (worst[i] > limit * largest[i]) bad = bad " column " i " by " worst[i]
      print NR, "rows", bad; exit bad != "" || NR < 200 }'
}

part_identify() {
  local base='--method dual --volume 0.06 --mass 0.08 --gas N2 --thermodynamics constant --points 601' key limit line data=$work/data.csv
  "$gasjet" exact tank_test_pulse --times 0:0.06:1e-4 --set gas_constant=296.79670 --set heat_capacity_ratio=1.3995470 \
    --set tank_gas_constant=287.04164 --set tank_heat_capacity_ratio=1.3999531 --set outlet_area=1e-4 |
    sed 's/inflow_kg_s/true_flow/' >"$data" || fail "no readings"
  # Without noise: what comes out runs to the readings' pressure; the limit is the one that the analysis states.
  for key in dual average; do
    expect 0 "mean_temperature_K: 600" "$gasjet" identify "$data" ${base/dual/$key} --out "$work/curves_$key.csv"
    expect 0 "" "$gasjet" run "$source/cases/tank_identified.toml" --out "$work/$key" --quiet \
      --set "inflator.0.mass_flow={ file = '$work/curves_$key.csv', column = 'mass_flow_kg_s' }" \
      --set "inflator.0.temperature={ file = '$work/curves_$key.csv', column = 'temperature_K' }"
    limit=$(sed -nE 's/^# forward_model: .* by ([0-9.e+-]+) % at most/\1/p' "$work/curves_$key.csv")
    misses "$(awk "BEGIN { print 0.01 * $limit + 1e-5 }")" pressure_Pa "$work/$key/history.csv" tank_pressure_Pa "$data" >"$work/log" && fail "$key: $(cat "$work/log")"
  done
  # The curve in the shipped example is the one of its script's command, row by row: 1e-5 of each column's largest value,
  # for its eight digits and the last bits of another machine's functions that the search for lambda carries on.
  expect 0 "" "$gasjet" identify "$source/cases/tank_test_readings.csv" ${base/601/241} --out "$work/shipped.csv"
  same_rows 1e-5 "$work/shipped.csv" "$source/cases/tank_test_curves.csv" >"$work/log" || fail "shipped curves: $(cat "$work/log")"
  # With closed descriptors too: what would be printed is lost, the table is not.
  "$gasjet" identify "$source/cases/tank_test_readings.csv" ${base/601/241} --out "$work/closed.csv" <&- >&- 2>&- || fail "closed descriptors"
  cmp <(without_dates "$work/shipped.csv") <(without_dates "$work/closed.csv") || fail "closed descriptors change the table"
  # Its case runs to the truth within the readings' noise (1 %).
  "$gasjet" run "$source/cases/tank_identified.toml" --out "$work/shipped" --quiet || fail "shipped example"
  misses 0.01 pressure_Pa "$work/shipped/history.csv" tank_pressure_Pa "$data" >"$work/log" && fail "shipped: $(cat "$work/log")"

  # A record of the program's own tank with cp(T): 0.07 kg of CO2 at 800 K into 28.3 litres of air.
  cat >"$work/co2.toml" <<'END'
[scene]
name = "co2"
end_time = 0.06
[gas]
thermodynamics = "nasa7"
initial = { composition = { air = 1.0 }, pressure = 101325.0, temperature = 293.15 }
[tank]
volume = 0.0283
[[inflator]]
composition = { CO2 = 1.0 }
temperature = 800.0
mass_flow = { time = [0.0, 0.01, 0.04], value = [0.0, 3.5, 0.0] }
[output]
history_every = 1e-4
END
  "$gasjet" run "$work/co2.toml" --out "$work/co2" --quiet || fail "tank of CO2"
  expect 0 "mean_temperature_K: (800|799.99|800.00)" "$gasjet" identify "$work/co2/history.csv" --method average --tank-column pressure_Pa \
    --volume 0.0283 --mass 0.07 --gas CO2 --out "$work/co2.csv"
  # The same with a CO2 of one's own: another case gives its constant cp, of 800 K, and the record is one of that gas.
  printf '[gas]\n[[gas.species]]\nname = "own"\nmolar_mass = 0.044009\ncp = 1168.6\n' >"$work/own.toml"
  sed 's/CO2/own/; s/"co2"/"own"/; s/^initial.*/&\nspecies = [{ name = "own", molar_mass = 0.044009, cp = 1168.6 }]/' "$work/co2.toml" >"$work/own_tank.toml"
  "$gasjet" run "$work/own_tank.toml" --out "$work/own" --quiet || fail "tank of a gas of one's own"
  expect 0 "mean_temperature_K: (800|799.99|800.00)" "$gasjet" identify "$work/own/history.csv" --method average --tank-column pressure_Pa \
    --volume 0.0283 --mass 0.07 --gas own --species "$work/own.toml" --out "$work/own.csv"
  grep -q '^# species: built-in and .*own.toml' "$work/own.csv" || fail "no word of the species' file"
  own='--method average --tank-column pressure_Pa --volume 0.0283 --mass 0.07 --gas own'
  expect 2 "--gas: species = .own.: must be one of N2" "$gasjet" identify "$work/own/history.csv" $own --out "$work/none.csv"
  expect 2 "own.csv: would overwrite|would overwrite .*own.toml" "$gasjet" identify "$work/own/history.csv" $own --species "$work/own.toml" --out "$work/own.toml"
  expect 2 "co2.toml:4:1: gas.species: is missing" "$gasjet" identify "$work/own/history.csv" $own --species "$work/co2.toml" --out "$work/none.csv"
  sed 's/0.044009/-1/' "$work/own.toml" >"$work/bad.toml"
  expect 2 "bad.toml:4:1: gas.species.0.molar_mass: is -1" "$gasjet" identify "$work/own/history.csv" $own --species "$work/bad.toml" --out "$work/none.csv"
  # A tank that loses heat to its walls is none of the model: the miss is no noise, so there is no band.
  sed 's/^initial.*/&\nheat_loss = { coefficient = 200.0, area = 0.6 }/' "$work/co2.toml" >"$work/loss.toml"
  "$gasjet" run "$work/loss.toml" --out "$work/loss" --quiet || fail "tank that loses heat"
  expect 0 "warning: .* noise explains 0.* a tank that loses heat does not fit" "$gasjet" identify "$work/loss/history.csv" \
    --method average --tank-column pressure_Pa --volume 0.0283 --mass 0.07 --gas CO2 --out "$work/loss.csv"
  grep -q '^# mean_temperature_K: .*, no band$' "$work/loss.csv" || fail "a band of a tank that loses heat: $(head -20 "$work/loss.csv")"
  awk -F, '/^[0-9]/ && $NF != 0 { exit 1 }' "$work/loss.csv" || fail "rows that claim a band of a tank that loses heat"
  # Noise that is the same over the record, 0.2 % of the largest reading.
  awk -F, -v OFS=, '/^#/ { print; next } $1 == "time_s" { for (i = 1; i <= NF; i++) if ($i == "chamber_pressure_Pa") c = i; print; next }
    { seed = (16807 * (seed ? seed : 7)) % 2147483647; $c += 1e4 * (2 * seed / 2147483647 - 1) * 1.7; print }' "$data" >"$work/gauge.csv"
  expect 2 "chamber pressure: .* fits --noise full-scale" "$gasjet" identify "$work/gauge.csv" $base --out "$work/none.csv"
  expect 0 "of the largest reading" "$gasjet" identify "$work/gauge.csv" $base --noise full-scale --out "$work/gauge_curves.csv"

  # Doubtful: gauge pressures, told by the start, and a record of temperatures that nothing explains; one cut short.
  awk -F, -v OFS=, '/^#/ || $1 == "time_s" { print; next } { $2 -= 101225; $3 -= 101225; print }' "$data" >"$work/gauge.csv"
  expect 0 "warning: the tank holds (99.99|100|100.[0-9]+) Pa at first, less than a tenth of an atmosphere: pressures are absolute" \
    "$gasjet" identify "$work/gauge.csv" $base --out "$work/gauge_curves.csv"
  expect 0 "warning: .* misses the smoothed tank pressure by [2-9][0-9] %, noise explains 0.* pressures are absolute" \
    "$gasjet" identify "$work/gauge.csv" $base --out "$work/gauge_curves.csv"
  [ "$(grep -c '^# warning: ' "$work/gauge_curves.csv")" = 2 ] || fail "warnings of gauge pressures in the table"
  awk -F, '/^[0-9]/ && $1 > 0.03 { exit } { print }' "$data" >"$work/cut.csv"
  expect 0 "warning: the record ends while gas still flows \([0-9.]+ % of the largest flow\): all of --mass" \
    "$gasjet" identify "$work/cut.csv" $base --out "$work/cut_curves.csv"
  grep '^# warning: ' "$work"/{curves_dual,curves_average,shipped,co2,own}.csv && fail "a warning of a good record"

  # Bad input: place, name, nothing written.
  bad() { # bad PATTERN SED_EXPRESSION: the readings changed by sed
    sed -E "$2" "$data" >"$work/bad.csv"
    expect 2 "bad.csv:$1" "$gasjet" identify "$work/bad.csv" $base --out "$work/none.csv"
  }
  line=$(grep -n '^0.01,' "$data" | cut -d: -f1)
  bad "[0-9]+:1: tank_pressure_Pa: no such column" 's/tank_pressure_Pa/p/'
  bad "$line:1: time_s: time: 0.002 s: must be finite and later" "${line}s/^0.01,/0.002,/"
  bad "$line:1: time_s: time: 0.0099[0-9]* s: must be finite and later" "${line}s/^0.01,/$(sed -n "$((line - 1))s/,.*//p" "$data"),/"
  bad "$line:6: 'nan'" "${line}s/^0.01,[^,]*/0.01,nan/"
  bad "$line:6: tank_pressure_Pa: tank pressure: -5: must be above 0; pressures are absolute$" "${line}s/^0.01,[^,]*/0.01,-5/"
  bad "$line:[0-9]+: chamber_pressure_Pa: chamber pressure: -5: must be above 0; pressures are absolute; noise" "${line}s/^(0.01,[^,]*),[^,]*/\1,-5/"
  bad "$line:[0-9]+: chamber_pressure_Pa: chamber pressure: 91234 Pa is below the tank's" "${line}s/^(0.01,[^,]*),[^,]*/\1,91234/"
  bad "$((line - 90)):1: time_s: has [0-9]+ readings, 20 or more" "$((line - 89)),\$d"
  bad "[0-9]+:1: time_s: -0.1 s: time counts from firing" 's/^0,/-0.1,/'
  bad_option() { # bad_option PATTERN OPTION VALUE: in place of the base's, or beside it
    local options
    options=$(sed -E "s/$2 [^ ]+//" <<<"$base")
    expect 2 "$1" "$gasjet" identify "$data" $options --out "$work/none.csv" "$2" "$3"
  }
  bad_option "gasjet: --volume \[m3\] = 0: must be above 0" --volume 0
  bad_option "gasjet: --mass \[kg\] = -0.08: must be above 0" --mass -0.08
  bad_option "gasjet: --initial-temperature \[K\] = -1: must be above 0" --initial-temperature -1
  expect 2 "gasjet: --initial-temperature \[K\] = 100: must be 200 to 6000$" "$gasjet" identify "$data" \
    ${base/constant/nasa7} --initial-temperature 100 --out "$work/none.csv"
  bad_option "gasjet: --threshold = 2: must be 0.001 to 0.9" --threshold 2
  bad_option "gasjet: --points = 3: must be 20 to" --points 3
  bad_option "gasjet: --draws = 1: must be 40 to" --draws 1
  bad_option "--gas: species = .Xe.: must be one of" --gas Xe
  bad_option "--gas N2=0.5: sum of fractions = 0.5: must be 1" --gas N2=0.5
  bad_option "--tank-gas N2=x: 'N2=x' is no NAME=FRACTION" --tank-gas N2=x
  bad_option "--method" --method triple
  bad_option "--noise" --noise none
  expect 2 "--draws: is empty" "$gasjet" identify "$data" $base --draws= --out "$work/none.csv"
  expect 2 "--out .*would overwrite" "$gasjet" identify "$data" $base --out "$data"
  expect 2 "not writable" "$gasjet" identify "$data" $base --out "$work/nowhere/none.csv"
  expect 2 "no such file" "$gasjet" identify "$work/missing.csv" $base --out "$work/none.csv"
  expect 2 "required" "$gasjet" identify "$data" --out "$work/none.csv"
  # A hundredth of the mass: no gas is that hot.
  expect 3 "do not fit" "$gasjet" identify "$data" --method average --volume 0.06 --mass 0.0008 --gas N2 --out "$work/none.csv"
  [ -e "$work/none.csv" ] && fail "bad input wrote a table"
}
