#!/usr/bin/env python3
"""A vehicle that stands still, written from docs/protocol.md alone: PORT ADDRESS KEY BEARING_DEGREES [READER:UID ...]

It is identified, says where its nose points and which tags lie under its readers, and obeys by standing.
"""
import binascii, hashlib, hmac, os, select, struct, sys, termios, time, tty  # noqa: E401

port, me, key = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY), int(sys.argv[2]), bytes.fromhex(sys.argv[3])
bearing, start = round(float(sys.argv[4]) / 360 * 65536) % 65536, time.monotonic()
tags = [({8: 1, 14: 2, 20: 3}[len(uid)] << 4 | int(reader), bytes.fromhex(uid)) for reader, uid in (t.split(":") for t in sys.argv[5:])]
boot, hellos, sent, running, prepared = int.from_bytes(os.urandom(4), "little") | 1 << 31, 0, 0, None, None
first, told, began, buffer = 0, 0, start, b""  # events before `first` are acknowledged, those before `told` were reported
if os.isatty(port):
    tty.setraw(port, termios.TCSANOW)


def mac(k, counter, to, sender, kind, body):
    return hmac.digest(k, struct.pack("<IBBB", counter, to, sender, kind) + body, hashlib.sha256)[:4]


def send(k, counter, kind, body):
    frame = struct.pack("<BBBBH", len(body) + 4, 0, me, kind, counter & 0xFFFF) + body + mac(k, counter, 0, me, kind, body)
    os.write(port, b"\xA5" + frame + struct.pack("<H", binascii.crc_hqx(frame, 0xFFFF)))


def accepted(low, to, kind, body, tag):
    global running, prepared, sent, first, told, began
    for s in filter(None, (running, prepared)):
        c = (s["last"] & 0xFFFF0000 | low) + (0x10000 if s["last"] & 0xFFFF >= low else 0)
        if hmac.compare_digest(mac(s["key"], c, to, 0, kind, body), tag):
            if s is prepared:
                prepared, sent, first, told, began = None, 0, 0, 0, time.monotonic()
            running, s["last"], sent = s, c, sent + 1
            return True


def take(to, sender, kind, low, payload, at):
    global hellos, prepared, first, told
    body, tag = payload[:-4], payload[-4:]
    if kind == 1 and to == me and low == 0 and hmac.compare_digest(mac(key, 0, to, 0, 1, body), tag):
        nonce, last = struct.unpack("<II", body)
        if not prepared or prepared["nonce"] != nonce:
            if hellos == 65535:
                return
            hellos += 1
            text = b"tessera session" + struct.pack("<IIH", nonce, boot, hellos)
            prepared = {"nonce": nonce, "last": last, "key": hmac.digest(key, text, hashlib.sha256)[:16]}
        send(key, 0, 0x81, struct.pack("<IIH7B", nonce, boot, hellos, 1, 0, 0, 1, 255, 3, 0))
    elif kind == 2 and to == 255 and len(payload) % 12 == 1 and me in payload[1::12]:
        i = payload[1::12].index(me)
        entry = payload[1 + 12 * i:13 + 12 * i]
        good = accepted(low, 255, 2, bytes([payload[0], i]) + entry[:8], entry[8:])
        time.sleep(max(0, at + i * payload[0] * 0.004 - time.monotonic()))
        if good:
            first = entry[7] if first <= entry[7] <= told else first
            told = min(len(tags), first + 2)
            now = time.monotonic()
            age = min(255, int((now - began) * 100))  # it stands: the tags were read when the session began
            send(running["key"], sent, 0x82, struct.pack(
                "<HBHHHhHHBBBB", low, 0, 0, int((now - start) * 1000) & 0xFFFF, int((now - at) * 1000), 0, 0, bearing,
                120, 255, 7, first) + b"".join(bytes([head, age]) + uid for head, uid in tags[first:told]))
        elif not running:
            send(key, 0, 0x84, struct.pack("<IB", boot, 0))
    elif kind in (3, 4, 5) and to == me and accepted(low, to, kind, body, tag):
        send(running["key"], sent, 0x83, struct.pack("<HBBi", low, body[0], 2, 0))  # 2: it knows no parameters


while True:
    quiet = not select.select([port], [], [], 0.02)[0]
    buffer = buffer[1:] if quiet else buffer + os.read(port, 256)
    while (buffer := buffer[buffer.find(b"\xA5"):] if b"\xA5" in buffer else b"") and len(buffer) > 1:
        size = buffer[1] + 9
        if size <= 58 and len(buffer) < size:
            break
        good = size <= 58 and struct.pack("<H", binascii.crc_hqx(buffer[1:size - 2], 0xFFFF)) == buffer[size - 2:size]
        if good and buffer[3] == 0:
            take(*struct.unpack("<BBBH", buffer[2:7]), buffer[7:size - 2], time.monotonic())
        buffer = buffer[size if good else 1:]
