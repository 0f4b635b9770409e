# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): what `gasjet check` derives from a case.

part_check() {
  local blowdown=$source/cases/tank_blowdown.toml backflow=$source/cases/tank_backflow.toml gamma
  local empty=(--set gas.initial.pressure=0.0)
  # An empty volume has the gamma of the gas that fills it: of the initial composition, 7/5, or of an inflator's.
  expect 0 "^gas: 0 kg at 0 Pa, 600 K, gamma 1.4 of what fills it$" "$gasjet" check "$blowdown" "${empty[@]}"
  expect 0 "^vents: not choked at the start, choked from 191801 Pa at that gamma$" "$gasjet" check "$blowdown" "${empty[@]}"
  gamma=$("$gasjet" check "$blowdown" "${empty[@]}" --format json | python3 -c 'import json, sys; print(json.load(sys.stdin)["derived"]["gas_at_start"]["gamma"])')
  awk -v gamma="$gamma" 'BEGIN { exit !(gamma > 1.3999 && gamma < 1.4001) }' || fail "gamma of an empty volume in JSON: $gamma"
  expect 0 "^gas: 0 kg .* gamma 1.6667 of what fills it$" "$gasjet" check "$blowdown" "${empty[@]}" \
    --set 'inflator=[{composition={He=1.0},mass_flow=1.0,temperature=500.0}]'
  # Nothing flows from a vacuum into a vacuum.
  expect 0 "^vents: not choked at the start, choked above 0 Pa" "$gasjet" check "$blowdown" "${empty[@]}" --set ambient.pressure=0.0
  # Ambient air comes in at the speed of sound below 0.528 of its pressure, through vents that let it in.
  expect 0 "^vents: choked inwards at the start, outwards from 1[0-9.]+ Pa" "$gasjet" check "$backflow" "${empty[@]}"
  expect 0 "^vents: choked inwards at the start, outwards from 1[0-9.]+ Pa" "$gasjet" check "$backflow" --set gas.initial.pressure=53.4e3
  expect 0 "^vents: not choked at the start, choked from 1" "$gasjet" check "$backflow" --set gas.initial.pressure=53.6e3
  expect 0 "^vents: not choked at the start, choked from 1" "$gasjet" check "$backflow" --set gas.initial.pressure=53.4e3 \
    --set vent.0.backflow=false --unset ambient.composition --unset ambient.composition_by
  # Peaks of what waits for a trigger are told by the time after it.
  expect 0 "^inflator 0: at its peak \(t = 0.004 s after its trigger\) 2.5 kg/s" "$gasjet" check "$source/cases/tank_triggers.toml"
  expect 0 "^jet of inflator 0: at its peak \(t = 0.012 s after its trigger\) V0" "$gasjet" check "$source/cases/passenger_pendulum.toml" \
    --set 'sensor=[{name="s",time=0.005}]' --set inflator.0.trigger=s
  expect 0 "^jet of inflator 0: at its peak \(t = 0.012 s\) V0" "$gasjet" check "$source/cases/passenger_pendulum.toml"
  # A warning names the inflator that is wrong.
  expect 2 "^warning: inflator.1.temperature is 7000 K: is that its unit" "$gasjet" check "$source/cases/tank_triggers.toml" --set inflator.1.temperature=7000.0
}
