#!/usr/bin/env python3
"""Floors and routes of many kinds, made from the publication's site; `bench/experiments.py --floors` drives on them.

Each kind is made anew for each seed: what is random in it (turns of tiles, tags that are not registered, the compass'
north) comes from the seed alone.
"""
import copy
import json
import math
import random

ROUTE = "drive"


def load(path):
    return json.loads(path.read_text(encoding="utf-8"))


def uids(count, rng):
    """Of seven bytes, each one once."""
    return [f"04{n:012X}" for n in rng.sample(range(1, 1 << 40), count)]


def lay(site, cells, rng, turns=lambda rng: 0):
    """Tiles of the site's type at these cells (column, row), each turned by so many quarters."""
    kind = site["tile_types"][0]
    width = kind["width_m"]
    site["tiles"], site["placements"] = [], []
    per_tile = sum((c + r) % 2 == 0 for r in range(kind["rows"]) for c in range(kind["columns"]))
    numbers = uids(per_tile * len(cells), rng)
    for i, (column, row) in enumerate(cells):
        quarters = turns(rng)
        serial = f"T-{i + 1:04d}"
        site["tiles"].append({"serial": serial, "type": kind["name"], "uids": numbers[i * per_tile:(i + 1) * per_tile]})
        # The corner that is the lower left one before turning.
        x, y = column + (quarters in (1, 2)), row + (quarters in (2, 3))
        site["placements"].append({"serial": serial, "x_m": round(x * width, 6), "y_m": round(y * width, 6),
                                   "quarter_turns": quarters})
    site["zones"] = []


def at_pitch(base, pitch):
    """The same floor with its tags at this pitch in metres, one-in-two across the seams as well. Its tiles must not be
    turned. ValueError: the pitch does not divide a tile."""
    site, rng = copy.deepcopy(base), random.Random(f"pitch {pitch:g}")
    kind = site["tile_types"][0]
    width, count = kind["width_m"], round(kind["width_m"] / pitch) if pitch > 0 else 0
    if count < 1 or abs(count * pitch - width) > 1e-6:
        raise ValueError(f"a pitch of {pitch:g} m does not divide tiles of {width:g} m")
    # With an odd number of places in a row the next tile goes on with a gap.
    both = [{**kind, "name": name, "pitch_m": pitch, "margin_m": [pitch / 2] * 2, "columns": count, "rows": count,
             "starts_with_gap": gap} for name, gap in ((kind["name"], False), (f"{kind['name']} gap first", True))]
    site["tile_types"] = both if count % 2 else both[:1]
    numbers = iter(uids(count * count * len(site["tiles"]), rng))
    places = {placement["serial"]: placement for placement in site["placements"]}
    for tile in site["tiles"]:
        place = places[tile["serial"]]
        gap = count % 2 * round((place["x_m"] + place["y_m"]) / width) % 2
        tile["type"] = both[gap]["name"]
        tile["uids"] = [next(numbers) for r in range(count) for c in range(count) if (c + r) % 2 == gap]
    return site


def route(site, vertices):
    site["routes"] = [{"name": ROUTE, "control_spacing_m": 0.2, "vertices_m": [[round(v, 6) for v in p] for p in vertices]}]
    (ax, ay), (bx, by) = vertices[:2]
    site["vehicles"][0]["start"] = {"x_m": round(ax, 6), "y_m": round(ay, 6),
                                    "heading_deg": round(math.degrees(math.atan2(by - ay, bx - ax)), 6)}


def turned(point, degrees, about=(0.9, 0.9)):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x, y = point[0] - about[0], point[1] - about[1]
    return about[0] + c * x - s * y, about[1] + s * x + c * y


