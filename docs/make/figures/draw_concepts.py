# SPDX-License-Identifier: Apache-2.0
# Draws what words say poorly, as SVG in docs/figures: the two jets with their profiles and the hidden elements (by (J.3) to
# (J.5)), the pendulum test with dimensions from its case file, the balance of the gas, and the passenger bag. GASJET names another
# binary than build/gasjet. usage: python3 docs/make/figures/draw_concepts.py
import json
import math
import os
import re
import subprocess
import tempfile
import tomllib

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
BLUE, VERMILION, INK, QUIET, PALE, SKIN = "#0072b2", "#d55e00", "#222222", "#767676", "#d8eaf5", "#e8c890"


class Drawing:
    def __init__(self, width, height):
        self.size = (width, height)
        self.parts = []

    def path(self, points, stroke=INK, fill="none", width=1.6, dash="", closed=False):
        steps = " L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(
            f'<path d="M{steps}{" Z" if closed else ""}" stroke="{stroke}" fill="{fill}" stroke-width="{width}"{dashes}/>'
        )

    def polygons(self, outlines, stroke, fill, width):
        """Many as one path."""
        steps = "".join("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points) + "Z" for points in outlines)
        self.parts.append(f'<path d="{steps}" stroke="{stroke}" fill="{fill}" stroke-width="{width}"/>')

    def circle(self, x, y, radius, fill, stroke=INK):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:.1f}" fill="{fill}" stroke="{stroke}"/>')

    def text(self, x, y, words, anchor="start", colour=INK, size=13, weight="normal"):
        """What follows a _ is a subscript. Not by baseline-shift, which not all browsers know."""
        words = re.sub(r"_(\w+)", rf'<tspan dy="3" font-size="{0.75 * size:.0f}">\1</tspan><tspan dy="-3">&#8203;</tspan>', words)
        self.parts.append(
            f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}" font-size="{size}" font-weight="{weight}">{words}</text>'
        )

    def arrow(self, x0, y0, x1, y1, colour=INK, both=False, width=1.2):
        self.path([(x0, y0), (x1, y1)], colour, width=width)
        angle = math.atan2(y1 - y0, x1 - x0)
        for x, y, way in [(x1, y1, angle)] + ([(x0, y0, angle + math.pi)] if both else []):
            corners = [(x - 8 * math.cos(way + turn), y - 8 * math.sin(way + turn)) for turn in (0.35, -0.35)]
            self.path([(x, y), *corners], colour, colour, 0.5, closed=True)

    def write(self, name):
        width, height = self.size
        with open(os.path.join(ROOT, "docs/figures", name + ".svg"), "w", encoding="utf-8") as file:
            file.write(
                f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
                'font-family="sans-serif">\n<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(self.parts) + "\n</svg>\n"
            )
        print(f"docs/figures/{name}.svg")


def decay(shape, distance, coefficient):
    """V_max/V_0 at a distance in units of R_0 (round, J.3) or b_0 (rectangular, J.4)."""
    if shape == "round":
        return min(1.0, 0.96 / (coefficient * distance + 0.29))
    return min(1.0, 1.2 / math.sqrt(coefficient * distance + 0.41))


def width_of(shape, peak):
    """Width R/R_0 or b/b_0 of the Gaussian (J.5)."""
    return math.sqrt(2) / peak if shape == "round" else 2 * math.sqrt(2 / math.pi) / peak**2


def jet(drawing, left, axis, shape, coefficient, unit, title, half):
    """One jet from the side: edge where V is 1/e of that on the axis, and profiles of V/V_0 at three distances."""
    steps = [i * 0.25 for i in range(0, 101)]
    edge = [(left + unit * z, unit * width_of(shape, decay(shape, z, coefficient))) for z in steps]
    drawing.path([(x, axis - r) for x, r in edge] + [(x, axis + r) for x, r in reversed(edge)], BLUE, PALE, 1.2, "6 4", True)
    drawing.path([(left - 14, axis), (left + unit * 25 + 60, axis)], QUIET, width=1, dash="10 4 2 4")
    drawing.path([(left, axis - 118), (left, axis - unit)], INK, width=4)
    drawing.path([(left, axis + unit), (left, axis + 118)], INK, width=4)
    drawing.text(left - 14, axis - 118 - 22, title, weight="bold", size=15)
    for z in (0.6, 10.5, 20):
        peak = decay(shape, z, coefficient)
        across = unit * width_of(shape, peak)
        x = left + unit * z
        curve = [(x + 62 * peak * math.exp(-((t / 20) ** 2)), axis + across * t / 20) for t in range(-36, 37)]
        drawing.path([(x, curve[0][1]), (x, curve[-1][1])], VERMILION, width=0.8)
        drawing.path(curve, VERMILION, width=2)
        drawing.arrow(x, axis, x + 62 * peak, axis, VERMILION)
    drawing.text(left - 20, axis + 5, half, "end", size=14)
    drawing.text(left + unit * 25 + 66, axis + 5, "z", size=14)


