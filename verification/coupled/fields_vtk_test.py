# SPDX-License-Identifier: Apache-2.0
"""Reads the fields of a short run with VTK, the library that ParaView reads them with."""
import xml.etree.ElementTree as xml

import pytest
from command import numbers, ok

ARRAYS = {"panel", "principal_stress_Pa", "principal_strain", "overpressure_Pa", "jet_overpressure_Pa", "jet_mask"}


def test_fields_vtk():
    missing = "VTK for Python is missing (package python3-vtk9)"
    filters = pytest.importorskip("vtkmodules.vtkFiltersCore", reason=missing)
    files = pytest.importorskip("vtkmodules.vtkIOXML", reason=missing)
    ok("run cases/passenger_pendulum.toml --quiet --out out --set scene.end_time=0.011 --set output.fields_every=0.005")
    history, seen = numbers("out/history.csv"), 0
    volumes = dict(zip(history["time_s"], history["volume_m3"]))
    for part in xml.parse("out/fields.pvd").iter("DataSet"):
        reader = files.vtkXMLPolyDataReader()
        reader.SetFileName(f"out/{part.get('file')}")
        reader.Update()
        assert reader.GetErrorCode() == 0
        data = reader.GetOutput()
        if part.get("part") == "1":
            assert data.GetNumberOfLines() == 1 and data.GetPointData().HasArray("radius_m")
            continue
        cells = data.GetCellData()
        assert data.GetNumberOfPolys() == 2744
        assert {cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())} == ARRAYS
        mass = filters.vtkMassProperties()
        mass.SetInputData(data)
        # VTK sums by projections along the axes, in double: a few eps for each of 2744 elements.
        assert mass.GetVolume() == pytest.approx(volumes[float(part.get("timestep"))], rel=1e-9)
        seen += 1
    assert seen == 3
