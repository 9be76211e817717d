"""pvpython read_frames.py DIR: checks that ParaView reads from DIR what DIR/summary.json lists.

Reads every frame of every series through NAME.xdmf with ParaView's three XDMF readers and through NAME.hdf.series with
its series reader, and compares times, numbers of cells and points, and the fields of each frame.
"""

import json
import os
import sys

from paraview import simple
from paraview.servermanager import Fetch

REQUIRED = ("surface", "crack")


def readers(directory, name):
    xdmf = os.path.join(directory, name + ".xdmf")
    series = os.path.join(directory, name + ".hdf.series")
    yield "XDMFReader", simple.XDMFReader(FileNames=[xdmf])
    yield "Xdmf3ReaderS", simple.Xdmf3ReaderS(FileName=[xdmf])
    yield "Xdmf3ReaderT", simple.Xdmf3ReaderT(FileName=[xdmf])
    yield "series reader", simple.OpenDataFile(series)


def times_of(reader):
    times = reader.TimestepValues
    return list(times) if hasattr(times, "__len__") else [times]


def leaves(data):
    """The grids of a dataset, which may be a tree of blocks."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    found = []
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def seen_at(reader, time):
    reader.UpdatePipeline(time)
    grids = leaves(Fetch(reader))
    fields = {g.GetCellData().GetArrayName(i) for g in grids for i in range(g.GetCellData().GetNumberOfArrays())}
    return sum(g.GetNumberOfCells() for g in grids), sum(g.GetNumberOfPoints() for g in grids), fields


def differences(label, reader, frames):
    if reader is None:
        yield f"{label}: cannot be opened"
        return
    times = times_of(reader)
    expected = [frame["time"] for frame in frames]
    if times != expected:
        yield f"{label}: times {times}, summary.json has {expected}"
        return
    fields_of_first = None
    for frame in frames:
        faces, points, fields = seen_at(reader, frame["time"])
        where = f"{label}, {frame['file']}"
        fields_of_first = fields if fields_of_first is None else fields_of_first
        if (faces, points) != (frame["faces"], frame["points"]):
            yield f"{where}: {faces} faces and {points} points, summary.json has {frame['faces']} and {frame['points']}"
        if not fields or fields != fields_of_first:
            yield f"{where}: cell data {sorted(fields)}, the first frame has {sorted(fields_of_first)}"


def check_series(directory, name, frames):
    """The differences in one series; a series without a frame must have no files."""
    if not frames:
        left = [name + e for e in (".xdmf", ".hdf.series") if os.path.exists(os.path.join(directory, name + e))]
        return [f"{file} stands there, but summary.json lists no frame of it" for file in left]
    found = [f"{frame['file']} is missing" for frame in frames
             if not os.path.exists(os.path.join(directory, frame["file"]))]
    if found:
        return found
    for label, reader in readers(directory, name):
        found += differences(f"{name}, {label}", reader, frames)
    return found


def main(directory):
    with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
        series = json.load(file)["frames"]
    found = [f"summary.json lists no series {name}" for name in REQUIRED if name not in series]
    for name, frames in series.items():
        found += check_series(directory, name, frames)
    count = sum(len(frames) for frames in series.values())
    if found or count == 0:
        print("\n".join(found or ["summary.json lists no frame"]))
        return 1
    print(f"{count} frames read, all as summary.json says")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print("usage: pvpython read_frames.py DIR")
        sys.exit(2)
    sys.exit(main(sys.argv[1]))
