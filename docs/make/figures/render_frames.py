# SPDX-License-Identifier: Apache-2.0
# Draws bags at the same times side by side, from the field files of two runs: the skin coloured by
# overpressure, what the jet lights and what is hidden from it, plate and pendulum. Used by render_frames.sh.
# usage: render_frames.py PICTURE.jpg TITLE=FOLDER TITLE=FOLDER TIME_MS...
import math
import os
import sys
import xml.etree.ElementTree as xml

import vtk
from render_scene import INK, aim, border, colour_table, marked, pendulum_actors, plate, rgb, skin

CELL = (400, 400)  # [pixels] of one frame
BAR = 96  # [pixels] height of the strip with the scale
BORDERS = [
    (54, INK, "border of what the jet lights"),
    (22, rgb("#1c7fd6"), "border of what is in it, but hidden or facing away"),
]


def frames(folder):
    """[(time in s, bag file, pendulum file)] of fields.pvd."""
    parts = {}
    for part in xml.parse(os.path.join(folder, "fields.pvd")).iter("DataSet"):
        at_this_time = parts.setdefault(float(part.get("timestep")), {})
        at_this_time[part.get("part")] = os.path.join(folder, part.get("file"))
    return [(time, files["0"], files["1"]) for time, files in sorted(parts.items())]


def read(file):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def angle(line):
    pivot, centre = line.GetPoint(0), line.GetPoint(1)
    return math.degrees(math.atan2(centre[0] - pivot[0], pivot[2] - centre[2]))


def text(words, size, bold=False):
    result = vtk.vtkTextActor()
    result.SetInput(words)
    look = result.GetTextProperty()
    look.SetFontFamilyToArial()
    look.SetFontSize(size)
    look.SetColor(*INK)
    look.SetBold(bold)
    return result


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
    for y, colour, words in BORDERS:
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
