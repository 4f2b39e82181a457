#!/usr/bin/env python3
"""Runs an experiment over speeds and seeds and prints a table of docs/experiments.md.

Every run is one call of `tessera-cli experiment`; its folder keeps summary.json, track.csv and track.png.
Runs go side by side as far as --jobs allows. Ends with 1 when a run gave no figures or did not finish.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile

import floors


def cpu_model():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines() if os.path.exists("/proc/cpuinfo") else []:
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def run_on_floor(arguments, kind, seed):
    """A run on a floor that is made for it."""
    with tempfile.TemporaryDirectory() as folder:
        words = argparse.Namespace(**vars(arguments))
        words.site = pathlib.Path(folder) / "floor.tessera.json"
        words.drive, words.route, words.out = [], floors.ROUTE, arguments.out / f"floor-{kind}"
        words.extra = [*arguments.extra, *floors.write(floors.load(arguments.site), kind, seed, words.site)]
        return run(words, arguments.speeds[0], seed)


def run(arguments, speed, seed):
    out = arguments.out / f"{arguments.vehicle}-{speed:g}-{seed}"
    summary = out / "summary.json"
    summary.unlink(missing_ok=True)  # an earlier run's figures are not this one's
    routes = [word for drive in arguments.drive for word in ("--drive", drive)] or ["--route", arguments.route]
    command = [str(arguments.cli), "experiment", str(arguments.site), *routes, "--speed", f"{speed:g}",
               "--vehicle", arguments.vehicle, "--seed", str(seed), "--out", str(out), "--quiet", *arguments.extra]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if not summary.exists():
        return {"error": (done.stderr or done.stdout).strip()}
    figures = json.loads(summary.read_text())
    if any(vehicle["samples"] == 0 for vehicle in figures["vehicles"]):
        return {"error": "a vehicle never drove, so nothing was measured"}
    return figures


def seeds_of(arguments):
    return range(arguments.first_seed, arguments.first_seed + arguments.seeds)


def row(speed, name, results):
    """One line of the table: a vehicle at one speed, over its seeds. results: its figures, None where a run gave none."""
    good = [figures for figures in results if figures is not None]
    head = f"| {speed:.2f} |" + (f" {name} |" if name else "")
    if not good:
        return f"{head} 0/{len(results)} |" + " – |" * 7

    def centimetres(name, pick):
        return f"{100 * pick(v[name] for v in good):.2f}"

    return (f"{head} {sum(v['finished'] for v in good)}/{len(results)} "
            f"| {centimetres('position_error_mean_m', statistics.fmean)} | {centimetres('position_error_mean_m', max)} "
            f"| {centimetres('position_error_p95_m', max)} "
            f"| {centimetres('cross_track_rms_m', statistics.fmean)} | {centimetres('cross_track_rms_m', max)} "
            f"| {sum(v['reversals'] for v in good)} | {min(v['mean_speed_ratio'] for v in good):.2f} |")


def limits_row(speed, results):
    """One line of the table of limits: a speed over its seeds. results: whole summaries."""
    good = [r for r in results if "error" not in r]
    if not good:
        return f"| {speed:.2f} | 0/{len(results)} |" + " – |" * 8

    def centimetres(name, pick):
        return f"{100 * pick(r[name] for r in good):.2f}"

    line = (f"| {speed:.2f} | {sum(r['finished'] for r in good)}/{len(results)} "
            f"| {centimetres('position_error_mean_m', statistics.fmean)} | {centimetres('position_error_mean_m', max)} "
            f"| {centimetres('cross_track_rms_off_corners_m', statistics.fmean)} "
            f"| {centimetres('cross_track_max_off_corners_m', max)} | {centimetres('end_error_m', max)} "
            f"| {statistics.fmean(r['nees_mean'] for r in good):.2f} | {sum(r['consistent'] for r in good)}/{len(good)} "
            f"| {min(r['mean_speed_ratio'] for r in good):.2f} |")
    carried = [r["carried"] for r in good if "carried" in r]
    if carried:
        ways = [c["found_after_m"] for c in carried if c["found"]]
        line += (f"\n\nFound again after being carried: {len(ways)} of {len(carried)}, after {statistics.fmean(ways):.2f} m"
                 f" on average and {max(ways):.2f} m at most, {sum(w <= 1.0 for w in ways)} within 1 m; sure of a wrong"
                 f" place for {statistics.fmean(c['wrongly_sure_s'] for c in carried):.1f} s on average.")
    return line


def print_limits(arguments, results):
    print("| m/s | finished | position error mean, cm | worst seed | cross-track RMS off corners, cm | largest, worst seed |"
          " off the end, worst seed | NEES (2 is honest) | consistent runs | mean speed ratio, worst seed |")
    print("| --- " * 10 + "|")
    for speed in arguments.speeds:
        print(limits_row(speed, [results[(speed, seed)] for seed in seeds_of(arguments)]))


DIVERGED = 0.5  # m: with an error of more than this, at any time after its first place, a locator has diverged


def print_floors(arguments, results):
    print("| floor and route | finished | position error mean, cm | worst seed | largest at any time, worst seed |"
          " cross-track RMS, cm | worst seed | diverged |")
    print("| --- " * 8 + "|")
    diverged = 0
    for kind, (name, _, _) in enumerate(floors.KINDS):
        good = [r for r in (results[(kind, seed)] for seed in seeds_of(arguments)) if "error" not in r]
        lost = sum(r["position_error_max_m"] > DIVERGED for r in good)
        diverged += lost
        figures = [f"{100 * pick(r[figure] for r in good):.2f}" if good else "–"
                   for figure, pick in (("position_error_mean_m", statistics.fmean), ("position_error_mean_m", max),
                                        ("position_error_max_m", max), ("cross_track_rms_m", statistics.fmean),
                                        ("cross_track_rms_m", max))]
        print(f"| {name} | {sum(r['finished'] for r in good)}/{arguments.seeds} | {' | '.join(figures)} | {lost} |")
    print(f"\nDiverged (an error above {100 * DIVERGED:.0f} cm at any time after the first place): {diverged} of"
          f" {len(results)} runs.")


def print_table(arguments, results):
    several = len(arguments.drive) > 1
    print("| m/s |" + (" vehicle |" if several else "") + " finished | position error mean, cm | worst seed |"
          " p95, worst seed | cross-track RMS, cm | worst seed | reversals | mean speed ratio, worst seed |")
    print("| --- " * (10 if several else 9) + "|")
    for speed in arguments.speeds:
        of_speed = [results[(speed, seed)] for seed in seeds_of(arguments)]
        for i in range(max(1, len(arguments.drive))):
            name = arguments.drive[i].split("=")[0] if several else ""
            print(row(speed, name, [r["vehicles"][i] if "vehicles" in r else None for r in of_speed]))
    channels = [r["channel"] for r in results.values() if "channel" in r]
    if channels:
        mean = {name: statistics.fmean(c[name] for c in channels) for name in channels[0]}
        print(f"\nAt the runs' ends, on average: {1000 * mean['cycle_s']:.0f} ms between two commands to a vehicle, answer"
              f" slots of {1000 * mean['slot_s']:.0f} ms, time on air {mean['air_factor']:.2f} times the formula's,"
              f" {1000 * mean['delay_s']:.0f} ms beside it each way.")


def parse():
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cli", type=pathlib.Path, default=root / "build/bin/tessera-cli")
    parser.add_argument("--site", type=pathlib.Path, default=root / "resources/sites/paper.tessera.json")
    parser.add_argument("--route", default="paper", help="route of the site's first vehicle")
    parser.add_argument("--drive", action="append", default=[], metavar="ID=ROUTE",
                        help="a vehicle and its route, instead of --route; may be repeated")
    parser.add_argument("--vehicle", choices=["qemu", "native"], default="qemu")
    parser.add_argument("--speeds", type=float, nargs="+", default=[0.05, 0.08, 0.12, 0.20], metavar="M_PER_S")
    parser.add_argument("--seeds", type=int, default=5, help="this many seeds")
    parser.add_argument("--first-seed", type=int, default=1, help="the first of them (default 1)")
    parser.add_argument("--jobs", type=int,
                        help="runs side by side; default: as many as cores, one less where they are in real time")
    parser.add_argument("--out", type=pathlib.Path, default=root / "out/experiments")
    parser.add_argument("--limits", action="store_true",
                        help="the table of limits: off corners and the end, and how honest the locator is")
    parser.add_argument("--floors", action="store_true",
                        help="on floors of many kinds, made from --site for each seed; at the first of --speeds")
    parser.add_argument("--baseline", action="store_true", help="runs that do not finish are no failure, only a result")
    parser.add_argument("extra", nargs="*", help="further options of `tessera-cli experiment`, after --")
    arguments = parser.parse_args()
    if arguments.jobs is None:
        cores = os.cpu_count() or 1
        arguments.jobs = cores if "--lockstep" in arguments.extra else max(1, cores - 1)
    if arguments.jobs < 1 or arguments.seeds < 1 or arguments.first_seed < 1:
        parser.error("--jobs, --seeds and --first-seed begin at 1")
    return arguments


def main():
    arguments = parse()
    firsts = range(len(floors.KINDS)) if arguments.floors else arguments.speeds
    cases = [(first, seed) for first in firsts for seed in seeds_of(arguments)]
    drive = run_on_floor if arguments.floors else run
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = dict(zip(cases, pool.map(lambda case: drive(arguments, *case), cases)))

    print(f"Machine: {cpu_model()}, {os.cpu_count()} cores; {arguments.jobs} runs side by side; vehicle {arguments.vehicle};"
          f" seeds {arguments.first_seed} to {arguments.first_seed + arguments.seeds - 1}; options: {' '.join(arguments.extra) or 'none'}\n")
    (print_floors if arguments.floors else print_limits if arguments.limits else print_table)(arguments, results)
    missing = [(case, r["error"]) for case, r in results.items() if "error" in r]
    for (speed, seed), error in missing:
        where = f"on floor {speed + 1}" if arguments.floors else f"at {speed:g} m/s"
        print(f"The run {where} with seed {seed} gave no summary: {error}", file=sys.stderr)
    troubled = sum(bool(r.get("world_complaints")) for r in results.values())
    if troubled:
        print(f"The machine did not keep step in {troubled} of {len(cases)} runs: this table is worth nothing. Take fewer"
              " --jobs.")
    late = sum(not r["finished"] for r in results.values() if "error" not in r)
    if late and not arguments.baseline:
        print(f"{late} of {len(cases)} runs did not reach the end of their routes.", file=sys.stderr)
    return 1 if missing or (late and not arguments.baseline) else 0


if __name__ == "__main__":
    sys.exit(main())
