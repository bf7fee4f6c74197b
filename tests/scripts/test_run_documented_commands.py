#!/usr/bin/env python3
"""The runner of documented commands must notice what it is there to notice."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

RUNNER = Path(__file__).with_name("run_documented_commands.py")


class RunnerTest(unittest.TestCase):
    def run_on(self, text):
        with tempfile.TemporaryDirectory() as folder:
            repository = Path(folder)
            for name in ("bin", "scenes", "data", "examples"):
                (repository / name).mkdir()
            (repository / "examples" / "main.cpp").write_text("int main() {\n  return 0;\n}\n")
            (repository / "bin" / "airlight").write_text("#!/bin/sh\necho sky of $1\n")
            (repository / "bin" / "airlight").chmod(0o755)
            (repository / "page.md").write_text(text)
            return subprocess.run([sys.executable, RUNNER, repository / "bin", repository, "page.md"],
                                  capture_output=True, text=True)

    def test_commands_run_in_order_in_one_folder(self):
        result = self.run_on("```sh\nairlight one > a\n```\ntext\n```sh\ngrep 'sky of one' a\n```\n")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_failing_command_fails(self):
        self.assertNotEqual(self.run_on("```sh\nfalse\ntrue\n```\n").returncode, 0)

    def test_a_failure_inside_a_pipe_fails(self):
        self.assertNotEqual(self.run_on("```sh\nfalse | cat\n```\n").returncode, 0)

    def test_setup_lines_are_skipped_but_not_alone(self):
        self.assertEqual(self.run_on("```sh\nscript/setup\nairlight one\n```\n").returncode, 0)
        self.assertNotEqual(self.run_on("```sh\nscript/setup\n```\n").returncode, 0)

    def test_code_must_be_part_of_an_example(self):
        commands = "```sh\nairlight one\n```\n"
        self.assertEqual(self.run_on(commands + "```cpp\nint main() { return 0; }\n```\n").returncode, 0)
        self.assertNotEqual(self.run_on(commands + "```cpp\nint main() { return 1; }\n```\n").returncode, 0)


if __name__ == "__main__":
    unittest.main()
