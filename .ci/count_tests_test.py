"""If these fail, ./tws test may call a broken build good."""
import pathlib
import tempfile
import unittest

import count_tests

PASSED = '<testcase name="a" status="run"/>'
FAILED = '<testcase name="b" status="run"><failure message=""/></testcase>'
SKIPPED = '<testcase name="c" status="run"><skipped message=""/></testcase>'
DISABLED = '<testcase name="d" status="notrun"/>'


class CountTests(unittest.TestCase):
    def count(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for name, content in files.items():
                file = pathlib.Path(folder, name)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(f"<testsuite>{content}</testsuite>" if content else "")
            total = count_tests.count(pathlib.Path(folder))
            return total["passed"], total["failed"], total["skipped"]

    def test_each_case_of_a_gtest_file_counts_once_also_in_nested_suites(self):
        nested = f"<testsuite>{PASSED}{PASSED}{FAILED}{SKIPPED}{DISABLED}</testsuite>"
        self.assertEqual(self.count({"test_results/p/gtest-p_test.xml": nested}), (2, 1, 1))

    def test_a_rostest_counts_by_the_cases_of_its_program(self):
        files = {"test_results/p/rosunit-x.xml": PASSED + FAILED,
                 "test_results/p/rostest-test_x.xml": '<testcase name="testx"><failure/></testcase>'}
        self.assertEqual(self.count(files), (1, 1, 0))

    def test_a_rostest_whose_program_crashed_is_a_failure(self):
        self.assertEqual(self.count({"test_results/p/rostest-test_x.xml": '<testcase name="testx"><failure/></testcase>'}), (0, 1, 0))

    def test_a_rostest_whose_node_died_is_a_failure_though_its_program_passed(self):
        files = {"test_results/p/rosunit-x.xml": PASSED,
                 "test_results/p/rostest-test_x.xml": '<testcase name="testx"><failure/></testcase>'}
        self.assertEqual(self.count(files), (1, 1, 0))

    def test_a_test_that_ctest_killed_before_it_left_a_file_is_a_failure(self):
        files = {"ctest-unit.xml": '<testcase name="_ctest_p_gtest_p_test" status="fail"/>',
                 "test_results/q/gtest-q_test.xml": FAILED + PASSED}
        self.assertEqual(self.count(files), (1, 2, 0))

    def test_a_failure_that_its_file_shows_is_not_counted_again(self):
        files = {"ctest-unit.xml": '<testcase name="_ctest_p_gtest_p_test" status="fail"/>',
                 "test_results/p/gtest-p_test.xml": FAILED + PASSED}
        self.assertEqual(self.count(files), (1, 1, 0))

    def test_a_test_that_only_ctest_knows_counts(self):
        report = '<testcase name="format" status="run"/><testcase name="tidy" status="notrun"><skipped message=""/></testcase>'
        self.assertEqual(self.count({"ctest-unit.xml": report}), (1, 0, 1))

    def test_what_unittest_prints_counts_case_by_case(self):
        said = "<system-out>Ran 5 tests in 0.1s\n\nFAILED (failures=1, errors=1, skipped=2)</system-out>"
        report = f'<testcase name="_ctest_p_csv" status="fail"><failure/>{said}</testcase>'
        self.assertEqual(self.count({"ctest-unit.xml": report}), (1, 2, 2))
        said = "<system-out>Ran 1 test in 0.1s\n\nOK</system-out>"
        self.assertEqual(self.count({"ctest-unit.xml": f'<testcase name="_ctest_p_csv" status="run">{said}</testcase>'}), (1, 0, 0))

    def test_a_program_that_failed_after_its_cases_passed_is_a_failure(self):
        said = "<system-out>Ran 2 tests in 0.1s\n\nOK</system-out>"
        report = f'<testcase name="_ctest_p_csv" status="fail"><failure/>{said}</testcase>'
        self.assertEqual(self.count({"ctest-unit.xml": report}), (2, 1, 0))

    def test_what_was_skipped_is_said_with_its_reason(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "gtest-x.xml")
            file.write_text('<testcase classname="Plots" name="AreReal"><skipped message="/x_test.cpp:3&#x0A;no data"/></testcase>')
            self.assertEqual(list(count_tests.skipped_cases([file])), ["skipped: Plots.AreReal: no data"])

    def test_a_test_skipped_for_want_of_a_program_is_no_success(self):
        self.assertTrue(count_tests.lacking(["skipped: fuzz: clang++ with libFuzzer is not installed"]))
        self.assertFalse(count_tests.lacking(["skipped: Plots.AreReal: no data"]))

    def test_an_empty_result_file_is_a_failure(self):
        self.assertEqual(self.count({"test_results/p/gtest-p_test.xml": ""}), (0, 1, 0))


if __name__ == "__main__":
    unittest.main()
