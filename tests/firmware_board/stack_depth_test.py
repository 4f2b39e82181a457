#!/usr/bin/env python3
"""Tests of firmware/tools: what is read from a disassembly, a call graph, an ELF."""
import struct
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "firmware" / "tools"))
import firmware_report  # noqa: E402
import stack_depth  # noqa: E402
from elf_file import ElfFile, Symbol  # noqa: E402

DISASSEMBLY = """
00000100 <outer>:
     100:\tpush\t{r4, r5, r6, lr}
     102:\tsub\tsp, #16
     104:\tbl\t200 <middle>
     108:\tbeq.n\t10c <outer+0xc>
     10c:\tadd\tsp, #16
     10e:\tpop\t{r4, r5, r6, pc}

00000200 <middle>:
     200:\tstmdb\tsp!, {r4, r5, r6, r7, r8, r9, sl, fp, lr}
     204:\tblx\tr3
     206:\tb.w\t300 <leaf>

00000300 <leaf>:
     300:\tstr.w\tr4, [sp, #-4]!
     302:\tbx\tlr
     304:\t.word\t0x00000401

00000400 <pointed>:
     400:\tpush\t{r0-r3, lr}
     402:\tpop\t{r0-r3, pc}
"""


def graph(text=DISASSEMBLY, frames=None, pointed_at=(0x400,)):
    return stack_depth.CallGraph(stack_depth.parse_disassembly(text), frames or {}, pointed_at)


class Disassembly(unittest.TestCase):
    def test_frames_and_calls_are_read(self):
        functions = stack_depth.parse_disassembly(DISASSEMBLY)
        self.assertEqual({f.name: f.pushed for f in functions.values()},
                         {"outer": 32, "middle": 36, "leaf": 4, "pointed": 20})
        self.assertEqual(functions[0x100].calls, {0x200}, "a jump within a function is no call")
        self.assertEqual(functions[0x200].calls, {0x300}, "a jump to another function is one")
        self.assertEqual([f.name for f in functions.values() if f.indirect], ["middle"])

    def test_a_frame_of_variable_size_is_refused(self):
        with self.assertRaisesRegex(stack_depth.StackError, "f takes a stack frame of variable size"):
            stack_depth.parse_disassembly("00000100 <f>:\n     100:\tsub.w\tsp, sp, r3\n")
        self.assertEqual(stack_depth.bytes_pushed("sub.w", "sp, sp, #1024"), 1024)
        self.assertEqual(stack_depth.bytes_pushed("sub", "r0, #4"), 0)
        self.assertEqual(stack_depth.bytes_pushed("bx", "lr"), 0)


class Depth(unittest.TestCase):
    def test_the_deepest_path_goes_through_pointers_too(self):
        depth, path = graph().deepest(0x100)
        self.assertEqual(depth, 32 + 36 + 20)
        self.assertEqual(path, ["outer 32", "middle 36", stack_depth.INDIRECT, "pointed 20"])

    def test_what_the_compiler_says_of_a_frame_counts(self):
        self.assertEqual(graph(frames={"middle": 100}).deepest(0x100)[0], 32 + 100 + 20)

    def test_recursion_is_an_error_that_names_the_circle(self):
        with self.assertRaisesRegex(stack_depth.StackError, "recursion: middle -> middle"):
            graph(pointed_at=(0x200,)).deepest(0x100)

    def test_the_total_adds_an_interrupt_and_a_fault_to_the_program(self):
        report = stack_depth.Report((100, []), (50, []), (10, []), 1000)
        self.assertEqual(report.total, 100 + 36 + 50 + 36 + 10)


