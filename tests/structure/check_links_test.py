#!/usr/bin/env python3
"""Tries check_links.py on small trees, each with one fault that it must find."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.dont_write_bytecode = True
import check_links  # noqa: E402

GOOD = {
    "README.md": "![The floor](docs/pictures/floor.png) [more](docs/more.md#part) [site](https://example.org/x)\n",
    "docs/more.md": "`[no](link.md)`\n\n```\n[nor](this.md)\n```\n[back](../README.md) [folder](pictures)\n",
    "docs/pictures/floor.png": "x",
    "build/copy.md": "[of](nothing.md)",
    "tree/CMakeCache.txt": "",
    "tree/deep/copy.md": "[of](nothing.md)",
}


class CheckLinks(unittest.TestCase):
    def problems(self, **changes):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**GOOD, **changes.get("files", {})}.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check_links.check(Path(folder).resolve())

    def test_a_good_tree_has_none(self):
        self.assertEqual(self.problems(), [])

    def test_a_link_that_leads_nowhere(self):
        self.assertEqual(self.problems(files={"docs/more.md": "a [word](gone.md) more"}),
                         ["docs/more.md: there is no gone.md"])

    def test_a_picture_that_is_shown_and_not_there(self):
        self.assertEqual(self.problems(files={"docs/more.md": "![A](pictures/gone.png)"}),
                         ["docs/more.md: there is no pictures/gone.png"])

    def test_a_picture_that_nobody_shows(self):
        self.assertEqual(self.problems(files={"docs/pictures/lost.png": "x"}),
                         ["docs/pictures/lost.png: no document shows it"])

    def test_a_picture_that_is_too_large(self):
        found = self.problems(files={"docs/pictures/floor.png": "x" * (check_links.MOST_BYTES + 1)})
        self.assertEqual(len(found), 1)
        self.assertIn("docs/pictures/floor.png: 300001 bytes", found[0])


if __name__ == "__main__":
    unittest.main()
