#!/usr/bin/env python3
"""Writes PACKAGE/doc/parameters.md from the comments in PACKAGE/config/*.yaml; with --check it only says which is stale.

A line of such a file is `key: value  # Meaning, unit [least, greatest].`; a comment may go on below its beginning. What is commented
out but looks so, too, is a parameter: a single value is its default, a map or list an example. Files with the same keys share a table, a
column for each.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
VALUE = r"""(?P<value>"[^"]*"|'[^']*'|\[.*?\](?=\s|$)|\{.*?\}(?=\s|$)|[^\s#"'\[{]\S*(?: [^\s#]\S*)*|)"""
LINE = re.compile(r"^(?P<indent> *)(?P<item>- )?(?P<key>\w+):(?: +" + VALUE + r")?(?: *| +# (?P<comment>.*))$")
# What is commented out; a bare value has no blanks, for else a sentence with a colon would count.
OPTIONAL = re.compile(r"^# ?(?P<rest> *(?:- )?[a-z]\w*:(?: +(?:\"[^\"]*\"|\[[^]]*\]|\{[^}]*\}|[^\s#]+))?(?: *| +# .*))$")
ITEM = re.compile(r"^ *- (?P<value>\{.*?\})(?: *| +# (?P<comment>.*))$")
RANGE = re.compile(r" ?\[(?:(?P<unit>[A-Za-z ]+), )?(?P<range>[-\w.]+, [-\w.]+)\]")
UNIT = re.compile(r" ?\[(?P<unit>[\w/^. ]+)\]")
SUFFIXES = {"deg_per_s": "°/s", "mps2": "m/s²", "mps": "m/s", "m2": "m²", "kn": "kn", "deg": "°", "db": "dB", "m": "m", "s": "s"}
SPOKEN = re.compile(r", (?P<unit>rad/s|m\^2/s\^3|m/s\^2|m/s|1/m\^3 and frame|standard deviations)(?=[ ;.,]|$)")
SUPERSCRIPTS = {"^2": "²", "^3": "³"}


HEAD = ["# Parameters", "",
        "Written by `.ci/parameter_tables.py` from the comments in `config/`; do not edit this page. A `.` parts the levels of a map, `[]`",
        "stands for each entry of a list. Ranges are inclusive. Where a default is `none`, an example stands beside it.", ""]


class Row:
    """A parameter: path, value, meaning; or, without a path, a line that stands above the next ones."""

    def __init__(self, path, value, comment):
        self.path, self.values, self.comment, self.optional = path, [value], comment or "", False


class File:
    """A parameter file's introduction and rows."""

    def __init__(self, path):
        self.name, self.intro, self.rows, self.levels, self.column = path.name, [], [], [], 0
        for line in path.read_text().splitlines():
            self.read(line)

    def read(self, line):
        optional = OPTIONAL.match(line)
        found, item = LINE.match(optional["rest"] if optional else line), ITEM.match(line.lstrip("# ") if self.rows else "")
        if found:
            self.parameter(found, line, bool(optional))
        elif item and self.rows:
            self.item(item)
        elif re.match(r"^\s+#", line) and self.rows and line.index("#") >= self.column:
            self.rows[-1].comment += " " + line.split("#", 1)[1].strip()
        elif line.startswith("#"):
            self.remark(line[1:].strip())
        elif not line.strip() and self.rows and self.rows[-1].path is None:
            self.rows.append(Row(None, "", ""))

    def parameter(self, found, line, optional):
        indent = len(found["indent"]) + (2 if found["item"] else 0)
        self.levels = [(depth, key) for depth, key in self.levels if depth < indent]
        if found["item"] and self.levels:
            depth, key = self.levels[-1]
            self.levels[-1] = depth, key.rstrip("[]") + "[]"
        path = ".".join([key for _, key in self.levels] + [found["key"]])
        self.levels.append((indent, found["key"]))
        if any(row.path == path for row in self.rows):
            return  # the second of a list
        self.rows.append(Row(path, found["value"] or "", found["comment"]))
        self.rows[-1].optional = optional
        self.column = line.find("#", 2) if found["comment"] else 1000

    def item(self, item):
        row = self.rows[-1]
        if "[]" not in (row.path or ""):
            row.values[0] = ", ".join(filter(None, [row.values[0], item["value"]]))
        row.comment += " " + item["comment"] if item["comment"] else ""

    def remark(self, words):
        if not self.rows:
            self.intro.append(words)
        elif self.rows[-1].path is None and self.rows[-1].comment:
            self.rows[-1].comment += " " + words
        else:
            self.rows.append(Row(None, "", words))


