#!/usr/bin/env python3
"""A run follows from what is in its input, whatever the file is called and wherever its topics stand: content_test.py PATH_OF_TWS_OFFLINE

If this fails, a copied scenario or a moved bag is silently tracked with other parameters, or not at all.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import rosbag

from graph_test_kit import bytes_off_the_map, message_bytes as tracks

SCENARIOS = pathlib.Path(__file__).resolve().parent.parent / "scenarios"
SENSORS = {"detections", "sector_marks", "range_profile", "truth", "tf_static"}


def run(*words):
    return subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120,
                          check=False)


def renamed(source, target, name_of):
    """A copy of the sensors' topics under other names; without the description of the graph."""
    with rosbag.Bag(str(source)) as recorded, rosbag.Bag(str(target), "w") as out:
        for topic, message, time in recorded.read_messages():
            if topic.split("/")[-1] in SENSORS:
                out.write(name_of(topic), message, time)
    return target


def off_the_map(bag):
    with rosbag.Bag(str(bag)) as opened:
        return [bytes_off_the_map(message) for _, message, _ in opened.read_messages(["/adit/tracks"])]


class Content(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.ship = cls.offline(SCENARIOS / "mrs_ship.yaml", "ship", "--duration", 40)
        cls.aircraft = cls.offline(SCENARIOS / "one_aircraft.yaml", "aircraft", "--duration", 60)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def offline(cls, source, name, *options):
        done = run(OFFLINE, source, "--out", cls.folder / name, *options)
        if done.returncode != 0:
            raise AssertionError(done.stderr)
        return cls.folder / name / "run.bag"

    def test_a_scenario_under_another_name_gives_the_same_tracks(self):
        copy = shutil.copy(SCENARIOS / "mrs_ship.yaml", self.folder / "my_ship.yaml")
        self.assertEqual(tracks(self.offline(copy, "my_ship", "--duration", 40), "/mrs/tracks"), tracks(self.ship, "/mrs/tracks"))

    def test_a_bag_under_another_name_is_tracked_with_its_own_parameters(self):
        (self.folder / "elsewhere").mkdir()
        moved = shutil.copy(self.ship, self.folder / "elsewhere" / "any.bag")
        self.assertEqual(tracks(self.offline(moved, "again"), "/mrs/tracks"), tracks(self.ship, "/mrs/tracks"))

    def test_topics_without_a_leading_slash_are_tracked(self):
        bag = renamed(self.aircraft, self.folder / "no_slash.bag", lambda topic: topic.lstrip("/"))
        self.assertEqual(off_the_map(self.offline(bag, "no_slash")), off_the_map(self.aircraft))

    def test_topics_in_a_namespace_are_tracked_there_and_scored(self):
        bag = renamed(self.aircraft, self.folder / "ship1.bag", lambda topic: topic if topic == "/tf_static" else "/ship1" + topic)
        out = self.offline(bag, "ship1")
        # The heartbeat, not the bytes: a tracker's messages say its name, which is another one there.
        self.assertEqual(len(tracks(out, "/ship1/adit/tracks")), len(tracks(self.aircraft, "/adit/tracks")))
        scored = run("rosrun", "track_evaluation", "evaluate_bag", out)
        self.assertEqual(scored.returncode, 0, scored.stderr)
        self.assertRegex(scored.stdout, r"\badit\b")

    def test_a_radar_under_other_topics_is_found_by_the_name_in_its_messages(self):
        bag = renamed(self.aircraft, self.folder / "north.bag",
                      lambda topic: {"/sps12/detections": "/north/video/plots", "/sps12/sector_marks": "/north/marks"}.get(topic, topic))
        self.assertEqual(off_the_map(self.offline(bag, "north")), off_the_map(self.aircraft))

    def test_what_cannot_be_understood_is_refused(self):
        bag = self.folder / "nobodys.bag"
        with rosbag.Bag(str(self.aircraft)) as recorded, rosbag.Bag(str(bag), "w") as out:
            for _, message, time in recorded.read_messages(["/sps12/detections"]):
                message.radar = ""
                out.write("/plots", message, time)
        done = run(OFFLINE, bag, "--out", self.folder / "nobodys")
        self.assertEqual(done.returncode, 1)
        self.assertIn("neither its messages nor its name say of which radar", done.stderr)
        self.assertFalse((self.folder / "nobodys").exists())


if __name__ == "__main__":
    OFFLINE = sys.argv.pop(1)
    unittest.main()
