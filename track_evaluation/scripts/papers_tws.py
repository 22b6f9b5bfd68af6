"""Henery (Witwatersrand 1985): track-while-scan. The filters run on series of positions by filter_csv, the windows in the whole graph."""
import math
import random
import statistics

TITLE = "The system design of a radar track-while-scan facility (Henery, University of the Witwatersrand 1985)"
T = 6.0        # of a scan [s]
SIGMA = 100.0  # of a measured position [m]
FLIGHTS = 40   # of each kind and seed
SETTINGS = {"cutoff_m": 3000.0, "from_s": 60.0}
DURATION = 300
# Name, arguments of filter_csv. Gains by Kalata's index for the manoeuvre that the Kalman filters assume, too.
MANOEUVRE = ["--sigma", SIGMA, "--manoeuvre", 5, "--speed", 200]
FILTERS = [("alpha (0.6)", ["--kind", "alpha", "--alpha", 0.6]),
           ("alpha-beta (0.6, 0.25)", ["--kind", "alpha_beta", "--alpha", 0.6, "--beta", 0.25]),
           ("alpha-beta, tracking index", ["--kind", "alpha_beta_index"]), ("adaptive alpha-beta", ["--kind", "adaptive_alpha_beta"]),
           ("alpha-beta-gamma, tracking index", ["--kind", "alpha_beta_gamma_index"]),
           ("Kalman, constant velocity", ["--kind", "kalman_cv"]),
           ("Kalman, constant acceleration", ["--kind", "kalman_ca"])]
MEMORIES = [("fixed, 8 scans", ["--kind", "fixed_memory", "--length", 8]), ("expanding", ["--kind", "expanding_memory"]),
            ("fading, 0.6", ["--kind", "fading_memory", "--theta", 0.6])]


def rows(runs, seeds, Sample, verdict):
    return [*formulas(runs, seeds, Sample), *memories(runs, seeds, Sample, verdict), *filters(runs, seeds, Sample),
            *pass_course(runs, seeds, Sample, verdict), *windows(runs, seeds, Sample)]


# ---- series of positions ------------------------------------------------------------------------------------------------------------

def filtered(runs, options, series):
    """What a filter makes of each series of measured positions, T apart: lists of (position, velocity, predicted)."""
    source, target = runs.folder / "measured.csv", runs.folder / "filtered.csv"
    with open(source, "w") as file:
        file.write("series,t_s,measured\n")
        for number, values in enumerate(series):
            file.writelines(f"{number},{k * T:.1f},{value!r}\n" for k, value in enumerate(values))
    runs.tool("range_gate_tracker", "filter_csv", "--in", source, "--out", target, *options)
    results = [[] for _ in series]
    for line in target.read_text().splitlines()[1:]:
        number, _, position, velocity, _, predicted = line.split(",")
        results[int(number)].append((float(position), float(velocity), float(predicted)))
    return results


def agreement(expected, found, tolerance):
    return "agrees" if abs(found - expected) <= tolerance else "DIFFERS"


def within(expected, sample):
    """Whether the interval over the seeds holds what the formula says; a single seed has none."""
    if math.isnan(sample.half_width):
        return "one seed says nothing"
    return "agrees" if abs(sample.mean - expected) <= sample.half_width else "DIFFERS by more than the interval"


# ---- section 3.3: formulas ------------------------------------------------------------------------------------------------------------

def formulas(runs, seeds, Sample):
    return [*lag(runs), *mean_age(runs), stability(runs), *noise_reduction(runs, seeds, Sample)]


def lag(runs):
    lines, speed = [], 200.0
    for alpha in (0.3, 0.5, 0.8):
        ramp = [speed * T * k for k in range(300)]
        found = ramp[-1] - filtered(runs, ["--kind", "alpha", "--alpha", alpha], [ramp])[0][-1][0]
        expected = speed * T * (1 - alpha) / alpha
        lines.append((f"(3.7): lag of the alpha filter, alpha = {alpha}, 200 m/s", f"{expected:.1f} m", f"{found:.1f} m",
                      agreement(expected, found, 0.01)))
    return lines


