#!/usr/bin/python3
"""Checks of tools/bench: bench_test.py REPOSITORY BUILD_FOLDER [NAMES...]. Exit status 0 where all of them hold."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.dont_write_bytecode = True  # no __pycache__ in the sources
REPOSITORY, BUILD = (pathlib.Path(word) for word in sys.argv[1:3])
sys.path.insert(0, str(REPOSITORY / "tools"))

from benchmark import goals, group, page, picture, programs, report, row, samples, stages, tables

SVG = "{http://www.w3.org/2000/svg}"


def line(goal, more_is_better=False):
    return group.Line("key", "what", "ms", goal, more_is_better)


def judged(goal, ours, anchor=None, more_is_better=False):
    """The row of three equal rounds."""
    measured = group.Measured({"key": [ours] * 3}, {"key": [anchor] * 3} if anchor else {})
    return row.rows_of(group.Group("stage", None, [line(goal, more_is_better)]), measured)[0]


class Arithmetic(unittest.TestCase):
    def test_exponent_of_a_power_law(self):
        points = [(x, 3.0 * x ** 1.5) for x in (1, 4, 16, 64)]
        self.assertAlmostEqual(samples.exponent(points), 1.5)
        self.assertAlmostEqual(samples.exponent([(x, 7.0) for x in (1, 2, 4)]), 0)
        self.assertIsNone(samples.exponent([(1, 2.0), (2, 0.0)]))
        self.assertIsNone(samples.exponent([(3, 2.0), (3, 2.0)]))

    def test_ratio_is_the_median_of_the_rounds(self):
        # 2, 3 and 1, of which the middle half reaches from 1.5 to 2.5.
        self.assertEqual(group.ratio([2, 6, 4], [1, 2, 4]), (2, 0.5))
        self.assertEqual(group.ratio([1, 2], None), (None, None))

    def test_rounds_alternate(self):
        order = []

        def called(name):
            order.append(name)
            return {"key": 1.0}

        one = group.Group("stage", called, [], anchor=lambda: called("anchor"), rounds=3)
        measured = group.in_turns(one, "ours", None, quick=False)
        self.assertEqual(order, ["ours", "anchor", "anchor", "ours", "ours", "anchor"])
        self.assertEqual(measured.ours, {"key": [1.0] * 3})


class Goals(unittest.TestCase):
    def test_limits_on_values(self):
        self.assertTrue(judged(goals.Goal(most=200), 200).met)
        self.assertFalse(judged(goals.Goal(most=200), 201).met)
        self.assertTrue(judged(goals.Goal(least=600), 600, more_is_better=True).met)
        self.assertFalse(judged(goals.Goal(least=600), 599, more_is_better=True).met)

    def test_limits_on_ratios(self):
        self.assertTrue(judged(goals.Goal(most_ratio=1.2), 12, 10).met)
        self.assertFalse(judged(goals.Goal(most_ratio=1.2), 12.1, 10).met)
        self.assertFalse(judged(goals.Goal(least_ratio=0.7), 6.9, 10, True).met)
        self.assertIsNone(judged(goals.Goal(least_ratio=0.7), 6.9).met)

    def test_every_limit_has_to_be_kept(self):
        self.assertTrue(judged(goals.START_UP, 1.4, 0.9).met)
        self.assertFalse(judged(goals.START_UP, 1.6, 0.9).met)
        self.assertFalse(judged(goals.START_UP, 1.4, 0.3).met)

    def test_a_tenth_of_the_reference_or_the_floor(self):
        self.assertEqual(goals.of_reference(253).most, 25.3)
        self.assertEqual(goals.of_reference(51).most, 6)

    def test_changes_smaller_than_the_spread_are_none(self):
        def change(ours, others, more):
            measured = group.Measured({"key": ours}, {"key": others})
            return tables.change(row.rows_of(group.Group("stage", None, [line(goals.NONE, more)]), measured)[0])

        self.assertEqual(change([10.0] * 3, [8.0] * 3, False), "WORSE")
        self.assertEqual(change([10.0] * 3, [8.0] * 3, True), "better")
        self.assertEqual(change([8.1] * 3, [8.0] * 3, False), "same")
        self.assertEqual(change([8.0, 10.0, 16.0], [8.0] * 3, False), "same")


class Page(unittest.TestCase):
    def test_text_around_the_tables_stays(self):
        results = report.Report({"Commit": "abc"}, [judged(goals.Goal(most=200), 100)])
        text = ("# Title\n<!-- bench: stages -->\nold\n<!-- bench end -->\nA sentence.\n"
                "<!-- bench: growth with lights -->\nkept\n<!-- bench end -->\n")
        filled = page.filled(text, results)
        self.assertIn("# Title\n<!-- bench: stages -->\n| stage |", filled)
        self.assertNotIn("old", filled)
        self.assertIn("A sentence.\n<!-- bench: growth with lights -->\nkept\n<!-- bench end -->\n", filled)
        self.assertEqual(page.filled(filled, results), filled)

    def test_picture_has_a_bar_a_goal(self):
        rows = [judged(goals.Goal(most=200), 100), judged(goals.Goal(most=200), 400), judged(goals.NONE, 1)]
        rows[0].what = "<&>"
        root = xml.etree.ElementTree.fromstring(picture.svg(report.Report({}, rows)))
        bars = [bar for bar in root.iter(f"{SVG}rect") if bar.get("class") != "paper"]
        self.assertEqual([bar.get("class") for bar in bars], ["met", "missed"])
        goal, = (mark for mark in root.iter(f"{SVG}line") if mark.get("class") == "goal")
        middle = float(goal.get("x1"))
        self.assertAlmostEqual(float(bars[0].get("x")), middle, places=1)
        self.assertAlmostEqual(float(bars[1].get("x")) + float(bars[1].get("width")), middle, places=1)


class Quick(unittest.TestCase):
    def test_all_stages_run(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            done = subprocess.run(
                [REPOSITORY / "tools" / "bench", "--quick", "--build", BUILD, "--json", folder / "a.json", "--svg",
                 folder / "a.svg", "--markdown", folder / "a.md"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            results = json.loads((folder / "a.json").read_text())
            xml.etree.ElementTree.parse(folder / "a.svg")
            self.check_tables((folder / "a.md").read_text())
        self.assertTrue(results["quick"])
        found = {one["stage"] for one in results["rows"]}
        self.assertEqual(found, {stage.STAGE for stage in stages.ALL})
        for one in results["rows"]:
            with self.subTest(stage=one["stage"], what=one["what"]):
                self.assertIn(one["what"], done.stdout if not one["place"] else one["what"])
                self.assertIsNone(one["met"])
                if one["note"] != "not in this build":
                    self.assertGreaterEqual(one["ours"], 0)
        self.assertEqual({table["axis"] for table in results["growth"]}, {"triangles", "lights", "depth", "pixels"})

    def check_tables(self, text):
        """Every row of a table has as many cells as its head."""
        cells = 0
        for text_line in text.splitlines():
            if not text_line.startswith("|"):
                cells = 0
                continue
            cells = cells or text_line.count("|")
            self.assertEqual(text_line.count("|"), cells, text_line)

    def test_packets_meet_what_single_rays_meet(self):
        scene = REPOSITORY / "scenes" / "features" / "trimesh_polygons.ray"
        text = programs.output([BUILD / "bench_kernels", "rays", scene, "--width", "101", "--repetitions", "1"])
        found = {(one["mode"], one["interface"]): one for one in programs.lines(text, "rays")}
        packets = [key for key in found if key[1] == "coherent"]
        for mode, interface in packets:
            one, other = found[mode, "single"], found[mode, interface]
            for count in ("rays", "hits", "shadow", "occluded"):
                self.assertEqual(other[count], one[count], (mode, count))
            # Added in another order.
            self.assertAlmostEqual(float(other["distances"]) / float(one["distances"]), 1, places=8)
        self.assertGreater(int(found["prim+allshadows", "single"]["shadow"]), 0)

    def test_two_builds_are_compared(self):
        done = subprocess.run(
            [REPOSITORY / "tools" / "bench", "--quick", "--build", BUILD, "--against", BUILD / "trace", "--only",
             "rays", "--only", "whole"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        lines = [text_line for text_line in done.stdout.splitlines() if text_line.startswith(("rays", "whole"))]
        self.assertTrue(lines)
        for text_line in lines:  # a program alone has no stages to measure
            self.assertEqual(text_line.startswith("rays"), text_line.endswith("not in this build"), text_line)

    def test_usage(self):
        done = subprocess.run([REPOSITORY / "tools" / "bench", "--only", "nothing"], capture_output=True, check=False)
        self.assertEqual(done.returncode, 2)
        done = subprocess.run([REPOSITORY / "tools" / "bench", "--list"], capture_output=True, text=True, check=False)
        self.assertEqual(done.stdout.split("\n")[:-1], [stage.STAGE for stage in stages.ALL])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
