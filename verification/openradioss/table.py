# SPDX-License-Identifier: Apache-2.0
"""Table of run.sh: differences of OpenRadioss to Gasjet.

usage: table.py row SCENE FORMAT FOLDER LIMITS     rows of a run as CSV, from FOLDER/compare.json and rows.csv
       table.py whole ROWS GASJET OPENRADIOSS OUT  OUT/table.csv and OUT/table.md from all rows
LIMITS are COLUMN=SHARE at the end of the run. Exit code 1: a run has no end, or a column is above its limit.
"""
import csv
import datetime
import json
import os
import sys

HEAD = ["scene", "deck", "column", "end_s", "at_the_end", "rms", "largest", "limit", "verdict"]


def row(scene, deck, folder, limits):
    limits = {name: float(share) for name, share in (item.split("=") for item in limits.split())}
    path = os.path.join(folder, "compare.json")
    out, good = csv.writer(sys.stdout, lineterminator="\n"), True
    if not os.path.exists(path):
        out.writerow([scene, deck, "", "", "", "", "", "", "no end"])
        return False
    with open(path, encoding="utf-8") as file:
        quantities = json.load(file)["quantities"]
    with open(os.path.join(folder, "rows.csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if line[0] != "#"))
    for column in set(limits) - set(quantities):
        print(f"{scene}: no column {column}", file=sys.stderr)
        good = False
    for column, found in quantities.items():
        if "relative_error" not in found:
            continue
        mine = [float(r[column]) for r in rows]
        reference = [float(r[column + "_reference"]) for r in rows]
        scale = max(abs(x) for x in reference) or 1.0
        end = (mine[-1] - reference[-1]) / scale
        verdict = "" if column not in limits else "inside" if abs(end) <= limits[column] else "outside"
        good = good and verdict != "outside"
        out.writerow([scene, deck, column, rows[-1]["time_s"], f"{end:.2g}", f"{found['relative_error'] or 0.0:.2g}",
                      f"{max(abs(a - b) for a, b in zip(mine, reference)) / scale:.2g}", limits.get(column, ""), verdict])
    return good


def whole(rows_path, gasjet, openradioss, out):
    with open(rows_path, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    made = f"{gasjet} and {openradioss}, {datetime.date.today().isoformat()}"
    with open(os.path.join(out, "table.csv"), "w", encoding="utf-8") as file:
        file.write(f"# differences of OpenRadioss to Gasjet, by {made}: verification/openradioss/run.sh\n")
        file.write("# shares of the largest magnitude of Gasjet's column: at the end of the run, root mean square (of the column's), largest\n")
        csv.writer(file, lineterminator="\n").writerows([HEAD] + rows)
    with open(os.path.join(out, "table.md"), "w", encoding="utf-8") as file:
        file.write(f"By {made}.\n\n| scene | deck | column | at the end | rms | largest | limit |\n|---|---|---|---|---|---|---|\n")
        for scene, deck, column, _, end, rms, largest, limit, verdict in rows:
            if verdict == "no end":
                file.write(f"| {scene} | {deck} | no end | | | | |\n")
            else:
                file.write(f"| {scene} | {deck} | {column} | {end} | {rms} | {largest} | {limit}{' **outside**' * (verdict == 'outside')} |\n")


def main():
    if sys.argv[1] == "row":
        sys.exit(0 if row(*sys.argv[2:]) else 1)
    whole(*sys.argv[2:])


if __name__ == "__main__":
    main()
