#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the tables of docs/verification.md and docs/stability.md from the rows that the tests write
(verification/support/claim.hpp). What stands above the tables is written by hand.

usage: docs/make/pages/claims.py [--from ROWS | --check [ROWS]]
  --from   take the rows that are in the folder ROWS already, instead of building and running the tests
  --check  compare the pages with the rows in the folder ROWS (build/claims); exit code 1 if they differ by more
           than the heads of the pages allow"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROVED = pathlib.Path(__file__).with_name("proved.tsv")
VERIFICATION, STABILITY = ROOT / "docs/verification.md", ROOT / "docs/stability.md"
NEAR = "| equation | what | computed | exact | error | allowed | why this much | checks | proved | test |\n" + "|---" * 10 + "|\n"
ORDER = "| equation | what | errors | orders | band | why this band | checks | test |\n" + "|---" * 8 + "|\n"
THRESHOLD = "| failure: case | formula | predicted | measured | ratio | allowed, and why | past it | test |\n" + "|---" * 8 + "|\n"


# --- from rows to tables

def theory_links():
    """Where docs/theory defines each equation: {tag: the way there from docs}."""
    links = {}
    for page in sorted(ROOT.glob("docs/theory/*.md")):
        for line in page.read_text(encoding="utf-8").splitlines():
            if heading := re.match(r"#+ (.*)", line):
                anchor = re.sub(r"[^a-z0-9 _-]", "", heading[1].lower()).replace(" ", "-")
            if tag := re.search(r"\\tag\{([A-Z]\.[0-9]+)\}", line):
                links[tag[1]] = f"theory/{page.name}#{anchor}"
    return links


def rows_of(folder):
    """The fields of all rows, whose equation is a link; exits if an equation is in no page of the theory."""
    files = sorted(pathlib.Path(folder).rglob("*.tsv"))
    if not files:
        sys.exit(f"claims.py: no rows in {folder}; run the tests first (ctest --preset fast)")
    rows = [line.split("\t") for file in files for line in file.read_text(encoding="utf-8").splitlines()]
    links, lost = theory_links(), False
    for row in rows:
        if row[3] not in links:
            print(f"{row[2]}: {row[1]}: no equation ({row[3]}) in docs/theory", file=sys.stderr)
            lost = True
        row[3] = f"[{row[3]}]({links.get(row[3])})"
    if lost:
        sys.exit(1)
    return rows


def share_used(row):
    """How much of the tolerance, or of half the band, a check uses."""
    if row[0] == "near":
        error, tolerance = abs(float(row[6]) - float(row[7])), float(row[8])
        return error / tolerance if tolerance > 0 else 1e300 if error > 0 else 0
    low, high = float(row[8]), float(row[9])
    return max(abs(2 * float(order) - low - high) / (high - low) for order in row[7].split())


