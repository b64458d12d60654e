"""`ringfilm optimise`: optima with closed forms, fronts, targets that cannot be met, kills, refusals."""

import json
import shutil
import signal
import subprocess
import time
import unittest

import program

SHIPPED = program.SOURCES / "cases" / "inverse"

BAD = """\
case = "slider.toml"
[[objective]]
quantity = "load"
goal = "maximise"
[[constraint]]
quantity = "min_film_thickness"
at_least = "40 um"
[[variable]]
key = "pad.separation"
lower = "5 um"
upper = "30 um"
"""
RING = """\
case = "case.toml"
[[objective]]
quantity = "fmep"
goal = "minimise"
[[constraint]]
quantity = "min_film_thickness"
at_least = "0.2 um"
[[variable]]
key = "ring.face.crown_height"
lower = "3 um"
upper = "30 um"
[[variable]]
key = "ring.elastic_pressure"
lower = "0.1 MPa"
upper = "0.3 MPa"
[[point]]
name = "slow"
weight = 0.4
values = { "operating.speed" = "1000 rpm" }
[[point]]
name = "fast"
weight = 0.6
values = { "operating.speed" = "3000 rpm" }
[optimise]
starts = 2
evaluations = 40
"""


class OptimiseTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("step.toml", "slider.toml", "rayleigh_step.toml", "load_and_friction.toml"):
            shutil.copy(SHIPPED / name, self.folder)
        (self.folder / "bad.toml").write_text(BAD)
        (self.folder / "ring.toml").write_text(RING)

    def optimised(self, file, *words):
        return json.loads(self.run_well("optimise", file, "--json", *words))


class ClosedForms(OptimiseTest):
    def test_rayleighs_step(self):
        best = self.optimised("rayleigh_step.toml")["best"]
        length, film = 10e-3, 10e-6
        # Published to four digits; the load of a step is exact on any grid.
        self.assertAlmostEqual(1 + best["variables"]["pad.grooves.depth"] / film, 1.866, delta=1e-3)
        self.assertAlmostEqual(best["variables"]["pad.grooves.width"] / 2 / length, 0.718, delta=1e-3)
        coefficient = best["quantities"]["load"] * film**2 / (0.02 * 5 * length**2)
        self.assertAlmostEqual(coefficient, 0.2063, delta=5e-5)

    def test_inclined_slider(self):
        (self.folder / "slope.toml").write_text(
            'case = "slider.toml"\n[[objective]]\nquantity = "load"\ngoal = "maximise"\n'
            '[[variable]]\nkey = "pad.face.height_unit"\nlower = "0.2 um"\nupper = "3 um"\n'
        )
        best = self.optimised("slope.toml")["best"]
        # The film at the outlet is 10 um, the rise ten times the unit: K = 1.1887, flat within the error of the cells.
        self.assertAlmostEqual(best["variables"]["pad.face.height_unit"] * 10 / 10e-6, 1.1887, delta=5e-3)
        self.assertAlmostEqual(best["quantities"]["load"] * 1e-10 / (0.02 * 5 * 1e-4), 0.1602, delta=5e-5)

    def test_front_of_load_and_friction(self):
        found = self.optimised("load_and_friction.toml")
        front = [one["quantities"] for one in found["front"]]
        self.assertGreaterEqual(len(front), 8)
        loads = [one["load"] for one in front]
        friction = [one["friction_moving"] for one in front]
        self.assertEqual(loads, sorted(loads))
        self.assertEqual(friction, sorted(friction))  # more load costs more friction
        self.assertTrue(all(one["min_film_thickness"] >= 8e-6 for one in front))


class Rings(OptimiseTest):
    def test_ring_over_operating_points_meets_its_film(self):
        found = self.optimised("ring.toml")
        best = found["best"]
        films = [point["quantities"]["min_film_thickness"] for point in best["points"]]
        self.assertGreaterEqual(min(films), 0.2e-6)
        mean = sum(w * p["quantities"]["fmep"] for w, p in zip((0.4, 0.6), best["points"]))
        self.assertAlmostEqual(best["quantities"]["fmep"], mean, delta=1e-9 * mean)
        self.assertIn("ring.elastic_pressure at its lower bound", found["at_bounds"])


class Limits(OptimiseTest):
    def test_targets_that_cannot_be_met_have_their_distance(self):
        done = self.run_program("optimise", "bad.toml", "--json")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("min_film_thickness cannot be met", done.stderr)
        found = json.loads(done.stdout)
        self.assertFalse(found["feasible"])
        self.assertIsNone(found["best"])
        self.assertAlmostEqual(found["violated"][0]["by"], 10e-6, delta=1e-8)

    def test_search_continues_after_a_kill(self):
        whole = self.optimised("ring.toml", "-o", "whole")
        words = [program.PROGRAM, "optimise", "ring.toml", "--json", "-o", "killed"]
        running = subprocess.Popen(words, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        points = self.folder / "killed" / "points.jsonl"
        for _ in range(1000):
            if points.exists() and points.read_bytes().count(b"\n") > 20:
                break
            time.sleep(0.02)
        running.send_signal(signal.SIGKILL)
        running.wait()
        after = self.optimised("ring.toml", "-o", "killed")
        self.assertGreater(after["cases_stored"], 10)
        self.assertEqual(after["best"], whole["best"])

    def test_bounds_reversed_are_refused(self):
        (self.folder / "bad.toml").write_text(BAD.replace('"5 um"', '"50 um"'))
        self.assert_refused(self.run_program("optimise", "bad.toml"), "is not below upper", "bad.toml:10")

    def test_key_without_use_is_refused(self):
        (self.folder / "bad.toml").write_text(BAD.replace("pad.separation", "pad.grooves.depth"))
        self.assert_refused(self.run_program("optimise", "bad.toml"), "pad.grooves.depth", "not in use")


if __name__ == "__main__":
    unittest.main()
