"""Recordings of a marine radar on a vessel (data/marine_autoferry of TWS_SHARED: a turn in 1.68 s, two boats with GNSS for truth)."""
import collections
import json
import math
import pathlib

NAMES = ("s2", "s3", "s4", "s13", "s16")
MARINE_RADAR = 2  # sensorID
CUT_OFF, BEGIN, NEWEST = 30.0, 10.0, 3.0  # [m], [s], [s]: scored from then on, by updates no older


def columns(measurement):
    """(north, east) of each plot [m]: a list for each of the two, or, of a single plot, a number."""
    return zip(*(value if isinstance(value, list) else [value] for value in measurement))


class Recording:
    """Plots and truth in the frame of where the vessel was at first, east and north [m]; it drifts by 30 m at most."""

    def __init__(self, folder, name):
        frames, truth = (json.loads(pathlib.Path(folder, f"{name}_{kind}.json").read_text(encoding="utf8"))
                         for kind in ("detections", "groundTruth"))
        chosen = [(frame, boats) for frame, boats in zip(frames, truth) if frame["sensorID"] == MARINE_RADAR]
        north, east = chosen[0][0]["ownshipPosition"]
        self.plots, self.truth = [], []  # (time, x, y); (time, {boat: (x, y)})
        self.measured = []  # as self.plots, from the vessel as it moves
        self.vessel = {}  # (x, y) by time: of all sensors' frames
        for frame in frames:
            own_north, own_east = frame["ownshipPosition"]
            self.vessel[f"{frame['time'] - frames[0]['time']:.3f}"] = own_east - east, own_north - north
        for frame, boats in chosen:
            time, (own_north, own_east) = frame["time"] - frames[0]["time"], frame["ownshipPosition"]
            self.plots += [(time, e + own_east - east, n + own_north - north) for n, e in columns(frame["measurement"])]
            self.measured += [(time, e, n) for n, e in columns(frame["measurement"])]
            self.truth.append((time, {boat["targetID"]: (boat["position"][1] - east, boat["position"][0] - north) for boat in boats}))

    def write_plots(self, file, measured=False):
        """`measured`: as the radar on the vessel has measured them."""
        file.write("t_s,radar,range_m,az_deg\n")
        for time, x, y in self.measured if measured else self.plots:
            file.write(f"{time:.3f},marine,{math.hypot(x, y):.2f},{math.degrees(math.atan2(x, y)) % 360.0:.4f}\n")

    def write_own_ship(self, file):
        file.write("t_s,x_m,y_m\n")
        for time, (x, y) in sorted(self.vessel.items(), key=lambda item: float(item[0])):
            file.write(f"{time},{x:.3f},{y:.3f}\n")


class Score:
    """Of adit_csv's rows: the share of a boat's epochs with a track nearby, and how many firm tracks never had a boat nearby."""

    def __init__(self, recording, rows):
        updates = collections.defaultdict(list)
        for row in rows:
            if row["status"] != "tentative":
                updates[row["track_id"]].append([float(row[key]) for key in ("t_s", "x_m", "y_m", "vx_mps", "vy_mps")])
        seen = wanted = 0
        real = set()
        for time, boats in recording.truth:
            if time < BEGIN:
                continue
            places = {uid: place for uid, track in updates.items() for place in self.at(track, time)}
            for boat in boats.values():
                near = [uid for uid, place in places.items() if math.dist(place, boat) < CUT_OFF]
                wanted, seen = wanted + 1, seen + bool(near)
                real.update(near)
        self.completeness, self.false_tracks = seen / wanted, len(set(updates) - real)

    @staticmethod
    def at(track, time):
        """Its place at a time by its newest update, in a list; empty: it has none."""
        updates = [update for update in track if time - NEWEST <= update[0] <= time + 1e-3]
        return [(x + vx * (time - t), y + vy * (time - t)) for t, x, y, vx, vy in updates[-1:]]
