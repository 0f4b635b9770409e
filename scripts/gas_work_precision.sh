#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Work against precision of the gas: CPU time and achieved error of each method, of GSL's msbdf and, if installed, of
# SUNDIALS CVODE, on the filled and vented tank of benchmarks/gas_tank_benchmark.cpp.
# usage: scripts/gas_work_precision.sh [BENCHMARK]   (built if not given; writes docs/charts/gas_work_precision.csv, .svg)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
csv=docs/charts/gas_work_precision.csv
benchmark=${1:-build/benchmarks/gas_tank_benchmark}
if (($# == 0)); then
  cmake --preset release >/dev/null
  cmake --build --preset release --target gas_tank_benchmark >/dev/null
fi
raw=$(mktemp)
trap 'rm -f "$raw"' EXIT
"$benchmark" --benchmark_format=csv --benchmark_filter=vented 2>/dev/null >"$raw"
{
  echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores, one used; CPU time"
  echo "# commit: $(git describe --always --dirty)"
  echo "solver,tolerance,cpu_us,error,evaluations"
  awk -F, '
    /^name,/ { for (i = 1; i <= NF; ++i) { gsub(/"/, "", $i); column[$i] = i } next }
    /^"BM_/ {
      n = split($1, part, "/"); gsub(/"/, "", part[n]); label = $column["label"]; gsub(/"/, "", label)
      printf "%s,1e-%02d,%.1f,%.2e,%s\n", label, part[n], $column["cpu_time"] / 1e3, $column["error"], $column["evaluations"]
    }' "$raw"
} >"$csv"
plots=$(awk -F, -v file="$csv" '!/^#/ && header++ && !seen[$1]++ {
    name = $1; gsub("_", " ", name)
    printf "%s'"'<grep ^%s, %s'"' using 4:3 with linespoints linewidth 2 pointsize 0.7 title '"'%s'"'", n++ ? ", " : "", $1, file, name }' "$csv")
gnuplot <<END
set terminal svg size 800,480 font 'sans,14' background 'white'
set output '${csv%.csv}.svg'
set datafile separator ','
set logscale xy
set border 3
set tics nomirror
set format x '10^{%L}'
set grid linecolor 'gray70' linewidth 0.5 dashtype 3
set key outside right samplen 2
set xlabel 'Achieved error of p and T at 100 ms, relative'
set ylabel 'CPU time [µs]'
plot $plots
END
echo "$csv ${csv%.csv}.svg"
