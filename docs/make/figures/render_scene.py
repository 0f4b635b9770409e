# SPDX-License-Identifier: Apache-2.0
# What a frame of render_frames.py shows: skin, borders of what the jet lights, plate and pendulum.
import vtk

RANGE = (1.0, 100.0)  # [kPa] of the colours, logarithmic: gas alone comes to 25, a jet to 100 and more
INK = (0.08, 0.08, 0.10)
# Perceptually even, readable without colour: dark is high.
COLOURS = [
    (0.00, "#f7f4e9"), (0.20, "#f6d9a3"), (0.40, "#f3a45c"),
    (0.60, "#dd6a3f"), (0.80, "#a5304a"), (1.00, "#4a0f4f"),
]


def rgb(text):
    return tuple(int(text[i : i + 2], 16) / 255 for i in (1, 3, 5))


def colour_table():
    function = vtk.vtkColorTransferFunction()
    for at, text in COLOURS:
        function.AddRGBPoint(at, *rgb(text))
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255))
    table.SetScaleToLog10()
    table.SetTableRange(*RANGE)
    return table


def actor(data, colour=INK, width=None):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetColor(*colour)
    if width:
        result.GetProperty().SetLineWidth(width)
        result.GetProperty().LightingOff()
    return result


def skin(bag, table):
    kilopascal = vtk.vtkDoubleArray()
    kilopascal.SetName("kPa")
    pascal = bag.GetCellData().GetArray("overpressure_Pa")
    for i in range(pascal.GetNumberOfTuples()):
        kilopascal.InsertNextValue(max(pascal.GetValue(i) * 1e-3, RANGE[0]))
    bag.GetCellData().SetScalars(kilopascal)
    result = actor(bag)
    result.GetMapper().ScalarVisibilityOn()
    result.GetMapper().SetLookupTable(table)
    result.GetMapper().UseLookupTableScalarRangeOn()
    look = result.GetProperty()
    look.SetAmbient(0.42)
    look.SetDiffuse(0.62)
    look.EdgeVisibilityOn()
    look.SetEdgeColor(0.62, 0.50, 0.46)
    look.SetLineWidth(0.3)
    return result


def marked(bag, value):
    pick = vtk.vtkThreshold()
    pick.SetInputData(bag)
    pick.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "jet_mask")
    pick.SetLowerThreshold(value - 0.5)
    pick.SetUpperThreshold(value + 0.5)
    surface = vtk.vtkGeometryFilter()
    surface.SetInputConnection(pick.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def border(part, colour, width):
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(part)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    result = actor(edges.GetOutput(), colour, width)
    result.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    result.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(0, -40)
    return result


def tube(line, radius):
    filter = vtk.vtkTubeFilter()
    filter.SetInputData(line)
    filter.SetRadius(radius)
    filter.SetNumberOfSides(24)
    filter.Update()
    return filter.GetOutput()


def pendulum_actors(line):
    ball = vtk.vtkSphereSource()
    ball.SetCenter(line.GetPoint(1))
    ball.SetRadius(line.GetPointData().GetArray("radius_m").GetValue(1))
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(48)
    ball.Update()
    bare = vtk.vtkPolyData()
    bare.SetPoints(line.GetPoints())
    bare.SetLines(line.GetLines())
    return [actor(ball.GetOutput(), (0.25, 0.38, 0.52)), actor(tube(bare, 0.010), (0.45, 0.52, 0.60))]


def plate():
    source = vtk.vtkPlaneSource()
    source.SetOrigin(-0.012, -0.24, -0.34)
    source.SetPoint1(-0.012, 0.24, -0.34)
    source.SetPoint2(-0.012, -0.24, 0.34)
    source.Update()
    result = actor(source.GetOutput(), (0.88, 0.89, 0.90))
    result.GetProperty().LightingOff()
    return result


def aim(renderer):
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.42, 0.0, 0.06)
    camera.SetPosition(0.42 + 1.4, -3.0, 0.06 + 0.9)
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(0.60)
    renderer.ResetCameraClippingRange()
