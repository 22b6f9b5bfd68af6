"""Skies that are harder than the report's: worlds of the bench (hard.py, score.py) in the folder that TWS_SHARED names."""
import bisect
import csv
import json
import math
import os
import pathlib
import random
import sys

# What it is, and what hard.py makes it of.
WORLDS = [("60 aircraft, 20 false plots a scan", "plain"), ("100 false plots more in a patch", "plain --patch 100"),
          ("1000 false plots a scan", "plain --fa 1000"), ("detection 0.7, 100 false plots", "plain --pd .7 --fa 100"),
          ("40 that cross, detection 0.7, 100 false plots", "crossing -N 40 --pd .7 --fa 100"),
          ("formations, 40, 100 false plots", "formation -N 40 --fa 100"), ("600-900 m/s", "fast"),
          ("changes of speed of 0.5-1 g", "accel"), ("turns of 3-5 g", "g5"), ("30-60 m/s", "slow60"), ("boats, 5-20 m/s", "slow")]
DOPPLER = [("60 aircraft, range rates to 2 m/s", "plain"), ("1000 false plots a scan, range rates to 2 m/s", "plain --fa 1000")]
RATE_SIGMA, FALSE_RATES = 2.0, 300.0  # [m/s]; those of false plots are spread evenly so far each way
RADARS = ["--radar", "0:6:0", "--radar", "1:8:90"]
FIGURES = [("ospa_m", "OSPA", "m", 0), ("completeness", "completeness", "", 3), ("swaps", "changes of track", "", 1),
           ("spurious_tracks", "spurious tracks", "", 1)]
FIRST_SEED = 100  # Seeds 1 to 20 have been looked at while the tracker was built.


def bench():
    """The folder of the bench, or None."""
    folder = pathlib.Path(os.environ.get("TWS_SHARED", "")) / "bench"
    return folder if (folder / "hard.py").exists() else None


def world(runs, kind, seed):
    folder = runs.folder / f"sky_{kind.replace(' ', '_')}_{seed}"
    if not folder.exists():
        name, *options = kind.split()
        runs.output("hard.py", sys.executable, bench() / "hard.py", name, folder, "--seed", FIRST_SEED + seed, *options)
    return folder


def picture(tracks):
    """The same without what score.py does not read."""
    reduced = tracks.with_suffix(".picture.csv")
    with open(tracks) as source, open(reduced, "w", newline="") as target:
        csv.writer(target).writerows(row[:6] for row in csv.reader(source))
    return reduced


def radial_velocity(flight, t):
    """Of a flight's rows of truth (t, x, y, vx, vy), by cubics through them [m/s]."""
    after = min(max(1, bisect.bisect([row[0] for row in flight], t)), len(flight) - 1)
    (t0, *a), (t1, *b) = flight[max(0, after - 1)], flight[after]
    h = t1 - t0 if t1 > t0 else 1.0
    u = (t - t0) / h
    place, velocity = [], []
    for p, v, q, w in zip(a[:2], a[2:], b[:2], b[2:]):
        place.append((1 + 2 * u) * (1 - u)**2 * p + u * (1 - u)**2 * h * v + u * u * (3 - 2 * u) * q + u * u * (u - 1) * h * w)
        velocity.append(6 * u * (1 - u) * (q - p) / h + (1 - u) * (1 - 3 * u) * v + u * (3 * u - 2) * w)
    return sum(p * v for p, v in zip(place, velocity)) / math.hypot(*place)


def with_rates(folder):
    """The world's plots with range rates; none where truth has no rows about them."""
    path = folder / "det_rates.csv"
    if path.exists():
        return path
    flights, chance = {}, random.Random(1)
    with open(folder / "truth.csv") as source:
        for row in list(csv.reader(source))[1:]:
            flights.setdefault(row[1], []).append([float(row[k]) for k in (0, 2, 3, 4, 5)])
    with open(folder / "det_rot.csv") as source, open(path, "w") as target:
        target.write(next(source).strip() + ",range_rate_mps\n")
        for line in source:
            t, number = float(line.split(",")[0]), line.strip().split(",")[-1]
            flight = flights.get(number, [])
            rate = ""
            if int(number) < 0:
                rate = f"{chance.uniform(-FALSE_RATES, FALSE_RATES):.2f}"
            elif len(flight) > 1 and flight[0][0] - 5.0 <= t <= flight[-1][0]:
                rate = f"{radial_velocity(flight, t) + chance.gauss(0.0, RATE_SIGMA):.2f}"
            target.write(f"{line.strip()},{rate}\n")
    return path


def doppler(runs):
    """A parameter file of `default` whose radars measure range rates."""
    path = runs.folder / "doppler.yaml"
    path.write_text("radars:\n" + "".join(f'  - {{name: "{radar}", range_rate_sigma_mps: {RATE_SIGMA}}}\n' for radar in (0, 1)))
    return path


def flown(runs, kind, parameters, seed, rates=False):
    """Scores of a parameter set in one world."""
    runs.count_run()
    folder = world(runs, kind, seed)
    tracks = folder / "tracks.csv"
    files = ["--detections", with_rates(folder) if rates else folder / "det_rot.csv", "--tracks", tracks]
    runs.tool("adit_tracker", "adit_csv", *files, *RADARS, "--epochs", 5, "--params", parameters)
    files = folder / "truth.csv", picture(tracks)
    return json.loads(runs.output("score.py", sys.executable, bench() / "score.py", *files, "--from", 60, "--to", 595, "--json"))


def rows(runs, seeds, Sample, verdict):
    if bench() is None:
        return [("harder skies", "beyond the report", "not flown: TWS_SHARED names no folder with a bench", "not measured")]
    lines = []
    for what, kind in WORLDS:
        ours = "marine" if kind == "slow" else "default"
        scores = {name: [flown(runs, kind, name, seed) for seed in seeds] for name in ("nrl7952", ours)}
        samples = {name: {key: Sample([s[key] for s in found]) for key, *_ in FIGURES} for name, found in scores.items()}
        said = [", ".join(f"{name} {samples[which][key].in_words(unit, 1, digits)}" for key, name, unit, digits in FIGURES)
                for which in (ours, "nrl7952")]
        lines.append((f"harder skies: {what}", "beyond the report", f"{said[0]} ({ours}); {said[1]} (nrl7952)",
                      verdict(samples["nrl7952"]["ospa_m"] - samples[ours]["ospa_m"])))
    return lines + doppler_rows(runs, seeds, Sample, verdict)


def doppler_rows(runs, seeds, Sample, verdict):
    lines = []
    for what, kind in DOPPLER:
        scores = {"with them": [flown(runs, kind, doppler(runs), seed, rates=True) for seed in seeds],
                  "without": [flown(runs, kind, "default", seed) for seed in seeds]}
        samples = {name: {key: Sample([s[key] for s in found]) for key, *_ in FIGURES} for name, found in scores.items()}
        said = [", ".join(f"{name} {of[key].in_words(unit, 1, digits)}" for key, name, unit, digits in FIGURES) + f" ({which})"
                for which, of in samples.items()]
        lines.append((f"harder skies: {what}", "beyond the report", "; ".join(said),
                      verdict(samples["without"]["ospa_m"] - samples["with them"]["ospa_m"])))
    return lines
