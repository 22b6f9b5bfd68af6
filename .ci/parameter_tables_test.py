"""If these fail, the pages about parameters lack some or say what is not so."""
import pathlib
import tempfile
import unittest

import yaml

import parameter_tables as tables


def paths(tree, above=""):
    """All keys of a parameter tree as the pages write them."""
    if isinstance(tree, dict):
        for key, value in tree.items():
            yield above + key
            yield from paths(value, above + key + ".")
    elif isinstance(tree, list):
        for value in tree:
            if isinstance(value, dict):
                yield from paths(value, above[:-1] + "[].")


class Pages(unittest.TestCase):
    def rows(self, text):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "x.yaml").write_text(text)
            lines = tables.page(pathlib.Path(folder)).splitlines()
        return [line for line in lines if line.startswith("| `") or line.startswith("| *")]

    def test_every_key_of_every_shipped_file_has_a_row(self):
        files = sorted(tables.ROOT.glob("*/config/*.yaml"))
        self.assertTrue(files)
        for path in files:
            listed = {row.path for row in tables.File(path).rows if row.path}
            known = {key for key in paths(yaml.safe_load(path.read_text()))}
            flow = {key for key in known - listed if "[]" in key}  # of lists of {…}, which stand as the list's value
            self.assertEqual(known - listed - flow, set(), path)

    def test_unit_range_and_meaning_come_from_key_and_comment(self):
        self.assertEqual(self.rows("drop_time_s: 20.0  # A track is kept so long [0.1, 100].\nomega: 0.5  # Bandwidth, rad/s [0, 1].\n"),
                         ["| `drop_time_s` | `20.0` | s | [0.1, 100] | A track is kept so long. |",
                          "| `omega` | `0.5` | rad/s | [0, 1] | Bandwidth. |"])

    def test_a_comment_goes_on_below_and_maps_have_paths(self):
        self.assertEqual(self.rows("gate:      # The gate.\n  kind: a  # One of\n           # two.\n"),
                         ["| `gate` |  |  |  | The gate. |", "| `gate.kind` | `a` |  |  | One of two. |"])

    def test_what_is_commented_out_is_a_parameter_but_a_sentence_is_not(self):
        text = "a: 1\n# limit_s: 5.0  # Longest wait.\n# radars: how they are named\n# udp: x  # required: where from\n"
        self.assertEqual(self.rows(text),
                         ["| `a` | `1` |  |  |  |", "| `limit_s` | `5.0` | s |  | Longest wait. |",
                          "| *radars: how they are named* | | | | |", "| `udp` | required |  |  | required: where from |"])

    def test_files_with_the_same_keys_share_a_table(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "a.yaml").write_text("x: 1  # Size.\n")
            pathlib.Path(folder, "b.yaml").write_text("x: 2  # Size.\n")
            self.assertIn("| `x` | `1` | `2` |  |  | Size. |", tables.page(pathlib.Path(folder)))


if __name__ == "__main__":
    unittest.main()
