#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A study as a Slurm job array, by a real slurmctld and slurmd on this machine (Debian: slurm-wlm, as root), and over
# GNU parallel (Debian: parallel). usage: study_slurm.sh GASJET SOURCE_DIR
set -euo pipefail
gasjet=$1 source=$2
for program in slurmctld slurmd munged sbatch parallel; do
  command -v "$program" >/dev/null || { echo "SKIPPED, $program is missing (packages slurm-wlm, parallel)"; exit 0; }
done
[[ $EUID -eq 0 ]] || { echo "SKIPPED, slurmd needs root"; exit 0; }
work=$(mktemp -d)
daemons=()
stop() {
  for pid in "${daemons[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap stop EXIT
chmod 755 "$work"

cat >"$work/plan.toml" <<END
[study]
case = "$source/cases/passenger_pendulum.toml"
set = ["scene.end_time=0.004"]
quantities = ["peak_pressure_Pa"]
seeds = 10
[[factor]]
key = "contact.friction"
values = [0.0, 0.3]
END
same() { for file in results.csv means.csv study.json; do cmp "$work/alone/$file" "$work/$1/$file"; done; }
"$gasjet" study run "$work/plan.toml" --out "$work/alone" --quiet

seq 4 | parallel -j 2 "$gasjet" study run "$work/plan.toml" --out "$work/parallel" --quiet --share {}/4
"$gasjet" study merge "$work/parallel" >/dev/null
same parallel
echo "GNU parallel: the same tables"

host=$(hostname -s)
mkdir "$work/munge" "$work/state" "$work/spool"
chmod 700 "$work/munge"
dd if=/dev/urandom of="$work/munge/key" bs=1024 count=1 status=none
chmod 600 "$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge.socket" --pid-file="$work/munge/pid" \
  --log-file="$work/munge/log" --seed-file="$work/munge/seed" >"$work/munged.out" 2>&1 &
daemons+=($!)
cat >"$work/slurm.conf" <<END
ClusterName=gasjet
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
ReturnToService=2
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$work/slurm.conf
slurmctld -D -f "$SLURM_CONF" >"$work/slurmctld.out" 2>&1 &
daemons+=($!)
slurmd -D -f "$SLURM_CONF" -N "$host" >"$work/slurmd.out" 2>&1 &
daemons+=($!)
cat >"$work/job.sh" <<END
#!/bin/sh
#SBATCH --array=1-4
"$gasjet" study run "$work/plan.toml" --out "$work/slurm" --share "\$SLURM_ARRAY_TASK_ID/4" --quiet
END
for ((try = 0; try < 60; ++try)); do
  sinfo -h -o %T 2>/dev/null | grep -q idle && break
  sleep 0.5
done
job=$(sbatch --parsable -n 1 -o "$work/job.%a.out" "$work/job.sh") || { tail -n 5 "$work"/*.out; exit 1; }
for ((try = 0; try < 240; ++try)); do
  [[ -n $(squeue -h -j "$job" 2>/dev/null) ]] || break
  sleep 0.5
done
"$gasjet" study merge "$work/slurm" >"$work/merge.out" || { cat "$work"/*.out; exit 1; }
same slurm
echo "a Slurm job array of 4 shares: the same tables"
