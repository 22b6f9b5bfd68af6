#!/usr/bin/env python3
"""evaluate_bag on good and bad bags: evaluate_bag_test.py PATH_OF_EVALUATE_BAG"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
from std_msgs.msg import String
from tws_msgs.msg import Track, Tracks, Truth, TruthTarget

PROGRAM = sys.argv.pop(1)


class ForeignTracks(Tracks):
    """What a later version of the package may record."""
    _md5sum = "0123456789abcdef0123456789abcdef"


def evaluate(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)


class EvaluateBag(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def bag(self, name, truth=True, tracks=Tracks, seconds=60):
        path = self.folder / name
        with rosbag.Bag(str(path), "w") as bag:
            for second in range(1, seconds):
                now = rospy.Time(second)
                if tracks is not None:
                    message = tracks(tracker="adit", radar="a", tracks=[Track(uid=1, state=Track.FIRM, stamp=now, last_update=now)])
                    message.header.stamp, message.header.frame_id = now, "map"
                    bag.write("/adit/tracks", message, now)
                if truth:
                    message = Truth(targets=[TruthTarget(id=1), TruthTarget(id=2)])
                    message.targets[1].position.x = 50e3
                    message.header.stamp, message.header.frame_id = now, "map"
                    bag.write("/truth", message, now)
        return path

    def test_scores_what_is_in_the_bag_and_twice_the_same(self):
        bag, outputs = self.bag("good.bag"), []
        for name in ("a.json", "b.json"):
            done = evaluate(bag, "--json", self.folder / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            outputs.append((self.folder / name).read_bytes())
        self.assertEqual(outputs[0], outputs[1])
        metrics = json.loads(outputs[0])["trackers"]["adit"]["metrics"]
        self.assertEqual((metrics["completeness"], metrics["truths"], metrics["rms_pos_m"]), (0.5, 2, 0))
        self.assertIn("completeness", done.stdout)

    def test_writes_series_and_picture(self):
        series, picture = self.folder / "series.csv", self.folder / "picture.csv"
        self.assertEqual(evaluate(self.bag("good.bag"), "--series", series, "--picture", picture, "--quiet").stdout, "")
        self.assertEqual(len(series.read_text().splitlines()), 1 + 29)  # from 31 s to 59 s
        self.assertIn("adit,10.0000,track,1,0.0,0.0", picture.read_text())

    def test_every_bad_bag_is_one_line_and_a_status(self):
        good = self.bag("good.bag").read_bytes()
        (self.folder / "truncated.bag").write_bytes(good[:len(good) // 2])
        (self.folder / "text.bag").write_text("no bag")
        with rosbag.Bag(str(self.folder / "empty.bag"), "w"):
            pass
        with rosbag.Bag(str(self.folder / "other.bag"), "w") as bag:
            bag.write("/chatter", String("hello"), rospy.Time(1))
        self.bag("no_truth.bag", truth=False)
        self.bag("foreign.bag", tracks=ForeignTracks)
        for name, word in [("truncated", "truncated"), ("text", "no bag"), ("empty", "is empty"), ("other", "holds no tracks"),
                           ("no_truth", "neither truth nor"), ("foreign", "0123456789abcdef"), ("missing", "is missing")]:
            with self.subTest(name):
                done = evaluate(self.folder / f"{name}.bag")
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn(f"{name}.bag", done.stderr)
                self.assertIn(word, done.stderr)
        self.assertEqual(evaluate().returncode, 2)

    def test_a_bag_without_truth_may_be_asked_for_its_timing_alone(self):
        done = evaluate(self.bag("no_truth.bag", truth=False), "--truth-optional")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("track_reports_per_s", done.stdout)


if __name__ == "__main__":
    unittest.main()
