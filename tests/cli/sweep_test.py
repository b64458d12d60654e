"""ringfilm sweep and run --gradients: a case over values of its keys, maps for other programs, derivatives."""

import csv
import json
import math
import re
import unittest

import program


class Sweep(program.ProgramTest):
    def test_sweep_computes_a_range_and_all_combinations(self):
        printed = self.run_well("sweep", "case.toml", "operating.speed=1000..3000", "--points", "3")
        self.assertEqual(re.findall(r"(?m)^(\d+ rpm) ", printed), ["1000 rpm", "2000 rpm", "3000 rpm"])
        self.assertIn("lowest FMEP: ", printed)
        words = ("lubricant.grade=SAE 0W-20, SAE 30", "operating.speed=1500 rpm", "--json")
        self.run_well("new", "mine.toml")
        scenarios = json.loads(self.run_well("sweep", "mine.toml", *words))["scenarios"]
        grades = [one["settings"]["lubricant.grade"] for one in scenarios]
        self.assertEqual(grades, ["SAE 0W-20", "SAE 30"])
        alone = json.loads(
            self.run_well("run", "mine.toml", "--json", "--set", "lubricant.grade=SAE 30", "operating.speed=1500 rpm")
        )
        self.assertEqual(scenarios[1]["values"]["fmep"], alone["fmep"])
        self.run_well("sweep", "case.toml", "operating.speed=1000,2000", "--csv", "sweep.csv")
        with open(self.folder / "sweep.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([row["operating.speed"] for row in rows], ["1000 rpm", "2000 rpm"])
        self.assertGreater(float(rows[1]["mean_power_loss [W]"]), float(rows[0]["mean_power_loss [W]"]))

    def test_sweep_takes_profiles_and_replaces_no_file_that_it_reads(self):
        self.run_well("new", "mine.toml")
        walls = 'thermal.liner=[["0 mm","127 degC"],["80 mm","110 degC"]], 120 degC'
        scenarios = json.loads(self.run_well("sweep", "mine.toml", walls, "--set", "solver.cells=60", "--json"))
        self.assertEqual(len(scenarios["scenarios"]), 2)
        (self.folder / "other.csv").write_text((self.folder / "trace.csv").read_text())
        before = (self.folder / "other.csv").read_text()
        self.assert_refused(
            self.run_program("sweep", "case.toml", "gas.cylinder_pressure=trace.csv,other.csv", "--csv", "other.csv")
        )
        self.assertEqual((self.folder / "other.csv").read_text(), before)

    def test_gradients_are_printed_with_their_errors(self):
        words = ("run", "case.toml", "--set", "solver.step_error=1e-4", "solver.cells=40", "--gradients")
        printed = self.run_well(*words)
        self.assertRegex(printed, r"(?m)^operating\.speed +-?[\d.e-]+ \+- [\d.e-]+ ")
        self.assertNotIn("not computed", printed)
        found = json.loads(self.run_well(*words, "--json"))
        self.assertGreater(found["gradients"]["fmep"]["ring.elastic_pressure"], 0)
        self.assertIn("ring.elastic_pressure", found["gradient_errors"]["fmep"])

    def test_sweep_makes_a_table_of_modelica_and_fits_chen_and_flynn(self):
        self.run_well("new", "mine.toml")
        words = ("gas.peak_pressure=30,60", "operating.speed=1000,2000,3000", "--set", "solver.cells=60", "--json")
        found = json.loads(self.run_well("sweep", "mine.toml", *words, "--chen-flynn", "--modelica", "fmep.txt"))
        values = [one["values"] for one in found["scenarios"]]
        speeds = [2 * 0.0795 * rpm / 60 for _ in range(2) for rpm in (1000, 2000, 3000)]
        fit = [
            found["chen_flynn"][name]["value"]
            for name in ("constant", "peak_pressure", "piston_speed", "piston_speed_squared")
        ]
        rest = [
            one["fmep"] - (fit[0] + fit[1] * one["peak_gas_pressure"] + fit[2] * v + fit[3] * v * v)
            for one, v in zip(values, speeds, strict=True)
        ]
        for weights in ([1] * 6, [one["peak_gas_pressure"] / 1e6 for one in values], speeds, [v * v for v in speeds]):
            self.assertAlmostEqual(sum(w * r for w, r in zip(weights, rest, strict=True)), 0, delta=1e-3)  # normal
        self.assertAlmostEqual(found["chen_flynn"]["residual_rms"], (sum(r * r for r in rest) / 6) ** 0.5, delta=1e-6)
        lines = (self.folder / "fmep.txt").read_text().splitlines()
        self.assertEqual(lines[0], "#1")
        self.assertTrue(lines[1].startswith("double fmep(3,4)"), lines[1])
        table = [[float(cell) for cell in line.split()] for line in lines[2:]]
        self.assertEqual([row[0] for row in table], [0, 30e5, 60e5])
        self.assertAlmostEqual(table[0][1], 1000 * 2 * math.pi / 60, delta=1e-5)
        self.assertAlmostEqual(table[2][3], values[5]["fmep"], delta=1e-4)
        for words, message in (
            (["operating.speed=1000..2000", "--chen-flynn"], "do not determine its four coefficients"),
            (["lubricant.grade=SAE 30", "--modelica", "x.txt"], "lubricant.grade is not a number"),
            (["operating.speed=2000,1000", "--modelica", "x.txt"], "do not rise"),
        ):
            self.assert_refused(self.run_program("sweep", "mine.toml", "--points", "2", *words), message)
        self.assertNotIn("x.txt", self.names())

    def test_sweep_refuses_what_is_not_a_key_with_values(self):
        for words, message in (
            (["operating.speed="], "is not a key with its values"),
            (["operating.speed=1000..x"], "is not a key with its values"),
            (["operating.speed=1000 rpm..2000 Hz"], "has two units"),
            (["operating.sped=1000"], "did you mean operating.speed?"),
            (["operating.speed=0..1000"], "operating.speed"),
            (["operating.speed=1", "operating.speed=2"], "given twice"),
            (["operating.speed=1000...2000"], "is not a key with its values"),
            (["operating.speed=1,000"], "a comma separates values"),
            (["operating.speed=1000", "--set", "operating.speed=2000 rpm"], "stated by --set and varied"),
            (["gas.cylinder_pressure=../x.csv"], "there is no such file"),
            (["operating.speed=1..2", "engine.bore=80..90", "--points", "1000"], "10000 at the most"),
        ):
            self.assert_refused(self.run_program("sweep", "case.toml", *words), message)


if __name__ == "__main__":
    unittest.main()
