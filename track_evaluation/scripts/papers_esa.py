"""Slocumb and Klusman: frames of data for an electronically scanned array. The closely-spaced-objects scenario in closed loop with each of
the frame builder's algorithms, the same tracker behind all of them. Section 4 compares in words and gives no numbers."""
import yaml

TITLE = "Frame building algorithm for electronically scanned array radar (Slocumb and Klusman)"
SETTINGS = {"cutoff_m": 300.0, "from_s": 30.0}  # of the evaluation: half of what parts neighbours in the formation
DURATION = 80  # of a flight [s]
ALGORITHMS = {1: "a dwell is a frame", 2: "within a resource period", 3: "across resource periods", 4: "several open frames"}


# Algorithm 1 makes ten frames of a resource period where the others make one or two: the tracker's window, which counts frames, holds less
# than a period. The second case gives it ten times the frames, so that it does start tracks, and the other claims can be looked at.
CASES = {"1": (1, 1), "1, window of 10 x the frames": (1, 10), "2": (2, 1), "3": (3, 1), "4": (4, 1)}


def rows(runs, seeds, Sample, verdict):
    scores = {case: [fly(runs, *CASES[case], seed) for seed in seeds] for case in CASES}
    if runs.figures:
        draw(scores, Sample, runs.figures / "esa.png")
    lines = []
    for metric, what, unit, scale, sign, document in (
            ("completeness", "objects with a track", "%", 100, 1, ("significantly under-represented", "optimal")),
            ("redundant", "redundant tracks an object", "%", 100, -1, ("some", "none")),
            ("spuriousness", "track reports that follow nobody", "%", 100, -1, ("some", "none")),
            ("rms_pos_m", "position error of objects with a track", "m", 1, -1, ("no number", "slightly better than 1"))):
        for case, (algorithm, _) in CASES.items():
            own = Sample([score[metric] for score in scores[case]])
            ours = "no track at all" if not own.values else own.in_words(unit, scale, 1)
            said = "no number (ours)" if algorithm == 4 else document[algorithm > 1]
            lines.append((f"{what}: algorithm {case} ({ALGORITHMS[algorithm]})", said, ours,
                          "" if algorithm == 1 else against(scores, case, metric, sign, Sample, verdict)))
    return lines


def against(scores, case, metric, sign, Sample, verdict):
    """The case against both ways of algorithm 1, seed by seed."""
    words = []
    for other, name in (("1", "1"), ("1, window of 10 x the frames", "1 with the long window")):
        pairs = [(a[metric], b[metric]) for a, b in zip(scores[case], scores[other]) if a[metric] is not None and b[metric] is not None]
        if pairs:
            words.append(f"better than {name}: {verdict(Sample([sign * (a - b) for a, b in pairs]))}")
    return "; ".join(words)


def fly(runs, algorithm, window, seed):
    """Scores of the array's tracker. `window`: factor on the tracker's numbers of frames."""
    config = runs.package("esa_frame_builder") / "config"
    builder = dict(yaml.safe_load((config / "frame_builder.yaml").read_text()), algorithm=algorithm)
    tracker = yaml.safe_load((config / "mfa_stub.yaml").read_text())
    for key in ("window_frames", "initiation_frames"):
        tracker[key] *= window
    bag = runs.offline(dict(runs.scenario("esa_closely_spaced"), duration_s=DURATION), "--seed", seed,
                       "--params", f"frame_builder={runs.file('frame_builder.yaml', builder)}",
                       "--params", f"mfa_stub={runs.file('mfa_stub.yaml', tracker)}")
    metrics = runs.evaluate(bag, SETTINGS)["esa"]["metrics"]
    return dict(metrics, redundant=None if metrics["ambiguity"] is None else metrics["ambiguity"] - 1)


def draw(scores, Sample, file):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    panels = [("completeness", "objects with a track [%]", 100), ("redundant", "redundant tracks an object [%]", 100),
              ("spuriousness", "reports that follow nobody [%]", 100), ("rms_pos_m", "position error [m]", 1)]
    figure, axes = plt.subplots(1, len(panels), figsize=(12, 3.2))
    for axis, (metric, title, scale) in zip(axes, panels):
        samples = [Sample([scale * score[metric] for score in scores[case] if score[metric] is not None]) for case in CASES]
        places = range(len(CASES))
        axis.bar(places, [s.mean if s.values else 0 for s in samples], yerr=[0 if len(s.values) < 2 else s.half_width for s in samples],
                 capsize=4,
                 color=["#b0b0b0", "#909090", "#4878a8", "#2f5f8f", "#7aa35a"])
        for place, sample in zip(places, samples):
            if not sample.values:
                axis.text(place, 0, "no track", rotation=90, ha="center", va="bottom", fontsize=8)
        axis.set_title(title, fontsize=10)
        axis.set_xticks(list(places), ["1", "1, long\nwindow", "2", "3", "4"], fontsize=8)
        axis.set_xlabel("algorithm")
    figure.suptitle("Ten objects within two beamwidths and six by themselves, closed loop; mean and its 95 % interval over seeds",
                    fontsize=10)
    figure.tight_layout()
    figure.savefig(file, dpi=110)
    plt.close(figure)