def mean_age(runs):
    lines = []
    for alpha in (0.3, 0.8):
        pulse = [0.0] * 300 + [1.0] + [0.0] * 300
        weights = [row[0] for row in filtered(runs, ["--kind", "alpha", "--alpha", alpha], [pulse])[0][300:]]
        found, expected = sum(k * w for k, w in enumerate(weights)), (1 - alpha) / alpha
        lines.append((f"mean age of the alpha filter's data, alpha = {alpha}", f"{expected:.3f} periods", f"{found:.3f} periods",
                      agreement(expected, found, 1e-6)))
    return lines


def stability(runs):
    """On both sides of the edge 4 - 2 alpha - beta = 0, whose filters would be refused outside."""
    calm, refused, points = 0, 0, [(alpha, 4 - 2 * alpha) for alpha in (0.2, 0.6, 1.0, 1.4, 1.8)]
    for alpha, edge in points:
        pulse = [0.0] * 20 + [1.0] + [0.0] * 3000
        end = filtered(runs, ["--kind", "alpha_beta", "--alpha", alpha, "--beta", 0.98 * edge], [pulse])[0][-1]
        calm += abs(end[0]) < 1e-3
        try:
            filtered(runs, ["--kind", "alpha_beta", "--alpha", alpha, "--beta", 1.02 * edge], [pulse])
        except RuntimeError:
            refused += 1
    good = calm == refused == len(points)
    return ("figure 3.5: the alpha-beta filter is stable for 4 - 2 alpha - beta > 0", "a triangle",
            f"{calm} of {len(points)} filters 2 % inside the edge forget a pulse, {refused} of {len(points)} 2 % outside are refused",
            "agrees" if good else "DIFFERS")


def noise_reduction(runs, seeds, Sample):
    lines = []
    for name, options, expected in (
            ("alpha (0.3)", ["--kind", "alpha", "--alpha", 0.3], 0.3 / 1.7),
            ("alpha (0.8)", ["--kind", "alpha", "--alpha", 0.8], 0.8 / 1.2),
            ("alpha-beta (0.5, 0.2)", ["--kind", "alpha_beta", "--alpha", 0.5, "--beta", 0.2], (0.5 + 0.4 - 0.3) / (0.5 * 2.8))):
        ratios = []
        for seed in seeds:
            noise = random.Random(seed)
            series = [noise.gauss(0.0, SIGMA) for _ in range(20000)]
            smoothed = [row[0] for row in filtered(runs, options, [series])[0]]
            ratios.append(statistics.fmean(v * v for v in smoothed[100:]) / statistics.fmean(v * v for v in series[100:]))
        sample = Sample(ratios)
        lines.append((f"small gains smooth well: variance left by {name}", f"no number; formula {expected:.3f}", sample.in_words(digits=3),
                      within(expected, sample)))
    return lines


# ---- targets --------------------------------------------------------------------------------------------------------------------------

def straight(k):
    return 200.0 * T * k, 0.0


def turning(k):
    """200 m/s, from scan 15 on half a turn at 1.5 degrees a second, to scan 35."""
    rate, start, end = math.radians(1.5), 15 * T, 35 * T
    t = min(max(k * T - start, 0.0), end - start)
    x = 200.0 * min(k * T, start) + 200.0 / rate * math.sin(rate * t)
    y = 200.0 / rate * (1 - math.cos(rate * t))
    rest = max(k * T - end, 0.0)
    return x + 200.0 * rest * math.cos(rate * t), y + 200.0 * rest * math.sin(rate * t)


def accelerating(k):
    """100 m/s, from scan 15 on 2.5 m/s^2 for 20 scans: 400 m/s."""
    t = min(max(k - 15, 0), 20) * T
    return 100.0 * T * min(k, 15) + 100.0 * t + 1.25 * t * t + 400.0 * T * max(k - 35, 0), 0.0


