# SPDX-License-Identifier: Apache-2.0
"""A study as a Slurm job array, by a real slurmctld and slurmd on this machine (Debian: slurm-wlm, as root), and over GNU parallel
(Debian: parallel)."""
import os
import shutil
import socket
import subprocess
from pathlib import Path

import pytest
from command import GASJET, ended, ok, program, until, write, write_script
from plans import BAG, factor, plan, same_study

SLURM_CONF = """ClusterName=gasjet
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={work}/munge.socket
CredType=cred/munge
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation={work}/state
SlurmdSpoolDir={work}/spool
SlurmctldPidFile={work}/slurmctld.pid
SlurmdPidFile={work}/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
ReturnToService=2
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


@pytest.fixture
def slurm(work, monkeypatch):
    """A cluster of this machine."""
    host = socket.gethostname().split(".")[0]
    for folder in ("munge", "state", "spool"):
        os.mkdir(folder, 0o700)
    Path("munge/key").write_bytes(os.urandom(1024))
    os.chmod("munge/key", 0o600)
    write("slurm.conf", SLURM_CONF.format(host=host, work=work))
    monkeypatch.setenv("SLURM_CONF", f"{work}/slurm.conf")
    daemons = []
    for words in (f"munged --foreground --force --key-file={work}/munge/key --socket={work}/munge.socket --pid-file={work}/munge/pid"
                  f" --log-file={work}/munge/log --seed-file={work}/munge/seed", f"slurmctld -D -f {work}/slurm.conf",
                  f"slurmd -D -f {work}/slurm.conf -N {host}"):
        with open(words.split()[0] + ".out", "w") as said:
            daemons.append(subprocess.Popen(words.split(), stdout=said, stderr=said))
    until(lambda: "idle" in program("sinfo", "-h", "-o", "%T").out)
    yield
    for daemon in daemons:
        daemon.terminate()
        daemon.wait()


@pytest.fixture(autouse=True)
def study(work):
    missing = [name for name in ("slurmctld", "slurmd", "munged", "sbatch", "parallel") if not shutil.which(name)]
    if missing or os.geteuid():
        pytest.skip(f"{' '.join(missing)} missing (packages slurm-wlm, parallel)" if missing else "slurmd needs root")
    plan('set = ["scene.end_time=0.004"]', 'quantities = ["peak_pressure_Pa"]', "seeds = 10", *factor("contact.friction", "values = [0.0, 0.3]"),
         case=BAG)
    ok("study run plan.toml --out alone --quiet")


def merged(folder):
    ok(f"study merge {folder}")
    same_study("alone", folder, "study.json")


def test_study_parallel():
    share = [GASJET, "study", "run", "plan.toml", "--out", "parallel", "--quiet", "--share", "{}/4", ":::", "1", "2", "3", "4"]
    ended(0, "", program("parallel", "-j", "2", *share))
    merged("parallel")


def test_study_slurm(work, slurm):
    job = write_script("job.sh", f'#!/bin/sh\n#SBATCH --array=1-4\n"{GASJET}" study run plan.toml --out slurm --share "$SLURM_ARRAY_TASK_ID/4" --quiet\n')
    number = ended(0, "", program("sbatch", "--parsable", "-n", "1", "-D", work, "-o", f"{work}/job.%a.out", job)).out.strip()
    until(lambda: not program("squeue", "-h", "-j", number).out, seconds=120)
    merged("slurm")
