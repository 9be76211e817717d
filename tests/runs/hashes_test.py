#!/usr/bin/env python3
"""The hashes of events and state do not depend on ranks, partition, audit, rates, prefilter or build."""
import os
import random
import subprocess

from runner import Failure, check, cracking_scene, frame_cells, last_frame, main, summary

RANKS = (1, 2, 3, 4, 7)
PARTITIONS = ("metis", "slab", "random")
PULLED = [{"name": "left", "where": {"box": [[-1, -1, -1], [0.005, 1, 1]]}, "velocity": [0, 0, None]},
          {"name": "right", "where": {"box": [[0.075, -1, -1], [1, 1, 1]]}, "velocity": ["0.3*(1+t)", 0, 0]}]


def hashes(directory):
    result = summary(directory)
    return result["event_hash"], result["state_hash"]


def reference(workplace, scene, least_splits, what):
    """Hashes of a run on one rank; the run must have enough splits for the hashes to be able to differ."""
    directory = workplace.finished(scene)
    splits = summary(directory)["events"]["splits"]
    check(splits >= least_splits, f"{what}: only {splits} splits; {least_splits} are needed for a test that can fail")
    return hashes(directory)


def compare(workplace, scene, expected, what, *arguments, ranks=1, binary=None):
    found = hashes(workplace.finished(scene, *arguments, ranks=ranks, binary=binary))
    check(found == expected, f"{what}: on {ranks} ranks with {' '.join(arguments) or 'no options'} the hashes are "
                             f"{found}, not {expected}")


def any_ranks_and_partition(workplace, quick):
    scene = cracking_scene()
    expected = reference(workplace, scene, 150, "the block")
    for ranks in (3,) if quick else RANKS:
        for partition in PARTITIONS:
            compare(workplace, scene, expected, "the block", "--set", f"partition.kind={partition}", ranks=ranks)
            compare(workplace, scene, expected, "the block, audited", "--audit", "--set",
                    f"partition.kind={partition}", ranks=ranks)


def energies_are_the_same_on_any_ranks(workplace, quick):
    """Sums over ranks agree to rounding. In these rows a rank may touch all vertices of an entity of another rank."""
    del quick

    def row(cells):
        return cracking_scene(block={"entity": "hexahedron", "cells": cells, "edge": 0.01, "origin": [0, 0, 0]},
                              initial={"velocity": ["3*(x-0.01)", "2*y", 0]}, time={"end": 0.05})

    for scene, many in ((row([4, 1, 1]), (2,)), (row([3, 1, 1]), (3,)), (cracking_scene(), (2, 3))):
        alone = summary(workplace.finished(scene))["energy"]
        largest = max(abs(value) for value in alone.values())
        for ranks in many:
            shared = summary(workplace.finished(scene, "--set", "partition.kind=random", ranks=ranks))["energy"]
            for name, value in alone.items():
                check(abs(shared[name] - value) <= 1e-9 * largest,
                      f"{name} energy on {ranks} ranks is {shared[name]}, on one {value}")


def hashes_tell_runs_apart(workplace, quick):
    del quick
    events, state = hashes(workplace.finished(cracking_scene()))
    other_seed = cracking_scene(sensors={"threshold": 0.02, "weibull": {"shape": 8, "seed": 2}})
    other_events, other_state = hashes(workplace.finished(other_seed))
    check(events != other_events and state != other_state, "another seed of the thresholds gives the same hashes")
    intact = cracking_scene(sensors={"threshold": 1e3})
    _, still = hashes(workplace.finished(intact))
    check(still != state, "an intact block gives the state hash of a broken one")


def any_rates(workplace, quick):
    expected = reference(workplace, cracking_scene(), 150, "the block")
    for ranks, key, rate in ((1, "coat", 7), (2, "coat", 1000), (3, "output", 7), (2, "output", 333),
                             (1, "history", 11), (3, "history", 1500))[:2 if quick else None]:
        compare(workplace, cracking_scene(), expected, f"{key}.rate {rate}", "--set", f"{key}.rate={rate}", ranks=ranks)


