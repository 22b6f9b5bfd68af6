"""Rows of the fault campaign whose input comes from a player: a recording in a loop or very fast, and messages that make no sense."""
import functools
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree

import rosbag
import rosgraph

from campaign_graph import FIRM, Graph, Outcome, alive, check, environment, offline, skipped
from graph_test_kit import free_port

SCENARIO = pathlib.Path(__file__).resolve().parent.parent / "scenarios" / "adit_nominal.yaml"
SENSORS = ("/sps12/detections", "/sps12/sector_marks", "/sps39/detections", "/sps39/sector_marks", "/tf_static")
RECORDED, LAST = 100.0, 16.0  # [s of data time]
LOOP_RATE, LOOPS, FAST = 5.0, 3, 20.0
INJECT = pathlib.Path(os.environ.get("TWS_SHARED", "/nowhere"), "data", "reported_inputs", "ros", "inject.py")
KINDS = ("future_day", "second_publisher", "nonsense_all", "foreign_tracks", "stamp_jitter_100ms", "flood", "tf_nonsense", "stamp_zero",
         "future_max")
INJECT_END, INJECT_RATE = 58.0, 6.0  # [s of data time]


class Bench:
    """A master with programs of its own, without our launch files; they end with it."""

    def __init__(self, folder):
        self.folder, port = folder, free_port()
        self.master_uri = f"http://localhost:{port}"
        self.environment = environment(folder, self.master_uri)
        self.master = rosgraph.Master("/campaign", master_uri=self.master_uri)
        self.processes = []
        self.start("roscore", "roscore", "-p", port)

    def __enter__(self):
        end = time.time() + 60.0
        while not self.master.is_online() and time.time() < end:
            time.sleep(0.1)
        self.master.setParam("/use_sim_time", True)
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.send_signal(signal.SIGINT)
            try:
                process.wait(20.0)
            except subprocess.TimeoutExpired:  # roscore, whose master was killed
                process.kill()

    def start(self, name, *command):
        with open(self.folder / f"{name}.log", "w", encoding="utf8") as log:
            self.processes.append(subprocess.Popen([*map(str, command)], env=self.environment, stdout=log, stderr=log))
        return self.processes[-1]

    def stop(self, process):
        process.send_signal(signal.SIGINT)
        process.wait()
        self.processes.remove(process)


def recording(folder):
    (folder / "recorded").mkdir(exist_ok=True)
    done = offline(SCENARIO, folder / "recorded", RECORDED)
    if done.returncode != 0:
        raise RuntimeError(f"the recording failed: {done.stdout[-160:]}")
    return folder / "recorded" / "run.bag"


def play(campaign, bag, seconds, *options):
    """A tracker as its own launch file starts it, and rosbag's player. Returns the bag of its tracks."""
    with Bench(campaign.folder) as bench:
        bench.start("tracker", "roslaunch", "adit_tracker", "adit.launch")
        recorder = bench.start("recorder", "rosbag", "record", "--buffsize=0", "-O", campaign.folder / "tracks.bag", "/adit/tracks")
        time.sleep(5.0)
        playing = ["rosbag", "play", "--quiet", "--clock", "--queue=0", "--delay=2", *options, bag, "--topics", *SENSORS]
        player = bench.start("player", *playing)
        end = time.time() + seconds
        while player.poll() is None and time.time() < end:
            time.sleep(0.2)
        time.sleep(2.0)
        bench.stop(recorder)
    return campaign.folder / "tracks.bag"


def rounds(bag):
    """(uid, stamp) of firm tracks, round by round: a round begins where the stamps go back by more than half the recording."""
    found, latest = [[]], None
    with rosbag.Bag(str(bag)) as opened:
        messages = [message for _, message, _ in opened.read_messages(["/adit/tracks"])]
    for message in sorted(messages, key=lambda each: each.header.seq):  # The recorder dates them by /clock, which goes back, too.
        stamp = message.header.stamp.to_sec()
        if latest is not None and stamp < latest - RECORDED / 2:
            found.append([])
        latest = stamp
        found[-1] += [(t.uid, stamp) for t in message.tracks if t.state == FIRM]
    return found


def tracked(campaign, bag, tracks, wanted_rounds):
    """Each whole round must have as many firm tracks at its end as the recording has, but for one in ten."""
    with rosbag.Bag(str(bag)) as opened:
        end = opened.get_start_time() + RECORDED
    reference, found = (len(alive(rounds(bag)[0], end - LAST, end)), rounds(tracks)[:wanted_rounds])
    counts = [len(alive(updates, end - LAST, end)) for updates in found]
    counts += [0] * (wanted_rounds - len(counts))
    lost = sum(reference - count for count in counts if count < 0.9 * reference)
    return Outcome(reference * wanted_rounds, lost, f"firm at the end of each round: {counts} where the recording has {reference}")


def bag_loop(campaign):
    bag = recording(campaign.folder)
    return tracked(campaign, bag, play(campaign, bag, (LOOPS + 0.5) * RECORDED / LOOP_RATE + 3.0, "-l", "-r", f"{LOOP_RATE:g}"), LOOPS)


def bag_fast(campaign):
    bag = recording(campaign.folder)
    return tracked(campaign, bag, play(campaign, bag, 60.0, "-r", f"{FAST:g}"), 1)


# ---- messages that make no sense ----

def graph_without_player(folder, bag):
    """The launch file of the graph for a bag, for whoever plays it."""
    launch = subprocess.run(["rosrun", "tws_launch", "tws_inspect", "launch", bag, "rviz:=false", f"rate:={INJECT_RATE:g}"],
                            stdout=subprocess.PIPE, text=True, check=True).stdout
    tree = xml.etree.ElementTree.fromstring(launch)
    for parent in tree.iter():
        for node in [child for child in parent if child.tag == "node" and child.get("pkg") == "rosbag"]:
            parent.remove(node)
    path = folder / "graph.launch"
    path.write_bytes(xml.etree.ElementTree.tostring(tree))
    return path


@functools.lru_cache(maxsize=None)
def firm_words(folder, bag, kind):
    """Firm words by tracker in the seconds behind the disturbance, as inject.py counts them, and whether the nodes lived to the end."""
    with Graph(folder, graph_without_player(folder, bag), name=f"graph_{kind}", rate=None) as graph:
        time.sleep(8.0)
        done = subprocess.run([sys.executable, INJECT, kind, bag, f"{INJECT_END:g}", f"{INJECT_RATE:g}"], env=graph.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        (folder / f"{kind}.log").write_text(done.stdout)
        lived = graph.process.poll() is None and "died" not in graph.words()
    return {name: int(count) for name, count in re.findall(rf"{kind} (\w+): .* s (\d+), nonfinite", done.stdout)}, lived


def inject(kind):
    def row(campaign):
        if not INJECT.exists():
            return skipped("TWS_SHARED does not name the folder with reported_inputs/ros/inject.py")
        reference = campaign.folder.parent / "reference"
        healthy, _ = firm_words(reference, reference / "run.bag", "none")
        found, lived = firm_words(campaign.folder, reference / "run.bag", kind)
        outcome = check(lived, "all nodes lived")
        for name, count in healthy.items():
            if count > 0:
                good = found.get(name, 0) >= 0.9 * count
                outcome += Outcome(1, int(not good), f"{'' if good else 'NOT '}{name} {found.get(name, 0)}/{count}")
        return outcome
    return row


INPUT_ROWS = [("bag_loop", bag_loop), ("bag_fast", bag_fast), *[(f"inject_{kind}", inject(kind)) for kind in KINDS]]
