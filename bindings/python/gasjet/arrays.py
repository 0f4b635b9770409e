# SPDX-License-Identifier: Apache-2.0
"""Arrays as the library takes them: views where the layout allows it."""
from __future__ import annotations

from typing import Any, Sequence, Tuple

import numpy as np

Vector = Sequence[float]
NAN = float("nan")
NO_VECTOR = (NAN, NAN, NAN)
NO_INDICES = np.zeros(0, np.int32)


def mesh_arrays(nodes: Any, triangles: Any) -> Tuple[Any, Any]:
    """Nodes and triangles; a meshio mesh stands for both."""
    if triangles is None:
        if not hasattr(nodes, "points"):
            raise TypeError("triangles: are missing, allowed: an array (m, 3), or a meshio mesh instead of nodes")
        cells = nodes.cells_dict
        if "triangle" not in cells:
            raise TypeError(f"nodes: the mesh has {sorted(cells)}, allowed: a mesh with triangles")
        nodes, triangles = nodes.points, cells["triangle"]
    return as_points(nodes, "nodes"), as_triangles(triangles)


def as_points(given: Any, name: str) -> Any:
    """An array as it is; lists and the like as one."""
    if isinstance(given, np.ndarray):
        return given
    try:
        return np.asarray(given, float)
    except (TypeError, ValueError):
        raise TypeError(f"{name}: are no numbers, allowed: an array (n, 3) of float64") from None


def as_triangles(triangles: Any) -> np.ndarray:
    """Node numbers (m, 3) of any integer type as int32; a view if they are int32."""
    array = np.asarray(triangles)
    if array.dtype.kind not in "iu":
        raise TypeError(f"triangles: have the dtype {array.dtype}, allowed: integers")
    if array.dtype != np.int32:
        if array.size and not (0 <= array.min() and array.max() < 2**31):
            raise ValueError("triangles: have a number that is no node's, allowed: from 0")
        array = array.astype(np.int32)
    return array


def as_indices(numbers: Any, name: str) -> np.ndarray:
    """Element or node numbers; None is none."""
    if numbers is None:
        return NO_INDICES
    array = np.asarray(numbers)
    if array.dtype == np.int32 and array.ndim == 1:
        return array
    if array.size == 0:
        return NO_INDICES
    if array.dtype.kind not in "iu" or array.ndim != 1:
        raise TypeError(f"{name}: are {array.dtype} in {array.ndim} dimensions, allowed: a list of integers")
    return np.ascontiguousarray(np.clip(array, -1, 2**31 - 1), np.int32)
