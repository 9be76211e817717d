#!/usr/bin/env python3
"""Notches: bodies that are parted, or cracked, from the start, on any number of ranks."""
from runner import check, dataset, frame_cells, last_frame, main, summary

RANKS = (1, 2, 3, 4)


def rectangle(corner, along, across):
    return {"where": {"rectangle": {"corner": corner, "along": along, "and": across}}}


def plate(cells, speed="0.02*min(t/0.02,1)", **changes):
    """A plate of cubes of 1 cm that a support at either end pulls apart along y."""
    nx, ny, nz = cells
    height = 0.01 * ny
    everywhere = [-1, 1]

    def grip(name, low, high, velocity):
        box = [[everywhere[0], low, everywhere[0]], [everywhere[1], high, everywhere[1]]]
        return {"name": name, "where": {"box": box}, "velocity": [None, velocity, None]}

    scene = {
        "block": {"cells": [nx, ny, nz], "edge": 0.01},
        "material": {"model": "paper", "young": 1e5, "density": 1000, "damping": 0.5},
        "sensors": {"threshold": 0.01},
        "supports": [grip("bottom", -1, 0.001, f"-{speed}"), grip("top", height - 0.001, 1, speed)],
        "time": {"end": 0.1},
        "coat": {"rate": 1000},
        "history": {"rate": 100},
        "output": {"rate": 0},
    }
    scene.update(changes)
    return {key: value for key, value in scene.items() if value is not None}


def hashes(directory):
    result = summary(directory)
    return result["event_hash"], result["state_hash"]


def a_cut_leaves_two_fragments_and_no_crack_area(workplace, quick):
    scene = plate([10, 10, 1], notches=[rectangle([-1, 0.05, -1], [2, 0, 0], [0, 0, 2])], time={"end": 0.002},
                  sensors={"threshold": 0.01}, supports=None,
                  initial={"velocity": [0, "y > 0.05 ? 0.1 : -0.1", 0]})
    for ranks in RANKS[:2] if quick else RANKS:
        directory = workplace.finished(scene, "--audit", ranks=ranks)
        found = summary(directory)
        for name, expected in (("fragments", 2), ("components", 2), ("crack_area", 0)):
            check(found[name] == expected, f"{name} is {found[name]} on {ranks} ranks, not {expected}")
        check(found["events"] == {"duplets": 0, "splits": 0}, f"a notch made events: {found['events']}")
        check(found["counts"]["notched_faces"] == 10, f"{found['counts']['notched_faces']} faces are open, not 10")
        check(found["counts"]["duplets"] == 4 * (found["counts"]["interior_faces"] - 10),
              "duplets are left in the notch")
        check(found["counts"]["unions"] == 11 * 11 * 2 + 11 * 2, f"{found['counts']['unions']} unions at the start")
        _, cells = frame_cells(last_frame(directory, "crack"))
        check(len(cells) == 20, f"{len(cells)} crack faces, not the 20 of a cut")
        for _, _, opened_at, opening, *corners in cells:
            check(opened_at == 0, f"a notch face opened at {opened_at} s")
            check(opening > 1e-5, f"the parts do not separate: opening {opening} m")
            check(all(abs(y - 0.05) < 1e-3 for _, y, _ in corners), "a face beside the cut is open")


def thresholds_open_faces_beside_the_cut(workplace, quick):
    """The reason for notches: the same plate, cut by thresholds."""
    del quick
    scene = plate([10, 10, 1], sensors={"threshold": "abs(y-0.05) < 1e-4 ? 1e-9 : 10"}, time={"end": 0.05})
    found = summary(workplace.finished(scene))
    check(found["fragments"] == 2, "the thresholds do not cut the plate")
    check(found["crack_area"] > 1.5 * 0.001,
          f"crack area {found['crack_area']} m2: thresholds have become exact; say so")


def displacement(time):
    """Of both grips: the velocity is 0.04 m/s after a ramp of 0.02 s."""
    return 0.04 * (time - 0.01) if time > 0.02 else time * time


def first_event(directory, cells, is_expected):
    """The time of the first event at a vertex, given in edges along x and y, where it is expected."""
    nx, ny, _ = cells
    offsets = [(0, 0), (1, 0), (1, 1), (0, 1)] * 2
    for time, mass in zip(*(dataset(directory / "events.hdf", f"/events/{name}") for name in ("time", "mass_a"))):
        entity, corner = divmod(mass, 8)
        x, y = entity % nx + offsets[corner][0], entity // nx % ny + offsets[corner][1]
        if is_expected(x, y):
            return time
    return None


def a_crack_starts_as_from_faces_opened_by_thresholds(workplace, quick):
    """The unions inside the notch are parted either way, and so are the faces between them."""
    cells = [24, 24, 2]
    notched = plate(cells, notches=[rectangle([0.08, 0.12, -1], [0.08, 0, 0], [0, 0, 2])])
    inside = "abs(y-0.12) < 1e-4 && x > 0.081 && x < 0.159"
    weak = plate(cells, sensors={"threshold": f"{inside} ? 1e-12 : 0.01"})
    found = []
    for scene in (notched, weak):
        directory = workplace.finished(scene, ranks=2)
        time = first_event(directory, cells, lambda x, y: not (y == 12 and 8 < x < 16))
        check(time is not None, "no crack starts")
        check(summary(directory)["fragments"] == 2, "the plate does not break in two")
        found.append(displacement(time))
    print(f"grip displacement {found[0]:.6g} m from the notch, {found[1]:.6g} m from thresholds", flush=True)
    check(abs(found[0] / found[1] - 1) < 0.01, f"the crack starts at a grip displacement of {found} m")
    del quick


