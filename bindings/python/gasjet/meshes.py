# SPDX-License-Identifier: Apache-2.0
"""Meshes by the command `gasjet mesh`."""
from __future__ import annotations

import os
import tempfile
from typing import Any, Dict, List, Mapping, Optional

import numpy as np

from .errors import InputError
from .frames import mesh_of
from .program import call, case_words, file_word, options
from .tables import Path

KINDS = ("driver", "passenger", "convert", "case", "fold", "state")


class Mesh:
    """Triangles of a bag: `nodes` (n, 3) [m], `triangles` (m, 3), `panels`, the names, and `panel` (m), the number of each element's.

    `initial`: (n, 3) [m] the initial shape, if it is another one; `printed`: the command's report. A mesh can replace nodes and triangles
    in gasjet.visible, Membrane and the like.
    """

    __slots__ = ("nodes", "triangles", "panels", "panel", "initial", "printed", "__weakref__")

    def __init__(self, nodes: np.ndarray, triangles: np.ndarray, panels: List[str], panel: np.ndarray) -> None:
        self.nodes = nodes
        self.triangles = triangles
        self.panels = panels
        self.panel = panel
        self.initial: Optional[np.ndarray] = None
        self.printed = ""

    def __repr__(self) -> str:
        return f"<gasjet.Mesh {len(self.triangles)} elements, {len(self.nodes)} nodes, panels {', '.join(self.panels)}>"

    @property
    def points(self) -> np.ndarray:
        """Nodes, by meshio's name."""
        return self.nodes

    @property
    def cells_dict(self) -> Dict[str, np.ndarray]:
        """Triangles, by meshio's name."""
        return {"triangle": self.triangles}

    def to_meshio(self) -> Any:
        """A meshio.Mesh; the panel's number is a field of the elements."""
        return mesh_of(self.nodes, self.triangles, {}, {"panel": self.panel})


def mesh(kind: str, source: Any = None, *, set: Optional[Mapping[str, Any]] = None, out: Optional[Path] = None, initial: Optional[Path] = None,
         **more: Any) -> Mesh:
    """Makes or reads a mesh, as `gasjet mesh KIND` does.

    kind: "driver" and "passenger" generate one, `set` has the generator's numbers; "convert" reads the file `source`; "case" takes that of
    a case (file or dict); "fold" folds a case's or a file's; "state" takes the shape at `time` [s] of a folder of results. out, initial:
    files to write, else none. more: the command's other options, with _ for -, lists for those that are repeated: refine=1,
    panel=["front"], merge=1e-4, outward=True, letter=True, axis="z", at=[-0.2, 0.2]. Raises InputError.
    """
    if kind not in KINDS:
        raise InputError(f"kind: is {kind!r}, allowed: {', '.join(KINDS)}")
    if (source is None) != (kind in KINDS[:2]):
        raise TypeError(f"source: is {'missing' if source is None else 'given'}, allowed for {kind}: {'none' if source is not None else 'one'}")
    if isinstance(more.get("at"), (list, tuple, np.ndarray)):
        more["at"] = ",".join(repr(float(x)) for x in more["at"])
    with tempfile.TemporaryDirectory() as scratch:
        first, second = (os.path.join(scratch, name) for name in ("design.obj", "initial.obj"))
        files = {"out": first if out is None else file_word(out, "out")}
        if kind in ("driver", "case"):
            files["initial"] = second if initial is None else file_word(initial, "initial")
        elif initial is not None:
            files["initial"] = file_word(initial, "initial")
        printed = _command(kind, source, set, options(**files, **more))
        made = _obj_of(files["out"], first)
        if "initial" in files and os.path.exists(files["initial"]):
            start = _obj_of(files["initial"], second).nodes
            made.initial = None if np.array_equal(start, made.nodes) else start
    made.printed = printed
    return made


def _command(kind: str, source: Any, set: Optional[Mapping[str, Any]], words: List[str]) -> str:
    if kind in ("convert", "state"):
        if set is not None:
            raise TypeError(f"set: is given, allowed for {kind}: none")
        return call(["mesh", kind, *words, file_word(source, "source")])
    if set and None in set.values():
        raise TypeError("set: has None, allowed for a mesh: values")
    generated = kind in KINDS[:2]
    with case_words("case.toml" if generated else source, set) as (given, names):
        return call(["mesh", kind, *words, *(given[1:] if generated else given)], names)


def _obj_of(written: str, scratch: str) -> Mesh:
    """A mesh in any format that the command writes."""
    if not written.endswith(".obj"):
        call(["mesh", "convert", written, "--report", f"--out={scratch}"])
        written = scratch
    return read_obj(written)


def read_obj(file: str) -> Mesh:
    """An OBJ file of triangles, as the command writes it."""
    nodes: List[List[float]] = []
    triangles: List[List[int]] = []
    panels: Dict[str, int] = {}
    panel: List[int] = []
    with open(file, encoding="utf-8") as stream:
        for line in stream:
            key, _, rest = line.strip().partition(" ")
            if key == "v":
                nodes.append([float(x) for x in rest.split()])
            elif key == "g":
                panels.setdefault(rest, len(panels))
                current = panels[rest]
            elif key == "f":
                triangles.append([int(x) - 1 for x in rest.split()])
                panel.append(current)
    return Mesh(np.array(nodes), np.array(triangles, np.int32), list(panels), np.array(panel, np.int32))
