#!/usr/bin/env python3
"""Clutter that comes and goes: how soon the map learns and forgets it, that nobody loses a track, and that a map that was saved is there in
the next run, in replays too. The figures in adit_tracker/doc/operators.md rest on the same scenario."""
import collections
import math
import pathlib
import tempfile
import unittest

import rosbag
import rospy
import rosunit
from tws_msgs.msg import OperatorRequest, Track, TruthTarget
from tws_msgs.srv import LoadClutterMap, SaveClutterMap

from adit_operator_test import Operator
from graph_test_kit import check_same
from whole_graph_test import command, late, launch, launch_beside, offline, tracks

SCENARIO = "clutter_comes_and_goes"
COMES, GOES = 100.0, 240.0  # the fleet [s]
PERIODS = {"sps12": 6.0, "sps39": 8.0}
HITS, DROP_TIME = 4, 40.0   # clutter.hits, clutter.drop_time_s
LAG = 1.0                   # five sectors, and the radar's clock [s]
CONFIRMED = (Track.FIRM, Track.COASTING)


def messages(bag, *topics):
    with rosbag.Bag(str(bag)) as opened:
        return [message for _, message, _ in opened.read_messages(topics)]


class Run:
    """What the bag of a run holds, in seconds since its beginning."""

    def __init__(self, bag):
        self.truth = messages(bag, "/truth")
        self.began = self.truth[0].header.stamp.to_sec()
        self.maps = [(self.since(m.header.stamp), m.points) for m in messages(bag, "/adit/clutter_map")]
        self.updates = [w for m in messages(bag, "/adit/tracks") for w in m.tracks]

    def since(self, stamp):
        return stamp.to_sec() - self.began

    def places(self, name):
        """Of what never moves: slant range and azimuth, by name."""
        return {t.name: (t.slant_range[0], t.azimuth[0]) for m in self.truth for t in m.targets if t.name.startswith(name)}

    def moving(self, time):
        nearest = min(self.truth, key=lambda m: abs(self.since(m.header.stamp) - time))
        return {t.name: (t.slant_range[0], t.azimuth[0]) for t in nearest.targets if t.kind != TruthTarget.CLUTTER}

    def absorbed(self, place, radar):
        """Times of the maps in which that radar's map takes out what is seen there."""
        return [time for time, points in self.maps
                if any(p.radar == radar and p.absorbing and apart(place, (p.range, p.azimuth)) < 1000 for p in points)]

    def begun_at(self, places, until):
        """Tracks that began there."""
        return {w.uid for w in self.updates
                if self.since(w.first_detection) < until and any(apart(place, (w.range, w.azimuth)) < 1000 for place in places)}


def apart(a, b):
    """Between two (range, azimuth) [m]."""
    return math.hypot(a[0] - b[0], 0.5 * (a[0] + b[0]) * math.remainder(a[1] - b[1], 2 * math.pi))


def north(time):
    """Where the scenario's aircraft of that name is: slant range [m], azimuth [degrees]."""
    x, y = (60e3 * f(math.radians(340)) + 200 * time * f(math.radians(200)) for f in (math.sin, math.cos))
    return math.hypot(x, y, 5000), math.degrees(math.atan2(x, y)) % 360


class ClutterTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("clutter_test", disable_rostime=True)
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="clutter_"))
        cls.live, cls.saved, cls.given = (cls.folder / name for name in ("live.bag", "saved.csv", "given.csv"))
        choice = f"adit: {{clutter_map_folder: {cls.folder}}}"
        cls.scenario = pathlib.Path(__file__).parent.parent / "scenarios" / f"{SCENARIO}.yaml"
        cls.save_answer, cls.load_answer = launch_beside(cls.work, cls.live, rate=5, scenario=SCENARIO, duration=85,
                                                         trackers=f"{{{choice}}}")
        cls.bare = Run(offline(cls.scenario, cls.folder / "bare"))

    @classmethod
    def work(cls):
        cls.given.write_text("radar,range_m,az_deg\n# where the aircraft north flies when this is loaded\n" +
                             "".join(f"*,{slant_range},{azimuth}\n" for slant_range, azimuth in map(north, range(60, 95))))
        Operator().wait(65)
        saved = rospy.ServiceProxy("/adit/save_clutter_map", SaveClutterMap)(cls.saved.name)
        for _ in range(50):  # asks again when the tracker is busy
            loaded = rospy.ServiceProxy("/adit/load_clutter_map", LoadClutterMap)(cls.given.name)
            if not loaded.message.startswith("busy"):
                break
        cls.given.unlink()
        return saved, loaded

    @classmethod
    def tearDownClass(cls):
        command("rm", "-rf", cls.folder)

    # If this fails, clutter is learned later than the method says, or aircraft are taken for it.
    def test_a_point_takes_its_detections_out_from_the_fifth_on(self):
        scans = []
        for boat in self.bare.places("boat").values():
            for radar, period in PERIODS.items():
                first = min(self.bare.absorbed(boat, radar))
                self.assertGreater(first, COMES + (HITS - 1) * period - LAG, "before the fourth detection")
                scans.append((first - COMES) / period)
        self.assertEqual(len(scans), 24)
        # The first detection comes within a turn, three more in as many turns, the map's message with the next north mark.
        self.assertLess(sorted(scans)[12], 1 + HITS + 1)
        # One detection in ten is missed, and of two points each may have two of the first four. Four of eight with a chance of three
        # quarters each: 0.97, so that of 24 more than two are later with a chance of 0.03.
        self.assertLess(sorted(scans)[21], 1 + 2 * HITS + 1)

    # If this fails, an aircraft is swallowed where clutter was a minute ago.
    def test_a_point_is_gone_forty_seconds_after_its_last_detection(self):
        for boat in self.bare.places("boat").values():
            for radar, period in PERIODS.items():
                there = self.bare.absorbed(boat, radar)
                self.assertGreater(max(there), GOES - 2 * period + DROP_TIME - period)
                self.assertLess(max(there), GOES + DROP_TIME + period + LAG)
        for time, points in self.bare.maps:
            for point in points:
                self.assertLess(time - self.bare.since(point.last_update), DROP_TIME + PERIODS[point.radar] + LAG)

    # If this fails, the picture shows boats and rocks as aircraft, or loses an aircraft over them.
    def test_no_clutter_becomes_a_firm_track_and_aircraft_keep_theirs(self):
        still = [*self.bare.places("boat").values(), *self.bare.places("rock").values()]
        holders = collections.defaultdict(list)
        for update in self.bare.updates:
            if update.state not in CONFIRMED:
                continue
            here, time = (update.range, update.azimuth), self.bare.since(update.stamp)
            name, distance = min(((name, apart(here, place)) for name, place in self.bare.moving(time).items()), key=lambda pair: pair[1])
            if distance < 3000:
                holders[name].append((time, update.uid))
            self.assertFalse(distance > 3000 and any(apart(here, place) < 1500 for place in still),
                             f"track {update.uid} at {time:.0f} s stands on clutter")
        self.assertEqual(len(holders), 6)
        for name, updates in holders.items():
            uids = [uid for time, uid in updates if time > 30]
            most = collections.Counter(uids).most_common(1)[0]
            self.assertLess(min(time for time, uid in updates if uid == most[0]), 40, name)
            self.assertGreater(max(time for time, uid in updates if uid == most[0]), 310, name)

    # If this fails, each run begins with a picture full of rocks that were known the day before.
    def test_a_run_that_loads_the_saved_map_starts_fewer_tracks_on_clutter(self):
        self.assertTrue(self.save_answer.success, self.save_answer.message)
        self.assertGreaterEqual(self.save_answer.count, 2 * 12 - 2)
        rows = [line for line in self.saved.read_text().splitlines() if not line.startswith("#")][1:]
        self.assertEqual(len([row for row in rows if row.count(",") == 2]), self.save_answer.count)
        self.assertGreater(len(rows), self.save_answer.count + 1000, "nothing that was learned of the radars")
        knowing = Run(offline(self.scenario, self.folder / "knowing", "--clutter-map", self.saved, "--duration", "60"))
        rocks = self.bare.places("rock").values()
        bare, knowing_begun = len(self.bare.begun_at(rocks, 40)), len(knowing.begun_at(rocks, 40))
        self.assertGreaterEqual(bare, 12)
        # Now and then a detection scatters beyond its point's region.
        self.assertLess(knowing_begun, bare / 2)
        # Offline runs of its bag need no file.
        again = offline(self.folder / "knowing" / "run.bag", self.folder / "again")
        self.assertEqual(tracks(self.folder / "knowing" / "run.bag"), tracks(again))

    def test_a_replay_repeats_a_load_without_the_file(self):
        self.assertTrue(self.load_answer.success, self.load_answer.message)
        self.assertEqual(self.load_answer.count, 35)
        loads = [m for m in messages(self.live, "/adit/operator_requests")
                 if m.request == OperatorRequest.LOAD_CLUTTER and m.result == m.OK]
        self.assertEqual([len(m.clutter) for m in loads], [35])
        lives, bare = tracks(self.live), tracks(self.folder / "bare" / "run.bag")
        self.assertTrue(lives != bare[:len(lives)], "what was loaded changed nothing")
        replay = launch("replay.launch", self.folder / "replay.bag", rate=5, bag=self.live)
        for bag in (replay, offline(self.live, self.folder / "offline")):
            for recorded in (self.live, bag):
                self.assertEqual(late(recorded), {}, "this machine was too slow for the comparison")
            check_same(tracks(self.live), tracks(bag))


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "clutter_test", ClutterTest)
