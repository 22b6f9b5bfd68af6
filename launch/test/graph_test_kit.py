"""What tests and campaigns of whole graphs have in common."""
import io
import math
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


def bytes_off_the_map(message):
    """A message of tracks as bytes, without header.seq and where on earth they lie: that, only graphs of scenarios are told."""
    message.header.seq = 0
    for track in message.tracks:
        track.latitude = track.longitude = track.altitude = math.nan
    out = io.BytesIO()
    message.serialize(out)
    return out.getvalue()


def check_same(lives, others, of="", least=100, apart=10):
    """Two runs' messages must be equal as far as the shorter one goes, which may have been stopped a few, `apart`, earlier."""
    length = min(len(lives), len(others))
    if length < least or max(len(lives), len(others)) - length > apart:
        raise AssertionError(f"{of}: {len(lives)} messages against {len(others)}, wanted: {least} or more, and no more than {apart} apart")
    different = [i for i in range(length) if lives[i] != others[i]]
    if different:
        raise AssertionError(f"{of}: {len(different)} of {length} messages differ, the first is number {different[0]}")


def launch_line(file, record, **arguments):
    return ["roslaunch", "--no-summary", "tws_launch", file, f"record:={record}", "rviz:=false",
            *(f"{name}:={value}" for name, value in arguments.items())]


def late(bag):
    """The counts in the diagnostics of a live run that tell of messages that came too late for the same result."""
    counts = {}
    with rosbag.Bag(str(bag)) as opened:
        for _, message, _ in opened.read_messages(["/diagnostics"]):
            for status in message.status:
                counts.update({f"{status.hardware_id}: {v.key}": int(v.value) for v in status.values if "late" in v.key.split()})
    return {name: count for name, count in counts.items() if count}


def in_time(record, rate):
    """The bag that record(rate) gives; at half the rate, then a quarter, while messages came late. A node waits half a second of data time
    for what belongs together: at ten times the speed a twentieth of a second, in which a busy machine may not run a node at all."""
    for slower in (1, 2, 4):
        bag = record(rate / slower)
        if not late(bag):
            break
    return bag
