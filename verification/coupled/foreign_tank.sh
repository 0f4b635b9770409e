#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A small foreign program for verification/run_external.sh: a tank with one inflator or one vent, by Runge-Kutta steps of 50 us. The
# variable DEFECT makes it wrong in one way; the test expects each to be caught.
# usage: foreign_tank.sh SCENE.json HISTORY.csv
set -euo pipefail
grep -q '"tank"' "$1" && ! grep -qE '"(fabric|file|amplitude|nasa7)"' "$1" && ! grep -q '"nasa7"' "$1" || exit 77
[[ ${DEFECT:-} != crash ]] || exit 3

# number KEY [WHICH]: the value after the WHICH-th "KEY": (keys are sorted within each table)
number() { { grep -oE "\"$1\": *[-+0-9.eE]+" "$json" || true; } | sed -n "${2:-1}s/.*: *//p"; }
json=$1
times=$(sed -nE 's/^ *"times": \[(.*)\],$/\1/p' "$json")
inflow=$(number mass_flow) vent=$(number area)
inflow_temperature=0
[[ -z $inflow ]] || inflow_temperature=$(awk '/"inflator"/ { on = 1 } on && /"temperature"/ { gsub(/[^0-9.eE+-]/, "", $2); print $2; exit }' "$json")
ambient=$(awk '/"ambient"/ { on = 1 } on && /"pressure"/ { gsub(/[^0-9.eE+-]/, "", $2); print $2; exit }' "$json")
initial() { awk -v key="\"$1\"" '/"initial"/ { on = 1 } on && index($0, key) { gsub(/[^0-9.eE+-]/, "", $2); print $2; exit }' "$json"; }

awk -v times="$times" -v V="$(number volume)" -v R="$(number gas_constant)" -v cp="$(number cp)" -v p0="$(initial pressure)" \
  -v T0="$(initial temperature)" -v pa="${ambient:-101325}" -v mdot="${inflow:-0}" -v Tin="$inflow_temperature" -v A="${vent:-0}" \
  -v Cd="$(number discharge_coefficient)" -v defect="${DEFECT:-}" '
function vent(m, U,   T, p, r, critical) {
  T = U / (m * cv); p = m * R * T / V
  if (A == 0 || p <= pa) return 0
  critical = (2 / (g + 1)) ^ (g / (g - 1))
  r = pa / p
  if (r < critical && defect != "never_chokes") r = critical
  return Cd * A * p / sqrt(R * T) * sqrt(2 * g / (g - 1) * (r ^ (2 / g) - r ^ ((g + 1) / g)))
}
function rate_m(m, U) { return mdot - vent(m, U) }
function rate_U(m, U) { return mdot * (defect == "energy_in" ? cv : cp) * Tin - vent(m, U) * (defect == "energy_out" ? cv : cp) * U / (m * cv) }
function step(h,   a, b, c, d, x, y, z, w) {
  a = rate_m(m, U); x = rate_U(m, U)
  if (defect == "euler") { m += h * a; U += h * x; return }
  b = rate_m(m + h / 2 * a, U + h / 2 * x); y = rate_U(m + h / 2 * a, U + h / 2 * x)
  c = rate_m(m + h / 2 * b, U + h / 2 * y); z = rate_U(m + h / 2 * b, U + h / 2 * y)
  d = rate_m(m + h * c, U + h * z); w = rate_U(m + h * c, U + h * z)
  m += h / 6 * (a + 2 * b + 2 * c + d); U += h / 6 * (x + 2 * y + 2 * z + w)
}
function row(t,   T, p) {
  T = U / (m * cv); p = m * R * T / V
  if (defect == "gauge") p -= pa
  if (defect == "kilopascal") p /= 1000
  if (defect == "celsius") T -= 273.15
  if (defect == "late") t += 1e-3
  if (defect == "nan" && t > 0.05) p = "nan"
  printf "%.12g,%.12g,%.12g%s,%.12g,%.12g,%.12g\n", t, p, T, (defect == "no_volume" ? "" : "," V), m, mdot, vent(m, U)
}
BEGIN {
  cv = cp - R
  g = defect == "gamma" ? 1.39 : cp / cv
  if (defect == "discharge") Cd *= 0.99
  if (defect == "inflow") mdot *= 0.999
  if (defect == "ambient") pa = 1e5
  h = defect == "euler" ? 1e-3 : 5e-5
  m = p0 * V / (R * T0); U = m * cv * T0
  n = split(times, time, ", ")
  if (defect == "stops") n = int(n / 2)
  print "time_s,pressure_Pa,temperature_K," (defect == "no_volume" ? "" : "volume_m3,") "gas_mass_kg,inflow_kg_s,vent_outflow_kg_s"
  row(time[1])
  for (i = 2; i <= n; i++) {
    steps = int((time[i] - time[i - 1]) / h + 0.999999)
    for (k = 0; k < steps; k++) step((time[i] - time[i - 1]) / steps)
    if (defect != "sparse" || i % 20 == 1 || i == n) row(time[i])
  }
}' >"$2"
