#!/usr/bin/env python3
"""Writes data files as one C++ source, so that the library needs no data folder when it runs.

usage: embed_data.py README OUTPUT FILE...

The README beside the data lists each file's SHA-256; a file whose bytes differ stops the build, so that nobody computes
with damaged data or changes data without saying so.
"""
import hashlib
import pathlib
import re
import sys


def main():
    readme, output, *files = map(pathlib.Path, sys.argv[1:])
    listed = dict(re.findall(r"^([0-9a-f]{64}) [ *](\S+)$", readme.read_text(encoding="utf-8"), re.MULTILINE))
    listed = {name: checksum for checksum, name in listed.items()}
    entries = []
    for file in sorted(files):
        content = file.read_bytes()
        checksum = hashlib.sha256(content).hexdigest()
        if listed.get(file.name) != checksum:
            sys.exit(f"{file}: SHA-256 {checksum}: expected {listed.get(file.name, 'a line')} as listed in {readme}")
        entries.append(f'    {{"{file.name}", R"data({content.decode("ascii")})data"}},\n')
    output.write_text(
        f"// Made by tools/embed_data.py from {readme.parent.name}/.\n"
        '#include "optics/shipped_data.h"\n\n'
        "namespace airlight {\n\n"
        "std::span<const ShippedFile> shipped_files() {\n"
        "  static constexpr ShippedFile files[] = {\n" + "".join(entries) + "  };\n"
        "  return files;\n}\n\n"
        "}  // namespace airlight\n",
        encoding="ascii",
    )


if __name__ == "__main__":
    main()
