# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154  # of charts.sh: out, work
# Sourced by scripts/charts.sh: tables and charts that the programs of benchmarks/ measure, CSV with machine, compiler, flags and
# commit, and SVG. Times are CPU time on one core; some twenty minutes in all, on an idle machine.
#   gas, tank_test, bag   work against precision
#   jet_fidelity          error of the jet force against cost for each rung of the hidden-element test, on the paper's scene
#   jet_overhead          single stages of the jet from 700 to a million elements, folded and inflated, each visibility route and
#                         Embree side by side in one process
#   membrane              one step of the bag in cache and from memory. Bytes are those that a step must move for each element, held
#                         against what a copy of memory moves in the same run
#   stability             maps of the stability atlas: stable or not over two parameters, each point a run, beside the formula

build() {
  scripts/setup_debian12.sh libsundials-dev libembree-dev >&2 # the peers
  cmake --preset release >/dev/null
  cmake --build --preset release --target "$@" -j "$(nproc)" >/dev/null
}

header() {
  machine "one used"
  build_version
  printf '# %s\n' "$@"
}

# measure PROGRAM REPETITIONS SECONDS COLUMNS: rows of a google-benchmark program, one a benchmark: the parts of its name, its
# least CPU time [us] over the repetitions of SECONDS each, and the counters COLUMNS; failed ones are left out.
measure() {
  "build/benchmarks/$1" --benchmark_format=csv --benchmark_repetitions="$2" --benchmark_min_time="$3" 2>/dev/null |
    awk -F, -v wanted="$4" '
      { gsub(/"/, "") }
      /^name,/ { for (i = 1; i <= NF; ++i) column[$i] = i; n = split(wanted, counter, ","); next }
      !column["name"] || $column["error_occurred"] == "true" || $1 ~ /_(mean|median|stddev|cv)$/ { next }
      {
        name = $1
        sub(/\/(iterations|repeats|min_time):.*/, "", name)
        gsub("/", ",", name)
        if (!(name in least)) order[++rows] = name
        if (!(name in least) || $column["cpu_time"] < least[name]) {
          least[name] = $column["cpu_time"]
          values[name] = ""
          for (i = 1; i <= n; ++i) values[name] = values[name] sprintf(",%.4g", $column[counter[i]])
        }
      }
      END { for (i = 1; i <= rows; ++i) printf "%s,%.4g%s\n", order[i], least[order[i]] / 1e3, values[order[i]] }'
}

# keep NAME: the table of that name, which is whole
keep() { cp "$work/$1.csv" "$out/$1.csv"; }

chart_gas() {
  build gas_tank_benchmark gasjet
  {
    header "CPU time: least mean of 5 times 20 ms; error: largest relative one of p and T (tiny volume: of p - p_a and T)"
    echo "problem,solver,tolerance,cpu_us,error,evaluations,substeps"
    measure gas_tank_benchmark 5 0.02 error,evaluations,substeps
  } >"$work/gas_work_precision.csv"
  keep gas_work_precision
  draw gas_work_precision
}

chart_tank_test() {
  build tank_test_benchmark gasjet
  {
    header "8 records; CPU time of one analysis, mean; error: r.m.s. over the points that are not masked, of the mass flow over its mean" \
      "(average: of the product mdot T_s) and of the temperature (average: of the mean)"
    echo "method,noise,readings,cpu_us,flow_error,temperature_error"
    measure tank_test_benchmark 1 0 flow_error,temperature_error
  } >"$work/tank_test_work_precision.csv"
  keep tank_test_work_precision
  draw tank_test_work_precision
}

chart_bag() {
  build bag_benchmark gasjet
  {
    header "two periods; CPU time: least of 5; error of the frequency against the closed form"
    echo "scene,mesh,share_of_critical_step,cpu_us,error,elements,steps"
    measure bag_benchmark 5 0 error,elements,steps
  } >"$work/bag_work_precision.csv"
  keep bag_work_precision
  draw bag_work_precision
}

chart_jet_fidelity() {
  build jet_fidelity
  { machine "one thread used"; build/benchmarks/jet_fidelity; } >"$work/jet_fidelity.csv"
  keep jet_fidelity
  draw jet_fidelity
}

chart_jet_overhead() {
  build jet_overhead
  { machine "one thread used"; build/benchmarks/jet_overhead; } >"$work/jet_overhead.csv"
  keep jet_overhead
  draw jet_overhead
}

chart_membrane() {
  build gasjet membrane_benchmark
  build/benchmarks/membrane_benchmark --benchmark_filter='BM_torus_step.*/threads:1/|BM_copy/150' --benchmark_format=csv \
    --benchmark_repetitions=5 --benchmark_min_time=0.05 --benchmark_enable_random_interleaving=true 2>/dev/null >"$work/membrane_rows.csv"
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
      }' "$work/membrane_rows.csv" | sort -t, -k1,1n -k2,2
  } >"$work/membrane_cost.csv"
  keep membrane_cost
}

# map NAME X_LABEL FORMULA TITLE
map() {
  {
    provenance
    echo "# points: $1, stable over time (1) or grown 1e5-fold from a disturbance of 1e-10 (0); formula: $3"
    build/benchmarks/stability_maps "$1"
  } >"$work/stability_$1.csv"
  keep "stability_$1"
  draw "stability_$1" "label='$2'; formula='$3'; heading='$4'" stability_maps
}

chart_stability() {
  build stability_maps gasjet
  map sliver 'Shortest side over what it was' 'bound of the step (M.12)' 'A sliver in the mesh shortens the stable step'
  map gas 'Volume over that of the sphere' 'bound of the step (M.12)' 'A small volume of gas shortens the stable step'
  map lagged 'Time simulated [s]' 'growth 1e5-fold by (M.20)' 'A pressure that lags grows slowly at any step'
}
