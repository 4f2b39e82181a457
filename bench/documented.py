#!/usr/bin/env python3
"""Every table of docs/experiments.md as data: what its rows are called and what is run for them.

`bench/renew.py` runs them. A table's name stands before it in the document as `<!-- table: NAME -->`.
"""
import dataclasses

import runs
import tables

SPEEDS = ("0.05", "0.08", "0.12", "0.20")


@dataclasses.dataclass
class Row:
    """`keys`: its first cells. `words`: options beside the table's, of which they may replace some."""
    keys: list
    words: str = ""
    seeds: range = None  # None: the table's


@dataclasses.dataclass
class Table:
    name: str  # also of its folder in out/experiments
    title: str
    kind: str  # one of tables.KINDS
    keys: list  # heads of the rows' first cells
    rows: list
    words: str = "--vehicle native --lockstep"
    seeds: range = range(1, 21)
    jobs: int = None  # None: as many as suit the machine
    baseline: bool = False  # what does not finish, or is refused, is a result and no failure

    def lockstep(self):
        return "--lockstep" in self.words

    def head(self):
        return tables.head(self.keys, self.kind)

    def drives(self, site):
        """What its rows run, as tables.measure() takes it. site: the folder of the demo sites."""
        for row in self.rows:
            setting = runs.setting_of(["--site", f"{site}/paper.tessera.json", "--route", "paper", "--speed", "0.12",
                                       *f"{self.words} {row.words}".split()])
            if "drive" in setting:
                setting["site"] = f"{site}/three.tessera.json"
                del setting["route"]
            yield row.keys, [(setting, seed) for seed in row.seeds or self.seeds]


def real(name, title, rows, **more):
    return Table(name, title, "drive", rows=rows, words="--vehicle qemu", **more)


def at_speeds(name, title, words="", **more):
    rows = [Row([f"{float(speed):.2f}"], f"--speed {speed} {words}") for speed in SPEEDS]
    return Table(name, title, "drive", ["m/s"], rows, **more)


def of_words(*options):
    """Rows that are called after their options; of (name, options) after the name."""
    pairs = [one if isinstance(one, tuple) else (f"`{one}`" if one else "none", one) for one in options]
    return [Row([name], words) for name, words in pairs]


THREE = "--drive 1=one --drive 2=two --drive 3=three"
SLOW = "--air 2400 --air-factor 1"
POLLED = f"{SLOW} --poll 0.2"
ROUGH = f"{POLLED} --detection 0.72 --compass-bias 5 --slip 0.1"
NOISE = "--compass-noise 2 --speed-noise 0.1"
WHITE = f"{NOISE} --speed-noise-time 0.05"
QUICK = ("`--speed 0.50`", "--speed 0.5")

# The errors that a vehicle like the publication's is taken to have, all of them given, and what is changed row by row.
ASKED = f"--readers 3 --radius 0.06 --detection 0.9 {NOISE} --compass-bias 2"
ODOMETERS = (("white at 10 Hz", "--speed-noise-time 0.05"), ("wanders over 0.5 s", ""))
ASKED_ROWS = ("--poll 0.1 --air 19200", "--poll 0.1 --air 19200 --estimator tag-centre",
              "--poll 0.2 --air 2400 --air-factor 1",
              "--poll 0.2 --air 2400 --air-factor 1 --detection 0.72 --compass-bias 5 --slip 0.1",
              "--poll 0.1 --air 2400 --air-factor 1", "--air 19200 --air-factor 1 --delay 0.3", "--speed 0.5 --air 19200")
OURS = [words for words in ASKED_ROWS if "tag-centre" not in words]
# What a simulation without vehicle and radio foretold for such errors: options, centimetres.
FORETOLD = (("--readers 1", "1.46"), ("--readers 2", "0.97"), ("--readers 3", "0.77"), ("--readers 5", "0.63"),
            ("--poll 0.2", "1.00"), ("--poll 0.4", "1.39"), ("--pitch 0.1", "0.54"), ("--pitch 0.2", "1.02"))


def asked(rows):
    """Each row with either odometer."""
    return [Row([f"`{words}`", name], f"{words} {odometer}") for words in rows for name, odometer in ODOMETERS]


PUBLICATION = [Row([f"{float(speed):.2f}", name], f"--speed {speed} {words}") for speed in SPEEDS
               for name, words in (("look-ahead (ours)", ""), ("control-points (the publication's)",
                                                               "--controller control-points --limit 600"))]

