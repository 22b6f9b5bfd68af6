#!/usr/bin/env python3
"""filter_csv as a user calls it: filter_csv_test.py PATH_OF_FILTER_CSV. If this fails, its files are no estimates, or a mistake in one goes
unnoticed."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)


class FilterCsvTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.source, self.target = (pathlib.Path(self.folder.name, name) for name in ("in.csv", "out.csv"))

    def run_on(self, lines, *options):
        self.source.write_text("\n".join(["series,t_s,measured", *lines]) + "\n")
        return subprocess.run([PROGRAM, "--in", self.source, "--out", self.target, *options], stderr=subprocess.PIPE, text=True)

    def estimates(self):
        return [line.split(",") for line in self.target.read_text().splitlines()[1:]]

    def test_the_alpha_filter_lags_by_the_formula(self):
        # 10 m/s, every 2 s, alpha 0.5: 20 m · 0.5 / 0.5.
        done = self.run_on([f"a,{2 * k},{20 * k}" for k in range(200)], "--kind", "alpha", "--alpha", "0.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        last = self.estimates()[-1]
        self.assertAlmostEqual(20 * 199 - float(last[2]), 20.0, places=6)
        self.assertAlmostEqual(20 * 199 - float(last[5]), 40.0, places=6)

    def test_a_new_series_starts_anew(self):
        done = self.run_on(["a,0,0", "a,1,10", "b,0,500", "b,1,500"], "--kind", "alpha_beta")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([float(row[2]) for row in self.estimates()], [0, 10, 500, 500])
        self.assertEqual([float(row[3]) for row in self.estimates()], [0, 10, 0, 0])

    def test_series_may_be_interleaved_and_lines_blank(self):
        done = self.run_on(["a,0,0", "b,0,500", "", "a,1,10", "b,1,500", ""], "--kind", "alpha_beta")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([float(row[2]) for row in self.estimates()], [0, 500, 10, 500])

    # If this fails, one slip in the command line destroys a user's measurements.
    def test_the_input_is_never_the_output(self):
        self.target = self.source
        done = self.run_on(["a,0,0"])
        self.assertEqual((done.returncode, self.source.read_text()), (1, "series,t_s,measured\na,0,0\n"))
        self.assertIn("is the input itself", done.stderr)

    def test_what_cannot_be_used_is_named_with_its_line(self):
        for line, words in (("a,2,nan", "in.csv:4"), ("a,2", "in.csv:4"), ("a,0.5,1", "dt is -0.5"), (",2,2", "series is empty"),
                            ("a,2,x", "measured 'x'")):
            done = self.run_on(["a,0,0", "a,1,1", line, "a,3,3"])
            self.assertEqual(done.returncode, 1, line)
            self.assertIn(words, done.stderr)

    def test_wrong_usage_is_status_2_and_an_unstable_filter_status_1(self):
        self.assertEqual(self.run_on([], "--kind", "beta").returncode, 2)
        self.assertEqual(self.run_on([], "--sigma", "-1").returncode, 2)
        done = self.run_on([], "--kind", "alpha_beta", "--alpha", "1", "--beta", "3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("stable", done.stderr)


if __name__ == "__main__":
    unittest.main()
