#!/usr/bin/env python3
"""The deepest that a Cortex-M program's stack can get, from the linked program itself.

Calls are read from the disassembly: what is linked, after inlining, libraries included. A function's own frame is what
the compiler says (-fcallgraph-info=su) or, for libraries, the sum of all that it pushes. A call through a pointer (a
virtual function, say) may reach every function whose address stands anywhere in the program's data. Recursion is an
error: its depth cannot be bounded.

  total = main path + exception frame + deepest interrupt handler + exception frame + fault handler

That holds as all interrupts have one priority and so never interrupt each other.
"""
import argparse
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from elf_file import ElfFile  # noqa: E402

EXCEPTION_FRAME = 8 * 4 + 4  # eight registers, and a word to align the stack to eight bytes
INDIRECT = "(through a pointer)"

FUNCTION_LINE = re.compile(r"^([0-9a-f]+) <(.+)>:$")
INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\s+([a-z][a-z0-9.]*)\s*(.*)$")
TARGET = re.compile(r"^(?:\w+, )?([0-9a-f]+) <")
CI_NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "(?:[^"\\]|\\.)*?\\n(\d+) bytes \((\w+(?:,\w+)*)\)')


class StackError(Exception):
    """The depth cannot be bounded; the text says why."""


@dataclass
class Function:
    name: str
    address: int
    pushed: int = 0
    calls: set = field(default_factory=set)  # addresses
    indirect: bool = False


def registers_in(operand):
    """How many registers a list such as "{r4, r5-r7, lr}" names."""
    count = 0
    for part in operand.strip("{}").split(","):
        ends = re.findall(r"\d+", part)
        count += int(ends[1]) - int(ends[0]) + 1 if "-" in part and len(ends) == 2 else 1
    return count


def bytes_pushed(mnemonic, operands):
    """By how much an instruction makes the stack deeper."""
    name = mnemonic.split(".")[0]
    if name == "push":
        return 4 * registers_in(operands)
    if name == "vpush":
        return (8 if "d" in operands else 4) * registers_in(operands)
    if name in ("stmdb", "stmfd") and operands.startswith("sp!"):
        return 4 * registers_in(operands[operands.index("{"):])
    if name in ("sub", "subw") and re.match(r"sp, (sp, )?#\d+", operands):
        return int(re.search(r"#(\d+)", operands).group(1))
    if name in ("sub", "subw") and operands.startswith("sp,"):
        raise StackError(f"takes a stack frame of variable size: {mnemonic} {operands}")
    pre_indexed = re.search(r"\[sp, #-(\d+)\]!", operands)
    return int(pre_indexed.group(1)) if name.startswith("str") and pre_indexed else 0


def parse_disassembly(text):
    """Functions by address, from `objdump -d --no-show-raw-insn`."""
    functions = {}
    current = None
    for line in text.splitlines():
        start = FUNCTION_LINE.match(line)
        if start:
            current = Function(start.group(2), int(start.group(1), 16))
            functions[current.address] = current
            continue
        match = INSTRUCTION.match(line)
        if current is None or not match:
            continue
        mnemonic, operands = match.group(2), match.group(3).split("@")[0].split(";")[0].strip()
        try:
            current.pushed += bytes_pushed(mnemonic, operands)
        except StackError as error:
            raise StackError(f"{current.name} {error}") from None
        name = mnemonic.split(".")[0]
        if name.startswith("b") and name not in ("bic", "bics", "bkpt", "bfi", "bfc"):
            target = TARGET.match(operands)
            if target:
                current.calls.add(int(target.group(1), 16))
            elif name in ("blx", "bx") and operands != "lr":
                current.indirect = True
    for function in functions.values():  # jumps within a function are no calls
        function.calls = {target for target in function.calls if target in functions and target != function.address}
    return functions


def parse_callgraph(text):
    """Frame sizes by (mangled) name, from GCC's .ci files."""
    frames = {}
    for line in text.splitlines():
        node = CI_NODE.match(line)
        if not node:
            continue
        name = node.group(1).rsplit(":", 1)[-1]
        if node.group(3) not in ("static", "dynamic,bounded"):
            raise StackError(f"{name} takes a stack frame of variable size")
        frames[name] = max(frames.get(name, 0), int(node.group(2)))
    return frames


