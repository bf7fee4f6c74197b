#!/usr/bin/env python3
"""Runs the shell commands that documents show, and checks that the C++, GLSL and CMake they show is compiled somewhere.

usage: run_documented_commands.py PROGRAM_FOLDER REPOSITORY DOCUMENT...

Each document's ```sh blocks run in order in one scratch folder, with PROGRAM_FOLDER first in PATH and the repository's
scenes/, data/ and examples/ beside. Every other test and CI covers what is skipped: setting up, building and the script/ commands.
A document that is missing, or shows no command, fails: then this test would test nothing.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)
SKIPPED = re.compile(r"^\s*(script/|git clone|cd airlight|cmake |ctest |sudo |apt)")


def blocks(text, language):
    return [body for tag, body in BLOCK.findall(text) if tag == language]


def commands(block):
    return "".join(line for line in block.splitlines(keepends=True) if not SKIPPED.match(line))


def run_commands(document, program_folder, repository):
    scripts = [commands(block) for block in blocks(document.read_text(), "sh")]
    scripts = [script for script in scripts if script.strip()]
    environment = dict(os.environ, PATH=f"{program_folder}:{os.environ['PATH']}")
    with tempfile.TemporaryDirectory() as scratch:
        for folder in ("scenes", "data", "examples"):
            (Path(scratch) / folder).symlink_to(repository / folder)
        for script in scripts:
            print(f"--- {document.name}\n{script}", flush=True)
            subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=scratch, env=environment, check=True, timeout=300)
    return len(scripts)


def flat(text):
    return " ".join(text.split())


def uncompiled(document, repository):
    """Snippets of the document that are no part of a file under examples/; those files are built by tests."""
    sources = [flat(file.read_text(errors="replace")) for file in (repository / "examples").rglob("*") if file.is_file()]
    shown = [block for language in ("cpp", "cmake", "glsl") for block in blocks(document.read_text(), language)]
    return [snippet for snippet in shown if not any(flat(snippet) in source for source in sources)]


def main():
    program_folder, repository = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    for name in sys.argv[3:]:
        document = repository / name
        for snippet in uncompiled(document, repository):
            sys.exit(f"{name} shows code that no example holds:\n{snippet}")
        if run_commands(document, program_folder, repository) == 0:
            sys.exit(f"{name} shows no command to run")


if __name__ == "__main__":
    main()
