#!/usr/bin/env python3
"""Writes a number that changes when any of some source files does, as C++: what tables on disk were computed by.

usage: source_version.py ROOT OUTPUT FILE...

The number is made of the files' names below ROOT and of their bytes, in the order of the names: the same sources give the
same number wherever they lie.
"""
import hashlib
import pathlib
import sys


def main():
    root, output, *files = map(pathlib.Path, sys.argv[1:])
    digest = hashlib.sha256()
    for name, file in sorted((file.relative_to(root).as_posix(), file) for file in files):
        digest.update(f"{name}\n{hashlib.sha256(file.read_bytes()).hexdigest()}\n".encode())
    output.write_text(
        "// Made by tools/source_version.py.\n"
        '#include "engine/source_version.h"\n\n'
        f"std::uint64_t airlight::source_version() {{ return 0x{digest.hexdigest()[:16]}; }}\n",
        encoding="ascii",
    )


if __name__ == "__main__":
    main()
