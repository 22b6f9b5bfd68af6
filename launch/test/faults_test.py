#!/usr/bin/env python3
"""The live ADIT tracker when something breaks: it is killed, it is held up, a radar falls silent."""
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rosunit
from diagnostic_msgs.msg import DiagnosticArray
from tws_msgs.msg import Track, TrackerStatus, Tracks

OUTAGE = """
duration_s: 110
radars:
  - {name: sps12, type: SPS-12, false_alarms_per_scan: 0}
  - {name: sps39, type: SPS-39, start_azimuth_deg: 90, false_alarms_per_scan: 0}
targets:
  - {name: alpha, range_m: 60000, azimuth_deg: 45, height_m: 6000, course_deg: 250, speed_mps: 220, detection_probability: 0.95}
faults:
  - {type: outage, radar: sps12, from_s: 45, to_s: 75}
"""


class Run:
    """A live run, and the messages of the tracker meanwhile."""

    def __init__(self, scenario, rate, duration, *arguments):
        self.tracks, self.statuses, self.said = [], [], set()
        self.subscribers = [rospy.Subscriber("/adit/tracks", Tracks, self.tracks.append),
                            rospy.Subscriber("/adit/status", TrackerStatus, self.statuses.append),
                            rospy.Subscriber("/diagnostics", DiagnosticArray, self.hear)]
        self.process = subprocess.Popen(["roslaunch", "--no-summary", "tws_launch", "run.launch", "rviz:=false", f"scenario:={scenario}",
                                         f"rate:={rate}", f"duration:={duration}", *arguments],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def hear(self, message):
        self.said.update(s.message for s in message.status if s.name == "adit: tracker")
        self.said.update(f"{v.key}: {v.value}" for s in message.status if s.name == "adit: counters" for v in s.values)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for subscriber in self.subscribers:
            subscriber.unregister()
        self.process.terminate()
        self.process.wait()

    def wait(self, what, seconds=60):
        end = time.time() + seconds
        while not what():
            if time.time() > end:
                raise AssertionError("waited in vain")
            time.sleep(0.01)

    def data_time(self):
        return self.tracks[-1].header.stamp.to_sec() - self.tracks[0].header.stamp.to_sec() if self.tracks else 0.0

    def tracker(self):
        """The tracker's process."""
        uri = rosgraph.Master("/faults_test").lookupNode("/adit")
        return xmlrpc.client.ServerProxy(uri).getPid("/faults_test")[2]


def first_time(messages, state, share=1):
    """When so many tracks had this state, after the first of the messages [s]."""
    seen = set()
    for message in messages:
        seen.update(track.uid for track in message.tracks if track.state == state)
        if len(seen) >= share:
            return (message.header.stamp - messages[0].header.stamp).to_sec()
    return float("inf")


class FaultsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("faults_test", disable_rostime=True)

    def test_a_tracker_that_is_killed_and_respawned_has_tracks_like_after_a_start(self):
        with Run("adit_nominal", 3, 100, "respawn:=true") as run:
            run.wait(lambda: run.data_time() > 40)
            os.kill(run.tracker(), signal.SIGKILL)
            killed = len(run.tracks)
            run.wait(lambda: run.data_time() > 88)
            messages = list(run.tracks)
        reborn = [i for i in range(killed - 5, len(messages)) if messages[i].sequence == 0]
        self.assertEqual(len(reborn), 1, "the tracker did not come again")
        start, again = messages[:reborn[0]], messages[reborn[0]:]
        self.assertLess(first_time(again, Track.TENTATIVE), 16.0, "two scans of the slower radar")
        # Ten firm tracks: one scan of the slower radar more, for the beam may be anywhere.
        self.assertLess(first_time(again, Track.FIRM, 10), first_time(start, Track.FIRM, 10) + 8.0)

    # A tracker that stood still works off in an instant what its sockets kept for it; it skips only what it cannot. (The tracker's
    # own tests show the skipping.)
    def test_a_tracker_that_is_held_up_catches_up_and_keeps_its_tracks(self):
        with Run("one_aircraft", 1, 45) as run:
            run.wait(lambda: any(t.state == t.FIRM for m in run.tracks for t in m.tracks) and run.data_time() > 26)
            before = {t.uid for m in run.tracks[-300:] for t in m.tracks if t.state == t.FIRM}
            tracker = run.tracker()
            os.kill(tracker, signal.SIGSTOP)
            time.sleep(4)
            held = run.data_time()
            os.kill(tracker, signal.SIGCONT)
            sectors = len(run.tracks)
            run.wait(lambda: run.data_time() > held + 8)
            messages = list(run.tracks)
            run.wait(lambda: run.statuses and run.statuses[-1].header.stamp > messages[sectors].header.stamp)
        self.assertEqual([m.sequence for m in messages], list(range(messages[0].sequence, messages[0].sequence + len(messages))))
        after = {t.uid for m in messages[sectors:] for t in m.tracks if t.state == t.FIRM}
        self.assertTrue(before, "no firm track to be kept")
        self.assertTrue(before & after, "the aircraft's track is lost")
        self.assertGreater(messages[-1].header.stamp.to_sec() - messages[sectors].header.stamp.to_sec(), 4.0, "it does not catch up")

    def test_a_dead_radar_is_said_to_be_silent_and_resumes(self):
        with tempfile.TemporaryDirectory() as folder:
            scenario = pathlib.Path(folder) / "outage.yaml"
            scenario.write_text(OUTAGE)
            with Run(str(scenario), 10, 110) as run:
                run.wait(lambda: run.data_time() > 104)
                messages, statuses, said = list(run.tracks), list(run.statuses), set(run.said)
        begin = messages[0].header.stamp.to_sec()
        firm = [(m.header.stamp.to_sec() - begin, m.radar, t.uid) for m in messages for t in m.tracks if t.state == t.FIRM]
        before = {uid for when, _, uid in firm if when < 45}
        self.assertEqual(len(before), 1)
        self.assertEqual({uid for _, _, uid in firm}, before, "the outage costs the track")
        self.assertFalse([when for when, radar, _ in firm if radar == "sps12" and 46 < when < 74])
        self.assertTrue([when for when, radar, _ in firm if radar == "sps12" and when > 76], "the radar does not resume")
        self.assertIn("sps12 is silent", said)
        self.assertTrue(any(s.stale[0] for s in statuses))
        self.assertFalse(statuses[-1].stale[0])


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "faults_test", FaultsTest)
