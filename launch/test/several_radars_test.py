#!/usr/bin/env python3
"""More radars than the two of NRL Report 7952, by parameters alone, and at different sites: several_radars_test.py PATH_OF_TWS_OFFLINE

Whoever adds a radar relies on it: tracks are held better where it sees, and each detection bit means the radar that it always meant.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag
import yaml

SCENARIOS = pathlib.Path(__file__).resolve().parent.parent / "scenarios"
DURATION = 180  # of data time [s]
# Every aircraft counts at every moment, whether a radar sees it then or not.
ALL = {"cutoff_m": 3000.0, "from_s": 60.0, "least_detection_probability": 0.0}


def scenario(name, **changes):
    return {**yaml.safe_load((SCENARIOS / f"{name}.yaml").read_text()), "duration_s": DURATION, **changes}


class SeveralRadars(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_tool(self, *words):
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def fly(self, scene, *options):
        """The bag of a scenario given as a tree."""
        file = self.folder / "scene.yaml"
        file.write_text(yaml.safe_dump(scene))
        self.run_tool(OFFLINE, file, "--out", self.folder, *options)
        return self.folder / "run.bag"

    def score(self, bag, settings):
        config, metrics = self.folder / "evaluation.yaml", self.folder / "metrics.json"
        config.write_text(yaml.safe_dump(settings))
        self.run_tool("rosrun", "track_evaluation", "evaluate_bag", bag, "--quiet", "--json", metrics, "--config", config)
        return json.loads(metrics.read_text())["trackers"]["adit"]["metrics"]

    def updates(self, bag):
        with rosbag.Bag(str(bag)) as opened:
            return [(message.radar, track) for _, message, _ in opened.read_messages(["/adit/tracks"]) for track in message.tracks]

    def test_the_third_radar_holds_fighters_near_the_site_better_than_two_do(self):
        scene = scenario("three_radars")
        scene["random_aircraft"] = scene["random_aircraft"][:1]  # The fighters near the site.
        gains = []
        for seed in (1, 2):
            three = self.score(self.fly(scene, "--seed", seed), ALL)
            two = self.score(self.fly({**scene, "radars": scene["radars"][:2]}, "--seed", seed), ALL)
            gains.append((three["completeness"] - two["completeness"], two["rms_pos_m"] - three["rms_pos_m"]))
        for held, closer in gains:
            self.assertGreater(held, 0.0, gains)
            self.assertGreater(closer, 0.0, gains)

    def test_the_detection_bits_of_the_report_are_the_radars_of_the_report(self):
        bits = {"sps12": 1, "sps39": 2, "sps10": 4, "harbour": 8}
        scene = scenario("three_radars")
        harbour = {"name": "harbour", "type": "generic", "site": "ship", "rotation_period_s": 2.5, "start_azimuth_deg": 300}
        seen = set()
        for radar, track in self.updates(self.fly({**scene, "radars": [harbour] + scene["radars"]})):
            if track.state == track.FIRM and track.stamp == track.last_update:
                self.assertTrue(track.detection_bits & bits[radar], (radar, track.detection_bits))
                seen.add(radar)
            elif track.state == track.COASTING:
                self.assertFalse(track.detection_bits & bits[radar], (radar, track.detection_bits))
        self.assertEqual(seen, set(bits), "a radar takes no part")

    def test_radars_at_two_sites_make_one_track_an_aircraft_and_cover_more_than_either_alone(self):
        scene = scenario("two_sites")
        for seed in (1, 2):
            both, ship, island = (self.score(self.fly({**scene, "radars": radars}, "--seed", seed), ALL)
                                  for radars in (scene["radars"], scene["radars"][:1], scene["radars"][1:]))
            self.assertGreater(both["completeness"], max(ship["completeness"], island["completeness"]) + 0.02)
            self.assertLess(both["ambiguity"], 1.01, "tracks for each aircraft that has one")
            self.assertLess(both["swaps"], 5)


if __name__ == "__main__":
    OFFLINE = sys.argv.pop(1)
    unittest.main()
