#!/usr/bin/python3
"""Checks that what this repository uses is in the packages that ./tws installs, however much else this machine has.

Looked at are Python's imports, the programs that scripts, tests and launch files call, C++ headers and package.xml. Each is traced to
the Debian package that owns it, and that must be among ./tws's lists or what those depend on (recommended packages do not count). What
a user runs must be in the list `packages`, reports and pictures besides in `report_packages`, tests in any of the lists.
"""
import ast
import collections
import functools
import importlib.machinery
import os
import pathlib
import re
import shlex
import subprocess
import sys
import xml.etree.ElementTree as xml

import shell_words

RUN, REPORT, TEST = ("packages",), ("packages", "report_packages"), ("packages", "report_packages", "developer_packages")
# What package.xml calls by rosdep's names instead of ROS packages'.
SYSTEM_KEYS = {"boost": "libboost-dev", "bzip2": "libbz2-dev", "cli11": "libcli11-dev", "eigen": "libeigen3-dev",
               "geographiclib": "libgeographiclib-dev", "libcsv-dev": "libcsv-dev", "lz4": "liblz4-dev",
               "tinyxml2": "libtinyxml2-dev", "yaml-cpp": "libyaml-cpp-dev",
               "python3-matplotlib": "python3-matplotlib", "python3-numpy": "python3-numpy", "python3-yaml": "python3-yaml"}
# Programs that are called only where they are.
OPTIONAL = {"sudo"}
PROGRAM_FOLDERS = ("/usr/bin", "/bin", "/usr/sbin", "/sbin")

# One thing that a file uses: kind is "import", "program", "header" or "package".
Use = collections.namedtuple("Use", "file line kind name")


# ---- what the files use -------------------------------------------------------------------------------------------------------------


