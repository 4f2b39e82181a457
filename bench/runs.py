"""Runs of `tessera-cli experiment`, side by side, and what they found as one table runs.csv.

A setting is the options of one run by their names, {"air": "2400", "lockstep": None}; None stands for an option without
a value. Besides the program's own there are `site`, `floor` (the number of one of floors.KINDS) and `pitch` (m), with
which the site is made anew.
"""
import concurrent.futures
import csv
import json
import pathlib
import subprocess

import floors

OURS = ("site", "floor", "pitch")  # what the program is told otherwise than by an option of this name


def setting_of(words):
    """Of ["--air", "2400", "--lockstep"]. A name that comes again holds its last value, but --drive all of them."""
    setting, name = {}, None
    for word in words:
        if word.startswith("--"):
            name = word[2:]
            setting[name] = setting.get(name) if name == "drive" else None
        elif name is None:
            raise ValueError(f"{word} follows no option")
        else:
            setting[name] = f"{setting[name]} {word}" if setting[name] else word
            name = None
    return setting


def words_of(setting):
    for name, value in setting.items():
        if name in OURS:
            continue
        for one in value.split() if name == "drive" else [value]:
            yield f"--{name}"
            if one is not None:
                yield one


def site_for(setting, seed, out):
    """The site of a run, made anew where its floor is to be another; and the setting that goes with it."""
    site = pathlib.Path(setting["site"])
    if "floor" not in setting and "pitch" not in setting:
        return site, setting
    if "floor" in setting and "pitch" in setting:
        raise ValueError("a floor of floors.py has the pitch that it has")
    made = out / "floor.tessera.json"
    if "pitch" in setting:
        made.write_text(json.dumps(floors.at_pitch(floors.load(site), float(setting["pitch"]))), encoding="utf-8")
        return made, setting
    extra = floors.write(floors.load(site), int(setting["floor"]), seed, made)
    return made, {**setting, "route": floors.ROUTE, **setting_of(extra)}


def run(cli, setting, seed, out):
    """The figures of one run, or {"error": why there are none}."""
    out.mkdir(parents=True, exist_ok=True)
    summary = out / "summary.json"
    summary.unlink(missing_ok=True)  # an earlier run's figures are not this one's
    try:
        site, setting = site_for(setting, seed, out)
    except ValueError as error:
        return {"error": str(error)}
    command = [str(cli), "experiment", str(site), *words_of(setting), "--seed", str(seed), "--out", str(out), "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if not summary.exists():
        return {"error": (done.stderr or done.stdout).strip()}
    figures = json.loads(summary.read_text(encoding="utf-8"))
    if any(vehicle["samples"] == 0 for vehicle in figures["vehicles"]):
        return {"error": "a vehicle never drove, so nothing was measured"}
    return figures


def run_all(cli, cases, jobs):
    """Of each (setting, seed, folder) its figures, in the same order."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(lambda case: run(cli, *case), cases))


def lines_of(case, figures, home):
    """One line of runs.csv a vehicle: where the run lies, its options, its figures; or why there are none."""
    setting, seed, folder = case
    asked = {name: value if value is not None else True for name, value in setting.items()}
    head = {"folder": folder.relative_to(home).as_posix(), **{f"asked_{name}": value for name, value in asked.items()}}
    if "error" in figures:
        yield {**head, "seed": seed, "error": figures["error"]}
        return
    options = {**figures["options"], "world_arguments": " ".join(figures["options"]["world_arguments"])}
    common = {f"{group}_{name}": value for group in ("channel", "carried") for name, value in figures.get(group, {}).items()}
    common |= {"events": len(figures["events"]), "world_complaints": len(figures["world_complaints"])}
    for vehicle in figures["vehicles"]:
        track = "track.csv" if len(figures["vehicles"]) == 1 else f"track-{vehicle['vehicle']}.csv"
        # What the vehicle is called is not what kind it is of.
        named = {"address" if name == "vehicle" else name: value for name, value in vehicle.items()}
        yield {**head, "track": track, **options, **named, **common}


def write_csv(path, cases, results):
    """Columns are all names there are; a cell is empty where a run has none of it."""
    lines = [line for case, figures in zip(cases, results) for line in lines_of(case, figures, path.parent)]
    names = list(dict.fromkeys(name for line in lines for name in line))
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, names)
        writer.writeheader()
        writer.writerows(lines)
