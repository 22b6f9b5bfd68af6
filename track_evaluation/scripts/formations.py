"""Aircraft that fly unresolved, as one plot: what becomes of their tracks when they part or cross. figures(BAG) -> a dictionary.

Groups are aircraft of one name but for what follows its last underscore (wedge_a, wedge_b), as in scenario formation_split. Whether a
radar sees two of them as one is judged by truth and the cells of the radars that the scenario uses.
"""
import bisect
import collections
import itertools
import math

import rosbag

# in range [m] and azimuth, of the types SPS-12 and SPS-39
CELLS = {"sps12": (300.0, math.radians(3.0)), "sps39": (300.0, math.radians(1.5))}
FIRM, COASTING = 2, 3
NEAR = 1500.0       # a track that is further off follows another aircraft [m]
STALE = 9.0         # a track without an update for so long counts as deleted [s]
ENOUGH = 3          # passes of beams over a pair in one cell, before its parting counts
AFTER = 0.6         # what a beam has seen is processed by then [s]


def turn(difference):
    return (difference + math.pi) % (2 * math.pi) - math.pi


class Truth:
    """Places of the aircraft in slant range and azimuth, and the beams' passes over them."""

    def __init__(self, messages):
        self.times = [m.header.stamp.to_sec() for m in messages]
        self.radars = messages[0].radars
        self.places = collections.defaultdict(dict)  # name -> time -> (range, azimuth)
        for time, message in zip(self.times, messages):
            for target in message.targets:
                if target.kind == 0:
                    self.places[target.name][time] = target.slant_range[0], target.azimuth[0]
        self.names = sorted(self.places)

    def polar(self, name, time):
        i = min(max(bisect.bisect_right(self.times, time) - 1, 0), len(self.times) - 2)
        before, after = self.times[i], self.times[i + 1]
        (r0, a0), (r1, a1) = self.places[name][before], self.places[name][after]
        share = (time - before) / (after - before)
        return r0 + share * (r1 - r0), a0 + share * turn(a1 - a0)

    def place(self, name, time):
        reach, azimuth = self.polar(name, time)
        return reach * math.sin(azimuth), reach * math.cos(azimuth)

    def resolved(self, pair, time, radar):
        (r0, a0), (r1, a1) = (self.polar(name, time) for name in pair)
        return abs(r0 - r1) >= CELLS[radar][0] or abs(turn(a0 - a1)) >= CELLS[radar][1]

    def groups(self):
        members = collections.defaultdict(list)
        for name in self.names:
            members[name.rsplit("_", 1)[0]].append(name)
        return {group: names for group, names in members.items() if len(names) > 1}


def read(bag_file):
    truth, marks, rows = [], collections.defaultdict(list), collections.defaultdict(list)
    with rosbag.Bag(str(bag_file)) as bag:
        radars = {f"/{radar}/sector_marks": radar for radar in CELLS}
        topics = ["/truth", "/adit/tracks", *radars]
        for topic, message, _ in bag.read_messages(topics):
            if topic == "/truth":
                truth.append(message)
            elif topic == "/adit/tracks":
                for t in message.tracks:
                    rows[t.uid].append((t.stamp.to_sec(), t.state in (FIRM, COASTING), t.position.x, t.position.y, t.velocity.x,
                                        t.velocity.y))
            else:
                marks[radars[topic]].append((message.header.stamp.to_sec(), message.sector))
    for history in rows.values():
        history.sort(key=lambda row: row[0])
    return Truth(truth), marks, rows


def picture(rows, time):
    """The confirmed tracks at that time: uid -> place."""
    found = {}
    for uid, history in rows.items():
        i = bisect.bisect_right(history, time, key=lambda row: row[0]) - 1
        if i < 0 or not history[i][1] or time - history[i][0] > STALE:
            continue
        then, _, x, y, vx, vy = history[i]
        found[uid] = x + (time - then) * vx, y + (time - then) * vy
    return found


