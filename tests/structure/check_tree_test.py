#!/usr/bin/env python3
"""Tries check_tree.py on small trees, each with one fault that it must find."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.dont_write_bytecode = True
import check_tree  # noqa: E402

PLAN = """| folder | is | knows |
| --- | --- | --- |
| `core/base` | units | nothing |
| `core/wire` | frames | base |
| `core/floor` | tags | base |
| `core/drive` | routes | floor |
| `core/host` | edge | drive |
| `firmware/vehicle` | vehicle | wire |
"""
GOOD = {
    "docs/architecture.md": PLAN,
    "core/base/CMakeLists.txt": "tessera_library(base SOURCES pose.cpp LIBS Eigen3::Eigen)",
    "core/base/pose.h": "#pragma once\n",
    "core/base/pose.cpp": '#include "base/pose.h"\n#include <vector>\n',
    "core/wire/CMakeLists.txt": "tessera_library(wire SOURCES frame.cpp DEPS base)",
    "core/wire/frame.h": "#pragma once\n",
    "core/wire/frame.cpp": '#include "wire/frame.h"\n// a std::vector would be too much here; so would sleep()\n',
    "core/floor/CMakeLists.txt": "tessera_library(floor DEPS base)",
    "core/floor/tag.h": '#pragma once\n#include "base/pose.h"\n',
    "core/drive/CMakeLists.txt": "tessera_library(drive SOURCES route.cpp\n  DEPS floor)",
    "core/drive/route.cpp": '#include "floor/tag.h"\n#include "base/pose.h"\nauto s = "std::thread";\n',
    "core/host/CMakeLists.txt": "tessera_library(host SOURCES port.cpp DEPS drive LIBS Qt6::SerialPort)",
    "core/host/port.cpp": "#include <QSerialPort>\n#include <thread>\n",
}


class CheckTree(unittest.TestCase):
    def problems(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**GOOD, **changes.get("files", {})}.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check_tree.Tree(Path(folder).resolve()).check()

    def assert_found(self, name, text, *words):
        problems = self.problems(files={name: text})
        self.assertEqual(len(problems), 1, problems)
        for word in (name, *words):
            self.assertIn(word, problems[0])

    def test_a_good_tree_has_no_problems(self):
        self.assertEqual(self.problems(), [])

    def test_an_include_against_the_arrows_is_found(self):
        self.assert_found("core/base/pose.cpp", '\n#include "floor/tag.h"\n', ":2:", "core/base may not know core/floor")

    def test_an_include_between_neighbours_is_found(self):
        self.assert_found("core/wire/frame.cpp", '#include "core/floor/tag.h"\n', "may not know core/floor")

    def test_a_relative_include_is_no_way_round(self):
        self.assert_found("core/wire/frame.cpp", '#include "../floor/tag.h"\n', "may not know core/floor")

    def test_an_allowed_include_needs_its_deps(self):
        problems = self.problems(files={"core/floor/CMakeLists.txt": "tessera_library(floor)"})
        self.assertTrue(any("the DEPS of core/floor do not lead to core/base" in p for p in problems), problems)

    def test_deps_against_the_plan_are_found(self):
        problems = self.problems(files={"core/wire/CMakeLists.txt": "tessera_library(wire SOURCES frame.cpp DEPS base drive)"})
        self.assertEqual(len(problems), 1, problems)
        self.assertIn("core/wire may not know core/drive", problems[0])

    def test_what_a_program_links_counts_as_its_deps(self):
        plan = PLAN + "| `app/cli` | program | drive |\n"
        files = {"docs/architecture.md": plan, "app/cli/main.cpp": '#include "floor/tag.h"\n',
                 "app/cli/CMakeLists.txt": "add_executable(cli main.cpp)\ntarget_link_libraries(cli PRIVATE tessera_drive)"}
        self.assertEqual(self.problems(files=files), [])
        files["app/cli/CMakeLists.txt"] = "add_executable(cli main.cpp)\ntarget_link_libraries(cli PRIVATE tessera_base)"
        self.assertEqual(len(self.problems(files=files)), 1)
        files["app/cli/CMakeLists.txt"] = "add_executable(cli main.cpp)\ntarget_link_libraries(cli PRIVATE tessera_wire)"
        self.assertIn("app/cli may not know core/wire", "".join(self.problems(files=files)))

    def test_deps_in_a_circle_are_found(self):
        problems = self.problems(files={"core/base/CMakeLists.txt": "tessera_library(base SOURCES pose.cpp DEPS drive)"})
        self.assertTrue(any("a circle" in p for p in problems), problems)

    def test_a_circle_in_the_plan_is_found(self):
        problems = self.problems(files={"docs/architecture.md": PLAN.replace("| units | nothing |", "| units | drive |")})
        self.assertIn("a circle", problems[0])

    def test_a_folder_without_a_row_is_found(self):
        self.assert_found("core/extra/thing.cpp", "int x;\n", "does not list")

    def test_an_include_of_a_missing_file_is_found(self):
        self.assert_found("core/wire/frame.cpp", '#include "wire/gone.h"\n', "not in the tree")

    def test_qt_in_the_logic_is_found(self):
        for line in ("#include <QString>", "#include <QtCore/qstring.h>", "#include <QtGlobal>", "QString s;"):
            self.assert_found("core/drive/route.cpp", line + "\n", "Qt in the logic")

    def test_a_clock_or_thread_in_the_logic_is_found(self):
        for line in ("#include <thread>", "auto t = std::chrono::steady_clock::now();", "std::random_device d;",
                     "usleep(3);", "#include <mutex>", "clock_gettime(0, &t);"):
            self.assert_found("core/drive/route.cpp", line + "\n", "in the logic")

    def test_heap_in_firmware_is_found(self):
        for line in ("#include <vector>", "std::string s;", "throw 1;", "auto* p = new int;"):
            self.assert_found("core/wire/frame.cpp", line + "\n", "heap or exceptions")

    def test_a_cast_that_may_lie_askew_is_found(self):
        cast = "auto* p = reinterpret_cast<const std::uint32_t*>(bytes);\n"
        self.assert_found("core/drive/route.cpp", cast, "alignment")
        for fine in ({"core/wire/frame.cpp": cast}, {"core/drive/route.cpp": cast.replace("uint32_t", "uint8_t")}):
            self.assertEqual(self.problems(files=fine), [])

    def test_a_long_file_is_found(self):
        self.assert_found("core/wire/frame.cpp", "//\n" * 301, "301 lines")
        self.assert_found("dev", "#\n" * 301, "301 lines")

    def test_a_test_that_nobody_builds_is_found(self):
        self.assert_found("tests/base/pose_test.cpp", "", "stands in no CMakeLists.txt")
        built = {"tests/base/pose_test.cpp": "", "tests/CMakeLists.txt": "tessera_test(base_test SOURCES base/pose_test.cpp)"}
        self.assertEqual(self.problems(files=built), [])

    def test_a_header_without_a_guard_is_found(self):
        self.assert_found("core/wire/frame.h", "int x;\n", "#pragma once")


if __name__ == "__main__":
    unittest.main()