def python_uses(file, text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from (Use(file, node.lineno, "import", alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield Use(file, node.lineno, "import", node.module)
        elif isinstance(node, ast.Call):
            name = called_program(node)
            if name and "/" not in name:
                yield Use(file, node.lineno, "program", name)


def called_program(call):
    """The program that subprocess.run(["x", …]), shutil.which("x") and their like name, if it is written there."""
    if not isinstance(call.func, ast.Attribute) or not isinstance(call.func.value, ast.Name) or not call.args:
        return None
    word = call.args[0]
    if call.func.value.id == "subprocess" and isinstance(word, (ast.List, ast.Tuple)) and word.elts:
        word = word.elts[0]
    elif call.func.value.id not in ("subprocess", "shutil") or call.func.attr not in ("which", "run", "call", "check_output", "Popen"):
        return None
    return word.value.split()[0] if isinstance(word, ast.Constant) and word.value else None


def shell_uses(file, text):
    return (Use(file, line, "program", name) for line, name in shell_words.commands(text))


def header_uses(file, text):
    for line, words in enumerate(text.splitlines(), 1):
        found = re.match(r'\s*#\s*include\s*<([^>]+)>', words)
        if found:
            yield Use(file, line, "header", found[1])


def line_of(text, word):
    return text[:text.find(word)].count("\n") + 1


def launch_uses(file, text):
    for element in xml.fromstring(text).iter():
        package = element.get("pkg")
        if package and "$(" not in package:
            yield Use(file, line_of(text, f'pkg="{package}"'), "package", package)
        prefix = element.get("launch-prefix")
        if prefix and "$(" not in prefix:
            yield Use(file, line_of(text, "launch-prefix"), "program", shlex.split(prefix)[0])
        if element.tag == "param" and element.get("command"):
            yield Use(file, line_of(text, element.get("command")), "program", element.get("command").split()[0])
    yield from (Use(file, line_of(text, found[0]), "package", found[1]) for found in re.finditer(r"\$\(find (\w+)\)", text))


def manifest_uses(file, text):
    for element in xml.fromstring(text):
        if element.tag.endswith("depend"):
            yield Use(file, line_of(text, f"<{element.tag}>{element.text}<"), "package", element.text)


def reader_of(path, text):
    """Which of the above reads a file, by its name and first line; None for what is not code."""
    first = text.split("\n", 1)[0]
    if path.suffix == ".py" or (first.startswith("#!") and "python" in first):
        return python_uses
    if first.startswith("#!") and "sh" in first:
        return shell_uses
    if path.suffix in (".h", ".cpp"):
        return header_uses
    if path.suffix in (".launch", ".test"):
        return launch_uses
    return manifest_uses if path.name == "package.xml" else None


def lists_for(path):
    """The names of the lists in ./tws from which a file may take what it uses."""
    if path.name == "package.xml" or {".ci", "test", "benchmark", "fuzz"} & set(path.parts):
        return TEST
    if path.stem.endswith(("_test", "_rostest", "_benchmark", "_test_helpers")):
        return TEST
    return REPORT if "scripts" in path.parts or path.name == "tws" else RUN


def files_of(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(set(folders) - {".git", "build", "devel", "install", "logs", "out"})
        yield from (pathlib.Path(folder, name).relative_to(root) for name in sorted(names))


def uses_in(root):
    for path in files_of(root):
        try:
            text = (root / path).read_text()
        except UnicodeDecodeError:
            continue
        read = reader_of(path, text)
        if read:
            yield from read(path, text)


# ---- where it is on this machine ----------------------------------------------------------------------------------------------------


class Repository:
    """What the repository itself brings: its packages, modules and headers need no Debian package."""

    def __init__(self, root):
        self.root = root
        self.packages = {xml.parse(file).findtext("name") for file in root.glob("*/package.xml")}
        paths = list(files_of(root))
        self.modules = {path.stem for path in paths if path.suffix == ".py"}
        self.headers = {"/".join(path.parts[-2:]) for path in paths if path.suffix == ".h"}

    def has(self, use):
        if use.kind == "import":
            return use.name.split(".")[0] in self.packages | self.modules
        if use.kind == "header":
            return use.name in self.headers or use.name.split("/")[0] in self.packages
        return use.kind == "package" and use.name in self.packages


@functools.lru_cache(None)
def module_file(name):
    """Where Python has a module, without running it: its deepest part that is one. "" for what is in the interpreter."""
    folders, origin = None, None
    for part in name.split("."):
        finder = importlib.machinery.PathFinder
        if folders is None and part in sys.builtin_module_names:
            return ""
        spec = finder.find_spec(part, folders)
        if spec is None:
            return origin
        origin, folders = spec.origin or next(iter(spec.submodule_search_locations), None), spec.submodule_search_locations
        if folders is None:
            break
    return origin


@functools.lru_cache(None)
def header_folders():
    said = subprocess.run(["g++", "-E", "-v", "-x", "c++", "/dev/null"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    listed = said.stderr.split("search starts here:")[-1].split("End of search")[0].split()
    folders = [pathlib.Path(folder).resolve() for folder in listed]
    # Some packages have a folder of their own, which their CMake files add.
    return folders + [pathlib.Path("/usr/include/x86_64-linux-gnu/qt5")] + sorted(pathlib.Path("/usr/include").glob("*/"))


def first_file(folders, name):
    return next((str(pathlib.Path(folder, name)) for folder in folders if pathlib.Path(folder, name).exists()), None)


def place_of(use):
    """The file on this machine that a use means; None when there is none, "" when nothing needs to be installed."""
    if use.kind == "import":
        return module_file(use.name)
    if use.kind == "header":
        return first_file(header_folders(), use.name)
    if use.kind == "program":
        return "" if use.name in OPTIONAL else first_file(PROGRAM_FOLDERS, use.name)
    return first_file(("/usr/share", "/opt/ros/noetic/share"), f"{use.name}/package.xml")


def spellings(path):
    """The names under which dpkg may know a file: before and after /bin became /usr/bin, behind a link or an alternative."""
    found = []
    while path and path not in found:
        found.append(path)
        path = str(pathlib.Path(path).readlink()) if pathlib.Path(path).is_symlink() else None
        if path and not path.startswith("/"):
            path = str(pathlib.Path(found[-1]).parent / path)
    found.append(str(pathlib.Path(found[0]).resolve()))
    return [name for path in found for name in (path, re.sub("^/usr(?=/s?bin/|/lib)", "", path), re.sub("^(?=/s?bin/|/lib)", "/usr", path))]


def owners(paths):
    """{path: the package that it belongs to} for each that belongs to one."""
    names = {path: spellings(path) for path in paths}
    wanted = sorted({name for known in names.values() for name in known})
    said = subprocess.run(["dpkg-query", "-S", *wanted], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    owner = {}
    for line in said.splitlines():
        package, _, path = line.partition(": ")
        if not package.startswith("diversion "):
            owner.setdefault(path, package.split(",")[0].split(":")[0])
    return {path: next((owner[name] for name in known if name in owner), None) for path, known in names.items()}


# ---- what ./tws installs ------------------------------------------------------------------------------------------------------------


class Installed:
    """dpkg's records of what is installed: {package: its dependencies, each a list of alternatives}."""

    def __init__(self, records):
        self.depends, self.providers, self.base = {}, collections.defaultdict(set), {"apt"}
        for package, status, essential, priority, provides, *depends in (line.split("\t") for line in records.splitlines()):
            if status != "installed":
                continue
            self.depends[package] = [group for words in depends for group in alternatives(words)]
            for group in alternatives(provides):
                self.providers[group[0]].add(package)
            if essential == "yes" or priority == "required":
                self.base.add(package)

    @classmethod
    def here(cls):
        form = "\t".join(f"${{{name}}}" for name in
                         ("Package", "db:Status-Status", "Essential", "Priority", "Provides", "Pre-Depends", "Depends")) + "\n"
        return cls(subprocess.run(["dpkg-query", "-W", "-f", form], stdout=subprocess.PIPE, text=True, check=True).stdout)

    def chosen(self, group):
        """The packages that stand for one dependency: apt takes the first alternative, unless that cannot be had."""
        for name in group:
            if name in self.depends:
                return {name}
            if self.providers[name]:
                return self.providers[name]
        return set()

    def closure(self, names):
        """The packages with all that they depend on, and what every Debian has."""
        found, waiting = set(), [*names, *self.base]
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                waiting += [package for group in self.depends.get(name, []) for package in self.chosen(group)]
        return found


def alternatives(words):
    """[["a", "b"], ["c"]] for "a (>= 1) | b, c:any"."""
    return [[re.sub(r"[\s(:\[].*", "", name.strip()) for name in group.split("|")] for group in words.split(",") if group.strip()]


def lists_in(text):
    """{list: its packages} as they stand in the script ./tws."""
    found = re.findall(r"^(\w*packages)=\((.*?)\)", text, re.MULTILINE | re.DOTALL)
    return {name: re.sub(r"#.*", "", words).split() for name, words in found}


# ---- the verdict --------------------------------------------------------------------------------------------------------------------


def mistakes(uses, lists, installed, places, owner):
    """One line for each use that the lists do not bring. places: {(kind, name): file}, owner: {file: package}."""
    closures = {}
    for use in uses:
        allowed, place = lists_for(use.file), places[use.kind, use.name]
        package = SYSTEM_KEYS.get(use.name) if use.kind == "package" else None
        if place == "" and not package:
            continue
        package = package or owner.get(place)
        if allowed not in closures:
            closures[allowed] = installed.closure(name for key in allowed for name in lists.get(key, []))
        where = f"{use.file}:{use.line}: {use.kind} '{use.name}'"
        if not package:
            yield f"{where} is in no installed Debian package"
        elif package not in closures[allowed]:
            yield f"{where} is in {package}, which ./tws does not install: add it to {' or '.join(allowed)}"


def missing(lists, installed):
    return [f"tws: '{name}' of {key} is not installed" for key, names in lists.items() for name in names if name not in installed.depends]


def check(root):
    repository, installed = Repository(root), Installed.here()
    lists = lists_in((root / "tws").read_text())
    uses = [use for use in uses_in(root) if not repository.has(use)]
    places = {(use.kind, use.name): place_of(use) for use in uses}
    found = list(mistakes(uses, lists, installed, places, owners({place for place in places.values() if place})))
    return missing(lists, installed) + found, len(places)


def main():
    found, count = check(pathlib.Path(__file__).resolve().parent.parent)
    print("\n".join(found) or f"all {count} imports, programs, headers and packages are in what ./tws installs")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
