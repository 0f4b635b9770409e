#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What the means of the paper's scene lead to as its mesh is refined: fits mean = limit + change h^p, h the element's side over
# that of 2744 elements, to the three meshes of TABLE, weighted by standard errors. Of p = 1 to 2 the order is the one that the
# impulse without jet, whose errors are the smallest, fits best. chi_squared: of that order, one degree of freedom (none for the
# impulse without jet: the order is its own). Runs nothing; reads first contact without jet from first_contact_seed.csv beside
# TABLE, since it needs a seed in proportion to the elements. Writes OUT.
# usage: scripts/mesh_limits.sh [TABLE] [OUT]      (docs/charts/ensemble_convergence.csv, docs/charts/mesh_limits.csv by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
table=${1:-docs/charts/ensemble_convergence.csv} out=${2:-docs/charts/mesh_limits.csv}

# Rows scene,quantity,elements,mean,error.
means() {
  awk -F, '$1 == "mesh" { print "jet," $3 "," $2 "," $4 "," $5; if ($3 != "first_contact_s") print "no_jet," $3 "," $2 "," $6 "," $7 }' "$table"
  awk -F, '$1 ~ /^[0-9]+$/ { print "no_jet,first_contact_s," $1 "," $3 "," $4 }' "$(dirname "$table")/first_contact_seed.csv"
}

{
  grep '^#' "$table"
  means | awk -F, '
    function side(elements) { return elements < 5000 ? 1 : elements < 20000 ? 0.5 : 0.25 }
    # Weighted least squares of mean = limit + change h^p; leaves limit, its error, change, its error, chi2.
    function fit(key, p,    i, w, x, s0, s1, s2, t0, t1, d) {
      s0 = s1 = s2 = t0 = t1 = chi2 = 0
      for (i = 1; i <= 3; ++i) {
        w = 1 / error[key, i] ^ 2; x = h[key, i] ^ p
        s0 += w; s1 += w * x; s2 += w * x * x; t0 += w * mean[key, i]; t1 += w * x * mean[key, i]
      }
      d = s0 * s2 - s1 * s1
      limit = (t0 * s2 - t1 * s1) / d; change = (t1 * s0 - t0 * s1) / d
      limit_error = sqrt(s2 / d); change_error = sqrt(s0 / d)
      for (i = 1; i <= 3; ++i) chi2 += ((mean[key, i] - limit - change * h[key, i] ^ p) / error[key, i]) ^ 2
    }
    { key = $1 "," $2; if (!(key in count)) order[++keys] = key
      i = ++count[key]; h[key, i] = side($3); mean[key, i] = $4; error[key, i] = $5 }
    END {
      best = -1
      for (q = 1; q <= 2; q += 0.01) { fit("no_jet,contact_impulse_Ns", q); if (best < 0 || chi2 < best) { best = chi2; p = q } }
      print "scene,quantity,order,limit,standard_error,shipped_less_limit,its_standard_error,chi_squared,limit_at_order_1,limit_at_order_2"
      for (k = 1; k <= keys; ++k) {
        key = order[k]
        if (key ~ /peak_(pressure|volume)|,peak_cg_acceleration_m_s2/) continue
        fit(key, 1); first = limit; fit(key, 2); second = limit; fit(key, p)
        printf "%s,%.2f,%.6g,%.2g,%.4g,%.2g,%.2g,%.6g,%.6g\n", key, p, limit, limit_error, change, change_error, chi2, first, second
      }
    }'
} >"$out"
