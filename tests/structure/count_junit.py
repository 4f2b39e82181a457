#!/usr/bin/env python3
"""Reads a JUnit file written by ctest. Prints 'PASSED FAILED SKIPPED'; with --failures, the failed tests' names and the end of
what each of them printed; with --names, the names alone. Exit code 1 when the file is missing or says nothing."""
import sys
import xml.etree.ElementTree as ElementTree

LINES_SHOWN = 40


def cases(path):
    return list(ElementTree.parse(path).getroot().iter("testcase"))


def outcome(case):
    """'passed', 'failed' or 'skipped'. ctest says 'notrun' of a test that skipped itself and of one whose program is missing."""
    status = case.get("status")
    if status == "run":
        return "passed"
    said_so = case.find("skipped") is not None and case.find("skipped").get("message", "").startswith("SKIP_")
    return "skipped" if status == "disabled" or said_so else "failed"


def counts(path):
    outcomes = [outcome(case) for case in cases(path)]
    return tuple(outcomes.count(which) for which in ("passed", "failed", "skipped"))


def failures(path):
    """The failed tests as (name, what it printed), in the order of the file."""
    return [(case.get("name"), case.findtext("system-out") or "") for case in cases(path) if outcome(case) == "failed"]


def main(path, what=None):
    if what == "--names":
        for name, _ in failures(path):
            print(name)
        return
    if what == "--failures":
        for name, printed in failures(path):
            print(f"    {name} failed; the end of what it printed:")
            print(*("      " + line for line in printed.rstrip().splitlines()[-LINES_SHOWN:]), sep="\n")
        return
    passed, failed, skipped = counts(path)
    if passed + failed == 0:
        sys.exit(f"count_junit: {path} lists no test that ran")
    print(passed, failed, skipped)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except (OSError, ElementTree.ParseError, TypeError, ValueError) as error:
        sys.exit(f"count_junit: no counts in {sys.argv[1:]}: {error}")
