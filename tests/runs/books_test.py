#!/usr/bin/env python3
"""history.csv and summary.json have the energy books, momenta and supports, and agree, on any number of ranks."""
import csv

from runner import check, cracking_scene, main, summary

SUPPORTS = [
    {"name": "left", "where": {"box": [[-1, -1, -1], [0.001, 1, 1]]}, "velocity": ["-0.3*cos(40*t)", 0, None]},
    {"name": 'lid, "upper"', "where": {"box": [[0.02, -1, 0.039], [1, 1, 1]]}, "velocity": [None, None, 0.1]},
]
VECTORS = ("momentum", "angular_momentum")


def history(directory):
    with open(directory / "history.csv", encoding="utf-8", newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def vector(row, name):
    return [row[f"{name}_{axis}"] for axis in "xyz"]


def close(a, b, scale):
    return abs(a - b) <= 1e-9 * scale


def columns_agree(rows, last, names):
    first = rows[0]["kinetic"] + rows[0]["elastic"]
    for row in rows:
        held = row["kinetic"] + row["elastic"] + row["dissipated"]
        check(close(row["residual"], first + row["external"] - held, row["scale"]), f"residual of {row}")
        work = sum(row[f"{name}.work"] for name in names)
        check(close(row["external"], work, row["scale"]), f"external is not the work of the supports in {row}")
        check(abs(row["residual"]) < 0.05 * row["scale"], f"the books do not close in {row}")
    scales = [row["scale"] for row in rows]
    check(scales == sorted(scales) and scales[0] == first, f"scales {scales}")
    end = rows[-1]
    for name in ("kinetic", "elastic", "dissipated", "external", "residual", "scale"):
        check(end[name] == last["energy"][name], f"energy.{name} is not in the last row")
    for name in VECTORS:
        check(vector(end, name) == last[name], f"{name} is not in the last row")
    check(list(last["supports"]) == names, f"supports {list(last['supports'])}")
    for name, support in last["supports"].items():
        check(vector(end, f"{name}.force") == support["force"], f"force of {name}")
        check(vector(end, f"{name}.displacement") == support["displacement"], f"displacement of {name}")
        check(end[f"{name}.work"] == support["work"], f"work of {name}")


def history_and_summary_agree(workplace, quick):
    names = [support["name"] for support in SUPPORTS]
    for scheme in ("cordis", "ab2"):
        runs = []
        for ranks in (1, 3) if quick else (1, 2, 3):
            scene = cracking_scene(supports=SUPPORTS, time={"end": 0.06, "scheme": scheme})
            directory = workplace.finished(scene, ranks=ranks)
            rows = history(directory)
            columns_agree(rows, summary(directory), names)
            runs.append(rows)
        check(runs[0][-1]["dissipated"] > 0, "nothing was dissipated")
        for rows in runs[1:]:
            for one, other in zip(runs[0], rows, strict=True):
                for name in ("kinetic", "elastic", "dissipated", "external", "residual"):
                    check(close(one[name], other[name], one["scale"]), f"{name} depends on the number of ranks")


def closing_line_names_the_share(workplace, quick):
    del quick
    done = workplace.run(workplace.write(cracking_scene()), "--out", workplace.path / "closing")
    share = summary(workplace.path / "closing")["energy"]
    lines = [line for line in done.stdout.splitlines() if line.startswith("energy books close to ")]
    check(len(lines) == 1, f"no line about the books:\n{done.stdout}")
    printed = float(lines[0].split()[4])
    expected = 100 * abs(share["residual"]) / share["scale"]
    check(abs(printed - expected) <= 0.06 * expected, f"{lines[0]}, but the summary has {expected} %")


main([history_and_summary_agree, closing_line_names_the_share])
