#!/usr/bin/env python3
"""Tables as other people's programs write them: reported_csv_test.py, in a workspace.

The files are in the folder that TWS_SHARED names. If this fails, a user's file is refused without a reason that helps, or read as
something that it does not say.
"""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest


def program(package, name):
    for prefix in os.environ["CMAKE_PREFIX_PATH"].split(":"):
        path = pathlib.Path(prefix, "lib", package, name)
        if path.exists():
            return path
    raise FileNotFoundError(f"{package}/{name} is not built")


ADIT_CSV = ("adit_tracker", "adit_csv")
EVALUATE_CSV = ("track_evaluation", "evaluate_csv")
FILTER_CSV = ("range_gate_tracker", "filter_csv")
SHARED = os.environ.get("TWS_SHARED", "")
FILES = pathlib.Path(SHARED, "data/reported_inputs/csv")
# One table in other forms: each is tracked as base.csv is.
SAME_AS_BASE = ("bom", "comment_in_body", "comment_lines", "cr_only", "crlf", "header_order", "header_upper", "plus_sign", "quoted",
                "semicolon", "semicolon_decimal_comma", "shuffled", "spaces", "tab", "trailing_comma")
SHIFTED = ("epoch_s", "iso_time", "tod_nowrap", "tod_wrap_midnight")  # base.csv at another time


@unittest.skipUnless(SHARED, "TWS_SHARED is not set")
class ReportedCsv(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, place, *words):
        return subprocess.run([program(*place), *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)

    def tracks_of(self, name):
        out = self.folder / "tracks.csv"
        done = self.run_program(ADIT_CSV, "--detections", FILES / f"{name}.csv", "--tracks", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out.read_text().splitlines(), done.stderr

    def test_one_table_in_any_form_gives_the_same_tracks(self):
        base, _ = self.tracks_of("base")
        self.assertGreater(len(base), 400)
        for name in SAME_AS_BASE:
            with self.subTest(name):
                self.assertEqual(self.tracks_of(name)[0], base)

    def test_times_of_any_kind_give_as_many_updates(self):
        base, _ = self.tracks_of("base")
        for name in SHIFTED:
            with self.subTest(name):
                tracks, said = self.tracks_of(name)
                self.assertIn("plots used          540", said)
                self.assertAlmostEqual(len(tracks), len(base), delta=12)
                self.assertEqual("pass midnight 1 time" in said, name == "tod_wrap_midnight")

    # Firm tracks, and how many may be started.
    def test_poor_times_and_another_beam_cost_no_track(self):
        for name, firm, most in (("whole_seconds", 12, 13), ("no_rotation_same_time", 12, 13), ("clock_step_plus3s", 20, 21),
                                 ("clock_step_minus3s", 20, 21), ("restart_20s_other_phase", 20, 21), ("restart_phase", 24, 25),
                                 ("speed_const_same_flights", 20, 21), ("speed_change_same_flights", 20, 21)):
            with self.subTest(name):
                _, said = self.tracks_of(name)
                self.assertEqual(int(re.search(r"become firm +(\d+)", said)[1]), firm, said)
                self.assertLessEqual(int(re.search(r"started +(\d+)", said)[1]), most, said)

    # A file joined to itself: each plot stands in it twice.
    def test_a_table_that_repeats_itself_gives_its_tracks_once(self):
        base, _ = self.tracks_of("base")
        twice, out = self.folder / "twice.csv", self.folder / "twice_tracks.csv"
        rows = (FILES / "base.csv").read_text()
        twice.write_text(rows + rows.split("\n", 1)[1])
        done = self.run_program(ADIT_CSV, "--detections", twice, "--tracks", out)
        self.assertEqual((done.returncode, out.read_text().splitlines()), (0, base), done.stderr)

    def test_what_is_refused_says_what_would_help(self):
        for name, words in (("utf16", "iconv -f UTF-16"), ("epoch_ms", "not milliseconds"), ("no_header", "must name the columns"),
                            ("empty", "is empty"), ("header_only", "no usable plot"),
                            ("counterclockwise", "turns counter-clockwise, once in 4.000 s")):
            with self.subTest(name):
                done = self.run_program(ADIT_CSV, "--detections", FILES / f"{name}.csv", "--tracks", self.folder / "tracks.csv")
                self.assertEqual(done.returncode, 1)
                self.assertIn(words, done.stderr)

    def score(self, tracks):
        out = self.folder / "score.json"
        done = self.run_program(EVALUATE_CSV, "--truth", FILES / "truth.csv", "--tracks", FILES / f"{tracks}.csv", "--json", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(out.read_text())["trackers"]["tracks"]["metrics"]

    # Each of these holds the same places: a score of 1000 m is what columns taken by their order gave.
    def test_tracks_are_scored_by_the_names_of_columns(self):
        base = self.score("tracks")
        for name in ("bom", "crlf", "header_order", "xy_swapped_names", "uuid", "nan_velocity", "empty_velocity"):
            with self.subTest(name):
                self.assertAlmostEqual(self.score(f"tracks_{name}")["ospa_m"], base["ospa_m"], places=6)

    def filtered(self, name):
        out = self.folder / "filtered.csv"
        done = self.run_program(FILTER_CSV, "--in", FILES / f"{name}.csv", "--out", out, "--kind", "alpha_beta")
        return done, [line.split(",") for line in out.read_text().splitlines()[1:]] if done.returncode == 0 else []

    def test_series_are_filtered(self):
        _, base = self.filtered("filter")
        self.assertEqual(len(base), 20)
        for name in ("bom", "crlf", "blank_last", "blank_mid", "extra_col"):
            with self.subTest(name):
                self.assertEqual([row[1:] for row in self.filtered(f"filter_{name}")[1][:20]], [row[1:] for row in base])
        _, interleaved = self.filtered("filter_interleaved")
        self.assertTrue(any(float(row[2]) != float(row[5]) for row in interleaved), "nothing is filtered")
        self.assertEqual(self.filtered("filter_header_order")[0].returncode, 0)
        for name, words in (("noheader", "has no column series"), ("nan", "not finite"), ("empty_field", "measured is empty"),
                            ("trailing_text", "is no number"), ("back", "dt is")):
            with self.subTest(name):
                done, _ = self.filtered(f"filter_{name}")
                self.assertEqual(done.returncode, 1)
                self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
