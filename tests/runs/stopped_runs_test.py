#!/usr/bin/env python3
"""Runs that an outside event ends or disturbs: a full disk, a signal, a terminal that cannot be written."""
import contextlib
import os
import re
import shlex
import signal
import subprocess
import time

from runner import ENVIRONMENT, check, cracking_scene, main, summary

LARGE = cracking_scene(output={"rate": 400, "masses": True})  # 6 MB or more
# 8 MB, all written by the worker thread
FREQUENT = cracking_scene(output={"rate": 2000, "surface": True, "crack": True})
LONG = cracking_scene(time={"end": 1000})


@contextlib.contextmanager
def small_disk(workplace, size):
    """A folder on a disk of `size` bytes; None where disks cannot be mounted."""
    disk = workplace.path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", disk]
    if subprocess.run(mount, check=False, capture_output=True).returncode:
        yield None
        return
    try:
        yield disk
    finally:
        subprocess.run(["umount", disk], check=True)


def check_stopped(directory, *words):
    found = summary(directory)
    check(found["status"] == "stopped", f"the status is {found['status']}, not stopped")
    for word in words:
        check(word in found["error"], f"'{word}' is not in the error '{found['error']}'")
    check(not list(directory.rglob("*.tmp")), "unfinished files were left")
    return found


def frames_listed_are_there(directory, found):
    for series, frames in found["frames"].items():
        for frame in frames:
            check((directory / frame["file"]).stat().st_size > 0, f"{frame['file']} of {series} is not there")


def full_disk_leaves_a_summary_that_says_so(workplace, quick):
    for scene, ranks in (((LARGE, 2), (FREQUENT, 2)) if quick else
                         ((LARGE, 1), (LARGE, 3), (FREQUENT, 1), (FREQUENT, 3))):
        with small_disk(workplace, "2m") as disk:
            if not disk:
                print("skipped full_disk_leaves_a_summary_that_says_so: a small disk cannot be mounted here",
                      flush=True)
                return
            done = workplace.run(workplace.write(scene), "--out", disk / "run", ranks=ranks)
            check(done.returncode == 1, f"the exit code is {done.returncode}, not 1\n{done.stdout}{done.stderr}")
            said = [line for line in done.stderr.splitlines() if "No space left on device" in line]
            check(len(said) == 1, f"the full disk is told {len(said)} times:\n{done.stderr}")
            frames_listed_are_there(disk / "run", check_stopped(disk / "run", "the disk is full"))
        (workplace.path / "disk").rmdir()


def frame_that_cannot_be_written_ends_the_run(workplace, quick):
    """A frame that cannot be written ends the run soon, even the last one. A folder has the second frame's name."""
    for rate, ranks in ((2000, 2), (0, 1)) if quick else ((2000, 1), (2000, 3), (0, 1), (0, 3)):
        scene = cracking_scene(output={"rate": rate, "surface": True, "crack": True})
        directory = workplace.finished(scene, ranks=ranks)
        obstacle = directory / "frames/surface-000001.hdf"
        obstacle.unlink()
        obstacle.mkdir()
        done = workplace.run(workplace.write(scene), "--out", directory, ranks=ranks)
        check(done.returncode == 1, f"the exit code is {done.returncode}, not 1\n{done.stdout}{done.stderr}")
        found = check_stopped(directory, "surface-000001.hdf")
        check(len(found["frames"]["surface"]) == 1, f"frames are listed that are not there: {found['frames']}")
        last = float((directory / "history.csv").read_text(encoding="utf-8").splitlines()[-1].split(",")[1])
        check(rate == 0 or last < 0.03, f"the run went on until {last} s")


def summary_of_an_old_run_is_never_left_to_one_that_failed(workplace, quick):
    del quick
    with small_disk(workplace, "2m") as disk:
        if not disk:
            print("skipped summary_of_an_old_run_...: a small disk cannot be mounted here", flush=True)
            return
        directory = disk / "run"
        done = workplace.run(workplace.write(cracking_scene(time={"end": 0.001})), "--out", directory)
        check(done.returncode == 0 and summary(directory)["status"] == "finished", f"no old run:\n{done.stderr}")
        with contextlib.suppress(OSError), open(disk / "filler", "wb", buffering=0) as filler:
            while filler.write(bytes(4096)):
                pass
        done = workplace.run(workplace.write(LARGE), "--out", directory)
        check(done.returncode == 1, f"the exit code is {done.returncode}, not 1\n{done.stdout}{done.stderr}")
        if (directory / "summary.json").exists():
            check_stopped(directory)


def process_of_a_rank(mpirun):
    """The process id of one of mpirun's ranks."""
    with open(f"/proc/{mpirun.pid}/task/{mpirun.pid}/children", encoding="ascii") as children:
        return int(children.read().split()[-1])


