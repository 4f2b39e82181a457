#!/usr/bin/env python3
"""Runs the reference experiment over speeds and seeds and prints the table of docs/experiments.md.

Every run is one call of `tessera-cli experiment`; its folder keeps summary.json, track.csv and track.png.
Runs go side by side as far as --jobs allows: a run waits for its radio most of the time.
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


def run(arguments, speed, seed):
    out = arguments.out / f"{arguments.vehicle}-{speed:g}-{seed}"
    command = [str(arguments.cli), "experiment", str(arguments.site), "--route", arguments.route, "--speed", f"{speed:g}",
               "--vehicle", arguments.vehicle, "--seed", str(seed), "--out", str(out), "--quiet", *arguments.extra]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    summary = out / "summary.json"
    if not summary.exists():
        return {"error": (done.stderr or done.stdout).strip()}
    return json.loads(summary.read_text())


def row(speed, results):
    good = [r["vehicles"][0] for r in results if "error" not in r]
    if not good:
        return f"| {speed:.2f} | 0/{len(results)} | – | – | – | – | – | – | – |"

    def centimetres(name, pick):
        return f"{100 * pick(v[name] for v in good):.2f}"

    mean = lambda values: statistics.fmean(values)  # noqa: E731
    return (f"| {speed:.2f} | {sum(v['finished'] for v in good)}/{len(results)} "
            f"| {centimetres('position_error_mean_m', mean)} | {centimetres('position_error_mean_m', max)} "
            f"| {centimetres('position_error_p95_m', max)} "
            f"| {centimetres('cross_track_rms_m', mean)} | {centimetres('cross_track_rms_m', max)} "
            f"| {sum(v['reversals'] for v in good)} | {min(v['mean_speed_ratio'] for v in good):.2f} |")


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cli", type=pathlib.Path, default=root / "build/bin/tessera-cli")
    parser.add_argument("--site", type=pathlib.Path, default=root / "resources/sites/paper.tessera.json")
    parser.add_argument("--route", default="paper")
    parser.add_argument("--vehicle", choices=["qemu", "native"], default="qemu")
    parser.add_argument("--speeds", type=float, nargs="+", default=[0.05, 0.08, 0.12, 0.20], metavar="M_PER_S")
    parser.add_argument("--seeds", type=int, default=5, help="seeds 1 to this many")
    parser.add_argument("--jobs", type=int, default=4, help="runs side by side")
    parser.add_argument("--out", type=pathlib.Path, default=root / "out/experiments")
    parser.add_argument("extra", nargs="*", help="further options of `tessera-cli experiment`, after --")
    arguments = parser.parse_args()

    cases = [(speed, seed) for speed in arguments.speeds for seed in range(1, arguments.seeds + 1)]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = dict(zip(cases, pool.map(lambda case: run(arguments, *case), cases)))

    print(f"Machine: {platform.machine()}, {os.cpu_count()} cores; vehicle {arguments.vehicle}; seeds 1 to {arguments.seeds};"
          f" options: {' '.join(arguments.extra) or 'none'}\n")
    print("| m/s | finished | position error mean, cm | worst seed | p95, worst seed | cross-track RMS, cm | worst seed"
          " | reversals | mean speed ratio, worst seed |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for speed in arguments.speeds:
        print(row(speed, [results[(speed, seed)] for seed in range(1, arguments.seeds + 1)]))
    failed = [(case, r["error"]) for case, r in results.items() if "error" in r]
    for case, error in failed:
        print(f"run {case} gave no summary: {error}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
