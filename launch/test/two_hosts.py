#!/usr/bin/env python3
"""Radars on one host, the tracker on another, a slow network with losses between them that fails for a while:

  two_hosts.py [--delay S] [--loss SHARE] [--outage S] [--duration S]

As root, in a workspace. The tracks must be those of the offline run, byte by byte. Prints what the network did; status 1: they differ.
"""
import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import compare_tracks
from slow_link import SlowLink

RADARS, TRACKER = "tws-radars", "tws-tracker"
ADDRESS = {RADARS: "10.77.19.1", TRACKER: "10.77.19.2"}
SCENARIO = pathlib.Path(__file__).resolve().parent.parent / "scenarios/adit_nominal.yaml"
MESSAGES_A_SECOND = 10  # at the least
LISTENERS = "[sps12/detections, sps12/sector_marks, sps39/detections, sps39/sector_marks, /adit/tracks]"


class Hosts:
    def __init__(self, folder):
        self.folder, self.processes = folder, []

    def start(self, host, name, *command):
        environment = {**os.environ, "ROS_MASTER_URI": f"http://{ADDRESS[RADARS]}:11411", "ROS_IP": ADDRESS[host]}
        environment.pop("ROS_HOSTNAME", None)
        with open(self.folder / f"{name}.log", "w") as log:
            process = subprocess.Popen(["ip", "netns", "exec", host, *map(str, command)], env=environment, stdout=log,
                                       stderr=subprocess.STDOUT, start_new_session=True)
        self.processes.append(process)
        return process

    def stop(self):
        for process in reversed(self.processes):
            for sign in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
                try:
                    os.killpg(process.pid, sign)
                    process.wait(15)
                except (ProcessLookupError, subprocess.TimeoutExpired):
                    continue


def offline(folder, duration):
    subprocess.run(["rosrun", "tws_launch", "tws_offline", SCENARIO, "--duration", str(duration), "--out", folder], check=True,
                   stdout=subprocess.DEVNULL)
    return compare_tracks.tracks(folder / "run.bag")["/adit/tracks"]


def over_the_network(folder, options):
    """The tracks that were recorded on the tracker's host, and the link with its counts."""
    hosts, bag = Hosts(folder), folder / "tracks.bag"
    with SlowLink({name: ADDRESS[name] for name in (RADARS, TRACKER)}, options.delay, options.delay / 3, options.loss) as link:
        try:
            hosts.start(RADARS, "master", "roscore", "-p", "11411")
            time.sleep(5.0)
            hosts.start(TRACKER, "tracker", "roslaunch", "adit_tracker", "adit.launch")
            recorder = hosts.start(TRACKER, "recorder", "rosbag", "record", "-O", bag, "/adit/tracks", "__name:=tracks_recorder")
            radars = hosts.start(RADARS, "radars", "roslaunch", "radar_sim", "radar_sim.launch", f"scenario:={SCENARIO}",
                                 f"wait_for:={LISTENERS}")
            time.sleep(options.duration / 2)
            link.down = options.outage > 0
            time.sleep(options.outage)
            link.down = False
            time.sleep(options.duration / 2 + 20.0)
            radars.poll()
            os.killpg(recorder.pid, signal.SIGINT)
            recorder.wait(30)
        finally:
            hosts.stop()
    return compare_tracks.tracks(bag)["/adit/tracks"], link


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--delay", type=float, default=0.05, help="of a packet [s]; up to a third more at random")
    parser.add_argument("--loss", type=float, default=0.005, help="share of the packets")
    parser.add_argument("--outage", type=float, default=20.0, help="[s]")
    parser.add_argument("--duration", type=float, default=120.0, help="[s]")
    options = parser.parse_args()
    if os.geteuid() != 0:
        print("skipped: network namespaces need root")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        expected = offline(folder / "offline", 600)
        found, link = over_the_network(folder, options)
    # A message is written down when it arrives: the times differ, and the last ones are still on their way.
    expected, found = ([(0, data) for _, data in messages] for messages in (expected[:len(found)], found))
    words = compare_tracks.difference(expected, found)
    print(f"{link.carried} packets carried, {link.lost} lost; {len(found)} messages of tracks: {words or 'same'}")
    return 1 if words or len(found) < MESSAGES_A_SECOND * options.duration else 0


if __name__ == "__main__":
    sys.exit(main())
