#!/usr/bin/env pvpython
"""A picture of one frame of a run: the original boundary in grey, crack faces by the time at which they opened.

xvfb-run -a pvpython jobs/render.py DIR [--series surface|crack] [--frame last|N] [--out picture.png] [--size 1600x900]
"""
import argparse
import json
import pathlib
import sys

from paraview.simple import (CreateRenderView, GetColorTransferFunction, Render, SaveScreenshot, Show, Threshold,
                             VTKHDFReader, _DisableFirstRenderCameraReset)
from paraview.servermanager import Fetch
from vtkmodules.util.numpy_support import vtk_to_numpy
import numpy

BOUNDARY = [0.80, 0.76, 0.70]
CRACK_EARLY, CRACK_LATE = [0.45, 0.03, 0.03], [0.90, 0.35, 0.12]
FROM = numpy.array([-0.45, -1.0, 0.95])  # where the camera stands, seen from the block's centre


def arguments():
    parser = argparse.ArgumentParser(prog="render.py", description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=pathlib.Path, help="a directory that cracksim wrote")
    parser.add_argument("--series", choices=["surface", "crack"], default="surface")
    parser.add_argument("--frame", default="last", help="last, or the number of a frame, from 0")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("picture.png"))
    parser.add_argument("--size", default="1600x900", help="in pixels")
    return parser.parse_args()


def frame_file(directory, series, frame):
    index = directory / f"{series}.hdf.series"
    if not index.is_file():
        sys.exit(f"render.py: {directory} is not a run's directory with {series} frames: it has no {index.name}")
    files = json.loads(index.read_text(encoding="utf-8"))["files"]
    if frame != "last" and not (frame.isdigit() and int(frame) < len(files)):
        sys.exit(f"render.py: --frame {frame}: give 'last' or a number from 0 to {len(files) - 1}")
    return directory / files[-1 if frame == "last" else int(frame)]["name"]


def bounds(mesh):
    """Of nearly all points: a lone fragment that flies away does not make the block small."""
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    low, high = numpy.quantile(points, [0.002, 0.998], axis=0)
    return low, high


def place_camera(view, low, high):
    view.CameraViewUp = [0, 0, 1]
    view.CameraFocalPoint = ((low + high) / 2).tolist()
    view.CameraPosition = ((low + high) / 2 + FROM).tolist()
    # ResetCamera frames the sphere around the box, which leaves much room around a flat block: look at its corners.
    corners = numpy.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    towards = -FROM / numpy.linalg.norm(FROM)
    right = numpy.cross(towards, [0, 0, 1])
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, towards)
    offsets = corners - (low + high) / 2
    tangent = numpy.tan(numpy.radians(view.CameraViewAngle / 2))
    aspect = view.ViewSize[0] / view.ViewSize[1]
    needed = [max(abs(o @ up), abs(o @ right) / aspect) / tangent - o @ towards for o in offsets]
    view.CameraPosition = ((low + high) / 2 - towards * max(needed) * 1.08).tolist()


def show_faces(view, faces, colour):
    display = Show(faces, view)
    display.SetRepresentationType("Surface")
    display.ColorArrayName = [None, ""]
    display.DiffuseColor = display.AmbientColor = colour
    display.Ambient, display.Diffuse, display.Specular = 0.25, 0.85, 0.0
    return display


def main():
    options = arguments()
    try:
        size = [int(side) for side in options.size.split("x")]
        width, height = size
    except ValueError:
        sys.exit(f"render.py: --size {options.size}: give width and height in pixels, as in 1600x900")
    source = VTKHDFReader(FileName=[str(frame_file(options.directory, options.series, options.frame))])
    mesh = Fetch(source)
    _DisableFirstRenderCameraReset()
    view = CreateRenderView()
    view.ViewSize = [width, height]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0

    opened = vtk_to_numpy(mesh.GetCellData().GetArray("opened_at"))
    for part, colour in (("Below Lower Threshold", BOUNDARY), ("Above Upper Threshold", CRACK_EARLY)):
        faces = Threshold(Input=source, Scalars=["CELLS", "opened_at"], ThresholdMethod=part, LowerThreshold=-0.5,
                          UpperThreshold=-0.5)
        display = show_faces(view, faces, colour)
        cracks = opened[opened >= 0]
        if colour is CRACK_EARLY and cracks.size and cracks.max() > cracks.min():
            colours = GetColorTransferFunction("opened_at")
            colours.RGBPoints = [cracks.min(), *CRACK_EARLY, cracks.max(), *CRACK_LATE]
            display.ColorArrayName = ["CELLS", "opened_at"]
            display.LookupTable = colours
            display.SetScalarBarVisibility(view, False)
    place_camera(view, *bounds(mesh))
    Render(view)
    SaveScreenshot(str(options.out), view, ImageResolution=[width, height])
    print(f"{options.out}: {mesh.GetNumberOfCells()} faces, {int((opened >= 0).sum())} of them of cracks")


if __name__ == "__main__":
    main()
