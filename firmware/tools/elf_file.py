"""Reads what the firmware's reports need from a 32-bit little-endian ELF: sections, symbols, words."""
import struct
from dataclasses import dataclass


@dataclass(frozen=True)
class Section:
    name: str
    type: int
    flags: int
    address: int
    data: bytes
    size: int

    @property
    def loaded(self):  # occupies memory on the chip
        return bool(self.flags & 2)

    @property
    def has_content(self):  # SHT_NOBITS has none in the file
        return self.type != 8


@dataclass(frozen=True)
class Symbol:
    name: str
    value: int
    size: int
    type: int  # 0 none, 1 object, 2 function

    @property
    def is_function(self):
        return self.type == 2

    @property
    def address(self):  # bit 0 of a Thumb function's value is no part of it
        return self.value & ~1 if self.is_function else self.value


class ElfFile:
    def __init__(self, content):
        if content[:6] != b"\x7fELF\x01\x01":
            raise ValueError("not a 32-bit little-endian ELF file")
        offset, = struct.unpack_from("<I", content, 32)
        entry_size, count, names_index = struct.unpack_from("<HHH", content, 46)
        headers = [struct.unpack_from("<10I", content, offset + i * entry_size) for i in range(count)]
        names = headers[names_index]
        self.sections = []
        for name, kind, flags, address, start, size, *_ in headers:
            data = b"" if kind == 8 else content[start:start + size]
            self.sections.append(Section(_text(content, names[4] + name), kind, flags, address, data, size))
        self.symbols = []
        for header in headers:
            if header[1] != 2:  # SHT_SYMTAB
                continue
            strings = headers[header[6]][4]
            for at in range(header[4], header[4] + header[5], 16):
                name, value, size, info, _, _ = struct.unpack_from("<IIIBBH", content, at)
                self.symbols.append(Symbol(_text(content, strings + name), value, size, info & 15))

    @staticmethod
    def read(path):
        with open(path, "rb") as file:
            return ElfFile(file.read())

    def value_of(self, name):
        """The value of the linker's symbol `name`; KeyError when there is none."""
        for symbol in self.symbols:
            if symbol.name == name:
                return symbol.value
        raise KeyError(name)

    def words(self, start, end):
        """(address, value) of the aligned words in [start, end) that the file holds."""
        for section in self.sections:
            if not section.loaded or not section.has_content:
                continue
            first = max(start, section.address + 3 & ~3)
            last = min(end, section.address + len(section.data))
            for address in range(first, last - 3, 4):
                yield address, struct.unpack_from("<I", section.data, address - section.address)[0]


def _text(content, at):
    return content[at:content.index(b"\0", at)].decode()
