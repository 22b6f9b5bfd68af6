#!/usr/bin/env python3
"""Recordings in which one radar's clock or publisher is bad, beside the healthy one: clocks_test.py PATH_OF_TWS_OFFLINE

Needs the folder that TWS_SHARED names, else it is skipped. One source's clock costs the others nothing, and is named.
"""
import collections
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag

from graph_test_kit import message_bytes

OFFLINE = sys.argv.pop()
SHARED = os.environ.get("TWS_SHARED", "")
FOLDER = pathlib.Path(SHARED, "data", "reported_inputs", "bags")
FIRM = 2
STEP = 1020.0  # when the clock of sps12 steps [s]


class Run:
    """An offline run of a recording."""

    def __init__(self, name):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([OFFLINE, FOLDER / f"{name}.bag", "--out", folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, timeout=120, check=False)
            if done.returncode:
                raise AssertionError(done.stdout)
            self.said = done.stdout
            self.raw, self.firm = message_bytes(f"{folder}/run.bag"), collections.defaultdict(list)
            with rosbag.Bag(f"{folder}/run.bag") as bag:
                for _, message, _ in bag.read_messages(["/adit/tracks"]):
                    self.firm[message.radar] += [t.uid for t in message.tracks if t.state == FIRM and message.header.stamp.to_sec() > STEP]
        rows = [line.split() for line in self.said.splitlines()]
        self.counts = {" ".join(row[1:-2]): int(row[-2]) for row in rows if row and row[0] == "adit" and row[-1] == "!"}


@unittest.skipUnless(FOLDER.is_dir(), "TWS_SHARED does not name the recordings")
class Clocks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.healthy = Run("small_base")

    def test_nothing_is_counted_of_a_healthy_recording(self):
        self.assertEqual(self.healthy.counts, {})
        self.assertGreater(len(self.healthy.firm["sps39"]), 200)

    def test_a_sector_a_day_ahead_is_left_out(self):
        extra, one = Run("extra_sector_a_day_ahead"), Run("one_sector_a_day_ahead")
        self.assertEqual(extra.raw, self.healthy.raw)
        self.assertEqual(extra.counts, {"stray messages": 2})
        self.assertEqual(len(one.raw), len(self.healthy.raw))
        self.assertGreaterEqual(len(one.firm["sps12"]), len(self.healthy.firm["sps12"]) - 2)

    def test_a_second_player_is_left_out_and_named(self):
        run = Run("second_player_old_sps12")
        self.assertEqual(run.raw, self.healthy.raw)
        self.assertGreater(run.counts["messages of a second publisher"], 100)
        self.assertIn("played twice?", run.said)

    def test_half_a_second_is_borne(self):
        for step in ("-0.5", "0.5"):
            run = Run(f"sps12_clock_step_{step}")
            self.assertGreaterEqual(len(run.firm["sps39"]), 0.98 * len(self.healthy.firm["sps39"]), step)
            self.assertGreaterEqual(len(run.firm["sps12"]), 0.98 * len(self.healthy.firm["sps12"]), step)

    def test_a_clock_that_steps_further_costs_the_other_radar_nothing(self):
        held = {uid for uid, count in collections.Counter(self.healthy.firm["sps39"]).items() if count > 1}
        for step in ("-3", "3", "-3600"):
            run = Run(f"sps12_clock_step_{step}")
            # By one radar alone a new track becomes firm some updates later; none may be lost.
            self.assertLessEqual(held, set(run.firm["sps39"]), step)
            self.assertGreaterEqual(len(run.firm["sps39"]), 0.95 * len(self.healthy.firm["sps39"]), step)
            self.assertEqual(run.counts["set aside"], 2, "its detections and its marks")
            self.assertNotIn("new runs", run.counts)
            self.assertIn("in sps12/", run.said)


if __name__ == "__main__":
    unittest.main()
