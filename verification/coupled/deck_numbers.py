# SPDX-License-Identifier: Apache-2.0
"""What deck_structure.py and deck_structure_lsdyna.py share: faults, and numbers that a deck defines and names."""

FAULTS = []


def fault(where, text):
    FAULTS.append(f"{where}: {text}")


class Deck:
    """Numbers that are defined and numbers that are named, by kind."""

    def __init__(self):
        self.defined, self.named, self.counts = {}, [], {}

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