def prefilter_on_and_off(workplace, quick):
    expected = reference(workplace, cracking_scene(), 150, "the block")
    for ranks in (2,) if quick else (1, 2, 3):
        compare(workplace, cracking_scene(), expected, "no prefilter", "--set", "sensors.prefilter=false", ranks=ranks)


def wide_rows(workplace, quick):
    """Most vectors of neighbours are inside the block, where the sweep assumes the shared edges of an intact block."""
    for precision in ("double", "single"):
        scene = cracking_scene(
            block={"entity": "hexahedron", "cells": [26, 6, 4], "edge": 0.01, "origin": [0, 0, 0]},
            initial={"velocity": ["1.2*(x-0.13)/0.04*exp(-900*(x-0.13)^2)", "0.3*sin(60*x)", 0]},
            time={"end": 0.04, "precision": precision})
        expected = reference(workplace, scene, 100, f"wide rows, {precision}")
        for ranks in (3,) if quick else (1, 2, 3):
            for prefilter in ("true", "false"):
                compare(workplace, scene, expected, f"wide rows, {precision}", "--set",
                        f"sensors.prefilter={prefilter}", "--set", "partition.kind=metis", ranks=ranks)


def scheme_ab2_with_supports(workplace, quick):
    scene = cracking_scene(supports=PULLED, time={"end": 0.06, "scheme": "ab2"})
    expected = reference(workplace, scene, 100, "ab2 with supports")
    for ranks in (3,) if quick else RANKS[1:]:
        for partition in PARTITIONS:
            compare(workplace, scene, expected, "ab2 with supports", "--audit", "--set",
                    f"partition.kind={partition}", ranks=ranks)


def stress_sensors(workplace, quick):
    """Several ranks decide about a face, each with its own copy of both entities."""
    sensors = {"kind": "stress", "threshold": 0.02, "weibull": {"shape": 8, "seed": 1}}
    for precision in ("double", "single"):
        for duplets in ("corners", "tree"):
            what = f"sensors stress, {precision}, {duplets}"
            scene = cracking_scene(sensors=sensors, duplets=duplets, time={"end": 0.06, "precision": precision})
            expected = reference(workplace, scene, 150, what)
            for ranks in (3,) if quick else (1, 2, 3, 4):
                for partition in ("metis", "slab"):
                    for prefilter in ("true", "false"):
                        compare(workplace, scene, expected, what, "--audit", "--set", f"partition.kind={partition}",
                                "--set", f"sensors.prefilter={prefilter}", ranks=ranks)


def standard_entities(workplace, quick):
    """Cubes and other boxes, whose corners are in the base layer and in the pool."""
    material = {"model": "standard", "young": 2.0e4, "density": 1000}
    boxes = {"entity": "hexahedron", "cells": [8, 7, 4], "edge": [0.01, 0.013, 0.008], "origin": [0, 0, 0]}
    more = ({"material": material}, {"material": {**material, "poisson": 0.35}, "block": boxes, "duplets": "tree"})
    sensors = {"threshold": 0.02, "weibull": {"shape": 8, "seed": 1}}
    for changes in more:
        for precision in ("double", "single"):
            for scheme in ("cordis",) if quick else ("cordis", "ab2"):
                what = f"standard entities, {precision}, {scheme}"
                scene = cracking_scene(sensors=sensors, supports=PULLED,
                                       time={"end": 0.06, "precision": precision, "scheme": scheme}, **changes)
                expected = reference(workplace, scene, 100, what)
                for ranks in (3,) if quick else (1, 2, 3, 4):
                    for partition, prefilter in (("metis", "true"), ("slab", "false")):
                        compare(workplace, scene, expected, what, "--audit", "--set", f"partition.kind={partition}",
                                "--set", f"sensors.prefilter={prefilter}", ranks=ranks)


