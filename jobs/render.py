#!/usr/bin/env pvpython
"""A picture of one frame of a run, or a movie of all.

  xvfb-run -a pvpython jobs/render.py DIR --out picture.png
  xvfb-run -a pvpython jobs/render.py DIR --view topology --frame 12 --out map.png
  xvfb-run -a pvpython jobs/render.py DIR --out movie.mp4

geometry: the free faces: the original boundary grey, crack faces red, lighter if they opened later.
crack:    the crack faces only.
masses:   a sphere on each mass, coloured by fragment.
topology: the faces inside the block, shrunk: sewn faces blue, unsewn faces orange.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy
from paraview.servermanager import Fetch
from paraview.simple import (Calculator, CellDatatoPointData, CreateRenderView, Delete, GetColorTransferFunction,
                             Render, SaveScreenshot, Show, Text, Threshold, VTKHDFReader,
                             _DisableFirstRenderCameraReset)
from vtkmodules.util.numpy_support import vtk_to_numpy

SERIES = {"geometry": "surface", "crack": "crack", "masses": "masses", "topology": "topology"}
BOUNDARY = [0.80, 0.76, 0.70]
CRACK_EARLY, CRACK_LATE = [0.45, 0.03, 0.03], [0.90, 0.35, 0.12]
SEWN, UNSEWN = [0.30, 0.50, 0.75], [0.95, 0.50, 0.10]
MOVIES = {".mp4": ["-c:v", "libx264", "-pix_fmt", "yuv420p"], ".webm": ["-c:v", "libvpx-vp9"], ".gif": []}


def fail(text):
    sys.exit(f"render.py: {text}")


def arguments():
    parser = argparse.ArgumentParser(prog="render.py", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=pathlib.Path, help="a directory that cracksim wrote")
    parser.add_argument("--view", choices=SERIES, default="geometry")
    parser.add_argument("--frame", default="last", help="last, or the number of a frame, from 0")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("picture.png"),
                        help="a picture (.png), or a movie of all frames (.mp4, .webm, .gif)")
    parser.add_argument("--size", type=size, default="1600x900", help="in pixels, even numbers up to 8192")
    parser.add_argument("--from", dest="viewpoint", type=direction, default="-0.45,-1,0.95",
                        help="the direction in which the camera stands, such as=-0.45,-1,0.95")
    parser.add_argument("--title", default="", help="a line to write above the picture")
    parser.add_argument("--fps", type=frame_rate, default=25, help="frames a second of a movie")
    options = parser.parse_args()
    if options.out.suffix not in [".png", *MOVIES]:
        parser.error(f"--out {options.out}: name a .png, .mp4, .webm or .gif")
    if not options.out.absolute().parent.is_dir():
        parser.error(f"--out {options.out}: there is no directory {options.out.parent}")
    if options.out.suffix in MOVIES and not shutil.which("ffmpeg"):
        parser.error(f"--out {options.out}: movies need ffmpeg (Debian package ffmpeg)")
    return options


def size(text):
    width, height = (int(side) for side in text.split("x"))
    if not (0 < width <= 8192 and 0 < height <= 8192) or width % 2 or height % 2:
        raise ValueError(text)
    return width, height


def frame_rate(text):
    if not 0 < float(text) <= 1000:
        raise ValueError(text)
    return float(text)


def direction(text):
    x, y, z = (float(part) for part in text.split(","))
    if not numpy.isfinite([x, y, z]).all() or x == 0 and y == 0:
        raise ValueError(text)
    return numpy.array([x, y, z])


def frame_files(directory, view):
    series = SERIES[view]
    index = directory / f"{series}.hdf.series"
    if not index.is_file():
        advice = f"run with --set output.{series}=true" if directory.is_dir() else "there is no such directory"
        advice += "; without a crack there are none" if series == "crack" else ""
        fail(f"{directory} has no {series} frames for the view {view}: {advice}")
    return [directory / entry["name"] for entry in json.loads(index.read_text(encoding="utf-8"))["files"]]


def chosen(files, frame):
    if frame != "last" and not (frame.isdigit() and int(frame) < len(files)):
        fail(f"--frame {frame}: give 'last' or a number from 0 to {len(files) - 1}")
    return files[-1 if frame == "last" else int(frame)]


def points_of(file):
    source = VTKHDFReader(FileName=[str(file)])
    points = vtk_to_numpy(Fetch(source).GetPoints().GetData())
    Delete(source)
    return points


def place_camera(view, points, viewpoint, radius):
    """Places the camera so that the picture shows all but lone fragments far away, which would make the block small.

    radius: that of the sphere drawn around each point.
    """
    towards = -viewpoint / numpy.linalg.norm(viewpoint)
    right = numpy.cross(towards, [0, 0, 1])
    right /= numpy.linalg.norm(right)
    axes = numpy.array([right, numpy.cross(right, towards), towards])
    projected = points @ axes.T
    low, high = numpy.quantile(projected, [0.002, 0.998], axis=0)
    near = (high - low) / 4
    inside = projected[numpy.all((projected >= low - near) & (projected <= high + near), axis=1)]
    focus = (inside.min(axis=0) + inside.max(axis=0)) / 2
    offsets = abs(inside - focus) * [1, 1, 0] + (inside - focus) * [0, 0, 1] + [radius, radius, -radius]
    tangent = numpy.tan(numpy.radians(view.CameraViewAngle / 2))
    aspect = view.ViewSize[0] / view.ViewSize[1]
    distance = (numpy.maximum(offsets[:, 0] / aspect, offsets[:, 1]) / tangent - offsets[:, 2]).max()
    view.CameraViewUp = [0, 0, 1]
    view.CameraFocalPoint = (focus @ axes).tolist()
    view.CameraPosition = (focus @ axes - towards * distance * 1.05).tolist()


def write_title(view, title):
    display = Show(Text(Text=title), view)
    display.WindowLocation = "Upper Center"
    display.Color = [0, 0, 0]
    display.FontSize = max(8, view.ViewSize[1] // 28)


def shown(view, source, colour):
    display = Show(source, view)
    display.SetRepresentationType("Surface")
    display.ColorArrayName = [None, ""]
    display.DiffuseColor = display.AmbientColor = colour
    display.Ambient, display.Diffuse, display.Specular = 0.25, 0.85, 0.0
    return display


def colour_by(display, view, array, colours):
    table = GetColorTransferFunction(array[1])
    table.RGBPoints = colours
    display.ColorArrayName = array
    display.LookupTable = table
    display.SetScalarBarVisibility(view, False)


def cells_where(source, array, lower, upper):
    return Threshold(Input=source, Scalars=["CELLS", array], ThresholdMethod="Between", LowerThreshold=lower,
                     UpperThreshold=upper)


def draw_faces(view, source, latest):
    """Draws free faces; the colours of cracks range up to the time `latest`, the same in all frames of a movie."""
    boundary = cells_where(source, "opened_at", -2, -0.5)
    cracks = cells_where(source, "opened_at", -0.5, 1e300)
    shown(view, boundary, BOUNDARY)
    display = shown(view, cracks, CRACK_EARLY)
    if latest > 0:
        colour_by(display, view, ["CELLS", "opened_at"], [0, *CRACK_EARLY, latest, *CRACK_LATE])
    return [boundary, cracks]


def draw_masses(view, source, radius):
    """Gives neighbouring ids distant colours: the fractional part of the id times the golden ratio."""
    by_point = CellDatatoPointData(Input=source)
    mixed = Calculator(Input=by_point, AttributeType="Point Data", ResultArrayName="colour",
                       Function="fragment*0.6180339887 - floor(fragment*0.6180339887)")
    display = shown(view, mixed, BOUNDARY)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    display.GaussianRadius = radius
    colour_by(display, view, ["POINTS", "colour"],
              [0, .70, .82, 1, .2, 1, .75, .45, .4, .70, .95, .65, .6, 1, .65, .75, .8, 1, .92, .60, 1, .75, .70, 1])
    return [by_point, mixed]


def draw_map(view, source):
    unsewn = cells_where(source, "opened_at", -0.5, 1e300)
    sewn = cells_where(source, "sewn", 0.5, 1.5)
    shown(view, sewn, SEWN)
    shown(view, unsewn, UNSEWN)
    return [sewn, unsewn]


def last_opening(file):
    source = VTKHDFReader(FileName=[str(file)])
    opened = vtk_to_numpy(Fetch(source).GetCellData().GetArray("opened_at"))
    Delete(source)
    return opened.max(initial=0)


def mass_radius(directory):
    """A third of the median edge."""
    for line in (directory / "input.resolved.yaml").read_text(encoding="utf-8").splitlines():
        if line.strip().startswith("edge: "):
            return float(numpy.median([float(side) for side in line.split(":")[1].strip(" []").split(",")])) / 3
    raise SystemExit(f"render.py: {directory}/input.resolved.yaml does not tell block.edge")


def draw(options, view, file, latest):
    source = VTKHDFReader(FileName=[str(file)])
    if options.view == "masses":
        return [source, *draw_masses(view, source, mass_radius(options.directory))]
    if options.view == "topology":
        return [source, *draw_map(view, source)]
    return [source, *draw_faces(view, source, latest)]


def picture(options, view, file, latest, out):
    sources = draw(options, view, file, latest)
    Render(view)
    SaveScreenshot(str(out), view, ImageResolution=list(options.size))
    for source in reversed(sources):
        Delete(source)


def movie(options, view, files, latest):
    with tempfile.TemporaryDirectory() as folder:
        for number, file in enumerate(files):
            picture(options, view, file, latest, f"{folder}/{number:06d}.png")
        command = ["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(options.fps), "-i", f"{folder}/%06d.png",
                   *MOVIES[options.out.suffix], str(options.out)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        fail(f"ffmpeg could not make {options.out}: {done.stderr.strip()}")


def main():
    options = arguments()
    files = frame_files(options.directory, options.view)
    _DisableFirstRenderCameraReset()
    view = CreateRenderView()
    view.ViewSize = list(options.size)
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    latest = last_opening(files[-1]) if options.view in ("geometry", "crack") else 0
    if options.out.suffix == ".png":
        files = [chosen(files, options.frame)]
    ends = [files[0], files[-1]] if len(files) > 1 else files
    radius = mass_radius(options.directory) if options.view == "masses" else 0
    place_camera(view, numpy.concatenate([points_of(file) for file in ends]), options.viewpoint, radius)
    if options.title:
        write_title(view, options.title)
    if options.out.suffix == ".png":
        picture(options, view, files[0], latest, options.out)
    else:
        movie(options, view, files, latest)
    print(f"{options.out}: {len(files)} frame(s) of {options.directory}")


if __name__ == "__main__":
    main()
