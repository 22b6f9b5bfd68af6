#!/usr/bin/env python3
"""Which files of a target the compiler reads as one: unity.py LIST (unity.cmake calls it); or unity.py --database BUILD.

LIST is a file of CMake's: targets, each followed by its C++ files and "--", with ";" between. Prints a line for each unit: target, number,
files. --database: gives each file an entry of its own in BUILD/compile_commands.json, as clangd wants it.
"""
import json
import pathlib
import shlex
import sys

import tidy_units

ROOT = pathlib.Path(__file__).resolve().parent.parent
AT_MOST = 30  # files in a unit, which then needs about 0.9 GB


def targets(words):
    """(target, files) of CMake's list."""
    line = []
    for word in words:
        if word != "--":
            line.append(word)
        else:
            yield line[0], [pathlib.Path(file) for file in line[1:]]
            line = []


def units(files, folders):
    words = [f"-I{folder}" for folder in folders]
    sources = [tidy_units.Source(file, words, lambda _: True) for file in files]
    return [[source.file for source in unit.members] for unit in tidy_units.units_of_a_kind(sources, AT_MOST)]


def main():
    if sys.argv[1] == "--database":
        build = pathlib.Path(sys.argv[2])
        (build / "compile_commands.json").write_text(json.dumps(tidy_units.entries(build), indent=1))
        return
    folders = [ROOT / "src", *sorted(ROOT.glob("*/src")), *sorted(ROOT.glob("*/include"))]
    for target, files in targets(pathlib.Path(sys.argv[1]).read_text().split(";")):
        for number, unit in enumerate(units(files, folders)):
            print(target, number, shlex.join(map(str, unit)))


if __name__ == "__main__":
    main()
