#!/usr/bin/env python3
"""Writes a number that changes when any of some source files does, as C++: what tables on disk were computed by.

usage: source_version.py ROOT OUTPUT HEADER FUNCTION FILE...

FUNCTION, as HEADER declares it, returns the number.

The number is made of the files' names below ROOT and of their bytes, in the order of the names: the same sources give the
same number wherever they lie.
"""
import hashlib
import pathlib
import sys


def main():
    header, function = sys.argv[3:5]
    root, output, *files = map(pathlib.Path, sys.argv[1:3] + sys.argv[5:])
    digest = hashlib.sha256()
    for name, file in sorted((file.relative_to(root).as_posix(), file) for file in files):
        digest.update(f"{name}\n{hashlib.sha256(file.read_bytes()).hexdigest()}\n".encode())
    output.write_text(
        "// Made by tools/source_version.py.\n"
        f'#include "{header}"\n\n'
        f"std::uint64_t airlight::{function}() {{ return 0x{digest.hexdigest()[:16]}; }}\n",
        encoding="ascii",
    )


if __name__ == "__main__":
    main()
