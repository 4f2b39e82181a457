#!/usr/bin/env python3
"""Tries the helpers of ./dev: counting ctest's results and choosing the files for clang-tidy."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
import tidy  # noqa: E402


class CountJunit(unittest.TestCase):
    CASES = {
        "good": '<testcase name="good" status="run"><system-out/></testcase>',
        "bad": '<testcase name="bad" status="fail"><failure message=""/><system-out>why\n</system-out></testcase>',
        "gone": '<testcase name="gone" status="notrun"><skipped message="Unable to find executable"/></testcase>',
        "left": '<testcase name="left" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/></testcase>',
        "off": '<testcase name="off" status="disabled"><disabled message=""/></testcase>',
    }

    def run_on(self, names, *options):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write("<testsuite>" + "".join(self.CASES[name] for name in names.split()) + "</testsuite>")
            file.flush()
            tool = [sys.executable, str(HERE / "count_junit.py"), file.name, *options]
            return subprocess.run(tool, capture_output=True, text=True)

    def test_counts_passed_failed_and_skipped(self):
        done = self.run_on("good bad good left off good")
        self.assertEqual((done.returncode, done.stdout), (0, "3 1 2\n"))

    def test_a_test_whose_program_is_missing_has_failed(self):
        self.assertEqual(self.run_on("good gone").stdout, "1 1 0\n")

    def test_a_run_without_tests_is_an_error(self):
        for names in ("", "left"):
            self.assertNotEqual(self.run_on(names).returncode, 0, names)

    def test_a_file_that_is_missing_or_no_junit_is_an_error(self):
        for path in ("/nonexistent.xml", str(HERE / "tools_test.py")):
            tool = [sys.executable, str(HERE / "count_junit.py"), path]
            self.assertNotEqual(subprocess.run(tool, capture_output=True).returncode, 0, path)

    def test_failures_are_told_with_what_they_printed(self):
        done = self.run_on("good bad gone", "--failures")
        self.assertIn("bad failed; the end of what it printed:\n      why\n", done.stdout)
        self.assertIn("gone failed", done.stdout)

    def test_names_are_those_of_the_failed(self):
        self.assertEqual(self.run_on("good bad left gone", "--names").stdout, "bad\ngone\n")
        self.assertEqual(self.run_on("good", "--names").stdout, "")


class RefuseWords(unittest.TestCase):
    CALLS = ["build tessera", "setup now", "bench --fast", "test --quick", "test --fast more", "lint some",
             "lint --all more", "fly"]

    def test_a_word_that_would_be_passed_over_is_a_wrong_call(self):
        # A copy in an empty folder, where nothing is missing: what is not refused soon fails instead of building.
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(HERE.parent.parent / "dev", folder)
            stub = Path(folder) / "dpkg-query"
            stub.write_text("#!/bin/sh\nprintf installed\n")
            stub.chmod(0o755)
            environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "HOME": folder}
            for call in self.CALLS:
                done = subprocess.run([f"{folder}/dev", *call.split()], capture_output=True, text=True, env=environment)
                self.assertEqual(done.returncode, 2, call)
                self.assertIn(call.split()[-1], done.stderr)


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
