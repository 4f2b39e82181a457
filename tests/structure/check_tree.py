#!/usr/bin/env python3
"""Holds the source tree to docs/architecture.md: who may include whom, where Qt, clocks and the heap may be used, and
how long a file may be. Prints one line for each violation; exit code 1 when there is any."""
import re
import sys
from pathlib import Path

MAX_LINES = 300
SKIPPED = {".git", ".cache", "build", "out", "__pycache__"}
CODE = {".h", ".cpp"}
COUNTED = CODE | {".py", ".sh", ".cmake", ".s", ".S", ".ld"}

# The edges to the real machine: the only places in the logic that may know clocks, threads, sockets. The cell in which
# snapshots pass from thread to thread stands with them, but needs no Qt, so that ThreadSanitizer sees it.
EDGES = re.compile(r"core/(host|store|sitecheck/live|sim/qemu|sim/pty)/|core/supervisor/latest_value\.h$")
QT_ALLOWED = re.compile(r"core/(host|store)/")
LOGIC = re.compile(r"core/|firmware/vehicle/|app/experiment/")
NO_HEAP = re.compile(r"core/wire/|firmware/vehicle/|firmware/boards/lm3s6965/")

QT = re.compile(r'#\s*include\s*[<"](Q\w+[>/"]|q\w+\.h)|\bQ(Object|String|Thread|Timer|ByteArray)\b')
CLOCK = re.compile(r"#\s*include\s*<(thread|mutex|shared_mutex|condition_variable|future|semaphore|stop_token|ctime|time\.h|"
                   r"poll\.h|pthread\.h|termios\.h|sys/(time|socket|select|epoll|wait)\.h)>|"
                   r"\bstd::(random_device|this_thread|j?thread)\b|\b(steady|system|high_resolution)_clock\b|"
                   r"\b(clock_gettime|gettimeofday|usleep|nanosleep)\b|\bsleep\s*\(")
HEAP = re.compile(r"#\s*include\s*<(string|vector|map|set|deque|list|memory|functional|iostream|sstream)>|"
                  r"\bstd::(vector|string|function|map|deque|list|make_unique|make_shared)\b|\bthrow\b|"
                  r"\b(malloc|calloc|realloc)\s*\(|=\s*new\b|\breturn\s+new\b")
# Bytes taken for something wider may lie askew: only where UBSan looks for it (TESSERA_ALIGNMENT of the preset asan).
ALIGNMENT = re.compile(r"core/wire/|firmware/|ui/canvas/")
WIDER = re.compile(r"\breinterpret_cast<(?!(const )?(unsigned |std::)?(char|uint8_t|byte|sockaddr)\s*\*)")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
LIBRARY = re.compile(r"\btessera_library\(([^)]*)\)")
LINKING = re.compile(r"\btarget_link_libraries\(([^)]*)\)")


