"""DDRE A-5/2005 (Sams, Lewis and Hviid): range tracking for the MRS radar. The whole loop runs: radar, tracker, gate. Signal-to-noise
ratios are those of the target's mean cross-section to the noise in the detection window of 24 bins; a bin alone has 14 dB more."""
import copy
import json
import math
import statistics

import rosbag
import yaml

TITLE = "DDRE A-5/2005: range tracking for the MRS radar"
FIGURES = [("1", "mrs_aircraft_no_background", "150 m/s, no background subtracted"),
           ("2", "mrs_aircraft", "150 m/s, local background subtracted"),
           ("3", "mrs_ship", "2.5 m/s")]
RCS, SPEED, WINDOW_BINS, NEAR, FAR = 3.0, 150.0, 24, 30000.0, 33000.0  # of the flight straight away
SETTLED = 4.0                                                          # from the start, eight times tau [s]
RATIOS = [20, 10, 6, 3]                                                # [dB]
METHODS = [("none", "no background"), ("local", "local background")]


def rows(runs, seeds, Sample, verdict):
    return [*figures(runs, Sample), *lag(runs, Sample), *noise(runs, seeds, Sample, verdict), *interferer(runs, seeds, Sample, verdict)]


# ---- what a bag says --------------------------------------------------------------------------------------------------------------

def truth_of(bag, target):
    """Times and slant ranges of a target from the radar."""
    site, times, ranges = None, [], []
    for topic, message, _ in bag.read_messages(["/tf_static", "/truth"]):
        if topic == "/tf_static":
            site = next((t.transform.translation for t in message.transforms if t.child_frame_id == "mrs"), site)
            continue
        for entry in message.targets:
            if entry.name == target:
                p = entry.position
                times.append(message.header.stamp.to_sec())
                ranges.append(math.dist((p.x, p.y, p.z), (site.x, site.y, site.z)))
    return times, ranges


def interpolated(times, values, time):
    step = times[1] - times[0]
    index = min(max(int((time - times[0]) / step), 0), len(times) - 2)
    return values[index] + (values[index + 1] - values[index]) * (time - times[index]) / step


def look(bag_file, target="aircraft", settled=SETTLED):
    """Where the target was in the gate, and how the measured and the smoothed range err."""
    inside, errors, lags, tracked = [], [], [], []
    with rosbag.Bag(str(bag_file)) as bag:
        times, ranges = truth_of(bag, target)
        for topic, message, _ in bag.read_messages(["/mrs/range_profile", "/mrs/range_gate"]):
            time = message.header.stamp.to_sec()
            true = interpolated(times, ranges, time)
            if time - times[0] < settled:
                continue
            if topic == "/mrs/range_profile":
                inside.append(message.range_min <= true <= message.range_min + message.bins * message.bin_size)
                continue
            hit = not math.isnan(message.measured_range)
            if hit:
                errors.append(message.measured_range - true)
            if not math.isnan(message.smoothed_range):
                lags.append(true - message.smoothed_range)
            tracked.append(hit and abs(message.measured_range - true) < message.window)
    middle = [e for e in errors if abs(e) < 100.0] or [math.nan]
    return {"inside": statistics.mean(inside), "on_target": statistics.mean(tracked), "bias": statistics.mean(middle),
            "spread": statistics.pstdev(middle), "lag": statistics.mean(lags) if lags else math.nan,
            "all_spread": statistics.pstdev(errors) if errors else math.nan}


# ---- scenes -----------------------------------------------------------------------------------------------------------------------

def parameters(runs, name, **changes):
    tree = yaml.safe_load((runs.package("range_gate_tracker") / "config" / f"{name}.yaml").read_text())
    tree.update(changes)
    return tree


def straight_away(runs, ratio, seconds=20):
    """An aircraft that flies straight away, so far that its signal-to-noise ratio hardly changes; no sea clutter, no other aircraft."""
    scene = copy.deepcopy(runs.scenario("mrs_aircraft"))
    radar = scene["range_radars"][0]
    radar.pop("sea_clutter")
    radar.update(noise_range_m=(NEAR + FAR) / 2, noise_rcs_m2=RCS / 10 ** (ratio / 10) / WINDOW_BINS)
    aircraft = next(t for t in scene["targets"] if t["name"] == "aircraft")
    aircraft.update(east_m=0, north_m=NEAR, height_m=600, course_deg=0, speed_mps=SPEED, rcs_m2=RCS)
    return dict(scene, duration_s=seconds, truth_period_s=0.1, targets=[aircraft])


