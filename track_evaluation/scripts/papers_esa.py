"""Slocumb and Klusman: frames of data for an electronically scanned array. The closely-spaced-objects scenario in closed loop with each of the
frame builder's algorithms, the same tracker behind all of them. Section 4 compares in words and gives no numbers."""
import yaml

TITLE = "Frame building algorithm for electronically scanned array radar (Slocumb and Klusman)"
SETTINGS = {"cutoff_m": 300.0, "from_s": 30.0}  # of the evaluation: half of what parts neighbours in the formation
ALGORITHMS = {1: "a dwell is a frame", 2: "within a resource period", 3: "across resource periods", 4: "several open frames"}


def rows(runs, seeds, Sample, verdict):
    scores = {algorithm: [fly(runs, algorithm, seed) for seed in seeds] for algorithm in ALGORITHMS}
    if runs.figures:
        draw(scores, Sample, runs.figures / "esa.png")

    def sample(algorithm, metric):
        return Sample([score[metric] for score in scores[algorithm]])

    return [*compared(sample, verdict, "completeness", "objects with a track", +1, "under-represented, optimal with 2 and 3"),
            *compared(sample, verdict, "redundant", "redundant tracks of an object", -1, "some; none with 2 and 3"),
            *compared(sample, verdict, "spuriousness", "track reports that follow nobody", -1, "some; none with 2 and 3"),
            *accuracy(sample, verdict)]


def fly(runs, algorithm, seed):
    """Scores of the array's tracker."""
    parameters = yaml.safe_load((runs.package("esa_frame_builder") / "config" / "frame_builder.yaml").read_text())
    parameters["algorithm"] = algorithm
    bag = runs.offline(runs.scenario("esa_closely_spaced"), "--seed", seed, "--frame-builder", runs.file("frame_builder.yaml", parameters))
    metrics = runs.evaluate(bag, SETTINGS)["esa"]["metrics"]
    return dict(metrics, redundant=metrics["ambiguity"] - 1)


def compared(sample, verdict, metric, what, better, document):
    """Algorithm 1 as it is, then each of the others against it; `better`: the sign of what is better."""
    one = sample(1, metric)
    lines = [(f"algorithm 1, {ALGORITHMS[1]}: {what}", document.split(";")[0].split(",")[0], one.in_words("%", 100, 1), "")]
    for algorithm in (2, 3, 4):
        other = sample(algorithm, metric)
        gain = other - one if better > 0 else one - other
        lines.append((f"algorithm {algorithm}, {ALGORITHMS[algorithm]}: {what}", document if algorithm < 4 else "no number (ours)",
                      other.in_words("%", 100, 1), f"better than algorithm 1: {verdict(gain)}"))
    return lines


def accuracy(sample, verdict):
    one = sample(1, "rms_pos_m")
    lines = [(f"algorithm 1, {ALGORITHMS[1]}: position error", "no number", one.in_words("m", digits=1), "of the objects that have a track")]
    for algorithm in (2, 3, 4):
        other = sample(algorithm, "rms_pos_m")
        lines.append((f"algorithm {algorithm}, {ALGORITHMS[algorithm]}: position error", "slightly better than 1" if algorithm < 4 else "no number (ours)",
                      other.in_words("m", digits=1), f"better than algorithm 1: {verdict(one - other)}"))
    return lines


def draw(scores, Sample, file):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    panels = [("completeness", "objects with a track [%]", 100), ("redundant", "redundant tracks an object [%]", 100),
              ("spuriousness", "reports that follow nobody [%]", 100), ("rms_pos_m", "position error [m]", 1)]
    figure, axes = plt.subplots(1, len(panels), figsize=(12, 3.2))
    for axis, (metric, title, scale) in zip(axes, panels):
        samples = [Sample([scale * score[metric] for score in scores[algorithm]]) for algorithm in ALGORITHMS]
        axis.bar(list(ALGORITHMS), [s.mean for s in samples], yerr=[0 if len(s.values) < 2 else s.half_width for s in samples], capsize=4,
                 color=["#b0b0b0", "#4878a8", "#2f5f8f", "#7aa35a"])
        axis.set_title(title, fontsize=10)
        axis.set_xticks(list(ALGORITHMS))
        axis.set_xlabel("algorithm")
    figure.suptitle("Ten objects within two beamwidths and six by themselves, closed loop; mean and its 95 % interval over seeds", fontsize=10)
    figure.tight_layout()
    figure.savefig(file, dpi=110)
    plt.close(figure)
