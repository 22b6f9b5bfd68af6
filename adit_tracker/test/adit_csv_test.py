#!/usr/bin/env python3
"""adit_csv from the command line: adit_csv_test.py PATH_OF_ADIT_CSV"""
import collections
import csv
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

ADIT_CSV = sys.argv.pop(1)
PERIODS = {"a": 6.0, "b": 8.0}


def plots(start=0.0, until=120.0):
    """One aircraft from (60, 20) km with (-150, 120) m/s, seen by two radars whose beams point north at t = start."""
    rows = []
    for radar, period in PERIODS.items():
        for scan in range(int(until / period)):
            t = start + scan * period
            for _ in range(20):
                x, y = 60e3 - 150 * (t - start), 20e3 + 120 * (t - start)
                azimuth = math.degrees(math.atan2(x, y)) % 360
                t = start + (scan + azimuth / 360) * period
            rows.append((t, f"{t:.4f},{radar},{scan},{math.hypot(x, y):.1f},{azimuth:.4f}"))
    return [row for _, row in sorted(rows)]


class AditCsv(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.detections = os.path.join(self.folder.name, "plots.csv")
        self.tracks = os.path.join(self.folder.name, "tracks.csv")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, rows):
        with open(self.detections, "w") as file:
            file.write("t_s,radar,scan,range_m,az_deg\n" + "".join(row + "\n" for row in rows))

    def start(self, *arguments):
        return subprocess.run([ADIT_CSV, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)

    def track(self, rows, *arguments, radars=("a:6:0", "b:8:0")):
        """The rows written, without the header, and what was said."""
        self.write(rows)
        named = [word for radar in radars for word in ("--radar", radar)]
        done = self.start("--detections", self.detections, "--tracks", self.tracks, *named, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.tracks) as file:
            lines = file.read().splitlines()
        self.assertEqual(lines[0], "t_s,track_id,x_m,y_m,vx_mps,vy_mps,status")
        return [line.split(",") for line in lines[1:]], done.stderr

    # If this fails, a file whose rotation was not understood gives an empty picture and status 0.
    def test_a_file_in_which_nothing_is_tracked_is_no_success(self):
        self.write([f"{6 * scan + 3},a,{scan},{20000 + 7919 * scan % 50000},180" for scan in range(20)])
        done = self.start("--detections", self.detections, "--tracks", self.tracks, "--radar", "a:6:0")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("nothing was tracked: no track of 20 plots became firm; check the periods", done.stderr.splitlines()[-1])

    # If this fails, what one file of plots taught about the clutter is lost for the next.
    def test_a_clutter_map_that_was_saved_keeps_rocks_from_starting_tracks(self):
        rocks = [f"{6 * scan + 6 * azimuth / 360:.4f},a,{scan},{20000 + 40 * azimuth},{azimuth}"
                 for scan in range(20) for azimuth in range(30, 360, 30)]
        saved = os.path.join(self.folder.name, "map.csv")
        bare, _ = self.track(rocks, "--save-clutter-map", saved, radars=("a:6:0",))
        knowing, _ = self.track(rocks, "--clutter-map", saved, radars=("a:6:0",))
        self.assertEqual(len({row[1] for row in bare}), 11)
        self.assertEqual(knowing, [])
        with open(saved) as file:
            lines = [line for line in file.read().splitlines() if not line.startswith("#")]
        self.assertEqual(lines[:2], ["radar,range_m,az_deg,depth_m,greatest_range_m,false_plots,scans,seen,looks", "a,21200.0,30.0000"])
        self.assertGreater(len(lines), 1000, "no cells")
        points = [",".join(line.split(",")[:3]) for line in lines[:12]]  # as earlier versions wrote them
        with open(saved, "w") as file:
            file.write("\n".join(points) + "\n")
        self.assertEqual(self.track(rocks, "--clutter-map", saved, radars=("a:6:0",))[0], [])
        with open(saved, "a") as file:
            file.write("b,1000,1\n")
        done = self.start("--detections", self.detections, "--tracks", self.tracks, "--radar", "a:6:0", "--clutter-map", saved)
        self.assertEqual((done.returncode, done.stderr), (1, f"adit_csv: {saved}:13: there is no radar 'b'\n"))

    # If this fails, a script cannot tell a slip in its command line from a bad file.
    def test_bad_usage_exits_with_2(self):
        for arguments in ([], ["--detections", "x"], ["--detections", "x", "--tracks", "y", "--nonsense"],
                          ["--detections", "x", "--tracks", "y", "--capacity", "1"],
                          ["--detections", "x", "--tracks", "y", "--epochs", "-5"],
                          ["--detections", "x", "--tracks", "y", "--radar", "a:x"],
                          ["--detections", "x", "--tracks", "y", "--radar", "a:0.1"],
                          ["--detections", "x", "--tracks", "y", "--radar", "a:6", "--radar", "a:8"]):
            done = self.start(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertLess(len(done.stderr), 160)

    def test_help_exits_with_0(self):
        done = self.start("--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("--detections", done.stdout)

    def refused(self, *arguments):
        done = self.start("--detections", self.detections, "--tracks", self.tracks, *arguments)
        self.assertEqual(done.returncode, 1, done.stderr)
        return done.stderr

    def test_what_cannot_be_done_exits_with_1_and_says_why(self):
        self.assertIn("plots.csv: cannot be read", self.refused())
        self.write([])
        self.assertIn("plots.csv: holds no usable plot", self.refused())
        self.write(plots())
        self.assertIn("no plot of radar c", self.refused("--radar", "c:6:0"))
        said = self.refused("--radar", "a:6:0", "--params", "none.yaml")
        for word in ("none.yaml", "default", "nrl7952"):
            self.assertIn(word, said)
        self.write(plots()[:3])
        self.assertIn("give --radar a:PERIOD_S:PHASE_DEG", self.refused("--radar", "a"))
        with open(self.detections, "w") as file:
            file.write("time,range\n1,2\n")
        self.assertIn("plots.csv:1: has no column t_s", self.refused())

    # If this fails, a slip in a second run destroys the tracks of the first.
    def test_what_cannot_be_done_leaves_the_old_tracks_alone(self):
        with open(self.tracks, "w") as file:
            file.write("precious")
        self.write(plots()[:3])
        self.refused()
        self.refused("--radar", "a")
        self.refused("--radar", "c:6:0")
        self.refused("--radar", "a:6:0", "--params", "none.yaml")
        with open(self.tracks) as file:
            self.assertEqual(file.read(), "precious")

    # If this fails, one damaged line costs hours of empty sectors, or the pictures of centuries.
    def test_a_mad_time_is_named_and_the_rest_is_used(self):
        good, _ = self.track(plots())
        for time in ("1e12", "9e9", "-4e5", "123456.7"):
            rows, said = self.track([f"{time},a,0,50000,45", *plots()])
            self.assertEqual(rows, good)
            self.assertRegex(said, r"plots.csv:2: t_s (is beyond 1e10 s|lies \d+ s from most other plots)")
            self.assertIn("lines refused       1\n", said)
        pictures, _ = self.track([*plots(), "9e9,b,0,50000,45"], "--epochs", "5")
        self.assertEqual(pictures, self.track(plots(), "--epochs", "5")[0])

    # If this fails, the second half of a recording is lost, or its aircraft takes the number of one that has long gone.
    def test_after_an_hours_pause_the_recording_goes_on(self):
        rows, said = self.track(plots() + plots(start=3600))
        self.assertIn("lines refused       0\n", said)
        first, second = ({row[1] for row in rows if row[6] == "firm" and (float(row[0]) > 1800) == later} for later in (False, True))
        self.assertEqual((len(first), len(second)), (1, 1))
        self.assertNotEqual(first, second)

    # If this fails, whoever reads the file gets wrong tracks, or none.
    def test_one_aircraft_is_one_track(self):
        for params in ("default", "nrl7952"):
            rows, said = self.track(plots(), "--params", params)
            self.assertIn("plots used          35", said)
            firm = [row for row in rows if row[6] == "firm"]
            self.assertEqual(len({row[1] for row in firm}), 1)
            self.assertGreater(len(firm), 15)
            self.assertEqual(rows[0][6], "tentative")
            self.assertLessEqual({row[6] for row in rows}, {"tentative", "firm", "coasting"})
            t, x, y, vx, vy = (float(firm[-1][i]) for i in (0, 2, 3, 4, 5))
            self.assertAlmostEqual(x, 60e3 - 150 * t, delta=300)
            self.assertAlmostEqual(y, 20e3 + 120 * t, delta=300)
            self.assertAlmostEqual(vx, -150, delta=20)
            self.assertAlmostEqual(vy, 120, delta=20)
            times = [float(row[0]) for row in rows]
            self.assertLess(max(a - b for a, b in zip(times, times[1:])), 1.0)  # in order, but for beams that cross

    def test_a_track_without_plots_coasts_and_then_says_nothing(self):
        # Another target, far away, keeps the file going for 400 s.
        far = [f"{6 * i + 3:.1f},a,{i},{150e3 + 600 * i:.1f},180.0" for i in range(66)]
        rows = sorted(plots() + far, key=lambda row: float(row.split(",")[0]))
        tracks, _ = self.track(rows, "--params", "nrl7952")
        firm = {row[1] for row in tracks if row[6] == "firm" and float(row[2]) > 10e3}
        self.assertEqual(len(firm), 1)
        own = [row for row in tracks if row[1] in firm]
        self.assertEqual(own[-1][6], "coasting")
        self.assertLess(float(own[-1][0]), 145)

    def test_period_and_phase_are_found_from_the_plots(self):
        clutter = [f"{6 * i + 6 * az / 360:.4f},a,{i},{20e3 + 500 * az:.0f},{az}" for i in range(20)
                   for az in range(5, 360, 30)]
        own = [row for row in plots() if row.split(",")[1] == "a"]
        rows = sorted(own + clutter, key=lambda row: float(row.split(",")[0]))
        _, said = self.track(rows, radars=("a",))
        self.assertRegex(said, r"radar a +period (5\.99|6\.00)")

    @staticmethod
    def fleet(beam, until=240.0):
        """Twelve aircraft as rows (time, range, azimuth); `beam`(turn, azimuth in turns) says when they are met."""
        rows = []
        for k in range(12):
            x, y = 50e3 * math.sin(2.4 * k), (20e3 + 4e3 * k) * math.cos(2.4 * k)
            vx, vy = 150 * math.cos(k), 150 * math.sin(k)
            for turn in range(200):
                t = 0.0
                for _ in range(20):
                    azimuth = math.atan2(x + vx * t, y + vy * t) / math.tau % 1.0
                    t = beam(turn, azimuth)
                if t < until:
                    rows.append((t, math.hypot(x + vx * t, y + vy * t), 360 * azimuth))
        return sorted(rows)

    def picture_of(self, rows):
        """How many tracks become firm and are started, and what was said."""
        _, said = self.track([f"{t:.4f},a,0,{r:.1f},{azimuth:.4f}" for t, r, azimuth in rows], radars=())
        return int(re.search(r"become firm +(\d+)", said)[1]), int(re.search(r"started +(\d+)", said)[1]), said

    # If these fail, hundreds of tracks are started of a dozen aircraft, because the file's times are poor.
    def test_tracks_go_on_over_a_step_of_the_clock(self):
        rows = self.fleet(lambda turn, azimuth: 4 * (turn + azimuth))
        healthy = self.picture_of(rows)
        self.assertEqual(healthy[0], 12)
        for step, words in ((3.0, "put forward by 3.00 s"), (-3.0, "put back by 3.00 s"), (-1.0, "put back by 1.00 s")):
            for at in (60.0, 150.0):
                firm, started, said = self.picture_of(sorted((t + (step if t > at else 0.0), r, a) for t, r, a in rows))
                self.assertEqual((firm, started), healthy[:2], said)
                self.assertIn(words, said)

    def test_times_in_whole_seconds_are_refined(self):
        for period in (2.5, 4.0, 10.0):
            rows = self.fleet(lambda turn, azimuth: period * (turn + azimuth))
            healthy = self.picture_of(rows)
            for rounded in (math.floor, round):
                firm, started, said = self.picture_of([(rounded(t), r, a) for t, r, a in rows])
                self.assertEqual(firm, 12, said)
                self.assertLessEqual(started, healthy[1] + 1, said)
                self.assertIn("radar a: its times are whole steps of 1 s; they are refined by the beam's azimuth\n", said)

    def test_an_antenna_that_scans_to_and_fro_is_refused(self):
        for degrees in (90, 180, 270):
            rows = self.fleet(lambda turn, azimuth: 4 * (turn + (azimuth if turn % 2 == 0 else degrees / 360 - azimuth)))
            self.write([f"{t:.4f},a,0,{r:.1f},{a:.4f}" for t, r, a in rows if a < degrees])
            self.assertRegex(self.refused(), "^adit_csv: radar a: the antenna scans to and fro, at about 90 deg/s: that is not read\n$")
            self.assertIn("to and fro", self.refused("--radar", "a:4:0"))

    def test_radars_that_are_not_named_are_left_out_and_counted(self):
        _, said = self.track(plots(), radars=("a:6:0",))
        self.assertIn("15 plots of radar b", said)
        self.assertIn("lines refused       15", said)

    def test_bad_lines_are_named_and_the_rest_is_used(self):
        _, said = self.track(plots() + ["1,a,0,none,3"])
        self.assertIn("plots.csv:37: range_m 'none' is no number", said)
        self.assertIn("plots used          35", said)

    # If this fails, a radar's Doppler is read and does nothing, or a file with it cannot be read.
    def test_range_rates_are_used_where_a_parameter_file_says_so(self):
        rows = []
        for row in plots():
            t = float(row.split(",")[0])
            x, y = 60e3 - 150 * t, 20e3 + 120 * t
            rows.append(f"{row},{(-150 * x + 120 * y) / math.hypot(x, y):.2f}")
        with open(self.detections, "w") as file:
            file.write("t_s,radar,scan,range_m,az_deg,range_rate_mps\n" + "".join(row + "\n" for row in rows))
        parameters = os.path.join(self.folder.name, "doppler.yaml")
        with open(parameters, "w") as file:
            file.write("radars: [{name: a, range_rate_sigma_mps: 2}, {name: b, range_rate_sigma_mps: 2}]\n")
        files = ["--detections", self.detections, "--tracks", self.tracks, "--radar", "a:6:0", "--radar", "b:8:0"]
        done = self.start(*files)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("range_rate_mps is not used: no radar has range_rate_sigma_mps", done.stderr)
        done = self.start(*files, "--params", parameters)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("range_rate_mps", done.stderr)
        with open(self.tracks) as file:
            first = next(csv.DictReader(file))
        x, y, vx, vy = (float(first[key]) for key in ("x_m", "y_m", "vx_mps", "vy_mps"))
        rate = [float(row.split(",")[-1]) for row in rows][0]
        self.assertAlmostEqual((x * vx + y * vy) / math.hypot(x, y), rate, delta=1.0)

    # If this fails, a picture is made from plots that come later: no real-time system could have made it.
    def test_epochs_use_only_what_was_there(self):
        whole, _ = self.track(plots(), "--epochs", "5")
        self.assertEqual({row[6] for row in whole} - {"firm", "coasting"}, set())
        times = [float(row[0]) for row in whole]
        self.assertTrue(all(t % 5 == 0 for t in times))
        self.assertGreater(len(times), 12)
        for row in whole:
            self.assertAlmostEqual(float(row[2]), 60e3 - 150 * float(row[0]), delta=400)
        cut = [row for row in plots() if float(row.split(",")[0]) <= 80]
        until, _ = self.track(cut, "--epochs", "5")
        last = max(float(row[0]) for row in until)
        self.assertEqual(last, 80)
        self.assertEqual([row for row in until if float(row[0]) < last], [row for row in whole if float(row[0]) < last])

    # If this fails, a score of the picture misses all targets at the end.
    def test_the_last_epoch_is_the_one_after_the_last_plot(self):
        rows, _ = self.track([row for row in plots() if float(row.split(",")[0]) <= 97], "--epochs", "5")
        self.assertEqual(float(rows[-1][0]), 100)
        self.assertAlmostEqual(float(rows[-1][2]), 60e3 - 150 * 100, delta=400)
        rows, _ = self.track([row for row in plots() if float(row.split(",")[0]) <= 97], "--epochs", "60")
        self.assertEqual(float(rows[-1][0]), 60)

    # Other trackers' files have all plots of a scan at one time. If this fails, nothing is tracked and nobody is told.
    def test_snapshots_are_tracked_as_such(self):
        rows = []
        for scan in range(1, 21):
            for target in range(6):
                x, y = 20e3 + 180 * 6 * scan * math.sin(target), 30e3 * (target - 2.5) + 180 * 6 * scan * math.cos(target)
                rows.append(f"{6 * scan},a,{scan},{math.hypot(x, y):.1f},{math.degrees(math.atan2(x, y)) % 360:.4f}")
        for radars in ((), ("a:6:0",)):
            pictures, said = self.track(rows, "--epochs", "6", radars=radars)
            self.assertIn("all plots of a scan have one time, each 6 s", said)
            last = [row for row in pictures if float(row[0]) == 120]
            self.assertEqual(len(last), 6)
            for target in range(6):
                x, y = 20e3 + 180 * 120 * math.sin(target), 30e3 * (target - 2.5) + 180 * 120 * math.cos(target)
                self.assertLess(min(math.hypot(float(row[2]) - x, float(row[3]) - y) for row in last), 150)

    def test_the_covariance_comes_when_it_is_asked_for(self):
        self.write(plots())
        done = self.start("--detections", self.detections, "--tracks", self.tracks, "--covariance", "--epochs", "10",
                          "--radar", "a:6:0", "--radar", "b:8:0")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.tracks) as file:
            lines = file.read().splitlines()
        self.assertEqual(lines[0].split(",")[:8], "t_s,track_id,x_m,y_m,vx_mps,vy_mps,status,cov_x_x".split(","))
        self.assertTrue(all(0 < float(line.split(",")[7]) < 1e6 for line in lines[1:]))

    # If this fails, nobody finds out which track took an aircraft's plot, and why.
    def test_what_became_of_each_plot_comes_when_it_is_asked_for(self):
        fates = os.path.join(self.folder.name, "fates.csv")
        rows, _ = self.track(plots(), "--plots", fates)
        with open(fates) as file:
            lines = [line.split(",") for line in file.read().splitlines()]
        self.assertEqual(lines[0], "t_s,radar,range_m,az_deg,fate,track_id,chance_false,claims".split(","))
        self.assertEqual(sorted(line[:2] + line[2:4] for line in lines[1:]),
                         sorted([t, radar, r, a] for t, radar, _, r, a in (row.split(",") for row in plots())))
        updates = {(row[0], row[1]) for row in rows}
        self.assertEqual({line[4] for line in lines[1:]}, {"started", "updated"})
        for line in lines[1:]:
            self.assertIn((line[0], line[5]), updates)
            if line[4] == "updated":
                uid, chance, sigmas = line[7].split(" ")[0].split(":")
                self.assertEqual(uid, line[5])
                self.assertGreater(float(chance), 0.9)
                self.assertLess(float(sigmas), 5)

    @staticmethod
    def voyage(turning=True, until=200.0):
        """What a radar on a ship at 8 m/s sees (the ship's own track, plots from the bow, boats): six boats and twelve rocks."""
        course = (lambda t: 0.8 * math.sin(t / 20)) if turning else (lambda t: 0.0)
        ship, x, y = [], 0.0, 0.0
        for i in range(int(until) + 2):
            ship.append((float(i), x, y, course(i)))
            for k in range(10):
                x, y = x + 0.8 * math.sin(course(i + k / 10)), y + 0.8 * math.cos(course(i + k / 10))

        def pose(t):
            (_, x0, y0, h0), (_, x1, y1, h1) = ship[int(t)], ship[int(t) + 1]
            f = t - int(t)
            return x0 + f * (x1 - x0), y0 + f * (y1 - y0), h0 + f * (h1 - h0)

        boats = [(900 * math.cos(k), 800 + 900 * math.sin(k), 6 * math.cos(2.3 * k), 6 * math.sin(2.3 * k)) for k in range(6)]
        rocks = [(1300 * math.cos(0.5 * k), 700 + 1300 * math.sin(0.5 * k), 0.0, 0.0) for k in range(12)]
        rows, noise = [], 0
        for boat_x, boat_y, vx, vy in boats + rocks:
            for turn in range(int(until / 2.5)):
                t = 2.5 * turn
                for _ in range(20):
                    own_x, own_y, heading = pose(min(t, until))
                    east, north = boat_x + vx * t - own_x, boat_y + vy * t - own_y
                    t = 2.5 * (turn + (math.atan2(east, north) - heading) / math.tau % 1.0)
                if t < until:
                    noise = noise * 7 % 11 + 1  # without two the same in a row, nor a mean
                    azimuth = math.degrees(math.atan2(east, north) - heading) + 0.05 * (noise - 6)
                    rows.append((t, math.hypot(east, north) + noise - 6, azimuth % 360))
        return ship, [f"{t:.4f},a,0,{r:.2f},{azimuth:.4f}" for t, r, azimuth in sorted(rows)], boats

    def sail(self, ship, rows, *arguments, columns="t_s,x_m,y_m,heading_deg"):
        path = os.path.join(self.folder.name, "own.csv")
        with open(path, "w") as file:
            file.write("\n".join([columns, *ship, ""]))
        self.write(rows)
        return self.start("--detections", self.detections, "--tracks", self.tracks, "--own-ship", path, "--params", "marine", *arguments)

    def check_boats(self, boats, until=200.0):
        with open(self.tracks) as file:
            rows = [line.split(",") for line in file.read().splitlines()[1:]]
        last = {row[1]: [float(value) for value in row[2:6]] for row in rows if float(row[0]) == until - 5}
        self.assertEqual(len(last), len(boats), last)
        for x, y, vx, vy in boats:
            at = (x + vx * (until - 5), y + vy * (until - 5))
            near = min(last.values(), key=lambda track: math.dist(track[:2], at))
            self.assertLess(math.dist(near[:2], at), 25)
            self.assertLess(math.dist(near[2:], (vx, vy)), 1.5)

    # If this fails, a ship's recording gives tracks that turn and drift with the ship, and one of each rock.
    def test_plots_of_a_ship_that_moves_and_turns_give_tracks_over_ground(self):
        ship, rows, boats = self.voyage()
        in_metres = [f"{t},{x:.3f},{y:.3f},{math.degrees(h):.4f}" for t, x, y, h in ship]
        done = self.sail(in_metres, rows, "--epochs", "5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("has headings: azimuths are taken to be told from the bow", done.stderr)
        self.check_boats(boats)
        ship, rows, boats = self.voyage(turning=False)
        in_degrees = [f"{t},{60 + y / 111412.9:.8f},{5 + x / 55800.0:.8f}" for t, x, y, _ in ship]
        done = self.sail(in_degrees, rows, "--epochs", "5", columns="t_s,lat_deg,lon_deg")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("positions are east and north of latitude 60.0000000 deg, longitude 5.0000000 deg", done.stderr)
        self.check_boats(boats)

    # If this fails, a slip in own ship's file gives wrong tracks and status 0.
    def test_a_bad_file_of_own_ship_is_named(self):
        ship, rows, _ = self.voyage()
        good = [f"{t},{x:.3f},{y:.3f},{math.degrees(h):.4f}" for t, x, y, h in ship]
        done = self.sail(good[:50] + ["60,nan,0,0", "60,0,0"] + good[90:], rows)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("own.csv:52: x_m", done.stderr)
        self.assertRegex(done.stderr, "own ship refused +2 lines\nown ship unknown +in 9.. sectors, with [0-9]+ plots")
        for lines, names, said in ((good, "t", "t_s"), (good[:1], "t_s", "needs two or more usable places"),
                                   (["1e6,0,0,0", "1000001,0,0,0"], "t_s", "the times of both files must be of one clock")):
            done = self.sail(lines, rows, columns=names + ",x_m,y_m,heading_deg")
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr.splitlines()[-1], f"^adit_csv: .*own.csv.*{said}")
        done = self.sail(good, rows, "--clutter-map", "map.csv")
        self.assertEqual((done.returncode, done.stderr), (2, "adit_csv: a clutter map is of one place: not with --own-ship\n"))

    # If this fails, a boat of a real radar on a vessel has no track.
    def test_a_recording_made_on_a_vessel(self):
        here = os.path.dirname(os.path.abspath(__file__))
        folder = os.path.join(here, "vessel_recording")
        done = self.start("--detections", f"{folder}/plots.csv", "--tracks", self.tracks, "--own-ship", f"{folder}/own_ship.csv",
                          "--params", os.path.join(here, "..", "config", "marine.yaml"), "--epochs", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.tracks) as file:
            places = collections.defaultdict(list)
            for row in csv.DictReader(file):
                places[int(float(row["t_s"]))].append((float(row["x_m"]), float(row["y_m"])))
        with open(f"{folder}/truth.csv") as file:
            truth = [(int(row["t_s"]), (float(row["x_m"]), float(row["y_m"]))) for row in csv.DictReader(file) if int(row["t_s"]) >= 10]
        seen = sum(any(math.dist(place, boat) < 30 for place in places[t]) for t, boat in truth)
        self.assertGreater(seen / len(truth), 0.75)

    def test_both_results_cannot_be_one_file(self):
        self.write(plots())
        same = f"{self.folder.name}/./tracks.csv"
        for option, path in (("--plots", self.tracks), ("--plots", same), ("--save-clutter-map", self.tracks)):
            done = self.start("--detections", self.detections, "--tracks", self.tracks, option, path)
            self.assertEqual((done.returncode, done.stderr), (2, f"adit_csv: --tracks and {option} name the same file\n"))

    # If this fails, files whose time is that of the day or of the epoch 1970 take hours.
    def test_epochs_begin_with_the_plots(self):
        rows, _ = self.track(plots(start=1599999984), "--epochs", "5", radars=("a:6:0", "b:8:0"))
        self.assertGreater(len(rows), 12)
        self.assertGreater(float(rows[0][0]), 1599999984)

    def test_the_same_input_gives_the_same_bytes(self):
        first, _ = self.track(plots())
        second, _ = self.track(plots())
        self.assertEqual(first, second)

    def test_at_capacity_tracks_are_refused_and_counted(self):
        _, said = self.track(plots(), "--capacity", "2", "--params", "nrl7952")
        self.assertRegex(said, r"tracks refused +\d+ \(capacity 2\)")


if __name__ == "__main__":
    unittest.main()
