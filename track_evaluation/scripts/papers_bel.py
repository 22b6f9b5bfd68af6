"""Sampath Kumar, Viji Paul and Ramakrishnan (Bharat Electronics): correlation of primary and secondary tracks. All flights go through the
whole graph; the correlator's parameters are its own, but for the scheme and, in table 1, for what the radars may disagree about."""
import collections
import json
import os
import pathlib
import statistics

import rosbag
import yaml

TITLE = "Robust correlation strategy for primary and secondary tracks with intact track identity (Bharat Electronics)"
SCHEMES = [("distance", "distance alone"), ("plain", "history"), ("parallel_counter", "history with parallel counter")]
CORRELATED, NONE = 3, 2**32 - 1                     # of CorrelatedTrack
FIRM, COASTING, DROPPED, UNKNOWN = 2, 3, 4, 65535   # of Track
SETTINGS = {"cutoff_m": 3000.0, "from_s": 30.0}     # of the evaluation
FLIGHTS, SPACING = 100, 40.0  # of the three targets, at least, and from one flight to the next [s]
SCANS = 11                    # seconds 10 to 20


def rows(runs, seeds, Sample, verdict):
    return [*table_1(runs, max(FLIGHTS, len(seeds)), Sample), *figure_10(runs), *new_identity(runs),
            *dense(runs, seeds, Sample, verdict), *cost(runs), *real_radar(runs)]


def fly(runs, scenario, scheme, seed=1, **changes):
    parameters = yaml.safe_load((runs.package("track_correlator") / "config" / "track_correlator.yaml").read_text())
    parameters.update(scheme=scheme, **changes)
    return runs.offline(scenario, "--seed", seed, "--params", f"track_correlator={runs.file('correlator.yaml', parameters)}")


def updates(bag_file):
    """(time, update) of each living track of the correlator."""
    with rosbag.Bag(str(bag_file)) as bag:
        for _, (_, data, _, _, message_type), _ in bag.read_messages(["/correlated/tracks"], raw=True):
            if len(data) < 150:  # Nothing in it, as in most: a track alone takes more.
                continue
            message = message_type().deserialize(data)
            for update in message.tracks:
                if update.track.state != DROPPED:
                    yield message.header.stamp.to_sec(), update


# ---- table 1: distance alone against history --------------------------------------------------------------------------------------

def many_flights(scene, count):
    """The three targets again and again. Errors are drawn by name and turn, so each flight has its own; codes say target and flight."""
    targets = [dict(target, name=f"{target['name']}_{flight}", start_s=flight * SPACING, end_s=flight * SPACING + 35,
                    transponder={"mode_3a": f"{number}{flight % 512:03o}"})
               for flight in range(count) for number, target in enumerate(scene["targets"], 1)]
    return dict(scene, duration_s=count * SPACING, targets=targets)


def miscorrelations(bag_file, start, count):
    """For each target its wrong scans in each flight. The first code that a primary track gets, while far from the others, is its own."""
    wrong, own = [[0] * count for _ in range(3)], {}
    for time, update in updates(bag_file):
        flight, second = divmod(time - start, SPACING)
        if update.kind != CORRELATED:
            continue
        target = update.track.mode_3a >> 9
        own.setdefault(update.primary, target)
        if 10 <= second < 10 + SCANS:
            wrong[own[update.primary] - 1][int(flight)] += target != own[update.primary]
    return wrong


def table_1(runs, count, Sample):
    scene = many_flights(runs.scenario("bel_three_targets"), count)
    lines = []
    for bias, remark in (({"position_bias_m": 0.0, "velocity_bias_mps": 0.0}, "the paper's: no bias"),
                         ({}, "ours: biases of 100 m and 10 m/s allowed")):
        for scheme, name in SCHEMES:
            samples = [Sample(target) for target in miscorrelations(fly(runs, scene, scheme, **bias), 1000.0, count)]
            lines.append((f"table 1: wrong scans of targets 1, 2, 3: {name}", "4, 4, 4" if scheme == "distance" else "0, 0, 0",
                          f"{', '.join(s.in_words() for s in samples)} of {SCANS}; {count} flights; {remark}",
                          table_1_words(scheme, samples)))
    return lines


