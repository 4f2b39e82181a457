#!/usr/bin/env python3
"""Runs an experiment over speeds, seeds and whatever else is varied, and prints a table as those of docs/experiments.md.

Every run is one call of `tessera-cli experiment`; its folder keeps summary.json, track.csv and track.png, and runs.csv
beside the folders holds all options and figures of all runs, one line a run (and vehicle, where a run has several);
`tessera-cli charts` draws it. Runs go side by side as far as --jobs allows. Ends with 1 when a run gave no figures or did
not finish.

  bench/experiments.py --vehicle native --vary estimator=particles,kalman --vary pitch=0.10,0.20 -- --lockstep
"""
import argparse
import itertools
import os
import pathlib
import platform
import sys

import runs
import tables

ROOT = pathlib.Path(__file__).resolve().parent.parent


def machine():
    info = pathlib.Path("/proc/cpuinfo")
    for line in info.read_text().splitlines() if info.exists() else []:
        if line.startswith("model name"):
            return f"{line.split(':', 1)[1].strip()}, {os.cpu_count()} cores"
    return f"{platform.processor() or platform.machine()}, {os.cpu_count()} cores"


def jobs_for(lockstep):
    """As many as cores, one less where runs are in real time."""
    cores = os.cpu_count() or 1
    return cores if lockstep else max(1, cores - 1)


def varied(text):
    name, equals, values = text.partition("=")
    values = [value for value in values.split(",") if value]
    if not equals or not name or not values:
        raise argparse.ArgumentTypeError(f"{text} is not of the form NAME=a,b,c")
    name = name.removeprefix("--")
    if name in ("seed", "speed", "out", "site"):
        raise argparse.ArgumentTypeError({"seed": "seeds are varied by --seeds and --first-seed",
                                          "speed": "speeds are varied by --speeds"}.get(name, f"{name} cannot be varied"))
    return name, values


def complain(cases, baseline):
    """Says on standard error which rows have runs that gave no figures or did not finish. True: there is cause for exit
    code 1. Of a baseline both are results, unless a row has nothing else."""
    failed = False
    for keys, results in cases:
        errors = [r["error"] for r in results if "error" in r]
        late = sum(not r["finished"] for r in results if "error" not in r)
        name = f"of {len(results)} runs of the row {' | '.join(keys)}"
        if errors:
            print(f"{len(errors)} {name} gave no figures, the first: {errors[0]}", file=sys.stderr)
        if late:
            print(f"{late} {name} did not reach the end of their routes.", file=sys.stderr)
        failed = failed or len(errors) == len(results) or (not baseline and bool(errors or late))
    return failed


def parse(words=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cli", type=pathlib.Path, default=ROOT / "build/bin/tessera-cli")
    parser.add_argument("--site", type=pathlib.Path, default=ROOT / "resources/sites/paper.tessera.json")
    parser.add_argument("--route", default="paper", help="route of the site's first vehicle")
    parser.add_argument("--drive", action="append", default=[], metavar="ID=ROUTE",
                        help="a vehicle and its route, instead of --route; may be repeated")
    parser.add_argument("--vehicle", choices=["qemu", "native"], default="qemu")
    parser.add_argument("--speeds", type=float, nargs="+", default=[0.05, 0.08, 0.12, 0.20], metavar="M_PER_S")
    parser.add_argument("--vary", type=varied, action="append", default=[], metavar="NAME=a,b,c",
                        help="an option of `tessera-cli experiment`, or pitch, with the values that it takes in turn; may be"
                             " repeated: the table has a row for each combination")
    parser.add_argument("--pitch", type=float, metavar="M",
                        help="the floor of --site with its tags at this pitch, which divides a tile")
    parser.add_argument("--seeds", type=int, default=5, help="this many seeds")
    parser.add_argument("--first-seed", type=int, default=1, help="the first of them (default 1)")
    parser.add_argument("--jobs", type=int,
                        help="runs side by side; default: as many as cores, one less where they are in real time")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/experiments/runs")
    parser.add_argument("--limits", action="store_true",
                        help="the table of limits: off corners and the end, and how honest the locator is")
    parser.add_argument("--floors", action="store_true", help="on floors of many kinds, made from --site for each seed")
    parser.add_argument("--baseline", action="store_true", help="runs that do not finish, or are refused, are no failure but a result")
    parser.add_argument("extra", nargs="*", help="further options of `tessera-cli experiment`, after --")
    arguments = parser.parse_args(words)
    try:
        given = runs.setting_of(arguments.extra)
    except ValueError as error:
        parser.error(f"after --: {error}")
    twice = [name for name, _ in arguments.vary if name in given or [n for n, _ in arguments.vary].count(name) > 1]
    if twice:
        parser.error(f"{twice[0]} is given twice")
    if arguments.floors and (arguments.pitch or "pitch" in dict(arguments.vary)):
        parser.error("--floors have the pitch that they have")
    if arguments.jobs is None:
        arguments.jobs = jobs_for("lockstep" in given)
    if arguments.jobs < 1 or arguments.seeds < 1 or arguments.first_seed < 1:
        parser.error("--jobs, --seeds and --first-seed begin at 1")
    base = {"site": str(arguments.site.resolve()), "vehicle": arguments.vehicle}
    base |= {"drive": " ".join(arguments.drive)} if arguments.drive else {"route": arguments.route}
    base |= {"pitch": f"{arguments.pitch:g}"} if arguments.pitch else {}
    return arguments, {**base, **given}


def product(arguments, base):
    """[(keys, [(setting, seed)])] of every combination, the first name varying slowest, the speed before all."""
    axes = [[("speed", f"{speed:g}", f"{speed:.2f}") for speed in arguments.speeds]]
    axes += [[(name, value, value) for value in values] for name, values in arguments.vary]
    if arguments.floors:
        axes.append([("floor", number, name) for name, number in tables.FLOORS])
    seeds = range(arguments.first_seed, arguments.first_seed + arguments.seeds)
    return [([shown for _, _, shown in one], [({**base, **{name: value for name, value, _ in one}}, s) for s in seeds])
            for one in itertools.product(*axes)]


def main():
    arguments, base = parse()
    kind = "floor" if arguments.floors else "limits" if arguments.limits else "drive"
    cases = tables.measure(arguments.cli, product(arguments, base), arguments.out.resolve(), arguments.jobs)
    print(f"Machine: {machine()}; {arguments.jobs} runs side by side; vehicle {arguments.vehicle}; seeds"
          f" {arguments.first_seed} to {arguments.first_seed + arguments.seeds - 1}; options:"
          f" {' '.join(arguments.extra) or 'none'}\n")
    keys = ["m/s", *(name for name, _ in arguments.vary)]
    keys += ["floor and route"] if arguments.floors else ["vehicle"] if kind == "drive" and len(arguments.drive) > 1 else []
    print("\n".join([*tables.head(keys, kind), *tables.rows(cases, kind)]))
    for note in tables.notes([r for _, results in cases for r in results]):
        print("\n" + note)
    return 1 if complain(cases, arguments.baseline) else 0


if __name__ == "__main__":
    sys.exit(main())
