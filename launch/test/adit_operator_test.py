#!/usr/bin/env python3
"""What an operator does in a live run is in its bag, and a replay and an offline run of the bag repeat it, byte by byte but for
header.seq."""
import math
import pathlib
import tempfile
import time
import unittest

import rosbag
import rospy
import rosunit
from tws_msgs.msg import OperatorRequest, Tracks
from tws_msgs.srv import DropTrack, InitiateTrack, InitiateTrackRequest, OperatorCommand, OperatorCommandRequest

from graph_test_kit import check_same
from whole_graph_test import command, late, launch, launch_beside, offline, tracks

DURATION = 60  # of data time [s]
NAN = float("nan")


class Operator:
    """Works while the run goes on: lists, hands over, designates, drops and starts tracks."""

    def __init__(self):
        self.began = self.now = None
        rospy.Subscriber("/adit/tracks", Tracks, self.hear)

    def hear(self, message):
        self.now = message.header.stamp.to_sec()
        self.began = self.began or self.now

    def wait(self, data_time):
        end = time.time() + 60
        while self.now is None or self.now < self.began + data_time:
            if time.time() > end:
                raise AssertionError("the run does not go on")
            time.sleep(0.01)

    def ask(self, request, track=0, start=NAN, end=NAN):
        """Asks again when the tracker is busy, as an operator does."""
        service = rospy.ServiceProxy("/adit/operator_command", OperatorCommand)
        for _ in range(50):
            answer = service(OperatorCommandRequest(request=request, track=track, lower=start, upper=end))
            if answer.result != answer.BUSY:
                return answer
            time.sleep(0.02)
        raise AssertionError("always busy")

    def work(self):
        self.wait(30)
        targets = self.ask(OperatorRequest.LIST_ALL).tracks
        self.ask(OperatorRequest.HANDOFF, targets[0].number)
        self.ask(OperatorRequest.DESIGNATE, targets[1].number)
        self.wait(36)
        dropped = rospy.ServiceProxy("/adit/drop_track", DropTrack)([targets[2].number])
        point = InitiateTrackRequest()
        point.point.header.frame_id = "map"
        point.point.point.x, point.point.point.y = -7e4, 3e4
        started = rospy.ServiceProxy("/adit/initiate_track", InitiateTrack)(point)
        self.wait(42)
        inside = self.ask(OperatorRequest.LIST_RANGE, end=80e3).tracks
        return {"targets": targets, "dropped": dropped, "started": started, "inside": inside}


class OperatorTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("adit_operator_test", disable_rostime=True)
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="operator_"))
        cls.live = cls.folder / "live.bag"
        cls.done = launch_beside(lambda: Operator().work(), cls.live, rate=5, scenario="adit_nominal", duration=DURATION)

    @classmethod
    def tearDownClass(cls):
        command("rm", "-rf", cls.folder)

    def messages(self, bag, topic):
        with rosbag.Bag(str(bag)) as opened:
            return [message for _, message, _ in opened.read_messages([topic])]

    def test_the_orders_show_in_the_tracks(self):
        targets = self.done["targets"]
        self.assertGreater(len(targets), 10)
        updates = [track for message in self.messages(self.live, "/adit/tracks") for track in message.tracks]
        last = {track.uid: track for track in updates}
        self.assertTrue(last[targets[0].uid].detection_bits & targets[0].HANDED_OFF)
        self.assertTrue(last[targets[1].uid].detection_bits & targets[0].ELEVATION_REQUESTED)
        self.assertTrue(self.done["dropped"].success, self.done["dropped"].message)
        self.assertEqual(last[targets[2].uid].state, targets[2].DROPPED)
        self.assertTrue(self.done["started"].success, self.done["started"].message)
        self.assertTrue(any(w.number == self.done["started"].number and math.hypot(w.position.x + 7e4, w.position.y - 3e4) < 100
                            for w in updates))
        self.assertTrue(self.done["inside"])
        self.assertTrue(all(track.range <= 80e3 for track in self.done["inside"]))

    def test_the_bag_holds_each_request_and_its_effect(self):
        requests = [m for m in self.messages(self.live, "/adit/operator_requests") if m.result != m.BUSY]
        asked = OperatorRequest
        self.assertEqual([m.request for m in requests],
                         [asked.LIST_ALL, asked.HANDOFF, asked.DESIGNATE, asked.DROP, asked.INITIATE, asked.LIST_RANGE])
        self.assertEqual(list(requests[0].tracks), [t.number for t in self.done["targets"]])
        self.assertEqual(list(requests[3].tracks), [self.done["targets"][2].number])

    def check_same(self, bag):
        self.assertEqual(late(self.live), {}, "this machine was too slow for the comparison")
        self.assertEqual(late(bag), {}, "this machine was too slow for the comparison")
        check_same(tracks(self.live), tracks(bag))
        asked = [[(m.request, m.running_sector, m.result, m.tracks)
                  for m in self.messages(b, "/adit/operator_requests") if m.result != m.BUSY]
                 for b in (self.live, bag)]
        self.assertEqual(asked[0], asked[1])

    def test_a_replay_repeats_what_the_operator_did(self):
        self.check_same(launch("replay.launch", self.folder / "replay.bag", rate=5, bag=self.live))

    def test_an_offline_run_of_the_bag_repeats_what_the_operator_did(self):
        self.check_same(offline(self.live, self.folder / "offline"))

    def test_a_replay_of_the_replay_does_so_too(self):
        first = offline(self.live, self.folder / "first")
        self.check_same(offline(first, self.folder / "second"))


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "adit_operator_test", OperatorTest)
