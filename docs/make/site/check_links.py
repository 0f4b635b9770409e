#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Checks a folder of HTML pages: each internal link leads to a file and an anchor of the folder, no page loads anything from
# elsewhere, and no equation is left as source. usage: check_links.py FOLDER
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADED = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("source", "src")}


class Page(HTMLParser):
    """Links (line, tag, attribute, target) and anchors of one page."""

    def __init__(self, text):
        super().__init__()
        self.links = []
        self.anchors = set()
        self.equation_lines = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append((self.getpos()[0], tag, name, value))
            elif name == "class" and value == "arithmatex":
                self.equation_lines.append(self.getpos()[0])


def problem(folder, pages, file, tag, attribute, target):
    """What is wrong with one link; empty if nothing is."""
    url = urlsplit(target)
    if url.scheme or url.netloc:
        loads = (tag, attribute) in LOADED and url.scheme != "data"
        return "loaded from elsewhere" if loads else ""
    goal = file
    if url.path:
        base = folder if url.path.startswith("/") else file.parent
        goal = (base / unquote(url.path).lstrip("/")).resolve()
    if goal.is_dir():
        goal = goal / "index.html"
    if not goal.is_file():
        return "no such file"
    anchor = unquote(url.fragment)
    if goal in pages and anchor and anchor not in pages[goal].anchors:
        return "no such anchor"
    return ""


def main(folder):
    folder = folder.resolve()
    skipped = folder / "api"  # doxygen checks its own links
    files = [file for file in sorted(folder.rglob("*.html")) if skipped not in file.parents]
    pages = {file: Page(file.read_text(encoding="utf-8")) for file in files}
    problems = []
    for file, page in pages.items():
        name = file.relative_to(folder)
        problems += [f"{name}:{line}: equation left as source" for line in page.equation_lines]
        for line, tag, attribute, target in page.links:
            if file.name == "404.html" and target.startswith("/"):
                continue  # its links are absolute: they hold where the site is published
            wrong = problem(folder, pages, file, tag, attribute, target)
            if wrong:
                problems.append(f"{name}:{line}: {target}: {wrong}")
    print("\n".join(problems) if problems else f"{len(pages)} pages, all links hold")
    return 1 if problems or not pages else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
