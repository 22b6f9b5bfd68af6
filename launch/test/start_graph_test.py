#!/usr/bin/env python3
"""What start_graph does when something is in its way: another graph, a full disk, a killed recorder, a tracker that stands, odd names."""
import contextlib
import os
import pathlib
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import xmlrpc.client

import rosbag
import rosgraph

from graph_test_kit import free_port

ODD = "it's \"two\nlines\" & März $HOME -x"


def wait(what, seconds=60):
    end = time.time() + seconds
    while not what():
        if time.time() > end:
            raise AssertionError("waited in vain")
        time.sleep(0.1)


class StartGraph(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.uri = f"http://localhost:{free_port()}"
        self.environment = {**os.environ, "ROS_MASTER_URI": self.uri, "ROS_LOG_DIR": temporary.name, "ROS_HOSTNAME": "localhost"}
        self.master = rosgraph.Master("/start_graph_test", master_uri=self.uri)

    def started(self, *words, before=()):
        process = subprocess.Popen([*before, "rosrun", "tws_launch", "start_graph", *map(str, words)], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=self.environment)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        process.terminate()
        process.wait(60)
        process.stdout.close()

    def pid(self, node):
        with contextlib.suppress(OSError, rosgraph.MasterException):
            with xmlrpc.client.ServerProxy(self.master.lookupNode(node)) as proxy:
                return proxy.getPid("/start_graph_test")[2]
        return None

    def roscore(self):
        core = subprocess.Popen(["roscore", "-p", self.uri.rsplit(":", 1)[1]], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                env=self.environment, text=True)
        self.addCleanup(self.end, core)
        wait(self.master.is_online)

    # If this fails, a second run kills the first one's trackers, or leaves its clock to whoever comes next.
    def test_another_graph_lives_on_and_gets_its_parameters_back(self):
        self.roscore()
        self.master.setParam("/use_sim_time", False)
        first = self.started("one_aircraft", "rate:=2", "rviz:=false")
        wait(lambda: self.pid("/adit"))
        tracker = self.pid("/adit")
        self.assertTrue(self.master.getParam("/use_sim_time"))
        second = subprocess.run(["rosrun", "tws_launch", "start_graph", "one_aircraft", "rviz:=false"], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, env=self.environment, text=True, timeout=60, check=False)
        self.assertEqual(second.returncode, 1, second.stdout)
        self.assertIn(f"at {self.uri} another graph is running, with nodes of the same names (/adit, ", second.stdout)
        elsewhere = subprocess.run(["rosrun", "tws_launch", "start_graph", "one_aircraft", "rviz:=false", "namespace:=/other"], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=self.environment, timeout=60, check=False)
        self.assertEqual(elsewhere.returncode, 1, elsewhere.stdout)
        self.assertIn("/radar_sim publishes its time on /clock", elsewhere.stdout)
        self.assertEqual(self.pid("/adit"), tracker)
        first.send_signal(signal.SIGINT)
        first.wait(60)
        self.assertIs(self.master.getParam("/use_sim_time"), False)
        self.assertFalse(self.master.hasParam("/adit/radars"))

    # If this fails, a run waits for good for a master that does not answer.
    def test_a_master_that_does_not_answer_is_named(self):
        with socket.socket() as mute:
            mute.bind(("localhost", 0))
            mute.listen()
            self.environment["ROS_MASTER_URI"] = uri = f"http://localhost:{mute.getsockname()[1]}"
            run = self.started("one_aircraft", "rviz:=false")
            self.assertIn(f"start_graph: the master at {uri} (ROS_MASTER_URI) does not answer", run.communicate(timeout=40)[0])
            self.assertEqual(run.returncode, 1)

    # If this fails, nobody is told that the whole network may command the trackers; or a run under an address that is not this machine's
    # says nothing for minutes, and does not end when it is told to.
    def test_a_graph_that_is_open_to_the_network_is_said_to_be_and_must_be_reached_there(self):
        del self.environment["ROS_HOSTNAME"]
        self.environment["ROS_IP"] = "192.0.2.1"  # of documents: nobody's
        run = self.started("one_aircraft", "rviz:=false")
        said = run.communicate(timeout=30)[0]
        self.assertEqual(run.returncode, 1, said)
        self.assertIn("open to the network as 192.0.2.1: whoever reaches the ports", said)
        self.assertIn("this machine cannot be reached as 192.0.2.1", said)

    # If this fails, a run whose simulator is not built waits for it for good.
    def test_a_node_that_cannot_be_started_ends_the_run(self):
        launch = self.folder / "mine.launch"
        launch.write_text("""<launch>
          <node pkg="tws_launch" type="progress_node" name="progress"/>
          <node pkg="tws_launch" type="no_such_node" name="other"/>
        </launch>""")
        run = self.started(launch)
        said = run.communicate(timeout=60)[0]
        self.assertEqual(run.returncode, 1, said)
        self.assertIn("no_such_node", said)

    # If this fails, a run is recorded half and ends well, and the half cannot be read.
    def test_a_killed_recorder_ends_the_run_and_its_bag_can_be_read(self):
        bag = self.folder / ODD / "run.bag"
        bag.parent.mkdir()
        run = self.started("adit_nominal", "rate:=10", "rviz:=false", f"record:={bag}")
        active = pathlib.Path(f"{bag}.active")
        wait(lambda: self.pid("/recorder") and active.exists() and active.stat().st_size > 1000000)
        os.kill(self.pid("/recorder"), signal.SIGKILL)
        said = run.communicate(timeout=60)[0]
        self.assertEqual(run.returncode, 1, said)
        self.assertIn("node recorder died", said)
        self.assertIn("what it had recorded until then is in the bag", said)
        with rosbag.Bag(str(bag)) as recorded:
            self.assertGreater(recorded.get_message_count("/sps12/detections"), 10)

    # If this fails, a run into a folder that is not there, or that cannot be written into, goes on to its end unrecorded.
    def test_a_bag_that_cannot_be_written_ends_the_run_before_it_begins(self):
        for bag in (self.folder / "none" / "run.bag", pathlib.Path("/proc/run.bag"), self.folder / ("x" * 250 + ".bag")):
            run = self.started("one_aircraft", "rviz:=false", f"record:={bag}")
            said = run.communicate(timeout=60)[0]
            self.assertEqual((run.returncode, len(said.splitlines())), (1, 1), said)
            self.assertIn(f"{bag}: cannot be written: ", said)

    # If this fails, a recorder that never opens its bag (it has no more files, say) goes unnoticed.
    def test_a_run_of_which_nothing_was_recorded_does_not_end_well(self):
        bag, launch = self.folder / "run.bag", self.folder / "mine.launch"
        launch.write_text(f"""<launch>
          <node pkg="rosbag" type="record" name="recorder" args="--output-name={bag}" launch-prefix="sh -c 'sleep 3'" required="true"/>
        </launch>""")
        for text in ("", "of an earlier run"):
            if text:
                bag.write_text(text)
            run = self.started(launch)
            said = run.communicate(timeout=60)[0]
            self.assertEqual(run.returncode, 1, said)
            self.assertIn(f"{bag}: nothing was recorded", said)

    # If this fails, a folder with an apostrophe or a new line in its name costs the recording.
    def test_odd_names_come_through(self):
        odd, quoted = self.folder / ODD, self.folder / ODD.replace("\n", "'")  # roslaunch's own command line knows no new line.
        for folder in (odd, quoted):
            folder.mkdir()
        self.ended_well("rosrun", "tws_launch", "start_graph", "one_aircraft", "duration:=25", f"record:={odd}/run.bag")
        self.ended_well("rosrun", "tws_launch", "start_graph", odd / "run.bag", f"record:={quoted}/again.bag")
        self.ended_well("roslaunch", "-p", self.uri.rsplit(":", 1)[1], "tws_launch", "replay.launch", f"bag:={quoted}/again.bag",
                        f"record:={quoted}/third.bag")
        with rosbag.Bag(f"{quoted}/third.bag") as recorded:
            self.assertGreater(recorded.get_message_count("/adit/tracks"), 100)

    # If this fails, a recorder or correlator that is slow to connect misses a tracker's first words, and a busy machine's recording is
    # not what an offline run gives.
    def test_a_run_and_a_replay_wait_for_who_hears_the_trackers(self):
        run, graph = self.folder / "run.bag", self.folder / "late.yaml"
        for source, late in (("one_aircraft", self.folder / "late.bag"), (run, self.folder / "late_again.bag")):
            graph.write_text(f"""nodes:
              - name: late_listener
                program: rosbag/record
                role: watcher
                hears: [adit/tracks]
                args: --output-name={late} adit/tracks
                prefix: bash -c 'sleep 6 && exec "$0" "$@"'
            """)
            said = self.ended_well("rosrun", "tws_launch", "start_graph", source, "duration:=10", f"graph:={graph}",
                                   *([] if source == run else [f"record:={run}"]))
            self.assertNotIn("too few subscribers", said)
            with rosbag.Bag(str(late)) as recorded:
                sequences = [message.sequence for _, message, _ in recorded.read_messages()]
            self.assertEqual(sequences, list(range(len(sequences))))
            self.assertGreater(len(sequences), 60)

    def ended_well(self, *words):
        done = subprocess.run([*map(str, words), "rate:=10", "rviz:=false"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env=self.environment, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    # If this fails, a run goes on unrecorded when the disk is full.
    def test_a_disk_that_fills_up_ends_the_run_and_its_bag_can_be_read(self):
        if subprocess.run(["unshare", "--mount", "--map-root-user", "mount", "-t", "tmpfs", "none", self.folder], check=False).returncode:
            self.skipTest("no disk of its own can be made here")
        disk, copy = self.folder / "disk", self.folder / "copy.bag"
        disk.mkdir()
        script = f'mount -t tmpfs -o size=$0 none {disk} && "$@"; s=$?; cp {disk}/run.bag {copy}; exit $s'

        def on_disk_of(size):
            return self.started("full", "rate:=10", "rviz:=false", f"record:={disk}/run.bag",
                                before=["unshare", "--mount", "--map-root-user", "sh", "-c", script, size])

        run = on_disk_of("132m")
        said = run.communicate(timeout=120)[0]
        self.assertEqual(run.returncode, 1, said)
        self.assertIn(f"{disk}/run.bag: the disk is nearly full", said)
        with rosbag.Bag(str(copy)) as recorded:
            self.assertGreater(recorded.get_message_count("/adit/tracks"), 10)
        run = on_disk_of("100m")
        said = run.communicate(timeout=120)[0]
        self.assertEqual(run.returncode, 1, said)
        self.assertIn("the disk is nearly full (100 MB left", said)

    # If this fails, the tracks of a tracker that stands are shown as those of now, to the end.
    def test_a_tracker_that_stands_is_named(self):
        run = self.started("one_aircraft", "rate:=2", "rviz:=false")
        wait(lambda: self.pid("/adit"))
        tracker, said = self.pid("/adit"), []
        while not said or " tracks" not in said[-1]:
            said.append(run.stdout.readline())
        os.kill(tracker, signal.SIGSTOP)
        try:
            end = time.time() + 40
            while "silent: tracker adit for" not in said[-1] and time.time() < end:
                said.append(run.stdout.readline())
        finally:
            os.kill(tracker, signal.SIGCONT)
        self.assertRegex(said[-1], r" tracks( as of [0-9.]+ s)?, .*; silent: tracker adit for [0-9]+ s\n")


if __name__ == "__main__":
    unittest.main()