def unit_and_range(path, comment):
    """(unit, range, what is left of the comment)."""
    limits, unit = RANGE.search(comment), ""
    if limits:
        comment = comment[:limits.start()] + comment[limits.end():]
        unit = limits["unit"] or ""
    spoken = SPOKEN.search(comment) or (None if unit else UNIT.search(comment))
    if spoken:
        unit, comment = spoken["unit"], comment[:spoken.start()] + comment[spoken.end():]
    key = path.split(".")[-1]
    suffix = next((SUFFIXES[end] for end in SUFFIXES if key.endswith("_" + end)), "")
    for plain, raised in SUPERSCRIPTS.items():
        unit = unit.replace(plain, raised)
    return unit or suffix, f"[{limits['range']}]" if limits else "", comment.strip(" ,;")


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def value_of(row, value):
    if row.optional and (row.comment.startswith("required") or value[:1] in ("{", "[")):
        return "required" if row.comment.startswith("required") else f"none; `{cell(value)}`"
    return f"`{cell(value)}`" if value else ""


def lines_of(row, columns):
    if row.path is None:
        return [f"| *{cell(row.comment)}* |" + " |" * (columns + 3)] if row.comment else []
    unit, limits, meaning = unit_and_range(row.path, row.comment)
    values = [value_of(row, value) for value in row.values]
    if not meaning and not any(values):
        return []
    return ["| " + " | ".join([f"`{row.path}`", *values, unit, limits, cell(meaning)]) + " |"]


def together(files):
    """Files in lists of those that have the same parameters; the rows of the first get the values of all."""
    groups = []
    for file in files:
        keys = [row.path for row in file.rows if row.path]
        group = next((g for g in groups if [row.path for row in g[0].rows if row.path] == keys), None)
        if group is None:
            groups.append([file])
            continue
        for row, other in zip([r for r in group[0].rows if r.path], [r for r in file.rows if r.path]):
            row.values += other.values
        group.append(file)
    return groups


def table(group):
    heads = ["default"] if len(group) == 1 else [file.name for file in group]
    columns = ["parameter", *heads, "unit", "range", "meaning"]
    lines = ["## " + ", ".join(file.name for file in group), ""]
    for file in group:
        lines += [(f"{file.name}: " if group[1:] else "") + " ".join(file.intro), ""]
    lines += ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return lines + [line for row in group[0].rows for line in lines_of(row, len(heads))] + [""]


def page(config):
    """The text of a package's page, given the folder of its parameter files."""
    files = [File(path) for path in sorted(config.glob("*.yaml"))]
    return "\n".join(HEAD + [line for group in together(files) for line in table(group)]).rstrip() + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; status 1 when a page is stale")
    options, stale = parser.parse_args(), []
    for config in sorted(ROOT.glob("*/config")):
        if not list(config.glob("*.yaml")):
            continue
        text, target = page(config), config.parent / "doc" / "parameters.md"
        if target.exists() and target.read_text() == text:
            continue
        stale.append(str(target.relative_to(ROOT)))
        if not options.check:
            target.parent.mkdir(exist_ok=True)
            target.write_text(text)
    print("\n".join(f"{name} {'is not what config/ says: run .ci/parameter_tables.py' if options.check else 'written'}" for name in stale))
    return 1 if options.check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
