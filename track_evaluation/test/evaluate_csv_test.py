#!/usr/bin/env python3
"""evaluate_csv on files: evaluate_csv_test.py PATH_OF_EVALUATE_CSV. The comparison needs the folder that TWS_SHARED names."""
import csv
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
SHARED = os.environ.get("TWS_SHARED", "")


def evaluate(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300)


def imperfect_tracks(truth_file, tracks_file, seed, step=1.0):
    """Tracks as a middling tracker makes them of this truth: late, noisy, with gaps, new numbers, doubles and ghosts."""
    chance = random.Random(seed)
    with open(truth_file) as file:
        rows = [[float(value) for value in row] for row in list(csv.reader(file))[1:]]
    numbers, next_number = {}, 1000
    with open(tracks_file, "w") as file:
        print("t_s,track_id,x_m,y_m,vx_mps,vy_mps", file=file)
        for t, truth, x, y, vx, vy in rows:
            if truth not in numbers or chance.random() < 0.02:
                numbers[truth], next_number = next_number, next_number + 1
            for number in [numbers[truth]] + [numbers[truth] + 500000] * (chance.random() < 0.05):
                if chance.random() < 0.1:
                    continue
                place = [chance.gauss(value, sigma) for value, sigma in ((x, 300), (y, 300), (vx, 10), (vy, 10))]
                print(t * step, number, *place, sep=",", file=file)
            if chance.random() < 0.02:
                print(t, next_number + 900000, chance.uniform(-1e5, 1e5), chance.uniform(-1e5, 1e5), 0, 0, sep=",", file=file)
                next_number += 1


class EvaluateCsv(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    # If this fails, our figures cannot be set beside those of others.
    @unittest.skipUnless(SHARED, "TWS_SHARED is not set")
    def test_its_metrics_are_those_of_the_independent_scorer(self):
        scorer = f"{SHARED}/bench/score.py"
        tracks, ours_file = self.folder / "tracks.csv", self.folder / "ours.json"
        cases = [(name, seed, options) for name in ("n10", "n60") for seed in (1, 2) for options in ([], ["--resample", "7"])]
        for name, seed, options in cases:
            with self.subTest(name=name, seed=seed, options=options):
                truth = f"{SHARED}/bench/{name}/truth.csv"
                imperfect_tracks(truth, tracks, seed)
                done = subprocess.run([sys.executable, scorer, truth, str(tracks), "--json", *options], stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE, text=True, timeout=300)
                if "No module named" in done.stderr:
                    self.skipTest("the scorer needs numpy and scipy")
                theirs = json.loads(done.stdout)
                done = evaluate("--truth", truth, "--tracks", tracks, "--json", ours_file, *options)
                self.assertEqual(done.returncode, 0, done.stderr)
                ours = json.loads(ours_file.read_text())["trackers"]["tracks"]["metrics"]
                self.assertGreater(theirs["swaps"], 0)
                for metric, value in theirs.items():
                    self.assertTrue(math.isclose(ours[metric], value, rel_tol=1e-9, abs_tol=1e-9),
                                    f"{metric}: ours {ours[metric]}, theirs {value}")

    def test_the_same_files_give_the_same_bytes(self):
        truth = self.write("truth.csv", "t_s,truth_id,x_m,y_m,vx_mps,vy_mps\n" + "".join(
            f"{60 + t},{i},{1000 * i + 100 * t},{500 * i},100,0\n" for t in range(20) for i in range(8)))
        tracks = self.folder / "tracks.csv"
        imperfect_tracks(truth, tracks, 3)
        outputs = []
        for name in ("a.json", "b.json"):
            self.assertEqual(evaluate("--truth", truth, "--tracks", tracks, "--json", self.folder / name).returncode, 0)
            outputs.append((self.folder / name).read_bytes())
        self.assertEqual(outputs[0], outputs[1])

    def test_bad_input_is_one_line_and_a_status(self):
        good = self.write("good.csv", "t_s,id,x_m,y_m,vx_mps,vy_mps\n60,1,0,0,0,0\n")
        bad = self.write("bad.csv", "t_s,id,x_m,y_m,vx_mps,vy_mps\n60,1,zero,0,0,0\n")
        other = self.write("other.csv", "t_s,id,x_m,y_m,vx_mps,vy_mps\n61,1,0,0,0,0\n")
        twice = self.write("twice.csv", "t_s,id,x_m,y_m,vx_mps,vy_mps\n60,1,0,0,0,0\n60,1,9,0,0,0\n")
        early = self.write("early.csv", "t_s,id,x_m,y_m,vx_mps,vy_mps\n6,1,0,0,0,0\n")
        empty = self.write("empty.csv", "")
        for truth, tracks, word in [(good, bad, "bad.csv:2"), (good, other, "61"), (good, twice, "twice"), (early, early, "no epoch"),
                                    (empty, good, "empty"), (good, "/nowhere.csv", "/nowhere.csv")]:
            with self.subTest(word):
                done = evaluate("--truth", truth, "--tracks", tracks)
                self.assertEqual(done.returncode, 1)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn(word, done.stderr)
        self.assertEqual(evaluate("--truth", good).returncode, 2)
        self.assertEqual(evaluate("--truth", good, "--tracks", good, "--order", "0").returncode, 2)


if __name__ == "__main__":
    unittest.main()
