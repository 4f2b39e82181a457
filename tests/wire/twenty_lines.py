#!/usr/bin/env python3
"""A vehicle in some twenty lines, written from docs/protocol.md alone: PORT ADDRESS KEY BEARING_DEGREES READER:UID

It is identified, tells where its nose points and which tag lies under one reader, and obeys by standing still.
It leaves out slots (it answers the first entry of a Cycle only, so it wants a host to itself), the session prepared
beside the running one (a repeated Hello ends its session until the host calls again), Hail, Get, Set, Do, faults,
and the crc of what it hears: it believes nothing without a MAC, which covers the same bytes.
"""
import binascii, hmac, os, struct, sys, time, tty  # noqa: E401

port, me, key = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY), int(sys.argv[2]), bytes.fromhex(sys.argv[3])
bearing, (reader, tag) = round(float(sys.argv[4]) / 360 * 65536) % 65536, sys.argv[5].split(":")
boot, hello, session, last, window = int.from_bytes(os.urandom(4), "little") | 1 << 31, 0, None, 0, b""
tty.setraw(port)


def seal(k, counter, to, sender, kind, body):
    return hmac.digest(k, struct.pack("<I3B", counter, to, sender, kind) + body, "sha256")[:4]


def send(k, count, kind, body):
    frame = struct.pack("<4BH", len(body) + 4, 0, me, kind, count & 0xFFFF) + body + seal(k, count, 0, me, kind, body)
    os.write(port, b"\xA5" + frame + struct.pack("<H", binascii.crc_hqx(frame, 0xFFFF)))


while byte := os.read(port, 1):
    window = (window + byte)[-58:]  # a frame has come when the last bytes look like one, whatever was before them
    for at in (i for i in range(len(window) - 8) if window[i] == 0xA5 and window[i + 1] == len(window) - i - 9):
        (to, _, kind, low), body, mac = struct.unpack("<3BH", window[at + 2:at + 7]), window[at + 7:-6], window[-6:-2]
        counter = last + 1 + (low - last - 1) % 65536  # the smallest number above `last` whose low half came
        if kind == 1 and to == me and hmac.compare_digest(seal(key, 0, me, 0, 1, body), mac):
            (nonce, last), hello, sent, began = struct.unpack("<II", body), hello + 1, 0, time.monotonic()
            session = hmac.digest(key, b"tessera session" + struct.pack("<IIH", nonce, boot, hello), "sha256")[:16]
            send(key, 0, 0x81, struct.pack("<IIH7B", nonce, boot, hello, 1, 0, 0, 1, 255, 3, 0))
        elif kind == 2 and session and body[1:2] == bytes([me]) and hmac.compare_digest(
                seal(session, counter, 255, 0, 2, body[:1] + b"\0" + body[1:9]), (body + mac)[9:13]):
            known, last, sent, age = sent > 0 and body[8] == 1, counter, sent + 1, time.monotonic() - began
            event = b"" if known else bytes([2 << 4 | int(reader), min(int(age * 100), 255)]) + bytes.fromhex(tag)
            send(session, sent, 0x82, struct.pack("<HBHHHhHH4B", low, 0, 0, int(age * 1000) & 0xFFFF, 0, 0, 0, bearing,
                                                  120, 255, 7, known) + event)
