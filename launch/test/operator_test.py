#!/usr/bin/env python3
"""What an operator asks of the window tracker in a live run is repeated by every replay of its recording, byte by byte but for
header.seq."""
import pathlib
import tempfile
import time
import unittest

import rosbag
import rospy
import rosunit
from geometry_msgs.msg import PointStamped
from tws_msgs.msg import OperatorRequest, Tracks
from tws_msgs.srv import DropTrack
from graph_test_kit import check_same
from whole_graph_test import command, late, launch, launch_beside, offline, tracks

DURATION = 30  # of data time [s]


class Operator:
    """Sets the designation marker after two turns and cancels a track after three."""

    def __init__(self):
        self.point = rospy.Publisher("/clicked_point", PointStamped, queue_size=10)
        self.first, self.flown, self.number = None, 0.0, None
        rospy.Subscriber("/tws/tracks", Tracks, self.hear)

    def hear(self, message):
        self.first = self.first or message.header.stamp
        self.flown = (message.header.stamp - self.first).to_sec()
        for track in message.tracks:
            if track.state != track.DROPPED:
                self.number = track.number

    def work(self):
        self.wait_for(lambda: self.flown > 12.0 and self.point.get_num_connections() > 0)
        for x, y in ((30e3, 40e3), (-60e3, 10e3)):
            marker = PointStamped()
            marker.header.frame_id = "map"
            marker.point.x, marker.point.y = x, y
            self.point.publish(marker)
        self.wait_for(lambda: self.flown > 18.0)
        return rospy.ServiceProxy("/tws/drop_track", DropTrack)([self.number])

    @staticmethod
    def wait_for(condition):
        end = time.time() + 60.0
        while not condition() and time.time() < end:
            time.sleep(0.01)


class OperatorTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("operator_test")
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="operator_"))
        cls.live = cls.folder / "live.bag"
        cls.answer = launch_beside(lambda: Operator().work(), cls.live, rate=5, scenario="full", duration=DURATION)

    @classmethod
    def tearDownClass(cls):
        command("rm", "-rf", cls.folder)

    def check_same(self, bag, run):
        self.assertEqual(late(bag), {}, f"{run}: this machine was too slow for the comparison")
        for topic in ("/tws/tracks", "/tws/windows"):
            check_same(tracks(self.live, topic), tracks(bag, topic), f"{run}, {topic}", least=250)
        self.assertEqual(len(tracks(bag, "/window_tracker/operator_requests")), 3, run)

    def test_the_requests_take_effect(self):
        self.assertTrue(self.answer.success, self.answer.message)
        with rosbag.Bag(str(self.live)) as bag:
            requests = [m for _, m, _ in bag.read_messages(["/window_tracker/operator_requests"])]
            designated = {w.uid for _, m, _ in bag.read_messages(["/tws/windows"]) for w in m.windows if w.designated}
            dropped = {t.number for _, m, _ in bag.read_messages(["/tws/tracks"]) for t in m.tracks if t.state == t.DROPPED}
        self.assertEqual([r.request for r in requests], [OperatorRequest.INITIATE] * 2 + [OperatorRequest.DROP])
        self.assertEqual(len(designated), 2)
        self.assertIn(requests[2].track, dropped)

    def test_an_offline_run_of_the_bag_repeats_them(self):
        self.check_same(offline(self.live, self.folder / "offline"), "offline")

    def test_a_replay_repeats_them(self):
        self.check_same(launch("replay.launch", self.folder / "replay.bag", bag=self.live, rate=5), "replay")


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "operator_test", OperatorTest)
