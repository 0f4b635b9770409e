# SPDX-License-Identifier: Apache-2.0
# Reads the fields of a short run with VTK, the library that ParaView reads them with. usage: fields_vtk.py GASJET SOURCE_DIR
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

try:
    from vtkmodules.vtkFiltersCore import vtkMassProperties
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError as missing:
    sys.exit("SKIPPED, VTK for Python is missing (package python3-vtk9): %s" % missing)

gasjet, source = sys.argv[1:]
arrays = {"panel", "principal_stress_Pa", "principal_strain", "overpressure_Pa", "jet_overpressure_Pa", "jet_mask"}


def read(file):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    assert reader.GetErrorCode() == 0, file
    return reader.GetOutput()


def history(folder):
    lines = [line.strip().split(",") for line in open(os.path.join(folder, "history.csv")) if not line.startswith("#")]
    rows = [dict(zip(lines[0], map(float, line))) for line in lines[1:]]
    return {row["time_s"]: row for row in rows}


with tempfile.TemporaryDirectory() as folder:
    case = os.path.join(source, "cases/passenger_pendulum.toml")
    options = ["--set", "scene.end_time=0.011", "--set", "output.fields_every=0.005"]
    subprocess.run([gasjet, "run", case, "--quiet", "--out", folder, *options], check=True)
    rows, seen = history(folder), 0
    for part in xml.parse(os.path.join(folder, "fields.pvd")).iter("DataSet"):
        data = read(os.path.join(folder, part.get("file")))
        if part.get("part") == "1":
            assert data.GetNumberOfLines() == 1 and data.GetPointData().HasArray("radius_m")
            continue
        cells = data.GetCellData()
        assert data.GetNumberOfPolys() == 2744, data.GetNumberOfPolys()
        assert {cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())} == arrays
        mass = vtkMassProperties()
        mass.SetInputData(data)
        volume = rows[float(part.get("timestep"))]["volume_m3"]
        # VTK sums by projections along the axes, in double: a few eps for each of 2744 elements.
        assert abs(mass.GetVolume() - volume) < 1e-9 * volume, (mass.GetVolume(), volume)
        seen += 1
    assert seen == 3, seen
print("VTK read three bags of 2744 elements, with the history's volumes")
