#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs whatever has more than one thread under ThreadSanitizer: a run, an ensemble, a ladder and a study of short scenes, each by
# --threads 4. Ends with exit code 1 at the first data race, whose report it prints.
# usage: scripts/tests/threads.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export LC_ALL=C.UTF-8 TSAN_OPTIONS='halt_on_error=1 exitcode=66'
cmake -S . -B build-threads -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O1 -g' \
  -DGASJET_SANITIZE_THREADS=ON -DGASJET_TESTS=OFF -DGASJET_BENCHMARKS=OFF -DGASJET_BINDINGS=OFF -DCMAKE_UNITY_BUILD=ON >/dev/null
cmake --build build-threads --target gasjet -j "$(nproc)" >build-threads/log || { tail -n 60 build-threads/log; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# raced NAME OPTION...: one command of gasjet, four threads.
raced() {
  local name=$1 status=0
  shift
  build-threads/gasjet "$@" --threads 4 --out "$work/$name" >"$work/log" 2>&1 </dev/null || status=$?
  if ((status != 0 && status != 4)); then # 4: a ladder that leaves a rung undecided
    tail -n 60 "$work/log"
    echo "threads.sh: $name: exit code $status (66: a data race)" >&2
    exit 1
  fi
  echo "$name: no data race"
}

raced run run cases/passenger_pendulum.toml --set scene.end_time=2e-3 --set membrane.mesh.refine=1 --set "pendulum.pivot=[0.12,0.0,1.31]"
raced ensemble ensemble cases/passenger_pendulum.toml --runs 8 --set scene.end_time=1e-3
raced ladder ladder cases/jet_bag.toml --set membrane.mesh.levels=2 --set scene.end_time=5e-3 --quantity pressure --tolerance 10%
cat >"$work/plan.toml" <<PLAN
[study]
case = "$PWD/cases/rigid_tank.toml"
quantities = ["peak_pressure_Pa"]

[[factor]]
key = "gas.initial.temperature"
values = [280.0, 290.0, 300.0, 310.0]
PLAN
raced study study run "$work/plan.toml"
