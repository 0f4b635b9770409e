# SPDX-License-Identifier: Apache-2.0
"""Reads the impactor out of a deck of `gasjet export`, by columns, in SI units. It shares nothing with the writers.

One dictionary for both formats: mass, centre of gravity (cg), inertia, velocity, spin, nodes and triangles of the surface (x,
faces), gap, held (what a rail leaves free is 0: three shifts, three turns), axes, load (curve, 'force' or 'moment', direction),
springs (curve of force over elongation, damping, place of the end that is held), and gravity (three curves).
"""
import math

FILES = {"radioss": "bag_0000.rad", "lsdyna": "bag.k"}
SYSTEMS = {"kg-m-s": (1.0, 1.0, 1.0), "t-mm-s": (1e3, 1e-3, 1.0), "kg-mm-ms": (1.0, 1e-3, 1e-3)}  # kg, m, s


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [v / math.hypot(*a) for v in a]


def columns(line, *widths):
    """Numbers of a line; a blank field is 0."""
    values, at = [], 0
    for width in widths:
        text = line[at:at + width].strip()
        values.append(float(text or 0))
        at += width
    return values


def blocks(path, mark, comment):
    """(header, lines) of each keyword."""
    found = []
    with open(path, encoding="ascii") as file:
        for line in file.read().split("\n"):
            if line.startswith(mark):
                found.append((line, []))
            elif line and not line.startswith(comment) and found:
                found[-1][1].append(line)
    return found


def symmetric(xx, yy, zz, xy, yz, xz):
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


def take_surface(deck, nodes, triangles):
    numbers = {n: i for i, n in enumerate(sorted({n for face in triangles for n in face}))}
    deck["x"] = [nodes[n] for n in sorted(numbers)]
    deck["faces"] = [[numbers[n] for n in face] for face in triangles]


def read_radioss(path, mass, length, time):
    force, E = mass * length / time**2, [20] * 5
    nodes, parts, curves, groups, skews, springs, shells, held = {}, {}, {}, {}, {}, {}, {}, {}
    deck = {"springs": [], "gravity": [[], [], []], "velocity": [0.0] * 3, "spin": [0.0] * 3, "held": [0] * 6, "load": None}
    found = blocks(path, "/", "#")
    for header, lines in found:
        key = header[1:].split("/")
        number = int(key[-1]) if key[-1].isdigit() else None
        if key[0] == "NODE":
            nodes |= {int(line[:10]): [length * v for v in columns(line[10:], *E[:3])] for line in lines}
        elif key[0] == "PART":
            parts[number] = (lines[0], int(lines[1][:10]))
        elif key[0] == "FUNCT":
            curves[number] = [columns(line, 20, 20) for line in lines[1:]]
        elif key[0] == "GRNOD":
            groups[number] = [int(v) for line in lines[1:] for v in line.split()]
        elif key[:2] == ["SKEW", "FIX"]:
            y, z = columns(lines[2], *E[:3]), columns(lines[3], *E[:3])
            x = unit(cross(y, z))
            skews[number] = [x, unit(cross(z, x)), unit(z)]
        elif key[0] == "SH3N":
            shells[number] = [[int(line[at:at + 10]) for at in (10, 20, 30)] for line in lines]
        elif key[:2] == ["PROP", "SPRING"]:
            springs[number] = lines
        elif key[0] == "BCS":
            held[int(lines[1][20:30])] = (lines[1][:10].split(), int(lines[1][10:20]))
    curve = lambda line, at, unit_of, y=1.0: [(time * a, y * unit_of * b) for a, b in curves[int(line[at:at + 10])]]
    for header, lines in found:
        key = header[1:].split("/")
        if key == ["RBODY", "1"]:
            main, group = int(lines[1][:10]), int(lines[1][60:70])
            assert int(lines[1][80:90]) == 4  # ICoG: by the card alone
            deck["mass"], deck["cg"] = mass * columns(lines[1][40:], 20)[0], nodes[main]
            inertia = columns(lines[2], *E[:3]) + columns(lines[3], *E[:3])
            deck["inertia"] = [[mass * length**2 * v for v in row] for row in symmetric(*inertia)]
            body = set(groups[group])
        elif key[0] == "INIVEL":
            assert groups[int(lines[1][60:70])] == [main]
            of = ("velocity", length / time) if key[1] == "TRA" else ("spin", 1 / time)
            deck[of[0]] = [of[1] * v for v in columns(lines[1], *E[:3])]
        elif key[0] == "CLOAD":
            way, skew = lines[1][10:20].strip(), int(lines[1][20:30])
            assert groups[int(lines[1][40:50])] == [main]
            scale = columns(lines[1][80:], 20)[0]
            kind, size = ("moment", force * length) if len(way) == 2 else ("force", force)
            deck["load"] = (curve(lines[1], 0, size, scale), kind, skews[skew]["XYZ".index(way[0])])
        elif key[0] == "GRAV":
            assert main in groups[int(lines[1][40:50])]
            axis = "XYZ".index(lines[1][10:20].strip())
            deck["gravity"][axis] = curve(lines[1], 0, length / time**2, columns(lines[1][80:], 20)[0])
        elif key[:2] == ["INTER", "TYPE7"] and key[2] == "1":
            deck["gap"] = length * columns(lines[4][40:], 20)[0]
        elif key[0] == "SPRING" and parts[int(key[1])][0] == "spring of the rail":
            prop = springs[parts[int(key[1])][1]]
            fixed, moving = int(lines[0][10:20]), int(lines[0][20:30])
            assert moving in body and math.dist(nodes[moving], deck["cg"]) == 0
            assert any(fixed in groups[g] and code == ["111", "111"] for g, (code, _) in held.items())
            points = [(length * a, force * b) for a, b in curves[int(prop[3][:10])]]
            deck["springs"].append((points, force * time / length * columns(prop[2], 20, 20)[1], nodes[fixed]))
    for group, (code, skew) in held.items():
        if groups[group] == [main]:
            deck["held"], deck["axes"] = [int(v) for v in "".join(code)], skews[skew]
    impactor, = (shells[number] for number, (name, _) in parts.items() if name == "impactor")
    assert {n for face in impactor for n in face} <= body
    take_surface(deck, nodes, impactor)
    return deck