def fly(runs, scene, tracker, seed, **options):
    key = json.dumps([scene, tracker, seed], sort_keys=True)
    if key not in runs.known:
        bag = runs.offline(scene, "--seed", seed, "--params", f"range_gate_tracker={runs.file('range.yaml', tracker)}")
        runs.known[key] = look(bag, **options)
    return runs.known[key]


def measured(runs, scene, tracker, seeds, Sample, metric):
    return Sample([fly(runs, scene, tracker, seed)[metric] for seed in seeds])


# ---- claims -----------------------------------------------------------------------------------------------------------------------

def figures(runs, Sample):
    lines = []
    for number, name, words in FIGURES:
        scene = dict(runs.scenario(name), truth_period_s=0.1)
        target = scene["range_radars"][0]["target"]
        bag = runs.offline(scene)
        if runs.figures:
            runs.tool("range_gate_tracker", "range_gate_view", "figure", bag, "--out",
                      (runs.figures / f"mrs_figure_{number}.png").absolute())
        found = look(bag, target, settled=10.0)
        share = found["inside"]
        lines.append((f"figure {number}: the method solves the tracking problem ({words})", "a figure",
                      f"target in the gate {100 * share:.1f} % of the time, "
                      f"measured with {found['bias']:+.1f} ± {found['spread']:.1f} m (bias, spread)",
                      "confirmed" if share > 0.99 else f"NOT always: {100 * (1 - share):.1f} % outside"))
    return lines


def lag(runs, Sample):
    """Of the filter, eqs. (8) to (10): v·Δt·α/(1-α), by the mean rate of the slant range."""
    lines = []
    for tau in (0.25, 0.5, 1.0):
        scene = straight_away(runs, 30)
        scene["targets"][0].update(swerling=0, scatterers=1, length_m=0)
        found = fly(runs, scene, parameters(runs, "aircraft", damping_time_s=tau), 1)
        alpha = math.exp(-0.02 / tau)
        rate = SPEED * math.cos(math.asin(575.0 / ((NEAR + FAR) / 2)))
        expected = rate * 0.02 * alpha / (1 - alpha)
        lines.append((f"lag of the damped range, tau = {tau} s", f"v dt alpha / (1 - alpha) = {expected:.1f} m", f"{found['lag']:.1f} m",
                      "confirmed" if abs(found["lag"] - expected) < 1.0 else "CONTRADICTED"))
    return lines


def noise(runs, seeds, Sample, verdict):
    lines = []
    for ratio in RATIOS:
        scene = straight_away(runs, ratio)
        spreads = {}
        for method, words in METHODS:
            tracker = parameters(runs, "aircraft", background=method)
            inside, on_target, bias, spreads[method] = (measured(runs, scene, tracker, seeds, Sample, m)
                                                        for m in ("inside", "on_target", "bias", "spread"))
            lines.append((f"{ratio} dB in the window, {words}", "no number",
                          f"in the gate {inside.in_words('%', 100, 1)}, measured {on_target.in_words('%', 100, 1)}, "
                          f"bias {bias.in_words('m', digits=1)}, spread {spreads[method].in_words('m', digits=1)}",
                          "" if method == "none" else
                          "smaller spread with background subtraction: " + verdict(spreads["none"] - spreads["local"])))
    return lines


def interferer(runs, seeds, Sample, verdict):
    """Another aircraft comes the other way in the same beam, twice as large, and meets the first after ten seconds."""
    scene = straight_away(runs, 20)
    other = dict(scene["targets"][0], name="other", east_m=30, north_m=NEAR + 20 * SPEED, course_deg=180, rcs_m2=2 * RCS)
    scene["targets"].append(other)
    lines, shares = [], {}
    for limit, words, changes in ((0, "as in the report, the whole gate", {}), (50, "with a jump limit of 50 m", {}),
                                  (30, "with Kalman predictor and jump limit of 30 m",
                                   {"predictor": "kalman", "acceleration_density": 1.0})):
        tracker = parameters(runs, "aircraft", jump_limit_m=limit, **changes)
        shares[limit] = measured(runs, scene, tracker, seeds, Sample, "inside")
        on_target = measured(runs, scene, tracker, seeds, Sample, "on_target")
        lines.append((f"an interferer passes through, {words}", "no number",
                      f"in the gate {shares[limit].in_words('%', 100, 1)}, measured {on_target.in_words('%', 100, 1)}",
                      "" if limit == 0 else "longer in the gate than in the report: " + verdict(shares[limit] - shares[0])))
    return lines
