# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): accelerations behind channel filters.

part_channels() {
  local case=$source/cases/pendulum_pulse.toml classes='output.channel_classes=[1000,60,600,180]' out=$work/channels
  # A moment of 1000 Hz, the cut-off of CFC 600, on a pendulum without gravity: each column has the gain of its class.
  python3 -c 'import math
print("time_s,moment")
for n in range(10001): print(n / 100000, 100 * math.sin(2000 * math.pi * n / 100000), sep=",")' >"$work/sine.csv"
  sed '/^\[pendulum.driving_moment\]/,/^\[time\]/{/^\[time\]/!d}' "$case" |
    sed 's/^impactor_radius.*/&\ndriving_moment = { file = "sine.csv", column = "moment" }/' >"$work/sine.toml"
  expect 0 "done" "$gasjet" run "$work/sine.toml" --set scene.gravity=[0,0,0] --set scene.end_time=0.1 --set time.step=1e-5 \
    --set output.history_every=1e-5 --set "$classes" --out "$out"
  expect 0 "gains agree" python3 -B "$source/verification/coupled/channel_gains.py" "$out" 1000
  grep -q '^time_s,pendulum_cg_acceleration_cfc60_m_s2,pendulum_cg_acceleration_cfc180_m_s2,pendulum_cg_acceleration_cfc600_m_s2,pendulum_cg_acceleration_cfc1000_m_s2$' \
    "$out/accelerations.csv" || fail "columns of accelerations.csv"
  # compare makes the same columns of the components, and says when rows are too few.
  awk -F, -v OFS=, '/^#/ { next } /^time_s/ { print $0, $4 "_band"; next } { print $0, 1e-6 }' "$out/accelerations.csv" >"$work/reference.csv"
  expect 0 "cfc600.*inside" "$gasjet" compare "$out/history.csv" "$work/reference.csv" --columns pendulum_cg_acceleration_cfc600_m_s2
  awk -F, '/^#/ { next } /^time_s/ || n++ % 40 == 0' "$out/history.csv" >"$work/coarse.csv"
  expect 4 "mine has rows 0.0004 s apart, CFC 600 needs 0.000167 s or less" "$gasjet" compare "$work/coarse.csv" "$work/reference.csv" \
    --columns pendulum_cg_acceleration_cfc600_m_s2
  # A run that asks for none has no such file, and takes one of the run before away.
  expect 0 "done" "$gasjet" run "$case" --out "$out"
  [ ! -e "$out/accelerations.csv" ] || fail "accelerations of the run before"
  # Without a step of its own, a bag steps as fast as the class needs.
  expect 0 "channel_classes = \[1000\]" "$gasjet" check "$source/cases/ball_impact.toml" --set output.channel_classes=[1000]
  # Bad input.
  expect 2 "output.channel_classes: holds 100, an array of 60, 180, 600, 1000 is allowed" "$gasjet" check "$case" --set output.channel_classes=[100]
  expect 2 "output.channel_classes: holds a string, an array of" "$gasjet" check "$case" --set 'output.channel_classes=["60"]'
  expect 2 "output.channel_classes: is a number, an array of" "$gasjet" check "$case" --set output.channel_classes=60
  expect 2 "output.channel_classes: has 60 twice, once is allowed" "$gasjet" check "$case" --set output.channel_classes=[60,60]
  expect 2 "output.channel_classes: 1000 needs steps of 0.0001 s or less, time.step is 0.0002 s" "$gasjet" check "$case" \
    --set time.step=2e-4 --set output.channel_classes=[60,1000]
  expect 2 "output.channel_classes: the scene has no pendulum" "$gasjet" check "$source/cases/sphere_inflation.toml" --set output.channel_classes=[60]
}