def read_lsdyna(path, mass, length, time):
    force, T = mass * length / time**2, [10] * 8
    nodes, curves, systems, materials, sections, parts, shells, extra = {}, {}, {}, {}, {}, {}, {}, set()
    deck = {"springs": [], "gravity": [[], [], []], "held": [0] * 6, "load": None}
    found = blocks(path, "*", "$")
    for header, lines in found:
        if header == "*NODE":
            nodes |= {int(line[:8]): [length * v for v in columns(line[8:], 16, 16, 16)] for line in lines}
        elif header == "*DEFINE_CURVE":
            curves[int(lines[0][:10])] = [columns(line, 20, 20) for line in lines[1:]]
        elif header == "*DEFINE_COORDINATE_VECTOR":
            v = columns(lines[0], *T[:7])
            x = unit(v[1:4])
            z = unit(cross(x, v[4:7]))
            systems[int(v[0])] = [x, cross(z, x), z]
        elif header.startswith("*MAT_"):
            materials[int(lines[0][:10])] = (header, lines)
        elif header == "*SECTION_SHELL":
            sections[int(lines[0][:10])] = columns(lines[1], 10)[0]
        elif header.startswith("*PART"):
            parts[int(lines[1][:10])] = (int(lines[1][10:20]), int(lines[1][20:30]))
            if header == "*PART_INERTIA":
                body, block = int(lines[1][:10]), lines
        elif header == "*ELEMENT_SHELL":
            for line in lines:
                shells.setdefault(int(line[8:16]), []).append([int(line[at:at + 8]) for at in (16, 24, 32)])
        elif header == "*CONSTRAINED_EXTRA_NODES_NODE":
            extra |= {int(line[10:20]) for line in lines if int(line[:10]) == body}
    v = columns(block[2], *T[:4])
    deck["cg"], deck["mass"] = [length * x for x in v[:3]], mass * v[3]
    xx, xy, xz, yy, yz, zz = columns(block[3], *T[:6])
    deck["inertia"] = [[mass * length**2 * v for v in row] for row in symmetric(xx, yy, zz, xy, yz, xz)]
    v = columns(block[4], *T[:6])
    deck["velocity"], deck["spin"] = [length / time * x for x in v[:3]], [x / time for x in v[3:]]
    deck["gap"] = 0.5 * length * sections[parts[body][0]]
    rigid = materials[parts[body][1]]
    assert rigid[0] == "*MAT_RIGID"
    if float(rigid[1][1][:10]) == -1.0:
        deck["held"] = [int(c) for c in rigid[1][1][20:30].strip().rjust(6, "0")]
        deck["axes"] = systems[int(rigid[1][1][10:20])]
    curve = lambda number, size: [(time * a, size * b) for a, b in curves[number]]
    fixed = set()
    for header, lines in found:
        if header == "*LOAD_RIGID_BODY":
            part, dof, number, scale, system = columns(lines[0], *T[:5])
            assert part == body
            kind, size = ("force", force) if dof <= 3 else ("moment", force * length)
            deck["load"] = (curve(number, scale * size), kind, systems[int(system)][int(dof) - (1 if dof <= 3 else 5)])
        elif header.startswith("*LOAD_BODY_"):  # of the frame: the bodies feel the opposite
            number, scale = columns(lines[0], 10, 10)
            deck["gravity"]["XYZ".index(header[-1])] = curve(number, -scale * length / time**2)
        elif header == "*BOUNDARY_SPC_NODE":
            values = columns(lines[0], *T)
            assert values[2:] == [1] * 6
            fixed.add(int(values[0]))
        elif header == "*ELEMENT_DISCRETE":
            _, part, a, b = (int(v) for v in columns(lines[0], 8, 8, 8, 8))
            if b not in extra:
                continue
            assert a in fixed and math.dist(nodes[b], deck["cg"]) < 1e-6  # fields of ten columns hold five digits or more
            kind, card = materials[parts[part][1]]
            if kind == "*MAT_DAMPER_VISCOUS":
                deck["springs"].append(([(-1.0, 0.0), (1.0, 0.0)], force * time / length * columns(card[0], 10, 10)[1], nodes[a]))
            else:
                points = [(length * x, force * y) for x, y in curves[int(card[0][10:20])]]
                deck["springs"].append((points, 0.0, nodes[a]))
    take_surface(deck, nodes, shells[body])
    return deck


def read_impactor(form, folder, units):
    read = {"radioss": read_radioss, "lsdyna": read_lsdyna}[form]
    return read(f"{folder}/{FILES[form]}", *SYSTEMS[units])
