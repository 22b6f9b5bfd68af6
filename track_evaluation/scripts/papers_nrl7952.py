"""NRL Report 7952 (Cantrell and Wilson 1976): the tracker of asynchronously scanning radars. The tracker flies with the parameter set
nrl7952, the report to the letter, unless a row says otherwise."""
import copy
import math

import rosbag

import formations
import skies

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
            *clutter(measured, scene, tracker, ours), *clutter_that_comes(runs, seeds, Sample, verdict, tracker, ours),
            *elevation(runs, seeds, Sample, tracker, ours), *bifurcation(runs, seeds, Sample, verdict, ours),
            *more_radars(runs, seeds, Sample, verdict, ours), *skies.rows(runs, seeds, Sample, verdict)]


def real_time(measured, scene, tracker, ours):
    lines = []
    for name, parameters in (("nrl7952", tracker), ("default", ours)):
        speed, complete = (measured(metric, scene, parameters) for metric in ("times_real_time", "completeness"))
        enough = speed.surely_above(1, "more than real time", "NOT in real time")
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
    for metric, what, unit, scale in (("swaps_per_truth_hour", "changes of track for each aircraft and hour", "", 1),
                                      ("ospa_m", "OSPA", "m", 1)):
        five, one = measured(metric, scene, tracker), measured(metric, scene, single)
        lines.append(("five growing gates correlate better than one", "no number",
                      f"{what} {five.in_words(unit, scale, 1)} against {one.in_words(unit, scale, 1)}, dense scene", verdict(one - five)))
    return lines


def adaptive_filter(measured, verdict, scene, tracker):
    lines = []
    adaptive = measured("rms_pos_m", scene, tracker)
    limits = tracker["alpha_beta"]
    for name, omega in (("slow", limits["omega_min"]), ("fast", limits["omega_max"])):
        fixed = changed(tracker, alpha_beta=changed(limits, omega_min=omega, omega_max=omega))
        error = measured("rms_pos_m", scene, fixed)
        lines.append((f"adaptive bandwidth beats a fixed {name} one ({omega} rad/s)", "no number",
                      f"position error {adaptive.in_words('m', digits=0)} against {error.in_words('m', digits=0)}",
                      verdict(error - adaptive)))
    return lines


def clutter(measured, scene, tracker, ours):
    lines = []
    for name, parameters in (("nrl7952", tracker), ("default", ours)):
        captured, spurious = measured("captured", scene, parameters), measured("spuriousness", scene, parameters)
        most = captured.surely_above(0.5, "most are", "FEWER than half")
        lines.append(("clutter points are captured, not tracked", "no number",
                      f"{captured.in_words('%', 100, 1)} captured; "
                      f"{spurious.in_words('%', 100, 1)} of track reports follow nobody ({name})", most))
    return lines


# Of the scenario clutter_comes_and_goes [s]: when rocks and boats appear, and after how long the map is looked at.
APPEARANCE = {"rock": 0, "boat": 100}
AFTER = (10, 20, 40)


def still_things(bag_file, kind):
    """When the run began [s], and the places of what stands still and bears that name."""
    with rosbag.Bag(str(bag_file)) as bag:
        truth = [message for _, message, _ in bag.read_messages(["/truth"])]
    places = {t.name: (t.slant_range[0], t.azimuth[0]) for message in truth for t in message.targets if t.name.startswith(kind)}
    return truth[0].header.stamp.to_sec(), list(places.values())


def clutter_maps(bag_file):
    with rosbag.Bag(str(bag_file)) as bag:
        return [message for _, message, _ in bag.read_messages(["/adit/clutter_map"])]


def held_after(bag_file, kind, seconds):
    """The share of these that the maps (each of them, where each radar has its own) hold so long after they appear."""
    began, places = still_things(bag_file, kind)
    maps = clutter_maps(bag_file)
    then = next(m for m in maps if m.header.stamp.to_sec() >= began + APPEARANCE[kind] + seconds)
    radars = {p.radar for m in maps for p in m.points}
    held = sum(any(p.radar == radar and p.absorbing and distance(place, (p.range, p.azimuth)) < 1000.0 for p in then.points)
               for place in places for radar in radars)
    return held / (len(places) * len(radars))


def tracks_begun(bag_file, seconds):
    """Tracks that begin on rocks in the first seconds of the run."""
    began, rocks = still_things(bag_file, "rock")
    with rosbag.Bag(str(bag_file)) as bag:
        tracks = [w for _, m, _ in bag.read_messages(["/adit/tracks"]) for w in m.tracks]
    early = [w for w in tracks if w.first_detection.to_sec() < began + seconds]
    return len({w.uid for w in early if any(distance(r, (w.range, w.azimuth)) < 1000.0 for r in rocks)})


