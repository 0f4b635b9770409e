#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What one step of the bag costs in cache and from memory, one thread: CSV with machine, compiler, flags and commit.
# Bytes are those that a step must move for each element, held against what a copy of memory moves in the same run.
# usage: scripts/charts/membrane_cost.sh [OUT.csv]      (docs/charts/membrane_cost.csv by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
out=${1:-docs/charts/membrane_cost.csv}
log=$(mktemp)
trap 'rm -f "$log"' EXIT

scripts/setup_debian12.sh
cmake --preset release >/dev/null
cmake --build --preset release --target gasjet membrane_benchmark -j "$(nproc)" >/dev/null
build/benchmarks/membrane_benchmark --benchmark_filter='BM_torus_step.*/threads:1/|BM_copy/150' --benchmark_format=csv \
  --benchmark_repetitions=5 --benchmark_min_time=0.05 --benchmark_enable_random_interleaving=true 2>/dev/null >"$log"
{
  machine "one thread used"
  build_version
  echo "# least processor time of 5 interleaved repetitions; bytes per element; copy: reads and writes of the fastest"
  echo "elements,kernels,ns_per_element,element_bytes,node_bytes,bytes,step_GB_s,copy_GB_s"
  awk -F, '
    { gsub(/"/, ""); sub(/, woven/, " woven") }
    /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    /_(mean|median|stddev|cv)/ { next }
    /^BM_copy/ { rate = 0.3 / ($column["cpu_time"] * 1e-3); if (rate > copy) copy = rate; next }  # 150 MB read, 150 written
    /^BM_torus_step/ {
      key = $column["elements"] + 0 "," $column["label"]
      time = $column["cpu_time"] * 1e6 / $column["elements"]
      if (!(key in least)) { order[++n] = key; element[key] = $column["element_bytes"]; node[key] = $column["node_bytes"] }
      if (!(key in least) || time < least[key]) least[key] = time
    }
    END {
      for (i = 1; i <= n; ++i) {
        key = order[i]
        bytes = element[key] + node[key]
        printf "%s,%.1f,%.1f,%.1f,%.1f,%.1f,%.1f\n", key, least[key], element[key], node[key], bytes, bytes / least[key], copy
      }
    }' "$log" | sort -t, -k1,1n -k2,2
} >"$out.new"
mv "$out.new" "$out"
cat "$out"
