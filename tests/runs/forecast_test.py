#!/usr/bin/env python3
"""Compares the forecast of --dry-run, and of the run before its first step, with the run's actual needs."""
import re
import time

from runner import ROOT, check, main, summary

BLOCK = (ROOT / "inputs" / "block.yaml").read_text(encoding="utf-8")
SMALL = ["--set", "block.cells=[20, 20, 5]", "--set", "time.end=0.1"]
INTACT = ["--set", "sensors.threshold=.inf"]
# The block is stretched along every axis from the first step on, so that every duplet triggers.
BROKEN = ["--set", "sensors={threshold: 1.0e-9}", "--set", "initial.velocity=[x, y, z]"]


EMPTY_FRAME = 65536  # bytes reserved for a frame's headers


def output_bytes(directory):
    return sum(path.stat().st_size for path in directory.rglob("*") if path.is_file())


def check_near(what, forecast, measured):
    check(abs(forecast - measured) <= 0.15 * measured, f"{what}: forecast {forecast}, measured {measured}")


def check_run(workplace, quick, end, *arguments, ranks):
    """Runs block.yaml with changes; every forecast for one end of the range must hold within 15 %.

    A quick run does not check memory: sanitizers need much memory themselves.
    """
    directory = workplace.finished(BLOCK, *arguments, ranks=ranks)
    found = summary(directory)
    forecast = found["forecast"]
    what = f"{end} on {ranks} ranks, {' '.join(arguments)}"
    if not quick:
        check_near(f"memory, {what}", forecast[f"memory_{end}"], found["memory"]["per_rank_max"])
    check_near(f"output, {what}", forecast[f"output_{end}"], output_bytes(directory))
    check(0 <= found["exchange"]["waiting"] <= found["seconds"]["exchange"],
          f"waiting, {what}: not a part of the exchange")
    said, sent = forecast[f"exchange_{end}"], found["exchange"]["bytes_per_step"]
    if end == "intact":
        check(said == sent, f"exchange, {what}: not exact")
    else:
        check_near(f"exchange, {what}", said, sent)
    return found


def holds_if_nothing_breaks(workplace, quick):
    for ranks in (1, 2) if quick else (1, 2, 4):
        found = check_run(workplace, quick, "intact", *SMALL, *INTACT, ranks=ranks)
        check(found["events"]["duplets"] == 0, "something broke")


def memory_of_the_smallest_blocks_lies_in_its_range(workplace, quick):
    """The memory of the smallest blocks is that of libraries, which depends on the machine; the range must cover it."""
    for ranks in () if quick else (1, 2, 4):
        for cells in ("[1, 1, 1]", "[4, 4, 2]", "[8, 7, 4]"):
            for end in (INTACT, BROKEN):
                arguments = ["--set", f"block.cells={cells}", "--set", "time.end=0.1", *end]
                found = summary(workplace.finished(BLOCK, *arguments, ranks=ranks))
                low, high = (found["forecast"][f"memory_{name}"] for name in ("intact", "broken"))
                measured = found["memory"]["per_rank_max"]
                check(low - 5e5 < measured <= high, f"{cells} on {ranks} ranks: {measured} is not in {low} to {high}")


def memory_grows_with_the_block_as_was_said(workplace, quick):
    """Half of a small run's memory is that of libraries, so the memory of the block itself is checked separately."""
    for ranks in () if quick else (1, 2):
        whole, grain = (check_run(workplace, quick, "intact", "--set", "time.end=0.05", *INTACT, *cells, ranks=ranks)
                        for cells in ([], ["--set", f"block.cells=[{ranks}, 1, 1]"]))
        check_near(f"memory of the block itself on {ranks} ranks",
                   whole["forecast"]["memory_intact"] - grain["forecast"]["memory_intact"],
                   whole["memory"]["per_rank_max"] - grain["memory"]["per_rank_max"])


def holds_if_all_of_it_breaks(workplace, quick):
    for ranks in (1,) if quick else (1, 2):
        found = check_run(workplace, quick, "broken", *SMALL, *BROKEN, ranks=ranks)
        check(found["events"]["duplets"] == found["counts"]["duplets"], "not all of it broke")