class CallGraphFile(unittest.TestCase):
    def test_frames_are_read_with_or_without_the_files_name(self):
        frames = stack_depth.parse_callgraph(
            'node: { title: "_Z1fv" label: "void f()\\na.cpp:1:2\\n24 bytes (static)" }\n'
            'node: { title: "a.cpp:_ZL1gv" label: "g \\"quoted\\"\\na.cpp:3:4\\n8 bytes (dynamic,bounded)" }\n'
            'node: { title: "memcpy" label: "memcpy\\n<built-in>" shape : ellipse }\n')
        self.assertEqual(frames, {"_Z1fv": 24, "_ZL1gv": 8})

    def test_an_unbounded_frame_is_refused(self):
        with self.assertRaises(stack_depth.StackError):
            stack_depth.parse_callgraph('node: { title: "f" label: "f\\na:1:1\\n24 bytes (dynamic)" }')


def elf_with(sections, symbols):
    """A small ELF. sections: (name, type, flags, address, bytes or size); symbols: (name, value, size, type)."""
    strings, names = b"\0", b"\0"
    table = bytes(16)
    for name, value, size, kind in symbols:
        table += struct.pack("<IIIBBH", len(strings), value, size, kind, 0, 1)
        strings += name.encode() + b"\0"
    count = len(sections) + 1
    everything = [("", 0, 0, 0, b"", 0)] + [(*s, 0) for s in sections]
    everything += [(".symtab", 2, 0, 0, table, count + 1), (".strtab", 3, 0, 0, strings, 0)]
    names_index = len(everything)
    everything.append((".shstrtab", 3, 0, 0, None, 0))
    starts = []
    for section in everything:
        starts.append(len(names))
        names += section[0].encode() + b"\0"
    body, headers = b"", b""
    for section, start in zip(everything, starts):
        name, kind, flags, address, data, link = section
        data = names if data is None else data
        size = data if isinstance(data, int) else len(data)
        headers += struct.pack("<10I", start, kind, flags, address, 52 + len(body), size, link, 0, 4, 0)
        body += b"" if isinstance(data, int) else data
    header = b"\x7fELF\x01\x01\x01" + bytes(9) + struct.pack("<HHIIIIIHHHHHH", 2, 40, 1, 0, 0, 52 + len(body), 0, 52,
                                                             0, 0, 40, len(everything), names_index)
    return header + body + headers


class Elf(unittest.TestCase):
    WORDS = struct.pack("<4I", 0x401, 0x400, 0x301, 0x999)

    def example(self, extra=()):
        return ElfFile(elf_with(
            [(".text", 1, 6, 0x1000, self.WORDS), (".data", 1, 3, 0x20000000, bytes(8)), (".bss", 8, 3, 0x20000008, 100),
             (".comment", 1, 0, 0, b"no memory")],
            [("$t", 0x0, 0, 0), ("$d", 0x1000, 0, 0), ("stackTop", 0x20002000, 0, 0), *extra]))

    def test_sections_count_where_they_lie(self):
        self.assertEqual(firmware_report.sizes(self.example()), (16 + 8, 8 + 100))

    def test_symbols_are_found_by_name(self):
        self.assertEqual(self.example().value_of("stackTop"), 0x20002000)
        with self.assertRaises(KeyError):
            self.example().value_of("nothing")

    def test_only_odd_words_that_name_a_function_are_pointers(self):
        functions = stack_depth.parse_disassembly(DISASSEMBLY)
        self.assertEqual(stack_depth.code_pointers(self.example(), functions, []), {0x400, 0x300})
        self.assertEqual(stack_depth.code_pointers(self.example(), functions, [(0x1008, 0x100C)]), {0x400})

    def test_a_heap_is_noticed(self):
        self.assertEqual(firmware_report.forbidden_symbols(self.example()), [])
        grown = self.example([("malloc", 0x1001, 4, 2), ("_Znwj", 0x1001, 4, 2), ("freeze", 0x1001, 4, 2)])
        self.assertEqual(firmware_report.forbidden_symbols(grown), ["_Znwj", "malloc"])

    def test_what_is_no_elf_is_refused(self):
        with self.assertRaises(ValueError):
            ElfFile(b"MZ something else entirely")

    def test_thumb_addresses_are_even(self):
        self.assertEqual(Symbol("f", 0x101, 4, 2).address, 0x100)


if __name__ == "__main__":
    unittest.main()
