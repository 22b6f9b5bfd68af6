"""If these fail, a mistake that clang-tidy sees passes."""
import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

CHECK = pathlib.Path(__file__).resolve().parent / "check_tidy"
GOOD = 'namespace {\nint helper() { return 1; }\n}  // namespace\nint good() { return helper(); }\n'
OTHER = 'namespace {\nint helper() { return 2; }\n}  // namespace\nint other() { return helper(); }\n'
HIDDEN = 'namespace {\nint\nhelper() { return 3; }\n}  // namespace\nint NAME() { return helper(); }\n'
BAD = 'int bad(const int* p) {\n  if (p == 0) return 0;\n  return *p;\n}\n'


@unittest.skipUnless(shutil.which("clang-tidy") and shutil.which("clang++"), "clang-tidy is not installed")
class Tidy(unittest.TestCase):
    def check(self, **files):
        """Status and words of check_tidy in a repository of these files, all compiled alike."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            for name in (".ci", "src", "build"):
                (root / name).mkdir()
            shutil.copy(CHECK, root / ".ci")
            shutil.copy(CHECK.parent / "tidy_units.py", root / ".ci")
            shutil.copy(CHECK.parent.parent / ".clang-tidy", root)
            entries = []
            (root / "src" / "bad.h").write_text("#pragma once\ninline " + BAD)
            for name, text in files.items():
                (root / "src" / f"{name}.cpp").write_text(text)
                gcc = f"-Winvalid-pch -include {root}/none.hxx -flto --param=large-unit-insns=9 -Wno-subobject-linkage"
                command = f"/usr/bin/c++ -std=c++17 {gcc} -o {name}.o -c {root}/src/{name}.cpp"
                entries.append({"directory": folder, "command": command, "file": f"{root}/src/{name}.cpp"})
            (root / "build" / "compile_commands.json").write_text(json.dumps(entries))
            done = subprocess.run([root / ".ci" / "check_tidy", root / "build"], stdout=subprocess.PIPE, text=True)
            return done.returncode, done.stdout

    def test_files_with_a_helper_of_the_same_name_are_both_checked(self):
        status, said = self.check(good=GOOD, other=OTHER)
        self.assertEqual(status, 0, said)
        self.assertIn("2 files", said)

    def test_a_mistake_in_one_of_several_files_is_shown_with_its_place(self):
        for files in ({"good": GOOD, "worse": BAD}, {"good": GOOD, "other": OTHER, "worse": OTHER.replace("other", "o3") + BAD}):
            status, said = self.check(**files)
            self.assertEqual(status, 1)
            self.assertRegex(said, r"/src/worse.cpp:\d+:\d+: error: .*modernize-use-nullptr")

    def test_the_analyser_follows_paths_through_files_that_are_checked_together(self):
        null = "int bad(int x) {\n  int* p = nullptr;\n  if (x > 3) return *p;\n  return 0;\n}\n"
        status, said = self.check(good=GOOD, null=null)
        self.assertEqual(status, 1)
        self.assertRegex(said, r"/src/null.cpp:\d+:\d+: error: .*core.NullDereference")

    def test_a_mistake_in_a_header_is_shown(self):
        status, said = self.check(good=GOOD, includes='#include "bad.h"\nint i() { return bad(nullptr); }\n')
        self.assertEqual(status, 1)
        self.assertRegex(said, r"/src/bad.h:\d+:\d+: error: .*modernize-use-nullptr")

    def test_programs_and_files_whose_clash_only_the_compiler_sees_are_checked(self):
        main = "int main() { return 0; }\n"
        status, said = self.check(one=HIDDEN.replace("NAME", "one") + main, two=HIDDEN.replace("NAME", "two") + main)
        self.assertEqual(status, 0, said)
        self.assertIn("parted in 2", said)
        status, said = self.check(one=HIDDEN.replace("NAME", "one"), two=HIDDEN.replace("NAME", "two") + BAD)
        self.assertEqual(status, 1)
        self.assertRegex(said, r"/src/two.cpp:\d+:\d+: error: .*modernize-use-nullptr")

    def test_a_file_that_does_not_compile_is_a_mistake(self):
        self.assertEqual(self.check(good=GOOD, broken="int f() { return x; }\n")[0], 1)

    def test_a_build_folder_without_files_is_no_success(self):
        self.assertEqual(self.check()[0], 1)


if __name__ == "__main__":
    unittest.main()
