#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes try.html, the page that runs Gasjet in a browser: one file, which needs no network. It holds gasjet.wasm of preset `browser`,
the shipped cases with their files, the reference of keys in docs/case_files.md and three.js for the reports. And live.js, by which places
of other pages become figures (page/live.js), with the programs that it loads: exact_program.js and gasjet_program.js.
usage: make_page.py BUILD      build-browser"""
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
LIVE = ("packing", "case_text", "jobs", "plot", "live")


def packed(content):
    """gzip as text of seven bits a character, a seventh longer; HTML would change NUL, CR and the < of tags, which stand 256 higher."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(content)
        file.flush()
        data = subprocess.run(["zopfli", "-c", "--i15", file.name], capture_output=True, check=True).stdout
    bits = "".join(f"{byte:08b}" for byte in data)
    bits += "0" * (-len(bits) % 7)
    text = "".join(chr(int(bits[i:i + 7], 2)) for i in range(0, len(bits), 7))
    return re.sub(r"[\0\r]|<(?=[/!])", lambda found: chr(ord(found[0]) + 256), text)


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


def read(name):
    return (HERE / "page" / name).read_text()


def program(build, name, data):
    """What startProgram in jobs.js takes."""
    return {"wasm": packed((build / f"{name}.wasm").read_bytes()), "data": packed(json.dumps(data).encode()),
            "worker": packed((build / f"{name}.js").read_bytes() + read("worker.js").encode())}


def page(parts):
    version = re.search(r"GASJET_VERSION ([\d.]+)", (ROOT / "cmake" / "GasjetVersion.cmake").read_text())[1]
    parts = {name.upper(): text for name, text in parts.items()} | {
        "STYLE": (REPORT / "page.css").read_text() + read("page.css"),
        "VERSION": f"Version {version}.",
        "SCRIPT": as_script("".join(read(f"{name}.js") for name in SCRIPTS)),
    }
    text = read("page.html")
    assert set(re.findall("@@(\\w+)@@", text)) == set(parts)
    return re.sub("@@(\\w+)@@", lambda place: parts[place[1]], text)


def as_loaded(parts):
    """A script that adds the program to those that live.js takes."""
    texts = (name + ": `" + re.sub(r"[\\`$]", r"\\\g<0>", text) + "`" for name, text in parts.items())
    return "gasjetPrograms.push({" + ", ".join(texts) + "});\n"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build, data = pathlib.Path(sys.argv[1]), {"cases": cases(), "units": units()}
    runs = program(build, "gasjet", data)
    whole = packed(json.dumps({**data, "keys": reference(), "three": three()}).encode())
    files = {"live.js": "(() => {\n" + "".join(read(f"{name}.js") for name in LIVE) + "})();\n",
             "exact_program.js": as_loaded(program(build, "exact", {"units": units()})),
             "gasjet_program.js": as_loaded(runs),
             "try.html": page(runs | {"data": whole})}
    for name, text in files.items():
        (build / name).write_bytes(text.encode())
        print(f"{build / name}: {len(text.encode()) / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
