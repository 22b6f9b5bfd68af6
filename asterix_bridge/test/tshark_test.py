#!/usr/bin/env python3
"""Compares what asterix_csv decodes with tshark's decoding, record by record and field by field: tshark_test.py PATH_OF_ASTERIX_CSV.

Needs tshark and the folder that TWS_SHARED names; else it is skipped. The framing is read here once more, independently.
"""
import csv
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

ASTERIX_CSV = sys.argv.pop(1)
SHARED = os.environ.get("TWS_SHARED", "")
DATA = os.path.join(SHARED, "data")
PORT = 8600


def chain(data, before=0, behind=0):
    """The blocks one behind the other, each with so many bytes before and behind it."""
    position = 0
    while position < len(data):
        start = position + before
        length = struct.unpack(">H", data[start + 1:start + 3])[0]
        yield data[start:start + length]
        position = start + length + behind


def datagrams(data):
    """The payloads of the Ethernet/IPv4/UDP packets of a pcap file with the least significant byte first."""
    position = 24
    while position < len(data):
        length = struct.unpack("<I", data[position + 8:position + 12])[0]
        packet = data[position + 16:position + 16 + length]
        size = struct.unpack(">H", packet[38:40])[0]
        yield packet[42:34 + size]
        position += 16 + length


# The track profile of CAT001, with the items' lengths (0: as long as the last bit is set), and the plot profile's order.
TRACK = [("010", 2), ("020", 0), ("161", 2), ("040", 4), ("042", 4), ("200", 4), ("070", 2), ("090", 2), ("141", 2), ("130", 0),
         ("131", 1), ("120", 1), ("170", 0), ("210", 0)]
PLOT = ["010", "020", "040", "070", "090", "130", "141"]


