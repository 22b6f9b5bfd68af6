#!/usr/bin/env python3
"""Radars at two sites: live, replayed and offline runs give the same tracks, byte by byte but for header.seq. (What joining them is worth:
several_radars_test.py.)"""
import pathlib
import tempfile
import unittest

import rosbag
import rosunit

from graph_test_kit import check_same
from whole_graph_test import RADARS, command, late, launch, offline, tracks

DURATION = 40  # of data time [s]


class TwoSitesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="two_sites_"))
        cls.live = launch("run.launch", cls.folder / "live.bag", scenario="two_sites", rate=5, duration=DURATION)

    @classmethod
    def tearDownClass(cls):
        command("rm", "-rf", cls.folder)

    def check_same(self, bag):
        self.assertEqual(late(self.live), {}, "this machine was too slow for the comparison")
        self.assertEqual(late(bag), {}, "this machine was too slow for the comparison")
        check_same(tracks(self.live), tracks(bag))

    def test_both_sites_hold_the_same_firm_tracks(self):
        with rosbag.Bag(str(self.live)) as bag:
            last = {t.uid: t for _, message, _ in bag.read_messages(["/adit/tracks"]) for t in message.tracks if t.state == t.FIRM}
        both = [t for t in last.values() if set(t.radars) == set(RADARS)]
        self.assertGreater(len(both), 5)
        self.assertTrue(any(t.position.z == t.position.z for t in both), "no height from two slant ranges")

    def test_an_offline_run_gives_the_same_tracks(self):
        file = f"{command('rospack', 'find', 'tws_launch').strip()}/scenarios/two_sites.yaml"
        self.check_same(offline(file, self.folder / "offline", "--duration", DURATION))

    def test_an_offline_run_of_the_bag_gives_the_same_tracks(self):
        self.check_same(offline(self.live, self.folder / "again"))

    def test_a_replay_gives_the_same_tracks(self):
        self.check_same(launch("replay.launch", self.folder / "replay.bag", bag=self.live, rate=5))


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "two_sites_test", TwoSitesTest)