def single_precision(workplace, quick):
    for scheme, more in (("cordis", {}), ("ab2", {"supports": PULLED})):
        scene = cracking_scene(time={"end": 0.06, "scheme": scheme, "precision": "single"}, **more)
        expected = reference(workplace, scene, 100, f"{scheme} in single precision")
        if not quick:
            double = cracking_scene(time={"end": 0.06, "scheme": scheme}, **more)
            check(hashes(workplace.finished(double)) != expected,
                  f"{scheme}: single precision has the hashes of double")
        for ranks in (3,) if quick else RANKS[1:]:
            for partition in PARTITIONS[-1:] if quick else PARTITIONS:
                compare(workplace, scene, expected, f"{scheme} in single precision", "--audit", "--set",
                        f"partition.kind={partition}", "--set", f"sensors.prefilter={str(partition != 'slab').lower()}",
                        ranks=ranks)


def simd_targets(workplace):
    """The targets, best first, from the message about an invalid one."""
    said = subprocess.run([workplace.binary, "--simd", "none", "scene.yaml"], check=False,
                          capture_output=True, text=True)
    return said.stderr.strip().rpartition("take one of ")[2].split(", ")


def every_simd_target(workplace, quick):
    """The oldest instructions round differently; ranks and partitions must still make no difference."""
    if quick:
        print("skipped every_simd_target: slow in this build", flush=True)
        return
    oldest = simd_targets(workplace)[-1]
    for precision in ("double", "single"):
        scene = cracking_scene(time={"end": 0.06, "precision": precision})
        best = workplace.finished(scene)
        used, with_best = summary(best)["provenance"]["simd_target"], hashes(best)
        for target in (oldest, "AVX2"):
            directory = workplace.finished(scene, "--simd", target)
            expected = hashes(directory)
            if target == oldest:
                check(summary(directory)["provenance"]["simd_target"] == oldest,
                      f"{oldest} is not what the summary names")
                check(expected != with_best or used == oldest, f"{oldest} has the hashes of {used}")
            elif used.startswith("AVX"):
                check(expected == with_best, f"{target} has other hashes than {used}")
            for ranks in (2, 3, 7):
                compare(workplace, scene, expected, f"{target}, {precision}", "--audit", "--simd", target, "--set",
                        "partition.kind=random", ranks=ranks)


def ranks_without_an_entity(workplace, quick):
    scene = cracking_scene(block={"entity": "hexahedron", "cells": [3, 1, 1], "edge": 0.01, "origin": [0, 0, 0]},
                           initial={"velocity": ["100*(x-0.015)", 0, 0]})
    expected = reference(workplace, scene, 8, "three entities")
    for ranks in (4,) if quick else (2, 3, 4, 7):
        for partition in PARTITIONS:
            compare(workplace, scene, expected, "three entities", "--audit", "--set", f"partition.kind={partition}",
                    ranks=ranks)


def boxes_of_a_network(workplace, quick):
    scene = cracking_scene(
        block={"entity": "hexahedron", "cells": [8, 7, 4], "edge": [0.01, 0.013, 0.008]}, material=None,
        network={"mass": 1.25e-4, "edge": {"stiffness": 40, "viscosity": 0.02},
                 "diagonal": {"stiffness": 0, "viscosity": 0}})
    expected = reference(workplace, scene, 100, "boxes")
    for ranks in (2,) if quick else (2, 3, 7):
        compare(workplace, scene, expected, "boxes", "--audit", "--set", "partition.kind=random", ranks=ranks)


def tree_of_duplets(workplace, quick):
    scene = cracking_scene(duplets="tree")
    expected = reference(workplace, scene, 150, "the tree")
    for ranks in (3,) if quick else (2, 3, 7):
        compare(workplace, scene, expected, "the tree", "--audit", "--set", "partition.kind=random", ranks=ranks)


