#!/usr/bin/env python3
"""A user's own launch file (own_graph.test): nodelets and programs, under two namespaces, give the tracks of an offline run."""
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
from tws_msgs.msg import Tracks

from graph_test_kit import bytes_off_the_map, check_same

TRACKERS = ["/inside/adit", "/outside/adit", "/outside/second", "/remapped/adit", "/remapped/told"]
SCENARIO = pathlib.Path(__file__).parents[1] / "scenarios" / "one_aircraft.yaml"
# What a class cannot be loaded without.
NEEDED = {
    "adit_tracker/adit_nodelet": {"radars": [{"name": "sps12"}]},
    "asterix_bridge/asterix_file_nodelet": {"file": "$recording"},
    "asterix_bridge/asterix_udp_nodelet": {"udp": "127.0.0.1:47917"},
    "radar_sim/radar_sim_nodelet": {"scenario": str(SCENARIO), "live": {"wait_for": ["/nobody"]}},
    "range_gate_tracker/window_tracker_nodelet": {"radar": "sps12"},
}


def printed(*command):
    return subprocess.run(command, check=True, timeout=100, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def without_names(message):
    """The bytes of all that does not tell where its tracker stands in the graph."""
    message.tracker = ""
    return bytes_off_the_map(message)


def offline():
    with tempfile.TemporaryDirectory() as folder:
        printed("rosrun", "tws_launch", "tws_offline", str(SCENARIO), "--out", folder)
        return [without_names(message) for _, message, _ in rosbag.Bag(f"{folder}/run.bag").read_messages(["/adit/tracks"])]


def classes():
    """Of all packages of this repository: PACKAGE/NODElet."""
    ours = printed("rospack", "depends-on1", "tws_runtime")
    plugins = [line.split() for line in printed("rospack", "plugins", "--attrib=plugin", "nodelet")]
    files = [file for package, file in plugins if package in ours]
    return sorted(entry.get("name") for file in files for entry in ElementTree.parse(file).iter("class"))


def north_message(seconds):
    """ASTERIX CAT034 of the radar 8/9: its beam points north at this time of the day [s]; the radar's position."""
    return bytes.fromhex("220013" "E110" "0809" "01") + (128 * seconds).to_bytes(3, "big") + bytes.fromhex("030C" "200000" "100000")


def plot_message(seconds):
    """ASTERIX CAT048 of the same radar: a primary plot in the east, 16 nautical miles away."""
    return bytes.fromhex("30000E" "F0" "0809") + (128 * seconds).to_bytes(3, "big") + bytes.fromhex("20" "10004000")


def wait_for(condition, seconds=60.0):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


class OwnGraphTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("own_graph_test")
        cls.tracks = {tracker: [] for tracker in TRACKERS}
        subscribers = [rospy.Subscriber(f"{tracker}/tracks", Tracks, lambda message, received=tracks: received.append(message))
                       for tracker, tracks in cls.tracks.items()]
        wait_for(lambda: all(subscriber.get_num_connections() > 0 for subscriber in subscribers))
        for radar in ("inside/sps12", "outside/sps12", "remapped/myradar"):  # The simulators wait for these.
            rospy.Subscriber(f"/{radar}/detections", rospy.AnyMsg, lambda message: None)
        cls.expected = offline()
        wait_for(lambda: all(len(tracks) >= len(cls.expected) - 10 for tracks in cls.tracks.values()))

    def check_same_as_offline(self, tracker):
        check_same([without_names(tracks) for tracks in self.tracks[tracker]], self.expected, tracker)

    def test_nodelets_give_the_tracks_of_an_offline_run(self):
        self.check_same_as_offline("/inside/adit")

    def test_programs_under_a_namespace_give_the_tracks_of_an_offline_run(self):
        self.check_same_as_offline("/outside/adit")

    def test_a_second_tracker_beside_the_first_has_tracks_of_its_own(self):
        states = [track.state for message in self.tracks["/outside/second"] for track in message.tracks]
        self.assertIn(2, states, "no firm track")
        self.assertEqual({message.tracker for message in self.tracks["/outside/second"]}, {"outside/second"})

    def test_a_radar_under_remapped_topics_is_tracked_by_who_is_told_by_remaps(self):
        self.check_same_as_offline("/remapped/adit")

    def test_a_radar_under_remapped_topics_is_tracked_by_who_is_told_by_a_parameter(self):
        firm = [track for message in self.tracks["/remapped/told"] for track in message.tracks if track.state == 2]
        self.assertGreater(len(firm), 20)
        self.assertEqual({radar for track in firm for radar in track.radars}, {"myradar", "sps39"})

    def test_a_wrong_parameter_keeps_only_its_own_nodelet_from_loading(self):
        nodelets = rospy.ServiceProxy("/inside/manager/list", NodeletList)().nodelets
        self.assertEqual(sorted(nodelets), ["/inside/adit", "/inside/ppi", "/inside/radar_sim"])

    def test_every_class_can_be_loaded_and_unloaded(self):
        load = rospy.ServiceProxy("/inside/manager/load_nodelet", NodeletLoad)
        unload = rospy.ServiceProxy("/inside/manager/unload_nodelet", NodeletUnload)
        with tempfile.NamedTemporaryFile() as recording:
            recording.write(b"".join(north_message(north) + plot_message(north + 1) for north in range(36000, 36040, 4)))
            recording.flush()
            self.assertGreaterEqual(len(classes()), 14)
            for number, name in enumerate(classes()):
                for key, value in NEEDED.get(name, {}).items():
                    rospy.set_param(f"/loaded{number}/{key}", recording.name if value == "$recording" else value)
                with self.subTest(name):
                    self.assertTrue(load(name=f"/loaded{number}", type=name).success)
                    self.assertTrue(unload(name=f"/loaded{number}").success)
        # Some of them have told a time of their own: who draws in the same process has got over it.
        rospy.wait_for_message("/inside/ppi/sweep", rospy.AnyMsg, timeout=10)


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "own_graph_test", OwnGraphTest)
