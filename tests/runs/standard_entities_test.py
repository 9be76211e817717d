#!/usr/bin/env python3
"""Standard entities resist what the paper's entities let pass: grid-scale noise, and shear without a sensor that feels
it."""
import csv

from runner import check, main, summary

MATERIAL = {"young": 2.0e4, "density": 1000}


def elastic_energies(directory):
    with open(directory / "history.csv", encoding="utf-8") as file:
        return [float(row["elastic"]) for row in csv.DictReader(file)]


def a_checkerboard_of_displacements_has_stiffness_and_decays(workplace, quick):
    """Its displacements along z alternate along x and y: a zero-energy mode of the paper's entities."""
    del quick
    scene = {"block": {"cells": [10, 10, 4], "edge": 0.01}, "sensors": {"threshold": float("inf")},
             "initial": {"displacement": [0, 0, "0.0005*cos(pi*x/0.01)*cos(pi*y/0.01)"]},
             "time": {"end": 0.5}, "output": {"rate": 0}, "history": {"rate": 200}}
    energies = {model: elastic_energies(workplace.finished({**scene, "material": {"model": model, **MATERIAL}}))
                for model in ("standard", "paper")}
    check(energies["standard"][0] > 20 * energies["paper"][0],
          f"the energy is {energies['standard'][0]} J, that of the paper's entities {energies['paper'][0]} J")
    check(energies["standard"][-1] < 1e-6 * energies["standard"][0],
          f"the energy decays from {energies['standard'][0]} to {energies['standard'][-1]} J only")


def simple_shear_breaks_a_block(workplace, quick):
    """A shear of 0.12, far above the threshold of 0.01, while every mass is held."""
    del quick
    everywhere = [[-float("inf")] * 3, [float("inf")] * 3]
    scene = {"block": {"cells": [6, 6, 6], "edge": 1.0}, "material": {"young": 1.0, "density": 1.0},
             "sensors": {"threshold": 0.01}, "initial": {"displacement": ["0.12*z", 0, 0]},
             "supports": [{"where": {"box": everywhere}, "velocity": [0, 0, 0]}],
             "time": {"end": 1}, "output": {"rate": 0}}
    splits = summary(workplace.finished(scene))["events"]["splits"]
    check(splits > 0, "the block does not break")
    paper = {**scene, "material": {"model": "paper", "young": 1.0, "density": 1.0}}
    check(summary(workplace.finished(paper))["events"]["splits"] == 0, "sensors `normal` feel shear")


def a_run_names_entity_and_sensors(workplace, quick):
    del quick
    scene = {"block": {"cells": [3, 3, 3], "edge": 0.01}, "material": {**MATERIAL, "poisson": 0.3},
             "sensors": {"threshold": 0.02}, "time": {"end": 1e-3}}
    said = workplace.run(workplace.write(scene), "--out", "named").stdout
    check("standard entities (Poisson's ratio 0.3), sensors stress" in said, f"not said in:\n{said}")
    resolved = (workplace.path / "named" / "input.resolved.yaml").read_text(encoding="utf-8")
    check("model: standard" in resolved and "kind: stress" in resolved, f"not said in:\n{resolved}")


TESTS = [a_checkerboard_of_displacements_has_stiffness_and_decays, simple_shear_breaks_a_block,
         a_run_names_entity_and_sensors]
if __name__ == "__main__":
    main(TESTS)
