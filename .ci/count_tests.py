#!/usr/bin/env python3
"""Counts the tests of one ./tws test: prints "N passed, N failed" (", N skipped" when there are any) and exits 1 unless all went well.

Counted are single test cases, from the result files that catkin keeps (gtest, rostest, launch file checks), and what Python's
unittest says of the tests that only ctest knows; those that say nothing count once. A rostest is counted by the cases of the program
it ran; catkin_test_results counts those twice. What was skipped is listed with its reason.
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


def skip_reason(case):
    skipped = case.find("skipped")
    words = (skipped.get("message") or "") + "\n" + (case.findtext("system-out") or "")
    return " ".join(line.strip() for line in words.splitlines() if line.strip() and not line.startswith(("/", "SKIP_RETURN_CODE")))


def skipped_cases(files):
    """One line for each skipped test case."""
    for file in files:
        try:
            tree = xml.parse(file)
        except xml.ParseError:
            continue
        for case in tree.iter("testcase"):
            counts = of_unittest(case.findtext("system-out"))
            if case.find("skipped") is not None:
                yield f"skipped: {case.get('classname')}.{case.get('name')}: {skip_reason(case)}"
            elif counts and counts["skipped"]:
                yield f"skipped: {counts['skipped']} cases of {case.get('name')}"


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


def of_unittest(output):
    """The counts in what Python's unittest prints at its end; None where it has not run."""
    ran = re.search(r"^Ran (\d+) tests? in .*\n+(?:OK|FAILED)(?: \((.*)\))?", output or "", re.MULTILINE)
    if not ran:
        return None
    told = {kind: int(n) for kind, n in re.findall(r"(\w+)=(\d+)", ran[2] or "")}
    failed, skipped = told.get("failures", 0) + told.get("errors", 0), told.get("skipped", 0)
    return collections.Counter(passed=int(ran[1]) - failed - skipped, failed=failed, skipped=skipped)


def only_known_to_ctest(report, outcomes):
    """Counts of the tests in ctest's own report that left no result file, or died before they left it."""
    total = collections.Counter()
    for case in xml.parse(report).iter("testcase"):
        name, result = case.get("name"), outcome(case)
        if re.match("_ctest_.*_(gtest|rostest|roslaunch-check|nosetests)_", name):
            total["failed"] += result == "failed" and not has_failed_file(name, outcomes)
            continue
        counts = of_unittest(case.findtext("system-out")) or collections.Counter({result: 1})
        total.update(counts)
        total["failed"] += result == "failed" and not counts["failed"]
    return total


def count(build):
    outcomes = results_by_file(build / "test_results")
    total = collections.Counter(result for results in outcomes.values() for result in results)
    for report in sorted(build.glob("ctest-*.xml")):
        total.update(only_known_to_ctest(report, outcomes))
    return total


def lacking(skipped):
    """Whether a test was skipped for want of a program: ./tws test installs all that its tests need, so it forgot one."""
    return any("not installed" in line for line in skipped)


def main():
    build = pathlib.Path(sys.argv[1])
    skipped = list(skipped_cases([*sorted(build.glob("test_results/*/*.xml")), *sorted(build.glob("ctest-*.xml"))]))
    print("".join(line + "\n" for line in skipped), end="")
    total = count(build)
    line = f"{total['passed']} passed, {total['failed']} failed"
    print(line + (f", {total['skipped']} skipped" if total["skipped"] else ""))
    return 0 if total["passed"] and not total["failed"] and not lacking(skipped) else 1


if __name__ == "__main__":
    sys.exit(main())
