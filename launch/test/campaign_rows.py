"""The rows of the fault campaign: each breaks one thing, and says what was lost by it. A row is a function of a Campaign."""
import dataclasses
import os
import pathlib
import resource
import subprocess
import sys
import typing

import yaml

from campaign_graph import (CLOSED_LOOPS, RATE, Graph, Outcome, Tracks, check, compare, count_alike, found_again, offline, same_topics,
                            skipped)
from campaign_rows_input import INPUT_ROWS, Bench

HERE = pathlib.Path(__file__).resolve().parent
SCENARIOS = HERE.parent / "scenarios"
SCENARIO = SCENARIOS / "full.yaml"
STOPS = ((40.0, 1.0), (64.0, 6.0), (120.0, 30.0))  # at this data time, for so long [s of wall time]
STOP_DURATION, DURATION, KILL_AT = 280.0, 88.0, 20.0  # [s of data time]
BEFORE, AFTER = (8.0, 20.0), (60.0, 86.0)
TRACKERS = ("adit", "ssr_tracker", "window_tracker", "range_gate_tracker", "frame_builder", "mfa_stub", "track_correlator")
FOUND_AGAIN_AFTER = 24.0  # [s of data time]: coasted, widened and swept once; a gap of a second leaves nothing to sweep for
NOBODY = 65534
ODD_NAMES = ("two  spaces", "it's \"quoted\"", "März 東京", "-dash", "two\nlines", "percent %s `id`", "a$HOME $name")
FEW_FILES, SMALL_FILE = 64, 2**20


@dataclasses.dataclass
class Row:
    """`long`: by name or --all only."""
    name: str
    run: typing.Callable
    long: bool = False
    short: bool = False
    duration: float = DURATION


class Campaign:
    """What a row works with: a folder of its own, and the reference without a fault."""

    def __init__(self, folder, reference):
        self.folder, self.reference = folder, reference

    def graph(self, *words, name="run", scenario=SCENARIO, duration=DURATION, **options):
        return Graph(self.folder, scenario, f"duration:={duration:g}", f"record:={self.bag(name)}", *words, name=name, **options)

    def bag(self, name="run"):
        return self.folder / f"{name}.bag"

    def tracks_after(self, graph, before=BEFORE, after=AFTER, name="run", status=0):
        """Waits for the end of the run, which must have this status, and compares."""
        found = graph.wait_for_end()
        outcome = check(found == status, f"status {found}") if found == status else check(False, f"status {found}: {graph.last_line()}")
        if not self.bag(name).exists():
            return outcome + check(False, "recorded")
        run = Tracks(self.bag(name))
        return outcome + compare(run, self.reference, before, after) + Outcome(text=same_topics(run, self.reference))


def ended(graph, *words, status=1, seconds=60.0):
    """The run must end with this status and say these words."""
    found = graph.wait_for_end(seconds)
    said = graph.words()
    line = next((line for line in said.splitlines() if words and words[0] in line), graph.last_line())
    return check(found == status and all(word in said for word in words), f"status {found}: {line[:160]}")


# ---- nodes that stand or die ----

def stop_and_go(node):
    def row(campaign):
        with campaign.graph(duration=STOP_DURATION) as graph:
            for at, seconds in STOPS:
                graph.wait_until(at)
                graph.stop_for(node, seconds)
            outcome = check(graph.wait_for_end() == 0, "status 0")
        run = Tracks(campaign.bag())
        for at, seconds in STOPS:
            end, loop = at + RATE * seconds, CLOSED_LOOPS.get(node)
            outcome += compare(run, campaign.reference, (at - 12.0, at), (end + 12.0, end + 28.0), but=loop)
            if loop:
                found = end + (FOUND_AGAIN_AFTER if seconds > 1.0 else 12.0)
                outcome += found_again(run, campaign.reference, loop, (at - 12.0, at), (found, found + 8.0))
        return outcome + Outcome(text=same_topics(run, campaign.reference))
    return row


def kill(node, role):
    """As launch/doc/graph.md says: a run ends with its source, and when a tracker or the recorder dies; it goes on without a watcher."""
    def row(campaign):
        with campaign.graph() as graph:
            graph.wait_until(KILL_AT)
            graph.kill(node)
            if role != "watcher":
                return ended(graph, f"node {node} died")
            return campaign.tracks_after(graph, status=1) + ended(graph, f"node {node} died")
    return row