def without_comments(text):
    """The code alone; strings other than those of #include are emptied, line numbers stay."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#[ \t]*include[^\n]*|"(?:\\.|[^"\\\n])*"', re.DOTALL | re.MULTILINE)

    def keep(match):
        piece = match.group(0)
        if piece.lstrip().startswith("#"):
            return re.sub(r"//.*", "", piece)
        return '""' if piece.startswith('"') else "\n" * piece.count("\n")

    return pattern.sub(keep, text)


def closure(direct):
    """For each name all that it reaches, itself included; raises ValueError when an arrow leads back."""
    reached = {}

    def visit(name, path):
        if name in path:
            raise ValueError("a circle: " + " -> ".join(path[path.index(name):] + [name]))
        if name not in reached:
            reached[name] = {name}.union(*(visit(d, path + [name]) for d in direct.get(name, ())))
        return reached[name]

    for name in direct:
        visit(name, [])
    return reached


def read_plan(text):
    """The table of docs/architecture.md as {folder: [folders it knows]}."""
    rows = re.findall(r"^\| `([^`]+)` \|.*\| ([^|]+) \|$", text, re.MULTILINE)
    folders = [folder for folder, _ in rows]
    plan = {}
    for folder, knows in rows:
        names = [] if knows.strip() == "nothing" else [n.strip() for n in knows.split(",")]
        plan[folder] = [n if n in folders else f"core/{n}" for n in names]
        for name in plan[folder]:
            if name not in folders:
                raise ValueError(f"{folder} knows {name}, which has no row")
    return plan


class Tree:
    def __init__(self, root):
        self.root = Path(root)
        self.problems = []
        self.files = sorted(f for f in self.root.rglob("*") if f.is_file()
                            and not SKIPPED & set(f.relative_to(self.root).parts))

    def name(self, path):
        return path.relative_to(self.root).as_posix()

    def complain(self, path, what, line=None):
        self.problems.append(f"{self.name(path)}{f':{line}' if line else ''}: {what}")

    def check(self):
        table = self.root / "docs/architecture.md"
        try:
            plan = read_plan(table.read_text())
            allowed = closure(plan)
        except (OSError, ValueError) as error:
            self.complain(table, str(error))
            return self.problems
        libraries = self.check_libraries(allowed)
        for path in self.files:
            self.check_length(path)
            if path.name.endswith("_test.cpp"):
                self.check_is_built(path)
            if path.suffix in CODE:
                text = without_comments(path.read_text())
                if self.name(path).split("/")[0] in ("core", "firmware", "ui", "app"):
                    self.check_includes(path, text, allowed, libraries)
                    self.check_words(path, text)
                if path.suffix == ".h" and "#pragma once" not in text:
                    self.complain(path, "has no #pragma once")
        return self.problems

    def check_length(self, path):
        if path.suffix in COUNTED or path.name in ("dev", "CMakeLists.txt"):
            lines = path.read_text().count("\n")
            if lines > MAX_LINES:
                self.complain(path, f"has {lines} lines; {MAX_LINES} are the limit")

    def check_is_built(self, path):
        """A test that no CMakeLists.txt names is compiled by nobody and never fails."""
        for folder in [f for f in path.parents if f == self.root or self.root in f.parents]:
            listing = folder / "CMakeLists.txt"
            if listing.is_file() and re.search(rf"(?<![\w.-]){re.escape(path.stem)}(\.cpp)?(?![\w.-])", listing.read_text()):
                return
        self.complain(path, "stands in no CMakeLists.txt")

    def folder_of(self, path, plan):
        """The row of the plan that a file belongs to."""
        name = self.name(path)
        return max((f for f in plan if name.startswith(f + "/")), key=len, default=None)

    def read_libraries(self, plan):
        """{library or program: (its CMakeLists.txt, its folder, the libraries that it links)}"""
        targets = {}
        for path in (f for f in self.files if f.name == "CMakeLists.txt"):
            text = re.sub(r"#.*", "", path.read_text())
            if "project(" in text and path.parent != self.root:  # a build of its own: its includes follow the plan alone
                continue
            for call in LIBRARY.findall(text):
                name, *words = call.split()
                parts, key = {"SOURCES": [], "DEPS": [], "LIBS": []}, None
                for word in words:
                    if word in parts:
                        key = word
                    elif key:
                        parts[key].append(word)
                source = next((s for s in parts["SOURCES"] if "$" not in s), "anything")
                folder = self.folder_of(path.parent / source, plan)
                # A list of sources in a variable says no folder: the name does.
                folder = folder or next((f for f in plan if f.replace("/", "_") == name), None)
                targets[name] = (path, folder, parts["DEPS"])
            for call in LINKING.findall(text):
                name, *words = call.split()
                name = name.removeprefix("tessera_")
                _, folder, deps = targets.setdefault(name, (path, self.folder_of(path.parent / "x", plan), []))
                deps += [w.removeprefix("tessera_") for w in words if w.startswith("tessera_")]
        return {n: (p, f, [d for d in deps if d != "options"]) for n, (p, f, deps) in targets.items()
                if self.name(p).split("/")[0] not in ("tests", "bench", "installer")}

    def check_libraries(self, allowed):
        """{folder: folders that its libraries' DEPS reach}; holds DEPS to the plan."""
        targets = self.read_libraries(allowed)
        for name, (path, folder, deps) in targets.items():
            if folder is None:
                self.complain(path, f"{name} lies in a folder that docs/architecture.md does not list")
                continue
            for dep in deps:
                if dep not in targets:
                    self.complain(path, f"{name} has DEPS {dep}, which no tessera_library declares")
                elif targets[dep][1] not in allowed[folder]:
                    self.complain(path, f"{folder} may not know {targets[dep][1]} (DEPS of {name})")
        reach = {}
        try:
            reached_by = closure({n: [d for d in deps if d in targets] for n, (_, _, deps) in targets.items()})
        except ValueError as error:
            self.complain(self.root / "CMakeLists.txt", str(error))
            return reach
        for name, reached in reached_by.items():
            reach.setdefault(targets[name][1], set()).update(targets[r][1] for r in reached)
        return reach

    def check_includes(self, path, text, allowed, libraries):
        own = self.folder_of(path, allowed)
        if own is None:
            self.complain(path, "lies in a folder that docs/architecture.md does not list")
            return
        for match in INCLUDE.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            target = next((c for c in (path.parent / match[1], self.root / "core" / match[1], self.root / match[1])
                           if c.is_file()), None)
            if target is None:
                self.complain(path, f'includes "{match[1]}", which is not in the tree', line)
                continue
            other = self.folder_of(target.resolve(), allowed) if target.resolve().is_relative_to(self.root) else None
            if other not in allowed[own]:
                self.complain(path, f'includes "{match[1]}", but {own} may not know {other}', line)
            elif own in libraries and other not in libraries[own]:
                self.complain(path, f'includes "{match[1]}", but the DEPS of {own} do not lead to {other}', line)

    def check_words(self, path, text):
        name = self.name(path)
        rules = []
        if LOGIC.match(name) and not QT_ALLOWED.match(name):
            rules.append((QT, "Qt in the logic"))
        if LOGIC.match(name) and not EDGES.match(name):
            rules.append((CLOCK, "a clock, sleep, thread or port in the logic"))
        if NO_HEAP.match(name):
            rules.append((HEAP, "heap or exceptions in code that the firmware compiles"))
        if not ALIGNMENT.match(name):
            rules.append((WIDER, "a cast to more than bytes where nothing looks for alignment"))
        for pattern, what in rules:
            for match in pattern.finditer(text):
                self.complain(path, f"{what}: {match[0].strip()}", text.count("\n", 0, match.start()) + 1)


if __name__ == "__main__":
    found = Tree(Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()).check()
    print("\n".join(found) if found else "the tree keeps its rules")
    sys.exit(1 if found else 0)
