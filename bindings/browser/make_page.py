#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the page that runs Gasjet in a browser: one file, which needs no network.

It holds gasjet.wasm of preset `browser`, the shipped cases with their files, the reference of keys in docs/case_files.md and
three.js for the reports.
usage: make_page.py BUILD PAGE      build-browser, build/site/try.html"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
REPORT = ROOT / "driver" / "report" / "src" / "page"
THREE = [pathlib.Path("/usr/share/javascript/three") / name for name in ("three.min.js", "examples/js/controls/OrbitControls.js")]
SCRIPTS = ("packing", "case_text", "editor", "jobs", "plot", "runs", "main")


def packed(content):
    """gzip as text of seven bits a character, a seventh longer; HTML would change NUL, CR and <, which stand 256 higher."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(content)
        file.flush()
        data = subprocess.run(["zopfli", "-c", "--i5", file.name], capture_output=True, check=True).stdout
    bits = "".join(f"{byte:08b}" for byte in data)
    bits += "0" * (-len(bits) % 7)
    codes = (int(bits[i:i + 7], 2) for i in range(0, len(bits), 7))
    return "".join(chr(code + 256 if code in (0, 13, 60) else code) for code in codes)


def cases():
    """{name: {text, files}}, the paper's scene first."""
    found = {}
    for file in sorted((ROOT / "cases").glob("*.toml"), key=lambda f: (f.stem != "passenger_pendulum", f.stem)):
        text = file.read_text()
        names = set(re.findall(r'^[^#\n]*?"([\w./-]+\.(?:csv|obj|toml))"', text, re.M)) | set(re.findall(r'"([\w./-]+\.(?:csv|obj))"', text))
        found[file.stem] = {"text": text, "files": {name: (file.parent / name).read_text() for name in sorted(names)
                                                    if (file.parent / name).is_file()}}
    return found


def plain(cell):
    return re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", cell).replace("`", "").strip()


def reference():
    """{"table.key": [meaning, unit, allowed, default]} of the tables in docs/case_files.md."""
    keys, table = {}, ""
    for line in (ROOT / "docs" / "case_files.md").read_text().splitlines():
        head = re.match(r"#+ `\[+([\w.]+)\]+`", line)
        if line.startswith("#"):
            table = head[1] if head else ""
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not table or len(cells) != 5 or not cells[0].startswith("`"):
            continue
        for key in re.findall(r"`([^`]+)`", cells[0]):
            name = f"{table}.{table.split('.')[-1]}" if key == table.split(".")[-1] else f"{table}.{key}"
            keys[name] = [plain(cell) for cell in cells[1:]]
    return keys


def units():
    """Units by the endings of columns, as the program has them."""
    text = (ROOT / "driver" / "results" / "include" / "results" / "unit_endings.hpp").read_text()
    return dict(re.findall(r'\{"(_\w+)", "([^"]+)"\}', text))


def as_script(text):
    return text.replace("</script", "<\\/script")


def three():
    return [as_script(file.read_text()) if file.exists() else "" for file in THREE]


def page(build):
    read = lambda name: (HERE / "page" / name).read_text()
    version = re.search(r"GASJET_VERSION ([\d.]+)", (ROOT / "cmake" / "GasjetVersion.cmake").read_text())[1]
    parts = {
        "STYLE": (REPORT / "page.css").read_text() + read("page.css"),
        "VERSION": f"Version {version}.",
        "WASM": packed((build / "gasjet.wasm").read_bytes()),
        "DATA": packed(json.dumps({"cases": cases(), "keys": reference(), "units": units(), "three": three()}).encode()),
        "WORKER": packed((build / "gasjet.js").read_bytes() + read("worker.js").encode()),
        "SCRIPT": as_script("".join(read(f"{name}.js") for name in SCRIPTS)),
    }
    text = read("page.html")
    assert set(re.findall("@@(\\w+)@@", text)) == set(parts)
    return re.sub("@@(\\w+)@@", lambda place: parts[place[1]], text)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    text = page(pathlib.Path(sys.argv[1]))
    pathlib.Path(sys.argv[2]).write_bytes(text.encode())
    print(f"{sys.argv[2]}: {len(text.encode()) / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
