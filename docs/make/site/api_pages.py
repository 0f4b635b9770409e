#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the reference of the bindings as Markdown: python.md from the package's docstrings, c.md from the headers, fortran.md from the
module that is made of them. Fails where something public in Python has no docstring.
usage: api_pages.py OUTPUT_FOLDER"""
import ast
import inspect
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = ROOT / "bindings/python/gasjet"
HEADERS = [*sorted((ROOT / "bindings/c/include/gasjet").glob("*.h")), ROOT / "bindings/c/include/gasjet_exact.h"]


def prose(text):
    """Plain words as Markdown; paragraphs, lists and `code` stay."""
    text = re.sub(r"`[^`]*`|[\\*_<>\[\]`$|#]", lambda found: found[0] if found[0][1:] else "\\" + found[0], text)
    return re.sub(r"\n(?=- )", "\n\n", text, count=1) + "\n\n"


def code(language, text):
    return f"```{language}\n{text.rstrip()}\n```\n\n"


# Python

def docstring(node, name):
    text = ast.get_docstring(node)
    if not text:
        sys.exit(f"api_pages.py: gasjet.{name} has no docstring")
    return prose(inspect.cleandoc(text))


def signature(node, name, is_method):
    arguments = ast.parse(f"def f({ast.unparse(node.args)}): ...").body[0].args
    decorators = [ast.unparse(one) for one in node.decorator_list]
    if is_method and "staticmethod" not in decorators:
        arguments.args.pop(0)
    if "property" in decorators:
        return f"{name}: {ast.unparse(node.returns)}" if node.returns else name
    result = f" -> {ast.unparse(node.returns)}" if node.returns and node.name != "__init__" else ""
    return f"{name}({ast.unparse(arguments)}){result}"


def of_class(node):
    members = [one for one in node.body if isinstance(one, ast.FunctionDef)]
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    made = [signature(one, node.name, True) for one in members if one.name == "__init__"]
    text = f"### {node.name}\n\n" + code("python", made[0] if made else f"class {node.name}({bases})") + docstring(node, node.name)
    for one in members:
        if one.name.startswith("_"):
            continue
        name = f"{node.name}.{one.name}"
        text += code("python", signature(one, name, True)) + docstring(one, name)
    return text


def of_function(node):
    return f"### {node.name}\n\n" + code("python", "gasjet." + signature(node, node.name, False)) + docstring(node, node.name)


def python_page():
    start = ast.parse((PACKAGE / "__init__.py").read_text())
    (names,) = (ast.literal_eval(one.value) for one in start.body if isinstance(one, ast.Assign) and one.targets[0].id == "__all__")
    defined = {one.name: one for file in sorted(PACKAGE.glob("*.py")) for one in ast.parse(file.read_text()).body
               if isinstance(one, (ast.ClassDef, ast.FunctionDef))}
    missing = sorted(set(names) - set(defined))
    if missing:
        sys.exit(f"api_pages.py: gasjet.{missing[0]} is in __all__, but no file defines it")
    public = [defined[name] for name in sorted(names, key=str.lower)]
    kinds = "In signatures, `Path` is a text or an `os.PathLike`, `Case` a file or a dict of its tables, `Vector` three numbers.\n\n"
    return ("# Python API\n\n" + docstring(start, "__init__") + kinds + "## Functions\n\n"
            + "".join(of_function(one) for one in public if isinstance(one, ast.FunctionDef))
            + "## Classes\n\n" + "".join(of_class(one) for one in public if isinstance(one, ast.ClassDef)))


# C and Fortran: comments stand before what they are about, blank lines between.

def c_words(comment):
    lines = [re.sub(r"^\s*\*? ?", "", line) for line in comment.strip().removeprefix("/*").removesuffix("*/").split("\n")]
    return prose("\n".join(lines).strip())


def c_block(block):
    """A comment and one declaration or more."""
    found = re.match(r"\s*(/\*.*?\*/)?\s*(.*)", block, re.S)
    declarations = re.sub(r"GASJET_API |__attribute__\S*", "", found[2]).strip()
    if not declarations or declarations.startswith(("#", "}", "extern")):
        return ""
    named = r"(?:typedef )?(?:struct|enum) (\w+)|.*?\(\*(\w+)\)|[^(]*?(\w+)\(|typedef [^;]*?(\w+);"
    each = [re.match(named, one, re.S).groups() for one in re.split(r"(?<=;)\n(?=\w)", declarations)]
    names = ", ".join(next(name for name in groups if name) for groups in each)
    return f"### {names}\n\n" + code("c", declarations) + c_words(found[1] or "")


def c_page():
    about = re.search(r"/\*.*?\*/", (ROOT / "bindings/c/include/gasjet.h").read_text(), re.S)[0]
    text = "# C API\n\n" + c_words(about)
    for header in HEADERS:
        first, *blocks = header.read_text().split("\n", 1)[1].split("\n\n")
        text += f"## {header.relative_to(ROOT / 'bindings/c/include')}\n\n" + c_words(re.search(r"/\*.*?\*/", first, re.S)[0])
        text += "".join(c_block(block) for block in blocks)
    return text


def fortran_module():
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "gasjet.f90")
        made = ROOT / "bindings/fortran"
        subprocess.run([sys.executable, "-B", made / "make_module.py", made / "gasjet.f90.in", file, *HEADERS], check=True)
        return file.read_text()


def fortran_block(block):
    lines = inspect.cleandoc("\n" + block).split("\n")
    count = next((i for i, line in enumerate(lines) if not line.startswith("!")), len(lines))
    words, rest = [line[1:].strip() for line in lines[:count]], "\n".join(lines[count:])
    named = re.search(r"^(?:type, bind\(c\) ::|function) (\w+)", rest, re.M)
    if not named:
        return ""
    return f"### {named[1]}\n\n" + code("fortran", rest) + prose("\n".join(words))


def fortran_page():
    module = fortran_module()
    about = [line[1:].strip() for line in module.split("\n")[1:5] if line.startswith("!")]
    numbers = "\n".join(line.strip() for line in module.split("\n") if line.startswith("  integer(c_int), parameter"))
    body = re.sub(r"^ *(interface|end interface|contains|end module.*)$", "", module, flags=re.M).split("\n\n")
    return ("# Fortran API\n\n" + prose("\n".join(about)) + "## Constants\n\n" + code("fortran", numbers)
            + "## Types and functions\n\n" + "".join(fortran_block(block) for block in body))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.split("usage: ")[1])
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    for name, page in (("python", python_page), ("c", c_page), ("fortran", fortran_page)):
        (out / f"{name}.md").write_text(page().rstrip() + "\n")


if __name__ == "__main__":
    main()
