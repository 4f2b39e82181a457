#!/usr/bin/env python3
"""Runs what stands behind the tables of docs/experiments.md and prints them as they stand there, then draws its charts.

  real      firmware in QEMU, in real time: some twenty-five minutes
  lockstep  native vehicles in virtual time: some 5300 runs, 10 to 20 minutes on two cores
Without a second word: both. Results lie in out/experiments, a folder a table: runs.csv and a folder a run. Exit code 1
when runs did not finish where they should have, 2 for a wrong command line.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys

import documented
import experiments
import tables

ROOT = experiments.ROOT


def place_of(lines, name):
    """First and last + 1 of the document's lines that are this table. ValueError: it has none, or several."""
    marker = f"<!-- table: {name} -->"
    if lines.count(marker) != 1:
        raise ValueError(f"the document has not one line {marker}")
    first = lines.index(marker) + 1
    last = first
    while last < len(lines) and lines[last].startswith("|"):
        last += 1
    return first, last


def put_into(document, name, table):
    """What follows `<!-- table: NAME -->` becomes these lines."""
    lines = document.read_text(encoding="utf-8").split("\n")
    first, last = place_of(lines, name)
    document.write_text("\n".join(lines[:first] + table + lines[last:]), encoding="utf-8")


def unicycle(programs):
    """Its table comes from a program of its own; None where that is not built."""
    if not (programs / "bench_drive").exists():
        print("bench_drive is not built here; ./dev bench builds it", file=sys.stderr)
        return None
    done = subprocess.run([programs / "bench_drive"], capture_output=True, text=True, check=True)
    return [line for line in done.stdout.splitlines() if line.startswith("|")]


def draw(programs, out, pictures):
    """The charts of all tables that were taken. pictures: where the document's are kept, None for nowhere."""
    fine = True
    for folder, names, column, kept in documented.CHARTS:
        found = [out / name / "runs.csv" for name in names if (out / name / "runs.csv").exists()]
        if len(found) < len(names):
            continue
        to = out / "charts" / folder
        done = subprocess.run([programs / "tessera-cli", "charts", *found, "--by", column, "--out", to], check=False)
        fine = fine and done.returncode == 0
        for picture, name in kept.items() if pictures and done.returncode == 0 else ():
            shutil.copyfile(to / picture, pictures / name)
    for picture, name in documented.TRACKS.items() if pictures else ():
        if (out / picture).exists():
            shutil.copyfile(out / picture, pictures / name)
    return fine


def parse(words=None):
    parser = argparse.ArgumentParser(prog="bench/experiments.sh", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, metavar="FOLDER-OF-PROGRAMS")
    parser.add_argument("part", nargs="?", choices=["real", "lockstep", "all"], default="all")
    parser.add_argument("--only", action="append", metavar="NAME", help="one table, by its name; may be repeated")
    parser.add_argument("--into", type=pathlib.Path, metavar="FILE",
                        help="put each table into this document, and charts into the folder pictures beside it")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/experiments")
    arguments = parser.parse_args(words)
    names = [table.name for table in documented.TABLES] + ["unicycle"]
    for name in arguments.only or ():
        if name not in names:
            parser.error(f"there is no table {name}; there are {', '.join(names)}")
    if not (arguments.programs / "tessera-cli").is_file():
        parser.error(f"there is no tessera-cli in {arguments.programs}; ./dev build makes it")
    return arguments


def main():
    arguments = parse()
    programs, out = arguments.programs.resolve(), arguments.out.resolve()
    failed = False

    def wanted(name, part):
        return arguments.part in ("all", part) and name in (arguments.only or [name])

    chosen = [table for table in documented.TABLES if wanted(table.name, "lockstep" if table.lockstep() else "real")]
    cycle = wanted("unicycle", "lockstep")
    for name in [table.name for table in chosen] + ["unicycle"] * cycle if arguments.into else ():
        place_of(arguments.into.read_text(encoding="utf-8").split("\n"), name)  # said before hours of runs, not after

    def give(name, title, lines):
        print(f"\n== {title} ({name})\n\n" + "\n".join(lines), flush=True)
        if arguments.into:
            put_into(arguments.into, name, lines)

    print(f"Machine: {experiments.machine()}")
    for table in chosen:
        jobs = table.jobs or experiments.jobs_for(table.lockstep())
        cases = tables.measure(programs / "tessera-cli", list(table.drives(ROOT / "resources/sites")), out / table.name, jobs)
        give(table.name, table.title, [*table.head(), *tables.rows(cases, table.kind)])
        for note in tables.notes([r for _, results in cases for r in results]):
            print("\n" + note, flush=True)
        failed = experiments.complain(cases, table.baseline) or failed
    if cycle:
        lines = unicycle(programs)
        failed = failed or lines is None
        if lines:
            give("unicycle", "Controllers on a unicycle without radio", lines)
    drawn = draw(programs, out, arguments.into and arguments.into.parent / "pictures")
    return 1 if failed or not drawn else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        sys.exit(f"experiments.sh: {error}")
