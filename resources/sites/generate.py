#!/usr/bin/env python3
"""Writes the sites of this folder: paper.tessera.json and three.tessera.json.

The same bytes on every run, in the form that the program itself writes. See README.md.
"""
import hashlib
import json
import pathlib

PITCH, COLUMNS, ROWS = 0.15, 4, 4
TILE = PITCH * COLUMNS
FOOTPRINT = [[-0.2, -0.18], [0.2, -0.18], [0.2, 0.18], [-0.2, 0.18]]
READERS = [[0.15, 0.1], [0.15, 0], [0.15, -0.1]]


def uid(site, serial, index):
    """Seven bytes, the first of which is the maker's code 04, as many tags have; the rest differs from tag to tag."""
    return "04" + hashlib.sha256(f"{site} {serial} {index}".encode()).hexdigest()[:12].upper()


def key(site, vehicle):
    return hashlib.sha256(f"demonstration key, known to all: {site} {vehicle}".encode()).hexdigest()[:32].upper()


def number(v):
    v = round(v, 9)
    return int(v) if v == int(v) else v


def compact(v):
    if isinstance(v, float):
        return repr(number(v)) if v else "0"
    if isinstance(v, list):
        return "[" + ", ".join(map(compact, v)) + "]"
    if isinstance(v, dict):
        return "{" + ", ".join(f"{json.dumps(k)}: {compact(x)}" for k, x in v.items()) + "}"
    return json.dumps(v, ensure_ascii=False)


def vehicle_text(v):
    lines = [("id", "name", "key"), ("readers_m", "reader_radius_m"), ("footprint_m",),
             ("track_m", "wheel_diameter_m", "max_speed_mps", "max_turn_rate_radps", "acceleration_mps2"), ("start",)]
    return "{" + ",\n     ".join(compact({k: v[k] for k in keys})[1:-1] for keys in lines) + "}"


def section(name, items, text=compact):
    return f'  "{name}": [' + ",".join("\n    " + text(i) for i in items) + ("\n  ]" if items else "]")


def vehicle(site, number_, start, heading):
    return {"id": number_, "name": f"AGV {number_}", "key": key(site, number_), "readers_m": READERS,
            "reader_radius_m": 0.06, "footprint_m": FOOTPRINT, "track_m": 0.3, "wheel_diameter_m": 0.1,
            "max_speed_mps": 0.5, "max_turn_rate_radps": 1.5, "acceleration_mps2": 0.5,
            "start": {"x_m": start[0], "y_m": start[1], "heading_deg": heading}}


def write(file, name, north_to_y, columns, rows, turn_of, routes, headings):
    tiles, placements = [], []
    for row in range(rows):
        for column in range(columns):
            serial = f"T-{row * columns + column + 1:04d}"
            tags = [uid(file, serial, i) for i in range(COLUMNS * ROWS // 2)]
            tiles.append({"serial": serial, "type": "60x60", "uids": tags})
            turns = turn_of(serial)
            # A turned tile's own lower left corner comes to lie on another corner of its square.
            dx, dy = [(0, 0), (1, 0), (1, 1), (0, 1)][turns]
            placements.append({"serial": serial, "x_m": number((column + dx) * TILE),
                               "y_m": number((row + dy) * TILE), "quarter_turns": turns})
    width, height = number(columns * TILE), number(rows * TILE)
    parts = [
        '  "format": "tessera-site"', '  "version": 1', f'  "name": {json.dumps(name)}',
        f'  "north_to_y_deg": {north_to_y}', '  "radio": {"channel": 23, "air_rate_bps": 19200, "baud": 115200}',
        section("tile_types", [{"name": "60x60", "width_m": TILE, "height_m": TILE, "pitch_m": PITCH,
                                "margin_m": [PITCH / 2, PITCH / 2], "columns": COLUMNS, "rows": ROWS,
                                "pattern": "one-in-two", "starts_with_gap": False}]),
        section("tiles", tiles), section("placements", placements), section("loose_tags", []),
        section("zones", [{"name": "floor", "kind": "running",
                           "outline_m": [[0, 0], [width, 0], [width, height], [0, height]]}]),
        section("routes", [{"name": n, "control_spacing_m": 0.2, "vertices_m": v} for n, v in routes]),
        section("vehicles", [vehicle(file, i + 1, v[0], headings[i]) for i, (_, v) in enumerate(routes)], vehicle_text),
    ]
    path = pathlib.Path(__file__).with_name(file + ".tessera.json")
    path.write_text("{\n" + ",\n".join(parts) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    write("paper", "The paper's floor", 20, 3, 3, lambda serial: 0,
          [("paper", [[0.3, 0.3], [0.3, 1.5], [0.9, 1.5], [0.9, 0.3], [1.5, 0.3], [1.5, 1.5]])], [90])
    write("three", "Three vehicles", -35, 8, 6, lambda serial: hashlib.sha256(serial.encode()).digest()[0] % 4,
          [("one", [[0.4, 0.4], [0.4, 3.2], [1.1, 3.2], [1.1, 0.4]]),
           ("two", [[2, 0.4], [2, 1.8], [2.8, 1.8], [2.8, 3.2], [2, 3.2]]),
           ("three", [[4.4, 3.2], [4.4, 0.4], [3.7, 0.4], [3.7, 3.2]])], [90, 90, -90])
