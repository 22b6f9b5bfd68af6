#!/usr/bin/env python3
"""Are the tracks of all scenarios still the same, byte by byte but for header.seq? To be run by hand around a change that must not
alter them.

  compare_tracks.py fly FOLDER [SCENARIO...]      every scenario offline, with the build whose setup.bash was sourced, into
                                                  FOLDER/SCENARIO/run.bag
  compare_tracks.py compare BEFORE AFTER          of two such folders; the status is 1 when anything differs
"""
import pathlib
import subprocess
import sys

import rosbag

SCENARIOS = pathlib.Path(__file__).resolve().parent.parent / "scenarios"
TYPES = {"tws_msgs/Tracks", "tws_msgs/CorrelatedTracks"}


def fly(folder, names):
    for name in names or sorted(file.stem for file in SCENARIOS.glob("*.yaml")):
        print(name, flush=True)
        subprocess.run(["rosrun", "tws_launch", "tws_offline", SCENARIOS / f"{name}.yaml", "--out", folder / name], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def tracks(path):
    """Times and bytes of all messages with tracks, by topic; the first four bytes are header.seq."""
    found = {}
    with rosbag.Bag(str(path)) as bag:
        for topic, (kind, data, *_), time in bag.read_messages(raw=True):
            if kind in TYPES:
                found.setdefault(topic, []).append((time.to_nsec(), data[4:]))
    return found


def difference(before, after):
    """In words; empty: there is none."""
    if len(before) != len(after):
        return f"{len(before)} messages, {len(after)} afterwards"
    different = [number for number, pair in enumerate(zip(before, after)) if pair[0] != pair[1]]
    return f"{len(different)} of {len(before)} messages differ, the first is number {different[0]}" if different else ""


def compare(before, after):
    """Returns the number of topics that differ."""
    count = 0
    for bag in sorted(before.glob("*/run.bag")):
        name = bag.parent.name
        one, two = tracks(bag), tracks(after / name / "run.bag")
        for topic in sorted({*one, *two}):
            words = difference(one.get(topic, []), two.get(topic, []))
            count += words != ""
            print(f"{name} {topic}: {words or 'same'} ({len(one.get(topic, []))} messages)")
    return count


def main():
    if len(sys.argv) >= 3 and sys.argv[1] == "fly":
        return fly(pathlib.Path(sys.argv[2]), sys.argv[3:])
    if len(sys.argv) == 4 and sys.argv[1] == "compare":
        return compare(pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])) > 0
    return __doc__


if __name__ == "__main__":
    sys.exit(main())
