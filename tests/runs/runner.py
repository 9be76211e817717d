"""Shared by the tests of whole runs: scenes, runs of cracksim under mpirun, and readers of their files."""
import array
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
    "OMPI_MCA_mpi_yield_when_idle": "1",  # more ranks than cores: a rank that waits must not spin
    "ASAN_OPTIONS": "fast_unwind_on_malloc=0",
    "LSAN_OPTIONS": f"suppressions={pathlib.Path(__file__).resolve().parent.parent}/support/lsan.supp:"
                    "print_suppressions=0",
}
ROOT = pathlib.Path(__file__).resolve().parents[2]


class Failure(Exception):
    """A check that did not hold; its text names the check and the result."""


def check(condition, text):
    if not condition:
        raise Failure(text)


def cracking_scene(**changes):
    """A block of 8 x 7 x 4 cubes of 1 cm with an initial velocity that breaks it within 60 ms; JSON is valid YAML.

    Keyword arguments replace sections of the scene.
    """
    scene = {
        "block": {"entity": "hexahedron", "cells": [8, 7, 4], "edge": 0.01, "origin": [0, 0, 0]},
        "material": {"model": "paper", "young": 2.0e4, "density": 1000, "damping": 0.2},
        "sensors": {"kind": "normal", "threshold": 0.02, "weibull": {"shape": 8, "seed": 1}},
        "initial": {"velocity": ["1.2*(x-0.04)/0.04", "0.3*sin(60*x)", "0.8*exp(-2000*((x-0.03)^2+(y-0.04)^2))"]},
        "time": {"end": 0.06},
        "coat": {"rate": 50},
        "output": {"rate": 50, "surface": True, "crack": True},
        "history": {"rate": 200},
    }
    scene.update(changes)
    return {key: value for key, value in scene.items() if value is not None}


class Workplace:
    """A temporary folder in which cracksim runs; every run gets its own directory."""

    def __init__(self, binary):
        self.binary = str(pathlib.Path(binary).resolve())
        self._folder = tempfile.TemporaryDirectory(prefix="cracksim-")
        self.path = pathlib.Path(self._folder.name)
        self._runs = 0

    def write(self, scene, name="scene.yaml"):
        path = self.path / name
        text = scene if isinstance(scene, str) else json.dumps(scene, indent=1).replace("Infinity", ".inf")
        path.write_text(text, encoding="utf-8")
        return path

    def run(self, *arguments, ranks=1, binary=None):
        """The finished process of mpirun; standard output and standard error are texts."""
        command = ["mpirun", "-n", str(ranks), binary or self.binary, *map(str, arguments)]
        return subprocess.run(command, cwd=self.path, env={**os.environ, **ENVIRONMENT}, text=True, check=False,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=600)

    def finished(self, scene, *arguments, ranks=1, binary=None):
        """Runs a scene, which must finish; returns its directory."""
        self._runs += 1
        directory = self.path / f"run-{self._runs}"
        done = self.run(self.write(scene), "--out", directory, "--quiet", *arguments, ranks=ranks, binary=binary)
        check(done.returncode == 0, f"{' '.join(done.args)} returned {done.returncode}\n{done.stdout}{done.stderr}")
        status = summary(directory)["status"]
        check(status == "finished", f"the run in {directory} has the status {status}")
        return directory


def summary(directory):
    return json.loads((pathlib.Path(directory) / "summary.json").read_text(encoding="utf-8"))


def dataset(file, path):
    """A dataset of an HDF5 file as a flat list of numbers, bit for bit, read by h5dump."""
    header = subprocess.run(["h5dump", "-H", "-d", path, str(file)], text=True, capture_output=True, check=True).stdout
    kind = re.search(r"DATATYPE\s+H5T_(?:IEEE|STD)_([FIU])(\d+)", header)
    check(kind, f"{file}: {path} holds no plain numbers:\n{header}")
    code = {"F32": "f", "F64": "d", "I8": "b", "U8": "B", "I32": "i", "I64": "q"}["".join(kind.groups())]
    with tempfile.NamedTemporaryFile() as raw:
        subprocess.run(["h5dump", "-d", path, "-b", "NATIVE", "-o", raw.name, str(file)], check=True,
                       stdout=subprocess.DEVNULL)
        return array.array(code, pathlib.Path(raw.name).read_bytes()).tolist()


def frame_cells(file):
    """The cells of a frame, (cell data ..., corner positions ...), sorted: the order in the file is irrelevant."""
    points = dataset(file, "/VTKHDF/Points")
    connectivity = dataset(file, "/VTKHDF/Connectivity")
    fields = [dataset(file, f"/VTKHDF/CellData/{name}") for name in ("entity", "fragment", "opened_at", "opening")]
    cells = []
    for number, values in enumerate(zip(*fields)):
        corners = [tuple(points[3 * p:3 * p + 3]) for p in connectivity[4 * number:4 * number + 4]]
        first = corners.index(min(corners))
        cells.append((*values, *corners[first:], *corners[:first]))
    return len(points) // 3, sorted(cells)


def last_frame(directory, kind):
    """The last frame file of a kind: surface or crack."""
    frames = sorted((pathlib.Path(directory) / "frames").glob(f"{kind}-*.hdf"))
    check(frames, f"{directory} has no {kind} frame")
    return frames[-1]


def main(tests):
    """Runs the functions tests(workplace, quick), one after the other; exits with success if all checks held."""
    arguments = [argument for argument in sys.argv[1:] if argument != "--quick"]
    if len(arguments) != 1:
        sys.exit(f"usage: {sys.argv[0]} CRACKSIM [--quick]")
    failed = 0
    for test in tests:
        try:
            test(Workplace(arguments[0]), "--quick" in sys.argv)
            print(f"passed  {test.__name__}", flush=True)
        except Failure as failure:
            failed += 1
            print(f"FAILED  {test.__name__}: {failure}", flush=True)
    sys.exit(1 if failed else 0)
