#!/usr/bin/env python3
"""docs/site.schema.json and the program must agree: both take the sites of resources/ and harmless variants of them, and
both refuse broken ones. Usage: schema_test.py SITE_VERDICT SOURCE_ROOT"""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

VERDICT, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
SCHEMA = json.loads((ROOT / "docs/site.schema.json").read_text("utf-8"))
SITES = {p.name: json.loads(p.read_text("utf-8")) for p in sorted((ROOT / "resources/sites").glob("*.tessera.json"))}
PAPER = SITES["paper.tessera.json"]
MISSING = object()
BACKDROP = {"file": "hall.png", "origin_m": [1, -2], "metres_per_pixel": 0.02, "picture": "iVBORw0KGgo="}


def changed(pointer, value):
    """The publication's site with the value at a JSON pointer replaced, added, or taken away."""
    site = copy.deepcopy(PAPER)
    *path, last = pointer.strip("/").split("/")
    at = site
    for key in path:
        at = at[int(key) if isinstance(at, list) else key]
    last = int(last) if isinstance(at, list) else last
    if value is MISSING:
        del at[last]
    else:
        at[last] = value
    return site


GOOD = [changed(*c) for c in [
    ("/north_to_y_deg", -360), ("/north_to_y_deg", 20.5), ("/north_to_y_deg", MISSING), ("/radio", MISSING),
    ("/radio/baud", MISSING), ("/radio/channel", 31), ("/radio/air_rate_bps", 300), ("/tiles/0/uids/3", None),
    ("/tiles/0/uids/3", "04b15f82"), ("/tiles/0/uids/3", "04B15F823A2F48000000"), ("/tiles/0/uids", []),
    ("/placements/0/quarter_turns", MISSING), ("/placements/0/quarter_turns", 3), ("/placements/0/x_m", -1e5),
    ("/tile_types/0/margin_m", MISSING), ("/tile_types/0/starts_with_gap", True), ("/zones/0/kind", "no-go"),
    ("/zones/0/speed_mps", 0.2), ("/zones/0/direction_deg", 90), ("/routes/0/control_spacing_m", MISSING),
    ("/vehicles/0/start", MISSING), ("/vehicles/0/id", 254), ("/vehicles/0/track_m", MISSING), ("/vehicles", MISSING),
    ("/backdrop", BACKDROP), ("/backdrop", {**BACKDROP, "turn_deg": -360, "opacity": 1, "file": "平" * 200}),
    ("/backdrop", {**BACKDROP, "picture": "/9j/4AAQ", "metres_per_pixel": 100}),
    ("/name", "地" * 200), ("/loose_tags", [{"uid": "04000000", "x_m": 1, "y_m": 2}]), ("/zones/0/kind", "one-way"),
    ("/vehicles/0/corner_cut_m", 0), ("/vehicles/0/corner_cut_m", 0.5),
    ("/routes/0/leg_speeds_mps", [None, 0.001, 20, 0.1, None]), ("/routes/0/leg_speeds_mps", [None] * 5)]]