def stop(workplace, ranks, choose):
    """Starts a long run, sends SIGTERM to the process that choose(mpirun) returns, and waits until mpirun has ended."""
    directory = workplace.path / f"stopped-{ranks}"
    command = ["mpirun", "-n", str(ranks), workplace.binary, workplace.write(LONG), "--out", directory]
    with subprocess.Popen(command, env={**os.environ, **ENVIRONMENT}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True) as run:
        for _ in range(600):
            history = directory / "history.csv"
            if history.exists() and history.read_text(encoding="utf-8").count("\n") > 2:
                break
            time.sleep(0.1)
        os.kill(choose(run), signal.SIGTERM)
        said, _ = run.communicate(timeout=60)
    return run.returncode, said, directory


def sigterm_stops_all_ranks_with_a_summary(workplace, quick):
    for ranks, choose in ((2, process_of_a_rank), (1, lambda run: run.pid))[:1 if quick else 2]:
        code, said, directory = stop(workplace, ranks, choose)
        check(code == 1, f"the exit code is {code}, not 1\n{said}")
        check(said.count("error: stopped at step") == 1, f"the end is not told once:\n{said}")
        found = check_stopped(directory, "stopped at step", "SIGTERM")
        check(0 < found["time"]["steps"] and found["time"]["end"] < 1000, f"the times are {found['time']}")
        frames_listed_are_there(directory, found)
        last = (directory / "cracksim.log").read_text(encoding="utf-8").splitlines()[-1]
        check(re.search(r" error: stopped at step \d+ of \d+ ", last), f"the log ends with\n{last}")


def told_to(terminal, workplace, *arguments):
    """The exit code and standard error of cracksim without mpirun, which would handle the terminal itself."""
    with open(terminal, "w", encoding="utf-8") as out:
        done = subprocess.run([workplace.binary, *map(str, arguments)], cwd=workplace.path,
                              env={**os.environ, **ENVIRONMENT}, check=False, stdout=out, stderr=subprocess.PIPE,
                              text=True, timeout=600)
    return done.returncode, done.stderr


def terminal_that_takes_nothing_is_told_once_and_is_no_success(workplace, quick):
    del quick
    scene = workplace.write(cracking_scene())
    message = "error: standard output cannot be written: No space left on device"
    for arguments in (["--help"], ["--version"], [scene, "--dry-run"]):
        code, problems = told_to("/dev/full", workplace, *arguments)
        check((code, problems) == (1, message + "\n"), f"{arguments}: {code}\n{problems}")
    for progress in ("plain", "live"):
        code, problems = told_to("/dev/full", workplace, scene, "--out", "run", "--progress", progress)
        log = "; the run goes on, and its lines are in its cracksim.log\n"
        check((code, problems) == (1, message + log), f"a run with {progress} progress: {code}\n{problems}")
        check(summary(workplace.path / "run")["status"] == "finished", "the run did not go on")
        lines = (workplace.path / "run/cracksim.log").read_text(encoding="utf-8")
        check(" info: results in run" in lines, f"the log is not whole:\n{lines}")
    code, problems = told_to("/dev/full", workplace, scene, "--out", "run", "--quiet")
    check((code, problems) == (0, ""), f"a quiet run has nothing to write there: {code}\n{problems}")


def closed_terminals_end_in_the_same_way(workplace, quick):
    del quick
    scene = workplace.write(cracking_scene())
    command = f"{shlex.quote(str(workplace.binary))} {shlex.quote(str(scene))} --out run --progress plain"
    def shell(line):
        return subprocess.run(["bash", "-c", line], cwd=workplace.path, env={**os.environ, **ENVIRONMENT}, check=False,
                              timeout=600).returncode

    for terminal in (">&-", ">&- 2>&-", "<&- >&- 2>&-"):
        code = shell(f"exec {command} {terminal}")
        check(code == 1, f"{terminal}: {code}")
        check(summary(workplace.path / "run")["status"] == "finished", f"{terminal}: the run did not go on")
    code = shell(f"set -o pipefail; {command} 2>problems | true")
    problems = (workplace.path / "problems").read_text(encoding="utf-8")
    check(code == 1 and "standard output cannot be written" in problems, f"{code}\n{problems}")
    check(summary(workplace.path / "run")["status"] == "finished", "the run did not go on without a reader")


if __name__ == "__main__":
    main([full_disk_leaves_a_summary_that_says_so, frame_that_cannot_be_written_ends_the_run,
          summary_of_an_old_run_is_never_left_to_one_that_failed, sigterm_stops_all_ranks_with_a_summary,
          terminal_that_takes_nothing_is_told_once_and_is_no_success, closed_terminals_end_in_the_same_way])
