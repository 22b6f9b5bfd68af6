"""NRL Report 7952 (Cantrell and Wilson 1976): the tracker of asynchronously scanning radars. The tracker flies with the parameter set
nrl7952, the report to the letter, unless a row says otherwise."""
import copy
import math

import rosbag

TITLE = "NRL Report 7952 (1976): tracking system for asynchronously scanning radars"
# Every aircraft counts at every moment, in cover or not, so that scenes with different radars are asked for the same.
ALL = {"cutoff_m": 3000.0, "from_s": 60.0, "least_detection_probability": 0.0}
DURATION = 300
CLUTTER, FIRM = 2, 2


def distance(a, b):
    """Between two (range, azimuth) [m]."""
    return math.hypot(a[0] - b[0], (a[0] + b[0]) * math.sin((a[1] - b[1]) / 2))


def captured_clutter(bag_file):
    """Of the clutter points that are detected more often than not: the share that the clutter map holds at the end."""
    with rosbag.Bag(str(bag_file)) as bag:
        truth = next(message for _, message, _ in bag.read_messages(["/truth"]))
        for _, message, _ in bag.read_messages(["/adit/clutter_map"]):
            last = message
    rocks = [(t.slant_range[0], t.azimuth[0]) for t in truth.targets if t.kind == CLUTTER and max(t.detection_probability) > 0.5]
    held = [(p.range, p.azimuth) for p in last.points if p.absorbing]
    return {"captured": sum(any(distance(rock, p) < 1000.0 for p in held) for rock in rocks) / len(rocks)}


def changed(tree, **changes):
    tree = copy.deepcopy(tree)
    tree.update(changes)
    return tree


def dense(scene):
    """The same aircraft in an eighth of the area."""
    scene = copy.deepcopy(scene)
    scene["random_aircraft"][0]["range_m"] = [10000, 65000]
    return scene


def rows(runs, seeds, Sample, verdict):
    scene = changed(runs.scenario("adit_nominal"), duration_s=DURATION)
    tracker = {key: value for key, value in runs.parameters("nrl7952").items() if key not in ("radars", "reference_radar")}
    ours = {key: value for key, value in runs.parameters("default").items() if key not in ("radars", "reference_radar")}

    def measured(metric, scene, tracker):
        return Sample([runs.fly(scene, tracker, seed, ALL, captured_clutter)[metric] for seed in seeds])

    return [*real_time(measured, scene, tracker, ours), *two_radars(measured, verdict, scene, tracker, ours),
            *five_gates(measured, verdict, dense(scene), tracker), *adaptive_filter(measured, verdict, scene, tracker),
            *clutter(measured, scene, tracker, ours)]


def real_time(measured, scene, tracker, ours):
    lines = []
    for name, parameters in (("nrl7952", tracker), ("default", ours)):
        speed, complete = (measured(metric, scene, parameters) for metric in ("times_real_time", "completeness"))
        enough = "more than real time" if speed.mean - speed.half_width > 1 else "NOT in real time"
        count = scene["random_aircraft"][0]["count"]
        fewer = count * (complete.mean + complete.half_width) < 50
        lines.append(("tracks on 50 to 60 targets in real time", "50-60, 1 x real time",
                      f"{complete.in_words(scale=count, digits=1)} of {count} at once, {speed.in_words(digits=0)} x ({name})",
                      enough + (", but FEWER targets: many are out of cover" if fewer else "")))
    return lines


def two_radars(measured, verdict, scene, tracker, ours):
    lines = []
    for name, parameters in (("nrl7952", tracker), ("default", ours)):
        both = measured("completeness", scene, parameters)
        for radar in scene["radars"]:
            alone = measured("completeness", changed(scene, radars=[radar]), parameters)
            lines.append((f"two radars fade less than {radar['type']} alone", "no number",
                          f"{both.in_words('%', 100, 1)} of aircraft tracked against {alone.in_words('%', 100, 1)} ({name})",
                          verdict(both - alone)))
    return lines


def five_gates(measured, verdict, scene, tracker):
    gates = tracker["track_gates"]
    largest = {key: [values[-1]] * len(values) for key, values in gates.items()}
    single = changed(tracker, track_gates=largest)
    lines = []
    for metric, what, unit, scale in (("swaps_per_truth_hour", "changes of track for each aircraft and hour", "", 1), ("ospa_m", "OSPA", "m", 1)):
        five, one = measured(metric, scene, tracker), measured(metric, scene, single)
        lines.append(("five growing gates correlate better than one", "no number",
                      f"{what} {five.in_words(unit, scale, 1)} against {one.in_words(unit, scale, 1)}, dense scene", verdict(one - five)))
    return lines


def adaptive_filter(measured, verdict, scene, tracker):
    lines = []
    adaptive = measured("rms_pos_m", scene, tracker)
    limits = tracker["alpha_beta"]
    for word, omega in (("slow", limits["omega_min"]), ("fast", limits["omega_max"])):
        fixed = changed(tracker, alpha_beta=changed(limits, omega_min=omega, omega_max=omega))
        error = measured("rms_pos_m", scene, fixed)
        lines.append((f"adaptive bandwidth beats a fixed {word} one ({omega} rad/s)", "no number",
                      f"position error {adaptive.in_words('m', digits=0)} against {error.in_words('m', digits=0)}", verdict(error - adaptive)))
    return lines


def clutter(measured, scene, tracker, ours):
    lines = []
    for name, parameters in (("nrl7952", tracker), ("default", ours)):
        captured, spurious = measured("captured", scene, parameters), measured("spuriousness", scene, parameters)
        most = "most are" if captured.mean - captured.half_width > 0.5 else "FEWER than half"
        lines.append(("clutter points are captured, not tracked", "no number",
                      f"{captured.in_words('%', 100, 1)} captured; {spurious.in_words('%', 100, 1)} of track reports follow nobody ({name})", most))
    return lines