def cracking_run_lies_between(workplace, quick):
    directory = workplace.finished(BLOCK, *SMALL, "--set", "initial.velocity=[9*x, 9*y, 0]", ranks=2)
    found = summary(directory)
    forecast = found["forecast"]
    check(0 < found["events"]["duplets"] < found["counts"]["duplets"], "the scene is no example of cracks")
    check(forecast["output_intact"] < output_bytes(directory) < forecast["output_broken"], "output is not between")
    measured = found["memory"]["per_rank_max"]
    check(quick or 0.85 * forecast["memory_intact"] < measured < 1.15 * forecast["memory_broken"],
          "memory is not between")


def interfaces_that_open_add_what_was_said(workplace, quick):
    """Frames of a growing crack grow by the forecast number of bytes for each interior face that opened."""
    del quick
    # Two halves separate where x = 0.1 m; elsewhere nothing breaks.
    weak = ["--set", "sensors={threshold: 'abs(x - 0.1) < 1e-6 ? 0.01 : 1e9'}",
            "--set", "initial.velocity=['x > 0.1 ? 1 : -1', 0, 0]", "--set", "time.end=0.004"]
    directory = workplace.finished(BLOCK, *SMALL, *weak, ranks=1)
    found = summary(directory)
    opened = round(found["crack_area"] / 1e-4)
    check(opened == 20 * 5 and found["fragments"] == 2, f"{opened} interfaces opened, not those of a plane")
    size = {path.name: path.stat().st_size for path in (directory / "frames").iterdir()}
    added = size["surface-000001.hdf"] - size["surface-000000.hdf"] + size["crack-000000.hdf"] - EMPTY_FRAME
    check_near("a frame's growth", found["forecast"]["output_per_interface"] * opened, added)


def dry_run_says_what_the_run_says(workplace, quick):
    del quick
    scene = workplace.write(BLOCK)
    arguments = [scene, *SMALL, "--set", "time.end=0.01", "--out", workplace.path / "said"]
    dry = workplace.run(*arguments, "--dry-run", ranks=2)
    check(dry.returncode == 0, f"--dry-run returned {dry.returncode}\n{dry.stdout}{dry.stderr}")
    run = workplace.run(*arguments, ranks=2)
    for line in dry.stdout.splitlines():
        if line.startswith("output:") or "entities" in line or "exchange" in line:
            check(line in run.stdout, f"the run does not begin with the line of --dry-run:\n{line}\n{run.stdout}")
    check(len(dry.stdout.splitlines()) >= 5, f"--dry-run says little:\n{dry.stdout}")


def huge_block_is_forecast_at_once_and_with_a_warning(workplace, quick):
    scene = workplace.write(BLOCK)
    start = time.monotonic()
    done = workplace.run(scene, "--dry-run", "--set", "block.cells=[1000, 1000, 1000]", "--set", "partition.kind=slab",
                         ranks=16)
    check(done.returncode == 0, f"--dry-run returned {done.returncode}\n{done.stdout}{done.stderr}")
    check(quick or time.monotonic() - start < 60, f"it took {time.monotonic() - start:.0f} s")
    check("1,000,000,000 entities" in done.stdout, done.stdout)
    check(re.search(r"about [0-9.]+ GB", done.stdout), f"no memory is said:\n{done.stdout}")
    with open("/proc/meminfo", encoding="ascii") as lines:
        total = 1024 * int(re.search(r"MemTotal: +(\d+)", lines.read()).group(1))
    if total < 5e11:
        check("use ranks on more machines" in done.stderr, f"no warning of too little memory:\n{done.stderr}")


main([holds_if_nothing_breaks, memory_of_the_smallest_blocks_lies_in_its_range, memory_grows_with_the_block_as_was_said,
      holds_if_all_of_it_breaks, cracking_run_lies_between, interfaces_that_open_add_what_was_said,
      dry_run_says_what_the_run_says, huge_block_is_forecast_at_once_and_with_a_warning])