def tag_places(site):
    kind = site["tile_types"][0]
    tiles = {tile["serial"]: tile["uids"] for tile in site["tiles"]}
    for placement in site["placements"]:
        offsets = [(kind["margin_m"][0] + c * kind["pitch_m"], kind["margin_m"][1] + r * kind["pitch_m"])
                   for r in range(kind["rows"]) for c in range(kind["columns"]) if (c + r) % 2 == 0]
        for uid, offset in zip(tiles[placement["serial"]], offsets):
            x, y = turned(offset, 90 * placement["quarter_turns"], (0, 0))
            yield uid, (placement["x_m"] + x, placement["y_m"] + y)


def rounded(vertices, radius):
    """The same way with its right angles as arcs in steps of 5 degrees."""
    line = [vertices[0]]
    for before, corner, behind in zip(vertices, vertices[1:], vertices[2:]):
        into = math.atan2(corner[1] - before[1], corner[0] - before[0])
        out = math.atan2(behind[1] - corner[1], behind[0] - corner[0])
        side = math.copysign(1.0, math.sin(out - into))
        centre = (corner[0] - radius * math.cos(into) - side * radius * math.sin(into),
                  corner[1] - radius * math.sin(into) + side * radius * math.cos(into))
        for step in range(19):
            heading = into + side * math.radians(5 * step)
            line.append((centre[0] + side * radius * math.sin(heading), centre[1] - side * radius * math.cos(heading)))
    return line + [vertices[-1]]


def missing(share):
    def make(site, rng):
        for tile in site["tiles"]:
            tile["uids"] = [None if rng.random() < share else uid for uid in tile["uids"]]
    return make


def whole_turned(degrees):
    def make(site, rng):
        vertices = [turned(p, degrees) for p in site["routes"][0]["vertices_m"]]
        site["loose_tags"] = [{"uid": uid, "x_m": round(x, 6), "y_m": round(y, 6)}
                              for uid, (x, y) in ((uid, turned(p, degrees)) for uid, p in tag_places(site))]
        site["tiles"], site["placements"], site["zones"] = [], [], []
        route(site, vertices)
    return make


def tiles_turned(site, rng):
    lay(site, [(c, r) for r in range(3) for c in range(3)], rng, lambda rng: rng.randrange(4))


def shape_of_l(site, rng):
    lay(site, [(c, r) for r in range(6) for c in range(6) if c < 2 or r < 2], rng)
    route(site, [(0.3, 3.3), (0.3, 0.3), (3.3, 0.3), (3.3, 0.9), (0.9, 0.9), (0.9, 3.3)])


def diagonal(site, rng):
    route(site, [(0.3, 0.3), (1.5, 1.5), (1.5, 0.3), (0.3, 1.5), (0.3, 0.9), (1.5, 0.6)])


def curved(site, rng):
    route(site, rounded(site["routes"][0]["vertices_m"], 0.25))


def as_it_is(site, rng):
    pass


# What it is called in the table, how it is made, further options of the experiment.
KINDS = [
    ("the publication's", as_it_is, []),
    ("the whole floor turned by 90°", whole_turned(90), []),
    ("the whole floor turned by 30°", whole_turned(30), []),
    ("each tile turned at random", tiles_turned, []),
    ("L-shaped, 20 tiles", shape_of_l, []),
    ("diagonal route", diagonal, []),
    ("curved route, arcs of 25 cm", curved, []),
    ("5 % of the tags not registered", missing(0.05), []),
    ("20 % of the tags not registered", missing(0.20), []),
    ("5 % of the tags dead, but registered", as_it_is, ["--dead-tags", "0.05"]),
    ("20 % of the tags dead, but registered", as_it_is, ["--dead-tags", "0.2"]),
]


def write(base, kind, seed, path):
    """A site file of this kind of floor; returns the further options."""
    _, make, extra = KINDS[kind]
    rng = random.Random(f"{kind} {seed}")
    site = copy.deepcopy(base)
    site["routes"][0]["name"] = ROUTE
    site["north_to_y_deg"] = rng.randrange(360)
    make(site, rng)
    path.write_text(json.dumps(site), encoding="utf-8")
    return extra