def respawn_adit(campaign):
    with campaign.graph("respawn:=true") as graph:
        graph.wait_until(KILL_AT)
        graph.kill("adit")
        outcome = ended(graph, "node adit died", seconds=120.0)  # It goes on; but somebody should know.
    return outcome + count_alike(Tracks(campaign.bag()), campaign.reference, "/adit/tracks", (70.0, DURATION))


def kill_master_of_its_own(campaign):
    with campaign.graph() as graph:
        graph.wait_until(KILL_AT)
        graph.kill("master")
        return ended(graph, "master")


def kill_roscore(campaign):
    """A master that was there before: nodes that are connected go on without it, to the end of the run."""
    with Bench(campaign.folder) as bench, campaign.graph(master_uri=bench.master_uri) as graph:
        graph.wait_until(KILL_AT)
        graph.kill("master")
        return campaign.tracks_after(graph)


# ---- strangers in the graph ----

def stranger(kind, at=20.0, seconds=5.0):
    def row(campaign):
        with campaign.graph() as graph:
            graph.wait_until(at)
            done = subprocess.run([sys.executable, HERE / "campaign_stranger.py", kind, str(seconds)], env=graph.environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            outcome = check(done.returncode == 0, done.stdout.strip() or done.stderr.strip()[-160:])
            return outcome + campaign.tracks_after(graph)
    return row


# ---- two at once ----

def two_masters(campaign):
    with campaign.graph(name="one") as one, campaign.graph(name="two") as two:
        return campaign.tracks_after(one, name="one") + campaign.tracks_after(two, name="two")


def same_master(campaign):
    with campaign.graph(name="one", duration=40.0) as one:
        one.wait_until(8.0)
        with campaign.graph(name="two", master_uri=one.master_uri) as two:
            outcome = ended(two, "another graph is running")
        return outcome + campaign.tracks_after(one, (8.0, 16.0), (24.0, 38.0), name="one")


# ---- the place where it runs ----

def as_nobody():
    """Words before a command by which root becomes nobody."""
    return ["setpriv", "--reuid", str(NOBODY), "--regid", str(NOBODY), "--clear-groups"] if os.geteuid() == 0 else []


def for_nobody(campaign, name, mode):
    """A folder that nobody can write into, or not; None: that, or this workspace, cannot even be reached."""
    folder = campaign.folder / name
    folder.mkdir(exist_ok=True)
    folder.chmod(mode)
    reached = subprocess.run([*as_nobody(), "test", "-x", folder, "-a", "-r", __file__], check=False).returncode == 0
    return folder if reached else None


def nobody_home(folder):
    return {"HOME": str(folder), "ROS_HOME": str(folder), "ROS_LOG_DIR": str(folder / "log")}


def non_root(campaign):
    if os.geteuid() != 0:
        return skipped("all rows ran as another than root")
    folder = for_nobody(campaign, "home", 0o777)
    if not folder:
        return skipped(f"nobody cannot get into {campaign.folder} or {HERE}")
    at_home = Campaign(folder, campaign.reference)
    with at_home.graph(before=as_nobody(), other=nobody_home(folder)) as graph:
        return at_home.tracks_after(graph)


def read_only(campaign):
    folder, home = for_nobody(campaign, "out", 0o555), for_nobody(campaign, "home", 0o777)
    if not folder:
        return skipped(f"nobody cannot get into {campaign.folder} or {HERE}")
    with Graph(campaign.folder, SCENARIO, f"record:={folder}/run.bag", before=as_nobody(), other=nobody_home(home)) as graph:
        outcome = ended(graph, f"{folder}/run.bag")
    done = subprocess.run([*as_nobody(), "rosrun", "tws_launch", "tws_offline", SCENARIO, "--out", folder], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**os.environ, **nobody_home(home)})
    line = (done.stdout.strip().splitlines() or [""])[-1]
    return outcome + check(done.returncode == 1 and str(folder) in line, f"offline status {done.returncode}: {line[:160]}")


