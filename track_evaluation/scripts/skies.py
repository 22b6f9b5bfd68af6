"""Skies that are harder than the report's: worlds of the bench (hard.py, score.py) in the folder that TWS_SHARED names."""
import csv
import json
import os
import pathlib
import sys

# What it is, and what hard.py makes it of.
WORLDS = [("60 aircraft, 20 false plots a scan", "plain"), ("100 false plots more in a patch", "plain --patch 100"),
          ("1000 false plots a scan", "plain --fa 1000"), ("detection 0.7, 100 false plots", "plain --pd .7 --fa 100"),
          ("40 that cross, detection 0.7, 100 false plots", "crossing -N 40 --pd .7 --fa 100"),
          ("formations, 40, 100 false plots", "formation -N 40 --fa 100"), ("600-900 m/s", "fast"),
          ("changes of speed of 0.5-1 g", "accel"), ("turns of 3-5 g", "g5"), ("30-60 m/s", "slow60"), ("boats, 5-20 m/s", "slow")]
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


def flown(runs, kind, parameters, seed):
    """Scores of a parameter set in one world."""
    runs.count_run()
    folder = world(runs, kind, seed)
    tracks = folder / "tracks.csv"
    files = ["--detections", folder / "det_rot.csv", "--tracks", tracks]
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
    return lines
