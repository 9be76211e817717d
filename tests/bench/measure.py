"""Shared by the measurements of whole programs: runs of cracksim, alternating runs, medians, rows of the table."""
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Ranks are bound to cores, unlike in the tests: a rank that migrates loses its caches.
ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "core",
}

BLOCK = {"entity": "hexahedron", "cells": [70, 70, 10], "edge": 0.01}
STEP = 1 / 1050
SILENT = {"rate": 0, "surface": False, "crack": False}


class Spread(NamedTuple):
    """Median and extremes of repeated measurements."""
    median: float
    low: float
    high: float

    @staticmethod
    def of(values):
        return Spread(statistics.median(values), min(values), max(values))


def intact_scene(cells, steps, damping=0.2, **changes):
    """A block in slow, smooth motion with strains of about a thousandth; its sensors, if it has any, never trigger."""
    length = 0.01 * cells[0]
    wave = f"{2 * 3.14159265358979 / length:.6g}"
    scene = {
        "block": {**BLOCK, "cells": list(cells)},
        "material": {"model": "paper", "young": 1.15e4, "density": 1000, "damping": damping},
        "sensors": {"kind": "normal", "threshold": 0.02},
        "initial": {"velocity": [f"0.002*sin({wave}*y)", f"0.002*cos({wave}*x)", f"0.002*sin({wave}*(x+y))"]},
        "time": {"end": STEP * steps, "step": STEP},
        "coat": {"rate": 1e-6},
        "output": SILENT,
        "history": {"rate": 0},
    }
    scene.update(changes)
    return scene


class Workplace:
    """A temporary folder in which programs run."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="cracksim-bench-")
        self.path = pathlib.Path(self._folder.name)
        self._runs = 0

    def run(self, ranks, *command):
        """The standard output of a program under mpirun."""
        full = ["mpirun", "-n", str(ranks), *map(str, command)]
        done = subprocess.run(full, cwd=self.path, env={**ENVIRONMENT, **os.environ}, text=True, check=False,
                              stdin=subprocess.DEVNULL, capture_output=True)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(full)} returned {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def cracksim(self, binary, scene, ranks, *settings):
        """summary.json of a run and its directory, which the next run replaces."""
        directory = self.path / "run"
        self.cracksim_says(binary, scene, ranks, "--out", directory, "--quiet", *settings)
        return json.loads((directory / "summary.json").read_text(encoding="utf-8")), directory

    def cracksim_says(self, binary, scene, ranks, *options):
        """The standard output of cracksim; scene: the path of a file, or the content of the file."""
        if isinstance(scene, dict):
            file = self.path / "scene.yaml"
            # JSON is valid YAML except for its infinity.
            file.write_text(json.dumps(scene).replace("Infinity", ".inf"), encoding="utf-8")
        else:
            file = scene
        return self.run(ranks, pathlib.Path(binary).resolve(), file, *options)


def step_milliseconds(summary):
    """The time of a step for physics and exchange, without topology and files."""
    seconds = summary["seconds"]
    return 1e3 * sum(seconds[phase] for phase in ("force", "update", "sense", "exchange")) / summary["time"]["steps"]


def alternate(subjects, rounds):
    """{name: values} of {name: function}. Each round calls all functions, so that other load affects them equally."""
    found = {name: [] for name in subjects}
    for _ in range(rounds):
        for name, subject in subjects.items():
            found[name].append(subject())
    return found


def ratio(above, below):
    """The ratio of two alternating measurements: that of the medians, with the extremes of the single pairs."""
    pairs = [a / b for a, b in zip(above, below)]
    return Spread(statistics.median(above) / statistics.median(below), min(pairs), max(pairs))


def on_ranks(count):
    return f"{count} rank{'s' if count > 1 else ''}"


def print_row(group, case, spread, unit, remark=""):
    """Prints a line of the table that table.py formats."""
    print(group, case, *(f"{value:.4g}" for value in spread), unit, remark, sep="\t", flush=True)
