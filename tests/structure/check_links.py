#!/usr/bin/env python3
"""Holds the documents to what they link: each relative link leads to a file, each picture of docs/pictures is shown or
linked by some document and small enough to be kept. Prints one line for each fault; exit code 1 when there is any."""
import re
import sys
from pathlib import Path

SKIPPED = {".git", ".cache", "build", "out", "__pycache__"}
MOST_BYTES = 300_000
FENCED = re.compile(r"^(```|~~~).*?^\1", re.DOTALL | re.MULTILINE)
SPAN = re.compile(r"`[^`\n]*`")
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?[^)]*\)")


def links_of(text):
    """What a document in Markdown links, without the parts that are code."""
    return LINK.findall(SPAN.sub("", FENCED.sub("", text)))


def documents(root):
    """All Markdown files outside of build trees."""
    for path in sorted(root.rglob("*.md")):
        above = path.relative_to(root).parents
        if not SKIPPED & set(path.relative_to(root).parts) and \
                not any((root / p / "CMakeCache.txt").exists() for p in above if p != Path(".")):
            yield path


def check(root):
    problems = []
    linked = set()
    for document in documents(root):
        for link in links_of(document.read_text(encoding="utf-8")):
            target = link.split("#")[0]
            if not target or re.match(r"[a-z]+:", target):
                continue
            path = (document.parent / target).resolve()
            linked.add(path)
            if not path.exists():
                problems.append(f"{document.relative_to(root)}: there is no {target}")
    for picture in sorted((root / "docs/pictures").glob("*.png")):
        name = picture.relative_to(root)
        if picture.resolve() not in linked:
            problems.append(f"{name}: no document shows it")
        if picture.stat().st_size > MOST_BYTES:
            problems.append(f"{name}: {picture.stat().st_size} bytes, more than {MOST_BYTES}")
    return problems


def main():
    problems = check(Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve())
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
