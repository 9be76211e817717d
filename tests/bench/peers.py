"""Compares cracksim with LAMMPS on the same intact block: first the motion, then the time of a step.

Usage: peers.py CRACKSIM [--lammps PATH] [--pairs N] [--quick]
"""
import argparse
import sys

from lammps import Lammps, read_positions
from lattice import Lattice
from measure import (ROOT, STEP, Spread, Workplace, alternate, intact_scene, on_ranks, print_row, ratio,
                     step_milliseconds)

sys.path.insert(0, str(ROOT / "tests"))
from runs.runner import dataset, last_frame  # noqa: E402

CELLS = (70, 70, 10)
FARTHEST = 1e-9  # of an edge


def plain_scene(steps, **changes):
    """A scene that LAMMPS' harmonic bonds can represent: no damping, no breaking."""
    never = {"kind": "normal", "threshold": float("inf")}
    return intact_scene(CELLS, steps, damping=0, sensors=never, **changes)


def largest_difference(lattice, atoms, masses):
    """The largest difference over all masses, in edges; masses: x, y, z of each mass in the order of their ids."""
    farthest = 0.0
    places = iter(range(0, len(masses), 3))
    for corners in lattice.entity_atoms():
        for atom in corners:
            at = next(places)
            farthest = max(farthest, *(abs(a - b) for a, b in zip(atoms[atom], masses[at:at + 3])))
    return farthest / lattice.edge


def check_motion(workplace, cracksim, peer, steps):
    """Checks that both programs move all masses the same way; otherwise their times cannot be compared."""
    for ranks in (1, 2):
        dump = workplace.path / "positions.dump"
        peer.milliseconds(peer.harmonic(steps, positions=dump), ranks, steps)
        scene = plain_scene(steps, output={"rate": 0, "surface": False, "crack": False, "masses": True})
        _, directory = workplace.cracksim(cracksim, scene, ranks)
        atoms = read_positions(dump)
        difference = largest_difference(peer.lattice, atoms, dataset(last_frame(directory, "masses"), "/VTKHDF/Points"))
        moved = max(abs(a - b) for atom, place in zip(atoms[1:], peer.lattice.atoms())
                    for a, b in zip(atom, peer.lattice.position(place)))
        print_row("LAMMPS", f"difference of positions after {steps} steps, {on_ranks(ranks)}", [difference] * 3,
                  "edges", f"must be below {FARTHEST:g}; the farthest moved {moved / peer.lattice.edge:.2g}")
        if not difference < FARTHEST or not moved > 1e3 * FARTHEST * peer.lattice.edge:
            raise SystemExit("LAMMPS and cracksim do not compute the same motion")


def fastest_newton(peer, steps):
    """The faster setting of `newton` (Newton's third law across ranks) on this machine: on or off."""
    times = alternate({newton: lambda n=newton: peer.milliseconds(peer.harmonic(steps, n), 1, steps)
                       for newton in ("on", "off")}, 2)
    return min(times, key=lambda newton: min(times[newton]))


def compare(workplace, options, peer, ranks, peer_name, script, scenes):
    """Prints rows of LAMMPS, of cracksim on some scenes, and of the ratios of their times; all runs alternate."""
    subjects = {peer_name: lambda: peer.milliseconds(script, ranks, options.steps)}
    for name, scene in scenes.items():
        subjects[name] = lambda scene=scene: step_milliseconds(workplace.cracksim(options.cracksim, scene, ranks)[0])
    times = alternate(subjects, options.pairs)
    for name, values in times.items():
        print_row("LAMMPS", f"{name}, {on_ranks(ranks)}", Spread.of(values), "ms/step")
        if name != peer_name:
            print_row("LAMMPS", f"{name}, {on_ranks(ranks)}: ratio", ratio(times[peer_name], values), "times",
                      f"time of {peer_name} over this one")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cracksim")
    parser.add_argument("--lammps", default="lmp")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--quick", action="store_true", help="few steps, one pair: does it work?")
    options = parser.parse_args()
    options.steps = 100 if options.quick else 1000
    options.pairs = 1 if options.quick else options.pairs

    workplace = Workplace()
    peer = Lammps(workplace, options.lammps, Lattice(plain_scene(1)))
    check_motion(workplace, options.cracksim, peer, options.steps)
    print(f"{options.lammps}: LAMMPS {peer.version()}", file=sys.stderr)
    newton = fastest_newton(peer, options.steps)
    damped = {"cracksim, damped, sensing": intact_scene(CELLS, options.steps)}
    single = {"cracksim, damped, sensing, single": intact_scene(
        CELLS, options.steps, time={"end": STEP * options.steps, "step": STEP, "precision": "single"})}
    undamped = {"cracksim, undamped, unbreakable": plain_scene(options.steps)}
    for ranks in (1, 2):
        compare(workplace, options, peer, ranks, f"harmonic + nve, newton {newton}",
                peer.harmonic(options.steps, newton), undamped | damped | single)
    if not peer.has("bpm/spring"):
        print(f"{options.lammps} has no bpm/spring (the package BPM, since May 2022): no row of it", file=sys.stderr)
        return
    breakable = Lammps(workplace, options.lammps, Lattice(intact_scene(CELLS, 1)))
    for ranks in (1, 2):
        compare(workplace, options, breakable, ranks, "bpm/spring + nve", breakable.breakable(options.steps), damped)


if __name__ == "__main__":
    main()
