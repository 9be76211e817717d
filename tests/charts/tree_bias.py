#!/usr/bin/env python3
"""Draws plane cracks with duplets `corners` (above) and `tree` (below), normal to x, y, z (from the left).

  python3 tests/charts/tree_bias.py OUT.png        # after jobs/build.sh release; needs xvfb, ParaView, ffmpeg

Cubes with a weak plane in the middle are pulled apart across it; the picture shows their crack faces.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CELLS, EDGE = 16, 0.01
LENGTH = CELLS * EDGE


def scene(axis, duplets):
    name = "xyz"[axis]
    low, high = [[-1, -1, -1], [1, 1, 1]], [[-1, -1, -1], [1, 1, 1]]
    low[1][axis], high[0][axis] = EDGE / 2, LENGTH - EDGE / 2
    along = lambda value: [value if i == axis else None for i in range(3)]
    return {"block": {"cells": [CELLS] * 3, "edge": EDGE},
            "material": {"model": "paper", "young": 2e4, "density": 1000, "damping": 0.4},
            "duplets": duplets,
            "sensors": {"threshold": f"abs({name} - {LENGTH / 2}) < {0.6 * EDGE} ? 0.03 : 0.3"},
            "initial": {"velocity": [v or 0 for v in along(f"2*({name} - {LENGTH / 2})")]},
            "supports": [{"name": "low", "where": {"box": low}, "velocity": along(-LENGTH)},
                         {"name": "high", "where": {"box": high}, "velocity": along(LENGTH)}],
            "time": {"end": 0.25},
            "output": {"rate": 0}}


def picture(folder, axis, duplets):
    """Runs one scene; returns a picture of its crack faces, and their area in units of the cross-section."""
    stem = folder / f"{duplets}_{'xyz'[axis]}"
    stem.with_suffix(".yaml").write_text(json.dumps(scene(axis, duplets)), encoding="utf-8")
    directory = stem.with_suffix(".out")
    subprocess.run([ROOT / "build/release/cracksim", stem.with_suffix(".yaml"), "--out", directory, "--quiet"],
                   check=True)
    subprocess.run(["xvfb-run", "-a", "pvpython", ROOT / "jobs/render.py", directory, "--view", "crack",
                    "--size", "640x560", "--from=0.8,0.9,0.6", "--title",
                    f"{duplets}, crack normal to {'xyz'[axis]}", "--out", stem.with_suffix(".png")],
                   check=True, stdout=subprocess.DEVNULL)
    area = json.loads((directory / "summary.json").read_text(encoding="utf-8"))["crack_area"] / LENGTH**2
    return stem.with_suffix(".png"), area


def main():
    with tempfile.TemporaryDirectory() as folder:
        inputs = []
        for duplets in ("corners", "tree"):
            for axis in range(3):
                file, area = picture(pathlib.Path(folder), axis, duplets)
                inputs += ["-i", file]
                print(f"{duplets}, crack normal to {'xyz'[axis]}: {area:.2f} cross-sections of crack")
        layout = "[0][1][2]hstack=3[above];[3][4][5]hstack=3[below];[above][below]vstack,scale=1200:-2"
        subprocess.run(["ffmpeg", "-nostdin", "-y", "-loglevel", "error", *inputs, "-filter_complex", layout,
                        sys.argv[1]], check=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