def proved_forms():
    """Forms that have proved bounds, by the checks whose exact value is theirs: [(test, form, part of the quantity)]."""
    text = "".join(path.read_text(encoding="utf-8") for path in sorted(ROOT.glob("verification/enclosure/formulas/*.txt")))
    forms = set(re.findall(r"^(\w+)(?:\(\w+\))?:$", text, flags=re.M))
    lines = [line.split("\t") for line in PROVED.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    if lost := {form for _, form, *_ in lines} - forms:
        sys.exit(f"claims.py: no formula in verification/enclosure/formulas for {', '.join(sorted(lost))} of {PROVED.name}")
    return [(test, form, part[0] if part else "") for test, form, *part in lines]


def proved_cell(row, test):
    form = next((form for name, form, part in proved_forms() if name == test and part in row[4]), None)
    return f"[`{form}`](exact.md)" if form else ""


def near_line(row, test, checks):
    """Error and tolerance are shares of the exact value, unless that is smaller than the tolerance (marked abs.)."""
    equation, what, why, computed, exact, tolerance = *row[3:6], *map(float, row[6:9])
    scale = abs(exact) if abs(exact) > tolerance else 1
    mark = " abs." if scale == 1 and exact != 1 else ""
    return (f"| {equation} | {what} | {computed:.9g} | {exact:.9g} | {abs(computed - exact) / scale:.1e}{mark} | {tolerance / scale:.1e}{mark} "
            f"| {why} | {checks} | {proved_cell(row, test)} | [{test}](../{row[2]}) |\n")


def order_line(row, test, checks):
    errors, orders = (" ".join(form % float(value) for value in row[i].split()) for i, form in ((6, "%.2e"), (7, "%.2f")))
    return (f"| {row[3]} | {row[4]} | {errors} | {orders} | {float(row[8]):g} to {float(row[9]):g} | {row[5]} | {checks} "
            f"| [{test}](../{row[2]}) |\n")


def verification_tables(rows):
    worst, count = {}, {}  # a sweep shows the check that uses most of what is allowed
    for row in rows:
        if row[0] == "threshold":
            continue
        test = re.sub(r"^[^./]*/", "", row[1]) if re.match(r"[^.]*/", row[1]) else row[1]  # without instance and parameter
        key = (row[0], row[2], row[3], row[4], re.sub(r"/[^/]*$", "", test))
        if key not in worst or share_used(row) > share_used(worst[key]):
            worst[key] = row
        count[key] = count.get(key, 0) + 1
    text, families = "", ("gas", "membrane", "mesh", "jet", "coupling", "coupled")
    if strange := {key[1] for key in worst if key[1].split("/")[1] not in families}:
        sys.exit(f"claims.py: no section of verification.md for {', '.join(sorted(strange))}")
    for family in families:
        here = [key for key in worst if key[1].startswith(f"verification/{family}/")]
        text += f"## {family.capitalize()}\n\n" if here else ""
        for kind, head, line in (("near", NEAR, near_line), ("order", ORDER, order_line)):
            lines = [line(worst[key], key[4], count[key]) for key in here if key[0] == kind]
            text += head + "".join(lines) + "\n" if lines else ""
    return text


def stability_tables(rows):
    def cell(text):
        return text.replace("|", "\\|")

    def limit(x):
        """Of a band; one that is 1 to six digits is told by its distance."""
        return f"1 {'−' if x < 1 else '+'} {abs(x - 1):.2g}" if x != 1 and (x - 1) ** 2 < 1e-11 else f"{x:.6g}"

    text = ""
    for letter, title in zip("GMJK", ("Gas", "Membrane and time step", "Jet", "Contact and pendulum")):
        failures = {}
        for row in rows:
            if row[0] == "threshold" and row[3][1] == letter:
                failures.setdefault(row[6], []).append(row)
        text += f"## {title}\n\n{THRESHOLD}" if failures else ""
        for failure, lines in failures.items():
            last = None
            for row in lines:
                predicted, measured, low, high = (float(row[i]) for i in (8, 9, 11, 12))
                unit = f" {row[10]}" if row[10] else ""
                text += (f"| {failure}: {cell(row[4])} | {row[3]} {cell(row[7])} | {predicted:.4g}{unit} | {measured:.4g}{unit} "
                         f"| {measured / predicted:.4f} | {limit(low)} to {limit(high)}: {cell(row[5])} "
                         f"| {'〃' if row[13] == last else cell(row[13])} | [{row[1]}](../{row[2]}) |\n")
                last = row[13]
        text += "\n" if failures else ""
    return text


# --- what differs: the rules are those that the head of each page states

def number(cell):
    return float(cell.split()[0])


def cells_of(text):
    """The cells of the rows that name a test."""
    return [line[2:-2].split(" | ") for line in text.splitlines() if line.endswith(") |") and "](../verification/" in line]


def drift_of_numbers(name, old, new):
    exact, error, allowed, checks = number(new[3]), number(new[4]), number(new[5]), new[7]
    round_off = allowed < 1e-9
    if error > allowed:
        yield f"{name}: error {error:g} is more than allowed {allowed:g}"
    if checks == "1" and abs(exact - number(old[3])) > 1e-6 * abs(exact) + (allowed if round_off else 0):
        yield f"{name}: exact is {new[3]}, in the report {old[3]}"
    if not (round_off and checks != "1") and abs(allowed - number(old[5])) > 0.02 * allowed:
        yield f"{name}: allowed is {allowed:g}, in the report {old[5]}"
    if not round_off and abs(error - number(old[4])) > 0.1 * allowed:
        yield f"{name}: error is {error:g}, in the report {old[4]}"


def drift_of_orders(name, old, new):
    now, then = new[3].split(), old[3].split()
    if len(now) != len(then):
        yield f"{name}: has other levels than in the report"
        return
    if any(abs(float(a) - float(b)) > 0.05 for a, b in zip(now, then)):
        yield f"{name}: orders are {new[3]}, in the report {old[3]}"
    if any(abs(float(a) - float(b)) > 0.05 * abs(float(a)) for a, b in zip(new[2].split(), old[2].split())):
        yield f"{name}: errors are {new[2]}, in the report {old[2]}"


def verification_drift(page, tables):
    def keyed(text):  # a number: equation, what, why, checks, proved, test; orders: band too
        return {(*cells[:2], *cells[6 if len(cells) == 10 else 4:]): cells for cells in cells_of(text)}
    old, new = keyed(page), keyed(tables)
    for key, cells in new.items():
        name = f"{cells[0]}: {cells[1]}"
        if key not in old:
            yield f"{name}: not in the report"
        else:
            yield from (drift_of_numbers if len(cells) == 10 else drift_of_orders)(name, old[key], cells)
    for key in old.keys() - new.keys():
        if not re.search(r"(_long_test|ensemble_test)\.cpp", key[-1]):  # not of the fast tests
            yield f"{key[0]}: {key[1]}: no test says this any more"


def stability_drift(page, tables):
    old, new = ({(cells[0], cells[7]): cells for cells in cells_of(text)} for text in (page, tables))
    for key, cells in new.items():
        if key not in old:
            yield f"{key[0]}: not in the atlas"
        elif [cells[i] for i in (1, 5, 6)] != [old[key][i] for i in (1, 5, 6)]:
            yield f"{key[0]}: formula, band or what is past it reads otherwise: {cells[1]}, {cells[5]}, {cells[6]}"
        else:
            for column, what, share in ((2, "predicted", 1e-3), (4, "ratio", 5e-3)):
                now, then = number(cells[column]), number(old[key][column])
                if abs(now - then) > share * abs(then):
                    yield f"{key[0]}: {what} is {now:g}, in the atlas {then:g}"
    for key in old.keys() - new.keys():
        yield f"{key[0]}: no test says this any more"


PAGES = ((VERIFICATION, verification_tables, verification_drift), (STABILITY, stability_tables, stability_drift))


# --- the command

def run_tests(folder):
    """Builds and runs every test that writes rows, long ones too. CI writes the same rows to build/claims while it tests."""
    sources = [path.read_text(encoding="utf-8") for path in ROOT.glob("verification/**/*_test.cpp")]
    suites = {suite for text in sources if "claim::expect_" in text for suite in re.findall(r"^TEST(?:_F|_P)?\((\w+), ", text, flags=re.M)}
    for command in (["cmake", "--preset", "release"], ["cmake", "--build", "--preset", "release", "-j", str(os.cpu_count())],
                    ["ctest", "--test-dir", "build", "-R", rf"(^|/)({'|'.join(sorted(suites))})\.", "--no-tests=error",
                     "--output-on-failure", "-j", str(os.cpu_count())]):
        with open(folder / "log", "a", encoding="utf-8") as log:
            if subprocess.run(command, cwd=ROOT, env={**os.environ, "GASJET_CLAIMS": str(folder)}, stdin=subprocess.DEVNULL, stdout=log).returncode:
                sys.exit(f"claims.py: failed: {' '.join(command)[:60]}\n" + (folder / "log").read_text(encoding="utf-8")[-4000:])


def write(folder):
    rows = rows_of(folder)
    for path, tables_of, _ in PAGES:
        head = path.read_text(encoding="utf-8").partition("\n## Gas\n")[0]
        tables = tables_of(rows)
        path.write_text(f"{head}\n{tables}", encoding="utf-8")
        print(f"{path.relative_to(ROOT)}: {len(cells_of(tables))} rows")


def check(folder):
    rows, wrong = rows_of(folder), False
    for path, tables_of, drift_of in PAGES:
        tables = tables_of(rows)
        drift = sorted(set(drift_of(path.read_text(encoding="utf-8"), tables)))
        for line in drift:
            print(line)
        page = path.relative_to(ROOT)
        print(f"{page} is not what the tests say: docs/make/pages/claims.py writes it anew" if drift
              else f"{page} holds: {len(cells_of(tables))} rows")
        wrong = wrong or bool(drift)
    return 1 if wrong else 0


def main(arguments):
    if arguments[:1] == ["--check"] and len(arguments) <= 2:
        return check(arguments[1] if len(arguments) == 2 else ROOT / "build/claims")
    if arguments[:1] == ["--from"] and len(arguments) == 2:
        return write(arguments[1])
    if arguments:
        print(f"claims.py: cannot take '{' '.join(arguments)}'; allowed: nothing, --from ROWS, --check [ROWS]", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        run_tests(pathlib.Path(folder))
        return write(folder)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
