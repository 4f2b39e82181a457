#!/usr/bin/env python3
"""Tries the scripts behind docs/experiments.md on a stand-in for tessera-cli: what they run, write and print."""
import contextlib
import csv
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench"))
sys.dont_write_bytecode = True
import documented  # noqa: E402
import experiments  # noqa: E402
import floors  # noqa: E402
import renew  # noqa: E402
import runs  # noqa: E402
import tables  # noqa: E402

# Writes what it was told into its folder; a run at 0.66 m/s is refused, one at 0.55 m/s does not finish.
STAND_IN = """#!/usr/bin/env python3
import json, pathlib, sys
words = sys.argv[1:]
if words[0] == "charts":
    to = pathlib.Path(words[words.index("--out") + 1])
    to.mkdir(parents=True, exist_ok=True)
    for name in ("errors", "speed", "nees", "tracking"):
        (to / f"{name}.png").write_text(" ".join(words))
    sys.exit()
value = lambda name, default: words[words.index(name) + 1] if name in words else default
speed, seed, readers = float(value("--speed", 0)), int(value("--seed", 0)), int(value("--readers", 3))
if speed == 0.66:
    sys.exit("tessera-cli: it is refused.")
error = 0.01 * readers + 0.001 * seed
one = {"finished": speed != 0.55, "position_error_mean_m": error, "position_error_p95_m": error, "reversals": 1, "nees_mean": 2,
       "position_error_max_m": 0.6, "cross_track_rms_m": error, "cross_track_rms_off_corners_m": error, "end_error_m": error,
       "cross_track_max_off_corners_m": error, "consistent": seed > 1, "mean_speed_ratio": 0.9, "samples": 7}
vehicles = [{**one, "vehicle": n + 1, "name": "AGV", "route": "r"} for n in range(max(1, words.count("--drive")))]
options = {"speed_m_per_s": speed, "seed": seed, "vehicle": "native", "site": words[1], "world_arguments": words}
summary = {**one, "vehicles": vehicles, "options": options, "events": [], "world_complaints": [],
           "channel": {"cycle_s": 0.1, "slot_s": 0.05, "air_factor": 1.8}}
if "--carry" in words:
    summary["carried"] = {"found": True, "found_after_m": 0.5, "wrongly_sure_s": 2}
pathlib.Path(value("--out", ""), "summary.json").write_text(json.dumps(summary))
"""


class OnAStandIn(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "tessera-cli").write_text(STAND_IN)
        (self.folder / "tessera-cli").chmod(0o755)

    def bench(self, *words):
        call = [sys.executable, str(ROOT / "bench/experiments.py"), "--cli", str(self.folder / "tessera-cli"), "--out",
                str(self.folder / "out"), "--vehicle", "native", *words]
        return subprocess.run(call, capture_output=True, text=True, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})

    def table(self):
        with (self.folder / "out/runs.csv").open(encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def renew(self, *words):
        call = ["bash", str(ROOT / "bench/experiments.sh"), *words]
        return subprocess.run(call, capture_output=True, text=True, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})


