"""Puts C++ files into units that clang-tidy (check_tidy) or the compiler (unity.py) reads as one file each.

Nearly all of clang-tidy's time goes into the headers of the system, so the fewer units the better, whatever package a file belongs to, and
files that need the same libraries stand together. Files that have a helper of the same name cannot stand in one unit. Which names are
helpers is read off the text, which clang-format lays out: declarations begin in the first column. What that misses the compiler finds.
"""
import collections
import functools
import json
import pathlib
import re
import shlex

AT_MOST = 120  # files in a unit, which then needs about 2 GB
DEAR = ("ros", "yaml-cpp", "Eigen")  # libraries whose headers take long to read
WITH_A_VALUE = {"-o", "-c", "-include"}
OF_GCC = {"-Winvalid-pch", "-Wno-maybe-uninitialized", "-Wno-subobject-linkage"}  # which clang does not know
# Names in the first column: of a test, a type, and of a function or variable.
TEST = re.compile(r"(?:\w*TEST\w*|INSTANTIATE_\w+)\((\w+), (\w+)")
TYPE = re.compile(r"(?:template <.*> )?(?:(?:struct|class|enum class|enum|union) (\w+)\b(?! *;|::)|using (\w+) =)")
OTHER = re.compile(r"(?:template <[^>]*> )?[A-Za-z_][\w:<>,&* ]*?[ *&]([A-Za-z_]\w*)(?:\(| =|\{|\[|;)")


class Source:
    """A file with the compiler's words for it; without output and precompiled header, which are no business of clang's."""

    def __init__(self, file, words, is_ours):
        self.file, self.folders, self.macros, self.rest = file, [], [], []
        words = iter(words)
        for word in words:
            if word in WITH_A_VALUE:
                next(words)
            elif word == "-isystem":
                self.folders.append((word, next(words)))
            elif word.startswith("-I"):
                self.folders.append(("-I", word[2:]))
            elif word.startswith("-D"):
                self.macros.append(word[2:])
            elif word not in OF_GCC and not word.startswith(("-flto", "--param")):
                self.rest.append(word)
        self.ours = tuple(folder for _, folder in self.folders if is_ours(pathlib.Path(folder)))
        self.headers = reached(file, self.ours)
        self.helpers = names(file, helpers_only=True)
        self.sees = set().union(*(names(header) for header in self.headers))

    def is_test(self):
        return self.file.stem.endswith(("_test", "_rostest", "_benchmark")) or "test" in self.file.parts

    def libraries(self):
        """The folders of others' headers that it needs, CLI of <CLI/CLI.hpp>."""
        return set().union(*(foreign(file, self.ours) for file in [self.file, *self.headers]))

    def opens_a_namespace(self):
        """What says "using namespace" says it to all that follows."""
        return any(line.startswith("using namespace") for line in lines(self.file))

    def own_macros(self):
        """Macros with a text, such as the package's name: they may differ from file to file in one unit."""
        return [macro.split("=", 1) for macro in self.macros if '"' in macro]

    def kind(self):
        """Files of different kinds never share a unit: other checks, a header asks for a macro that only one of them has, or CLI11's
        header: for each of its functions that take a copy one check searches the whole unit, 25 s in a large one."""
        asked = set().union(*(conditions(file) for file in [self.file, *self.headers]))
        return self.is_test(), "CLI" in self.libraries(), tuple(sorted(set(self.macros) & asked))


@functools.lru_cache(None)
def lines(file):
    return file.read_text(errors="replace").splitlines() if file.exists() else []


@functools.lru_cache(None)
def conditions(file):
    """Words of the file's #if lines."""
    return {word for line in lines(file) if line.startswith("#if") or line.startswith("#elif") for word in line.split()[1:]}


@functools.lru_cache(None)
def names(file, helpers_only=False):
    """(name space, name) of what the file declares; helpers_only: of what may stand in another file, too."""
    spaces, found = [], set()
    for line in lines(file):
        if opened := re.match(r"(?:inline )?namespace ?([\w:]*) ?\{", line):
            spaces.append(opened[1])
        elif re.match(r"\} *// namespace", line):
            del spaces[-1:]
        elif named := TEST.match(line) or TYPE.match(line):
            found.add(("::".join(filter(None, spaces)), "/".join(filter(None, named.groups()))))
        elif not line.startswith(("using ", "class ", "struct ")) and (not helpers_only or "" in spaces or line.startswith("static ")):
            found.update(("::".join(filter(None, spaces)), named[1]) for named in [OTHER.match(line)] if named)
    return found


