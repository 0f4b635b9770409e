# SPDX-License-Identifier: Apache-2.0
"""The commands of many runs on the ranks of an MPI job: the bytes are those of one process."""
import os
import re
import shutil
import signal
import subprocess

from command import GASJET, ended, has, ok, program, read, status, until
from plans import SPHERE, TANK, bag_plan, rungs, same_study, tank_plan, write_slow


def ranks(count, *command):
    """Words of a job of many ranks; those after a colon are of another rank."""
    mpi = os.path.join(os.path.dirname(GASJET), "gasjet_mpi")
    words = ["mpirun", "--allow-run-as-root", "--oversubscribe"]
    for i, part in enumerate(command):
        words += [":"] * (i > 0) + ["-n", str(count), mpi, *part.split()]
    return words


def on_ranks(code, pattern, count, *command):
    return ended(code, pattern, program(*ranks(count, *command)))


def without_comments(path):
    return [line for line in read(path).splitlines() if not line.startswith("#")]


def test_mpi():
    bag_plan(6)
    ok("study run plan.toml --out alone --quiet")
    on_ranks(0, "12 of 12 runs: 12 done", 3, "study run plan.toml --out ranks")
    same_study("alone", "ranks")
    on_ranks(2, "with 2 ranks or more", 1, "study run plan.toml --out ranks")
    on_ranks(2, "gasjet_mpi ensemble.ladder.study run", 2, f"run {TANK}")
    on_ranks(2, "gasjet_mpi ensemble.ladder.study run", 2, "study merge ranks")  # all ranks would write
    ended(0, "^gasjet [0-9]", program(os.path.join(os.path.dirname(GASJET), "gasjet_mpi"), "--version"))
    tank_plan("seeds = 4")
    said = on_ranks(2, "study.seeds: perturb the nodes", 3, "study run plan.toml --out none").said
    assert said.count("study.seeds: perturb") == 1  # not by each rank
    write_slow()
    ensemble = f"ensemble {SPHERE} --against slow.toml --runs 5 --set scene.end_time=4e-3 --set membrane.mesh.levels=2"
    ok(f"{ensemble} --out one --quiet")
    on_ranks(0, "difference", 3, f"{ensemble} --out many")
    for name in ("effects", *(f"{case}/{name}" for case in ("sphere_inflation", "slow") for name in ("ensemble", "quantities", "runs"))):
        assert without_comments(f"one/{name}.csv") == without_comments(f"many/{name}.csv"), name
    ladder = "ladder cases/jet_bag.toml --set membrane.mesh.levels=1 --set scene.end_time=5e-3 --quantity pressure --tolerance 50%"
    warnings = ok(f"{ladder} --out ladder --quiet").err.splitlines()
    assert len(set(warnings)) == len(warnings) and all(re.match("warning: jet of inflator [01]: element sides", text) for text in warnings)
    on_ranks(0, "cheapest within", 3, f"{ladder} --out ladder_ranks")
    assert rungs("ladder") == rungs("ladder_ranks")


def test_mpi_faults():
    # A rank that sees another case says so, and all end.
    write_slow()
    shutil.copy(SPHERE, "both.toml")
    both, two = "ensemble both.toml --runs 2 --out two", "ensemble {}.toml --runs 2 --out two"
    on_ranks(2, "rank 1 reads another plan, case or file", 1, both, two.format("slow"))
    on_ranks(2, "missing.toml", 1, both, two.format("missing"))
    # What a run of each rank refuses is said once, and the folder says it.
    small = f"ensemble {SPHERE} --amplitude 1e-3 --set membrane.mesh.levels=1 --set membrane.mesh.radius=1e-4 --out small"
    assert len(re.findall("gasjet: volume .* must be finite and positive", program(*ranks(5, small)).said)) == 1
    assert status("small") == "failed"


def test_mpi_interrupt():
    """Ctrl-C of one rank, the only one that computes, is one of the command, which goes on from there."""
    bag_plan(200)
    job = subprocess.Popen(ranks(2, "study run plan.toml --out stopped"), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    until(lambda: has("stopped/shares/1_of_1/journal.jsonl", '"run":3,'))
    here = os.getcwd()
    of_the_job = [int(pid) for pid in os.listdir("/proc") if pid.isdigit() and is_rank(pid, here)]
    os.kill(max(of_the_job), signal.SIGINT)  # the newest
    assert job.wait() == 130 and status("stopped/shares/1_of_1") == "interrupted"
    on_ranks(0, "continues after [0-9]+ finished runs", 3, "study run plan.toml --out stopped")
    ok("study run plan.toml --out unstopped --quiet")
    same_study("unstopped", "stopped")


def is_rank(pid, folder):
    try:
        return os.readlink(f"/proc/{pid}/cwd") == folder and read(f"/proc/{pid}/cmdline").split("\0")[0].endswith("gasjet_mpi")
    except OSError:
        return False
