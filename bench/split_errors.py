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


def rms(values):
    values = list(values)
    return 100 * math.sqrt(sum(v * v for v in values) / len(values))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("site", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path, help="of runs on the site's first route")
    arguments = parser.parse_args()
    line = list(legs(json.loads(arguments.site.read_text(encoding="utf-8"))["routes"][0]["vertices_m"]))
    runs = [split(track, line) for track in sorted(arguments.folder.glob("**/track.csv"))]
    if not runs:
        parser.error(f"there is no track.csv below {arguments.folder}")
    across = [pair for run in runs for pair in run[0]]
    true, believed = [run[1] for run in runs], [run[2] for run in runs]
    print("| | true, cm | believed, cm | mistaken, cm |\n| --- | --- | --- | --- |")
    print(f"| off corners, RMS across | {rms(t for t, _ in across):.2f} | {rms(b for _, b in across):.2f} |"
          f" {rms(b - t for t, b in across):.2f} |")
    for name, axis in (("along", 0), ("across", 1)):
        print(f"| at the end, RMS {name} | {rms(t[axis] for t in true):.2f} | {rms(b[axis] for b in believed):.2f} |"
              f" {rms(b[axis] - t[axis] for t, b in zip(true, believed)):.2f} |")
    print(f"\nWithin 1 cm of the end: {sum(math.hypot(*t) <= 0.01 for t in true)} of {len(runs)} runs, the worst"
          f" {100 * max(math.hypot(*t) for t in true):.2f} cm off.")


if __name__ == "__main__":
    main()
