#!/usr/bin/env python3
"""ParaView reads every frame of a run with all outputs; read_frames.py, in pvpython, compares with summary.json."""
import os
import pathlib
import shutil
import subprocess
import sys

from runner import check, cracking_scene, main

SKIPPED = 77


def read_frames(directory):
    script = pathlib.Path(__file__).with_name("read_frames.py")
    done = subprocess.run(["pvpython", str(script), str(directory)], text=True, capture_output=True, check=False,
                          timeout=300)
    check(done.returncode == 0, f"read_frames.py returned {done.returncode}\n{done.stdout}{done.stderr}")


def paraview_reads_every_frame(workplace, quick):
    del quick
    directory = workplace.finished(
        cracking_scene(output={"rate": 100, "surface": True, "crack": True, "masses": True, "topology": True}), ranks=2)
    read_frames(directory)


def paraview_reads_frames_of_any_ranks(workplace, quick):
    """CRACKSIM_WRITE_FRAMES writes frames whose cells are distributed unevenly, also over ranks without any cells."""
    writer = os.environ.get("CRACKSIM_WRITE_FRAMES")
    if not writer:
        print("no CRACKSIM_WRITE_FRAMES to write frames with", flush=True)
        return
    for ranks in (3,) if quick else (1, 2, 4):
        directory = workplace.path / f"frames-{ranks}"
        done = workplace.run(directory, ranks=ranks, binary=writer)
        check(done.returncode == 0, f"{writer} returned {done.returncode}\n{done.stdout}{done.stderr}")
        read_frames(directory)


if __name__ == "__main__":
    if not shutil.which("pvpython"):
        print("pvpython is not installed")
        sys.exit(SKIPPED)
    main([paraview_reads_every_frame, paraview_reads_frames_of_any_ranks])
