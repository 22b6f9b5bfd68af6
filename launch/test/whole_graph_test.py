#!/usr/bin/env python3
"""The graph as a whole: one scenario live, replayed and offline must give the same tracks, byte by byte but for header.seq.

Whoever evaluates a tracker offline, or looks into a recorded incident, relies on that.
"""
import pathlib
import random
import subprocess
import tempfile
import unittest

import rosbag
import rospy
import rosunit
import yaml

from graph_test_kit import check_same, in_time, late, launch_line
from graph_test_kit import message_bytes as tracks

SCENARIO = "full"
DURATION = 30  # of data time [s]: long enough for firm tracks, coasts and drops
RADARS = ["sps12", "sps39"]
SENSOR_TOPICS = [f"/{radar}/{kind}" for radar in RADARS for kind in ("detections", "sector_marks")]
SENSOR_TOPICS += ["/ssr/plots", "/ssr/sector_marks", "/esa/dwell_reports", "/mrs/range_profile"]
TRACK_TOPICS = ["/adit/tracks", "/ssr/tracks", "/correlated/tracks", "/tws/tracks", "/esa/frames", "/esa/tracks", "/esa/track_database",
                "/mrs/range_gate", "/mrs/tracks"]
WINDOWS = "{window_tracker: {radar: sps12}}"  # what the scenario says, for bags without a description


