#!/usr/bin/env python3
"""Radars on one host, the tracker on another, a slow network with losses between them:

  two_hosts.py [--delay S] [--loss SHARE] [--outage S] [--duration S] [--out FOLDER]

As root, in a workspace. Without an outage the tracks must be those of the offline run, byte by byte: what comes less than the tracker's
skew limit (a second) late changes nothing. In a second flight the network fails for a while: the tracker may skip what it missed, and the
tracks that it had must go on. Prints what the network did; status 1: one of the two does not hold.
"""
import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import rosbag

import compare_tracks
from campaign_graph import Tracks, compare
from slow_link import SlowLink

RADARS, TRACKER = "tws-radars", "tws-tracker"
ADDRESS = {RADARS: "10.77.19.1", TRACKER: "10.77.19.2"}
SCENARIO = pathlib.Path(__file__).resolve().parent.parent / "scenarios/adit_nominal.yaml"
MESSAGES_A_SECOND = 10  # at the least
HEARD = ["/sps12/detections", "/sps12/sector_marks", "/sps39/detections", "/sps39/sector_marks"]
TRACKS = "/adit/tracks"
PATIENCE = 60  # [s]: over such a network a node needs some seconds to start
AGAIN = 30.0  # [s]: TCP repeats at last after such a pause what it has lost, when the network is back


class Hosts:
    def __init__(self, folder):
        self.folder, self.processes = folder, []

    def command(self, host, words):
        environment = {**os.environ, "ROS_MASTER_URI": f"http://{ADDRESS[RADARS]}:11411", "ROS_IP": ADDRESS[host],
                       "ROS_LOG_DIR": str(self.folder / "log")}
        environment.pop("ROS_HOSTNAME", None)
        return {"args": ["ip", "netns", "exec", host, *map(str, words)], "env": environment}

    def start(self, host, name, *words):
        with open(self.folder / f"{name}.log", "w", encoding="utf8") as log:
            self.processes.append(subprocess.Popen(**self.command(host, words), stdout=log, stderr=log, start_new_session=True))
        return self.processes[-1]

    def run(self, host, *words):
        return subprocess.run(**self.command(host, words), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False).stdout

    def wait_for_subscribers(self, topics):
        end = time.time() + PATIENCE
        while not set(topics) <= set(self.run(RADARS, "rostopic", "list", "-s").split()):
            if time.time() > end:
                raise RuntimeError(f"no subscribers of {', '.join(topics)} after {PATIENCE} s")
            time.sleep(0.5)

    def stop(self):
        for process in reversed(self.processes):
            for sign in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
                try:
                    os.killpg(process.pid, sign)
                    process.wait(15)
                except (ProcessLookupError, subprocess.TimeoutExpired):
                    continue


def start_all(hosts, bag):
    """The tracker and its recorder first: radars that start before it is there fly on without it. Returns the recorder."""
    hosts.start(RADARS, "master", "roscore", "-p", "11411")
    hosts.wait_for_subscribers(["/rosout"])
    hosts.start(TRACKER, "tracker", "roslaunch", "adit_tracker", "adit.launch")
    recorder = hosts.start(TRACKER, "recorder", "rosrun", "rosbag", "record", "-O", bag, TRACKS, "__name:=tracks_recorder")
    hosts.wait_for_subscribers([*HEARD, TRACKS])
    hosts.run(RADARS, "rosparam", "set", "/radar_sim/live/wait_timeout", str(PATIENCE))
    hosts.start(RADARS, "radars", "roslaunch", "radar_sim", "radar_sim.launch", f"scenario:={SCENARIO}", f"wait_for:=[{', '.join(HEARD)}]")
    hosts.wait_for_subscribers(["/sps39/elevation_requests"])  # It is there, and starts as soon as the tracker is connected.
    time.sleep(3.0)
    return recorder


def fly(folder, options, outage):
    """Returns the bag of the tracker's host, when [wall time] the network failed and was back, and the link with its counts."""
    folder.mkdir(parents=True, exist_ok=True)
    hosts, bag = Hosts(folder), folder / "tracks.bag"
    with SlowLink({name: ADDRESS[name] for name in (RADARS, TRACKER)}, options.delay, options.delay / 3, options.loss) as link:
        try:
            recorder = start_all(hosts, bag)
            time.sleep(options.duration / 2)
            down, link.down = time.time(), outage > 0.0
            time.sleep(outage)
            up, link.down = time.time(), False
            time.sleep(options.duration / 2 + (AGAIN if outage > 0.0 else 0.0))
            os.killpg(recorder.pid, signal.SIGINT)
            recorder.wait(30)
        finally:
            hosts.stop()
    return bag, (down, up), link


def same_bytes(folder, options):
    bag, _, link = fly(folder / "loss", options, 0.0)
    found, expected = (compare_tracks.tracks(path).get(TRACKS, []) for path in (bag, folder / "offline/run.bag"))
    # A message is written down when it arrives: the times differ, and the last ones are still on their way.
    expected, found = ([(0, data) for _, data in messages] for messages in (expected[:len(found)], found))
    words = compare_tracks.difference(expected, found)
    print(f"{link.carried} packets carried, {link.lost} lost; {len(found)} messages of tracks: {words or 'same'}")
    return not words and len(found) >= MESSAGES_A_SECOND * options.duration


def tracks_kept(folder, options):
    bag, (down, up), link = fly(folder / "outage", options, options.outage)
    with rosbag.Bag(str(bag)) as opened:
        stamps = [(arrival.to_sec(), message.header.stamp.to_sec()) for _, message, arrival in opened.read_messages([TRACKS])]
    reference = Tracks(folder / "offline/run.bag")
    fails = max((stamp for arrival, stamp in stamps if arrival < down), default=reference.begin) - reference.begin
    last = max((stamp for _, stamp in stamps), default=reference.begin) - reference.begin
    outcome = compare(Tracks(bag), reference, (fails - 10.0, fails), (last - 12.0, last))
    print(f"{link.carried} packets carried, {link.lost} lost; {up - down:.0f} s without a network from {fails:.1f} s on, the last tracks "
          f"are of {last:.1f} s: {outcome.text} kept")
    return outcome.tried > 0 and outcome.lost == 0 and last > fails + options.outage


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--delay", type=float, default=0.05, help="of a packet [s]; up to a third more at random")
    parser.add_argument("--loss", type=float, default=0.005, help="share of the packets")
    parser.add_argument("--outage", type=float, default=20.0, help="of the second flight [s]; 0: there is none")
    parser.add_argument("--duration", type=float, default=60.0, help="of each flight, with the network up [s]")
    parser.add_argument("--out", help="keep bags and logs here")
    options = parser.parse_args()
    if os.geteuid() != 0:
        print("skipped: network namespaces need root")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(options.out or name).resolve()
        subprocess.run(["rosrun", "tws_launch", "tws_offline", SCENARIO, "--duration", "300", "--out", folder / "offline"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        good = same_bytes(folder, options)
        good = (options.outage <= 0.0 or tracks_kept(folder, options)) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