def fracture_energy_drives_a_crack_from_a_notch(workplace, quick):
    """The uniform threshold of a fracture energy and a notch: the crack stays in the plane of the notch."""
    material = {"model": "paper", "young": 1e5, "density": 1000, "damping": 0.5, "fracture_energy": 0.5}
    scene = plate([48, 24, 1], speed="0.005*min(t/0.02,1)", material=material, sensors=None,
                  notches=[rectangle([-1, 0.12, -1], [1.24, 0, 0], [0, 0, 2])], time={"end": 0.4}, coat={"rate": 50},
                  history={"rate": 50})
    expected = None
    for ranks in (1, 2) if quick else RANKS:
        directory = workplace.finished(scene, ranks=ranks)
        found = summary(directory)
        check(found["fragments"] >= 2, "the plate does not break")
        check(found["counts"]["notched_faces"] == 24, "the notch is not 24 faces long")
        area = 0.01 * 0.01 * 24
        check(0.99 * area < found["crack_area"] < 1.3 * area,
              f"crack area {found['crack_area']} m2, {area} m2 are left in the plane of the notch")
        expected = expected or hashes(directory)
        check(hashes(directory) == expected, f"other hashes on {ranks} ranks")


def any_ranks_and_partition(workplace, quick):
    """Oblique notches through vertices and entities, with both kinds of duplets, audited."""
    notches = [{"name": "oblique", **rectangle([0.02, 0.01, -0.01], [0.05, 0.04, 0], [0.01, 0, 0.06])},
               {"name": "disc",
                "where": {"disc": {"centre": [0.09, 0.04, 0.02], "normal": [1, 0.3, 0.2], "radius": 0.03}}},
               {"name": "triangle", "where": {"polygon": [[0, 0.05, 0.02], [0.12, 0.05, 0.02], [0.06, 0.09, 0.02]]}}]
    for duplets in ("corners", "tree"):
        scene = {
            "block": {"cells": [12, 8, 4], "edge": 0.01},
            "material": {"model": "paper", "young": 2e4, "density": 1000},
            "duplets": duplets,
            "notches": notches,
            "sensors": {"threshold": 0.03, "weibull": {"shape": 6}},
            "initial": {"velocity": ["8*(x-0.06)", "6*(y-0.04)", "0.2*sin(60*x)"]},
            "time": {"end": 0.03, "scheme": "ab2"},
            "coat": {"rate": 500},
            "output": {"rate": 0},
        }
        reference = workplace.finished(scene)
        found = summary(reference)
        check(found["events"]["splits"] > 100, f"only {found['events']['splits']} splits")
        for ranks in (2,) if quick else RANKS[1:]:
            for partition in ("random",) if quick else ("metis", "slab", "random"):
                directory = workplace.finished(scene, "--audit", "--set", f"partition.kind={partition}", ranks=ranks)
                check(hashes(directory) == hashes(reference), f"{duplets}, {partition}: other hashes on {ranks} ranks")
                for name in ("fragments", "components", "crack_area", "counts"):
                    check(summary(directory)[name] == found[name],
                          f"{duplets}, {partition}: other {name} on {ranks} ranks")
                same = frame_cells(last_frame(directory, "crack")) == frame_cells(last_frame(reference, "crack"))
                check(same, f"{duplets}, {partition}: another crack frame on {ranks} ranks")


def a_notch_one_entity_wide_parts_no_union(workplace, quick):
    """Its face stays sewn until a union at its rim splits, and is no crack area then either."""
    del quick
    narrow = rectangle([0.041, 0.05, 0.001], [0.008, 0, 0], [0, 0, 0.008])
    scene = plate([10, 10, 3], notches=[narrow], time={"end": 0.001})
    done = workplace.run(workplace.write(scene), "--out", workplace.path / "narrow")
    check("notches: they part no Mass-union" in done.stdout + done.stderr, done.stdout + done.stderr)
    found = summary(workplace.path / "narrow")
    check(found["counts"]["notched_faces"] == 1 and found["counts"]["unions"] == 11 * 11 * 4, f"{found['counts']}")
    broken = {**scene, "time": {"end": 0.2}, "sensors": {"threshold": "abs(y-0.05) < 1e-4 ? 0.01 : 1e9"}}
    directory = workplace.finished(broken, "--audit", ranks=2)
    found = summary(directory)
    check(found["fragments"] == 2, "the plate does not break in two")
    _, cells = frame_cells(last_frame(directory, "crack"))
    notched = sum(1 for cell in cells if cell[2] == 0)
    check(notched == 2, f"{notched} crack faces have opened_at 0, not the two sides of the notch")
    faces_beside = len(cells) / 2 - 1
    check(abs(found["crack_area"] - 1e-4 * faces_beside) < 1e-9,
          f"crack area {found['crack_area']} m2 of {faces_beside} faces")


def a_run_says_what_notches_open(workplace, quick):
    del quick
    scene = plate([10, 10, 1], notches=[rectangle([-1, 0.05, -1], [2, 0, 0], [0, 0, 2])])
    done = workplace.run(workplace.write(scene), "--dry-run", ranks=2)
    check(done.returncode == 0 and "notches open 10 interior faces" in done.stdout, done.stdout + done.stderr)


TESTS = [a_notch_one_entity_wide_parts_no_union, a_cut_leaves_two_fragments_and_no_crack_area,
         thresholds_open_faces_beside_the_cut, a_crack_starts_as_from_faces_opened_by_thresholds,
         fracture_energy_drives_a_crack_from_a_notch, any_ranks_and_partition, a_run_says_what_notches_open]
if __name__ == "__main__":
    main(TESTS)
