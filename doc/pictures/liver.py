# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renders the liver job off screen: temperature on a cut through the needle, the dead zone, the tumour.

Usage: /usr/bin/python3 liver.py OUTPUT_DIRECTORY PNG [FRAME]     (Debian's python3-vtk9)
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import vtk

directory, png = pathlib.Path(sys.argv[1]), sys.argv[2]
frames = [node.get("file") for node in ElementTree.parse(directory / "solution.pvd").iter("DataSet")]
frame = frames[int(sys.argv[3]) if len(sys.argv) > 3 else -1]

reader = vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(str(directory / frame))
reader.Update()
body = reader.GetOutput()

CENTRE = (0.062, 0.066, 0.080)
plane = vtk.vtkPlane()
plane.SetOrigin(*CENTRE)
plane.SetNormal(0, 0, -1)  # horizontal, through the needle


def surface(data):
    extract = vtk.vtkDataSetSurfaceFilter()
    extract.SetInputData(data)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(extract.GetOutputPort())
    normals.SetFeatureAngle(60)
    normals.Update()
    return normals.GetOutput()


def actor(data, colour=None, opacity=1.0, field=None, limits=None, table=None):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    if field:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(field)
        mapper.SetScalarRange(*limits)
        mapper.SetLookupTable(table)
    else:
        mapper.ScalarVisibilityOff()
    result = vtk.vtkActor()
    result.SetMapper(mapper)
    if colour:
        result.GetProperty().SetColor(*colour)
    result.GetProperty().SetOpacity(opacity)
    return result


below = vtk.vtkPlane()
below.SetOrigin(CENTRE[0], CENTRE[1], CENTRE[2] - 2e-4)  # the cut itself lies on top
below.SetNormal(0, 0, -1)
clip = vtk.vtkClipDataSet()
clip.SetInputData(body)
clip.SetClipFunction(below)
clip.Update()
lower = surface(clip.GetOutput())

cutter = vtk.vtkCutter()
cutter.SetCutFunction(plane)
cutter.SetInputData(body)
cutter.Update()

table = vtk.vtkColorTransferFunction()
LIMITS = (310.0, 385.0)
for share, colour in ((0.0, (0.45, 0.09, 0.10)), (0.15, (0.62, 0.16, 0.12)), (0.4, (0.86, 0.40, 0.12)),
                      (0.7, (0.98, 0.78, 0.25)), (1.0, (1.0, 1.0, 0.85))):
    table.AddRGBPoint(LIMITS[0] + share * (LIMITS[1] - LIMITS[0]), *colour)


def on_cut(field, value):
    lines = vtk.vtkContourFilter()
    lines.SetInputConnection(cutter.GetOutputPort())
    lines.SetInputArrayToProcess(0, 0, 0, 0, field)
    lines.SetValue(0, value)
    tube = vtk.vtkTubeFilter()
    tube.SetInputConnection(lines.GetOutputPort())
    tube.SetRadius(0.0006)
    tube.Update()
    return tube.GetOutput()


rim = vtk.vtkRegularPolygonSource()  # the tumour is a sphere of 15 mm, see meshes/liver.geo
rim.SetCenter(*CENTRE)
rim.SetRadius(0.015)
rim.SetNumberOfSides(96)
rim.GeneratePolygonOff()
rim_tube = vtk.vtkTubeFilter()
rim_tube.SetInputConnection(rim.GetOutputPort())
rim_tube.SetRadius(0.0004)
rim_tube.Update()

needle = vtk.vtkLineSource()
needle.SetPoint1(CENTRE[0] - 0.6 * 0.085, CENTRE[1] - 0.8 * 0.085, CENTRE[2])
needle.SetPoint2(*CENTRE)
needle_tube = vtk.vtkTubeFilter()
needle_tube.SetInputConnection(needle.GetOutputPort())
needle_tube.SetRadius(0.0011)
needle_tube.SetNumberOfSides(24)
needle_tube.CappingOn()
needle_tube.Update()

scene = vtk.vtkRenderer()
scene.SetBackground(1, 1, 1)
scene.AddActor(actor(lower, (0.55, 0.17, 0.14)))
scene.AddActor(actor(cutter.GetOutput(), field="temperature_K", limits=LIMITS, table=table))
scene.AddActor(actor(on_cut("ln_damage", 0.0), (0.05, 0.25, 0.75)))
scene.AddActor(actor(rim_tube.GetOutput(), (0.1, 0.1, 0.1)))
scene.AddActor(actor(needle_tube.GetOutput(), (0.75, 0.77, 0.8)))

bar = vtk.vtkScalarBarActor()
bar.SetLookupTable(table)
bar.SetTitle("temperature, K")
bar.SetNumberOfLabels(6)
bar.SetLabelFormat("%.0f")
bar.SetPosition(0.88, 0.2)
bar.SetWidth(0.08)
bar.SetUnconstrainedFontSize(True)
bar.GetTitleTextProperty().SetFontSize(18)
bar.GetLabelTextProperty().SetFontSize(18)
bar.SetHeight(0.6)
for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
    text.SetColor(0.1, 0.1, 0.1)
    text.ItalicOff()
    text.ShadowOff()
    text.BoldOff()
scene.AddActor(bar)
note = vtk.vtkTextActor()
note.SetInput("blue: border of the dead tissue    black: tumour")
note.GetTextProperty().SetColor(0.1, 0.1, 0.1)
note.GetTextProperty().SetFontSize(20)
note.SetPosition(24, 670)
scene.AddActor(note)

camera = scene.GetActiveCamera()
camera.SetFocalPoint(0.105, 0.075, 0.065)
camera.SetPosition(0.06, -0.20, 0.42)
camera.SetViewUp(0, 0, 1)
scene.ResetCamera()
camera.Zoom(1.3)

window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(8)
window.SetSize(1200, 720)
window.AddRenderer(scene)
window.Render()
image = vtk.vtkWindowToImageFilter()
image.SetInput(window)
image.Update()
writer = vtk.vtkPNGWriter()
writer.SetFileName(png)
writer.SetInputConnection(image.GetOutputPort())
writer.Write()
