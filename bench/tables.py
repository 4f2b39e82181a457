"""The tables of docs/experiments.md: what their columns are called, and how a row of runs is told in them.

A table's kind has the heads of its columns and a function that makes their cells of a row's runs. Lengths are in
centimetres; a run that gave no figures counts as not finished and is left out of all else.
"""
import pathlib
import re
import statistics

import floors
import runs
import split_errors

mean = statistics.fmean


def cm(figures, name, pick):
    return f"{100 * pick([f[name] for f in figures]):.2f}"


def finished(figures, of):
    return f"{sum(f['finished'] for f in figures)}/{of}"


def honesty(figures):
    return [f"{mean([f['nees_mean'] for f in figures]):.2f}", f"{sum(f['consistent'] for f in figures)}/{len(figures)}"]


def drive(figures, of):
    return [finished(figures, of), cm(figures, "position_error_mean_m", mean), cm(figures, "position_error_mean_m", max),
            cm(figures, "position_error_p95_m", max), cm(figures, "cross_track_rms_m", mean),
            cm(figures, "cross_track_rms_m", max), f"{sum(f['reversals'] for f in figures)}",
            f"{min(f['mean_speed_ratio'] for f in figures):.2f}"]


def limits(figures, of):
    return [finished(figures, of), cm(figures, "position_error_mean_m", mean), cm(figures, "position_error_mean_m", max),
            cm(figures, "cross_track_rms_off_corners_m", mean), cm(figures, "cross_track_max_off_corners_m", max),
            cm(figures, "end_error_m", max), f"{sum(f['reversals'] for f in figures)}",
            *honesty(figures), f"{mean([f['mean_speed_ratio'] for f in figures]):.2f}", f"{min(f['mean_speed_ratio'] for f in figures):.2f}"]


def floor(figures, of):
    return [finished(figures, of), cm(figures, "position_error_mean_m", mean), cm(figures, "position_error_mean_m", max),
            cm(figures, "position_error_max_m", max), cm(figures, "cross_track_rms_m", mean),
            cm(figures, "cross_track_rms_m", max), *honesty(figures),
            f"{sum(f['position_error_max_m'] > DIVERGED for f in figures)}"]


def carried(figures, of):
    lifted = [f["carried"] for f in figures if "carried" in f]
    ways = [c["found_after_m"] for c in lifted if c["found"]]
    if not ways:
        return [f"0/{of}"] + ["–"] * 5
    sure = [c["wrongly_sure_s"] for c in lifted]
    return [f"{len(ways)}/{of}", f"{mean(ways):.2f}", f"{max(ways):.2f}", f"{sum(w <= 1.0 for w in ways)}/{of}",
            f"{mean(sure):.1f}", f"{max(sure):.1f}"]


def split(figures, of):
    line = split_errors.line_of(pathlib.Path(figures[0]["options"]["site"]))
    found = split_errors.Split([split_errors.split(f["folder"] / "track.csv", line) for f in figures])
    largest = max(f["cross_track_max_off_corners_m"] for f in figures)
    return [found.across(), f"{100 * largest:.2f}", found.end(0), found.end(1), f"{found.within(0.01)}/{of}",
            f"{100 * found.worst():.2f}"]


DIVERGED = 0.5  # m: with an error of more than this, at any time after its first place, a locator has diverged
KINDS = {
    "drive": (drive, "finished | position error mean, cm | worst seed | p95, worst seed | cross-track RMS, cm | worst seed |"
                     " reversals | mean speed ratio, worst seed"),
    "limits": (limits, "finished | position error mean, cm | worst seed | cross-track RMS off corners, cm |"
                       " largest, worst seed | off the end, worst seed | reversals | NEES (2 is honest) |"
                       " consistent runs | mean speed ratio | worst seed"),
    "floor": (floor, "finished | position error mean, cm | worst seed | largest at any time, worst seed |"
                     " cross-track RMS, cm | worst seed | NEES (2 is honest) | consistent runs | diverged"),
    "carried": (carried, "found again | after, m | the longest way, m | within 1 m | sure of a wrong place, s | the longest, s"),
    "split": (split, "across, off corners | largest true | along, at the end | across, at the end | within 1 cm of the end |"
                     " worst"),
}
FLOORS = [(name, str(number)) for number, (name, _, _) in enumerate(floors.KINDS)]


def head(keys, kind):
    """The two lines over a table with these columns of keys."""
    columns = [*keys, *KINDS[kind][1].split(" | ")]
    return [f"| {' | '.join(columns)} |", "| --- " * len(columns) + "|"]


def row(keys, kind, results):
    """One line: its keys, and its runs' figures. results: of its seeds, with `error` where a run gave none."""
    good = [figures for figures in results if "error" not in figures]
    make, names = KINDS[kind]
    cells = make(good, len(results)) if good else [f"0/{len(results)}"] + ["–"] * names.count(" | ")
    return f"| {' | '.join([*keys, *cells])} |"


def rows(cases, kind):
    """Of [(keys, results)] the lines; a run of several vehicles, in the kind `drive`, gives one each."""
    for keys, results in cases:
        names = next((r["vehicles"] for r in results if "error" not in r), [])
        if kind != "drive" or len(names) < 2:
            yield row(keys, kind, results)
            continue
        for i, vehicle in enumerate(names):
            yield row([*keys, f"{vehicle['vehicle']}"], kind, [r if "error" in r else r["vehicles"][i] for r in results])


def notes(results):
    """What stands below a table on the terminal."""
    channels = [r["channel"] for r in results if "channel" in r]
    # Of radios that differ the average says nothing.
    radios = {tuple(r["options"].get(n) for n in ("air_rate_bit_per_s", "air_factor", "delay_s")) for r in results if "options" in r}
    if channels and len(radios) == 1:
        at = {name: mean([c[name] for c in channels]) for name in channels[0]}
        yield (f"At the runs' ends, on average: {1000 * at['cycle_s']:.0f} ms between two commands to a vehicle, answer slots"
               f" of {1000 * at['slot_s']:.0f} ms, time on air {at['air_factor']:.2f} times the formula's, {1000 * at.get('delay_s', 0.0):.0f} ms"
               " beside it each way.")
    troubled = sum(bool(r.get("world_complaints")) for r in results)
    if troubled:
        yield (f"The machine did not keep step in {troubled} of {len(results)} runs: this table is worth nothing. Take fewer"
               " --jobs.")


def measure(cli, rows_of, home, jobs):
    """Drives what a table's rows ask for. rows_of: [(keys, [(setting, seed)])]. Leaves runs.csv in the folder `home`.
    Returns [(keys, results)]."""
    cases = []
    for number, (keys, drives) in enumerate(rows_of, 1):
        name = re.sub(r"[^\w.]+", "-", " ".join([f"{number:02}", *keys])).strip("-")[:60]
        cases += [(setting, seed, home / name / f"{seed}") for setting, seed in drives]
    results = runs.run_all(cli, cases, jobs)
    for case, figures in zip(cases, results):
        figures["folder"] = case[2]
    runs.write_csv(home / "runs.csv", cases, results)
    of = iter(results)
    return [(keys, [next(of) for _ in drives]) for keys, drives in rows_of]
