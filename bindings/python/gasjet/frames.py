# SPDX-License-Identifier: Apache-2.0
"""The bag at the times of frames.bin (docs/results.md has its format)."""
from __future__ import annotations

import json
import os
from typing import Any, Dict, Iterator, List, Optional, Sequence, Union, overload

import numpy as np

from .errors import InputError
from .tables import Path

FORMAT = 1  # of result files


def mesh_of(points: np.ndarray, triangles: np.ndarray, of_nodes: Dict[str, np.ndarray], of_elements: Dict[str, np.ndarray]) -> Any:
    """A meshio.Mesh."""
    try:
        import meshio
    except ImportError as error:
        raise ImportError(f"meshio is not installed, allowed with Debian's python3-meshio ({error})") from None
    return meshio.Mesh(points, [("triangle", triangles)], point_data=of_nodes, cell_data={name: [data] for name, data in of_elements.items()})


class Frame:
    """The bag, or a rigid target, at one time. The file's rounding is at most half of 1/65535 of the frame's largest value."""

    __slots__ = ("_header", "_raw", "values", "__weakref__")

    def __init__(self, header: Dict[str, Any], raw: np.void) -> None:
        self._header = header
        self._raw = raw
        self.values: Dict[str, float] = dict(zip(header["scalars"], raw["scalars"].tolist()))  # the frame's numbers, with units

    def __repr__(self) -> str:
        return f"<gasjet.Frame at {self.time:g} s: {len(self.nodes)} nodes, {len(self.triangles)} elements>"

    @property
    def time(self) -> float:
        """[s]"""
        return self.values["time_s"]

    @property
    def nodes(self) -> np.ndarray:
        """[m] (nodes, 3) positions."""
        corner = [self.values[name] for name in ("x_m", "y_m", "z_m")]
        return corner + self.values["position_step_m"] * self._raw["position"]

    @property
    def triangles(self) -> np.ndarray:
        """(elements, 3) node numbers."""
        return np.array(self._header["triangles"], np.int32).reshape(-1, 3)

    @property
    def panels(self) -> List[str]:
        """(elements) name of the panel of each; empty for a target."""
        names = self._header.get("panel_names", [])
        return [names[number] for number in self._header.get("panels", [])]

    @property
    def speed(self) -> np.ndarray:
        """[m/s] (nodes) magnitude of the velocity."""
        return self.values["speed_step_m_s"] * self._raw["speed"]

    @property
    def jet_overpressure(self) -> np.ndarray:
        """[Pa] (elements) of all jets."""
        return self.values["jet_step_Pa"] * self._raw["jet"]

    @property
    def overpressure(self) -> np.ndarray:
        """[Pa] (elements) of the gas and all jets."""
        return self.values["overpressure_Pa"] + self.jet_overpressure

    @property
    def strain(self) -> np.ndarray:
        """(elements) larger principal strain."""
        return self.values["strain_low"] + self.values["strain_step"] * self._raw["strain"]

    @property
    def lit(self) -> np.ndarray:
        """(elements) True where a jet reaches the element."""
        return self._raw["mask"] == 2

    @property
    def hidden(self) -> np.ndarray:
        """(elements) True in a jet that others hide, and in no other."""
        return self._raw["mask"] == 1

    def to_meshio(self) -> Any:
        """A meshio.Mesh with these fields, by the names of the files for ParaView; its write("bag.vtu") makes a file."""
        fields = {"overpressure_Pa": self.overpressure, "jet_overpressure_Pa": self.jet_overpressure, "principal_strain": self.strain,
                  "jet_mask": self._raw["mask"].astype(np.int32)}
        if self._header.get("panels"):
            fields["panel"] = np.array(self._header["panels"], np.int32)
        return mesh_of(self.nodes, self.triangles, {"speed_m_s": self.speed}, fields)


class Frames(Sequence[Frame]):
    """Frames of a run, by number."""

    __slots__ = ("_header", "_raw")

    def __init__(self, header: Dict[str, Any], raw: np.ndarray) -> None:
        self._header = header
        self._raw = raw

    def __repr__(self) -> str:
        return f"<gasjet.Frames {len(self)}, from {self.times[0]:g} to {self.times[-1]:g} s>"

    def __len__(self) -> int:
        return len(self._raw)

    @overload
    def __getitem__(self, index: int) -> Frame: ...

    @overload
    def __getitem__(self, index: slice) -> List[Frame]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Frame, List[Frame]]:
        if isinstance(index, slice):
            return [Frame(self._header, raw) for raw in self._raw[index]]
        if not -len(self) <= index < len(self):
            raise IndexError(f"frames: has no number {index}, allowed: {-len(self)} to {len(self) - 1}")
        return Frame(self._header, self._raw[index])

    def __iter__(self) -> Iterator[Frame]:
        return (Frame(self._header, raw) for raw in self._raw)

    @property
    def times(self) -> np.ndarray:
        """[s] of each frame."""
        return self._raw["scalars"][:, 0]


def _layout(header: Dict[str, Any]) -> np.dtype:
    """A frame's parts, in the order of the file."""
    nodes, elements = header["nodes"], header["elements"]
    parts = [("scalars", "<f8", (len(header["scalars"]),)), ("position", "<u2", (nodes, 3)), ("speed", "<u2", (nodes,)),
             ("jet", "<u2", (elements,)), ("strain", "<u2", (elements,)), ("mask", "u1", (elements,))]
    packed = np.dtype(parts)
    return np.dtype({"names": packed.names, "formats": [packed[name] for name in packed.names],
                     "offsets": [packed.fields[name][1] for name in packed.names], "itemsize": header["frame_bytes"]})


def read_frames(file: Path, run: Optional[str] = None) -> Frames:
    """frames.bin. run: the id that it must have. Raises InputError."""
    name = os.fspath(file)
    try:
        with open(file, "rb") as stream:
            first = stream.readline()
            rest = stream.read()
    except OSError as error:
        raise InputError(f"{name}: {error.strerror}, allowed: frames.bin of a run") from None
    try:
        header = json.loads(first)
        if header["file"] != "gasjet frames" or header["format"] != FORMAT:
            raise InputError(f'{name}: does not begin as "gasjet frames" of format {FORMAT}')
        layout, triangles = _layout(header), np.array(header["triangles"])
        if triangles.shape != (header["elements"], 3) or not (0 <= triangles.min() and triangles.max() < header["nodes"]):
            raise ValueError
    except InputError:
        raise
    except (ValueError, KeyError, TypeError, AttributeError):
        raise InputError(f"{name}: its header is damaged, allowed: frames.bin of a run") from None
    if run is not None and header["run"] != run:
        raise InputError(f"{name}: is of run {header['run']}, allowed: {run}, that of the other files")
    if not rest or len(rest) % layout.itemsize:
        raise InputError(f"{name}: has {len(rest)} bytes of frames, allowed: whole frames of {layout.itemsize} bytes")
    return Frames(header, np.frombuffer(rest, layout))