def track_items(records):
    """The items of each track record of a CAT001 block."""
    while records:
        octets = 1
        while records[octets - 1] & 1:
            octets += 1
        present = [place for place in range(7 * octets) if records[place // 7] & 0x80 >> place % 7]
        records, items = records[octets:], {}
        for name, length in (TRACK[place] for place in present):
            if length == 0:
                length = next(i for i, octet in enumerate(records) if not octet & 1) + 1
            items[name], records = records[:length], records[length:]
        yield items


def as_plots(block):
    """A block of CAT001 tracks as plots: tshark 4.0 reads tracks, too, by the plot profile. The items have the same formats."""
    if block[0] != 1 or not next(track_items(block[3:]))["020"][0] & 0x80:
        return block
    records = b""
    for items in track_items(block[3:]):
        fspec = sum(0x80 >> place for place, name in enumerate(PLOT) if name in items)
        records += bytes([fspec]) + b"".join(items.get(name, b"") for name in PLOT)
    return block[:1] + struct.pack(">H", len(records) + 3) + records


def write_pcap(blocks, path):
    """One UDP packet a block."""
    with open(path, "wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 1))
        for block in blocks:
            udp = struct.pack(">HHHH", PORT, PORT, 8 + len(block), 0) + block
            ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0, b"\x7f\0\0\1", b"\x7f\0\0\1")
            frame = bytes(12) + b"\x08\0" + ip + udp
            file.write(struct.pack("<IIII", 0, 0, len(frame), len(frame)) + frame)


def tshark_records(blocks):
    """For each record its category and a map from field name to what tshark shows."""
    with tempfile.TemporaryDirectory() as folder:
        pcap = os.path.join(folder, "blocks.pcap")
        write_pcap(blocks, pcap)
        command = ["tshark", "-r", pcap, "-d", f"udp.port=={PORT},asterix", "-T", "pdml"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
            for _, element in xml.etree.ElementTree.iterparse(process.stdout):
                if element.tag != "packet":
                    continue
                for block in element.iterfind("proto[@name='asterix']"):
                    category = int(block.find("field[@name='asterix.category']").get("show"))
                    for record in block.iterfind("field[@name='asterix.message']"):
                        yield category, {f.get("name").removeprefix(f"asterix.{category:03d}_"): f.get("show")
                                         for f in record.iter("field")}
                element.clear()


def bits(*names):
    """The flags of an item as a string of digits."""
    return lambda fields: "".join(fields[name] for name in names) if names[0] in fields else ""


def octal(name):
    return lambda fields: f"{int(fields[name]):04o}" if name in fields else ""


def text(name):
    return lambda fields: fields.get(name, "").strip()


def number(name):
    return lambda fields: float(fields[name]) if name in fields else ""


def integer(name):
    return lambda fields: str(int(fields[name], 0)) if name in fields else ""


def level(name):
    """tshark 4.0 shows this signed number of 14 bits without its sign."""
    return lambda fields: (float(fields[name]) + 2048) % 4096 - 2048 if name in fields else ""


def flag(name):
    return lambda fields: fields.get(name, "0")


SOURCE = {"sac": integer("010_SAC"), "sic": integer("010_SIC")}
TARGET = {**SOURCE, "rho_nm": number("040_RHO"), "theta_deg": number("040_THETA"), "mode3a": octal("070_MODE3A"),
          "mode3a_vgl": bits("070_V", "070_G", "070_L"), "mode2": octal("050_MODE2"),
          "fl_vg": bits("090_V", "090_G"), "sim": flag("020_SIM"), "test": flag("020_TST"), "spi": flag("020_SPI"), "rab": flag("020_RAB")}
MARK = {**SOURCE, "type": integer("000_VALUE"), "time_of_day": number("030_VALUE"), "sector_deg": number("020_VALUE"),
        "period_s": number("041_VALUE")}
FIELDS = {
    1: {**TARGET, "type": integer("020_SSRPSR"), "is_track": flag("020_TYP"), "time_of_day": number("141_VALUE"),
        "fl": level("090_HGT"), "power_dbm": number("131_VALUE"), "i001_130": lambda f: f.get("130_IND", "0")},
    2: MARK,
    34: {**MARK, "lat_deg": number("120_LAT"), "lon_deg": number("120_LON"), "height_m": number("120_HGT"),
         "nogo": text("050_COM_NOGO")},
    48: {**TARGET, "x_nm": number("042_X"), "y_nm": number("042_Y"), "speed_nm_s": number("200_GSP"), "heading_deg": number("200_HDG"),
         "type": integer("020_TYP"), "time_of_day": number("140_VALUE"), "fl": level("090_FL"), "track": integer("161_TRN"),
         "address": lambda f: f"{int(f['220_VALUE'], 16):06X}" if "220_VALUE" in f else "", "callsign": text("240_VALUE"),
         "height_3d_ft": number("110_3DH"), "doppler_m_s": number("120_CAL_CAL"), "srl_deg": number("130_SRL_VALUE"),
         "srr": number("130_SRR_VALUE"), "sam_dbm": number("130_SAM_VALUE"), "prl_deg": number("130_PRL_VALUE"),
         "pam_dbm": number("130_PAM_VALUE"), "rpd_nm": number("130_RPD_VALUE"), "apd_deg": number("130_APD_VALUE")},
}


def differences(ours, category, fields):
    """What our line says otherwise than tshark's fields."""
    for column, expected in FIELDS[category].items():
        wanted, got = expected(fields), ours[column]
        same = abs(float(got) - wanted) < 1e-8 * max(1.0, abs(wanted)) if isinstance(wanted, float) and got else got == wanted
        if not same:
            yield f"{column}: {got!r}, tshark {wanted!r}"


@unittest.skipUnless(SHARED, "TWS_SHARED is not set")
@unittest.skipUnless(shutil.which("tshark"), "tshark is not installed")
class Tshark(unittest.TestCase):
    # If this fails, a plot may be drawn elsewhere than the radar says, or with another aircraft's code.
    def compare(self, name, blocks, least):
        path = os.path.join(DATA, name)
        with open(path, "rb") as file:
            blocks = list(blocks(file.read()))
        done = subprocess.run([ASTERIX_CSV, "--records", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        ours = list(csv.DictReader(done.stdout.splitlines()))
        compared = fields_seen = 0
        for category, fields in tshark_records(b for b in blocks if b[0] in FIELDS):
            self.assertLess(compared, len(ours), "tshark has more records")
            line = ours[compared]
            self.assertEqual(int(line["category"]), category)
            self.assertEqual(list(differences(line, category, fields)), [], f"{name}, record {compared}")
            fields_seen += sum(1 for expected in FIELDS[category].values() if expected(fields) != "")
            compared += 1
        self.assertEqual(compared, len(ours))
        self.assertGreaterEqual(compared, least)
        print(f"{name}: {compared} records, {fields_seen} fields agree", file=sys.stderr)

    def test_48_minutes_of_cat001_and_cat002(self):
        self.compare("asterix_msr_canalA/canalA.gps", lambda data: chain(data[2200:], behind=10), 30651 + 716)

    def test_packets_of_cat034_and_cat048(self):
        self.compare("asterix_packets/cat_034_048.pcap", lambda data: (b for d in datagrams(data) for b in chain(d)), 162)

    def test_tracks_of_cat001(self):
        self.compare("asterix_packets/cat_001_002.pcap", lambda data: (as_plots(b) for d in datagrams(data) for b in chain(d, before=6)), 8)

    def test_what_only_tracks_of_cat001_have(self):
        path = os.path.join(DATA, "asterix_packets", "cat_001_002.pcap")
        with open(path, "rb") as file:
            blocks = [b for d in datagrams(file.read()) for b in chain(d, before=6)]
        done = subprocess.run([ASTERIX_CSV, "--records", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=60)
        ours = [line for line in csv.DictReader(done.stdout.splitlines()) if line["category"] == "1"]
        tracks = [items for block in blocks if block[0] == 1 for items in track_items(block[3:])]
        self.assertEqual(len(ours), len(tracks))
        for line, items in zip(ours, tracks):
            speed, heading = struct.unpack(">HH", items["200"])
            self.assertEqual(int(line["track"]), struct.unpack(">H", items["161"])[0])
            self.assertAlmostEqual(float(line["speed_nm_s"]), speed / 2 ** 14, 9)
            self.assertAlmostEqual(float(line["heading_deg"]), heading * 360 / 2 ** 16, 7)

    def test_a_single_block_of_cat048(self):
        self.compare("asterix_packets/cat048.raw", chain, 1)

    def test_categories_that_are_not_decoded_are_named(self):
        for name in ("cat_062_065.pcap", "cat062cat065.raw"):
            done = subprocess.run([ASTERIX_CSV, os.path.join(DATA, "asterix_packets", name)], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True, timeout=60)
            self.assertEqual(done.returncode, 1)
            self.assertIn("category 62 is not decoded", done.stderr)
            self.assertIn("category 65 is not decoded", done.stderr)


if __name__ == "__main__":
    unittest.main()
