# SPDX-License-Identifier: Apache-2.0
# What means lead to: weighted fits mean = limit + change x^order, of two tables (-v of=mesh or of=impulse).
#
# mesh: the means of the paper's scene as its mesh is refined; x is the element's side over that of 2744 elements, three meshes. Of
# order 1 to 2 that one is taken which the impulse without jet, whose errors are the smallest, fits best. standard_error: of the
# limit, that order's own included; scatter: at that order; half_of_orders: half of what the limit moves by from order 1 to 2;
# its_error: scatter and that together. chi_squared: of that order, one degree of freedom (none for the impulse without jet: the
# order is its own; the last row sums up the others). Files: ensemble_convergence.csv, first_contact_seed.csv, from which comes first
# contact without jet, since it needs an amplitude in proportion to the elements.
#
# impulse: limits of impulse_limits.csv; x is 1/stiffness, or step or element side over the shipped case's. order: the best from
# 0.5 (stiffness) or 1 (mesh) to 2, for the step 2, the scheme's; 1.5 of two meshes, which leave it open. order_low, order_high: the
# orders whose chi_squared is within 1 of the best one's; low, high: the limits within 1, at any of these orders. chi_squared has
# `degrees` degrees of freedom. chi_squared_constant: of no change at all; chi_squared_log: of a change with log2 x, which has no
# limit, by per_doubling with its error. Rows one_step: chi_squared of the means at the shorter step against those of the same
# stiffness.

# Leaves limit, change, their errors, chi2, and constant and chi2_constant of no change; order 0: change by log2 x.
function fit(key, order,   i, w, y, s0, s1, s2, t0, t1, d) {
  s0 = s1 = s2 = t0 = t1 = 0
  for (i = 1; i <= count[key]; ++i) {
    w = 1 / error[key, i] ^ 2; y = power(x[key, i], order)
    s0 += w; s1 += w * y; s2 += w * y * y; t0 += w * mean[key, i]; t1 += w * y * mean[key, i]
  }
  d = s0 * s2 - s1 * s1
  limit = (t0 * s2 - t1 * s1) / d; change = (t1 * s0 - t0 * s1) / d
  limit_error = sqrt(s2 / d); change_error = sqrt(s0 / d); constant = t0 / s0
  chi2 = chi2_constant = 0
  for (i = 1; i <= count[key]; ++i) {
    y = power(x[key, i], order)
    chi2 += ((mean[key, i] - limit - change * y) / error[key, i]) ^ 2
    chi2_constant += ((mean[key, i] - constant) / error[key, i]) ^ 2
  }
}
function power(size, order) { return order > 0 ? size ^ order : -log(size) / log(2) }
function add(key, size, value, its_error,   i) {
  if (!(key in count)) order_of[++keys] = key
  i = ++count[key]; x[key, i] = size; mean[key, i] = value; error[key, i] = its_error
}

function side(elements) { return elements < 5000 ? 1 : elements < 20000 ? 0.5 : 0.25 }
function mesh_limits(   best, p, q, step, middle, bend, order_error, k, key, first, chi2_1, second, chi2_2, half, slope, sum) {
  best = -1
  for (q = 1; q <= 2; q += 0.01) { fit("no_jet,contact_impulse_Ns", q); if (best < 0 || chi2 < best) { best = chi2; p = q } }
  step = 0.05; fit("no_jet,contact_impulse_Ns", p); middle = chi2; fit("no_jet,contact_impulse_Ns", p + step); bend = chi2 - 2 * middle
  fit("no_jet,contact_impulse_Ns", p - step); order_error = step * sqrt(2 / (bend + chi2))  # chi2 grows by 1 over it
  print "scene,quantity,order,order_error,limit,scatter,standard_error,half_of_orders,shipped_less_limit,its_error,chi_squared,limit_at_order_1,limit_at_order_2,chi_squared_at_order_1,chi_squared_at_order_2"
  for (k = 1; k <= keys; ++k) {
    key = order_of[k]
    if (key ~ /peak_(pressure|volume)|,peak_cg_acceleration_m_s2/) continue
    fit(key, 1); first = limit; chi2_1 = chi2; fit(key, 2); second = limit; chi2_2 = chi2; half = (second - first) / 2
    fit(key, p + step); slope = limit; fit(key, p - step); slope = (slope - limit) / (2 * step); fit(key, p)
    if (key != "no_jet,contact_impulse_Ns") sum += chi2
    printf "%s,%.2f,%.2g,%.6g,%.2g,%.2g,%.2g,%.4g,%.2g,%.2g,%.6g,%.6g,%.2g,%.2g\n", key, p, order_error, limit, limit_error,
      sqrt(limit_error ^ 2 + (slope * order_error) ^ 2), half, change, sqrt(change_error ^ 2 + half ^ 2), chi2, first, second, chi2_1, chi2_2
  }
  printf "both,the_others,%.2f,%.2g,,,,,,,%.3g,,,,\n", p, order_error, sum
}

