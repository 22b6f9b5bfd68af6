#!/usr/bin/env python3
"""Bags recorded before a message changed

tracks_before_existence.bag holds four messages of each of three topics of the scenario bel_three_targets, as version b6f4c19 recorded
them; requests_before_radar_counts.bag, two requests in the form that they had then. If this fails, nobody can use recordings of earlier
versions.
"""
import math
import pathlib
import subprocess
import tempfile
import unittest

import rosbag

HERE = pathlib.Path(__file__).resolve().parent
KEPT, RULES = HERE / "tracks_before_existence.bag", HERE.parent.parent / "msgs" / "migration" / "rules.bmr"
REQUESTS = HERE / "requests_before_radar_counts.bag"


def messages(path):
    with rosbag.Bag(str(path)) as bag:
        return list(bag.read_messages())


class OldBags(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def fix(self, kept):
        """The messages of a bag before and after."""
        fixed = self.folder / "fixed.bag"
        done = subprocess.run(["rosbag", "fix", "-n", kept, fixed, RULES], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return messages(kept), messages(fixed)

    def test_rosbag_fix_keeps_all_that_an_operator_asked(self):
        before, after = self.fix(REQUESTS)
        self.assertEqual([(topic, t) for topic, _, t in after], [(topic, t) for topic, _, t in before])
        self.assertEqual([len(new.clutter) for _, new, _ in after], [2, 0])
        for (_, old, _), (_, new, _) in zip(before, after):
            for name in old.__slots__:
                self.assertEqual(str(getattr(old, name)), str(getattr(new, name)), name)
            self.assertEqual(len(new.radar_counts), 0)

    def test_rosbag_fix_keeps_all_that_a_track_said(self):
        before, after = self.fix(KEPT)
        self.assertEqual(len(before), 12)
        self.assertEqual([(topic, t) for topic, _, t in after], [(topic, t) for topic, _, t in before])
        tracks = 0
        for (_, old, _), (_, new, _) in zip(before, after):
            for was, now in zip(old.tracks, new.tracks):
                was, now = getattr(was, "track", was), getattr(now, "track", now)  # of a CorrelatedTrack
                tracks += 1
                for name in was.__slots__:
                    self.assertEqual(str(getattr(was, name)), str(getattr(now, name)), name)
                self.assertTrue(math.isnan(now.existence) and math.isnan(now.plot_range) and math.isnan(now.plot_azimuth))
                self.assertEqual(len(now.model_probabilities), 0)
                self.assertTrue(math.isnan(now.latitude) and math.isnan(now.longitude) and math.isnan(now.altitude))
            self.assertEqual(old.header.stamp, new.header.stamp)
        self.assertGreater(tracks, 12)


if __name__ == "__main__":
    unittest.main()
