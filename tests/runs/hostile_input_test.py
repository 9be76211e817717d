#!/usr/bin/env python3
"""Wrong scenes and command lines: one exact message, from one rank; exit code 2; no files written.

The tables are hostile_scenes.py, hostile_values.py, hostile_texts.py and hostile_commands.py.
hostile_input_test.py CRACKSIM --show prints the current messages.
"""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from hostile_commands import COMMANDS, FOR_ONE_RANK, PREPARED
from hostile_scenes import FORM, SCENE, scene_with
from hostile_texts import TEXTS
from hostile_values import MEANING
from runner import ENVIRONMENT, check, main

LIMIT = 60  # s; a refusal takes a fraction of a second


def rows():
    """Yields the name, the files to write, the arguments and the message of every row."""
    right = {"scene.yaml": SCENE.encode()}
    for row in FORM + MEANING:
        yield row.name, {"scene.yaml": scene_with(row).encode()}, ["scene.yaml"], "scene.yaml" + row.message
    for name, text, message in TEXTS:
        yield name, {"scene.yaml": text}, ["scene.yaml"], "scene.yaml" + message
    for name, arguments, message in COMMANDS:
        yield name, right, arguments, message


def run_in(folder, command, ranks=None):
    """The finished process and its output; ranks=None: without mpirun."""
    with tempfile.TemporaryDirectory(prefix="cracksim-mpi-") as sessions:
        os.chmod(sessions, 0o1777)
        # A single rank needs no daemon; but without its own folder, parallel runs would all create Open MPI's same
        # folder.
        alone = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_orte_tmpdir_base": sessions}
        start, environment = (["mpirun", "-n", str(ranks)], {}) if ranks else ([], alone)
        done = subprocess.run([*start, *command], cwd=folder, env={**os.environ, **ENVIRONMENT, **environment},
                              check=False, stdin=subprocess.DEVNULL, capture_output=True, timeout=LIMIT)
    return done, (done.stdout + done.stderr).decode("utf-8", "backslashreplace")


def contents(folder):
    """Every path below a folder with a value that changes if it changes: the bytes of files, the times of all else."""
    return {path: path.read_bytes() if path.is_file() else path.lstat().st_mtime_ns
            for path in [folder, *sorted(folder.rglob("*"))]}


def run_row(binary, row, ranks=None):
    """The exit code, the output, the expected message, and whether the folder was left unchanged."""
    _, files, arguments, message = row
    with tempfile.TemporaryDirectory(prefix="cracksim-") as name:
        folder = pathlib.Path(name)
        for file, text in files.items():
            (folder / file).write_bytes(text)
        for made, make in PREPARED.items():
            make(folder / made)
        before = contents(folder)
        done, said = run_in(folder, [binary, *arguments], ranks)
        return done.returncode, said, f"cracksim: {message.replace('{here}', name)}\n", contents(folder) == before


def faults(binary, row, ranks=None):
    """The differences from how a row must be refused; empty if there are none. mpirun adds lines of its own."""
    try:
        code, said, expected, untouched = run_row(binary, row, ranks)
    except subprocess.TimeoutExpired:
        return [f"{row[0]}: no answer within {LIMIT} s"]
    once = said.count(expected) == 1 and said.count("cracksim: ") == 1
    found = [] if code == 2 else [f"the exit code is {code}"]
    found += [] if untouched else ["files were written"]
    found += [] if once and (ranks or said == expected) else [f"expected\n  {expected}found\n  {said[:3000]}"]
    return [f"{row[0]}: {'; '.join(found)}"] if found else []


def refuse_all(binary, chosen, ranks=None):
    with concurrent.futures.ThreadPoolExecutor(1 if ranks else 6) as pool:
        found = sum(pool.map(lambda row: faults(binary, row, ranks), chosen), [])
    check(not found, "\n".join(found))


def chosen_rows(quick, step):
    """Every `step`-th row; with sanitizers, which watch each allocation, no row that allocates millions."""
    large = 100_000  # bytes
    light = [row for row in rows() if not quick or max(map(len, row[1].values())) < large]
    return light[::step]


def every_row_is_refused(workplace, quick):
    refuse_all(workplace.binary, chosen_rows(quick, 3 if quick else 1))


def one_rank_of_three_speaks(workplace, quick):
    chosen = [row for row in chosen_rows(quick, 40 if quick else 15) if row[0] not in FOR_ONE_RANK]
    refuse_all(workplace.binary, chosen, ranks=3)


def told_once(folder, command, ranks, *words):
    """Checks a failure that is not the input's fault: exit code 1, one message, no unfinished files."""
    done, said = run_in(folder, command, ranks)
    messages = [line for line in said.splitlines() if line.startswith("cracksim: ")]
    check(done.returncode == 1, f"the exit code is {done.returncode}, not 1\n{said}")
    check(len(messages) == 1, f"expected one message:\n{said}")
    check(all(word in messages[0] for word in words), f"expected {words} in the message:\n{said}")
    check(not list(folder.rglob("*.tmp")), "unfinished files were left")


def full_disk_is_told_once(workplace, quick):
    del quick
    disk = workplace.path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=8k", "tmpfs", disk]
    if subprocess.run(mount, check=False, capture_output=True).returncode:
        print("skipped full_disk_is_told_once: a small disk cannot be mounted here", flush=True)
        return
    try:
        told_once(workplace.path, [workplace.binary, workplace.write(SCENE), "--out", disk / "run", "--quiet"], 3,
                  "disk/run", "No space left on device (the disk is full: make room, or name a directory on another")
    finally:
        subprocess.run(["umount", disk], check=True)


def file_size_limit_is_told_once(workplace, quick):
    del quick
    told_once(workplace.path, ["prlimit", "--fsize=100", workplace.binary, workplace.write(SCENE)], 2,
              "cannot write scene.out/.cracksim.tmp: File too large")


def what_a_user_may_not_touch_is_refused(workplace, quick):
    """Runs as another user, because root may access everything."""
    del quick
    nobody = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
    if os.geteuid() != 0 or not shutil.which("setpriv") or subprocess.run(
            [*nobody, "test", "-x", workplace.binary], check=False).returncode:
        print("skipped what_a_user_may_not_touch_is_refused: no other user may run cracksim here", flush=True)
        return
    workplace.path.chmod(0o755)
    workplace.write(SCENE)
    workplace.write(SCENE, "secret.yaml").chmod(0o600)
    advice = "name a scene's file, such as inputs/block.yaml"
    other = "name another directory with --out"
    for name, message in [
            ("secret.yaml", f"secret.yaml: cannot be opened: Permission denied; {advice}"),
            ("scene.yaml", f"cannot write to scene.out: nothing can be created in {workplace.path}; {other}")]:
        done, said = run_in(workplace.path, [*nobody, workplace.binary, name])
        check(done.returncode == 2 and said == f"cracksim: {message}\n", f"{name}: {done.returncode}\n{said}")


def show(binary):
    for row in rows():
        code, said, _, untouched = run_row(binary, row)
        print(f"{row[0]}\n    {code} {'' if untouched else 'WRITTEN '}{said[:1500]}", flush=True)


if __name__ == "__main__":
    if "--show" in sys.argv:
        show(str(pathlib.Path(sys.argv[1]).resolve()))
    else:
        main([every_row_is_refused, one_rank_of_three_speaks, full_disk_is_told_once, file_size_limit_is_told_once,
              what_a_user_may_not_touch_is_refused])
