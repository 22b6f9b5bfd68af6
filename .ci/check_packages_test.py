"""If these fail, ./tws may not install what it needs, and only a bare machine tells."""
import pathlib
import unittest

import check_packages as check
import shell_words

RECORDS = """\
dash\tinstalled\tyes\trequired\t\t\t
apt\tinstalled\tno\timportant\t\t\t
ros-tool\tinstalled\tno\toptional\t\t\tpython3-ros (>= 1), libc6 | libc-of-old
python3-ros\tinstalled\tno\toptional\tpython3-ros-abi\t\t
python3-tf2-msgs\tinstalled\tno\toptional\t\tpython3-genpy:any\tpython3-ros-abi
python3-genpy\tinstalled\tno\toptional\t\t\t
libc6\tinstalled\tno\toptional\t\t\t
libc-of-old\tinstalled\tno\toptional\t\t\t
gone\tconfig-files\tno\toptional\t\t\t
"""


class Closure(unittest.TestCase):
    def closure(self, *names):
        return check.Installed(RECORDS).closure(names)

    def test_what_a_package_depends_on_comes_with_it_and_what_every_debian_has(self):
        self.assertEqual(self.closure("ros-tool"), {"dash", "apt", "ros-tool", "python3-ros", "libc6"})

    def test_a_second_alternative_does_not_come_though_it_is_installed(self):
        self.assertNotIn("libc-of-old", self.closure("ros-tool"))

    def test_a_name_that_packages_only_provide_brings_those(self):
        self.assertLessEqual({"python3-ros", "python3-genpy"}, self.closure("python3-tf2-msgs"))

    def test_a_listed_package_that_is_not_installed_is_said(self):
        self.assertEqual(check.missing({"packages": ["dash", "gone"]}, check.Installed(RECORDS)),
                         ["tws: 'gone' of packages is not installed"])


class Verdict(unittest.TestCase):
    def verdict(self, lists, file="p/test/x_rostest.py", text="from tf2_msgs.msg import TFMessage"):
        uses = list(check.reader_of(pathlib.Path(file), text)(pathlib.Path(file), text))
        places = {(use.kind, use.name): "/usr/lib/" + use.name for use in uses}
        owner = {"/usr/lib/tf2_msgs.msg": "python3-tf2-msgs", "/usr/lib/tshark": "tshark"}
        return list(check.mistakes(uses, lists, check.Installed(RECORDS), places, owner))

    def test_an_import_whose_package_only_this_machine_has_is_refused(self):
        said = self.verdict({"packages": ["ros-tool"]})
        self.assertEqual(len(said), 1)
        self.assertIn("p/test/x_rostest.py:1: import 'tf2_msgs.msg' is in python3-tf2-msgs, which ./tws does not install", said[0])

    def test_it_is_content_when_a_list_has_the_package(self):
        self.assertEqual(self.verdict({"packages": ["ros-tool"], "developer_packages": ["python3-tf2-msgs"]}), [])

    def test_what_a_user_runs_may_not_need_a_developers_package(self):
        self.assertEqual(len(self.verdict({"developer_packages": ["python3-tf2-msgs"]}, file="p/src/x.py")), 1)

    def test_what_is_in_no_package_is_said(self):
        said = self.verdict({}, text='import subprocess\nsubprocess.run(["pip-thing", "-x"])')
        self.assertIn("p/test/x_rostest.py:2: program 'pip-thing' is in no installed Debian package", said)


class Reading(unittest.TestCase):
    def names(self, file, text):
        path = pathlib.Path(file)
        return [(use.line, use.kind, use.name) for use in check.reader_of(path, text)(path, text)]

    def test_imports_and_programs_of_python_also_of_scripts_without_suffix(self):
        text = '#!/usr/bin/env python3\nimport a.b\ndef f():\n    from c import d\n    subprocess.run(["tshark", x])\nshutil.which("dot")\n'
        self.assertCountEqual(self.names("scripts/report", text),
                              [(2, "import", "a.b"), (4, "import", "c"), (5, "program", "tshark"), (6, "program", "dot")])

    def test_a_program_named_by_a_variable_is_left_alone(self):
        self.assertEqual(self.names("x.py", "subprocess.run([sys.executable, x])\nsubprocess.run(words)"), [])

    def test_headers_that_are_not_the_files_own(self):
        self.assertEqual(self.names("x.cpp", '#include "own.h"\n#include <Eigen/Core>'), [(2, "header", "Eigen/Core")])

    def test_packages_and_prefixes_of_launch_files(self):
        text = '<launch>\n<node pkg="rosbag" type="play" launch-prefix="xterm -e"/>\n<include file="$(find rviz)/x"/></launch>'
        self.assertCountEqual(self.names("x.launch", text), [(2, "package", "rosbag"), (2, "program", "xterm"), (3, "package", "rviz")])

    def test_what_package_xml_names(self):
        text = "<package><name>p</name>\n<depend>roscpp</depend>\n<test_depend>tf2_msgs</test_depend></package>"
        self.assertEqual(self.names("p/package.xml", text), [(2, "package", "roscpp"), (3, "package", "tf2_msgs")])

    def test_the_lists_of_the_script(self):
        text = "packages=(\n  g++ make # compiler\n  cmake\n)\nreport_packages=(python3-tk)\n"
        self.assertEqual(check.lists_in(text), {"packages": ["g++", "make", "cmake"], "report_packages": ["python3-tk"]})

    def test_dependencies_in_debians_words(self):
        self.assertEqual(check.alternatives("a (>= 1) | b [amd64], c:any"), [["a", "b"], ["c"]])


class Shell(unittest.TestCase):
    def names(self, text):
        return [name for _, name in shell_words.commands(text)]

    def test_commands_stand_first_after_pipes_conditions_and_assignments(self):
        text = 'LC_ALL=C sort x | uniq -c && if ! grep -q y z; then awk 1; fi\ncd /; [ -n "$x" ] || mkdir d'
        self.assertEqual(self.names(text), ["sort", "uniq", "grep", "awk", "mkdir"])

    def test_what_is_quoted_or_a_comment_is_not_called_but_what_is_substituted_is(self):
        self.assertEqual(self.names("""echo "no tshark; $(date "+$(nproc)") | dot" 'a; b' # | c\n"""), ["date", "nproc"])

    def test_the_lines_are_those_of_the_file(self):
        self.assertEqual(list(shell_words.commands("x='a\nb'\n\ntshark $(\nnproc)")), [(4, "tshark"), (5, "nproc")])

    def test_programs_that_run_programs(self):
        self.assertEqual(self.names("find . -print0 | xargs -0 -P 2 clang-tidy --quiet"), ["find", "xargs", "clang-tidy"])

    def test_functions_of_the_script_arrays_patterns_and_texts_are_no_programs(self):
        text = 'say() { echo "$*"; }\nlist=(one\n two)\ncase $1 in\n  run | build) say x ;;\n  *) tee y ;;\nesac\n'
        text += "cat <<END\nfind $(id)\nEND\nrm z"
        self.assertEqual(self.names(text), ["tee", "cat", "rm", "id"])


if __name__ == "__main__":
    unittest.main()
