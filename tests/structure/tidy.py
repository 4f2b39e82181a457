#!/usr/bin/env python3
"""Runs clang-tidy on changed files, or on all of them.

Changed means: different from origin/main, uncommitted ones included, and the sources that include a changed header
directly; they are always checked, and a finding in them is a failure. Where nothing differs from origin/main (a fresh
clone), the files changed last are taken, newest first, for as long as the time limit allows; how many those are depends on
the machine, so their findings are told and fail nothing. Ends with a line that says how many of how many were checked."""
import argparse
import concurrent.futures
import json
import re
import subprocess
import sys
import time
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def git(*arguments):
    """Output lines of git, or None when there is no git or no such revision."""
    try:
        done = subprocess.run(["git", "-c", "safe.directory=*", *arguments], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return done.stdout.split("\n")[:-1]


def changed_files():
    """Files that differ from origin/main; None when that is unknown."""
    base = git("merge-base", "HEAD", "origin/main")
    if not base:
        return None
    committed = git("diff", "--name-only", base[0]) or []
    untracked = git("ls-files", "--others", "--exclude-standard") or []
    return committed + untracked


def newest_first():
    """All files in the order of their last change, as far as the history reaches."""
    seen = {}
    for line in git("log", "--format=", "--name-only", "-n", "300") or []:
        if line:
            seen.setdefault(line, None)
    return list(seen)


def sources_for(changed, sources, read):
    """The sources among `changed`, then those that include a changed header, in that order."""
    picked = [name for name in changed if name in sources]
    headers = [name for name in changed if name.endswith(".h")]
    for source in sources:
        included = INCLUDE.findall(read(source))
        if any(h == i or h.endswith("/" + i) for h in headers for i in included) and source not in picked:
            picked.append(source)
    return picked


def choose(sources, everything, changed, history, read):
    """(files that must be checked, files to check while time is left)."""
    if everything:
        return list(sources), []
    must = sources_for(changed, sources, read) if changed else []
    if must:
        return must, []
    ordered = [name for name in history if name in sources]
    return [], ordered + [name for name in sources if name not in ordered]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", default="build", help="folder with compile_commands.json")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=240, help="limit for files that did not change")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--clang-tidy", default="clang-tidy-19")
    options = parser.parse_args()

    root = Path.cwd()
    commands = json.loads(Path(options.build, "compile_commands.json").read_text())
    files = sorted({Path(c["directory"], c["file"]).resolve() for c in commands})
    sources = [f.relative_to(root).as_posix() for f in files if f.is_relative_to(root)]
    sources = [s for s in sources if s.split("/")[0] in ("app", "bench", "core", "firmware", "tests", "ui")]
    must, maybe = choose(sources, options.all, changed_files(), newest_first(), lambda s: Path(s).read_text())

    end = time.monotonic() + options.seconds

    def check(source, limited):
        if limited and time.monotonic() > end:
            return None
        # The static analyser takes as long as all else together: it is for changed files and for --all.
        less = ["--checks=-clang-analyzer-*"] if limited else []
        done = subprocess.run([options.clang_tidy, "-quiet", *less, "-p", options.build, source], capture_output=True, text=True)
        return done.returncode, done.stdout + (done.stderr if done.returncode else "")

    checked, failed, told = 0, 0, 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        runs = [pool.submit(check, s, False) for s in must] + [pool.submit(check, s, True) for s in maybe]
        for number, run in enumerate(runs):
            if (result := run.result()) is None:
                continue
            checked += 1
            if result[0] != 0:
                failed += 1 if options.all or number < len(must) else 0
                told += 1
                print(result[1], flush=True)
    print(f"checked {checked} of {len(sources)} files with clang-tidy ({len(must)} of them because they changed): "
          f"{told} with findings, {failed} of which count")
    sys.exit(1 if failed or not sources else 0)


if __name__ == "__main__":
    main()
