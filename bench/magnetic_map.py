#!/usr/bin/env python3
"""What a magnetic map of the floor is worth: prints the table of docs/decisions/0016-magnetic-map.md.

For each seed a floor with its own iron. A drive is judged without a map; as the first on its floor with one, which learns
as it goes; and with what one or more drives of other vehicles (other seeds: other noise, mounting and calibration of the
compass) have learned before. All are the same drive but for the map.
"""
import argparse
import concurrent.futures
import json
import pathlib
import statistics
import subprocess
import sys


def parse():
    root = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cli", type=pathlib.Path, default=root / "build/bin/tessera-cli")
    parser.add_argument("--site", type=pathlib.Path, default=root / "resources/sites/paper.tessera.json")
    parser.add_argument("--route", default="paper")
    parser.add_argument("--speeds", type=float, nargs="+", default=[0.12, 0.5])
    parser.add_argument("--spots", type=float, nargs="+", default=[10, 20])
    parser.add_argument("--before", type=int, nargs="+", default=[0, 1, 4], help="drives that learned before")
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out", type=pathlib.Path, default=root / "out/magnetic-map")
    parser.add_argument("extra", nargs="*", help="further options of `tessera-cli experiment`, after --")
    return parser.parse_args()


def drive(arguments, speed, spots, floor, seed, folder, magnetic=None):
    words = [str(arguments.cli), "experiment", str(arguments.site), "--route", arguments.route, "--speed", f"{speed:g}",
             "--vehicle", "native", "--lockstep", "--quiet", "--seed", str(seed), "--floor-seed", str(floor),
             "--compass-spots", f"{spots:g}", "--out", str(folder), *arguments.extra]
    if magnetic:
        words += ["--magnetic-map", str(magnetic)]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    summary = folder / "summary.json"
    if not summary.exists():
        raise RuntimeError((done.stderr or done.stdout).strip())
    return json.loads(summary.read_text())["vehicles"][0]


def course(arguments, speed, spots, seed):
    """The judged drive of one seed: without a map, and after so many drives before it."""
    folder = arguments.out / f"{speed:g}-{spots:g}-{seed}"
    folder.mkdir(parents=True, exist_ok=True)
    found = {"none": drive(arguments, speed, spots, seed, seed, folder / "none")}
    learned = folder / "learned.map"
    learned.unlink(missing_ok=True)
    for before in range(max(arguments.before) + 1):
        if before in arguments.before:
            copy = folder / "judged.map"
            copy.unlink(missing_ok=True)
            if learned.exists():
                copy.write_bytes(learned.read_bytes())
            found[before] = drive(arguments, speed, spots, seed, seed, folder / f"after-{before}", copy)
        if before < max(arguments.before):
            drive(arguments, speed, spots, seed, 10000 + 100 * seed + before, folder / "learning", learned)
    return found


def row(name, figures, base):
    def of(key, scale):
        return [scale * f[key] for f in figures]
    place, heading = of("position_error_mean_m", 100), of("heading_error_rms_rad", 57.29578)
    cross = of("cross_track_rms_off_corners_m", 100)
    gain = [a - b for a, b in zip(place, [100 * f["position_error_mean_m"] for f in base])]
    error = statistics.stdev(gain) / len(gain) ** 0.5 if len(gain) > 1 else 0.0
    return (f"| {name} | {statistics.fmean(place):.2f} | {max(place):.2f} | {statistics.fmean(gain):+.3f} ± {error:.3f} "
            f"| {statistics.fmean(heading):.2f} | {max(heading):.2f} | {statistics.fmean(cross):.2f} "
            f"| {statistics.fmean(f['nees_mean'] for f in figures):.2f} | {sum(f['finished'] for f in figures)}/{len(figures)} |")


def main():
    arguments = parse()
    seeds = range(arguments.first_seed, arguments.first_seed + arguments.seeds)
    print("| m/s, iron, map | place, mean, cm | worst seed | against none | heading, RMS, ° | worst seed |"
          " across off corners, cm | NEES | finished |\n" + "| --- " * 9 + "|")
    for speed in arguments.speeds:
        for spots in arguments.spots:
            with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
                found = list(pool.map(lambda seed: course(arguments, speed, spots, seed), seeds))
            base = [f["none"] for f in found]
            print(row(f"{speed:g}, {spots:g}°, none", base, base))
            for before in arguments.before:
                print(row(f"{speed:g}, {spots:g}°, after {before}", [f[before] for f in found], base), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
