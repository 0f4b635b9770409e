# SPDX-License-Identifier: Apache-2.0
# Draws bags at the same times side by side, from the field files of two runs: the skin coloured by overpressure, what the jet
# lights and what is hidden from it, plate and pendulum. Called by render_frames.sh.
# usage: render_frames.py PICTURE.jpg TITLE=FOLDER TITLE=FOLDER TIME_MS...
import math
import os
import sys
import xml.etree.ElementTree as xml

import vtk

CELL = (400, 400)  # [pixels] of one frame
BAR = 96  # [pixels] height of the strip with the scale
RANGE = (1.0, 100.0)  # [kPa] of the colours, logarithmic: gas alone comes to 25 kPa, a jet at the skin to 100 and more
INK = (0.08, 0.08, 0.10)
# Perceptually even, readable without colour: dark is high.
COLOURS = [(0.00, "#f7f4e9"), (0.20, "#f6d9a3"), (0.40, "#f3a45c"), (0.60, "#dd6a3f"), (0.80, "#a5304a"), (1.00, "#4a0f4f")]


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


def frames(folder):
    """[(time in s, bag file, pendulum file)] of fields.pvd."""
    parts = {}
    for part in xml.parse(os.path.join(folder, "fields.pvd")).iter("DataSet"):
        parts.setdefault(float(part.get("timestep")), {})[part.get("part")] = os.path.join(folder, part.get("file"))
    return [(time, files["0"], files["1"]) for time, files in sorted(parts.items())]


def read(file):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


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


def angle(line):
    pivot, centre = line.GetPoint(0), line.GetPoint(1)
    return math.degrees(math.atan2(centre[0] - pivot[0], pivot[2] - centre[2]))


def plate():
    source = vtk.vtkPlaneSource()
    source.SetOrigin(-0.012, -0.24, -0.34)
    source.SetPoint1(-0.012, 0.24, -0.34)
    source.SetPoint2(-0.012, -0.24, 0.34)
    source.Update()
    result = actor(source.GetOutput(), (0.88, 0.89, 0.90))
    result.GetProperty().LightingOff()
    return result


def text(words, size, bold=False):
    result = vtk.vtkTextActor()
    result.SetInput(words)
    look = result.GetTextProperty()
    look.SetFontFamilyToArial()
    look.SetFontSize(size)
    look.SetColor(*INK)
    look.SetBold(bold)
    return result


def aim(renderer):
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(0.40, 0.0, 0.04)
    camera.SetPosition(0.40 + 1.4, -3.0, 0.04 + 0.9)
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(0.52)
    renderer.ResetCameraClippingRange()


def frame(title, time, bag_file, pendulum_file, table):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    bag, line = read(bag_file), read(pendulum_file)
    renderer.AddActor(plate())
    renderer.AddActor(skin(bag, table))
    renderer.AddActor(border(marked(bag, 1), rgb("#1c7fd6"), 2.0))
    renderer.AddActor(border(marked(bag, 2), INK, 2.6))
    for part in pendulum_actors(line):
        renderer.AddActor(part)
    heading = text("%.0f ms, %s" % (time * 1e3, title), 18, bold=True)
    heading.SetPosition(14, CELL[1] - 30)
    swing = text("%.1f\u00b0" % abs(angle(line)), 19)
    swing.SetPosition(CELL[0] - 80, CELL[1] - 30)
    renderer.AddActor2D(heading)
    renderer.AddActor2D(swing)
    aim(renderer)
    return renderer


def legend(table, width):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.03, 0.08)
    bar.SetPosition2(0.42, 0.60)
    bar.UnconstrainedFontSizeOn()
    bar.GetLabelTextProperty().ShallowCopy(text("", 18).GetTextProperty())
    renderer.AddActor2D(bar)
    heading = text("overpressure of gas and jet on the skin [kPa]", 19)
    heading.SetPosition(int(0.03 * width), BAR - 26)
    renderer.AddActor2D(heading)
    for y, colour, words in ((54, INK, "border of what the jet lights"), (22, rgb("#1c7fd6"), "border of what is in it, but hidden or facing away")):
        line = vtk.vtkLineSource()
        line.SetPoint1(0.53 * width, y + 8, 0)
        line.SetPoint2(0.57 * width, y + 8, 0)
        mapper = vtk.vtkPolyDataMapper2D()
        mapper.SetInputConnection(line.GetOutputPort())
        stroke = vtk.vtkActor2D()
        stroke.SetMapper(mapper)
        stroke.GetProperty().SetColor(*colour)
        stroke.GetProperty().SetLineWidth(3)
        renderer.AddActor2D(stroke)
        label = text(words, 19)
        label.SetPosition(int(0.585 * width), y)
        renderer.AddActor2D(label)
    return renderer


def nearest(folder, time):
    found = min(frames(folder), key=lambda entry: abs(entry[0] - time))
    if abs(found[0] - time) > 1e-3:
        sys.exit("render_frames: %s has no fields within 1 ms of %g ms" % (folder, 1e3 * time))
    return found


def main(picture, runs, times):
    columns, rows = 3, 2 * math.ceil(len(times) / 3)
    width, height = columns * CELL[0], rows * CELL[1] + BAR
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(width, height)
    table = colour_table()
    for i, time in enumerate(times):
        for j, (title, folder) in enumerate(runs):
            row, column = 2 * (i // columns) + j, i % columns
            renderer = frame(title, *nearest(folder, time), table)
            top = 1 - row * CELL[1] / height
            renderer.SetViewport(column / columns, top - CELL[1] / height, (column + 1) / columns, top)
            window.AddRenderer(renderer)
    scale = legend(table, width)
    scale.SetViewport(0, 0, 1, BAR / height)
    window.AddRenderer(scale)
    window.Render()
    shot = vtk.vtkWindowToImageFilter()
    shot.SetInput(window)
    shot.ReadFrontBufferOff()
    writer = vtk.vtkJPEGWriter()
    writer.SetQuality(88)
    writer.SetFileName(picture)
    writer.SetInputConnection(shot.GetOutputPort())
    writer.Write()


main(sys.argv[1], [run.split("=", 1) for run in sys.argv[2:4]], [float(t) / 1e3 for t in sys.argv[4:]])