def command(*words):
    """Runs a command to its good end and returns what it printed."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
    return good_end(words, done.returncode, done.stdout)


def good_end(words, status, said):
    if status != 0 or "process has died" in said:
        raise AssertionError(f"{' '.join(map(str, words))} failed:\n{said}")
    return said


def launch(file, record, rate, **arguments):
    """A run or a replay, slower where this machine is too busy for the rate."""
    def at(rate):
        command(*launch_line(file, record, rate=rate, **arguments))
        return record
    return in_time(at, rate)


def launch_beside(work, record, rate, **arguments):
    """A run in which somebody works: what work() gave."""
    answers = []

    def at(rate):
        words = launch_line("run.launch", record, rate=rate, **arguments)
        with tempfile.TemporaryFile("w+", encoding="utf8") as said:
            run = subprocess.Popen(words, stdout=said, stderr=subprocess.STDOUT)
            try:
                answers.append(work())
                run.wait(120)
            finally:
                run.terminate()
                run.wait()
            said.seek(0)
            good_end(words, run.returncode, said.read())
        return record

    in_time(at, rate)
    return answers[-1]


def offline(source, folder, *options):
    command("rosrun", "tws_launch", "tws_offline", source, "--out", folder, *options)
    return folder / "run.bag"


def publications(bag):
    """Who publishes what: topic, type, node."""
    with rosbag.Bag(str(bag)) as opened:
        connections = [(c.topic, c.datatype, c.header["callerid"]) for c in opened._get_connections()]
    return {connection for connection in connections if connection[0] not in ("/diagnostics", "/tf_static")}


def shuffled(source, target, seed):
    """A copy in which each sensor topic arrives late by an amount of its own, below the trackers' limit of a second; however late it
    was in the live run on a busy machine."""
    delays = random.Random(seed)
    delay = {topic: rospy.Duration(delays.uniform(0.0, 0.4)) for topic in SENSOR_TOPICS}
    with rosbag.Bag(str(source)) as recorded, rosbag.Bag(str(target), "w") as out:
        for topic, message, time in recorded.read_messages(SENSOR_TOPICS + ["/tf_static", "/graph"]):
            out.write(topic, message, message.header.stamp + delay[topic] if topic in delay else time)
    return target


class WholeGraphTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="whole_graph_"))
        cls.live = launch("run.launch", cls.folder / "live.bag", scenario=SCENARIO, rate=5, duration=DURATION)

    @classmethod
    def tearDownClass(cls):
        command("rm", "-rf", cls.folder)

    def check_same_tracks(self, bag, run):
        self.assertEqual(late(bag), {}, f"{run}: this machine was too slow for the comparison")
        for topic in TRACK_TOPICS:
            check_same(tracks(self.live, topic), tracks(bag, topic), f"{run}, {topic}")

    def test_the_live_run_has_firm_tracks_and_loses_nothing(self):
        self.assertEqual(late(self.live), {}, "this machine was too slow for the test")
        with rosbag.Bag(str(self.live)) as bag:
            messages = [message for _, message, _ in bag.read_messages(["/adit/tracks"])]
            for radar, period in (("sps12", 6.0), ("sps39", 8.0)):
                self.assertAlmostEqual(bag.get_message_count(f"/{radar}/detections"), 64 * DURATION / period, delta=1)
            plots = [message for _, message, _ in bag.read_messages(["/ssr/plots"])]
            self.assertAlmostEqual(len(plots), 64 * DURATION / 6.0, delta=1)
            self.assertEqual(bag.get_message_count("/ssr/sector_marks"), len(plots))
            self.assertTrue(any(plot.mode_3a != plot.CODE_UNKNOWN for message in plots for plot in message.plots))
        self.assertEqual([m.sequence for m in messages], list(range(len(messages))))
        self.assertTrue(any(track.state == track.FIRM for m in messages for track in m.tracks))

    def test_the_tracks_say_who_answers_the_secondary_radar(self):
        """95 of 100 aircraft of the scenario do, boats do not."""
        with rosbag.Bag(str(self.live)) as bag:
            messages = [message for _, message, _ in bag.read_messages(["/adit/tracks"])]
        late_words = [t for m in messages[2 * len(messages) // 3:] for t in m.tracks if t.state == t.FIRM]
        answering = sum(t.detection_bits & t.DETECTED_BY_IFF != 0 for t in late_words) / len(late_words)
        self.assertTrue(0.7 < answering < 1.0, answering)

    def test_position_and_codes_come_together_over_the_whole_chain(self):
        """SSR and SPS-12, secondary tracker and ADIT, correlator: each aircraft under one identity, with the code that it replies."""
        live = launch("run.launch", self.folder / "chain.bag", scenario=SCENARIO, rate=10, duration=60)  # Pairs need some turns.
        with rosbag.Bag(str(live)) as bag:
            updates = [update for _, message, _ in bag.read_messages(["/correlated/tracks"]) for update in message.tracks]
            codes = {target.mode_3a for _, message, _ in bag.read_messages(["/truth"]) for target in message.targets}
        correlated = [update for update in updates if update.kind == update.CORRELATED]
        self.assertGreater(len({update.identity for update in correlated}), 10)
        known = [update.track.mode_3a for update in correlated if update.track.mode_3a != update.track.CODE_UNKNOWN]
        self.assertTrue(known)
        self.assertLessEqual(set(known), codes)
        for update in updates:
            self.assertEqual(update.primary != update.NONE, update.kind != update.SECONDARY_ONLY)
            self.assertEqual(update.secondary != update.NONE, update.kind != update.PRIMARY_ONLY)

    def test_tracks_that_a_scenario_feeds_are_correlated_alike_live_and_offline(self):
        file = f"{command('rospack', 'find', 'tws_launch').strip()}/scenarios/bel_three_targets.yaml"
        live = launch("run.launch", self.folder / "fed.bag", scenario="bel_three_targets", rate=10, duration=30)
        bags = {"offline": offline(file, self.folder / "fed_offline", "--duration", 30),
                "offline from the bag": offline(live, self.folder / "fed_again")}
        for run, bag in bags.items():
            for topic in ("/primary/tracks", "/secondary/tracks", "/correlated/tracks"):
                check_same(tracks(live, topic), tracks(bag, topic), f"{run}, {topic}")
        identities = {}
        for _, message, _ in rosbag.Bag(str(live)).read_messages(["/correlated/tracks"]):
            for update in message.tracks:
                if update.kind == update.CORRELATED:
                    identities.setdefault(update.primary, set()).add((update.identity, update.track.mode_3a))
        self.assertEqual(sorted(len(names) for names in identities.values()), [1, 1, 1])

    def test_the_array_radar_is_steered_by_its_tracker(self):
        """The loop is closed: dwells on tracks, of which there are firm ones; each report is answered."""
        with rosbag.Bag(str(self.live)) as bag:
            reports = [message for _, message, _ in bag.read_messages(["/esa/dwell_reports"])]
            answers = [message.header.stamp for _, message, _ in bag.read_messages(["/esa/track_database"])]
            firm = {track.uid for _, message, _ in bag.read_messages(["/esa/tracks"])
                    for track in message.tracks if track.state == track.FIRM}
        self.assertEqual(len(reports), 10 * DURATION)
        self.assertEqual(answers, [message.header.stamp for message in reports][:len(answers)])
        self.assertGreaterEqual(len(answers), len(reports) - 1)
        self.assertGreaterEqual(len(firm), 8, "the formation alone has eight")
        expected = {number for message in reports for dwell in message.dwells if dwell.is_track_dwell
                    for number in dwell.dwell_group_indices}
        self.assertTrue(firm & expected)

    def test_an_offline_run_of_the_scenario_gives_the_same_tracks(self):
        bag = offline(f"{command('rospack', 'find', 'tws_launch').strip()}/scenarios/{SCENARIO}.yaml", self.folder / "offline",
                      "--duration", DURATION)
        self.check_same_tracks(bag, "offline from the scenario")
        check_same(*(tracks(of, "/esa/dwell_reports") for of in (self.live, bag)), "offline from the scenario, /esa/dwell_reports")
        self.assertEqual(publications(bag), publications(self.live))

    def test_nodelets_of_one_manager_give_the_same_tracks(self):
        bag = launch("run.launch", self.folder / "nodelets.bag", scenario=SCENARIO, rate=5, duration=DURATION, nodelets="true")
        self.check_same_tracks(bag, "as nodelets")

    def test_in_a_namespace_the_same_radars_are_tracked_there(self):
        bag = self.folder / "space.bag"
        command("roslaunch", "--no-summary", "tws_launch", "run.launch", f"record:={bag}", "rviz:=false", "scenario:=one_aircraft",
                "rate:=10", "duration:=30", "__ns:=siteA")
        with rosbag.Bag(str(bag)) as opened:
            topics = opened.get_type_and_topic_info().topics
        self.assertGreater(topics["/siteA/adit/tracks"].message_count, 500)
        self.assertGreater(topics["/siteA/sps12/detections"].message_count, 250)
        self.assertNotIn("/adit/tracks", topics)

    def test_an_offline_run_of_the_bag_gives_the_same_tracks(self):
        bag = offline(self.live, self.folder / "offline_bag")
        self.check_same_tracks(bag, "offline from the bag")

    def test_a_replay_at_recorded_speed_gives_the_same_tracks(self):
        self.check_same_tracks(launch("replay.launch", self.folder / "slow.bag", bag=self.live, rate=1), "replay")

    def test_the_range_gate_follows_its_target_in_closed_loop(self):
        """The visitor flies at 150 m/s: without commands it would have left the first gate after four seconds."""
        with rosbag.Bag(str(self.live)) as bag:
            profiles = [message for _, message, _ in bag.read_messages(["/mrs/range_profile"])]
            gates = {message.header.stamp: message for _, message, _ in bag.read_messages(["/mrs/range_gate"])}
        self.assertAlmostEqual(len(profiles), 25 * DURATION, delta=2)
        self.assertLess(profiles[-1].range_min, profiles[0].range_min - 150 * 0.9 * (DURATION - 2))
        locked = [gates[p.header.stamp].lock != 0 for p in profiles[25:] if p.header.stamp in gates]
        self.assertGreater(len(locked), 20 * DURATION)
        self.assertGreater(sum(locked) / len(locked), 0.95)
        # The simulated radar executes after its latency of 0.1 s, at the third profile.
        for before, after in zip(profiles[:100], profiles[3:103]):
            self.assertAlmostEqual(after.range_min, gates[before.header.stamp].range_min, delta=1.01)  # half a bin

    def test_a_replay_at_ten_times_the_speed_gives_the_same_tracks(self):
        self.check_same_tracks(launch("replay.launch", self.folder / "fast.bag", bag=self.live, rate=10), "fast replay")

    def test_a_replay_of_limited_duration_ends_there(self):
        bag = launch("replay.launch", self.folder / "short.bag", bag=self.live, rate=10, duration=10)
        with rosbag.Bag(str(bag)) as opened:
            stamps = [m.header.stamp.to_sec() for _, m, _ in opened.read_messages(["/sps12/detections"])]
        self.assertAlmostEqual(max(stamps) - min(stamps), 10, delta=0.5)

    def test_topics_that_interleave_differently_give_the_same_tracks(self):
        for seed in range(5):
            bag = shuffled(self.live, self.folder / f"shuffled{seed}.bag", seed)
            self.check_same_tracks(offline(bag, self.folder / f"shuffled{seed}", "--trackers", WINDOWS),
                                   f"shuffled with seed {seed}, offline")
        self.check_same_tracks(launch("replay.launch", self.folder / "shuffled.bag", bag=bag, rate=5, trackers=WINDOWS),
                               "shuffled, replayed")

    def test_the_offline_graph_is_what_roslaunch_starts(self):
        """Nodes and private parameters, compared with roslaunch's own dump of the launch file."""
        options = ["rviz:=false", "rate:=5"]
        described = yaml.safe_load(command("rosrun", "tws_launch", "tws_inspect", SCENARIO, *options))["nodes"]
        file = self.folder / "graph.launch"
        file.write_text(command("rosrun", "tws_launch", "tws_inspect", "launch", SCENARIO, *options))
        self.assertEqual(sorted("/" + node["name"] for node in described), sorted(command("roslaunch", "--nodes", file).split()))
        dumped = yaml.safe_load(command("roslaunch", "--dump-params", file))

        def flat(prefix, tree):
            if not isinstance(tree, dict):
                return {prefix: tree}
            return {key: value for name, branch in tree.items() for key, value in flat(f"{prefix}/{name}", branch).items()}

        parameters = {}
        for node in described:
            parameters.update(flat("/" + node["name"], node.get("parameters", {})))
        self.assertEqual(parameters, {key: value for key, value in dumped.items() if key.count("/") > 1})

    def test_launch_files_are_plain(self):
        """Whoever opens one, or asks for its arguments, understands it."""
        folder = pathlib.Path(command("rospack", "find", "tws_launch").strip())
        for file in sorted(folder.glob("*.launch")):
            text = file.read_text()
            self.assertLess(max(map(len, text.splitlines())), 140, file)
            self.assertNotIn("eval", text, file)
            arguments = command("roslaunch", "--ros-args", file)
            self.assertNotIn("undocumented", arguments.lower(), file)
            self.assertEqual("Required Arguments" in arguments, file.name == "replay.launch", arguments)


if __name__ == "__main__":
    rosunit.unitrun("tws_launch", "whole_graph_test", WholeGraphTest)