@functools.lru_cache(None)
def places(file, folders):
    """(word, path) of what the file includes; no path: it is not of this repository."""
    words = [found[1] for line in lines(file) for found in [re.match(r'#include [<"](.+)[>"]', line)] if found]
    return [(word, next((place for place in (pathlib.Path(folder) / word for folder in (file.parent, *folders)) if place.exists()), None))
            for word in words]


def included(file, folders):
    """Headers of this repository that the file names."""
    return [place for _, place in places(file, folders) if place]


def foreign(file, folders):
    """Folders of the headers that it names and that are not of this repository."""
    return {word.split("/")[0] for word, place in places(file, folders) if not place and "/" in word}


def reached(file, folders):
    """The headers that the file includes, and those that they include."""
    found, new = set(), {file}
    while new:
        new = {header.resolve() for one in new for header in included(one, folders)} - found
        found |= new
    return found


def entries(build):
    """The compile database of a build folder, with an entry for each file of what CMake compiles as one."""
    found = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        unit = pathlib.Path(entry["file"])
        members = re.findall(r'^#include "(.+)"$', unit.read_text(), re.MULTILINE) if unit.parent.name == "Unity" else [str(unit)]
        found += [{**entry, "file": file, "command": entry["command"].replace(str(unit), file)} for file in members]
    return found


def by_libraries(files):
    """In an order that has those together that need the same libraries."""
    return sorted(files, key=lambda source: ([name not in source.libraries() for name in DEAR], source.file))


def sources(build, root, only=""):
    """The files of this repository that the build folder compiles, none twice."""
    found = {}

    def is_ours(path):
        return root in path.parents and build not in path.parents

    for entry in entries(build):
        file = pathlib.Path(entry["file"])
        if is_ours(file) and only in str(file) and file not in found:
            found[file] = Source(file, shlex.split(entry["command"])[1:], is_ours)
    return by_libraries(found.values())


class Unit:
    def __init__(self, members=()):
        self.members, self.helpers, self.sees = [], set(), set()
        for source in members:
            self.add(source)

    def add(self, source):
        self.members.append(source)
        self.helpers |= source.helpers
        self.sees |= source.sees

    def has_room_for(self, source):
        return not source.helpers & (self.helpers | self.sees) and not source.sees & self.helpers

    def text(self):
        """The unit itself. A program's main() must not be the second one."""
        parts = []
        for number, source in enumerate(self.members):
            macros = [*source.own_macros(), ["main", f"main_{number}"]] if self.members[1:] else source.own_macros()
            parts += [f"#define {name} {value}\n" for name, value in macros]
            parts += [f'#include "{source.file}"\n', *(f"#undef {name}\n" for name, *_ in macros)]
        return "".join(parts)

    def flags(self):
        """The compiler's words that all members need. A folder of one's own headers is nobody's system folder."""
        own = {str(pathlib.Path(folder).resolve()): "-I" for source in self.members for kind, folder in source.folders if kind == "-I"}
        folders = {str(pathlib.Path(folder).resolve()): kind for source in self.members for kind, folder in source.folders}
        words = [f"-D{macro}" for source in self.members for macro in source.macros if '"' not in macro or not self.members[1:]]
        words += [word for source in self.members for word in source.rest]
        return [kind + folder for folder, kind in {**own, **folders, **own}.items()] + list(dict.fromkeys(words))


def alike(files):
    """How many of the files have a helper of a name."""
    return collections.Counter(name for source in files for name in source.helpers)


def units_of_a_kind(files, at_most=AT_MOST):
    """As few units as the files fit in, of about the same size."""
    count = max(-(-len(files) // at_most), *alike(files).values(), 1)
    units = [Unit() for _ in range(count)]
    for source in files:
        free = [unit for unit in units if unit.has_room_for(source)]
        if not free:
            free = [Unit()]
            units += free
        next((unit for unit in free if len(unit.members) < len(files) / count), free[0]).add(source)
    for unit in units:
        unit.members.sort(key=Source.opens_a_namespace)
    return [unit for unit in units if unit.members]


def units(files):
    kinds = collections.defaultdict(list)
    for source in files:
        kinds[source.kind()].append(source)
    return [unit for kind in kinds.values() for unit in units_of_a_kind(kind)]
