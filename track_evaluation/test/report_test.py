#!/usr/bin/env python3
"""The page of a run: report_test.py PATH_OF_REPORT. If this fails, a user cannot show anybody how good a tracker is."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

REPORT = sys.argv.pop(1)
SERIES = "tracker,t_s,ospa_m,gospa_m,gospa_loc,gospa_miss,gospa_false,completeness,required,tracks,rms_pos_m\n"


class ReportTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_folder(self, name, completeness, trackers=("adit",)):
        run = self.folder / name
        run.mkdir()
        row = {"profile": "en route", "name": "long gaps", "unit": "", "value": 0.5, "limit": 0.01, "sense": "at most", "passed": False}
        score = {"metrics": {"completeness": completeness, "gospa_m": None}, "identity": {}, "timing": {}, "requirements": [row]}
        scores = {"version": 1, "input": "x", "settings": {"order": 2}, "trackers": dict.fromkeys(trackers, score)}
        (run / "metrics.json").write_text(json.dumps(scores))
        (run / "series.csv").write_text(SERIES + "".join(f"adit,{t},1,2,3,4,5,{completeness},6,7,8\n" for t in range(60, 70)))
        picture = ["tracker,t_s,what,id,x_m,y_m", "adit,60,required,1,0,0", "adit,62,required,1,9,9", "adit,60,track,7,0,0"]
        (run / "picture.csv").write_text("\n".join(picture) + "\n")
        return run

    def report(self, *arguments):
        return subprocess.run([sys.executable, REPORT, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=120)

    def page(self, *runs):
        out = self.folder / "page.html"
        done = self.report(*runs, "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out.read_text()

    def test_the_page_needs_nothing_but_itself(self):
        page = self.page(self.run_folder("one", 0.9))
        self.assertIsNone(re.search(r"<script|<link|src='(?!data:)|src=\"(?!data:)|url\(['\"]?http", page))
        self.assertGreaterEqual(page.count("<svg"), 3)
        self.assertIn("data:image/png;base64,", page)
        self.assertIn("@media print", page)

    def test_it_says_values_and_failed_requirements(self):
        page = self.page(self.run_folder("one", 0.9))
        self.assertIn("90.00 %", page)
        self.assertIn("FAIL", page)

    # If this fails, nobody sees that a radar was misaligned; or numbers of a foreign bag that are none end in no page at all.
    def test_it_shows_errors_of_registration_where_they_are_known(self):
        run = self.run_folder("one", 0.9)
        self.assertNotIn("Registration", self.page(run))
        shown = ",".join(f"{name},{name}_sigma,{name}_applied" for name in ("range_m", "azimuth_rad", "clock_s"))
        rows = [f"tracker,t_s,radar,state,relative_only,{shown}"]
        rows += [f"adit,{t},sps12,2,1,{40 + t},9,40,.01,.001,.01,{clock},.1,0" for t, clock in ((5, 0), (10, "nan"), (15, 0.1))]
        (run / "registration.csv").write_text("\n".join(rows) + "\n")
        self.assertIn("<h2>Registration</h2>", self.page(run))

    def test_two_runs_stand_side_by_side_with_their_difference(self):
        page = self.page(self.run_folder("one", 0.9), self.run_folder("two", 0.95))
        self.assertIn("<td class='n better'>+5.00 %</td>", page)

    # If this fails, a page of a whole graph compares a range gate with a surveillance radar, in columns beyond the screen.
    def test_trackers_are_compared_with_themselves_in_another_run(self):
        both = ("adit", "esa")
        page = self.page(self.run_folder("one", 0.9, both))
        self.assertNotIn("difference", page)
        self.assertIn("<b>esa</b>", page)
        page = self.page(self.run_folder("two", 0.9, both), self.run_folder("three", 0.95, both))
        self.assertEqual(page.count("<td class='n better'>+5.00 %</td>"), 2)
        self.assertIn("<b>three: esa</b>", page)

    # If this fails, a slip of the pen destroys a recording, or a full disk leaves half a page.
    def test_the_page_is_whole_and_replaces_no_run_and_no_link(self):
        run = self.run_folder("one", 0.9)
        link = self.folder / "link.html"
        link.symlink_to(run / "series.csv")
        for out, reason in ((link, "no regular file"), ("/dev/null", "no regular file"), (self.folder / "no" / "page", "No such file")):
            done = self.report(run, "--out", out)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(reason, done.stderr)
        done = subprocess.run(["sh", "-c", 'ulimit -f 8; exec "$@"', "sh", sys.executable, REPORT, run, "--out", self.folder / "page"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("page: cannot be written: File too large", done.stderr)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["link.html", "one"])

    def test_a_name_cannot_break_the_page(self):
        self.assertNotIn("<b>bad", self.page(self.run_folder("<b>bad", 0.9)).replace("<b>&lt;b&gt;bad", ""))

    def test_what_is_no_run_is_one_line_and_a_status(self):
        (self.folder / "broken").mkdir()
        (self.folder / "broken" / "metrics.json").write_text("{")
        for run in ("nothing", "broken"):
            done = self.report(self.folder / run)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(run, done.stderr)
        self.assertEqual(self.report().returncode, 2)


if __name__ == "__main__":
    unittest.main()
