#!/usr/bin/env python3
"""The statistics behind `papers`: papers_test.py PATH_OF_PAPERS. If this fails, a claim is called confirmed by chance."""
import importlib.machinery
import importlib.util
import math
import pathlib
import subprocess
import sys
import unittest

PAPERS = sys.argv.pop(1)
sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(PAPERS).parent))
loader = importlib.machinery.SourceFileLoader("papers", PAPERS)
papers = importlib.util.module_from_spec(importlib.util.spec_from_loader("papers", loader))
loader.exec_module(papers)
Sample, verdict = papers.Sample, papers.verdict

import papers_mrs  # noqa: E402, beside the program


class MrsTest(unittest.TestCase):
    def test_truth_is_interpolated_between_its_messages_and_carried_on_behind_them(self):
        times, ranges = [10.0, 10.5, 11.0], [100.0, 110.0, 130.0]
        for time, expected in ((10.0, 100.0), (10.25, 105.0), (10.75, 120.0), (11.25, 140.0)):
            self.assertAlmostEqual(papers_mrs.interpolated(times, ranges, time), expected)


class PapersTest(unittest.TestCase):
    def test_the_interval_is_students(self):
        # Mean 3, standard deviation sqrt(2.5), five values: 2.776 * sqrt(2.5 / 5).
        sample = Sample([1, 2, 3, 4, 5])
        self.assertEqual(sample.mean, 3)
        self.assertAlmostEqual(sample.half_width, 2.776 * math.sqrt(0.5), places=9)
        self.assertEqual(sample.in_words("m", digits=1), "3.0 ± 2.0 m")

    def test_one_seed_has_no_interval_and_no_verdict(self):
        self.assertEqual(Sample([4]).in_words(), "4.00")
        self.assertEqual(verdict(Sample([4])), "one seed says nothing")
        self.assertEqual(Sample([4]).surely_above(1, "fast", "slow"), "one seed says nothing")
        self.assertEqual(Sample([4, 4.1, 3.9]).surely_above(1, "fast", "slow"), "fast")
        self.assertEqual(Sample([4, 4.1, 3.9]).surely_above(4, "fast", "slow"), "slow")

    def test_a_verdict_needs_the_whole_interval_on_one_side(self):
        self.assertEqual(verdict(Sample([1, 1.1, 0.9])), "confirmed")
        self.assertEqual(verdict(Sample([-1, -1.1, -0.9])), "CONTRADICTED")
        self.assertEqual(verdict(Sample([1, -1, 0.5])), "no difference to be seen")

    def test_differences_are_taken_seed_by_seed(self):
        # The scenes differ by 100, the trackers by 1: only pairs show it.
        self.assertEqual(verdict(Sample([101, 201.1, 300.9]) - Sample([100, 200, 300])), "confirmed")

    def test_bad_usage_is_status_2(self):
        for words in (["nobody"], ["--seeds", "0"], ["--seeds", "x"]):
            done = subprocess.run([sys.executable, PAPERS, *words], stderr=subprocess.PIPE, text=True)
            self.assertEqual(done.returncode, 2, words)


if __name__ == "__main__":
    unittest.main()
