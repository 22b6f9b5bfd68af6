"""What tests and campaigns of whole graphs have in common."""
import socket

import rosbag


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def message_bytes(bag, topic="/adit/tracks"):
    """All messages on a topic as bytes, without the first four, which are header.seq."""
    with rosbag.Bag(str(bag)) as opened:
        return [raw[1][4:] for _, raw, _ in opened.read_messages([topic], raw=True)]
