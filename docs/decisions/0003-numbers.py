#!/usr/bin/env python3
"""The numbers of decision 0003: bytes, airtimes, and what a forger needs. Airtime: LoRa formula (Semtech AN1200.13) as in
core/wire/airtime.h, for modules as fast as their data sheet; in the field they take one to three times as long."""
from math import ceil

RATES = {"19.2k": (7, 500e3), "9.6k": (8, 500e3), "2.4k": (11, 500e3)}
PACKET, OVERHEAD = 58, 9


def airtime(size, rate):
    factor, bandwidth = RATES[rate]
    blocks = max(0, ceil((8 * size - 4 * factor + 44) / (4 * factor)))
    return (8 + 4.25 + 8 + 5 * blocks) * 2 ** factor / bandwidth


def row(*cells):
    print("| " + " | ".join(str(c) for c in cells) + " |")


print("Frames, whole, in bytes and ms on the air:\n")
row("frame", "bytes", *RATES)
row(*["---"] * (2 + len(RATES)))
frames = {"Hello": 21, "Identity": 30, "Cycle, 1 vehicle": 22, "Cycle, 2": 34, "Cycle, 4": 58,
          "Report, no event": 32, "Report, one tag of 7 bytes": 41, "Report, longest": 58}
for name, size in frames.items():
    row(name, size, *(f"{1000 * airtime(size, r):.0f}" for r in RATES))

print("\nVehicles in a Cycle, and bytes for events in a Report, by length of MAC and of the counter sent:\n")
row("MAC", "counter", "vehicles in a Cycle", "event bytes in a Report")
row(*["---"] * 4)
for mac in (4, 8, 16):
    for counter in (2, 4):
        room = PACKET - OVERHEAD + 2 - counter
        row(mac, counter, (room - 1) // (8 + mac), room - 19 - mac)

print("\nForging a command (one entry, 22 bytes) by sending one try after the other, with nobody else on the air:\n")
for rate in RATES:
    tries = 1 / airtime(22, rate)
    print(f"- {rate}: {tries:.0f} tries a second; half of 2^32 take {2 ** 31 / tries / 86400 / 365:.1f} years")

print(f"\nA counter of 16 bits lasts {65536 * 0.1 / 3600:.1f} h at ten frames a second, of 32 bits {2 ** 32 * 0.1 / 86400 / 365:.0f} years")
