# SPDX-License-Identifier: Apache-2.0
"""A run in a notebook: a table, two charts and the bag, as HTML with pictures in it."""
from __future__ import annotations

import html
from typing import Any, Dict, List, Mapping, Tuple

import numpy as np

CHARTED = ("pressure_Pa", "pendulum_angle_rad", "impactor_displacement_m", "contact_force_N", "jet_force_N", "volume_m3", "temperature_K")
WIDTH, HEIGHT, POINTS = 280, 140, 200  # of a picture, and of a curve in it


def page(name: str, summary: Mapping[str, Any], history: Mapping[str, np.ndarray], frame: Any) -> str:
    """frame: the last one, or None."""
    pictures = [_chart(history["time_s"], history[column], column) for column in _charted(history)]
    if frame is not None:
        pictures.append(_outline(frame.nodes, frame.triangles, frame.time))
    return f"<div>{_table(name, summary)}{''.join(pictures)}</div>"


def _charted(history: Mapping[str, np.ndarray]) -> List[str]:
    """Two columns: the first of CHARTED, or whatever there is."""
    known = [column for column in CHARTED if column in history]
    return [*known, *(column for column in history if column != "time_s" and column not in known)][:2]


def _table(name: str, summary: Mapping[str, Any]) -> str:
    rows: Dict[str, Any] = {"status": summary["status"]}
    if summary.get("message"):
        rows["message"] = summary["message"]
    rows.update({key: summary[key] for key in ("steps", "time_end_s", "wall_s") if key in summary})
    rows.update({"peak " + key: value for key, value in summary.get("peak", {}).items() if isinstance(value, (int, float))})
    drift = summary.get("residual", {}).get("energy_rel")
    if drift is not None:
        rows["drift of the energy"] = drift
    rows.update({f"warning {number}": text for number, text in enumerate(summary.get("warnings", []), 1)})
    lines = "".join(f"<tr><td>{html.escape(key)}</td><td>{html.escape(_text(value))}</td></tr>" for key, value in rows.items())
    return f"<table><caption>{html.escape(name)}</caption>{lines}</table>"


def _text(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _picture(title: str, shape: str) -> str:
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT + 34}" font-family="sans-serif" font-size="11" '
            f'fill="none" stroke="#1f5f99"><text x="4" y="12" fill="currentColor" stroke="none">{html.escape(title)}</text>{shape}</svg>')


def _label(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:g}" y="{y:g}" fill="currentColor" stroke="none" text-anchor="{anchor}">{text}</text>'


def _chart(time: np.ndarray, values: np.ndarray, column: str) -> str:
    """A curve of at most POINTS points, with the ends of its axes."""
    finite = np.flatnonzero(np.isfinite(values))
    if not len(finite):
        return _picture(column, "")
    some = finite[np.unique(np.linspace(0, len(finite) - 1, POINTS).astype(int))]
    left, right, top, bottom = 60, WIDTH - 8, 24, HEIGHT + 10
    x, y = time[some], values[some]
    across = left + (right - left) * (x - x[0]) / ((x[-1] - x[0]) or 1.0)
    up = bottom - (bottom - top) * (y - y.min()) / ((y.max() - y.min()) or 1.0)
    curve = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(across, up))
    ends = (_label(left - 4, bottom, f"{y.min():.4g}", "end"), _label(left - 4, top + 8, f"{y.max():.4g}", "end"),
            _label(left, bottom + 16, f"{x[0]:g}", "start"), _label(right, bottom + 16, f"{x[-1]:g} s", "end"))
    return _picture(column, f'<path d="M{left} {top}V{bottom}H{right}" stroke="#999"/><polyline points="{curve}"/>{"".join(ends)}')


def silhouette(points: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(n, 2) node numbers of the edges where a surface turns away from the viewer; points: (nodes, 2), counter-clockwise is in front."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    front = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) > (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    if not front.any():
        return np.zeros((0, 2), triangles.dtype)
    edges = np.sort(np.concatenate([triangles[front][:, pair] for pair in ((0, 1), (1, 2), (2, 0))]), axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)
    return edges[counts == 1]


def _outline(nodes: np.ndarray, triangles: np.ndarray, time: float) -> str:
    """The surface seen along the axis of its least extent."""
    axes = np.sort(np.argsort(np.ptp(nodes, axis=0), kind="stable")[1:])
    points = nodes[:, axes]
    low, high = points.min(0), points.max(0)
    scale = min((WIDTH - 16) / ((high - low)[0] or 1.0), (HEIGHT - 10) / ((high - low)[1] or 1.0))

    def place(node: int) -> Tuple[float, float]:
        x, y = (points[node] - low) * scale
        return 8 + x, HEIGHT + 14 - y

    lines = "".join("M{:.1f} {:.1f}L{:.1f} {:.1f}".format(*place(a), *place(b)) for a, b in silhouette(points, triangles))
    names = "".join("xyz"[axis] for axis in axes)
    return _picture(f"the surface at {time:g} s, {names}: {(high - low)[0]:.3g} m by {(high - low)[1]:.3g} m", f'<path d="{lines}"/>')
