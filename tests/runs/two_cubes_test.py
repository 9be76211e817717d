#!/usr/bin/env python3
"""inputs/two_cubes.yaml splits at the step of its closed form, on one rank and on two."""
import math

from runner import ROOT, check, dataset, main, summary

EDGE, YOUNG, DENSITY, DAMPING, STEP, THRESHOLD = 0.01, 2.0e4, 1000, 0.2, 1.0e-4, 1.0e-3


def closed_form_step(threshold, step=STEP):
    """The first step n with 2 q(n) / (2 edge) above the threshold; the scene has the derivation."""
    mass = DENSITY * EDGE ** 3 / 8
    edge, diagonal = 0.2 * EDGE * YOUNG, 0.3 * EDGE * YOUNG
    viscosity = DAMPING * EDGE / math.sqrt(YOUNG / DENSITY)
    stiffness = edge + diagonal / 3
    kappa = step ** 2 * stiffness / mass
    zeta = step * viscosity * stiffness / mass
    r = math.sqrt(1 - zeta)
    theta = math.acos((2 - kappa - zeta) / (2 * r))
    first = step * EDGE * (1 + zeta / 2)
    for n in range(1, 1000):
        q = (1 - zeta) * first * r ** (n - 1) * math.sin(n * theta) / math.sin(theta)
        if q / EDGE > threshold:
            return n
    raise AssertionError("the cubes never part")


def parts_at_the_step_of_the_closed_form(workplace, quick):
    del quick
    text = (ROOT / "inputs" / "two_cubes.yaml").read_text(encoding="utf-8")
    for threshold, ranks in ((THRESHOLD, 1), (THRESHOLD, 2), (0.4 * THRESHOLD, 2), (0.71 * THRESHOLD, 1)):
        expected = closed_form_step(threshold)
        directory = workplace.finished(text, "--set", f"sensors.threshold={threshold}", ranks=ranks)
        steps = dataset(directory / "events.hdf", "/events/step")
        check(steps == [expected] * 4, f"threshold {threshold} on {ranks} ranks: parts at {steps}, not at {expected}")
        check(summary(directory)["fragments"] == 2, f"threshold {threshold}: not two fragments")
    check(closed_form_step(THRESHOLD) != closed_form_step(0.4 * THRESHOLD), "the thresholds do not tell steps apart")


main([parts_at_the_step_of_the_closed_form])
