#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A small foreign program for verification/run_external.sh: a tank with one inflator or one vent, by Runge-Kutta steps of 50 us. The
# variable DEFECT makes it wrong in one way; the test expects each to be caught.
# usage: foreign_tank.sh SCENE.json HISTORY.csv
set -euo pipefail
grep -q '"tank"' "$1" && ! grep -qE '"(fabric|file|amplitude|nasa7)"' "$1" && ! grep -q '"nasa7"' "$1" || exit 77
[[ ${DEFECT:-} != crash ]] || exit 3

awk -v defect="${DEFECT:-}" '
function number() { gsub(/[^0-9.eE+-]/, "", $2); return $2 + 0 }
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
BEGIN { pa = 101325 }
/^ *"times": / { times = $0; gsub(/^[^[]*\[|\].*$/, "", times) }
/^ *"(ambient|initial|inflator)": / { table = $1 }
/"volume": / { V = number() }
/"gas_constant": / && !R { R = number() }
/"cp": / && !cp { cp = number() }
/"area": / { A = number() }
/"discharge_coefficient": / { Cd = number() }
/"mass_flow": / { mdot = number() }
/"pressure": / { if (table ~ /ambient/) pa = number(); if (table ~ /initial/) p0 = number() }
/"temperature": / { if (table ~ /initial/ && !T0) T0 = number(); if (table ~ /inflator/ && !Tin) Tin = number() }
END {
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
}' "$1" >"$2"
