#!/usr/bin/env python3
"""Tries the helpers of ./dev: counting ctest's results and choosing the files for clang-tidy."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
import count_junit  # noqa: E402
import tidy  # noqa: E402


class CountJunit(unittest.TestCase):
    def run_on(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write(text)
            file.flush()
            return subprocess.run([sys.executable, str(HERE / "count_junit.py"), file.name], capture_output=True, text=True)

    def test_counts_passed_failed_and_skipped(self):
        done = self.run_on('<testsuite tests="10" failures="2" disabled="1" skipped="3"/>')
        self.assertEqual((done.returncode, done.stdout), (0, "4 2 4\n"))

    def test_a_run_without_tests_is_an_error(self):
        for text in ('<testsuite tests="0" failures="0"/>', "", "<testsuite/>", '<testsuite tests="1" failures="0" skipped="1"/>'):
            self.assertNotEqual(self.run_on(text).returncode, 0, text)

    def test_a_missing_file_is_an_error(self):
        with self.assertRaises(OSError):
            count_junit.counts("/nonexistent.xml")


class ChooseForTidy(unittest.TestCase):
    FILES = {"core/a/x.cpp": '#include "a/x.h"\n', "core/b/y.cpp": '#include "a/x.h"\n', "core/b/z.cpp": ""}

    def choose(self, everything=False, changed=None, history=()):
        return tidy.choose(list(self.FILES), everything, changed, list(history), self.FILES.get)

    def test_changed_sources_are_checked_whatever_the_time(self):
        self.assertEqual(self.choose(changed=["core/b/z.cpp", "README.md"]), (["core/b/z.cpp"], []))

    def test_a_changed_header_brings_the_sources_that_include_it(self):
        self.assertEqual(self.choose(changed=["core/a/x.h"]), (["core/a/x.cpp", "core/b/y.cpp"], []))

    def test_without_changes_the_newest_come_first(self):
        must, maybe = self.choose(changed=[], history=["core/b/z.cpp", "gone.cpp"])
        self.assertEqual((must, maybe), ([], ["core/b/z.cpp", "core/a/x.cpp", "core/b/y.cpp"]))

    def test_without_git_all_may_be_checked(self):
        self.assertEqual(self.choose(changed=None), ([], list(self.FILES)))

    def test_all_means_all(self):
        self.assertEqual(self.choose(everything=True), (list(self.FILES), []))


if __name__ == "__main__":
    unittest.main()
