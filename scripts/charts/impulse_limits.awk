# SPDX-License-Identifier: Apache-2.0
# Limits of impulse_limits.csv: fits mean = limit + change x^order, x = 1/stiffness, step or element side over the shipped
# case's, weighted by standard errors. order: the best from 0.5 (stiffness) or 1 (mesh) to 2, for the step 2, the scheme's; 1.5
# of two meshes, which leave it open. order_low, order_high: the orders whose chi_squared is within 1 of the best one's; low,
# high: the limits within 1, at any of these orders. chi_squared has `degrees` degrees of freedom. chi_squared_constant: of no
# change at all; chi_squared_log: of a change with log2 x, which has no limit, by per_doubling with its error. Rows one_step:
# chi_squared of the means at the shorter step against those of the same stiffness.
function size(varied, value) { return varied == "contact" ? 1 / value : varied == "step" ? value / 0.8 : sqrt(2744 / value) }
# Weighted least squares of mean = limit + change y, y as given; order 0: log2 x.
function fit(key, order,   i, w, y, s0, s1, s2, t0, t1, d) {
  s0 = s1 = s2 = t0 = t1 = 0
  for (i = 1; i <= count[key]; ++i) {
    w = 1 / error[key, i] ^ 2; y = order > 0 ? x[key, i] ^ order : -log(x[key, i]) / log(2)
    s0 += w; s1 += w * y; s2 += w * y * y; t0 += w * mean[key, i]; t1 += w * y * mean[key, i]
  }
  d = s0 * s2 - s1 * s1
  limit = (t0 * s2 - t1 * s1) / d; change = (t1 * s0 - t0 * s1) / d
  limit_error = sqrt(s2 / d); change_error = sqrt(s0 / d); constant = t0 / s0
  chi2 = chi2_constant = 0
  for (i = 1; i <= count[key]; ++i) {
    y = order > 0 ? x[key, i] ^ order : -log(x[key, i]) / log(2)
    chi2 += ((mean[key, i] - limit - change * y) / error[key, i]) ^ 2
    chi2_constant += ((mean[key, i] - constant) / error[key, i]) ^ 2
  }
}
function report(key,   first, order, best, at, least, most, low, high, reach, straight, slope, slope_error) {
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
/^#/ { print; next }
$1 == "varied" { next }
$1 == "one_step" { other[$3 "," $4, $2] = $5; other_error[$3 "," $4, $2] = $6; next }
{
  key = $1 "," $3 "," $4
  if (!(key in count)) order_of[++keys] = key
  i = ++count[key]; x[key, i] = size($1, $2); mean[key, i] = $5; error[key, i] = $6
  if ($1 == "contact") place[$3 "," $4, $2] = i
}
END {
  print "varied,scene,quantity,order,order_low,order_high,limit,low,high,chi_squared,degrees,chi_squared_constant,chi_squared_log,per_doubling,error_per_doubling"
  for (k = 1; k <= keys; ++k) {
    report(order_of[k])
    if (order_of[k] !~ /^contact,/) continue
    name = substr(order_of[k], 9); sum = 0
    for (share = 1; share <= 4; share += 3) {
      i = place[name, share]
      sum += (mean["contact," name, i] - other[name, share]) ^ 2 / (error["contact," name, i] ^ 2 + other_error[name, share] ^ 2)
    }
    printf "one_step,%s,,,,,,,%.3g,2,,,,\n", name, sum
  }
}
