#!/usr/bin/env python3
"""The window tracker on its topics: if this fails, an operator's marker or cancellation does nothing, or tracks neither start nor end."""
import math
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PointStamped, TransformStamped
from tf2_msgs.msg import TFMessage
from tws_msgs.msg import Detection, Detections, OperatorRequest, SectorMark, Track, Tracks
from tws_msgs.srv import DropTrack

SECTORS, PERIOD, START = 64, 6.4, 1000.0
NAN = float("nan")


def aircraft(t):
    """Where the target is [m], east and north of the radar."""
    return 20e3 - 150.0 * (t - START), 30e3 + 100.0 * (t - START)


class Scene:
    """The radar "test"; it sees the aircraft in the turns that `sees` names."""

    def __init__(self):
        self.detections = rospy.Publisher("/test/detections", Detections, queue_size=0)
        self.marks = rospy.Publisher("/test/sector_marks", SectorMark, queue_size=0)
        self.point = rospy.Publisher("/clicked_point", PointStamped, queue_size=10)
        self.sites = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        self.received, self.requests, self.next, self.plots = [], [], 0, 0
        rospy.Subscriber("/tws/tracks", Tracks, self.received.append)
        rospy.Subscriber("/window_tracker/operator_requests", OperatorRequest, self.requests.append)
        site = TransformStamped()
        site.header.frame_id, site.child_frame_id, site.transform.rotation.w = "map", "test", 1.0
        self.sites.publish(TFMessage([site]))

    def wait(self, condition, what):
        end = time.time() + 30.0
        while not condition():
            if time.time() > end:
                raise AssertionError(f"still waiting for {what}")
            time.sleep(0.005)

    def sector(self, seen):
        n, width = self.next, PERIOD / SECTORS
        enter, leave = START + n * width, START + (n + 1) * width
        message = Detections(radar="test", sector=n % SECTORS, running_sector=n)
        message.header.frame_id, message.header.stamp = "test", rospy.Time(leave)
        x, y = aircraft(enter)
        azimuth = math.atan2(x, y) % (2 * math.pi)
        if seen and int(azimuth / (2 * math.pi) * SECTORS) == n % SECTORS:
            message.detections.append(Detection(stamp=rospy.Time(enter), range=math.hypot(x, y), azimuth=azimuth, elevation=NAN,
                                                range_rate=NAN, range_sigma=100.0, azimuth_sigma=0.005, snr=NAN))
        self.plots += len(message.detections)
        mark = SectorMark(radar="test", sector=(n + 1) % SECTORS, running_sector=n + 1, closed_sector=n % SECTORS,
                          closed_count=len(message.detections), running_count=self.plots, rotation_period=PERIOD)
        mark.header = message.header
        self.detections.publish(message)
        self.marks.publish(mark)
        self.next += 1

    def turn(self, seen=True):
        """One turn; ends when the node has answered all of it but for the latest sectors."""
        for _ in range(SECTORS):
            self.sector(seen)
            self.wait(lambda: self.received and self.received[-1].running_sector >= self.next - 4 or self.next < 8, "an answer")

    def tracks(self):
        """The latest update of each living track."""
        last = {}
        for message in list(self.received):
            for track in message.tracks:
                last[track.uid] = track
        return {uid: track for uid, track in last.items() if track.state != Track.DROPPED}


class WindowTrackerTest(unittest.TestCase):
    def test_tracks_start_by_themselves_and_by_the_marker_and_end_by_the_operator_and_by_missed_scans(self):
        rospy.init_node("window_tracker_rostest")
        scene = Scene()
        scene.wait(lambda: scene.detections.get_num_connections() and scene.marks.get_num_connections() and
                   scene.point.get_num_connections(), "the node")

        for _ in range(7):  # an automatic start
            scene.turn()
        self.assertEqual([t.state for t in scene.tracks().values()], [Track.FIRM])
        first = next(iter(scene.tracks().values()))
        x, y = aircraft(first.stamp.to_sec())
        self.assertLess(math.hypot(first.position.x - x, first.position.y - y), 100.0)

        answer = rospy.ServiceProxy("/tws/drop_track", DropTrack)([first.number, 12345])  # the operator cancels it
        self.assertFalse(answer.success)
        self.assertIn("12345", answer.message)
        scene.turn(seen=False)
        self.assertEqual(scene.tracks(), {})

        marker = PointStamped()  # the designation marker, half a kilometre beside the aircraft
        marker.header.frame_id = "map"
        marker.point.x, marker.point.y = (c + 350.0 for c in aircraft(START + scene.next * PERIOD / SECTORS))
        scene.point.publish(marker)
        scene.wait(lambda: len(scene.requests) == 3, "the request")
        self.assertEqual([(r.request, r.result) for r in scene.requests],
                         [(OperatorRequest.DROP, OperatorRequest.OK), (OperatorRequest.DROP, OperatorRequest.REFUSED),
                          (OperatorRequest.INITIATE, OperatorRequest.OK)])
        for _ in range(7):
            scene.turn()
        self.assertEqual([t.state for t in scene.tracks().values()], [Track.FIRM])
        self.assertNotIn(first.uid, scene.tracks())

        scene.turn(seen=False)  # missed scans: it coasts, and ends
        self.assertEqual([t.state for t in scene.tracks().values()], [Track.COASTING])
        for _ in range(5):
            scene.turn(seen=False)
        self.assertEqual(scene.tracks(), {})


if __name__ == "__main__":
    rostest.rosrun("range_gate_tracker", "window_tracker_rostest", WindowTrackerTest)
