# SPDX-License-Identifier: Apache-2.0
# Cuts a part of a bag's elements in four, design and initial shape alike; elements beside it in two, so that no side has a
# node on it. A part is a list of panels, or `front`: main panel beyond x = 0.6 m and within 0.15 m of z = 0; `rest`: all else.
# usage: refine_part.py DESIGN.obj INITIAL.obj OUT_DESIGN.obj OUT_INITIAL.obj none|front|rest|all|PANEL,PANEL
import sys


def read(path):
    nodes, elements, panels, panel = [], [], [], None
    for words in map(str.split, open(path)):
        if words[:1] == ["v"]:
            nodes.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["g"]:
            panel = words[1]
        elif words[:1] == ["f"]:
            elements.append(tuple(int(w) - 1 for w in words[1:4]))
            panels.append(panel)
    return nodes, elements, panels


def write(path, nodes, elements, panels):
    with open(path, "w") as out:
        out.writelines("v %r %r %r\n" % node for node in nodes)
        last = None
        for element, panel in zip(elements, panels):
            out.write(("" if panel == last else "g %s\n" % panel) + "f %d %d %d\n" % tuple(n + 1 for n in element))
            last = panel


def sides(element):
    return [frozenset((element[i], element[(i + 1) % 3])) for i in range(3)]


def chosen(part, element, panel, design):
    x, _, z = (sum(design[n][i] for n in element) / 3 for i in range(3))
    front = panel == "main" and x > 0.6 and abs(z) < 0.15
    return {"none": False, "all": True, "front": front, "rest": not front}.get(part, panel in part.split(","))


# The null panel keeps its elements but for sides that it shares: all its nodes have to stay on its rim.
def marked_sides(part, elements, panels, design):
    red = {e for e, t in enumerate(elements) if panels[e] != "vent" and chosen(part, t, panels[e], design)}
    while True:
        marked = {side for e in red for side in sides(elements[e])}
        more = {e for e, t in enumerate(elements)
                if e not in red and panels[e] != "vent" and sum(s in marked for s in sides(t)) > 1}
        if not more:
            return marked
        red |= more


def pieces(element, marked, middle):
    a, b, c = element
    cut = [side in marked for side in sides(element)]
    if not any(cut):
        return [element]
    if sum(cut) == 3:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        return [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    while not cut[0] or (sum(cut) == 2 and not cut[1]):  # a-b is cut; of two, b-c too
        (a, b, c), cut = (b, c, a), cut[1:] + cut[:1]
    if sum(cut) == 1:
        return [(a, middle(a, b), c), (middle(a, b), b, c)]
    ab, bc = middle(a, b), middle(b, c)
    return [(ab, b, bc), (a, ab, bc), (a, bc, c)]


def main(design_file, initial_file, out_design, out_initial, part):
    design, elements, panels = read(design_file)
    initial = read(initial_file)[0]
    marked, middles = marked_sides(part, elements, panels, design), {}

    def middle(a, b):
        side = frozenset((a, b))
        if side not in middles:
            middles[side] = len(design)
            for nodes in (design, initial):
                nodes.append(tuple(0.5 * (p + q) for p, q in zip(nodes[a], nodes[b])))
        return middles[side]

    cut = [(piece, panel) for t, panel in zip(elements, panels) for piece in pieces(t, marked, middle)]
    for path, nodes in ((out_design, design), (out_initial, initial)):
        write(path, nodes, [t for t, _ in cut], [p for _, p in cut])


main(*sys.argv[1:])
