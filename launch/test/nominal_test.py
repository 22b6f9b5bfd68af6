#!/usr/bin/env python3
"""Scenario adit_nominal, whole: nominal_test.py PATH_OF_TWS_OFFLINE PATH_OF_SCENARIO

60 aircraft, two radars that fade, clutter and false alarms. If this fails, aircraft that a radar sees well have no track, or clutter has one.
The limits are requirements, not measurements; adit_tracker/README.md has the figures.
"""
import bisect
import collections
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import rosbag

SCENARIO, OFFLINE = sys.argv.pop(), sys.argv.pop()
SEEDS = [1, 2, 3]
SHORTEST_VISIT = 60     # of aircraft that are shorter in cover, the completeness is not judged one by one [s]
COVER = 0.8          # single-scan chance of detection by at least one radar
NEAR = 3000.0        # a track holds a target within [m]
LONGEST_SILENCE = 30.0  # a track's last word counts for [s]
AIRCRAFT, CLUTTER = 0, 2
FIRM, COASTING, DROPPED = 2, 3, 4


def distance(a, b):
    """Between two (range, azimuth)."""
    return math.hypot(a[0] - b[0], (a[0] + b[0]) * math.sin((a[1] - b[1]) / 2))


class Run:
    def __init__(self, seed):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([OFFLINE, SCENARIO, "--seed", str(seed), "--out", folder], check=True, timeout=300,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            with rosbag.Bag(str(pathlib.Path(folder) / "run.bag")) as bag:
                self.truth = [m for _, m, _ in bag.read_messages(["/truth"])]
                self.messages = [m for _, m, _ in bag.read_messages(["/adit/tracks"])]
        self.covered, self.held = collections.Counter(), collections.Counter()
        self.entered, self.found = {}, {}
        self.compare()

    def compare(self):
        """Every second: which aircraft in cover have a firm or coasting track?"""
        times = [m.header.stamp.to_sec() for m in self.messages]
        last, done = {}, 0
        for truth in self.truth:
            now = truth.header.stamp.to_sec()
            until = bisect.bisect_right(times, now)
            for message in self.messages[done:until]:
                last.update({track.uid: track for track in message.tracks})
            done = until
            places = []
            for track in last.values():
                age = now - track.stamp.to_sec()
                if track.state in (FIRM, COASTING) and age < LONGEST_SILENCE:
                    places.append((track.range + age * track.range_rate, track.azimuth + age * track.azimuth_rate))
            for target in truth.targets:
                if target.kind == AIRCRAFT:
                    self.judge(now, target, places)

    def judge(self, now, target, places):
        place = (target.slant_range[0], target.azimuth[0])
        held = any(distance(place, p) < NEAR for p in places)
        in_cover = max(target.detection_probability) >= COVER
        if in_cover:
            self.entered.setdefault(target.id, now)
            self.covered[target.id] += 1
            self.held[target.id] += held
        if held and target.id in self.entered:
            self.found.setdefault(target.id, now)

    def share_found_within(self, limit):
        """Of the aircraft that entered cover early enough to be judged."""
        end = self.truth[-1].header.stamp.to_sec()
        delays = [self.found.get(i, math.inf) - entered for i, entered in self.entered.items() if entered + limit <= end]
        return sum(delay <= limit for delay in delays) / len(delays)

    def completeness(self):
        return sum(self.held.values()) / sum(self.covered.values())

    def mean_completeness(self):
        """Each aircraft counts the same."""
        judged = [i for i, seconds in self.covered.items() if seconds >= SHORTEST_VISIT]
        return sum(self.held[i] / self.covered[i] for i in judged) / len(judged)

    def firm_clutter(self):
        """Tracks that were firm for over a minute and were mostly where clutter is."""
        clutter = [(t.slant_range[0], t.azimuth[0]) for t in self.truth[0].targets if t.kind == CLUTTER]
        span, on_clutter = {}, collections.defaultdict(list)
        for message in self.messages:
            for track in message.tracks:
                if track.state not in (FIRM, COASTING):
                    continue
                now = track.stamp.to_sec()
                span[track.uid] = (span.get(track.uid, (now,))[0], now)
                on_clutter[track.uid].append(any(distance((track.range, track.azimuth), c) < 1000.0 for c in clutter))
        return [uid for uid, (begin, end) in span.items()
                if end - begin > 60.0 and 2 * sum(on_clutter[uid]) > len(on_clutter[uid])]


class AditNominal(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.runs = {seed: Run(seed) for seed in SEEDS}

    def each(self):
        for seed, run in self.runs.items():
            with self.subTest(seed=seed):
                yield run

    def test_aircraft_have_a_firm_track_within_40_s_of_entering_cover(self):
        for run in self.each():
            self.assertGreaterEqual(run.share_found_within(40.0), 0.95)

    def test_aircraft_in_cover_keep_their_tracks(self):
        for run in self.each():
            self.assertGreaterEqual(run.completeness(), 0.95)

    def test_in_the_mean_over_aircraft_and_seeds_too(self):
        means = [run.mean_completeness() for run in self.runs.values()]
        self.assertGreaterEqual(sum(means) / len(means), 0.95)

    def test_no_clutter_point_is_a_firm_track_for_a_minute(self):
        for run in self.each():
            self.assertEqual(run.firm_clutter(), [])


if __name__ == "__main__":
    unittest.main()
