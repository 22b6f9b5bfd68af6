#!/usr/bin/env python3
"""Elevation searches through the whole graph: an operator designates tracks, the SPS-39 searches for them, and they get heights that agree
with the truth. A live run, its replay and offline runs give the same, byte by byte but for header.seq."""
import math
import pathlib
import tempfile
import unittest

import rosbag
import rospy
import rosunit
import yaml
from tws_msgs.msg import ElevationRequests, OperatorRequest

from adit_operator_test import Operator
from graph_test_kit import check_same
from whole_graph_test import command, late, launch, launch_beside, offline, tracks

DURATION = 115  # of data time [s]
DESIGNATED = 11
EARTH = 6371e3  # [m]
END = 100  # Messages at the end of a live run that may be missing: five seconds of data time, half a second of a busy machine.
ANTENNA = 25.0  # of the first radar, from which heights are told [m]
TOPICS = ["/adit/tracks", "/sps39/elevation_requests", "/sps39/detections"]


def messages(bag, topic):
    with rosbag.Bag(str(bag)) as opened:
        return [message for _, message, _ in opened.read_messages([topic])]


def altitude(position):
    return math.sqrt(position.x ** 2 + position.y ** 2 + (position.z + EARTH) ** 2) - EARTH


class Truth:
    def __init__(self, bag):
        self.messages = {round(m.header.stamp.to_sec()): m for m in messages(bag, "/truth")}

    def height_of(self, update):
        """Of the aircraft where the track is; none: it is on nobody's tail, or two aircraft are near it."""
        picture = self.messages.get(round(update.stamp.to_sec()))
        near = [t for t in picture.targets if abs(t.slant_range[1] - update.range) < 1500 and
                update.range * abs(math.remainder(t.azimuth[1] - update.azimuth, 2 * math.pi)) < 2000] if picture else []
        return altitude(near[0].position) if len(near) == 1 else None


class Designator(Operator):
    def work(self):
        self.wait(40)
        rospy.wait_for_message("/sps39/elevation_requests", ElevationRequests, 60)  # A scan's time until the next one.
        firm = [t.number for t in self.ask(OperatorRequest.LIST_ALL).tracks][:DESIGNATED]
        for number in firm:
            self.ask(OperatorRequest.DESIGNATE, number)
        return firm


class ElevationTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("elevation_test", disable_rostime=True)
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="elevation_"))
        cls.live = cls.folder / "live.bag"
        cls.designated = launch_beside(lambda: Designator().work(), cls.live, rate=8, scenario="elevation_search", duration=DURATION)
        cls.lists = messages(cls.live, "/sps39/elevation_requests")
        cls.updates = [update for m in messages(cls.live, "/adit/tracks") for update in m.tracks]

    @classmethod
    def tearDownClass(cls):
        command("rm", "-rf", cls.folder)

    def test_each_scan_has_its_list_in_order_of_azimuth(self):
        self.assertEqual(len(self.designated), DESIGNATED)
        self.assertGreater(len(self.lists), 12)
        for before, after in zip(self.lists, self.lists[1:]):
            self.assertAlmostEqual((after.header.stamp - before.header.stamp).to_sec(), 8.0, delta=0.02)
        for m in self.lists:
            self.assertLessEqual(len(m.requests), 8)
            self.assertEqual([r.azimuth for r in m.requests], sorted(r.azimuth for r in m.requests))

    def test_the_new_ones_come_first_four_a_scan_and_then_each_on_every_fourth_scan(self):
        scans = {number: [i for i, m in enumerate(self.lists) if number in [r.track for r in m.requests]] for number in self.designated}
        first = min(on[0] for on in scans.values() if on)
        begun = [sum(on[:1] == [first + i] for on in scans.values()) for i in range(4)]
        self.assertIn(4, begun, scans)
        self.assertEqual((max(begun), sum(begun)), (4, DESIGNATED), scans)
        for on in scans.values():
            self.assertEqual({b - a for a, b in zip(on, on[1:])} - {4}, set(), scans)
        self.assertGreaterEqual(sum(len(on) > 1 for on in scans.values()), DESIGNATED - 2, scans)

    def test_designated_tracks_get_heights_that_agree_with_the_truth(self):
        truth = Truth(self.live)
        known = [w for w in self.updates if not math.isnan(w.height)]
        self.assertLessEqual({w.number for w in known}, set(self.designated))
        self.assertGreaterEqual(len({w.uid for w in known}), DESIGNATED - 2)
        deviations = [abs(w.height - height) / w.height_sigma for w in known for height in [truth.height_of(w)] if height is not None]
        self.assertGreater(len(deviations), 100)
        # Normal errors stay within 3 sigma for 99.7 %; the updates between two searches share one error.
        self.assertGreater(sum(d < 3.0 for d in deviations) / len(deviations), 0.95)
        self.assertLess(max(deviations), 6.0)

    def test_a_track_with_height_stands_over_the_ground(self):
        self.assertTrue(any(not math.isnan(update.height) for update in self.updates))
        for update in self.updates:
            self.assertEqual(math.isnan(update.position.z), math.isnan(update.height))
            if not math.isnan(update.height):
                ground = math.hypot(update.position.x, update.position.y)
                self.assertLess(ground, update.range)
                self.assertAlmostEqual(math.sqrt(ground ** 2 + (update.position.z - ANTENNA) ** 2), update.range, delta=0.1)

    def check_runs(self, first, second, topics):
        for bag in (first, second):
            self.assertEqual(late(bag), {}, "this machine was too slow for the comparison")
        for topic in topics:
            check_same(tracks(first, topic), tracks(second, topic), topic, least=6, apart=END)

    def test_an_offline_run_and_a_replay_of_the_bag_give_the_same(self):
        self.check_runs(self.live, offline(self.live, self.folder / "offline"), TOPICS[:2])
        self.check_runs(self.live, launch("replay.launch", self.folder / "replay.bag", rate=12, bag=self.live), TOPICS[:2])

    def test_the_closed_loop_gives_the_same_live_and_offline_and_never_more_than_eight_a_scan(self):
        """All of 45 aircraft are designated as soon as they are firm: more than can be searched for on four scans."""
        package = pathlib.Path(command("rospack", "find", "tws_launch").strip())
        scene = yaml.safe_load((package / "scenarios/elevation_search.yaml").read_text())
        scene["random_aircraft"][0]["count"] = 42
        parameters = yaml.safe_load((pathlib.Path(command("rospack", "find", "adit_tracker").strip()) / "config/default.yaml").read_text())
        parameters["elevation"]["automatic"] = True
        file, params, live = (self.folder / name for name in ("many.yaml", "automatic.yaml", "many.bag"))
        file.write_text(yaml.safe_dump({**scene, "duration_s": 90}))
        params.write_text(yaml.safe_dump(parameters))
        launch("run.launch", live, rate=10, scenario=file, duration=90, params=params)
        self.check_runs(live, offline(file, self.folder / "many", "--params", params), TOPICS)
        lists = [len(m.requests) for m in messages(live, "/sps39/elevation_requests")]
        self.assertEqual(max(lists), 8)
        self.assertGreater(lists.count(8), 2)
        found = sum(not math.isnan(d.elevation) for m in messages(live, "/sps39/detections") for d in m.detections)
        self.assertGreater(found, 0.5 * sum(lists))


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "elevation_test", ElevationTest)
