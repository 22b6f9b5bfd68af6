#!/usr/bin/env python3
"""The evaluation node on its topics: if this fails, an operator sees no score while a tracker runs."""
import time
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Clock
from tws_msgs.msg import EvaluationSummary, Track, Tracks, Truth, TruthTarget


class EvaluationNodeTest(unittest.TestCase):
    def test_the_summary_is_latched_and_says_how_complete_the_picture_is(self):
        rospy.init_node("evaluation_rostest")
        clock = rospy.Publisher("/clock", Clock, queue_size=100)
        truth = rospy.Publisher("/truth", Truth, queue_size=100)
        tracks = rospy.Publisher("/adit/tracks", Tracks, queue_size=100)
        deadline = time.time() + 20
        while time.time() < deadline and not (truth.get_num_connections() and tracks.get_num_connections() and clock.get_num_connections()):
            time.sleep(0.05)
        for second in range(1, 101):
            now = rospy.Time(second)
            message = Tracks(tracker="adit", radar="a", tracks=[Track(uid=1, state=Track.FIRM, stamp=now, last_update=now)])
            message.header.stamp, message.header.frame_id = now, "map"
            tracks.publish(message)
            message = Truth(targets=[TruthTarget(id=1)])
            message.header.stamp, message.header.frame_id = now, "map"
            truth.publish(message)
            clock.publish(now)
            time.sleep(0.02)
        summary = rospy.wait_for_message("/evaluation/summary", EvaluationSummary, timeout=20)
        metrics = dict(zip(summary.names, summary.values))
        self.assertEqual(summary.tracker, "adit")
        self.assertEqual(metrics["completeness"], 1.0)
        self.assertIn("tracks_latency_p95_s", rospy.wait_for_message("/evaluation/timing", EvaluationSummary, timeout=20).names)


if __name__ == "__main__":
    rostest.rosrun("track_evaluation", "evaluation_rostest", EvaluationNodeTest)
