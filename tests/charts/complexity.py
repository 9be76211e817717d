#!/usr/bin/env python3
"""Draws complexity.png, the time of the modification, from complexity.csv, which tests/long/complexity.sh writes.

Usage: complexity.py [CSV [PNG]]
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
CASES = [(0, 0, "same splits in the middle, caches warm", "tab:blue", "o", "-"),
         (0, 1, "same splits in the middle, caches cold", "tab:blue", "o", "--"),
         (1, 0, "splits all over the block, caches warm", "tab:red", "s", "-"),
         (1, 1, "splits all over the block, caches cold", "tab:red", "s", "--")]


def medians(path):
    """A row of numbers for each measurement: the medians over its repetitions, times in microseconds."""
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            name, _, statistic = row["name"].rpartition("_")
            if statistic == "median":
                numbers = {key: float(value) for key, value in row.items()
                           if value and key not in ("name", "time_unit")}
                yield {"kind": name.split("/")[0], "time": numbers.pop("real_time"), **numbers}


def select(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def sizes(rows):
    return sorted({row["entities"] for row in rows})


def line(axes, rows, x, y, **style):
    ordered = sorted(rows, key=lambda row: row[x])
    axes.plot([row[x] for row in ordered], [y(row) for row in ordered], markersize=4, **style)


def nanoseconds_a_split(row):
    return 1000 * row["time"] / row["splits"]


def draw_splits(axes, rows):
    for place, style in ((0, "-"), (1, ":")):
        for number, entities in enumerate(sizes(rows)):
            chosen = select(rows, kind="modify", masses=0, scattered=place, cold=0, entities=entities)
            line(axes, chosen, "splits", nanoseconds_a_split, color=f"C{number}", linestyle=style, marker="o",
                 label=f"{entities:,.0f} entities" if place == 0 else None)
    axes.set(xscale="log", xlabel="splits", ylabel="time per split, ns",
             title="(a) number of splits\n(solid: in the middle, dotted: all over; warm)")


def draw_masses(axes, rows):
    for number, entities in enumerate(sizes(rows)):
        chosen = [row for row in select(rows, kind="modify", entities=entities) if row["masses"] > 0]
        line(axes, chosen, "masses", nanoseconds_a_split, color=f"C{number}", marker="o",
             label=f"{entities:,.0f} entities")
    unsewn = axes.twinx()
    line(unsewn, [row for row in select(rows, kind="modify", entities=sizes(rows)[0]) if row["masses"] > 0], "masses",
         lambda row: row["unsewn"] / row["splits"], color="grey", linestyle="--", marker="x")
    unsewn.set(ylabel="faces unsewn per split (dashed)", ylim=(0, None))
    axes.set(xlabel="masses in the new union, of 8", ylabel="time per split, ns",
             title="(b) masses per new union\n(1,000 splits in the middle; warm)")


def draw_sizes(axes, rows):
    for place, cold, label, color, marker, style in CASES:
        chosen = select(rows, kind="modify", splits=1000, masses=0, scattered=place, cold=cold)
        line(axes, chosen, "entities", lambda row: row["time"] / 1000, label=label, color=color, marker=marker,
             linestyle=style)
    line(axes, select(rows, kind="labels"), "entities", lambda row: row["time"] / 1000, color="grey", linestyle="-.",
         marker="x", label="not modification: labels of components")
    first = select(rows, kind="modify")[0]
    axes.text(0.02, 0.02, f"every block, before and after: {first['darts_per_entity']:.0f} darts and "
              f"{first['bytes_per_entity']:.0f} bytes an entity", transform=axes.transAxes, fontsize=8)
    axes.set(xscale="log", yscale="log", ylim=(0.1, None), xlabel="entities of the block",
             ylabel="time of the modification, ms", title="(c) size of the block\n(1,000 splits)")


def main(arguments):
    table = pathlib.Path(arguments[0]) if arguments else FOLDER / "complexity.csv"
    picture = pathlib.Path(arguments[1]) if len(arguments) > 1 else table.with_suffix(".png")
    rows = list(medians(table))
    figure, axes = plt.subplots(1, 3, figsize=(16, 5), layout="constrained")
    for draw, panel in zip((draw_splits, draw_masses, draw_sizes), axes):
        draw(panel, rows)
        panel.grid(alpha=0.3)
        panel.legend(fontsize=8)
        if panel is not axes[2]:
            panel.set_ylim(bottom=0)
    figure.get_layout_engine().set(w_pad=0.15)
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(sys.argv[1:])
