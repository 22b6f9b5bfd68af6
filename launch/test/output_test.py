#!/usr/bin/env python3
"""What becomes of the output on a full disk, and of the input when both are the same: output_test.py PATH_OF_TWS_OFFLINE

If this fails, a program ends well with half of its results, or destroys what it was to read.
"""
import pathlib
import resource
import subprocess
import sys
import tempfile
import unittest

import rosbag

SCENARIOS = pathlib.Path(__file__).resolve().parent.parent / "scenarios"
MEASURED = "series,t_s,measured\n" + "".join(f"a,{i},{3 * i}\n" for i in range(20000))
PLOTS = "t_s,radar,scan,range_m,az_deg\n" + "".join(f"{4 * i + 2},a,{i},{50000 - 800 * i},180\n" for i in range(40))
TRUTH = "t_s,truth_id,x_m,y_m\n" + "".join(f"{i},1,{i},0\n" for i in range(200))
TRACKS = TRUTH.replace("truth_id", "track_id")


def run(*words, limit=None, stdout=subprocess.PIPE):
    """`limit`: of a file's size [bytes], as on a disk that is nearly full."""
    def lower():
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.run([str(word) for word in words], stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=120, check=False,
                          preexec_fn=lower)


class Output(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for name, text in (("measured", MEASURED), ("plots", PLOTS), ("truth", TRUTH), ("tracks", TRACKS)):
            (self.folder / name).write_text(text)
        programs = OFFLINE.parent.parent
        filter_csv, adit_csv = programs / "range_gate_tracker" / "filter_csv", programs / "adit_tracker" / "adit_csv"
        score = [programs / "track_evaluation" / "evaluate_csv", "--truth", self.folder / "truth", "--tracks", self.folder / "tracks"]
        # Words that an output follows, and the input that it must not be.
        self.writers = [([filter_csv, "--in", self.folder / "measured", "--out"], "measured"),
                        ([adit_csv, "--detections", self.folder / "plots", "--radar", "a:4:0", "--tracks"], "plots"),
                        ([*score, "--json"], "truth"), ([*score, "--series"], "tracks"), ([*score, "--picture"], "truth")]
        self.score = score

    def refused(self, done, *words):
        self.assertEqual(done.returncode, 1, done)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(str(word), done.stderr)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_half_a_file_is_none_and_status_1(self):
        before = self.files()
        for words, _ in self.writers:
            self.refused(run(*words, self.folder / "out", limit=100), self.folder / "out", "cannot be written")
            self.assertEqual(self.files(), before)
            self.assertEqual(run(*words, self.folder / "out").returncode, 0, words)
            (self.folder / "out").unlink()

    def test_the_input_is_never_the_output(self):
        for words, name in self.writers:
            path = self.folder / name
            text = path.read_text()
            self.refused(run(*words, path), path, "is the input itself")
            self.assertEqual(path.read_text(), text)

    def test_devices_and_links_are_no_output(self):
        (self.folder / "link").symlink_to(self.folder / "truth")
        for words, _ in self.writers:
            for output in ("/dev/null", self.folder / "link", self.folder / "no" / "folder"):
                self.refused(run(*words, output), output)
        self.assertEqual((self.folder / "truth").read_text(), TRUTH)

    def test_a_table_that_nobody_gets_is_no_success(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            self.refused(run(*self.score, stdout=full), "standard output")

    def test_an_offline_run_on_a_full_disk_ends_in_one_line_and_its_bag_can_be_read(self):
        out = self.folder / "out"
        done = run(OFFLINE, SCENARIOS / "adit_nominal.yaml", "--out", out, limit=19 * 2**20)
        self.assertEqual(done.returncode, 1, done)
        self.assertIn(f"{out}/run.bag: the disk is nearly full (16 MB left)", done.stderr.splitlines()[-1])
        with rosbag.Bag(str(out / "run.bag")) as bag:
            self.assertGreater(bag.get_message_count("/adit/tracks"), 100)
        self.refused(run(OFFLINE, SCENARIOS / "one_aircraft.yaml", "--out", out, limit=1000), "run.bag")


if __name__ == "__main__":
    OFFLINE = pathlib.Path(sys.argv.pop(1))
    unittest.main()
