# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renders the liver job off screen: temperature on a cut through the needle, the dead zone, the tumour.

Usage: xvfb-run -a /usr/bin/python3 doc/pictures/liver.py output/liver_ablation doc/images/liver.png [FRAME]
(Debian's python3-vtk9 and xvfb: its VTK renders only where there is a display, if only an imagined one)
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import vtk

# Places of meshes/liver.geo and prm/liver_ablation.prm, m
CENTRE = (0.062, 0.066, 0.080)
NEEDLE = (0.6, 0.8, 0.0)
TUMOUR_RADIUS = 0.015

LIMITS = (310.0, 355.0)  # K
COLOURS = ((0.00, (0.96, 0.88, 0.84)), (0.12, (0.97, 0.80, 0.68)), (0.35, (0.96, 0.60, 0.30)),
           (0.60, (0.85, 0.27, 0.13)), (0.82, (0.55, 0.05, 0.22)), (1.00, (0.26, 0.02, 0.28)))
LIVER, DEAD, TUMOUR, INK = (0.62, 0.27, 0.22), (0.05, 0.30, 0.75), (0.06, 0.06, 0.06), (0.15, 0.15, 0.15)


def read(directory, number):
    frames = [node.get("file") for node in ElementTree.parse(directory / "solution.pvd").iter("DataSet")]
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(directory / frames[number]))
    reader.Update()
    return reader.GetOutput()


def plane_at(z):
    plane = vtk.vtkPlane()
    plane.SetOrigin(CENTRE[0], CENTRE[1], z)
    plane.SetNormal(0, 0, -1)
    return plane


def run(algorithm, data):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def below(body, z):
    clip = vtk.vtkClipDataSet()
    clip.SetClipFunction(plane_at(z))
    return run(clip, body)


def cut(body):
    cutter = vtk.vtkCutter()
    cutter.SetCutFunction(plane_at(CENTRE[2]))
    return run(cutter, body)


def smooth_surface(data):
    normals = vtk.vtkPolyDataNormals()
    normals.SetFeatureAngle(50)
    return run(normals, run(vtk.vtkDataSetSurfaceFilter(), data))


def contour(data, field, value):
    filter = vtk.vtkContourFilter()
    filter.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, field)
    filter.SetValue(0, value)
    return run(filter, data)


def tube(line, radius):
    result = vtk.vtkTubeFilter()
    result.SetRadius(radius)
    result.SetNumberOfSides(24)
    result.CappingOn()
    return run(result, line)


def line_between(first, second):
    source = vtk.vtkLineSource()
    source.SetPoint1(first)
    source.SetPoint2(second)
    source.Update()
    return source.GetOutput()


def circle(radius):
    source = vtk.vtkRegularPolygonSource()
    source.SetCenter(CENTRE)
    source.SetRadius(radius)
    source.SetNumberOfSides(96)
    source.GeneratePolygonOff()
    source.Update()
    return source.GetOutput()


def colour_table():
    table = vtk.vtkColorTransferFunction()
    for share, colour in COLOURS:
        table.AddRGBPoint(LIMITS[0] + share * (LIMITS[1] - LIMITS[0]), *colour)
    return table


def actor(data, colour=None, table=None):
    """In one colour, or coloured by temperature and not shaded, so that colours mean what the bar says."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    if table is None:
        mapper.ScalarVisibilityOff()
        result.GetProperty().SetColor(*colour)
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("temperature_K")
        mapper.SetLookupTable(table)
        result.GetProperty().LightingOff()
    return result


def shining(thing):
    thing.GetProperty().SetSpecular(0.25)
    thing.GetProperty().SetSpecularPower(25)
    return thing


def colour_bar(table):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("temperature, K")
    bar.SetNumberOfLabels(4)
    bar.SetLabelFormat("%.0f")
    bar.SetUnconstrainedFontSize(True)
    bar.SetPosition(0.885, 0.16)
    bar.SetWidth(0.07)
    bar.SetHeight(0.68)
    bar.SetVerticalTitleSeparation(12)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetFontSize(22)
        text.SetColor(*INK)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    return bar


def label(text, place, shift, width, colour=INK):
    """Text with a line to a place, from which it is shifted by pixels; width as a share of the window's."""
    caption = vtk.vtkCaptionActor2D()
    caption.SetCaption(text)
    caption.SetAttachmentPoint(place)
    caption.SetPosition(*shift)
    caption.SetWidth(width)
    caption.SetHeight(0.045)
    caption.BorderOff()
    caption.ThreeDimensionalLeaderOff()
    caption.GetProperty().SetColor(*colour)
    caption.GetProperty().SetLineWidth(1.5)
    caption.GetTextActor().SetTextScaleModeToNone()
    style = caption.GetCaptionTextProperty()
    style.SetFontSize(24)
    style.SetColor(*colour)
    style.ItalicOff()
    style.BoldOff()
    style.ShadowOff()
    return caption


def point_on(data, direction):
    """The point of some lines that lies farthest in a direction."""
    points = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    return max(points, key=lambda point: sum(a * b for a, b in zip(point, direction)))


def scene(body):
    table = colour_table()
    section = cut(body)
    border = contour(section, "ln_damage", 0.0)
    rim = circle(TUMOUR_RADIUS)
    entry = [c - 0.085 * d for c, d in zip(CENTRE, NEEDLE)]

    view = vtk.vtkRenderer()
    view.SetBackground(1, 1, 1)
    view.AddActor(shining(actor(smooth_surface(below(body, CENTRE[2] - 2e-4)), LIVER)))  # the cut itself lies on top
    view.AddActor(actor(section, table=table))
    view.AddActor(actor(tube(border, 0.0007), DEAD))
    view.AddActor(actor(tube(rim, 0.0004), TUMOUR))
    view.AddActor(shining(actor(tube(line_between(entry, CENTRE), 0.0011), (0.70, 0.73, 0.77))))
    view.AddActor(colour_bar(table))
    view.AddActor(label("border of the dead tissue", point_on(border, (1, -0.5, 0)), (90, -80), 0.24, DEAD))
    view.AddActor(label("tumour", point_on(rim, (-1, 0.5, 0)), (-150, 60), 0.075, TUMOUR))
    view.AddActor(label("needle", [c - 0.075 * d for c, d in zip(CENTRE, NEEDLE)], (-140, 20), 0.07))
    return view


def look(view):
    camera = view.GetActiveCamera()
    camera.SetFocalPoint(0.105, 0.075, 0.065)
    camera.SetPosition(0.075, -0.12, 0.45)
    camera.SetViewUp(0, 0, 1)
    view.ResetCamera()
    camera.Zoom(1.45)


def write(view, png):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1280, 760)
    window.AddRenderer(view)
    look(view)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.Update()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(png)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    write(scene(read(pathlib.Path(sys.argv[1]), int(sys.argv[3]) if len(sys.argv) > 3 else -1)), sys.argv[2])
