#!/usr/bin/env python3
"""Nodes as nodelets of one manager (nodelets.test): the tracks of an offline run, byte by byte but for header.seq."""
import pathlib
import subprocess
import tempfile
import time
import unittest
from xml.etree import ElementTree

import rosbag
import rospy
import rosunit
from nodelet.srv import NodeletList, NodeletLoad, NodeletUnload
from rosgraph_msgs.msg import Clock

END = 1120.0  # data time [s]: scenarios begin at 1000 s
# What a class cannot be loaded without.
NEEDED = {
    "adit_tracker/adit_nodelet": {"radars": [{"name": "sps12"}]},
    "asterix_bridge/asterix_file_nodelet": {"file": "$recording"},
    "asterix_bridge/asterix_udp_nodelet": {"udp": "127.0.0.1:47917"},
    "radar_sim/radar_sim_nodelet": {"scenario": "$scenario", "live": {"wait_for": ["/nobody"]}},
    "range_gate_tracker/window_tracker_nodelet": {"radar": "sps12"},
}


def scenario():
    return str(pathlib.Path(__file__).parents[1] / "scenarios" / "one_aircraft.yaml")


def north_message(seconds):
    """ASTERIX CAT034 of the radar 8/9: its beam points north at this time of the day [s]; the radar's position."""
    return bytes.fromhex("220013" "E110" "0809" "01") + (128 * seconds).to_bytes(3, "big") + bytes.fromhex("030C" "200000" "100000")


def offline(folder):
    command = ["rosrun", "tws_launch", "tws_offline", scenario(), "--out", str(folder)]
    subprocess.run(command, check=True, timeout=100, stdout=subprocess.DEVNULL)
    return [raw[1][4:] for _, raw, _ in rosbag.Bag(str(folder / "run.bag")).read_messages(["/adit/tracks"], raw=True)]


def classes():
    """Of all packages of this repository: PACKAGE/NODElet."""
    ours = printed("rospack", "depends-on1", "tws_runtime")
    plugins = [line.split() for line in printed("rospack", "plugins", "--attrib=plugin", "nodelet")]
    files = [file for package, file in plugins if package in ours]
    return sorted(entry.get("name") for file in files for entry in ElementTree.parse(file).iter("class"))


def printed(*command):
    return subprocess.run(command, check=True, timeout=60, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def wait_for(condition, seconds=60.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


class NodeletsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("nodelets_test")
        cls.tracks, cls.clock = [], [0.0]
        live = rospy.Subscriber("/adit/tracks", rospy.AnyMsg, lambda message: cls.tracks.append(message._buff[4:]))
        rospy.Subscriber("/clock", Clock, lambda message: cls.clock.append(message.clock.to_sec()))
        cls.tracked = wait_for(lambda: live.get_num_connections() > 0)
        rospy.Subscriber("/sps12/detections", rospy.AnyMsg, lambda message: None)  # The simulator waits for this one.
        wait_for(lambda: cls.clock[-1] >= END - 1.0)

    def test_nodelets_give_the_tracks_of_an_offline_run(self):
        self.assertTrue(self.tracked)
        with tempfile.TemporaryDirectory() as folder:
            expected = offline(pathlib.Path(folder))
        self.assertTrue(wait_for(lambda: len(self.tracks) >= len(expected) - 10))
        length = min(len(self.tracks), len(expected))
        different = [i for i in range(length) if self.tracks[i] != expected[i]]
        self.assertFalse(different, f"{len(different)} of {length} messages differ, the first is number {different[:1]}")

    def test_a_wrong_parameter_keeps_only_its_own_nodelet_from_loading(self):
        nodelets = rospy.ServiceProxy("/manager/list", NodeletList)().nodelets
        self.assertEqual(sorted(nodelets), ["/adit", "/ppi", "/radar_sim"])

    def test_every_class_can_be_loaded_and_unloaded(self):
        load = rospy.ServiceProxy("/manager/load_nodelet", NodeletLoad)
        unload = rospy.ServiceProxy("/manager/unload_nodelet", NodeletUnload)
        with tempfile.NamedTemporaryFile() as recording:
            recording.write(b"".join(north_message(36000 + 4 * turn) for turn in range(4)))
            recording.flush()
            self.assertGreaterEqual(len(classes()), 14)
            for number, name in enumerate(classes()):
                for key, value in NEEDED.get(name, {}).items():
                    known = {"$scenario": scenario(), "$recording": recording.name}
                    rospy.set_param(f"/loaded{number}/{key}", known.get(value, value) if isinstance(value, str) else value)
                with self.subTest(name):
                    self.assertTrue(load(name=f"/loaded{number}", type=name).success)
                    self.assertTrue(unload(name=f"/loaded{number}").success)


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "nodelets_test", NodeletsTest)
