"""Formats the rows of all measurements, read from standard input, as one Markdown table."""
import sys

HEAD = ["what", "case", "median", "min", "max", "unit", "remark"]


def main():
    rows = [line.rstrip("\n").split("\t") for line in sys.stdin if line.count("\t") == len(HEAD) - 1]
    # The name of a group appears in its first row only.
    shown = [[*(["" if i > 0 and rows[i - 1][0] == row[0] else row[0]]), *row[1:]] for i, row in enumerate(rows)]
    widths = [max(len(row[column]) for row in [HEAD, *shown]) for column in range(len(HEAD))]
    rule = ["-" * width for width in widths]
    for row in [HEAD, rule, *shown]:
        print("| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths)) + " |")


if __name__ == "__main__":
    main()