TARGETS = [("straight", straight), ("turning", turning), ("accelerating", accelerating)]
SCANS = 50


def flights(target, seed):
    """Measured x and measured y of all flights."""
    noise = random.Random(seed)
    return [[target(k)[axis] + noise.gauss(0.0, SIGMA) for k in range(SCANS)] for _ in range(FLIGHTS) for axis in (0, 1)]


def errors(runs, options, target, seed, column=0):
    """Root mean square distance from the truth at each scan, of the smoothed place or (column 2) the predicted one."""
    results = filtered(runs, [*options, *MANOEUVRE], flights(target, seed))
    squares = [[(row[column] - target(k)[number % 2]) ** 2 for k, row in enumerate(result)] for number, result in enumerate(results)]
    return [math.sqrt(sum(series[k] for series in squares) / FLIGHTS) for k in range(SCANS)]


def rms(values):
    return math.sqrt(statistics.fmean(v * v for v in values))


# ---- section 3.2.3: memories ----------------------------------------------------------------------------------------------------------

def memories(runs, seeds, Sample, verdict):
    lines, curves = [], {}
    for name, options in MEMORIES:
        still = [errors(runs, options, straight, seed) for seed in seeds]
        turn = [errors(runs, options, turning, seed) for seed in seeds]
        curves[name] = turn[0]
        early, later = Sample([rms(run[8:12]) for run in still]), Sample([rms(run[40:]) for run in still])
        claim = {"expanding": "gets increasingly better", "fixed, 8 scans": "weighs its window equally, and forgets the rest",
                 "fading, 0.6": "forgets at an exponential rate"}[name]
        found = verdict(early - later) if name == "expanding" else "stays as it is"
        worst = Sample([max(run) for run in turn])
        lines.append((f"memory: {name}: {claim}", "no number",
                      f"straight flight: {early.in_words('m', digits=0)} after 10 scans, {later.in_words('m', digits=0)} after 45; "
                      f"in a turn up to {worst.in_words('m', digits=0)}",
                      found + ("; a turn is never forgotten" if name == "expanding" else "")))
    draw(runs, "tws_memories.png", "Position error of three memories, turn from scan 15 to 35", curves)
    return lines


# ---- section 3.3: filters side by side --------------------------------------------------------------------------------------------------

def filters(runs, seeds, Sample):
    lines, curves = [], {}
    for name, options in FILTERS:
        parts = []
        for word, target in TARGETS:
            place, predicted = (Sample([rms(errors(runs, options, target, seed, column)[10:]) for seed in seeds]) for column in (0, 2))
            parts.append(f"{word} {place.in_words('m', digits=0)} ({predicted.mean:.0f})")
        curves[name] = errors(runs, options, turning, seeds[0])
        alpha = name.startswith("alpha (")
        lines.append((f"filter: {name}" + (": not normally used for tracking" if alpha else ""), "no number", ", ".join(parts),
                      "confirmed: it lags behind every moving target" if alpha else "position error (of the prediction)"))
    draw(runs, "tws_filters.png", "Position error of the filters, turn from scan 15 to 35",
         {n: c for n, c in curves.items() if not n.startswith("alpha (")})
    return lines


def draw(runs, name, title, curves):
    """A figure where matplotlib is installed and a folder for figures is named."""
    if runs.figures is None:
        return
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("Agg")
    from matplotlib import pyplot
    runs.figures.mkdir(parents=True, exist_ok=True)
    figure, axes = pyplot.subplots(figsize=(8, 4.5), layout="constrained")
    for label, values in curves.items():
        axes.plot(values, label=label)
    axes.axhline(SIGMA * math.sqrt(2.0), color="0.6", linestyle=":", label="of a measurement")
    axes.set(title=title, xlabel=f"scan of {T:.0f} s", ylabel="rms error [m]", yscale="log")
    axes.legend(fontsize=8)
    figure.savefig(runs.figures / name, dpi=110, metadata={"Software": None})
    pyplot.close(figure)


