#!/usr/bin/env python3
"""The number that tables on disk are known by must change with every source that computes them, and with nothing else."""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOL = Path(__file__).parents[2] / "tools" / "source_version.py"


def number(sources):
    with tempfile.TemporaryDirectory() as folder:
        root, output = Path(folder), Path(folder) / "version.cpp"
        for name, text in sources.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        subprocess.run([sys.executable, TOOL, root, output, "a/b.h", "c", *(root / name for name in sources)], check=True)
        return re.search(r'#include "a/b.h"\n.*airlight::c\(\) { return (0x[0-9a-f]{16});', output.read_text(), re.S).group(1)


class SourceVersionTest(unittest.TestCase):
    sources = {"src/sky/orders.cpp": "sum\n", "kernels/core/air.glsl": "air\n"}

    def test_the_same_sources_give_the_same_number_wherever_they_lie(self):
        self.assertEqual(number(self.sources), number(dict(reversed(self.sources.items()))))

    def test_another_text_gives_another_number(self):
        for name in self.sources:
            self.assertNotEqual(number(self.sources), number({**self.sources, name: "other\n"}))

    def test_another_name_gives_another_number(self):
        self.assertNotEqual(number({"a": "x", "b": "y"}), number({"a": "y", "b": "x"}))
        self.assertNotEqual(number({"a": "x"}), number({"b": "x"}))

    def test_one_more_file_gives_another_number(self):
        self.assertNotEqual(number(self.sources), number({**self.sources, "src/sky/new.cpp": ""}))


if __name__ == "__main__":
    unittest.main()
