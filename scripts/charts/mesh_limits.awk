# SPDX-License-Identifier: Apache-2.0
# What the means of the paper's scene lead to as its mesh is refined: fits mean = limit + change h^p, h the element's side over
# that of 2744 elements, to the three meshes, weighted by standard errors. Of p = 1 to 2 the order is the one that the
# impulse without jet, whose errors are the smallest, fits best. standard_error: of the limit, that order's own included;
# scatter: at that order; half_of_orders: half of what the limit moves by from order 1 to 2; its_error: scatter and that together.
# chi_squared: of that order, one degree of freedom (none for the impulse without jet: the order is its own; the last row sums up
# the others). Files: ensemble_convergence.csv, first_contact_seed.csv, from which comes first contact without jet, since it needs
# a seed in proportion to the elements.
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
function add(key, elements, value, its_error,    i) {
  if (!(key in count)) order[++keys] = key
  i = ++count[key]; h[key, i] = side(elements); mean[key, i] = value; error[key, i] = its_error
}
FNR == 1 { ++file }
/^#/ && file == 1 { print; next }
/^# gasjet/ { print "# first contact without jet:" substr($0, 2) }
/^#/ { next }
file == 1 && $1 == "mesh" { add("jet," $3, $2, $4, $5); if ($3 != "first_contact_s") add("no_jet," $3, $2, $6, $7) }
file == 2 && $1 ~ /^[0-9]+$/ { add("no_jet,first_contact_s", $1, $3, $4) }
END {
  best = -1
  for (q = 1; q <= 2; q += 0.01) { fit("no_jet,contact_impulse_Ns", q); if (best < 0 || chi2 < best) { best = chi2; p = q } }
  step = 0.05; fit("no_jet,contact_impulse_Ns", p); middle = chi2; fit("no_jet,contact_impulse_Ns", p + step); bend = chi2 - 2 * middle
  fit("no_jet,contact_impulse_Ns", p - step); order_error = step * sqrt(2 / (bend + chi2))  # chi2 grows by 1 over it
  print "scene,quantity,order,order_error,limit,scatter,standard_error,half_of_orders,shipped_less_limit,its_error,chi_squared,limit_at_order_1,limit_at_order_2,chi_squared_at_order_1,chi_squared_at_order_2"
  for (k = 1; k <= keys; ++k) {
    key = order[k]
    if (key ~ /peak_(pressure|volume)|,peak_cg_acceleration_m_s2/) continue
    fit(key, 1); first = limit; chi2_1 = chi2; fit(key, 2); second = limit; chi2_2 = chi2; half = (second - first) / 2
    fit(key, p + step); slope = limit; fit(key, p - step); slope = (slope - limit) / (2 * step); fit(key, p)
    if (key != "no_jet,contact_impulse_Ns") sum += chi2
    printf "%s,%.2f,%.2g,%.6g,%.2g,%.2g,%.2g,%.4g,%.2g,%.2g,%.6g,%.6g,%.2g,%.2g\n", key, p, order_error, limit, limit_error,
      sqrt(limit_error ^ 2 + (slope * order_error) ^ 2), half, change, sqrt(change_error ^ 2 + half ^ 2), chi2, first, second, chi2_1, chi2_2
  }
  printf "both,the_others,%.2f,%.2g,,,,,,,%.3g,,,,\n", p, order_error, sum
}
