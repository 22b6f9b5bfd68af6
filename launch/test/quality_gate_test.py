#!/usr/bin/env python3
"""The trackers' quality on the standard scenarios: quality_gate_test.py PATH_OF_TWS_OFFLINE

Limits, and the distributions that they rest on, stand in quality.yaml. If this fails, a change made the tracker worse by more than chance.
With --measure N instead of the tests: prints the distributions over N seeds, to be reviewed and written there.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import unittest

import yaml

HERE = pathlib.Path(__file__).resolve().parent
SCENARIOS = yaml.safe_load((HERE / "quality.yaml").read_text())["scenarios"]


def damaged_parameters(folder):
    """The tracker's default parameters with gates of half the size. That of a hard manoeuvre, which would make up for it, is off."""
    config = subprocess.run(["rospack", "find", "adit_tracker"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
    tree = yaml.safe_load(pathlib.Path(config, "config", "default.yaml").read_text())
    tree["gate_sigmas"] /= 2
    tree["turning"]["manoeuvre_acceleration"] = 0.0
    path = pathlib.Path(folder, "halved.yaml")
    path.write_text(yaml.safe_dump(tree))
    return str(path)


def fly(scenario, seed, params="default"):
    """The metrics of one run."""
    with tempfile.TemporaryDirectory() as folder:
        bag, metrics = pathlib.Path(folder, "run.bag"), pathlib.Path(folder, "metrics.json")
        file = HERE.parent / "scenarios" / f"{scenario}.yaml"
        for words in ([OFFLINE, file, "--seed", seed, "--out", folder, "--params", params],
                      ["rosrun", "track_evaluation", "evaluate_bag", bag, "--quiet", "--json", metrics]):
            subprocess.run([str(word) for word in words], check=True, timeout=300, stdout=subprocess.DEVNULL)
        return json.loads(metrics.read_text())["trackers"]["adit"]["metrics"]


def outside(metrics, limits):
    """In words, each metric that is not within its limits."""
    found = []
    for name, limit in limits.items():
        value = metrics[name]
        if value is None or value < limit.get("least", value) or value > limit.get("most", value):
            found.append(f"{name} is {value}, limits are {({key: limit[key] for key in ('least', 'most') if key in limit})}")
    return found


class QualityGate(unittest.TestCase):
    def test_every_standard_scenario_is_within_its_limits(self):
        for scenario, entry in SCENARIOS.items():
            for seed in entry["gate_seeds"]:
                with self.subTest(scenario=scenario, seed=seed):
                    self.assertEqual(outside(fly(scenario, seed), entry["limits"]), [])

    def test_a_tracker_with_gates_of_half_the_size_does_not_pass(self):
        entry = SCENARIOS["adit_nominal"]
        with tempfile.TemporaryDirectory() as folder:
            damaged = damaged_parameters(folder)
            found = [outside(fly("adit_nominal", seed, damaged), entry["limits"]) for seed in entry["gate_seeds"]]
        self.assertTrue(any(found), "the gate does not notice that the tracker is damaged")


def measure(seeds):
    for scenario, entry in SCENARIOS.items():
        runs = [fly(scenario, seed) for seed in range(1, seeds + 1)]
        print(f"{scenario}: seeds 1 to {seeds}")
        for name in entry["limits"]:
            values = [run[name] for run in runs]
            print(f"  {name}: {{mean: {statistics.mean(values):.4g}, sd: {statistics.stdev(values):.2g}, "
                  f"least: {min(values):.4g}, greatest: {max(values):.4g}}}", flush=True)


if __name__ == "__main__":
    OFFLINE = sys.argv.pop(1)
    if sys.argv[1:2] == ["--measure"]:
        measure(int(sys.argv[2]))
    else:
        unittest.main()