class CallGraph:
    def __init__(self, functions, frames, pointed_at):
        self.functions = functions
        self.frames = frames
        self.pointed_at = sorted(a for a in pointed_at if a in functions)
        self._known = {}

    def frame(self, function):
        return self.frames.get(function.name, function.pushed)

    def deepest(self, address):
        """(bytes, [names from here down]) of the deepest path that starts at a function."""
        return self._deepest(address, [])

    def _deepest(self, address, above):
        if address in self._known:
            return self._known[address]
        function = self.functions[address]
        if address in above:
            names = [self.functions[a].name for a in above[above.index(address):]]
            raise StackError("recursion: " + " -> ".join(names + [function.name]))
        best = (0, [])
        path = above + [address]
        for target in sorted(function.calls):
            best = max(best, self._deepest(target, path), key=lambda found: found[0])
        if function.indirect:
            for target in self.pointed_at:
                depth, names = self._deepest(target, path)
                best = max(best, (depth, [INDIRECT] + names), key=lambda found: found[0])
        frame = self.frame(function)
        self._known[address] = (frame + best[0], [f"{function.name} {frame}"] + best[1])
        return self._known[address]


@dataclass
class Report:
    main: tuple
    interrupt: tuple
    fault: tuple
    available: int

    @property
    def total(self):
        return self.main[0] + 2 * EXCEPTION_FRAME + self.interrupt[0] + self.fault[0]


def code_pointers(elf, functions, excluded):
    """Addresses of functions that stand as data: in data sections, and between the instructions ($d marks)."""
    marks = sorted((s.value, s.name[:2]) for s in elf.symbols if s.name[:2] in ("$t", "$d", "$a"))
    ranges = [(at, following[0]) for (at, kind), following in zip(marks, marks[1:] + [(1 << 32, "")]) if kind == "$d"]
    found = set()
    for start, end in ranges:
        for address, word in elf.words(start, end):
            if word & 1 and word - 1 in functions and not any(a <= address < b for a, b in excluded):
                found.add(word - 1)
    return found


def analyse(elf, disassembly, callgraphs):
    functions = parse_disassembly(disassembly)
    frames = {}
    for text in callgraphs:
        for name, size in parse_callgraph(text).items():
            frames[name] = max(frames.get(name, 0), size)
    vectors = next(s for s in elf.symbols if s.name.endswith("vectorsE") or s.name == "vectors")
    table = [word for _, word in elf.words(vectors.value, vectors.value + vectors.size)]
    constructors = (elf.value_of("constructorsStart"), elf.value_of("constructorsEnd"))
    excluded = [(vectors.value, vectors.value + vectors.size), constructors]
    graph = CallGraph(functions, frames, code_pointers(elf, functions, excluded))

    reset, fault = table[1] & ~1, table[2] & ~1
    # What the start-up code calls through pointers are the constructors, and nothing else.
    functions[reset].indirect = False
    functions[reset].calls |= {word & ~1 for _, word in elf.words(*constructors)}
    handlers = {word & ~1 for word in table[2:]} - {fault}
    interrupt = max((graph.deepest(h) for h in handlers), key=lambda found: found[0], default=(0, []))
    available = elf.value_of("stackTop") - elf.value_of("stackBottom")
    return Report(graph.deepest(reset), interrupt, graph.deepest(fault), available)


def analyse_files(program, callgraph_directories, objdump):
    disassembly = subprocess.run([objdump, "-d", "--no-show-raw-insn", program], check=True, capture_output=True,
                                 text=True).stdout
    files = [path for directory in callgraph_directories for path in sorted(Path(directory).rglob("*.ci"))]
    return analyse(ElfFile.read(program), disassembly, [path.read_text() for path in files])


def describe(report):
    lines = [f"stack: {report.total} of {report.available} bytes at worst: program {report.main[0]}, "
             f"interrupt {report.interrupt[0]}, fault {report.fault[0]}, two exception frames of {EXCEPTION_FRAME}"]
    lines += [f"  {name}" for name in report.main[1]]
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the linked ELF")
    parser.add_argument("--callgraph", required=True, action="append", help="folder with the compiler's .ci files")
    parser.add_argument("--objdump", default="arm-none-eabi-objdump")
    arguments = parser.parse_args()
    try:
        report = analyse_files(arguments.program, arguments.callgraph, arguments.objdump)
    except StackError as error:
        print(f"stack: not bounded: {error}", file=sys.stderr)
        return 1
    print("\n".join(describe(report)))
    return 0 if report.total <= report.available else 1


if __name__ == "__main__":
    sys.exit(main())