function size(varied, value) { return varied == "contact" ? 1 / value : varied == "step" ? value / 0.8 : sqrt(2744 / value) }
function impulse_limit(key,   first, order, best, at, least, most, low, high, reach, straight, slope, slope_error) {
  first = key ~ /^step/ ? 2 : key ~ /^mesh/ ? 1 : 0.5
  best = -1
  for (order = first; order < 2.005; order += 0.01) { fit(key, order); if (best < 0 || chi2 < best) { best = chi2; at = order } }
  if (count[key] < 3) { at = 1.5; best = 0 }
  least = 9
  for (order = first; order < 2.005; order += 0.01) {
    fit(key, order)
    if (chi2 > best + 1) continue
    if (least > 2) { least = order; low = limit; high = limit }
    most = order
    reach = limit_error * sqrt(best + 1 - chi2)
    if (limit - reach < low) low = limit - reach
    if (limit + reach > high) high = limit + reach
  }
  fit(key, 0); straight = chi2; slope = change; slope_error = change_error
  fit(key, at)
  if (count[key] < 3) chi2 = straight = 0
  printf "%s,%.2f,%.2f,%.2f,%.6g,%.6g,%.6g,%.3g,%d,%.3g,%.3g,%.3g,%.2g\n", key, at, least, most, limit, low, high, chi2,
    count[key] < 3 ? 0 : count[key] - (first < 2 ? 3 : 2), chi2_constant, straight, slope, slope_error
}
function impulse_limits(   k, name, sum, share, i) {
  print "varied,scene,quantity,order,order_low,order_high,limit,low,high,chi_squared,degrees,chi_squared_constant,chi_squared_log,per_doubling,error_per_doubling"
  for (k = 1; k <= keys; ++k) {
    impulse_limit(order_of[k])
    if (order_of[k] !~ /^contact,/) continue
    name = substr(order_of[k], 9); sum = 0
    for (share = 1; share <= 4; share += 3) {
      i = place[name, share]
      sum += (mean["contact," name, i] - other[name, share]) ^ 2 / (error["contact," name, i] ^ 2 + other_error[name, share] ^ 2)
    }
    printf "one_step,%s,,,,,,,%.3g,2,,,,\n", name, sum
  }
}

FNR == 1 { ++file }
/^#/ && file == 1 { print; next }
/^# gasjet/ { print "# first contact without jet:" substr($0, 2) }
/^#/ { next }
of == "mesh" && file == 1 && $1 == "mesh" { add("jet," $3, side($2), $4, $5); if ($3 != "first_contact_s") add("no_jet," $3, side($2), $6, $7) }
of == "mesh" && file == 2 && $1 ~ /^[0-9]+$/ { add("no_jet,first_contact_s", side($1), $3, $4) }
of == "impulse" && $1 == "one_step" { other[$3 "," $4, $2] = $5; other_error[$3 "," $4, $2] = $6; next }
of == "impulse" && $1 != "varied" {
  key = $1 "," $3 "," $4
  add(key, size($1, $2), $5, $6)
  if ($1 == "contact") place[$3 "," $4, $2] = count[key]
}
END { if (of == "mesh") mesh_limits(); else impulse_limits() }
