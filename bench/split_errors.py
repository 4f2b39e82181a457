#!/usr/bin/env python3
"""Splits the distance from the line into what the locator and what the controller is to blame for.

Reads the track.csv of every run below a folder that bench/experiments.py has filled: how far the vehicle truly was from
the line, how far it believed to be, and the difference, off corners (20 cm from every vertex); and the same at the end.
"""
import argparse
import csv
import json
import math
import pathlib

MARGIN = 0.2  # m from every vertex: off corners
WINDOW = 0.25  # m along the route, in which the nearest leg is looked for


def legs(vertices):
    start = 0.0
    for a, b in zip(vertices, vertices[1:]):
        length = math.dist(a, b)
        yield {"a": a, "start": start, "length": length, "x": (b[0] - a[0]) / length, "y": (b[1] - a[1]) / length}
        start += length


def on(leg, p):
    """Along and across a leg."""
    dx, dy = p[0] - leg["a"][0], p[1] - leg["a"][1]
    return dx * leg["x"] + dy * leg["y"], dy * leg["x"] - dx * leg["y"]


def nearest(line, p, progress):
    best = None
    for leg in line:
        along, across = on(leg, p)
        clamped = min(max(along, 0.0), leg["length"])
        off = math.hypot(along - clamped, across)
        at = leg["start"] + clamped
        if abs(at - progress) < WINDOW and (best is None or off < best[0]):
            best = (off, at, leg)
    return best


def split(track, line):
    """Of one run: true, believed and mistaken distance across at each tick off corners; the same at the end."""
    across, progress = [], 0.0
    true = believed = None
    with track.open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row["located"] != "1":
                continue
            true = float(row["true_x_m"]), float(row["true_y_m"])
            believed = float(row["estimate_x_m"]), float(row["estimate_y_m"])
            found = nearest(line, true, progress)
            if found is None:
                continue
            _, at, leg = found
            progress = max(progress, at)
            if MARGIN <= at - leg["start"] <= leg["length"] - MARGIN:
                across.append((on(leg, true)[1], on(leg, believed)[1]))
    last = line[-1]
    (along, side), (along_believed, side_believed) = on(last, true), on(last, believed)
    return across, (along - last["length"], side), (along_believed - last["length"], side_believed)


def line_of(site):
    """The legs of the site's first route."""
    return list(legs(json.loads(site.read_text(encoding="utf-8"))["routes"][0]["vertices_m"]))


def rms(values):
    values = list(values)
    return 100 * math.sqrt(sum(v * v for v in values) / len(values))


def told(true, believed):
    """RMS of what was true, believed and mistaken, cm."""
    return f"{rms(true):.2f} / {rms(believed):.2f} / {rms(b - t for t, b in zip(true, believed)):.2f}"


class Split:
    """Of many runs, each as split() gives it."""

    def __init__(self, found):
        self.pairs = [pair for across, _, _ in found for pair in across]
        self.true, self.believed = [true for _, true, _ in found], [believed for _, _, believed in found]

    def across(self):
        return told(*zip(*self.pairs))

    def end(self, axis):
        """axis 0: along, 1: across."""
        return told([end[axis] for end in self.true], [end[axis] for end in self.believed])

    def within(self, metres):
        return sum(math.hypot(*end) <= metres for end in self.true)

    def worst(self):
        return max(math.hypot(*end) for end in self.true)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("site", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path, help="of runs on the site's first route")
    arguments = parser.parse_args()
    line = line_of(arguments.site)
    found = [split(track, line) for track in sorted(arguments.folder.glob("**/track.csv"))]
    if not found:
        parser.error(f"there is no track.csv below {arguments.folder}")
    runs = Split(found)
    print("| RMS | true / believed / mistaken, cm |\n| --- | --- |")
    for name, cell in (("across, off corners", runs.across()), ("along, at the end", runs.end(0)),
                       ("across, at the end", runs.end(1))):
        print(f"| {name} | {cell} |")
    print(f"\nWithin 1 cm of the end: {runs.within(0.01)} of {len(found)} runs, the worst {100 * runs.worst():.2f} cm off.")


if __name__ == "__main__":
    main()
