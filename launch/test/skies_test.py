#!/usr/bin/env python3
"""Scenarios with clutter that has a place and a history fly, and their clutter is no target: skies_test.py PATH_OF_TWS_OFFLINE

If this fails, the scenarios by which trackers are judged in rain, on a coast and at an airport do not run, or hold something else.
"""
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag
from tws_msgs.msg import TruthTarget

SCENARIOS = pathlib.Path(__file__).resolve().parent.parent / "scenarios"
DURATION = 40
# The tracks' topics, the clutter whose outline the truth holds, and where a radar has plots of it: range [m] and azimuth [deg], each with
# half a width.
EXPECTED = {
    "weather": (["/adit/tracks"], {"front", "shower", "drizzle", "duct"}, ("sps39", 33500, 9000, 27, 15)),
    "coast": (["/adit/tracks"], {"sea", "hills", "offshore", "gulls", "jammer"}, ("sps10", 5000, 3000, 290, 20)),
    "airport": (["/adit/tracks", "/ssr/tracks", "/correlated/tracks"], {"town", "shower", "birds"}, ("app", 7000, 5000, 50, 30)),
}


class Skies(unittest.TestCase):
    def fly(self, scenario):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([OFFLINE, str(SCENARIOS / f"{scenario}.yaml"), "--out", folder, "--duration", str(DURATION)],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            with rosbag.Bag(f"{folder}/run.bag") as bag:
                return [(topic, message) for topic, message, _ in bag.read_messages()]

    def test_they_fly_with_plots_where_their_clutter_is(self):
        for scenario, (topics, outlines, (radar, distance, width, azimuth, half)) in EXPECTED.items():
            with self.subTest(scenario):
                messages = self.fly(scenario)
                for topic in topics:
                    self.assertTrue(any(message.tracks for name, message in messages if name == topic), topic)
                targets = [target for name, message in messages if name == "/truth" for target in message.targets]
                clutter = {target.name.split("/")[0] for target in targets if target.kind == TruthTarget.CLUTTER}
                self.assertEqual(clutter, outlines)
                self.assertTrue(any(target.kind == TruthTarget.AIRCRAFT for target in targets))
                plots = [plot for name, message in messages if name == f"/{radar}/detections" for plot in message.detections]
                here = [plot for plot in plots if abs(plot.range - distance) < width
                        and abs((math.degrees(plot.azimuth) - azimuth + 180) % 360 - 180) < half]
                elsewhere = [plot for plot in plots if abs(plot.range - distance) < width
                             and abs((math.degrees(plot.azimuth) - azimuth) % 360 - 180) < half]
                self.assertGreater(len(here), 100)
                self.assertGreater(len(here), 1.3 * len(elsewhere))


if __name__ == "__main__":
    OFFLINE = sys.argv.pop(1)
    unittest.main()