def jets():
    drawing = Drawing(960, 550)
    drawing.text(24, 32, "The two jets from the side: edge and velocity profiles", size=18)
    jet(drawing, 70, 210, "round", 0.08, 11, "Round outlet: cone (a = 0.08)", "2R_0")
    jet(drawing, 540, 210, "rectangular", 0.108, 11, "Rectangular outlet: wedge (a = 0.108)", "2b_0")
    drawing.text(70, 366, "The outlets from the front, and where V is 1/e of that on the axis 20 R_0 or 20 b_0 away", size=14)
    for x, shape, coefficient in ((190, "round", 0.08), (680, "rectangular", 0.108)):
        far = 11 * width_of(shape, decay(shape, 20, coefficient))
        if shape == "round":
            drawing.circle(x, 440, far, PALE, BLUE)
            drawing.circle(x, 440, 11, "#ffffff")
            drawing.text(x + far + 14, 444, "Gaussian along every radius")
        else:
            corners = [(x - 70, 440 - far), (x + 70, 440 - far), (x + 70, 440 + far), (x - 70, 440 + far)]
            drawing.path(corners, BLUE, PALE, 1.2, "6 4", True)
            drawing.path([(x - 70, 429), (x + 70, 429), (x + 70, 451), (x - 70, 451)], INK, "#ffffff", closed=True)
            drawing.text(x + 84, 426, "Gaussian across")
            drawing.text(x + 84, 446, "uniform along the")
            drawing.text(x + 84, 466, "long side, sharp ends")
    drawing.path([(70, 520), (110, 520)], BLUE, width=1.2, dash="6 4")
    drawing.text(118, 525, "V = V_max/e")
    drawing.path([(260, 520), (300, 520)], VERMILION, width=2)
    drawing.text(308, 525, "V across the jet; its arrow is V_max, of one scale in both")
    drawing.write("jets")


def hidden_elements():
    drawing = Drawing(900, 400)
    drawing.text(24, 32, "Hidden elements: a straight line from the outlet must reach the element", size=18)
    outlet, axis = 90, 205
    cone = [(outlet, axis - 20), (690, 75), (690, 335), (outlet, axis + 20)]
    drawing.path(cone, BLUE, PALE, 1, "6 4", True)
    drawing.path([(outlet, 70), (outlet, axis - 20)], INK, width=4)
    drawing.path([(outlet, axis + 20), (outlet, 340)], INK, width=4)
    drawing.text(outlet - 8, axis + 5, "outlet", "end")
    origin = (outlet, axis)
    # The fold stands before part of the front: rays through its two ends cut the shadow out.
    fold = [(400, 150), (415, 175), (400, 203)]

    def at(point, x):
        return (x, origin[1] + (point[1] - origin[1]) * (x - origin[0]) / (point[0] - origin[0]))

    front = 690
    high, low = at(fold[0], front), at(fold[-1], front)
    drawing.path([fold[0], high, low, fold[-1], fold[1]], "none", "#cfcfcf", closed=True)
    for end in (high, low, (front, 250)):
        drawing.arrow(*origin, *end, QUIET)
    drawing.path(fold, VERMILION, width=6)
    drawing.text(390, 96, "fold: lit, takes the jet’s pressure", "middle", VERMILION)
    drawing.path([(front, 76), high], VERMILION, width=6)
    drawing.path([high, low], QUIET, width=6)
    drawing.path([low, (front, 335)], VERMILION, width=6)
    drawing.text(front + 14, 160, "in the fold’s shadow:", colour=INK)
    drawing.text(front + 14, 178, "gas pressure alone")
    drawing.text(front + 14, 272, "lit", colour=VERMILION)
    drawing.path([(490, 266), (560, 290)], "#333333", width=5, dash="3 3")
    drawing.text(430, 340, "faces the outlet with its outer side: no load", "middle")
    drawing.path([(24, 380), (54, 380)], VERMILION, width=6)
    drawing.text(62, 385, "lit")
    drawing.path([(110, 380), (140, 380)], QUIET, width=6)
    drawing.text(148, 385, "hidden")
    drawing.path([(220, 380), (250, 380)], "#333333", width=5, dash="3 3")
    drawing.text(258, 385, "facing away")
    drawing.write("hidden_elements")


