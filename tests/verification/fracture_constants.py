#!/usr/bin/env python3
"""Measures the constant c of G_c = c E a s_c^2 on strips, for an entity, sensors and Poisson's ratios.

A strip of height H with a crack along its middle, between grips that move apart slowly, in plane strain: the crack
starts at the strain e of the first split, where the energy release rate is G = (kappa + 4/3 mu) e^2 H/2. Prints
c(H) = G/(E a s_c^2) for each height, and the law fitted to all heights: c (1 - B a/H) for sensors `stress`, and
s_c/e = sqrt(C H/2c) + b for sensors `normal` (uniform strain adds to the strain at the tip).

Usage: fracture_constants.py CRACKSIM [--model standard] [--sensors stress] [--poisson 0.2,0.25,0.3] [--heights 20,40,80]
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import tempfile

THRESHOLD = 0.01
DAMPING = 0.2


def confined_modulus(poisson):
    """kappa + 4/3 mu over Young's modulus."""
    return 1 / (3 * (1 - 2 * poisson)) + 4 / 3 / (2 * (1 + poisson))


def strip(height, model, sensors, poisson, velocity, end):
    """A strip of unit cubes, E = rho = 1, three times as long as high; the crack reaches to its middle."""
    length = 3 * height
    inner = {"name": "plane strain", "where": {"box": [[-1, -1, 0.2], [length + 1, 2, height - 0.2]]},
             "velocity": [None, 0, None]}
    grips = [{"name": name, "where": {"box": [[-1, -1, z - 0.1], [length + 1, 2, z + 0.1]]}, "velocity": [0, 0, speed]}
             for name, z, speed in (("lower grip", 0, 0), ("upper grip", height, velocity))]
    return {"block": {"cells": [length, 1, height], "edge": 1.0},
            "material": {"model": model, "young": 1.0, "density": 1.0, "poisson": poisson, "damping": DAMPING},
            "sensors": {"kind": sensors, "threshold": THRESHOLD},
            "notches": [{"name": "crack", "where": {"rectangle": {
                "corner": [-1, -1, height / 2], "along": [length / 2 + 1, 0, 0], "and": [0, 3, 0]}}}],
            "supports": [*grips, inner],
            "time": {"end": end}, "output": {"rate": 0}, "coat": {"rate": 1e-3}, "history": {"rate": 2.0}}


def strain_at_first_split(cracksim, height, model, sensors, poisson):
    modulus = confined_modulus(poisson)
    expected = THRESHOLD / math.sqrt(modulus * height / 2 / 2.8)
    duration = 20 * height
    velocity = expected * height / duration
    with tempfile.TemporaryDirectory() as place:
        scene = pathlib.Path(place) / "strip.yaml"
        scene.write_text(json.dumps(strip(height, model, sensors, poisson, velocity, 1.5 * duration)), encoding="utf-8")
        subprocess.run([cracksim, scene, "--out", f"{place}/out", "--quiet"], check=True, capture_output=True)
        with open(f"{place}/out/history.csv", encoding="utf-8") as history:
            rows = list(csv.DictReader(history))
    inactive = next(name for name in rows[0] if "inactive" in name)
    first = next(row for row in rows if float(row[inactive]) > 0)
    return velocity * float(first["time"]) / height


def line_through(points):
    """Slope and value at 0 of the straight line of least squares."""
    count = len(points)
    sum_x = sum(x for x, _ in points)
    sum_y = sum(y for _, y in points)
    slope = ((count * sum(x * y for x, y in points) - sum_x * sum_y) /
             (count * sum(x * x for x, _ in points) - sum_x ** 2))
    return slope, (sum_y - slope * sum_x) / count


def fit(sensors, modulus, strains):
    """c for strips of infinite height, and the parameter of the law; strains: by height."""
    if sensors == "stress":
        slope, constant = line_through([(1 / height, modulus * strain ** 2 * height / 2 / THRESHOLD ** 2)
                                        for height, strain in strains.items()])
        return constant, -slope / constant
    slope, offset = line_through([(math.sqrt(height), THRESHOLD / strain) for height, strain in strains.items()])
    return modulus / (2 * slope ** 2), offset


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cracksim")
    parser.add_argument("--model", default="standard")
    parser.add_argument("--sensors", default="stress")
    parser.add_argument("--poisson", default="0.2,0.25,0.3")
    parser.add_argument("--heights", default="20,40,80")
    options = parser.parse_args()
    for poisson in (float(text) for text in options.poisson.split(",")):
        modulus = confined_modulus(poisson)
        strains = {}
        for height in (int(text) for text in options.heights.split(",")):
            strains[height] = strain_at_first_split(options.cracksim, height, options.model, options.sensors, poisson)
            print(f"{options.model}, {options.sensors}, nu {poisson}, H/a {height}: "
                  f"c {modulus * strains[height] ** 2 * height / 2 / THRESHOLD ** 2:.4f}", flush=True)
        constant, parameter = fit(options.sensors, modulus, strains)
        print(f"{options.model}, {options.sensors}, nu {poisson}: c {constant:.3f}, "
              f"{'B' if options.sensors == 'stress' else 'b'} {parameter:.3f}", flush=True)


if __name__ == "__main__":
    main()
