"""Measures whole runs of cracksim: time of a step by state and size, gain of ranks, memory, ratio to real time.

Usage: programs.py CRACKSIM [--against OTHER] [--pairs N] [--quick]
"""
import argparse
import pathlib
import re
import sys
from typing import Callable, NamedTuple

from measure import ROOT, Spread, Workplace, alternate, intact_scene, on_ranks, print_row, ratio, step_milliseconds

MILLION = (100, 100, 100)
TWENTY_MILLION = (200, 200, 500)
PAPER = (70, 70, 10)


def split_scene(cells, steps):
    """A block in uniform expansion; all its duplets trigger at the first step."""
    grow = "0.02*"
    return intact_scene(cells, steps, sensors={"kind": "normal", "threshold": 1e-9},
                        initial={"velocity": [f"{grow}x", f"{grow}y", f"{grow}z"]})


def in_single(scene):
    return {**scene, "time": {**scene["time"], "precision": "single"}}


def steady_milliseconds(summary):
    """The time of a step of a block that split at the first step: only `force`, which does not include that split."""
    return 1e3 * summary["seconds"]["force"] / summary["time"]["steps"]


class Case(NamedTuple):
    name: str
    scene: object  # in the form that Workplace.cracksim takes
    milliseconds: Callable = step_milliseconds
    rounds: int = 0  # 0: the number that the command line requests
    ranks: tuple = (1, 2)
    settings: tuple = ()  # further arguments of cracksim


