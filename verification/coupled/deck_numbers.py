# SPDX-License-Identifier: Apache-2.0
"""What deck_structure.py and deck_structure_lsdyna.py share: faults, and numbers that a deck defines and names."""

FAULTS = []


def fault(where, text):
    FAULTS.append(f"{where}: {text}")


def blocks(path, mark, comment, last):
    """Each keyword of a file, which begins with `mark`, and the lines below it, with their places; `last` ends it."""
    header, block = None, []
    with open(path, encoding="ascii") as file:
        for number, line in enumerate(file, 1):
            where, line = f"{path}:{number}", line.rstrip("\n")
            if line.startswith(comment):
                continue
            if line.startswith(mark):
                if header:
                    yield header, block
                header, block = (where, line), []
            elif header:
                block.append((where, line))
            else:
                fault(where, "a line before the first keyword")
    if not header or header[1] != last:
        fault(path, f"no {last}")


class Deck:
    """Numbers that are defined and numbers that are named, by kind."""

    def __init__(self):
        self.defined, self.named, self.counts = {}, [], {}
        self.porous, self.members, self.law_of = [], {}, {}  # surfaces that leak; numbers of a list; law of a part
        # Whether a function rises; keyword of a law or property; parts with these; functions of threads.
        self.rising, self.keyword_of, self.parts, self.threads = {}, {}, [], []

    def define(self, where, kind, number):
        numbers = self.defined.setdefault(kind, set())
        if number in numbers:
            fault(where, f"{kind} {number} is there twice")
        numbers.add(number)

    def name(self, where, kind, number):
        if number != 0:
            self.named.append((where, kind, number))

    def resolve(self):
        for where, kind, number in self.named:
            if number not in self.defined.get(kind, set()):
                fault(where, f"{kind} {number} is named and nowhere defined")
