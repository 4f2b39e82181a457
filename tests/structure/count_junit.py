#!/usr/bin/env python3
"""Prints 'PASSED FAILED SKIPPED' of a JUnit file written by ctest; exit code 1 when it is missing or says nothing."""
import sys
import xml.etree.ElementTree as ElementTree


def counts(path):
    suite = ElementTree.parse(path).getroot()
    total, failed = int(suite.get("tests")), int(suite.get("failures"))
    skipped = int(suite.get("skipped", 0)) + int(suite.get("disabled", 0))
    return total - failed - skipped, failed, skipped


if __name__ == "__main__":
    try:
        passed, failed, skipped = counts(sys.argv[1])
    except (OSError, ElementTree.ParseError, TypeError, ValueError) as error:
        sys.exit(f"count_junit: no counts in {sys.argv[1]}: {error}")
    if passed + failed == 0:
        sys.exit(f"count_junit: {sys.argv[1]} lists no test that ran")
    print(passed, failed, skipped)