class Vary(OnAStandIn):
    def test_each_combination_has_a_row_and_each_run_a_line(self):
        done = self.bench("--speeds", "0.12", "0.2", "--seeds", "2", "--vary", "readers=1,5", "--vary", "pitch=0.1,0.2")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rows = [line.split(" | ") for line in done.stdout.splitlines() if line.startswith("| 0")]
        self.assertEqual([row[:5] for row in rows[:2]], [["| 0.12", "1", "0.1", "2/2", "1.15"], ["| 0.12", "1", "0.2", "2/2", "1.15"]])
        self.assertEqual(len(rows), 8)
        lines = self.table()
        self.assertEqual(len(lines), 16)
        self.assertEqual(len({line["folder"] for line in lines}), 16)
        for line in lines:
            summary = json.loads((self.folder / "out" / line["folder"] / "summary.json").read_text())
            told = summary["options"]["world_arguments"]
            self.assertEqual(told[told.index("--readers") + 1], line["asked_readers"])
            pitch = json.loads(pathlib.Path(told[1]).read_text())["tile_types"][0]["pitch_m"]
            self.assertEqual(pitch, float(line["asked_pitch"]))
            self.assertEqual(float(line["position_error_mean_m"]), summary["position_error_mean_m"])

    def test_options_after_the_dashes_reach_every_run(self):
        self.bench("--speeds", "0.12", "--seeds", "1", "--", "--lockstep", "--air", "2400")
        self.assertRegex(self.table()[0]["world_arguments"], "--lockstep --air 2400")

    def test_several_vehicles_have_a_row_and_a_line_each(self):
        done = self.bench("--speeds", "0.12", "--seeds", "1", "--drive", "1=one", "--drive", "2=two")
        self.assertEqual([row[:12] for row in done.stdout.splitlines() if row.startswith("| 0")], ["| 0.12 | 1 |", "| 0.12 | 2 |"])
        self.assertEqual([line["address"] for line in self.table()], ["1", "2"])

    def test_wrong_calls_are_refused(self):
        for words in (["--vary", "readers"], ["--vary", "readers="], ["--vary", "seed=1,2"], ["--vary", "speed=1"],
                      ["--vary", "air=1", "--", "--air", "2"], ["--floors", "--pitch", "0.1"], ["--seeds", "0"]):
            self.assertEqual(self.bench(*words).returncode, 2, words)

    def test_a_pitch_that_fits_no_tile_is_told(self):
        done = self.bench("--speeds", "0.12", "--seeds", "1", "--pitch", "0.13")
        self.assertEqual(done.returncode, 1)
        self.assertIn("a pitch of 0.13 m does not divide tiles of 0.6 m", done.stderr)

    def test_runs_without_figures_and_unfinished_ones_are_told(self):
        done = self.bench("--speeds", "0.12", "0.66", "--seeds", "1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("it is refused", done.stderr)
        self.assertIn("| 0.66 | 0/1 | – |", done.stdout)
        self.assertEqual([bool(line["error"]) for line in self.table()], [False, True])
        self.assertEqual(self.bench("--speeds", "0.55", "--seeds", "1").returncode, 1)
        self.assertEqual(self.bench("--speeds", "0.55", "--seeds", "1", "--baseline").returncode, 0)
        self.assertEqual(self.bench("--speeds", "0.66", "--seeds", "1", "--baseline").returncode, 1, "nothing else is there")


class Renew(OnAStandIn):
    def test_a_table_is_put_in_its_place(self):
        document = self.folder / "page.md"
        document.write_text("before\n\n<!-- table: three -->\n| old |\n| --- |\n\nbehind\n")
        done = self.renew(str(self.folder), "lockstep", "--only", "three", "--into", str(document), "--out", str(self.folder / "out"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = document.read_text()
        self.assertTrue(text.startswith("before\n\n<!-- table: three -->\n| m/s | vehicle |"), text)
        self.assertIn("| 0.12 | 3 | 5/5 | 3.30 | 3.50 |", text)
        self.assertTrue(text.endswith(" |\n\nbehind\n") and "old" not in text, text)
        self.assertIn("| 0.12 | 3 | 5/5 | 3.30 | 3.50 |", done.stdout)

    def test_charts_are_drawn_and_kept_beside_the_document(self):
        (self.folder / "pictures").mkdir()
        for name in ("native", "tag-centre"):
            (self.folder / "out" / name).mkdir(parents=True)
            (self.folder / "out" / name / "runs.csv").write_text("")
        self.assertTrue(renew.draw(self.folder, self.folder / "out", self.folder / "pictures"))
        self.assertIn("--by estimator", (self.folder / "pictures/experiments-errors.png").read_text())
        self.assertIn("--by speed_m_per_s", (self.folder / "pictures/experiments-nees.png").read_text())
        self.assertFalse((self.folder / "pictures/experiments-controllers.png").exists(), "its table was not taken")

    def test_a_page_without_the_place_is_told(self):
        document = self.folder / "page.md"
        document.write_text("nothing\n")
        done = self.renew(str(self.folder), "--only", "three", "--into", str(document), "--out", str(self.folder / "out"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("<!-- table: three -->", done.stderr)
        self.assertFalse((self.folder / "out").exists(), "it is told before anything is run")

    def test_wrong_calls_are_refused(self):
        for words in ([], [str(self.folder), "fast"], [str(self.folder), "--only", "moon"], [str(self.folder / "none")]):
            self.assertEqual(self.renew(*words).returncode, 2, words)


class Document(unittest.TestCase):
    TEXT = (ROOT / "docs/experiments.md").read_text(encoding="utf-8")

    def test_holds_each_table_that_the_command_makes_and_no_other(self):
        names = re.findall(r"^<!-- table: (.*) -->$", self.TEXT, re.MULTILINE)
        self.assertEqual(names, [table.name for table in documented.TABLES] + ["unicycle"])
        tables = re.findall(r"(?:^|\n)(.*)\n(\|.*\n)\| --- ", self.TEXT)
        self.assertEqual([head for before, head in tables if not before.startswith("<!-- table: ")],
                         ["| figure | is |\n"], "a table that no command makes")

    def test_has_their_heads_and_rows(self):
        for table in documented.TABLES:
            lines = self.TEXT.split(f"<!-- table: {table.name} -->\n")[1].split("\n\n")[0].splitlines()
            self.assertEqual(lines[:2], table.head(), table.name)
            if len(table.rows) == len(lines) - 2:  # several vehicles have several lines
                self.assertEqual([line[:len(f"| {' | '.join(row.keys)} |")] for line, row in zip(lines[2:], table.rows)],
                                 [f"| {' | '.join(row.keys)} |" for row in table.rows])
            else:
                self.assertIn("vehicle", table.keys)

    def test_shows_each_chart_that_is_kept(self):
        for _, _, _, kept in documented.CHARTS:
            for name in kept.values():
                self.assertIn(f"(pictures/{name})", self.TEXT)


class Kinds(unittest.TestCase):
    def test_carried_runs_are_told_by_how_soon_they_are_found(self):
        results = [{"carried": {"found": True, "found_after_m": way, "wrongly_sure_s": 2}} for way in (0.5, 1.5)]
        results += [{"carried": {"found": False, "found_after_m": 0, "wrongly_sure_s": 5}}, {"error": "refused"}]
        self.assertEqual(tables.row(["x"], "carried", results), "| x | 2/4 | 1.00 | 1.50 | 1/4 | 3.0 | 5.0 |")
        self.assertEqual(tables.row(["x"], "carried", results[3:]), "| x | 0/1 | – | – | – | – | – |")

    def test_runs_that_gave_no_figures_count_as_not_finished(self):
        one = {"finished": True, "position_error_mean_m": 0.01, "position_error_max_m": 0.6, "cross_track_rms_m": 0.02,
               "nees_mean": 2.1, "consistent": True}
        self.assertEqual(tables.row(["x"], "floor", [one, {"error": "refused"}]), "| x | 1/2 | 1.00 | 1.00 | 60.00 | 2.00 | 2.00 | 2.10 | 1/1 | 1 |")

    def test_a_tables_head_has_as_many_columns_as_its_rows(self):
        for kind in tables.KINDS:
            top, rule = tables.head(["a", "b"], kind)
            self.assertEqual(top.count("|"), rule.count("|"), kind)
            self.assertEqual(tables.row(["a", "b"], kind, [{"error": "refused"}]).count("|"), top.count("|"), kind)


class Settings(unittest.TestCase):
    def test_later_options_replace_earlier_ones_but_drives_add_up(self):
        setting = runs.setting_of("--air 19200 --lockstep --drive 1=a --air 2400 --drive 2=b --tyre-difference -0.1".split())
        self.assertEqual(list(runs.words_of(setting)), "--air 2400 --lockstep --drive 1=a --drive 2=b --tyre-difference -0.1".split())
        with self.assertRaises(ValueError):
            runs.setting_of(["0.12"])

    def test_a_table_varies_one_thing_at_a_time(self):
        table = next(t for t in documented.TABLES if t.name == "foretold")
        readers = [drives[0][0]["readers"] for _, drives in table.drives("sites")]
        self.assertEqual(readers, ["1", "2", "3", "5", "3", "3", "3", "3"])

    def test_refused_runs_of_a_baseline_are_a_result_beside_others(self):
        some = [(["x"], [{"finished": True}, {"error": "refused"}])]
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertTrue(experiments.complain(some, baseline=False))
            self.assertFalse(experiments.complain(some, baseline=True))
            self.assertTrue(experiments.complain([(["x"], [{"error": "refused"}])], baseline=True))
        self.assertIn("1 of 2 runs of the row x gave no figures, the first: refused\n", said.getvalue())

    def test_a_value_is_varied_by_its_name(self):
        self.assertEqual(experiments.varied("--readers=1,2"), ("readers", ["1", "2"]))


class Pitch(unittest.TestCase):
    BASE = floors.load(ROOT / "resources/sites/paper.tessera.json")

    def places(self, site):
        kinds = {kind["name"]: kind for kind in site["tile_types"]}
        for tile, placement in zip(site["tiles"], site["placements"]):
            kind = kinds[tile["type"]]
            cells = [(c, r) for r in range(kind["rows"]) for c in range(kind["columns"]) if (c + r) % 2 == kind["starts_with_gap"]]
            self.assertEqual(len(cells), len(tile["uids"]))
            for c, r in cells:
                yield tuple(round(1000 * (placement[f"{axis}_m"] + margin + n * kind["pitch_m"]))
                            for axis, n, margin in zip("xy", (c, r), kind["margin_m"]))

    def test_lays_every_second_place_across_the_seams(self):
        for pitch, count in ((0.1, 162), (0.15, 72), (0.2, 41)):
            site, step = floors.at_pitch(self.BASE, pitch), round(1000 * pitch)
            places = set(self.places(site))
            self.assertEqual(len(places), count)
            whole = {(step // 2 + step * c, step // 2 + step * r) for c in range(1800 // step) for r in range(1800 // step)
                     if (c + r) % 2 == 0}
            self.assertEqual(places, whole)
            self.assertEqual(len({uid for tile in site["tiles"] for uid in tile["uids"]}), count)

    def test_leaves_the_publications_floor_as_it_lies_at_its_own(self):
        self.assertEqual(set(self.places(self.BASE)), set(self.places(floors.at_pitch(self.BASE, 0.15))))

    def test_refuses_what_does_not_divide_a_tile(self):
        for pitch in (0.13, 0.0, -0.1, 0.7):
            with self.assertRaises(ValueError):
                floors.at_pitch(self.BASE, pitch)


if __name__ == "__main__":
    unittest.main()