def saved_map(runs, bag_file, seconds):
    """The map as it was then, as /adit/save_clutter_map writes it."""
    began, _ = still_things(bag_file, "rock")
    then = [m for m in clutter_maps(bag_file) if m.header.stamp.to_sec() <= began + seconds][-1]
    path = runs.folder / "clutter.csv"
    path.write_text("radar,range_m,az_deg\n" + "".join(f"{p.radar or '*'},{p.range:.1f},{math.degrees(p.azimuth):.4f}\n"
                                                       for p in then.points if p.absorbing and p.hits > 1))
    return path


def draw_clutter(bag_file, file):
    """Points of the map against time, by what stands there."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    began, maps = still_things(bag_file, "rock")[0], clutter_maps(bag_file)
    radars = sorted({p.radar for m in maps for p in m.points})
    figure, axes = plt.subplots(1, len(radars), figsize=(10, 3), sharey=True, squeeze=False)
    for panel, radar in zip(axes[0], radars):
        for kind, color in (("rock", "saddlebrown"), ("boat", "tab:blue")):
            _, places = still_things(bag_file, kind)
            for absorbing, style in ((True, "-"), (False, ":")):
                counts = [sum(any(p.radar == radar and p.absorbing == absorbing and distance(place, (p.range, p.azimuth)) < 1000.0
                                  for p in m.points) for place in places) for m in maps]
                panel.step([m.header.stamp.to_sec() - began for m in maps], counts, style, color=color, where="post",
                           label=f"{kind}s, {'absorbing' if absorbing else 'on probation'}")
        for edge in (APPEARANCE["boat"], 240):
            panel.axvline(edge, color="0.7", linewidth=0.8)
        panel.set(title=radar or "common map", xlabel="time [s]", xlim=(0, 330))
    axes[0][0].set_ylabel("of 12 places")
    axes[0][0].legend(fontsize=7, loc="center right")
    figure.tight_layout()
    figure.savefig(file, dpi=100, metadata={"Software": None})
    plt.close(figure)


def clutter_that_comes(runs, seeds, Sample, verdict, tracker, ours):
    scene, lines = runs.scenario("clutter_comes_and_goes"), []
    for name, parameters in (("nrl7952", tracker), ("default", ours)):
        held, bare, knowing = {(kind, after): [] for kind in APPEARANCE for after in AFTER}, [], []
        for seed in seeds:
            options = ["--params", runs.file("tracker.yaml", parameters), "--seed", seed]
            bag = runs.offline(scene, *options)
            for kind, after in held:
                held[kind, after].append(held_after(bag, kind, after))
            if runs.figures and parameters is ours and seed == seeds[0]:
                draw_clutter(bag, runs.figures / "clutter.png")
            bare.append(tracks_begun(bag, 40))
            known = saved_map(runs, bag, 95)
            knowing.append(tracks_begun(runs.offline(scene, *options, "--duration", 60, "--clutter-map", known), 40))
        for kind, what in (("rock", "at the start of a run"), ("boat", "100 s later")):
            shares = [Sample(held[kind, after]) for after in AFTER]
            enough = next((f"most are after {after} s" for share, after in zip(shares, AFTER) if share.mean - share.half_width > 0.5),
                          shares[-1].surely_above(0.5, "", f"FEWER than half after {AFTER[-1]} s"))
            lines.append((f"clutter is captured immediately: {what}", "no number",
                          ", ".join(f"{share.in_words('%', 100, 0)} after {after} s" for share, after in zip(shares, AFTER)) + f" ({name})",
                          enough))
        with_map, without = Sample(knowing), Sample(bare)
        lines.append(("captured clutter is not processed as tracks", "no number",
                      f"{with_map.in_words(digits=1)} tracks begin on 12 rocks in 40 s with the map of the run before, "
                      f"{without.in_words(digits=1)} without ({name})",
                      verdict(without - with_map)))
    return lines


def height_of(target):
    """Above the sea, of a place in the map frame [m]."""
    earth = 6371e3
    return math.hypot(target.position.x, target.position.y, target.position.z + earth) - earth


def searched_heights(bag_file):
    """Of tracks under elevation search: the error of their heights, how often it is within three of its stated sigmas, and the time from
    designation to the first height."""
    designated, first, errors, within, truth = {}, {}, [], [], {}
    with rosbag.Bag(str(bag_file)) as bag:
        for topic, message, _ in bag.read_messages(["/truth", "/adit/tracks"]):
            if topic == "/truth":
                truth = {t.id: t for t in message.targets}
                continue
            for track in message.tracks:
                if track.detection_bits & track.ELEVATION_REQUESTED:
                    designated.setdefault(track.uid, message.header.stamp)
                if math.isnan(track.height):
                    continue
                first.setdefault(track.uid, message.header.stamp)
                near = [t for t in truth.values() if distance((t.slant_range[1], t.azimuth[1]), (track.range, track.azimuth)) < 2000.0]
                if len(near) == 1:
                    errors.append(track.height - height_of(near[0]))
                    within.append(abs(errors[-1]) < 3 * track.height_sigma)
    delays = [(first[uid] - begin).to_sec() for uid, begin in designated.items() if uid in first]
    return {"height_error_m": math.sqrt(sum(e * e for e in errors) / len(errors)), "height_within": sum(within) / len(within),
            "first_height_s": sum(delays) / len(delays)}


def elevation(runs, seeds, Sample, tracker, ours):
    """All aircraft are designated as soon as their tracks are firm."""
    lines = []
    for name, parameters in (("nrl7952", tracker), ("default", ours)):
        automatic = changed(parameters, elevation=changed(parameters["elevation"], automatic=True))
        flights = [runs.fly(runs.scenario("elevation_search"), automatic, seed, ALL, searched_heights) for seed in seeds]
        error, within, delay = (Sample([flight[metric] for flight in flights])
                                for metric in ("height_error_m", "height_within", "first_height_s"))
        lines += [("elevation scans give the heights of designated targets", "no number",
                   f"error {error.in_words('m', digits=0)}, {within.in_words('%', 100, 1)} within 3 stated sigmas ({name})",
                   "they do" if within.mean > 0.95 else "NOT as well as stated"),
                  ("searched for on the next scan, four new targets a scan", "8 s a scan",
                   f"{delay.in_words('s', digits=1)} from designation to the first height, 15 targets at about the same time ({name})",
                   Sample([32 - v for v in delay.values]).surely_above(0, "within four scans", "LATER"))]
    return lines


def bifurcation(runs, seeds, Sample, verdict, ours):
    """Aircraft that part, cross and fly together as one plot (scenario formation_split), with and without the scheme."""
    scene = runs.scenario("formation_split")

    def measured(metric, on):
        parameters = changed(ours, bifurcation=on)
        return Sample([runs.fly(scene, parameters, seed, ALL, formations.figures)[metric] for seed in seeds])

    lines = []
    for metric, what, better, scale, unit, digits in (
            ("two_tracks_in_three_updates", "have two tracks within three updates", 1, 100, "%", 0),
            ("updates_to_two_tracks", "updates until there are two tracks", -1, 1, "", 2),
            ("identities_kept", "of crossing or overtaking pairs keep their tracks", 1, 100, "%", 0),
            ("redundant_tracks", "tracks too many in a run", -1, 1, "", 2)):
        on, off = measured(metric, True), measured(metric, False)
        lines.append(("track bifurcation, in development", "no number",
                      f"{what}: {on.in_words(unit, scale, digits)} against {off.in_words(unit, scale, digits)} without (default)",
                      verdict(on - off if better > 0 else off - on)))
    return lines


def more_radars(runs, seeds, Sample, verdict, ours):
    """The SPS-10, for which the report made provisions; and radars that do not stand "in close proximity"."""
    def measured(metric, scene):
        return Sample([runs.fly(changed(scene, duration_s=DURATION), ours, seed, ALL)[metric] for seed in seeds])

    three = runs.scenario("three_radars")
    three["random_aircraft"] = three["random_aircraft"][:1]  # the fighters near the site
    two = changed(three, radars=three["radars"][:2])
    held = [measured("completeness", scene) for scene in (three, two)]
    error = [measured("rms_pos_m", scene) for scene in (three, two)]
    lines = [("the SPS-10 as a third radar", "no number",
              f"{held[0].in_words('%', 100, 1)} of fighters near the site tracked, with two radars "
              f"{held[1].in_words('%', 100, 1)} (default)", verdict(held[0] - held[1])),
             ("the SPS-10 as a third radar", "no number", f"position error {error[0].in_words('m', digits=0)}, with two radars "
              f"{error[1].in_words('m', digits=0)} (default)", verdict(error[1] - error[0]))]
    scene = runs.scenario("two_sites")
    both, double = measured("completeness", scene), measured("ambiguity", scene)
    for radar in scene["radars"]:
        alone = measured("completeness", changed(scene, radars=[radar]))
        lines.append((f"radars 40 km apart against {radar['type']} alone", "one site only",
                      f"{both.in_words('%', 100, 1)} of aircraft tracked against {alone.in_words('%', 100, 1)}; "
                      f"{double.in_words(digits=3)} tracks for each that has one (default)", verdict(both - alone)))
    return lines
