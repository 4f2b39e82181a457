#!/usr/bin/env python3
"""Printed at every link of the firmware: flash, RAM, worst-case stack. Fails when one does not fit or when the program
has grown a heap or exceptions."""
import argparse
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import stack_depth  # noqa: E402
from elf_file import ElfFile  # noqa: E402

FLASH, RAM = 256 * 1024, 64 * 1024
RAM_START = 0x20000000
FORBIDDEN = re.compile(r"^_?(malloc|calloc|realloc|free|_malloc_r|_free_r|sbrk|_sbrk_r)$|^_Zn[wa]|^_Zd[la]|"
                       r"^__cxa_(throw|allocate_exception|begin_catch)$")


def sizes(elf):
    """(flash, RAM) in bytes. Initialised data takes both."""
    flash = ram = 0
    for section in elf.sections:
        if not section.loaded:
            continue
        if section.address >= RAM_START:
            ram += section.size
            flash += section.size if section.has_content else 0
        else:
            flash += section.size
    return flash, ram


def forbidden_symbols(elf):
    return sorted({s.name for s in elf.symbols if FORBIDDEN.match(s.name)})


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the linked ELF")
    parser.add_argument("--callgraph", required=True, action="append", help="folder with the compiler's .ci files")
    parser.add_argument("--objdump", default="arm-none-eabi-objdump")
    arguments = parser.parse_args()

    elf = ElfFile.read(arguments.program)
    flash, ram = sizes(elf)
    name = Path(arguments.program).stem
    print(f"{name}: flash {flash} of {FLASH} bytes ({100 * flash / FLASH:.1f} %), "
          f"RAM {ram} of {RAM} bytes ({100 * ram / RAM:.1f} %) with the stack's room")
    faults = []
    if flash > FLASH or ram > RAM:
        faults.append("it does not fit the chip")
    heap = forbidden_symbols(elf)
    if heap:
        faults.append("it must not use a heap or exceptions, but holds " + ", ".join(heap))
    try:
        report = stack_depth.analyse_files(arguments.program, arguments.callgraph, arguments.objdump)
        print(f"{name}: " + "\n".join(stack_depth.describe(report)))
        if report.total > report.available:
            faults.append("its stack may overflow")
    except stack_depth.StackError as error:
        faults.append(f"its stack is not bounded: {error}")
    for fault in faults:
        print(f"{name}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