# ---- section 3.2.2: the pass-course effect ----------------------------------------------------------------------------------------------

def passing(k):
    """250 m/s straight past the radar, 5 km off."""
    return -250.0 * T * 20 + 250.0 * T * k, 5000.0


def pass_course(runs, seeds, Sample, verdict):
    options = ["--kind", "alpha_beta", "--alpha", 0.6, "--beta", 0.25]
    sigma_azimuth, polar, plane = 0.005, [], []
    for seed in seeds:
        noise = random.Random(seed)
        measured = [(math.hypot(*passing(k)) + noise.gauss(0.0, SIGMA), math.atan2(*passing(k)) + noise.gauss(0.0, sigma_azimuth))
                    for k in range(40)]
        ranges, azimuths = filtered(runs, options, [[r for r, _ in measured], [a for _, a in measured]])
        xs, ys = filtered(runs, options, [[r * math.sin(a) for r, a in measured], [r * math.cos(a) for r, a in measured]])
        places = [(r[2] * math.sin(a[2]), r[2] * math.cos(a[2])) for r, a in zip(ranges, azimuths)]
        polar.append(rms([math.dist(places[k], passing(k)) for k in range(10, 40)]))
        plane.append(rms([math.hypot(xs[k][2] - passing(k)[0], ys[k][2] - passing(k)[1]) for k in range(10, 40)]))
    polar, plane = Sample(polar), Sample(plane)
    return [("pass-course: straight flight accelerates in polar coordinates", "no number; v²/d = 12.5 m/s²",
             f"prediction off by {polar.in_words('m', digits=0)} in polar, {plane.in_words('m', digits=0)} in Cartesian coordinates",
             verdict(polar - plane))]


# ---- sections 2.4 and 2.5: the windows ------------------------------------------------------------------------------------------------

FIGURES = [("completeness", "aircraft tracked", "%", 100, 1, True), ("rms_pos_m", "position error", "m", 1, 0, False),
           ("rms_vel_mps", "velocity error", "m/s", 1, 0, False), ("spuriousness", "track reports that follow nobody", "%", 100, 1, False),
           ("swaps_per_truth_hour", "changes of track for each aircraft and hour", "", 1, 1, False),
           ("init_delay_med_s", "until a track is firm", "s", 1, 0, False)]


def windows(runs, seeds, Sample):
    scene = dict(runs.scenario("adit_nominal"), duration_s=DURATION)
    radar = scene["radars"][0]["name"]
    alone = dict(scene, radars=scene["radars"][:1])
    trackers = f"{{window_tracker: {{radar: {radar}}}}}"
    one = [runs.evaluate(runs.offline(alone, "--seed", seed, "--trackers", trackers), SETTINGS) for seed in seeds]
    both = [runs.evaluate(runs.offline(scene, "--seed", seed), SETTINGS) for seed in seeds]
    lines = []
    for key, name, unit, scale, digits, more in FIGURES:
        ours, adit = (Sample([found[tracker]["metrics"][key] for found in one]) for tracker in ("tws", "adit"))
        best = Sample([found["adit"]["metrics"][key] for found in both])
        gain = (adit - ours) if more else (ours - adit)
        lines.append((f"adit_nominal, {radar}: {name}", "no number",
                      f"windows {ours.in_words(unit, scale, digits)}; ADIT {adit.in_words(unit, scale, digits)}, "
                      f"with both radars {best.in_words(unit, scale, digits)}",
                      better(gain)))
    return lines


def better(gain):
    if math.isnan(gain.half_width):
        return "one seed says nothing"
    if abs(gain.mean) <= gain.half_width:
        return "no difference to be seen"
    return "ADIT is better" if gain.mean > 0 else "the windows are better"
