# SPDX-License-Identifier: Apache-2.0
"""A second reader of frames.bin: its frames say what the field files say, to half a step."""
import json
import struct
import xml.etree.ElementTree as xml

import pytest
from command import arrays, numbers, ok


def run(case, *options):
    ok(f"run cases/{case} --quiet --out out", *(word for option in options for word in ("--set", option)))


def frames_of(file):
    """Header, then the frames: dictionaries of scalars and arrays, with the largest error that rounding may leave."""
    header, data = open(file, "rb").read().split(b"\n", 1)
    header = json.loads(header)
    size, nodes, elements, names = (header[k] for k in ("frame_bytes", "nodes", "elements", "scalars"))
    assert header["file"] == "gasjet frames" and header["format"] == 1 and len(data) % size == 0
    list_ = []
    for begin in range(0, len(data), size):
        frame = dict(zip(names, struct.unpack_from(f"<{len(names)}d", data, begin)))
        at = begin + 8 * len(names)
        for name, count in (("position", 3 * nodes), ("speed", nodes), ("jet", elements), ("strain", elements)):
            frame[name] = struct.unpack_from(f"<{count}H", data, at)
            at += 2 * count
        frame["mask"] = data[at:at + elements]
        list_.append(frame)
    return header, list_


def check(name, whole, step, low, exact):
    assert len(whole) == len(exact), name
    for k, (w, e) in enumerate(zip(whole, exact)):
        start = low[k % len(low)]
        allowed = 0.5 * step * (1 + 1e-9) + 4e-16 * (abs(start) + 65535 * step)  # half a step, and rounding
        assert abs(start + step * w - e) <= allowed, f"{name} {k}: {start + step * w}, {e}, step {step}"


def test_frames_read():
    run("passenger_pendulum.toml", "scene.end_time=0.012", "output.frames=3", "output.fields_every=0.004")
    header, frames = frames_of("out/frames.bin")
    assert not header["rigid"] and header["elements"] == 2744 and len(header["straps"]) == 2 and len(header["plates"]) == 1 and len(header["jets"]) == 1
    parts = [p for p in xml.parse("out/fields.pvd").iter("DataSet") if p.get("part") == "0"]
    assert len(frames) == len(parts) == 4, (len(frames), len(parts))
    for frame, part in zip(frames, parts):
        assert frame["time_s"] == float(part.get("timestep"))
        exact = arrays("out/" + part.get("file"))
        assert [n for t in header["triangles"] for n in t] == exact["connectivity"]
        check("position", frame["position"], frame["position_step_m"], [frame["x_m"], frame["y_m"], frame["z_m"]], exact["Points"])
        v = exact["velocity_m_s"]
        speed = [(v[k] ** 2 + v[k + 1] ** 2 + v[k + 2] ** 2) ** 0.5 for k in range(0, len(v), 3)]
        check("speed", frame["speed"], frame["speed_step_m_s"], [0.0], speed)
        check("jet", frame["jet"], frame["jet_step_Pa"], [0.0], exact["jet_overpressure_Pa"])
        check("strain", frame["strain"], frame["strain_step"], [frame["strain_low"]], exact["principal_strain"])
        assert list(frame["mask"]) == exact["jet_mask"]
        gauge = [p - j for p, j in zip(exact["overpressure_Pa"], exact["jet_overpressure_Pa"])]
        assert max(abs(g - frame["overpressure_Pa"]) for g in gauge) <= 1e-9 * max(exact["overpressure_Pa"] + [101325.0])
        centre = arrays("out/" + part.get("file").replace("bag_", "pendulum_"))["Points"][3:]
        assert [frame["impactor_x_m"], frame["impactor_y_m"], frame["impactor_z_m"]] == centre, centre
    assert frames[-1]["jet_0_m_s"] > 0 and any(frames[-1]["mask"])


@pytest.mark.parametrize("columns, rows", [(41, 83), (7, 120)])
def test_frames_read_target(columns, rows):
    """A rigid target on a coarser grid: the force of its overpressures is that of the history, whatever cells share one."""
    pulse = "inflator.0.mass_flow={ time = [0.0, 0.01, 0.015], value = [0.0, 2.0, 0.0] }"
    run("plate_jet.toml", pulse, f"target.columns={columns}", f"target.rows={rows}", "target.normal=[0.8, 0.0, 0.6]")
    header, plate = frames_of("out/frames.bin")
    assert header["rigid"] and header["elements"] == 2 * min(columns, 30) * min(rows, 30)
    force = numbers("out/history.csv")["jet_force_N"]
    assert len(plate) == len(force) == 21 and max(force) > 1000
    for frame, exact in zip(plate, force):
        at = [[frame[n] + frame["position_step_m"] * frame["position"][3 * k + c] for c, n in enumerate(("x_m", "y_m", "z_m"))] for k in range(header["nodes"])]
        sum_, whole = [0.0] * 3, 0.0
        for pressure, (a, b, c) in zip(frame["jet"], header["triangles"]):
            u, v = ([at[k][i] - at[a][i] for i in range(3)] for k in (b, c))
            area = [0.5 * (u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) for i in range(3)]
            sum_ = [s + frame["jet_step_Pa"] * pressure * x for s, x in zip(sum_, area)]
            whole += sum(x * x for x in area) ** 0.5
        assert abs(whole - 1.44) < 1e-4, whole  # [m2]; positions are off by 1e-5 of the sides
        found = sum(s * s for s in sum_) ** 0.5
        assert abs(found - exact) <= 0.5 * frame["jet_step_Pa"] * whole + 1e-4 * exact, (found, exact)
        assert (frame["jet_0_m_s"] > 0) == any(frame["mask"]) == (exact > 0), frame["time_s"]
