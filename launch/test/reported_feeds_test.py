#!/usr/bin/env python3
"""ASTERIX files as people in the field have reported them: reported_feeds_test.py PATH_OF_TWS_OFFLINE.

Needs the folder that TWS_SHARED names, else it is skipped. Its README says what each file is.
"""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

FILES = pathlib.Path(os.environ.get("TWS_SHARED", ""), "data", "reported_inputs", "asterix")
OFFLINE = ""

# File, plots that come out, ADIT's firm tracks and how many it may start at most.
BASE = (540, 12, 13)
TRACKED = {
    # Framings and what stands around the blocks.
    **{name: BASE for name in (
        "base.ast", "base.pcap", "ioss_final.ff", "rff.rff", "first_60_blocks_cat062_then_048.ast", "leading_garbage.ast",
        "split_starts_2_bytes_into_block.ast", "one_byte_missing_in_one_block.ast", "mixed_062_021.ast",
        "mixed_062_021_in_datagram.pcap", "pcap_two_files_concatenated.pcap", "pcap_payload_header12.pcap",
        "pcap_payload_trailer4.pcap", "pcap_with_dns_ssdp_ntp.pcap", "pcap_snaplen60.pcap")},
    "split_second_piece_starts_mid_block.ast": (331, 12, 12),
    # Link layers.
    **{f"pcap_{name}.pcap": BASE for name in (
        "sll", "sll_vlan", "vlan", "qinq_9100", "rawip_101", "rawip_228", "rawip6_229", "null_0", "loop_108", "ipv6",
        "ipv6_hopbyhop", "llc_snap", "llc_asterix", "nano_be")},
    "pcapng_old_packet_block.pcapng": BASE, "pcapng_simple.pcapng": BASE, "pcapng_two_sections.pcapng": BASE,
    "udp_fragmented.pcap": (13500, 300, 320), "udp_unfragmented_same.pcap": (13500, 300, 320),
    # Times that records lack, or that come late.
    **{name: BASE for name in (
        "no_time_of_day.ast", "no_time_of_day.pcap", "plots_3s_after_marks.ast", "sent_once_a_turn.pcap", "reordered_0p3s.ast",
        "midnight_001.ast", "midnight_048.pcap", "pcap_clock_1581s_behind.pcap", "tod_local_time_plus2h.pcap")},
    # The beam: another speed or phase, a clock that was set, slow and fast antennas, a single aircraft.
    "restart_10s_other_phase.ast": (2044, 20, 25), "speed_const_same_flights.ast": (2100, 20, 25),
    "clock_slew_0p5s_back.ast": (780, 12, 15), "clock_slew_2s_ahead.ast": (780, 12, 15), "clock_back_1h.ast": (778, 24, 28),
    "period_4_then_5.ast": (1320, 40, 45), "speed_4_to_5_nomarks.ast": (3600, 40, 46),  # twenty flights in either half
    "period_0.4.ast": (13500, 30, 60), "period_1.25.ast": (4320, 30, 42), "period_12.0.ast": (450, 30, 40),
    "period_60.0.ast": (450, 30, 66), "marks_none_sparse1.ast": (150, 1, 1), "marks_sector_sparse1.ast": (150, 1, 1),
}
BREAKS = ("restart_10s_other_phase.ast", "clock_slew_0p5s_back.ast", "clock_slew_2s_ahead.ast", "period_4_then_5.ast",
          "speed_4_to_5_nomarks.ast")

# File, what its one line says; status 1.
REFUSED = {
    "empty.ast": "the file is empty",
    "text.ast": "this is text",
    "three_bytes.ast": "3 bytes are too few",
    "zeros.ast": "no ASTERIX in a known framing",
    "ff.ast": "no ASTERIX in a known framing",
    "pcap_dataoffset_kuznetzov.pcap": "editcap",
    "pcap_tcp.pcap": "TCP",
    "only_cat062_60_blocks.ast": "category 62 is not decoded",
    "cartesian_only.ast": "reports without measured position",
    "counterclockwise_marks.ast": "turns counter-clockwise, once in 4.000 s",
    "counterclockwise_nomarks.ast": "turns counter-clockwise, once in 4.000 s",
    "tod_stuck.pcap": "all have the same time",
    "i184_issue_packet.ast": "3 up to",
}