def table_1_words(scheme, samples):
    if scheme != "distance":
        return "as the paper" if all(sum(s.values) == 0 for s in samples) else "NOT as the paper"
    means = [s.mean for s in samples]
    if all(mean < 4 for mean in means):
        return "fewer than in the paper, which shows one run; history mends them all the same"
    if all(mean > 4 for mean in means):
        return "more than in the paper: 20 m are little beside what the distance forgives"
    return "about as many as in the paper, which shows one run; the middle one has two to be mixed up with"


# ---- figure 10: time against number of tracks -------------------------------------------------------------------------------------

def benchmarks(runs, package, pattern):
    """Nanoseconds of CPU by name; empty where Google Benchmark is not installed."""
    program = runs.program(package, f"{package}_benchmark")
    if program is None:
        return {}
    said = runs.tool(package, program, f"--benchmark_filter={pattern}", "--benchmark_format=json", "--benchmark_min_time=0.1")
    scale = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    return {b["name"]: b["cpu_time"] * scale[b["time_unit"]] for b in json.loads(said)["benchmarks"] if "cpu_time" in b}


SOLVERS = [("AssignmentSquare", "ours"), ("AssignmentClassicMunkres", "classic Munkres"), ("AssignmentBruteForce", "all assignments tried")]


def figure_10(runs):
    found = benchmarks(runs, "tws_core", "Assignment(Square|ClassicMunkres|BruteForce)/(3|5|10)$")
    if not found:
        return [("figure 10: Munkres takes less time than trying all", "curves without figures",
                 "not measured: Google Benchmark is not installed", "")]
    times = {name: [found[f"{key}/{n}"] / 1000.0 for n in (3, 5, 10)] for key, name in SOLVERS}
    draw(runs, "bel_figure_10.png", (3, 5, 10), times, "tracks", "time of one assignment [µs]")
    lines = []
    for i, n in enumerate((3, 5, 10)):
        ours, classic, brute = (times[name][i] for _, name in SOLVERS)
        remark = "confirmed" if classic < brute else "CONTRADICTED for so few: trying all is quicker than the classic steps"
        lines.append((f"figure 10: {n} tracks: Munkres takes less time than trying all", "a curve without figures",
                      f"ours {ours:.3g} µs, classic Munkres {classic:.3g} µs, all tried {in_short(brute)} µs", remark))
    return lines


