#!/usr/bin/env python3
"""A node that does not belong to the graph and disturbs it, for the fault campaign: campaign_stranger.py KIND SECONDS

flood       each message of plots that it hears comes another hundred times, its plots elsewhere
day_ahead   one message of plots and its sector mark, each said once more, a day ahead
clock_ahead, clock_back   /clock, an hour ahead of the others' or ten minutes behind
"""
import copy
import random
import sys
import time

import genpy
import rospy
from rosgraph_msgs.msg import Clock
from tws_msgs.msg import Detections, SectorMark

PLOTS, MARKS = "/sps12/detections", "/sps12/sector_marks"
COPIES, DAY = 100, 86400.0


def flood(seconds):
    publisher = rospy.Publisher(PLOTS, Detections, queue_size=10 * COPIES)
    numbers, said = random.Random(1), []

    def again(message):
        if message._connection_header["callerid"] == rospy.get_name():
            return
        for _ in range(COPIES):
            for plot in message.detections:
                plot.range = numbers.uniform(1e3, 2e5)
            publisher.publish(message)
        said.append(COPIES * len(message.detections))

    subscriber = rospy.Subscriber(PLOTS, Detections, again)
    time.sleep(seconds)
    subscriber.unregister()
    time.sleep(1.0)
    return f"{sum(said)} plots said in {COPIES * len(said)} messages"


def day_ahead(seconds):
    publishers = {topic: rospy.Publisher(topic, kind, queue_size=10) for topic, kind in ((PLOTS, Detections), (MARKS, SectorMark))}
    time.sleep(2.0)  # until they are connected
    heard, said = {PLOTS: {}, MARKS: {}}, []

    def keep(message, topic):
        heard[topic][message.header.stamp] = message
        both = set(heard[PLOTS]) & set(heard[MARKS])
        if both and not said:
            said.append(both.pop())
            for each, publisher in publishers.items():
                publisher.publish(later(heard[each][said[0]], DAY))

    for topic, publisher in publishers.items():
        rospy.Subscriber(topic, publisher.data_class, keep, topic)
    time.sleep(seconds)
    return f"{len(said)} sector said again, a day ahead"


def later(message, seconds):
    message = copy.deepcopy(message)
    for stamped in (message.header, *getattr(message, "detections", [])):
        stamped.stamp += genpy.Duration(seconds)
    return message


def clock(offset):
    def jump(seconds):
        publisher, said = rospy.Publisher("/clock", Clock, queue_size=100), []

        def other(message):
            if message._connection_header["callerid"] != rospy.get_name():
                publisher.publish(Clock(message.clock + genpy.Duration(offset)))
                said.append(message)

        subscriber = rospy.Subscriber("/clock", Clock, other)
        time.sleep(seconds)
        subscriber.unregister()
        time.sleep(1.0)
        return f"{len(said)} times {offset:+.0f} s on /clock"
    return jump


KINDS = {"flood": flood, "day_ahead": day_ahead, "clock_ahead": clock(3600.0), "clock_back": clock(-600.0)}


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in KINDS:
        return __doc__
    rospy.init_node("stranger", disable_rostime=True)
    words = KINDS[sys.argv[1]](float(sys.argv[2]))
    print(words)
    return 1 if words.startswith("0 ") else 0


if __name__ == "__main__":
    sys.exit(main())