def cases(quick):
    steps = {PAPER: 100, MILLION: 5, TWENTY_MILLION: 2} if quick else {PAPER: 2000, MILLION: 100, TWENTY_MILLION: 10}
    for cells, count in steps.items():
        few = {"rounds": 1, "ranks": (2,)} if cells == TWENTY_MILLION else {}
        if not (quick and few):
            yield Case("intact", intact_scene(cells, count), **few)
            yield Case("intact, single", in_single(intact_scene(cells, count)), **few)
            yield Case("fully split", split_scene(cells, max(2, count // 4)), steady_milliseconds, **few)
            yield Case("fully split, single", in_single(split_scene(cells, max(2, count // 4))),
                       steady_milliseconds, **few)


def phases(seconds):
    """The phases that took a hundredth of a run's time or more, as text."""
    rest = {name: spent for name, spent in seconds.items() if name != "total"}
    return "in s: " + ", ".join(f"{name} {spent:.2f}" for name, spent in rest.items()
                                if spent >= 0.01 * seconds["total"])


def entities_of(scene):
    x, y, z = scene["block"]["cells"]
    return x * y * z


def available_gigabytes():
    for line in pathlib.Path("/proc/meminfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("MemAvailable:"):
            return 1024e-9 * int(line.split()[1])
    return 0.0


class Measurements:
    def __init__(self, options):
        self.options = options
        self.workplace = Workplace()

    def run(self, binary, case, ranks, summaries):
        summary, _ = self.workplace.cracksim(binary, case.scene, ranks, *case.settings)
        summaries[ranks] = summary
        return case.milliseconds(summary)

    def times(self, case, summaries):
        """Milliseconds of a step by number of ranks; those of the other binary under "other"."""
        own = self.options.cracksim
        subjects = {ranks: lambda r=ranks: self.run(own, case, r, summaries) for ranks in case.ranks}
        if self.options.against:
            subjects["other"] = lambda: self.run(self.options.against, case, case.ranks[0], {})
        return alternate(subjects, case.rounds or self.options.pairs)

    def print_times(self, group, case, times, summaries):
        """summaries: the last summary by number of ranks."""
        for ranks in case.ranks:
            entities = summaries[ranks]["counts"]["entities"]
            each = 1e6 * Spread.of(times[ranks]).median / entities
            print_row(group, f"{case.name}, {on_ranks(ranks)}", Spread.of(times[ranks]), "ms/step",
                      f"{each:.3g} ns/entity")
        if len(case.ranks) == 2:
            print_row(group, f"{case.name}, gain of 2 ranks", ratio(times[1], times[2]), "times")
        if self.options.against:
            print_row(group, f"{case.name}, {on_ranks(case.ranks[0])}, gain over {self.options.against}",
                      ratio(times["other"], times[case.ranks[0]]), "times")

    def fits(self, case):
        """True if memory suffices, by the forecast of --dry-run for an intact and for a fully split block."""
        ranks = case.ranks[-1]
        forecast = self.workplace.cracksim_says(self.options.cracksim, case.scene, ranks, "--dry-run")
        ends = re.search(r"memory of a rank.*?([\d.]+) (kB|MB|GB) if nothing breaks, ([\d.]+) (kB|MB|GB) if all",
                         forecast).groups()
        number, unit = ends[2:] if case.milliseconds is steady_milliseconds else ends[:2]
        needed = 1.1 * ranks * float(number) * {"kB": 1e-6, "MB": 1e-3, "GB": 1.0}[unit]
        if needed > available_gigabytes():
            print(f"{case.name}, {entities_of(case.scene)} entities: needs {needed:.1f} GB, "
                  f"{available_gigabytes():.1f} GB are free: not measured", file=sys.stderr)
        return needed <= available_gigabytes()

    def measure(self, case):
        if not self.fits(case):
            return
        summaries = {}
        times = self.times(case, summaries)
        entities = entities_of(case.scene)
        group = f"program, {entities} entities"
        self.print_times(group, case, times, summaries)
        ranks = case.ranks[-1]
        memory = summaries[ranks]["memory"]
        whole = memory["per_rank_max"] * ranks / entities
        print_row(group, f"{case.name}, memory on {on_ranks(ranks)}", [whole] * 3, "bytes/entity",
                  f"with the program; the model takes {memory['per_entity']:.0f}, "
                  f"the map {memory['map_per_entity']:.0f}")
        seconds = summaries[ranks]["seconds"]
        print_row(group, f"{case.name}, set-up on {on_ranks(ranks)}", [seconds["setup"]] * 3, "s")
        if case.milliseconds is steady_milliseconds:
            print_row(group, f"{case.name}, the split itself on {on_ranks(ranks)}", [seconds["update"]] * 3, "s")

    def measure_block(self, name, *settings):
        """Measures inputs/block.yaml, which cracks, with coat and files at 50 Hz.

        The same runs give the times of the physics and of the whole.
        """
        factors = {1: [], 2: []}

        def milliseconds(summary):
            factors[summary["provenance"]["ranks"]].append(summary["times_real_time"])
            return step_milliseconds(summary)

        case = Case(f"physics{name}", ROOT / "inputs" / "block.yaml", milliseconds, settings=settings)
        summaries = {}
        times = self.times(case, summaries)
        group = "program, inputs/block.yaml"
        self.print_times(group, case, times, summaries)
        own = {ranks: values[::2] if self.options.against and ranks == 1 else values
               for ranks, values in factors.items()}
        for ranks, values in own.items():
            print_row(group, f"all{name}, coat and files at 50 Hz, {on_ranks(ranks)}", Spread.of(values),
                      "times real time", phases(summaries[ranks]["seconds"]))
        print_row(group, f"all{name}, gain of 2 ranks", ratio(own[2], own[1]), "times")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cracksim")
    parser.add_argument("--against", help="another build of cracksim, which takes turns")
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--quick", action="store_true", help="few steps, one pair, no 20 million: does it work?")
    options = parser.parse_args()
    options.pairs = 1 if options.quick else options.pairs
    measurements = Measurements(options)
    measurements.measure_block("")
    measurements.measure_block(", single", "--set", "time.precision=single")
    for case in cases(options.quick):
        measurements.measure(case)


if __name__ == "__main__":
    main()