BAD = {f"{c[0]} = {'(missing)' if c[1] is MISSING else json.dumps(c[1])[:60]}": changed(*c) for c in [
    ("/format", MISSING), ("/format", "site"), ("/version", 2), ("/version", "1"), ("/name", ""), ("/name", MISSING),
    ("/name", "地" * 201), ("/name", 5), ("/extra", 1), ("/north_to_y", 20), ("/north_to_y_deg", 361),
    ("/north_to_y_deg", "20"), ("/north_to_y_deg", None), ("/radio", []), ("/radio/channel", 32),
    ("/radio/channel", 1.5), ("/radio/air_rate_bps", 9601), ("/radio/baud", 0), ("/radio/power", 1),
    ("/tile_types", {}), ("/tile_types/0/pitch_m", 0), ("/tile_types/0/columns", 0), ("/tile_types/0/columns", 101),
    ("/tile_types/0/pattern", "half"), ("/tile_types/0/pattern", "custom"), ("/tile_types/0/custom", ["####"]),
    ("/tile_types/0/margin_m", [0.1]), ("/tile_types/0/starts_with_gap", 1), ("/tile_types/0/width_m", MISSING),
    ("/tiles/0/uids/3", "04B15F823A2F4"), ("/tiles/0/uids/3", "04:B1:5F:82"), ("/tiles/0/uids/3", ""),
    ("/tiles/0/uids/3", 4), ("/tiles/0/uids", None), ("/tiles/0/serial", MISSING), ("/tiles/0/place", 1),
    ("/placements/0/quarter_turns", 4), ("/placements/0/quarter_turns", 0.5), ("/placements/0/x_m", 1e6),
    ("/placements/0/y_m", MISSING), ("/loose_tags", [{"uid": None, "x_m": 1, "y_m": 2}]), ("/zones/0/kind", "river"),
    ("/zones/0/outline_m", [[0, 0], [1, 0]]), ("/zones/0/outline_m/0", [0, 0, 0]), ("/zones/0/speed_mps", 0),
    ("/routes/0/vertices_m", [[0, 0]]), ("/routes/0/vertices_m/0/0", True), ("/routes/0/control_spacing_m", 0),
    ("/routes/0/name", MISSING), ("/routes/0/leg_speeds_mps", [0, 1, 1, 1, 1]), ("/routes/0/leg_speeds_mps", []),
    ("/routes/0/leg_speeds_mps", [True, 1, 1, 1, 1]), ("/routes/0/leg_speeds_mps", None), ("/vehicles/0/id", 0), ("/vehicles/0/id", 255), ("/vehicles/0/key", "00"),
    ("/vehicles/0/key", MISSING), ("/vehicles/0/key", "G" * 32), ("/vehicles/0/readers_m", []),
    ("/vehicles/0/readers_m", [[0, 0]] * 9), ("/vehicles/0/start/heading_deg", MISSING),
    ("/backdrop", None), ("/backdrop", {k: v for k, v in BACKDROP.items() if k != "picture"}),
    ("/backdrop", {**BACKDROP, "picture": "R0lGODlh"}), ("/backdrop", {**BACKDROP, "picture": "iVBORw0KGg!="}),
    ("/backdrop", {**BACKDROP, "picture": ""}), ("/backdrop", {**BACKDROP, "opacity": 1.1}),
    ("/backdrop", {**BACKDROP, "metres_per_pixel": 0}), ("/backdrop", {**BACKDROP, "origin_m": [1]}),
    ("/backdrop", {**BACKDROP, "file": ""}), ("/backdrop", {**BACKDROP, "turn": 90}),
    ("/vehicles/0/corner_cut_m", -0.01), ("/vehicles/0/corner_cut_m", 0.51), ("/vehicles/0/corner_cut_m", None),
    ("/vehicles/0/start", None), ("/vehicles/0/max_speed_mps", -1), ("/vehicles/0/footprint_m", [[0, 0]])]}


def verdicts(sites):
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for i, site in enumerate(sites):
            files.append(pathlib.Path(folder) / f"{i}.json")
            files[-1].write_text(json.dumps(site), "utf-8")
        out = subprocess.run([VERDICT, *files], check=True, capture_output=True, text=True, timeout=60).stdout
    return out.splitlines()


class SchemaAndProgram(unittest.TestCase):
    def setUp(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        self.schema = jsonschema.Draft202012Validator(SCHEMA)

    def test_both_take_the_sites_that_come_with_the_program(self):
        self.assertGreaterEqual(len(SITES), 2)
        for name, verdict in zip(SITES, verdicts(SITES.values())):
            self.assertEqual([e.message for e in self.schema.iter_errors(SITES[name])], [], name)
            self.assertEqual(verdict, "taken", name)

    def test_both_take_harmless_variants(self):
        for site, verdict in zip(GOOD, verdicts(GOOD)):
            self.assertEqual([e.message for e in self.schema.iter_errors(site)], [])
            self.assertEqual(verdict, "taken")

    def test_both_refuse_each_broken_one(self):
        for (what, site), verdict in zip(BAD.items(), verdicts(BAD.values())):
            with self.subTest(what):
                self.assertFalse(self.schema.is_valid(site), "the schema takes it")
                self.assertNotEqual(verdict, "taken")
                pointer = what.split(" = ")[0]
                self.assertIn(pointer.rsplit("/", 1)[0], verdict, "the sentence names another place")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