def random_scene(generator):
    cells = [generator.randint(2, 12) for _ in range(2)] + [generator.randint(1, 5)]
    length = [0.01 * n for n in cells]
    rate = generator.uniform(10, 40)
    velocity = [f"{rate}*({axis}-{generator.uniform(0.2, 0.8) * size})+{generator.uniform(-0.3, 0.3)}*sin(90*{other})"
                for axis, other, size in zip("xyz", "yzx", length)]
    # In some scenes the whole block moves hundreds of edges away from its rest position.
    velocity[0] += f"+{generator.choice([0, 0, 150])}"
    return cracking_scene(
        block={"entity": "hexahedron", "cells": cells, "edge": 0.01, "origin": [generator.uniform(-0.1, 0.1), 0, 0]},
        duplets=generator.choice(["corners", "tree"]),
        material={"model": "paper", "young": generator.uniform(5e3, 5e4), "density": 1000,
                  "damping": generator.uniform(0.05, 0.6)},
        sensors={"threshold": generator.uniform(0.005, 0.04),
                 "weibull": {"shape": generator.uniform(3, 15), "seed": generator.randint(0, 2**31)}},
        initial={"velocity": velocity},
        time={"end": 0.03, "scheme": generator.choice(["cordis", "ab2"]),
              "precision": generator.choice(["double", "single"])},
        coat={"rate": generator.choice([20, 100, 900])})


def breaking_scene(workplace, generator, what):
    """The first random scene in which a union splits, and its hashes. In about one of ten scenes nothing splits."""
    for _ in range(10):
        scene = random_scene(generator)
        directory = workplace.finished(scene)
        if summary(directory)["events"]["splits"] > 0:
            return scene, hashes(directory)
    raise Failure(f"{what}: ten random scenes in a row hold")


def random_scenes(workplace, quick):
    seed = int(os.environ.get("CRACKSIM_SEED", random.SystemRandom().randint(0, 2**31)))
    print(f"random scenes of CRACKSIM_SEED={seed}", flush=True)
    generator = random.Random(seed)
    for number in range(1 if quick else 4):
        what = f"scene {number} of CRACKSIM_SEED={seed}"
        scene, expected = breaking_scene(workplace, generator, what)
        compare(workplace, scene, expected, what, "--audit", ranks=generator.choice(RANKS[1:]))
        compare(workplace, scene, expected, what, "--set", "partition.kind=slab", ranks=generator.choice(RANKS[1:]))


def frames_do_not_depend_on_ranks(workplace, quick):
    del quick
    expected = {}
    for ranks in (1, 2, 3):
        directory = workplace.finished(cracking_scene(), ranks=ranks)
        for kind in ("surface", "crack"):
            frame = last_frame(directory, kind)
            found = (frame.name, *frame_cells(frame))
            check(len(found[2]) > 50, f"the last {kind} frame has only {len(found[2])} cells")
            check(found == expected.setdefault(kind, found), f"the last {kind} frame on {ranks} ranks is not that on 1")


def release_and_second_build_agree(workplace, quick):
    del quick
    second = os.environ["CRACKSIM_SECOND_BINARY"]
    for scheme, precision in (("cordis", "double"), ("ab2", "double"), ("ab2", "single")):
        what = f"{scheme}, {precision}"
        scene = cracking_scene(time={"end": 0.06, "scheme": scheme, "precision": precision})
        expected = reference(workplace, scene, 150, what)
        for ranks in (1, 2, 7):
            compare(workplace, scene, expected, f"{second}, {what}", "--audit", ranks=ranks, binary=second)


TESTS = [any_ranks_and_partition, energies_are_the_same_on_any_ranks, hashes_tell_runs_apart, any_rates,
         prefilter_on_and_off, wide_rows, scheme_ab2_with_supports, single_precision, stress_sensors, standard_entities,
         every_simd_target, boxes_of_a_network, tree_of_duplets, ranks_without_an_entity, random_scenes,
         frames_do_not_depend_on_ranks]
if __name__ == "__main__":
    if "CRACKSIM_SECOND_BINARY" in os.environ:
        TESTS.append(release_and_second_build_agree)
    else:
        print("not compared: two builds (CRACKSIM_SECOND_BINARY names the other)", flush=True)
    main(TESTS)
