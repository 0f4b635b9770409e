# SPDX-License-Identifier: Apache-2.0
"""What the programs that damage cases and decks share: many inputs at once, and a table of how they ended."""
import collections
import concurrent.futures
import sys


def tally(work, number, jobs, classes, outcomes):
    """Runs work(0) to work(number - 1), which return (class, outcome, what is wrong or nothing, index), and prints a row for each
    class. Returns the exit code: 1 if anything is wrong."""
    counts = collections.Counter()
    failures = []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for name, outcome, wrong, index in pool.map(work, range(number)):
            counts[name, "wrong" if wrong else outcome] += 1
            if wrong:
                failures.append(f"input {index} ({name}): {wrong}")
    print("\t".join(["class", "inputs", *outcomes]))
    for name in [*classes, "all"]:
        row = [sum(n for (c, o), n in counts.items() if name in (c, "all") and o == outcome) for outcome in outcomes]
        print("\t".join(map(str, [name, sum(row), *row])))
    print("\n".join(failures), file=sys.stderr)
    return 1 if failures else 0
