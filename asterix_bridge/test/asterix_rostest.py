#!/usr/bin/env python3
"""asterix_file_node and asterix_udp_node on their topics: a radar worked by hand, in a file and over UDP."""
import collections
import math
import os
import pathlib
import socket
import struct
import subprocess
import tempfile
import time
import unittest

import rospy
import rosunit
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage
from tws_msgs.msg import Detections, SectorMark, SsrPlots

PERIOD = 4.0            # [s]
TURNS = 8
PLOTS = 20              # a turn
UDP_PORT = 28631        # as in asterix.test
CODE, LEVEL = 0o1234, 350
NAUTICAL_MILE = 1852.0


def block(category, records):
    return struct.pack(">BH", category, len(records) + 3) + records


def time_of_day(seconds):
    return struct.pack(">I", round(seconds * 128))[1:]


def north(seconds):
    """CAT034 with source 8/9, type, time, and the radar's position: 780 m, 45° north, 22.5° east."""
    position = struct.pack(">h", 780) + struct.pack(">i", 0x200000)[1:] + struct.pack(">i", 0x100000)[1:]
    return block(34, b"\xE1\x10" + b"\x08\x09" + b"\x01" + time_of_day(seconds) + position)


def plot(seconds, start):
    """CAT048 with source, time, type SSR, position at 25 NM, Mode 3/A, flight level."""
    turn = (seconds - start) / PERIOD % 1.0
    return block(48, b"\xFC" + b"\x08\x09" + time_of_day(seconds) + b"\x40" + struct.pack(">HH", 6400, round(turn * 65536) % 65536) +
                 struct.pack(">HH", CODE, LEVEL * 4))


def blocks(start):
    """(time, block) of a radar whose beam points north at `start` [s of the day]."""
    for i in range(TURNS * PLOTS):
        seconds = start + i * PERIOD / PLOTS
        if i % PLOTS == 0:
            yield seconds, north(seconds)
        yield seconds, plot(seconds + 1 / 128, start)


class Ear:
    """What is heard of a radar."""

    def __init__(self, radar):
        self.detections, self.plots, self.marks = [], [], []
        self.subscribers = [rospy.Subscriber(f"/{radar}/detections", Detections, self.detections.append),
                            rospy.Subscriber(f"/{radar}/plots", SsrPlots, self.plots.append),
                            rospy.Subscriber(f"/{radar}/sector_marks", SectorMark, self.marks.append)]

    def count(self):
        return sum(len(message.detections) for message in self.detections)

    def wait(self, condition, seconds=30.0):
        end = time.time() + seconds
        while not condition() and time.time() < end:
            time.sleep(0.05)
        time.sleep(0.3)


class AsterixTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("asterix_rostest")
        cls.frames, cls.clocks, cls.counters = {}, [], collections.defaultdict(dict)
        cls.subscribers = [
            rospy.Subscriber("/tf_static", TFMessage, lambda m: cls.frames.update({t.child_frame_id: t for t in m.transforms})),
            rospy.Subscriber("/clock", Clock, cls.clocks.append),
            rospy.Subscriber("/diagnostics", DiagnosticArray, cls.note)]

    @classmethod
    def note(cls, message):
        for status in message.status:
            cls.counters[status.hardware_id].update({value.key: int(value.value) for value in status.values if value.value.isdigit()})

    def check(self, ear, radar, least):
        """Trackers count on sectors in order, their detections before the mark that counts them, and on what is in them."""
        self.assertGreaterEqual(ear.count(), least)
        self.assertEqual([m.running_sector + 1 for m in ear.detections], [m.running_sector for m in ear.marks])
        self.assertEqual([m.running_sector for m in ear.detections], [m.running_sector for m in ear.plots])
        for before, after in zip(ear.marks, ear.marks[1:]):
            self.assertEqual(after.running_sector, before.running_sector + 1)
        for sector, mark in zip(ear.detections, ear.marks):
            self.assertEqual(mark.closed_count, len(sector.detections))
            self.assertEqual(sector.header.frame_id, radar)
            for detection in sector.detections:
                self.assertAlmostEqual(detection.range, 25 * NAUTICAL_MILE, 6)
                off = (detection.azimuth - sector.sector * math.pi / 32 + math.pi) % (2 * math.pi) - math.pi
                self.assertTrue(-0.03 < off < 0.13, off)
        replies = [reply for message in ear.plots for reply in message.plots]
        self.assertEqual({reply.mode_3a for reply in replies}, {CODE})
        self.assertTrue(all(abs(reply.height - LEVEL * 100 * 0.3048) < 1e-6 for reply in replies))

    # If this fails, a recording shows nothing, or aircraft where none were.
    def test_a_recording_is_played_as_sectors(self):
        ear = Ear("radar_8_9")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "one_radar.ast"
            content = b"".join(data for _, data in blocks(86400 - 14.0))  # over midnight
            path.write_bytes(content + b"\x30\x00\x40cut")
            rospy.set_param("/asterix_file", {
                "file": str(path), "date": "2020-02-29",
                "live": {"rate": 4, "wait_for": ["/radar_8_9/sector_marks", "/radar_8_9/detections", "/radar_8_9/plots", "/tf_static"]}})
            done = subprocess.run(["rosrun", "asterix_bridge", "asterix_file_node", "__name:=asterix_file"], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, timeout=60)
            self.assertEqual(done.returncode, 0, done.stdout)
        ear.wait(lambda: ear.count() >= TURNS * PLOTS, 5.0)
        self.check(ear, "radar_8_9", TURNS * PLOTS)
        self.assertEqual(ear.count(), TURNS * PLOTS)
        self.assertIn("byte %d" % len(content), done.stdout)  # what is wrong is said with its place
        first = 18321 * 86400 + 86400 - 14.0  # 29 February 2020
        self.assertAlmostEqual(ear.detections[0].header.stamp.to_sec(), first, delta=PERIOD / 32)
        self.assertAlmostEqual(ear.detections[-1].header.stamp.to_sec(), first + TURNS * PERIOD, delta=PERIOD / 10)
        self.assertIn("radar_8_9", self.frames)

    # If this fails, a live radar shows nothing.
    def test_a_live_feed_comes_as_sectors(self):
        ear = Ear("wire")
        time.sleep(1.0)
        now = time.time() % 86400 - TURNS * PERIOD
        sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        for number, (_, data) in enumerate(blocks(now)):
            sender.sendto(data, ("127.0.0.1", UDP_PORT))
            if number == 50:
                sender.sendto(b"\x30\x00\x09\xFFbroken", ("127.0.0.1", UDP_PORT))
            time.sleep(0.01)
        least = (TURNS - 1) * PLOTS
        ear.wait(lambda: ear.count() >= least)
        self.check(ear, "wire", least)
        ear.wait(lambda: self.counters["asterix_udp"].get("bytes passed over") == 1 and "wire" in self.frames, 5.0)
        self.assertEqual(self.counters["asterix_udp"].get("bytes passed over"), 1)
        self.assertIn("wire", self.frames)
        self.assertTrue(self.clocks)
        newest = ear.marks[-1].header.stamp.to_sec()
        self.assertTrue(newest <= self.clocks[-1].clock.to_sec() < newest + 60.0)

    def test_a_file_that_is_no_asterix_is_refused_in_one_line(self):
        done = subprocess.run(["rosrun", "asterix_bridge", "asterix_file_node", "__name:=asterix_bad",
                               f"_file:={os.path.abspath(__file__)}"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=30)
        self.assertEqual(done.returncode, 1)
        self.assertIn("asterix_rostest.py: this is text, no ASTERIX", done.stdout)


if __name__ == "__main__":
    rosunit.unitrun("asterix_bridge", "asterix_rostest", AsterixTest)