TABLES = [
    Table("asked", "The publication's vehicle with the errors of its parts", "limits", ["options", "odometer's noise"],
          asked(ASKED_ROWS), words=f"--vehicle native --lockstep {ASKED}", baseline=True),
    Table("asked-hundred", "The same on a hundred seeds on which nothing was chosen", "limits", ["options", "odometer's noise"],
          asked(OURS), words=f"--vehicle native --lockstep {ASKED}", seeds=range(301, 401), baseline=True),
    Table("asked-no-iron", "The same on a floor without iron", "limits", ["options", "odometer's noise"],
          asked(OURS), words=f"--vehicle native --lockstep {ASKED} --compass-spots 0", seeds=range(301, 401), baseline=True),
    Table("asked-carried", "The same, carried in the middle of the drive", "carried", ["options", "odometer's noise"],
          asked(["--carry 20 --air 19200", "--carry 20 --air 19200 --readers 1"]),
          words=f"--vehicle native --lockstep {ASKED}", seeds=range(1, 101), baseline=True),
    Table("foretold", "Readers, polls and pitch against what was foretold", "limits", ["options", "foretold mean, cm"],
          [Row([f"`{words}`", figure], words) for words, figure in FORETOLD],
          words=f"--vehicle native --lockstep {ASKED} --speed-noise-time 0.05 --air 19200", baseline=True),
    real("qemu", "Firmware in QEMU, through a pty, in real time",
         [Row([f"{float(speed):.2f}"], f"--speed {speed}") for speed in SPEEDS], keys=["m/s"], seeds=range(1, 6), jobs=2),
    Table("qemu-asked", "The publication's vehicle with the errors of its parts, firmware in QEMU, through a pty, in real time",
          "limits", ["options", "odometer's noise"], asked(["--poll 0.1 --air 19200", "--poll 0.1 --air 2400 --air-factor 1"]),
          words=f"--vehicle qemu {ASKED}", seeds=range(1, 4), jobs=2, baseline=True),
    real("three-qemu", "Three vehicles on one channel, firmware in QEMU, through a pty, in real time", [Row(["0.12"], THREE)],
         keys=["m/s", "vehicle"], seeds=range(1, 2), jobs=1),
    at_speeds("native", "Native vehicles, virtual time"),
    at_speeds("air-1", "The same, the air as its data sheet says (k = 1)", "--air-factor 1"),
    at_speeds("air-3.2", "The same, the slowest air seen in the field (k = 3.2)", "--air-factor 3.2"),
    at_speeds("air-2400", "The same, air rate 2.4 kbit/s as modules are delivered", "--air-rate 2400"),
    at_speeds("loss", "The same, one packet in five lost", "--loss 0.2"),
    Table("three", "Three vehicles on one channel", "drive", ["m/s", "vehicle"], [Row(["0.12"], THREE)], seeds=range(1, 6)),
    Table("limits", "Limits", "limits", ["options"], of_words(
        "", "--estimator kalman", "--estimator tag-centre", "--compass-noise 2 --speed-noise 0.05", NOISE, WHITE, SLOW,
        POLLED, ("the same with `--estimator kalman`", f"{POLLED} --estimator kalman"),
        ("the same with `--estimator tag-centre`", f"{POLLED} --estimator tag-centre"),
        ROUGH, ("the same with `--estimator kalman`", f"{ROUGH} --estimator kalman"),
        QUICK, ("the same with `--estimator kalman`", f"{QUICK[1]} --estimator kalman"), "--slip 0.2"), baseline=True),
    Table("limits-other-seeds", "The same on seeds on which nothing was chosen", "limits", ["options"],
          of_words("", NOISE, WHITE, POLLED, ROUGH, QUICK), seeds=range(101, 121), baseline=True),
    Table("carried", "Carried in the middle of the drive", "carried", ["options"],
          of_words("--carry 20", "--carry 20 --estimator kalman"), seeds=range(1, 101), baseline=True),
    Table("split", "What keeps it off the line, and off the end: true / believed / mistaken, cm", "split", ["options"],
          of_words("", SLOW, ("the same with `--compass-spots 0`", f"{SLOW} --compass-spots 0")), seeds=range(1, 101)),
    Table("publication", "The publication's controller beside ours, at 2.4 kbit/s with k = 1", "drive", ["m/s", "controller"],
          PUBLICATION, words=f"--vehicle native --lockstep {SLOW}", baseline=True),
    at_speeds("aimer", "The publication's controller at 2.4 kbit/s: aims at the next control point, knows nothing of the delay",
              "--air-rate 2400 --controller control-points --limit 600", baseline=True),
    at_speeds("pursuit", "Regulated Pure Pursuit, tuned to L = 0.3 m, at 2.4 kbit/s",
              "--air-rate 2400 --controller regulated-pure-pursuit", baseline=True),
    at_speeds("tag-centre", "The locator of the publication, for comparison", "--estimator tag-centre", baseline=True),
    Table("floors", "Floors and routes of many kinds", "floor", ["floor and route"],
          [Row([name], f"--floor {number}") for name, number in tables.FLOORS], baseline=True),
    Table("slow-floors", "Diagonal and curved routes at 2.4 kbit/s, as modules are delivered", "floor", ["floor and route"],
          [Row([name], f"--floor {number}") for name, number in tables.FLOORS if "route" in name],
          words="--vehicle native --lockstep --air 2400", baseline=True),
    Table("corners", "Corners on the spot and rounded at 2.4 kbit/s, as modules are delivered", "limits", ["m/s", "cut, cm"],
          [Row([speed, f"{100 * float(cut):.0f}"], f"--speed {speed} --corner-cut {cut}") for speed in ("0.12", "0.50")
           for cut in ("0", "0.05", "0.15")], words="--vehicle native --lockstep --air 2400", baseline=True),
]

# Pictures that go with them: folder, tables that they are drawn from, the column that tells series apart, and the name in
# docs/pictures of each that the document shows.
CHARTS = [
    ("locators", ["native", "tag-centre"], "estimator",
     {"errors.png": "experiments-errors.png", "speed.png": "experiments-speed.png"}),
    ("honesty", ["native"], "speed_m_per_s", {"nees.png": "experiments-nees.png"}),
    ("controllers", ["publication"], "controller", {"tracking.png": "experiments-controllers.png"}),
]

# Pictures of single runs: where one lies in the folder of results, and its name beside the document.
TRACKS = {"native/03-0.12/1/track.png": "track-0.12.png"}
