# SPDX-License-Identifier: Apache-2.0
"""Takes into a folder the shared libraries that its programs need, each under a name of its content, as auditwheel does.

Two versions of a library can then be in one process, and none of the machine's is taken by mistake. glibc and gcc's libraries stay
outside: all machines with a Python for them have these.
"""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess

OUTSIDE = re.compile(r"(linux-vdso|ld-linux.*|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+))\.so(\..*)?")


def take_in(folder):
    """Libraries of the system that files in the folder need are copied into it. Returns where they were."""
    own = [file for file in sorted(folder.iterdir()) if is_elf(file)]
    found = {}
    for file in own:
        found.update(libraries_of(file, folder))
    copies = {name: folder / named_by_content(path) for name, path in sorted(found.items())}
    for name, copy in copies.items():
        shutil.copyfile(found[name], copy)
        patch(copy, "--set-soname", copy.name)
    names = [word for name, copy in copies.items() for word in ("--replace-needed", name, copy.name)]
    for file in [*own, *copies.values()]:
        patch(file, *names)
        patch(file, "--force-rpath", "--set-rpath", "$ORIGIN")
    for file in [*own, *copies.values()]:
        if left := libraries_of(file, folder):
            raise SystemExit(f"gasjet: patchelf failed, {file.name} still needs {', '.join(left)}: install Debian's patchelf 0.14 or later")
    return sorted(found.values())


def patch(file, *options):
    """One change a call: two that make the file longer overwrite each other (patchelf 0.14)."""
    if subprocess.run(["patchelf", *options, file]).returncode:
        raise SystemExit(f"gasjet: patchelf {options[0]} failed for {file.name}, see above")


def is_elf(file):
    with open(file, "rb") as stream:
        return stream.read(4) == b"\x7fELF"


def libraries_of(file, folder):
    """Name and path of all that the loader takes from elsewhere."""
    listed = subprocess.run(["ldd", file], check=True, stdout=subprocess.PIPE, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    found = {}
    for name, path in re.findall(r"^\s*(\S+) => (.*?)(?: \(0x[0-9a-f]+\))?$", listed, re.M):
        if path == "not found":
            raise SystemExit(f"gasjet: {file.name} needs {name}, which this machine does not have: build again here")
        if not OUTSIDE.fullmatch(name) and pathlib.Path(path).parent.resolve() != folder.resolve():
            found[name] = pathlib.Path(path).resolve()
    return found


def named_by_content(path):
    stem, version = re.fullmatch(r"(.*?)(\.so.*)", path.name).groups()
    return f"{stem}-{hashlib.sha256(path.read_bytes()).hexdigest()[:8]}{version}"


def licences_of(libraries):
    """The copyright file of each library's package, by a name for it; none where dpkg does not know the library."""
    known = {}
    for path in libraries if shutil.which("dpkg-query") else ():
        names = [str(path), str(path).removeprefix("/usr")]  # dpkg has the one that the package was made with
        owner = subprocess.run(["dpkg-query", "-S", *names], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
        package = owner.split(":")[0]
        file = pathlib.Path("/usr/share/doc") / package / "copyright"
        if package and file.is_file():
            known[f"{package}/copyright"] = file.read_bytes()
    return known