def passes(truth, marks, name):
    """When which radar's beam meets an aircraft."""
    found = []
    for radar, entered in marks.items():
        for time, sector in entered:
            known = truth.times[0] < time < truth.times[-1] - 1
            if known and int(truth.polar(name, time)[1] % (2 * math.pi) / (2 * math.pi) * 64) == sector:
                found.append((time, radar))
    return sorted(found)


def partings(truth, marks):
    """For each pair that parts: names and the passes of beams, from the first one that parts them on."""
    for names in truth.groups().values():
        for pair in itertools.combinations(names, 2):
            seen = [(time, radar, truth.resolved(pair, time, radar)) for time, radar in passes(truth, marks, pair[0])]
            merged = 0
            for i, (_, radar, resolved) in enumerate(seen):
                later = [apart for _, other, apart in seen[i:] if other == radar][:4]
                if not resolved:
                    merged += 1
                elif merged >= ENOUGH and len(later) == 4 and all(later):
                    yield pair, [(time, by) for time, by, apart in seen[i:] if apart]
                    break


def own_tracks(truth, tracks, pair, time):
    """The track nearest to each of both, that is not nearer to the other; None: there is none."""
    places = [truth.place(name, time) for name in pair]
    own = []
    for mine, other in (places, places[::-1]):
        near = sorted((math.dist(place, mine), uid) for uid, place in tracks.items()
                      if math.dist(place, mine) < min(NEAR, math.dist(place, other)))
        own.append(near[0][1] if near else None)
    return own


def two_tracks(truth, rows, pair, seen):
    """Updates and seconds from the parting to a track for each; None: it has not come to that."""
    for i, (time, _) in enumerate(seen):
        if None not in own_tracks(truth, picture(rows, time + AFTER), pair, time + AFTER):
            return i + 1, time - seen[0][0]
    return None


def left_over(places, tracks):
    """The tracks near an aircraft that are left when each aircraft has its own, the closest pairs first."""
    near = sorted((math.dist(place, track), i, uid) for i, place in enumerate(places) for uid, track in tracks.items()
                  if math.dist(place, track) < NEAR)
    served, given = set(), set()
    for _, i, uid in near:
        if i not in served and uid not in given:
            served.add(i)
            given.add(uid)
    return {uid for _, _, uid in near} - given


def redundant(truth, rows):
    """How many tracks are left over in three pictures of two seconds, or more."""
    count = collections.Counter()
    time = truth.times[0] + 40.0
    while time < truth.times[-1] - 2.0:
        count.update(left_over([truth.place(name, time) for name in truth.names], picture(rows, time)))
        time += 2.0
    return sum(seen >= 3 for seen in count.values())


def kept(truth, rows, pair):
    """Have both the tracks after their closest approach that they had before it? None: one had none, or they fly together."""
    nearest = min(truth.times, key=lambda time: math.dist(*(truth.place(name, time) for name in pair)))
    before, after = nearest - 45.0, min(nearest + 60.0, truth.times[-1] - 3.0)
    if before < truth.times[0] + 20.0:
        return None
    had = own_tracks(truth, picture(rows, before), pair, before)
    return None if None in had else had == own_tracks(truth, picture(rows, after), pair, after)


def figures(bag_file):
    truth, marks, rows = read(bag_file)
    took = [two_tracks(truth, rows, pair, seen) for pair, seen in partings(truth, marks)]
    crossings = [kept(truth, rows, names) for names in truth.groups().values() if len(names) == 2]
    crossings = [state for state in crossings if state is not None]
    return {
        "partings": len(took),
        "two_tracks_in_three_updates": sum(t is not None and t[0] <= 3 for t in took) / len(took),
        "updates_to_two_tracks": sum(min(t[0], 15) if t else 15 for t in took) / len(took),
        "seconds_to_two_tracks": sum(min(t[1], 60.0) if t else 60.0 for t in took) / len(took),
        "redundant_tracks": redundant(truth, rows),
        "identities_kept": sum(crossings) / len(crossings),
    }
