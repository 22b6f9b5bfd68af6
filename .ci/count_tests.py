#!/usr/bin/env python3
"""Counts the tests of one ./tws test: prints "N passed, N failed" (", N skipped" when there are any) and exits 1 unless all went well.

Counted are single test cases, from the result files that catkin keeps (gtest, rostest, launch file checks), and the tests that only
ctest knows. A rostest is counted by the cases of the program it ran; catkin_test_results counts those twice.
"""
import collections
import pathlib
import re
import sys
import xml.etree.ElementTree as xml


def outcome(case):
    """One of "passed", "failed", "skipped", or None for a case that was not to run."""
    if case.find("failure") is not None or case.find("error") is not None or case.get("status") == "fail":
        return "failed"
    if case.find("skipped") is not None:
        return "skipped"
    return None if case.get("status") in ("notrun", "disabled") else "passed"


def cases(file):
    """The test cases of a result file; an empty or broken file counts as one that failed."""
    try:
        return [(case.get("name"), outcome(case)) for case in xml.parse(file).iter("testcase")]
    except xml.ParseError:
        return [(file.name, "failed")]


def rostest_cases(file, outcomes_of_file):
    """What a rostest's own file adds to those of its programs: a failure of the launch, or a program that left no result."""
    added = []
    for name, result in cases(file):
        inner = outcomes_of_file.get(file.parent / f"rosunit-{name[len('test'):]}.xml")
        if inner is None or (result == "failed" and "failed" not in inner):
            added.append(result)
    return added


def results_by_file(folder):
    files = sorted(folder.rglob("*.xml"))
    outcomes = {file: [result for _, result in cases(file)] for file in files if not file.name.startswith("rostest-")}
    outcomes.update({file: rostest_cases(file, outcomes) for file in files if file.name.startswith("rostest-")})
    return outcomes


def has_failed_file(name, outcomes):
    """Whether the failure of ctest's test `_ctest_<package>_<type>_<name>` shows in a result file of that package."""
    return any("failed" in results and name.startswith(f"_ctest_{file.parent.name}_") for file, results in outcomes.items())


def count(build):
    outcomes = results_by_file(build / "test_results")
    total = collections.Counter(result for results in outcomes.values() for result in results)
    for report in sorted(build.glob("ctest-*.xml")):
        for name, result in cases(report):
            from_catkin = re.match("_ctest_", name)
            if not from_catkin or (result == "failed" and not has_failed_file(name, outcomes)):
                total[result] += 1
    return total


def main():
    total = count(pathlib.Path(sys.argv[1]))
    line = f"{total['passed']} passed, {total['failed']} failed"
    print(line + (f", {total['skipped']} skipped" if total["skipped"] else ""))
    return 0 if total["passed"] and not total["failed"] else 1


if __name__ == "__main__":
    sys.exit(main())
