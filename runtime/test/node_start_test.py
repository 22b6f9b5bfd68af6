#!/usr/bin/env python3
"""A node without a master: node_start_test.py PATH_OF_A_NODE

If this fails, a person who types a node's name sees nothing at all, for good.
"""
import os
import socket
import subprocess
import sys
import tempfile
import time
import unittest


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


class NodeStart(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.uri = f"http://localhost:{free_port()}"
        self.environment = {**os.environ, "ROS_MASTER_URI": self.uri, "ROS_LOG_DIR": folder.name, "ROS_HOSTNAME": "localhost"}

    def test_help_needs_no_master(self):
        for word in ("--help", "-h"):
            done = subprocess.run([NODE, word], stdout=subprocess.PIPE, env=self.environment, text=True, timeout=10, check=False)
            self.assertEqual(done.returncode, 0)
            self.assertIn("It needs a master", done.stdout)
            self.assertIn(os.path.basename(NODE), done.stdout)

    def said_within_five_seconds(self):
        node = subprocess.Popen([NODE], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=self.environment, text=True)
        time.sleep(5)
        node.kill()
        return node.communicate(timeout=20)[1]

    def test_a_master_that_is_not_there_is_named(self):
        self.assertIn(f"waits for the ROS master at {self.uri}", self.said_within_five_seconds())

    def test_a_master_that_does_not_answer_is_named(self):
        with socket.socket() as mute:
            mute.bind(("localhost", 0))
            mute.listen()
            self.environment["ROS_MASTER_URI"] = uri = f"http://localhost:{mute.getsockname()[1]}"
            self.assertIn(f"waits for the ROS master at {uri}", self.said_within_five_seconds())


if __name__ == "__main__":
    NODE = sys.argv.pop(1)
    unittest.main()
