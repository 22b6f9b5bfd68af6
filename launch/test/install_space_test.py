#!/usr/bin/env python3
"""The install space: `cmake --install` gives all that a run needs, and nothing of it lies in the source or build folder.

Called with the build folder. Who deploys the trackers on another machine has nothing else."""
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import rosbag

from graph_test_kit import check_same, in_time
from graph_test_kit import message_bytes as tracks

BUILD = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build").resolve()
STAGE = BUILD / "install_test"  # Under build/: within the source tree it would be crawled for packages.
PACKAGES = ["adit_tracker", "asterix_bridge", "esa_frame_builder", "radar_sim", "range_gate_tracker", "track_correlator",
            "track_evaluation", "tws_launch", "tws_rviz"]
PORT = 11987  # of this test's own master


def prefix():
    """catkin writes it into what it installs, so that it is the one given when the build was configured."""
    cache = (BUILD / "CMakeCache.txt").read_text().splitlines()
    return next(line.split("=", 1)[1] for line in cache if line.startswith("CMAKE_INSTALL_PREFIX:"))


SPACE = pathlib.Path(f"{STAGE}{prefix()}")


def installed(command, **options):
    """Runs a line of shell in the environment of the install space and of nothing else."""
    environment = {"PATH": "/usr/bin:/bin", "HOME": os.environ.get("HOME", "/tmp"), "ROS_HOSTNAME": "localhost"}
    environment["ROS_MASTER_URI"] = f"http://localhost:{PORT}"
    done = subprocess.run(["bash", "-c", f"source {SPACE}/setup.bash && {command}"], env=environment, text=True, timeout=300, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}")
    return done.stdout


class InstallSpaceTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(STAGE, ignore_errors=True)
        subprocess.run(["cmake", "--install", str(BUILD)], env=dict(os.environ, DESTDIR=str(STAGE)), check=True, timeout=300,
                       stdout=subprocess.DEVNULL)

    def test_every_package_is_found_there_with_its_nodelets(self):
        for package in PACKAGES:
            self.assertEqual(installed(f"rospack find {package}").strip(), f"{SPACE}/share/{package}")
        exported = installed("rospack plugins --attrib=plugin nodelet").split()
        for package in PACKAGES:
            plugins = SPACE / "share" / package / "nodelet_plugins.xml"
            self.assertIn(str(plugins), exported)
            self.assertTrue((SPACE / f"lib/lib{package}_nodelets.so").exists())

    def test_every_launch_file_finds_its_nodes_and_files(self):
        own = {"radar_sim": "scenario:=/x.yaml", "asterix_file": "file:=/x", "asterix_udp": "udp:=1", "replay": "bag:=/x"}
        for file in sorted(SPACE.glob("share/*/launch/*.launch")) + sorted(SPACE.glob("share/tws_launch/*.launch")):
            with self.subTest(file.name):
                self.assertTrue(installed(f"roslaunch --nodes {file} {own.get(file.stem, '')}"))

    def test_runs_live_and_offline_give_the_same_tracks(self):
        live, folder = SPACE / "live.bag", SPACE / "offline"
        scenario = SPACE / "share/tws_launch/scenarios/one_aircraft.yaml"
        installed(f"rosrun tws_launch tws_offline {scenario} --out {folder} --duration 20")

        def at(rate):
            installed(f"roslaunch -p {PORT} tws_launch run.launch scenario:=one_aircraft duration:=20 rate:={rate} rviz:=false "
                      f"record:={live}")
            return live

        check_same(tracks(in_time(at, 10)), tracks(folder / "run.bag"))

    def test_a_scenario_of_ones_own_has_every_system_that_it_describes(self):
        scenario, bag = STAGE / "mine.yaml", SPACE / "mine.bag"
        shutil.copy(SPACE / "share/tws_launch/scenarios/full.yaml", scenario)
        installed(f"roslaunch -p {PORT} tws_launch run.launch scenario:={scenario} duration:=30 rate:=5 rviz:=false record:={bag}")
        heard = rosbag.Bag(str(bag)).get_type_and_topic_info().topics
        for topic in ("/adit/tracks", "/ssr/tracks", "/correlated/tracks", "/esa/tracks", "/mrs/tracks"):
            self.assertIn(topic, heard)
            self.assertGreater(heard[topic].message_count, 10, topic)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
