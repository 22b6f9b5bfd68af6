"""If these fail, a build from nothing breaks or takes twice as long, or clangd knows no file."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

UNITY = pathlib.Path(__file__).resolve().parent / "unity.py"
HELPER = "namespace {\nint helper() { return 1; }\n}  // namespace\n"


def run(*words):
    return subprocess.run([sys.executable, UNITY, *words], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()


class Unity(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()

    def file(self, name, text=""):
        (self.root / name).write_text(text)
        return str(self.root / name)

    def test_files_of_a_target_are_compiled_as_one_unless_they_have_a_helper_of_the_same_name(self):
        a, b, c, d = self.file("a.cpp", HELPER), self.file("b.cpp", HELPER), self.file("c.cpp"), self.file("d.cpp")
        said = run(self.file("list", ";".join(["one", a, b, c, "--", "other", d, c, "--", ""])))
        units = [line.split() for line in said]
        self.assertEqual([unit[:2] for unit in units], [["one", "0"], ["one", "1"], ["other", "0"]])
        self.assertEqual(sorted(units[0][2:] + units[1][2:]), [a, b, c])
        self.assertFalse({a, b} <= set(units[0]) or {a, b} <= set(units[1]))
        self.assertEqual(sorted(units[2][2:]), [c, d])

    def test_each_file_has_an_entry_of_its_own_in_the_compile_database(self):
        (self.root / "Unity").mkdir()
        unit, alone = self.file("Unity/unity_0_cxx.cxx", '#include "/p/a.cpp"\n\n#include "/p/b.cpp"\n'), self.file("c.cpp")
        entries = [{"directory": "/", "command": f"c++ -o o -c {file}", "file": file} for file in (unit, alone)]
        database = pathlib.Path(self.file("compile_commands.json", json.dumps(entries)))
        for _ in range(2):
            run("--database", str(self.root))
            made = {entry["file"]: entry["command"] for entry in json.loads(database.read_text())}
            self.assertEqual(made, {file: f"c++ -o o -c {file}" for file in ("/p/a.cpp", "/p/b.cpp", alone)})


if __name__ == "__main__":
    unittest.main()