def test_setup():
    with open(os.path.join(ROOT, "cases/passenger_pendulum.toml"), "rb") as file:
        case = tomllib.load(file)
    pendulum, jet_case = case["pendulum"], case["inflator"][0]["jet"]
    scale = 330  # [pixels/m]
    left, base = 250, 560

    def place(x, z):
        return (left + scale * x, base - scale * z)

    pivot = place(pendulum["pivot"][0], pendulum["pivot"][2])
    gravity_centre = (pivot[0], pivot[1] + scale * pendulum["cg_distance"])
    impactor = (pivot[0], pivot[1] + scale * pendulum["impactor_distance"])
    drawing = Drawing(860, 760)
    drawing.text(24, 32, "The pendulum test of the paper’s scene, from the side", size=18)
    wall = [place(0, 0.42), place(0, -0.42)]
    drawing.path([(wall[0][0] - 24, wall[0][1]), wall[0], wall[1], (wall[1][0] - 24, wall[1][1])], QUIET, "#dddddd", closed=True)
    drawing.text(left - 34, base - 100, "rigid plate", "end")
    drawing.path([place(0, 0.3), place(0.06, 0.26), place(0.06, -0.26), place(0, -0.3)], INK, SKIN, 1.6)
    drawing.text(left - 34, base + 66, "bag, laid flat,", "end")
    drawing.text(left - 34, base + 84, "120 l when full", "end")
    half = jet_case["short_side"] / 2
    drawing.path([place(0, half), place(0, -half)], VERMILION, width=5)
    drawing.arrow(left - 2, base, left + 62, base, VERMILION)
    drawing.text(left - 34, base - 8, "outlet of the jet", "end", VERMILION)
    long_side, short_side = 1e3 * jet_case["long_side"], 1e3 * jet_case["short_side"]
    drawing.text(left - 34, base + 10, f"{long_side:.0f} × {short_side:.0f} mm", "end", VERMILION)
    drawing.path([pivot, impactor], INK, width=4)
    drawing.circle(*pivot, 6, "#ffffff")
    drawing.text(pivot[0] - 14, pivot[1] + 5, "pivot", "end")
    drawing.circle(*gravity_centre, 6, BLUE)
    drawing.text(gravity_centre[0] + 162, gravity_centre[1] + 5, "centre of gravity")
    drawing.circle(*impactor, scale * pendulum["impactor_radius"], BLUE)
    drawing.text(impactor[0] + 22, impactor[1] + 34, f"impactor, radius {1e3 * pendulum['impactor_radius']:.0f} mm")
    for distance, across in ((pendulum["cg_distance"], 60), (pendulum["impactor_distance"], 150)):
        x, y = pivot[0] + across, pivot[1] + scale * distance
        drawing.path([(pivot[0] + 12, pivot[1]), (x + 8, pivot[1])], QUIET, width=0.8)
        drawing.path([(pivot[0] + 18, y), (x + 8, y)], QUIET, width=0.8)
        drawing.arrow(x, pivot[1], x, y, both=True)
        drawing.text(x + 8, (pivot[1] + y) / 2, f"{1e3 * distance:.0f} mm")
    below = base + 175
    drawing.path([(left, base + 142), (left, below + 8)], QUIET, width=0.8)
    drawing.path([(pivot[0], impactor[1] + 18), (pivot[0], below + 8)], QUIET, width=0.8)
    drawing.arrow(left, below, pivot[0], below, both=True)
    drawing.text((left + pivot[0]) / 2, below - 6, f"{1e3 * pendulum['pivot'][0]:.0f} mm", "middle")
    words = [f"mass {pendulum['mass']:g} kg", f"inertia about its centre {pendulum['inertia_cg']:g} kg m²", "at rest at first"]
    for i, line in enumerate(words):
        drawing.text(pivot[0] + 200, pivot[1] + 60 + 20 * i, line)
    drawing.write("test_setup")


def control_volume():
    """What crosses the boundary of the gas, with the equations' tags (G.6) to (G.11)."""
    drawing = Drawing(1120, 360)
    drawing.text(24, 32, "The gas of a bag: what comes in and what leaves", size=18)
    cx, cy, rx, ry = 530, 200, 180, 118
    ring = [(cx + rx * math.cos(t * math.pi / 60), cy + ry * math.sin(t * math.pi / 60)) for t in range(120)]
    drawing.path(ring, INK, PALE, 2.5, closed=True)
    drawing.text(cx, cy - 34, "uniform gas", "middle", size=15, weight="bold")
    drawing.text(cx, cy - 10, "p, T, V; masses of the species; energy", "middle")
    drawing.text(cx, cy + 24, "work p dV/dt as the skin moves (G.9)", "middle", QUIET)
    drawing.text(cx, cy + ry + 28, "outside: ambient gas, p_a and T_a, with a composition of its own", "middle", QUIET, 12)

    def on_ring(degrees, reach=1.0):
        turn = math.radians(degrees)
        return (cx + reach * rx * math.cos(turn), cy - reach * ry * math.sin(turn))

    # name, place on the ring, whether it comes in, colour, where the words stand
    flows = [
        ("inflators: mass flow and temperature by time,", "fired by sensors; the jet leaves one of them", 180, True, BLUE, "end"),
        ("vents: isentropic hole, sonic or subsonic (G.6),", "fixed, by time, by pressure, or opened by sensors", 32, False, VERMILION, "start"),
        ("fabric: porous skin (G.7), or a measured table (G.12)", "", 0, False, VERMILION, "start"),
        ("backflow of ambient gas through vents", "while p is below p_a", 328, True, BLUE, "start"),
        ("heat through the skin (G.11)", "", 212, False, QUIET, "end"),
    ]
    for first, second, degrees, comes_in, colour, anchor in flows:
        near, far = on_ring(degrees, 0.93), on_ring(degrees, 1.22)
        start, end = (far, near) if comes_in else (near, far)
        drawing.arrow(*start, *end, colour, width=2.4)
        x = far[0] + (8 if anchor == "start" else -8)
        drawing.text(x, far[1] + (0 if second else 5), first, anchor, size=12)
        if second:
            drawing.text(x, far[1] + 16, second, anchor, size=12)
    drawing.write("control_volume")