def full_disk(campaign):
    """A disk of its own where the kernel lets it be made; and files that may not grow beyond a limit."""
    disk = campaign.folder / "disk"
    disk.mkdir(exist_ok=True)
    outcome = Outcome()
    own_mounts = ["unshare", "--mount", *([] if os.geteuid() == 0 else ["--map-root-user"])]
    if subprocess.run([*own_mounts, "mount", "-t", "tmpfs", "none", disk], check=False, stderr=subprocess.DEVNULL).returncode == 0:
        script = 'mount -t tmpfs -o size=132m none "$0" && exec "$@"'
        before = [*own_mounts, "sh", "-c", script, disk]
        with Graph(campaign.folder, SCENARIO, f"record:={disk}/run.bag", name="disk", before=before) as graph:
            outcome += ended(graph, "the disk is nearly full", seconds=120.0)
    with campaign.graph(limits=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (SMALL_FILE, SMALL_FILE))) as graph:
        return outcome + ended(graph, "recorder", seconds=120.0)


def odd_names(campaign):
    """The scenario and the bag in folders of such names, offline, live, and replayed."""
    outcome = Outcome()
    for number, name in enumerate(ODD_NAMES):
        folder = campaign.folder / name
        folder.mkdir(exist_ok=True)
        (folder / f"{name}.yaml").write_bytes((SCENARIOS / "one_aircraft.yaml").read_bytes())
        done = offline(f"{name}/{name}.yaml" if name[0] != "-" else f"./{name}/{name}.yaml", folder, 30.0, cwd=campaign.folder)
        outcome += Outcome(1, int(done.returncode != 0), "" if done.returncode == 0 else f"NOT offline {name!r}: {done.stdout[-160:]}")
        with Graph(campaign.folder, folder / "run.bag", f"record:={folder}/again.bag", name=f"name_{number}", rate=10.0) as graph:
            good = graph.wait_for_end() == 0 and (folder / "again.bag").exists()
            outcome += Outcome(1, int(not good), "" if good else f"NOT live {name!r}: {graph.last_line()[:160]}")
    return outcome + Outcome(text=f"{len(ODD_NAMES)} names, offline and replayed")


def few_files(campaign):
    """Either it is enough, or the run ends with a reason."""
    with campaign.graph(limits=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (FEW_FILES, FEW_FILES))) as graph:
        status = graph.wait_for_end()
        if status == 0:
            return campaign.tracks_after(graph)
        return check(status == 1 and "Traceback" not in graph.words(), f"status {status}: {graph.last_line()[:160]}")


def time_zone(campaign):
    zone = {"TZ": "Pacific/Chatham"}
    elsewhere, here = campaign.folder / "elsewhere", campaign.folder / "here"
    for folder, zones in ((elsewhere, zone), (here, {"TZ": "UTC"})):
        done = offline(SCENARIO, folder, 60.0, env={**os.environ, **zones})
        if done.returncode != 0:
            return check(False, done.stdout[-160:])
    outcome = check(Tracks(elsewhere / "run.bag").bytes == Tracks(here / "run.bag").bytes, "offline the same bytes in both zones")
    with campaign.graph(other=zone) as graph:
        return outcome + campaign.tracks_after(graph)


def two_hosts(_):
    done = subprocess.run([sys.executable, HERE / "two_hosts.py"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    line = (done.stdout.strip().splitlines() or [""])[-1]
    return skipped(line) if done.returncode == 77 else check(done.returncode == 0, line)


def roles():
    """Of the nodes, as graph.yaml has them."""
    rows = yaml.safe_load((HERE.parent / "graph.yaml").read_text(encoding="utf8"))["nodes"]
    return {row["name"]: row["role"] for row in rows}


SHORT = {"kill_adit", "day_ahead", "read_only"}
KILLED = ("radar_sim", *TRACKERS, "recorder", "progress", "evaluation")
ROWS = [
    *[Row(f"stop_{node}", stop_and_go(node), duration=STOP_DURATION) for node in (*TRACKERS, "evaluation")],
    *[Row(f"kill_{node}", kill(node, roles()[node])) for node in KILLED],
    *[Row(run.__name__, run) for run in (respawn_adit, kill_master_of_its_own, kill_roscore)],
    *[Row(kind, stranger(kind)) for kind in ("flood", "day_ahead", "clock_ahead", "clock_back")],
    *[Row(run.__name__, run) for run in (two_masters, same_master, non_root, read_only, full_disk, odd_names, few_files, time_zone)],
    *[Row(name, run) for name, run in INPUT_ROWS],
    Row("two_hosts", two_hosts, long=True),
]
for each in ROWS:
    each.short = each.name in SHORT
