#!/usr/bin/env python3
"""A tracker of a package of its own, by one row of graph.yaml and one of the node registry: live, where the whole graph runs as nodelets
of one manager, replayed and offline it gives the same tracks; it is recorded, scored and drawn."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import rosbag
import rosunit

from graph_test_kit import check_same, launch_line
from graph_test_kit import message_bytes as tracks

EXAMPLE = pathlib.Path(__file__).parent / "example_tracker"
SCENARIO = "one_aircraft"
DURATION = 60  # of data time [s]
TOPICS = ["/nearest/tracks", "/adit/tracks"]


def command(*words):
    environment = dict(os.environ, ROS_PACKAGE_PATH=f"{EXAMPLE}:{os.environ['ROS_PACKAGE_PATH']}")
    done = subprocess.run([str(word) for word in words], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=150, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def live(file, record, **arguments):
    command(*launch_line(file, record, nodelets="true", graph=f"{EXAMPLE}/graph.yaml", **arguments))
    return record


def messages(bag, topic):
    return [message for _, message, _ in rosbag.Bag(str(bag)).read_messages([topic])]


class ExampleTrackerTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="example_tracker_"))
        cls.live = live("run.launch", cls.folder / "live.bag", scenario=SCENARIO, rate=10, duration=DURATION)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def check_same(self, bag):
        for topic in TOPICS:
            check_same(tracks(self.live, topic), tracks(bag, topic), topic)

    def test_it_follows_the_aircraft_and_is_scored(self):
        firm = {track.uid for message in messages(self.live, "/nearest/tracks") for track in message.tracks if track.state == track.FIRM}
        self.assertTrue(firm)
        scored = {message.tracker for message in messages(self.live, "/evaluation/summary")}
        self.assertEqual(scored, {"adit", "nearest"})

    def test_it_is_drawn(self):
        xml = command("rosrun", "tws_launch", "tws_inspect", "launch", SCENARIO, "rviz:=true", f"graph:={EXAMPLE}/graph.yaml")
        picture = xml.split('name="ppi"')[1].split("</node>")[0]
        self.assertIn("nearest/tracks", picture)

    def test_an_offline_run_gives_the_same_tracks(self):
        scenario = pathlib.Path(__file__).parents[1] / "scenarios" / f"{SCENARIO}.yaml"
        command("rosrun", "tws_launch", "tws_launch_example_offline", scenario, "--graph", EXAMPLE / "graph.yaml",
                "--duration", DURATION, "--out", self.folder / "offline")
        self.check_same(self.folder / "offline" / "run.bag")

    def test_a_replay_gives_the_same_tracks(self):
        self.check_same(live("replay.launch", self.folder / "replay.bag", bag=self.live, rate=10))


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "example_tracker_test", ExampleTrackerTest)