def read_obj(path):
    """Nodes, and triangles with the name of their group."""
    nodes, triangles, group = [], [], ""
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                nodes.append([float(word) for word in words[1:4]])
            elif words[0] == "g":
                group = words[1]
            elif words[0] == "f":
                triangles.append(([int(word.split("/")[0]) - 1 for word in words[1:4]], group))
    return nodes, triangles


def straps_of(case):
    """Pairs of node numbers, from the head of the frames of a short run."""
    gasjet = os.environ.get("GASJET", os.path.join(ROOT, "build/gasjet"))
    with tempfile.TemporaryDirectory() as folder:
        options = ["--set", "scene.end_time=1e-5", "--quiet", "--out", folder]
        subprocess.run([gasjet, "run", os.path.join(ROOT, case), *options], check=True, stderr=subprocess.DEVNULL)
        with open(os.path.join(folder, "frames.bin"), "rb") as file:
            return json.loads(file.readline())["straps"]


def passenger_bag():
    nodes, triangles = read_obj(os.path.join(ROOT, "cases/reference/passenger_jet.obj"))
    drawing = Drawing(900, 560)
    drawing.text(24, 32, "The passenger bag as cut: panels, straps and vent", size=18)
    turn, tilt, scale = math.radians(128), math.radians(22), 540
    across = (math.cos(turn), math.sin(turn))  # of the page's right in x, y

    def place(point):
        x, y, z = point
        depth = x * across[1] - y * across[0]
        return (340 + scale * (x * across[0] + y * across[1]), 268 - scale * (z * math.cos(tilt) - depth * math.sin(tilt)))

    def faces_us(corners):
        (ax, ay), (bx, by), (cx, cy) = (place(nodes[n]) for n in corners)
        return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay) < 0  # the page's y goes down

    # The bag is convex as cut: of what faces us nothing hides anything.
    colours = {"main": PALE, "side_left": "#cfe6d8", "side_right": "#cfe6d8", "attachment": "#bdbdbd", "vent": VERMILION}
    for panel, colour in colours.items():
        seen = [[place(nodes[n]) for n in corners] for corners, group in triangles if group == panel and faces_us(corners)]
        drawing.polygons(seen, "#5f7f94", colour, 0.35)

    for ends in straps_of("cases/passenger_pendulum.toml"):
        ends = [place(nodes[n]) for n in ends]
        drawing.path(ends, VERMILION, width=2.2, dash="7 4")
        for end in ends:
            drawing.circle(*end, 3.5, VERMILION, VERMILION)
    words = [
        ("main panel, once round", PALE),
        ("two side panels", "#cfe6d8"),
        ("attachment, fixed to the plate (behind)", "#bdbdbd"),
        ("vent, in the right-hand side", VERMILION),
    ]
    for i, (line, colour) in enumerate(words):
        drawing.path([(560, 120 + 26 * i), (584, 120 + 26 * i), (584, 134 + 26 * i), (560, 134 + 26 * i)], INK, colour, 0.8, closed=True)
        drawing.text(594, 132 + 26 * i, line)
    drawing.path([(560, 232), (584, 232)], VERMILION, width=2.2, dash="7 4")
    drawing.text(594, 237, "straps, inside")
    size = [max(node[c] for node in nodes) - min(node[c] for node in nodes) for c in range(3)]
    drawing.text(560, 274, f"{len(triangles)} elements, {len(nodes)} nodes")
    drawing.text(560, 294, f"{1e3 * size[0]:.0f} × {1e3 * size[1]:.0f} × {1e3 * size[2]:.0f} mm as cut, 120 l")
    drawing.write("passenger_bag")


jets()
hidden_elements()
test_setup()
control_volume()
passenger_bag()