def draw(runs, name, x, curves, x_label, y_label):
    """A figure where matplotlib is installed and a folder for figures is named."""
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        return
    if runs.figures is None:
        return
    figure, axes = plt.subplots(figsize=(6, 4))
    for label, values in curves.items():
        axes.plot(x, values, marker="o", label=label)
    axes.set(xlabel=x_label, ylabel=y_label, yscale="log", xticks=list(x))
    axes.grid(True, which="both", alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(runs.figures / name, dpi=110, metadata={"Software": None})
    plt.close(figure)


# ---- a new secondary number -------------------------------------------------------------------------------------------------------

def new_identity(runs):
    """A transponder that is silent for a moment, from which its secondary track goes on under another number."""
    target = {"name": "one", "east_m": 30000, "north_m": 30000, "height_m": 6000, "course_deg": 90, "speed_mps": 200,
              "transponder": {"mode_3a": "4101", "silent": [{"from_s": 30.2, "to_s": 30.6}]}}
    scene = dict(runs.scenario("bel_three_targets"), targets=[target])
    lines = []
    for scheme, name, document in (("plain", "plain scheme", 7), ("parallel_counter", "parallel counter", 3)):
        said = list(updates(fly(runs, scene, scheme)))
        number = max(update.secondary for _, update in said if update.secondary != NONE)
        first = next(time for time, update in said if update.secondary == number)
        done, joined = next((time, update) for time, update in said
                            if update.secondary == number and update.kind == CORRELATED and update.track.state != COASTING)
        before = next(update.identity for time, update in reversed(said) if time < first and update.kind == CORRELATED)
        scans = round((done - first) / scene["radars"][0]["rotation_period_s"]) + 1
        lines.append((f"scans until a new secondary number is correlated: {name}", str(document), str(scans),
                      ("as the paper" if scans == document else "NOT as the paper") +
                      ("; the aircraft keeps its identity" if joined.identity == before else "; the aircraft's identity CHANGES")))
    return lines


# ---- a dense scene ----------------------------------------------------------------------------------------------------------------

def dense(runs, seeds, Sample, verdict):
    scene = runs.scenario("bel_dense")
    measured = {scheme: [runs.evaluate(fly(runs, scene, scheme, seed), SETTINGS)["correlated"] for seed in seeds] for scheme, _ in SCHEMES}

    def sample(scheme, part, metric):
        return Sample([run[part][metric] for run in measured[scheme]])

    lines = []
    for part, metric, claim, digits in (("correlation", "miscorrelations_per_hour", "updates an hour with another aircraft's code", 0),
                                        ("metrics", "swaps_per_truth_hour", "changes of identity for each aircraft and hour", 2)):
        alone = sample("distance", part, metric)
        for scheme, name in SCHEMES:
            own = sample(scheme, part, metric)
            lines.append((f"60 aircraft, {claim}: {name}", "no number", own.in_words(digits=digits),
                          "" if scheme == "distance" else f"fewer than by distance: {verdict(alone - own)}"))
    return lines


# ---- cost and a real radar --------------------------------------------------------------------------------------------------------

def in_short(number):
    return f"{number:.0f}" if number >= 100 else f"{number:.3g}"


def cost(runs):
    found = benchmarks(runs, "track_correlator", "CorrelatorTurnByHistory")
    counts = sorted(int(name.rsplit("/", 1)[1]) for name in found)
    sectors = {n: found[f"CorrelatorTurnByHistory/{n}"] / 64 / 1000.0 for n in counts}
    draw(runs, "bel_cost.png", counts, {"a sector": list(sectors.values())}, "tracks of each radar", "time of one sector [µs]")
    return [(f"{n} tracks of each radar in real time", "no number", f"{in_short(time)} µs a sector",
             f"{100 * time / (6e6 / 64):.2g} % of a sector's time at 6 s a turn") for n, time in sectors.items()]


def real_radar(runs):
    claim = "a real radar: a secondary track holds one code"
    file = pathlib.Path(os.environ.get("TWS_SHARED", ""), "data", "asterix_msr_canalA", "canalA.gps")
    if not os.environ.get("TWS_SHARED") or not file.is_file():
        return [(claim, "no number", "not measured: TWS_SHARED names no folder with the recording", "")]
    codes, firm, kinds = collections.defaultdict(list), set(), collections.Counter()
    with rosbag.Bag(str(runs.offline(file))) as bag:
        for topic, message, _ in bag.read_messages(["/ssr/tracks", "/correlated/tracks"]):
            for entry in message.tracks:
                track, who = (entry, ("track", entry.uid)) if topic == "/ssr/tracks" else (entry.track, ("identity", entry.identity))
                if topic == "/correlated/tracks":
                    kinds[entry.kind] += 1
                if track.state == FIRM and track.mode_3a != UNKNOWN:
                    firm.add(who)
                    if track.mode_3a not in codes[who][-1:]:
                        codes[who].append(track.mode_3a)
    lines = []
    for what, plural in (("track", "secondary tracks"), ("identity", "own identities")):
        held = [len(codes[who]) for who in firm if who[0] == what]
        one = sum(count == 1 for count in held)
        lines.append((claim if what == "track" else "a real radar: an aircraft under one identity holds one code", "no number",
                      f"{statistics.mean(held):.3f} codes in a row for each of {len(held)} {plural}; {one} hold one",
                      "no truth: aircraft do change their codes"))
    share = kinds[CORRELATED] / sum(kinds.values())
    lines.append(("a real radar: position and codes come back as one track", "no number",
                  f"{100 * share:.1f} % of {sum(kinds.values())} updates", ""))
    return lines
