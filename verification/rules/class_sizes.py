# SPDX-License-Identifier: Apache-2.0
"""Members of each class and struct, and the .cpp files that its functions are in.

It has at most MEMBERS members, and its functions are in at most SOURCES .cpp files: then its idea fits in its first
comment. Members are functions and data, private ones and overloads too; types, aliases, friends, and functions that are
defaulted or deleted do not count."""

import collections
import re

from tree import rule

MEMBERS, SOURCES = 25, 2
# A function of a class where it is defined; the name of the class.
DEFINITION = (r"^(?![\s}#/])(?:[^;{}()=]*[\s&*>])?(\w+)(?:<[^;{}()]*>)?::~?\w+(?:\s*[=!<>+\-*/\[\]()]+)?\s*\(")


def without_comments(text):
    blank = lambda found: re.sub(r"[^\n]", " ", found[0])
    text = re.sub(r'R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*(?:.|\n)*?\*/', blank, text)
    return re.sub(r"^[ \t]*#(?:.*\\\n)*.*$", blank, text, flags=re.M)  # and directives


def closing(text, start):
    """Where the brace that opens at `start` closes."""
    depth = 0
    for i in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return len(text)


def declarations(body):
    """The members of a class body, one text each, without what stands in braces."""
    part, i, depth = "", 0, 0
    while i < len(body):
        c = body[i]
        if c == "{":
            end = closing(body, i)
            i = end
            part += "{}"
            if re.search(r"\)\s*(const|noexcept|override|final|\s|:.*|->.*)*\{\}$", part, re.S) and \
                    not re.match(r"\s*(struct|class|enum|union)\b", part):
                yield part
                part = ""
        elif c == ";" and depth == 0:
            yield part
            part = ""
        else:
            depth += {"(": 1, ")": -1}.get(c, 0)
            part += c
        i += 1


def names(declaration):
    """How many members a declaration makes."""
    text = re.sub(r"\b(public|private|protected)\s*:", " ", declaration).strip()
    text = re.sub(r"^(template\s*<[^{}]*?>\s*(?=[A-Za-z]))+", "", text)
    if not text or re.match(r"(using|typedef|friend|static_assert|enum)\b", text) or re.search(r"=\s*(default|delete)$", text):
        return 0
    if re.match(r"(struct|class|union)\s+\w+[^()]*(\{\})?$", text):
        return 0
    if "(" in re.sub(r"<[^<>]*>|\{\}|=.*", "", text):
        return 1
    return 1 + re.sub(r"<[^;]*>|\([^()]*\)|\{\}", "", text).count(",")


def classes(path, text):
    """(place, name, members) of each class or struct with a body."""
    for found in re.finditer(r"\b(class|struct)\s+(?:alignas\([^)]*\)\s*)?(\w+)\s*(?:final\s*)?(?::[^:;{}()][^;{}()]*)?\{", text):
        if text[:found.start()].rstrip().endswith("enum"):
            continue
        body = text[found.end():closing(text, found.end() - 1)]
        yield f"{path}:{text.count(chr(10), 0, found.start()) + 1}", found[2], sum(map(names, declarations(body)))


@rule
def class_sizes(tree):
    """Classes of one library and name go together."""
    found, sources = [], collections.defaultdict(set)
    for path in tree.files("*.cpp", "*.hpp", "*.h", under=r"(lib[a-z]+|driver|bindings)/"):
        text, library = without_comments(tree.read(path)), path.split("/")[0]
        found += [(library, *entry) for entry in classes(path, text)]
        if path.endswith(".cpp"):
            for name in re.findall(DEFINITION, text, re.M):
                sources[library, name].add(path)
    for library, place, name, members in found:
        files = len(sources[library, name])
        if members > MEMBERS or files > SOURCES:
            yield f"{place}: {name} has {members} members in {files} .cpp files, at most {MEMBERS} in {SOURCES} are allowed"
