#!/usr/bin/env python3
"""What a user is told of a slip in the command line: command_line_test.py PATH_OF_TWS_OFFLINE PATH_OF_TWS_INSPECT PATH_OF_TWS"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
from tws_msgs.msg import Detections

TWS, INSPECT, OFFLINE = sys.argv.pop(), sys.argv.pop(), sys.argv.pop()


def run(*words):
    return subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.bag, self.scenario = self.folder / "run.bag", self.folder / "one.yaml"
        self.scenario.write_text("radars: [{name: a}]\n")
        with rosbag.Bag(str(self.bag), "w") as bag:
            for time in (100, 160):
                bag.write("/a/detections", Detections(radar="a"), rospy.Time(time))

    def refused(self, status, reason, *words):
        """In one line, which a person can read, and without a word into a file."""
        done = run(*words)
        self.assertEqual(done.returncode, status, done)
        self.assertIn(reason, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertNotIn("e+", done.stderr)
        self.assertEqual(sorted(file.name for file in self.folder.iterdir()), ["one.yaml", "run.bag"])

    # If this fails, a run that was to be short or other than the last one is silently neither.
    def test_what_does_not_apply_is_refused(self):
        for duration in ("0.5", "-3", "1000001", "soon"):
            for words in ([TWS, "run", self.scenario], [TWS, "run", self.bag], [TWS, "replay", self.bag],
                          [TWS, "offline", self.scenario], [OFFLINE, self.scenario, "--out", self.folder / "out"],
                          [INSPECT, self.scenario]):
                self.refused(2, "--duration", *words, "--duration", duration)
        for words in ([TWS, "run"], [TWS, "offline"], [OFFLINE]):
            self.refused(2, "a bag has no random numbers", *words, self.bag, "--seed", "3")
            self.refused(2, "--seed", *words, self.scenario, "--seed", "-3")
        for rate in ("0", "-1", "fast"):
            self.refused(2, "--rate", TWS, "run", self.scenario, "--rate", rate)
        self.refused(2, "unknown option --speed", TWS, "run", "--speed", "3")
        self.refused(2, "no file or scenario 'nothing'", TWS, "run", "nothing")

    def test_a_wrong_scenario_is_named_with_its_line(self):
        self.scenario.write_text("radars:\n  - {name: a, typ: SPS-12}\n")
        for words in ([INSPECT, self.scenario], [OFFLINE, self.scenario, "--out", self.folder / "out"]):
            self.refused(1, f"{self.scenario}:2:", *words)

    # If this fails, a replay ends by writing over the bag that it has just played.
    def test_a_bag_is_not_recorded_over_itself(self):
        self.refused(1, f"{self.bag}: is the input itself", INSPECT, "launch", self.bag, f"record:={self.bag}")
        self.refused(1, "name another folder by --out", INSPECT, "plan", "replay", self.bag, "--out", self.folder)
        self.refused(1, "no regular file", INSPECT, "launch", self.bag, "record:=/dev/null")

    # If this fails, the progress of a shortened run ends at some odd per cent.
    def test_the_length_of_a_run_is_what_will_be_run(self):
        for words, length in (([self.scenario], 300), ([self.scenario, "--duration", "400"], 400), ([self.bag], 60),
                              ([self.bag, "--duration", "20"], 20), ([self.bag, "--duration", "400"], 60)):
            self.assertEqual(run(INSPECT, *words).stdout.splitlines()[0], f"length: {length}")

    def test_help_names_scenarios_places_and_defaults(self):
        said = run(TWS, "help").stdout
        for word in ("adit_nominal", "out/", "10 without", "--seed"):
            self.assertIn(word, said)


if __name__ == "__main__":
    unittest.main()
