"""What the rows of the fault campaign have in common: live runs, their tracks, and how these compare."""
import collections
import dataclasses
import math
import os
import re
import signal
import subprocess
import time
import xmlrpc.client

import rosbag

from graph_test_kit import free_port

RATE = 4.0  # data time over wall time
FIRM = 2
# Their radars look where they are told to: what comes late on a busy machine, or not at all while the node stands, is looked at elsewhere,
# and a target may be lost and found again under another number.
CLOSED_LOOPS = {"range_gate_tracker": "/mrs/tracks", "mfa_stub": "/esa/tracks"}
NEAR = 500.0  # [m]: so near to each other within a second, two tracks are of one target


def environment(folder, master_uri):
    return dict(os.environ, ROS_MASTER_URI=master_uri, ROS_HOSTNAME="localhost", ROS_LOG_DIR=str(folder / "log"), ROS_HOME=str(folder))


class Graph:
    """A live run. Further `words` are start_graph's (a launch file stands alone, with no `rate`); `before` stands before the command;
    `other` is added to its environment; `limits` is called in the process before it."""

    def __init__(self, folder, *words, name="run", rate=RATE, master_uri=None, before=(), other=(), limits=None):
        self.log = folder / f"{name}.log"
        self.master_uri = master_uri or f"http://localhost:{free_port()}"
        self.environment = {**environment(folder, self.master_uri), **dict(other)}
        command = [*before, "rosrun", "tws_launch", "start_graph", *words, *([] if rate is None else [f"rate:={rate:g}", "rviz:=false"])]
        with open(self.log, "w", encoding="utf8") as log:
            self.process = subprocess.Popen([*map(str, command)], env=self.environment, stdout=log, stderr=log, preexec_fn=limits)
        self.rate, self.said, self.heard = rate, 0.0, time.time()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait()

    def words(self):
        return self.log.read_text(encoding="utf8", errors="replace")

    def last_line(self):
        return (self.words().strip().splitlines() or ["it said nothing"])[-1]

    def data_time(self):
        """Since the run's start [s], as its progress says it every five seconds; 0 before that."""
        said = re.findall(r"([0-9.]+) of [0-9.]+ s simulated", self.words())
        if said and float(said[-1]) != self.said:
            self.said, self.heard = float(said[-1]), time.time()
        return self.said + self.rate * (time.time() - self.heard) if said else 0.0

    def wait_until(self, data_time):
        while self.data_time() < data_time:
            if self.process.poll() is not None:
                raise RuntimeError(f"the run ended too early: {self.last_line()}")
            time.sleep(0.1)

    def pid(self, node):
        """Of a node by its name, or of the master, which is no node."""
        if node == "master":
            return xmlrpc.client.ServerProxy(self.master_uri).getPid("/campaign")[2]
        _, _, uri = xmlrpc.client.ServerProxy(self.master_uri).lookupNode("/campaign", "/" + node)
        return xmlrpc.client.ServerProxy(uri).getPid("/campaign")[2]

    def kill(self, node):
        os.kill(self.pid(node), signal.SIGKILL)

    def stop_for(self, node, seconds):
        pid = self.pid(node)
        os.kill(pid, signal.SIGSTOP)
        time.sleep(seconds)
        os.kill(pid, signal.SIGCONT)

    def wait_for_end(self, seconds=240.0):
        """The status, or None: it does not end."""
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            return None


class Tracks:
    """What a recorded run says of tracks, by topic: (uid, stamp [s]) of each update of a firm track, in the order of the recording; its
    place (x, y) [m] by the same; and the bytes of its messages but for header.seq."""

    def __init__(self, bag):
        self.firm, self.bytes, self.places = (collections.defaultdict(kind) for kind in (list, list, dict))
        with rosbag.Bag(str(bag)) as opened:
            self.begin = opened.get_start_time()
            for topic, (kind, data, _, _, cls), _ in opened.read_messages(raw=True):
                if kind != "tws_msgs/Tracks":
                    continue
                self.bytes[topic].append(data[4:])
                message = cls().deserialize(data)
                stamp = message.header.stamp.to_sec()
                self.firm[topic] += [(t.uid, stamp) for t in message.tracks if t.state == FIRM]
                self.places[topic].update({(t.uid, stamp): (t.position.x, t.position.y) for t in message.tracks if t.state == FIRM})