def offline(name):
    """FILES / path is the path where it is absolute."""
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([OFFLINE, str(FILES / name), "--out", folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, timeout=300)


def sector_scan(with_marks):
    """The bytes of a radar that scans 270 degrees to and fro in 4.5 s each: CAT048 plots of five targets, CAT034 sector marks."""
    def record(category, seconds, kind, rest):
        content = b"\xF0\x01\x01" + round((36000 + seconds) * 128).to_bytes(3, "big") + kind + rest
        return seconds, struct.pack(">BH", category, len(content) + 3) + content

    def mark(seconds, sector):  # source, type and time stand in another order than in CAT048
        content = b"\xF0\x01\x01\x02" + round((36000 + seconds) * 128).to_bytes(3, "big") + bytes([4 * sector])
        return seconds, struct.pack(">BH", 34, len(content) + 3) + content

    blocks = []
    for sweep in range(60):
        def met(azimuth):
            return 4.5 * (sweep + (azimuth if sweep % 2 == 0 else 270 - azimuth) / 270 % 1.0)
        blocks += [record(48, met(azimuth), b"\x20", struct.pack(">HH", 6400, azimuth * 65536 // 360)) for azimuth in range(13, 260, 50)]
        if with_marks:
            blocks += [mark(met(sector * 5.625), sector) for sector in range(1, 48)]
    return b"".join(block for _, block in sorted(blocks))


class SectorScan(unittest.TestCase):
    # If this fails, tracks are pretended of an antenna that was not understood.
    def test_an_antenna_that_scans_to_and_fro_is_refused(self):
        for with_marks in (False, True):
            with tempfile.TemporaryDirectory() as folder, self.subTest(with_marks=with_marks):
                path = pathlib.Path(folder, "scan.ast")
                path.write_bytes(sector_scan(with_marks))
                done = offline(path)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn("the antenna scans to and fro, at about 60 deg/s: that is not read", done.stderr.splitlines()[-1])


@unittest.skipUnless(os.environ.get("TWS_SHARED"), "TWS_SHARED is not set")
class ReportedFeeds(unittest.TestCase):
    def test_what_can_be_read_is_tracked(self):
        for name, (plots, firm, most) in TRACKED.items():
            with self.subTest(name):
                done = offline(name)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn(f" {plots} ", re.search(r"^asterix +detections +\d+", done.stdout, re.M)[0] + " ")
                started, firmed = map(int, re.search(r"^adit +(\d+) +(\d+) +\d+ ", done.stdout, re.M).groups())
                self.assertEqual(firmed, firm)
                self.assertLessEqual(started, most)
                self.assertEqual(bool(re.search(r"^asterix +beam breaks +1\b", done.stdout, re.M)), name in BREAKS)

    # If this fails, the second time of a file that is joined to itself is mixed with what was left of the first.
    def test_a_file_that_repeats_itself_begins_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            twice = pathlib.Path(folder, "twice.ast")
            twice.write_bytes(2 * (FILES / "base.ast").read_bytes())
            done = offline(twice)
        self.assertEqual(done.returncode, 0, done.stderr)
        counts = {match[1]: int(match[2]) for match in re.finditer(r"^(\w+ +[a-z ]+?) {2,}(\d+)", done.stdout, re.M)}
        self.assertGreater(sum(count for name, count in counts.items() if re.match(r"adit +detections", name)), 1070)
        self.assertNotRegex(done.stdout, "late sectors|duplicate messages|stray sector marks")
        self.assertEqual(len(re.findall(r"new runs +1 !", done.stdout)), 5, done.stdout)
        self.assertRegex(done.stdout, r"(?m)^adit +2[67] +24 ")

    def test_what_cannot_be_read_is_refused_in_one_line(self):
        for name, words in REFUSED.items():
            with self.subTest(name):
                done = offline(name)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(words, done.stderr.strip().splitlines()[-1])


if __name__ == "__main__":
    OFFLINE = sys.argv.pop(1)
    unittest.main()
