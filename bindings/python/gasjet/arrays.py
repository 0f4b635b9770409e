# SPDX-License-Identifier: Apache-2.0
"""Arrays for the library, as views if the layout allows it."""
from __future__ import annotations

from typing import Any, Callable, Sequence, Tuple

import numpy as np

from .errors import DomainError, InputError

Vector = Sequence[float]
NAN = float("nan")
NO_VECTOR = (NAN, NAN, NAN)
NO_INDICES = np.zeros(0, np.int32)


def mesh_arrays(nodes: Any, triangles: Any, name: str = "nodes") -> Tuple[Any, Any]:
    """Nodes and triangles; a meshio mesh can replace both."""
    if triangles is None:
        if not hasattr(nodes, "points"):
            raise TypeError("triangles: are missing, allowed: an array (m, 3), or a meshio mesh instead of nodes")
        cells = nodes.cells_dict
        if "triangle" not in cells:
            raise TypeError(f"{name}: the mesh has {sorted(cells)}, allowed: a mesh with triangles")
        nodes, triangles = nodes.points, cells["triangle"]
    return as_points(nodes, name), as_triangles(triangles)


def as_points(given: Any, name: str) -> np.ndarray:
    """Float64 arrays unchanged; numbers that float64 represents exactly, and lists and the like, are converted."""
    if isinstance(given, np.ndarray):
        _refuse_masks(given, name)
        array = given if given.dtype == np.float64 else _exact_doubles(given, name)
    else:
        array = as_numbers(given, name)
    return _rows_of_three(array, name)


def _exact_doubles(array: np.ndarray, name: str) -> np.ndarray:
    """Converts float32, integers and other byte orders, which meshes may have."""
    kind, size = array.dtype.kind, array.dtype.itemsize
    if not (kind in "iu" or kind == "f" and size <= 8):
        raise TypeError(f"{name}: have the dtype {array.dtype}, allowed: float64, or numbers that it holds exactly")
    if kind in "iu" and size == 8 and array.size and max(-int(array.min()), int(array.max())) > 2**53:
        raise TypeError(f"{name}: have an integer beyond 2^53, allowed: numbers that float64 holds exactly")
    return array.astype(np.float64)


def _rows_of_three(array: np.ndarray, name: str) -> np.ndarray:
    if array.ndim != 2 or array.shape[1] != 3:
        raise TypeError(f"{name}: have the shape {array.shape}, allowed: (n, 3)")
    return array


def as_numbers(given: Any, name: str) -> np.ndarray:
    """Any real numbers as float64."""
    try:
        array = np.asarray(given)
        if array.dtype.kind not in "biufO":
            raise TypeError
        _refuse_masks(given, name)
        return array.astype(float, copy=False)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name}: are not real numbers, allowed: an array of float64") from None


def as_column(given: Any, name: str) -> np.ndarray:
    """Real numbers in one dimension; a single number gives one element."""
    array = np.atleast_1d(as_numbers(given, name))
    if array.ndim != 1:
        raise TypeError(f"{name}: have the shape {array.shape}, allowed: one dimension")
    return array


def _refuse_masks(given: Any, name: str) -> None:
    """Masked values would be read as numbers."""
    if isinstance(given, np.ma.MaskedArray) and np.ma.is_masked(given):
        raise TypeError(f"{name}: has masked values, allowed: an array without a mask")


def handle_of(given: Any, kind: type, name: str) -> Any:
    """The library's handle of an object."""
    if not isinstance(given, kind):
        raise TypeError(f"{name}: is a {type(given).__name__}, allowed: a gasjet.{kind.__name__}")
    return given._handle


def as_triangles(triangles: Any) -> np.ndarray:
    """Node numbers (m, 3) of any integer type as int32; a view if they are int32."""
    array = np.asarray(triangles)
    _refuse_masks(triangles, "triangles")
    if array.dtype.kind not in "iu":
        raise TypeError(f"triangles: have the dtype {array.dtype}, allowed: integers")
    _rows_of_three(array, "triangles")
    if array.dtype != np.int32:
        if array.size and not (0 <= array.min() and array.max() < 2**31):
            raise ValueError("triangles: have a number that is no node's, allowed: from 0")
        array = array.astype(np.int32)
    return array


def as_indices(numbers: Any, name: str) -> np.ndarray:
    """Element or node numbers; None means an empty list."""
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


def is_single(given: Any) -> bool:
    """True for what is no array, list or tuple."""
    return not isinstance(given, (list, tuple)) and getattr(given, "ndim", 0) == 0


def at_each(function: Callable[..., Any], values_each: Tuple[int, ...] = (), **given: Any) -> Any:
    """function(numbers...) for numbers, and for arrays, which are broadcast, at each place; values_each: shape of what it returns.

    A fault names its place.
    """
    if all(is_single(values) for values in given.values()):
        return function(*given.values())
    some = [as_numbers(values, name) for name, values in given.items()]
    try:
        arrays = np.broadcast_arrays(*some)
    except ValueError:
        shapes = " and ".join(str(array.shape) for array in some)
        raise TypeError(f"{', '.join(given)}: have the shapes {shapes}, allowed: one shape, or those that numpy broadcasts") from None
    results = np.empty(arrays[0].shape + values_each)
    for place in np.ndindex(arrays[0].shape):
        try:
            results[place] = function(*(float(array[place]) for array in arrays))
        except (DomainError, InputError) as error:
            raise type(error)(f"{error} (at {list(place)})") from None
    return results
