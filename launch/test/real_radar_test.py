#!/usr/bin/env python3
"""A recording of a real secondary radar through the whole graph: real_radar_test.py PATH_OF_TWS_OFFLINE

Needs the folder that TWS_SHARED names, else it is skipped. The tracker does not see the codes; they are for scoring only.
"""
import collections
import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag

from graph_test_kit import free_port, in_time, late
from graph_test_kit import message_bytes as tracks

OFFLINE = sys.argv.pop()
SHARED = os.environ.get("TWS_SHARED", "")
FOLDER = pathlib.Path(SHARED, "data", "asterix_msr_canalA")
RADAR = "radar_20_130"
FIRM = 2
MONITOR = "7777"  # the code of the site's fixed transponders
LIVE_DURATION = 200  # of data time [s]


def quiet(*words, timeout=300):
    subprocess.run([str(word) for word in words], check=True, timeout=timeout, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


class Score:
    """Which share of the aircraft's plots made a firm track, and how many of the monitors'."""

    def __init__(self, plots, firm):
        """plots: {time: [(x, y, code)]}; firm: (time, x, y) of each update of a firm track."""
        codes = collections.Counter(code for group in plots.values() for _, _, code in group)
        hits = collections.Counter()
        for time, x, y in firm:
            if time in plots:
                hits[min(plots[time], key=lambda p: math.hypot(p[0] - x, p[1] - y))[2]] += 1
        aircraft = [code for code, count in codes.items() if count >= 20 and code != MONITOR]
        self.share = sum(hits[code] for code in aircraft) / sum(codes[code] for code in aircraft)
        self.monitors = hits[MONITOR]


def place(reach, azimuth):
    return reach * math.sin(azimuth), reach * math.cos(azimuth)


def score_of_csv(folder):
    tracks = folder / "tracks.csv"
    quiet("rosrun", "adit_tracker", "adit_csv", "--detections", FOLDER / "plots.csv", "--tracks", tracks)
    plots = collections.defaultdict(list)
    with open(FOLDER / "plots.csv") as file:
        for row in csv.DictReader(file):
            plots[row["t_s"]].append((*place(float(row["range_m"]), math.radians(float(row["az_deg"]))), row["mode3a"]))
    with open(tracks) as file:
        return Score(plots, [(r["t_s"], float(r["x_m"]), float(r["y_m"])) for r in csv.DictReader(file) if r["status"] == "firm"])


def code_of_csv():
    """The code of each plot by where and when it was: unlike the message, the file also has those that the radar doubts."""
    with open(FOLDER / "plots.csv") as file:
        return [(float(r["t_s"]), float(r["range_m"]), r["mode3a"]) for r in csv.DictReader(file)]


def score_of_bag(bag):
    plots, firm, start = collections.defaultdict(list), [], None
    codes = collections.defaultdict(list)
    for time, reach, code in code_of_csv():
        codes[round(time, 4), round(reach)].append(code)
    with rosbag.Bag(str(bag)) as opened:
        for topic, message, _ in opened.read_messages([f"/{RADAR}/detections", "/adit/tracks"]):
            if topic == "/adit/tracks":
                firm += [(t.last_update, t.position.x, t.position.y) for t in message.tracks if t.state == FIRM]
                continue
            for plot in message.detections:
                start = start or plot.stamp
                key = round((plot.stamp - start).to_sec(), 4), round(round(plot.range, 1))
                plots[plot.stamp].append((*place(plot.range, plot.azimuth), codes[key].pop()))
    return Score(plots, firm)


@unittest.skipUnless(SHARED, "TWS_SHARED is not set")
class RealRadar(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        quiet(OFFLINE, FOLDER / "canalA.gps", "--out", cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    # If this fails, aircraft that a real radar reports lose their tracks, or its fixed monitors become aircraft.
    def test_scores_are_those_of_the_same_plots_from_a_csv_file(self):
        graph, plain = score_of_bag(self.folder / "run.bag"), score_of_csv(self.folder)
        print(f"plots of aircraft in a firm track: {graph.share:.4f}, from CSV {plain.share:.4f}; of monitors: {graph.monitors}",
              file=sys.stderr)
        self.assertGreater(graph.share, 0.97)  # the probability of update that surveillance standards ask for en route
        self.assertEqual(graph.monitors, 0)
        self.assertAlmostEqual(graph.share, plain.share, delta=0.005)

    # Whoever replays an incident offline relies on that.
    def test_live_tracks_are_those_of_the_offline_run(self):
        bag = self.folder / "live.bag"

        def at(rate):
            quiet("roslaunch", "--no-summary", "-p", free_port(), "tws_launch", "asterix.launch", f"file:={FOLDER / 'canalA.gps'}",
                  f"radars:={RADAR}", f"rate:={rate}", f"duration:={LIVE_DURATION}", "rviz:=false", f"record:={bag}")
            return bag

        self.assertEqual(late(in_time(at, 10)), {}, "this machine was too slow for the comparison")
        live, offline = tracks(bag), tracks(self.folder / "run.bag")
        self.assertGreater(len(live), LIVE_DURATION / 4.1 * 64)
        self.assertIn(live[0], offline[:128], "the first message of tracks is none of the first two turns")
        first = offline.index(live[0])  # On a busy machine the recorder may join a moment after the tracker's first message.
        different = [number for number, pair in enumerate(zip(live, offline[first:])) if pair[0] != pair[1]]
        self.assertEqual(different, [], f"of {len(live)} messages")


if __name__ == "__main__":
    unittest.main()
