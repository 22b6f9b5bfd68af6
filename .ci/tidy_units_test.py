"""If these fail, clang-tidy skips files, or takes the time of many more units than are needed."""
import json
import pathlib
import tempfile
import unittest

import tidy_units


def helper(name, space="p"):
    return f"namespace {space} {{\nnamespace {{\n\n{name}\n\n}}  // namespace\n}}  // namespace {space}\n"


class Units(unittest.TestCase):
    def units(self, files, macros="", **headers):
        """Names of the files in each unit that these make; files: text by name, macros: of all but the first."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            (root / "build").mkdir()
            for name, text in headers.items():
                (root / f"{name}.h").write_text(text)
            entries = []
            for name, text in files.items():
                (root / name).write_text(text)
                words = f"c++ -I{root} {macros if entries else ''} -DNAME='\"{name}\"' -Dp_EXPORTS -O2 -o {name}.o -c {root}/{name}"
                entries.append({"directory": folder, "command": words, "file": f"{root}/{name}"})
            (root / "build" / "compile_commands.json").write_text(json.dumps(entries))
            self.made = tidy_units.units(tidy_units.sources(root / "build", root))
        return sorted(sorted(source.file.name for source in unit.members) for unit in self.made)

    def apart(self, first, second, **headers):
        return len(self.units({"a.cpp": first, "b.cpp": second}, **headers)) == 2

    def test_files_of_all_packages_share_a_unit_each_with_its_own_macros(self):
        self.assertEqual(self.units({"a.cpp": "int main() {\n", "b.cpp": "int main() {\n"}), [["a.cpp", "b.cpp"]])
        text = self.made[0].text()
        self.assertRegex(text, r'(?s)#define NAME "a.cpp"\n.*a.cpp"\n#undef NAME\n.*#define NAME "b.cpp"')
        self.assertIn("#define main main_1\n", text)
        self.assertEqual(self.made[0].flags().count("-O2"), 1)
        self.assertIn("-Dp_EXPORTS", self.made[0].flags())

    def test_helpers_of_the_same_name_are_apart(self):
        for one in ("int f(int x) {\n", "constexpr double kPi = 3.0;", "struct Plot {\n", "using Plots = std::vector<int>;",
                    "const std::map<std::string, int> names{{1, 2}};", "TEST(Plot, IsSeen) {\n", "template <class T>\nT f(T x) {\n"):
            self.assertTrue(self.apart(helper(one), helper(one)), one)
            self.assertFalse(self.apart(helper(one), helper(one, "q")), one)
        self.assertTrue(self.apart("static int f() {\n", "static int f() {\n"))

    def test_what_is_only_declared_or_indented_is_no_helper(self):
        for one in ("using tws::Plot;", "class Plot;", "  int f(int x);", "// int f(int x)"):
            self.assertFalse(self.apart(helper(one), helper(one)), one)

    def test_a_helper_is_apart_from_who_includes_a_header_with_that_name(self):
        header = "namespace p {\ninline int f() { return 1; }\n}  // namespace p\n"
        for included in ('#include "own.h"\n', "#include <own.h>\n", '#include "outer.h"\n'):
            self.assertTrue(self.apart(helper("int f() {\n"), included, own=header, outer='#include "own.h"\n'))
            self.assertFalse(self.apart(helper("int g() {\n"), included, own=header, outer='#include "own.h"\n'))

    def test_tests_and_files_for_which_a_header_reads_otherwise_are_apart(self):
        self.assertEqual(self.units({"a.cpp": "", "a_test.cpp": ""}), [["a.cpp"], ["a_test.cpp"]])
        asks = {"a.cpp": '#include "asks.h"\n', "b.cpp": '#include "asks.h"\n'}
        self.assertEqual(len(self.units(asks, "-DNODELET", asks="#ifdef NODELET\n#endif\n")), 2)
        self.assertEqual(len(self.units(asks, "-DOTHER", asks="#ifdef NODELET\n#endif\n")), 1)

    def test_files_that_need_the_same_libraries_are_together(self):
        files = {f"{number:03}.cpp": "#include <CLI/CLI.hpp>\n" if number % 40 == 0 else "#include <cmath>\n" for number in range(200)}
        with_cli = {name for name in files if int(name[:3]) % 40 == 0}
        self.assertEqual(sum(1 for unit in self.units(files) if with_cli & set(unit)), 1)

    def test_what_cmake_compiles_as_one_is_read_file_by_file(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            unit = root / "build" / "Unity" / "unity_0_cxx.cxx"
            unit.parent.mkdir(parents=True)
            files = [root / "a.cpp", root / "b.cpp"]
            for file in files:
                file.write_text("")
            unit.write_text("/* by CMake */\n" + "".join(f'#include "{file}"\n\n' for file in files))
            entry = {"directory": folder, "command": f"c++ -DX -o u.o -c {unit}", "file": str(unit)}
            (root / "build" / "compile_commands.json").write_text(json.dumps([entry]))
            self.assertEqual([source.file for source in tidy_units.sources(root / "build", root)], files)
            self.assertEqual(tidy_units.entries(root / "build")[1]["command"], f"c++ -DX -o u.o -c {files[1]}")

    def test_who_opens_a_namespace_is_the_last_of_a_unit(self):
        self.units({"a.cpp": "using namespace p;\n", "b.cpp": "", "c.cpp": ""})
        self.assertEqual([source.file.name for source in self.made[0].members], ["b.cpp", "c.cpp", "a.cpp"])

    def test_no_unit_is_much_longer_than_others_and_no_file_is_lost(self):
        files = {f"{number:03}.cpp": helper("int f() {\n") if number % 50 == 0 else "" for number in range(150)}
        units = self.units(files)
        self.assertEqual(sorted(sum(units, [])), sorted(files))
        self.assertEqual([len(unit) for unit in units], [50, 50, 50])


if __name__ == "__main__":
    unittest.main()
