#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the Fortran module from the C headers, so that nothing is kept by hand in two places.

usage: make_module.py TEMPLATE OUTPUT HEADER...
In a header `x[]` is an array and `*x` one value; GASJET_OR_NULL makes an argument optional.
"""
import re
import sys

KINDS = {
    "double": "real(c_double)",
    "float": "real(c_float)",
    "int": "integer(c_int)",
    "int32_t": "integer(c_int32_t)",
    "int64_t": "integer(c_int64_t)",
    "uint8_t": "integer(c_int8_t)",
    "char": "character(kind=c_char)",
    "gasjet_handle": "integer(c_int64_t)",
}


def kind_of(name, structs):
    if name in structs:
        return f"type({name})"
    if name not in KINDS:
        sys.exit(f"make_module.py: no Fortran kind for the C type {name}")
    return KINDS[name]


def argument(text, structs, callbacks):
    """One C parameter as a Fortran declaration, and its name."""
    optional = "GASJET_OR_NULL" in text
    text = " ".join(text.replace("GASJET_OR_NULL", " ").split())
    match = re.fullmatch(r"(const )?(\w+) ?(\**) ?(\w+)(\[(\d*)\])?", text)
    if not match:
        sys.exit(f"make_module.py: cannot read the parameter '{text}'")
    const, base, stars, name, array, size = match.groups()
    if base in callbacks:
        return f"type(c_funptr), value :: {name}", name
    if base == "void":
        return f"type(c_ptr), value :: {name}", name
    if stars == "**":
        return f"type(c_ptr), intent(out) :: {name}", name
    if not stars and not array:
        return f"{kind_of(base, structs)}, value :: {name}", name
    shape = f"({size or '*'})" if array or base == "char" else ""
    intent = "in" if const else "inout"
    return f"{kind_of(base, structs)}, intent({intent}){', optional' if optional else ''} :: {name}{shape}", name


def all_of(found, wanted, where):
    if len(found) != wanted:
        sys.exit(f"make_module.py: reads {len(found)} of {wanted}: {where}")


def comment(text, indent):
    lines = [line.strip().lstrip("*").strip() for line in text.replace("\x02", ";").splitlines()]
    return "".join(f"{indent}! {line}\n" for line in lines if line)


def read(headers):
    text = "".join(open(header, encoding="utf-8").read() for header in headers)
    # Comments are marked with single characters, so that one expression finds what follows them.
    return re.sub(r"/\*(.*?)\*/", lambda m: "\x01" + m.group(1).replace(";", "\x02") + "\x03", text, flags=re.S)


def parameters_of(source):
    body = ""
    for found in re.finditer(r"enum \w+ \{(.*?)\};", source, re.S):
        pattern = r"(GASJET_\w+)\s*=\s*(\d+)\s*,?\s*(?:\x01([^\x03]*)\x03)?"
        listed = re.findall(pattern, found.group(1))
        all_of(listed, found.group(1).count("="), found.group(0))
        for name, value, text in listed:
            body += comment(text, "  ") + f"  integer(c_int), parameter :: {name} = {value}\n"
    return body


def types_of(source):
    body, structs = "", []
    pattern = r"(?:\x01([^\x01\x03]*)\x03\s*)?typedef struct (\w+) \{(.*?)\} \2;"
    for text, name, fields in re.findall(pattern, source, re.S):
        body += "\n" + comment(text, "  ") + f"  type, bind(c) :: {name}\n"
        listed = re.findall(r"(\w+) (\w+)(\[\d+\])?;\s*(?:\x01([^\x03]*)\x03)?", fields)
        all_of(listed, fields.count(";"), name)
        for kind, field, size, note in listed:
            shape = f"({size[1:-1]})" if size else ""
            note = " ".join(note.replace("\x02", ";").split())
            body += f"    {kind_of(kind, structs)} :: {field}{shape}  ! {note}\n"
        body += f"  end type {name}\n"
        structs.append(name)
    all_of(structs, source.count("typedef struct"), "structures")
    return body, structs


def functions_of(source, structs):
    callbacks = re.findall(r"typedef int \(\*(\w+)\)", source)
    body = ""
    pattern = r"(?:\x01([^\x01\x03]*)\x03\s*)?GASJET_API ([\w ]+?\*?) ?(\w+)\(([^;]*)\);"
    functions = re.findall(pattern, source, re.S)
    all_of(functions, source.count("GASJET_API ") - source.count("#define GASJET_API "), "functions")
    for text, result, name, parameters in functions:
        listed = [] if parameters.strip() == "void" else [argument(p, structs, callbacks) for p in parameters.split(",")]
        names = ", &\n        ".join(n for _, n in listed)
        body += "\n" + comment(text, "    ")
        body += f"    function {name}({names}) &\n        bind(c, name='{name}') result(status)\n      import\n"
        body += "".join(f"      {declaration}\n" for declaration, _ in listed)
        body += f"      {'type(c_ptr)' if '*' in result else KINDS[result]} :: status\n    end function {name}\n"
    return body


def main():
    template, output, *headers = sys.argv[1:]
    source = read(headers)
    types, structs = types_of(source)
    text = open(template, encoding="utf-8").read()
    text = text.replace("@PARAMETERS@\n", parameters_of(source)).replace("@TYPES@\n", types)
    text = text.replace("@FUNCTIONS@\n", functions_of(source, structs))
    with open(output, "w", encoding="utf-8") as file:
        file.write(text)


main()