def alive(updates, begin, end):
    return {uid for uid, stamp in updates if begin <= stamp < end}


@dataclasses.dataclass
class Outcome:
    tried: int = 0
    lost: int = 0
    text: str = ""
    skipped: bool = False

    def __add__(self, other):
        return Outcome(self.tried + other.tried, self.lost + other.lost, "; ".join(filter(None, (self.text, other.text))),
                       self.skipped and other.skipped)


def skipped(why):
    return Outcome(text=why, skipped=True)


def check(good, text):
    """One thing tried, which held or not."""
    return Outcome(1, 0 if good else 1, text if good else f"NOT {text}")


def compare(run, reference, before, after, but=None):
    """Tracks that the reference has in both intervals of data time since the start [s]: how many the run has before, and has lost after.
    Not those on the topic `but`. In a closed loop another track of the same target will do."""
    before, after = (tuple(reference.begin + t for t in interval) for interval in (before, after))
    result, where = Outcome(), []
    for topic, updates in reference.firm.items():
        if topic == but:
            continue
        kept = alive(updates, *before) & alive(updates, *after) & alive(run.firm[topic], *before)
        lost = kept - alive(run.firm[topic], *after)
        if topic in CLOSED_LOOPS.values():
            lost -= seen_again(run, reference, topic, lost, after)
        result += Outcome(len(kept), len(lost))
        where += [topic] * bool(lost)
    said = f"{result.tried - result.lost}/{result.tried} tracks"
    return Outcome(result.tried, result.lost, f"{said}, lost on {' '.join(where)}" if where else said)


def seen_again(run, reference, topic, uids, interval):
    """Those of the reference's tracks on whose target the run has a firm track, too, within the interval [s]."""
    begin, end = interval
    found = [(stamp, place) for (_, stamp), place in run.places[topic].items() if begin <= stamp < end]
    return {uid for (uid, stamp), place in reference.places[topic].items() if uid in uids and begin <= stamp < end
            and any(abs(other - stamp) < 1.0 and math.dist(there, place) < NEAR for other, there in found)}


def found_again(run, reference, topic, before, after):
    """Targets on which the reference has a firm track in both intervals [s of data time]: lost are those where the run has none after."""
    before, after = (tuple(reference.begin + t for t in interval) for interval in (before, after))
    wanted = alive(reference.firm[topic], *before) & alive(reference.firm[topic], *after)
    seen = seen_again(run, reference, topic, wanted, after)
    return Outcome(len(wanted), len(wanted - seen), f"{len(seen)}/{len(wanted)} targets on {topic}")


def count_alike(run, reference, topic, interval):
    """As `compare` for tracks that began anew: only their number counts, and one in ten may be missing."""
    begin, end = (reference.begin + t for t in interval)
    wanted, found = len(alive(reference.firm[topic], begin, end)), len(alive(run.firm[topic], begin, end))
    lost = max(0, wanted - found) if found < 0.9 * wanted else 0
    return Outcome(wanted, lost, f"{found} tracks on {topic} where the reference has {wanted}")


def same_topics(run, reference):
    """As far as the shorter of them goes."""
    pairs = {topic: list(zip(run.bytes[topic], messages)) for topic, messages in reference.bytes.items()}
    same = [topic for topic, pair in pairs.items() if pair and all(one == two for one, two in pair)]
    return f"the same bytes: {' '.join(same) or 'none'}"


def offline(scenario, folder, duration, *words, **options):
    """Runs it; returns subprocess's result."""
    command = ["rosrun", "tws_launch", "tws_offline", str(scenario), "--out", str(folder), "--duration", f"{duration:g}"]
    return subprocess.run([*command, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False,
                          **options)
