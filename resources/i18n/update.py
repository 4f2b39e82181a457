#!/usr/bin/env python3
"""Brings the translation files up to date with the sources; --check says instead what is missing.

English is the language of the sources: tessera_en.ts holds its plurals alone. The supervisor's sentences come from
core/, which knows no Qt: there phrase() marks them.
"""
import argparse
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FOLDERS = ["ui", "app/tessera", "core/base", "core/floor", "core/store", "core/sitecheck", "core/sitediff", "core/exchange", "core/scan", "core/tilecheck", "core/calibrate", "core/locate", "core/drive", "core/supervisor", "core/link", "core/host"]
FILES = {"tessera_en.ts": ["-pluralonly"], "tessera_zh_CN.ts": []}
# /usr/bin/lupdate starts whichever Qt is the default one.
LUPDATE = next((p for p in (shutil.which("lupdate6"), "/usr/lib/qt6/bin/lupdate") if p and Path(p).exists()), "lupdate")
ALIAS = ["-tr-function-alias", "QT_TRANSLATE_NOOP+=phrase"]


def update(folder):
    """Runs lupdate on the translation files in `folder`."""
    sources = [str(p) for f in FOLDERS for p in sorted((ROOT / f).rglob("*")) if p.suffix in (".h", ".cpp")]
    with tempfile.NamedTemporaryFile("w", suffix=".lst") as listing:
        listing.write("\n".join(sources))
        listing.flush()
        for name, options in FILES.items():
            language = name.removeprefix("tessera_").removesuffix(".ts")
            subprocess.run([LUPDATE, "-silent", "-I", str(ROOT), "-I", str(ROOT / "core"), "-locations", "none", "-no-ui-lines", "-no-obsolete", "-source-language", "en",
                            "-target-language", language, *options, *ALIAS, f"@{listing.name}",
                            "-ts", str(folder / name)], check=True)


def unfinished(path):
    """What stands in a translation file without a translation, as 'context: source'."""
    missing = []
    for context in ET.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            forms = [f.text for f in translation.iter("numerusform")] or [translation.text]
            if translation.get("type") is not None or not all(forms):
                missing.append(f"{context.findtext('name')}: {message.findtext('source')}")
    return missing


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--check", action="store_true", help="change nothing; exit code 1 when something is missing")
    if not arguments.parse_args().check:
        update(HERE)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        for name in FILES:
            shutil.copy(HERE / name, folder)
        update(Path(folder))
        missing = {name: unfinished(Path(folder) / name) for name in FILES}
    for name, texts in missing.items():
        for text in texts:
            print(f"{name}: not translated: {text}")
    return 1 if any(missing.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
