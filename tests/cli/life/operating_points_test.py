"""Studies of weighted operating points: `method = "operating-points"`."""

import csv
import json
import unittest

import program

STUDY = """\
title = "a duty"
kind = "compare"
[[base]]
name = "new"
case = "case.toml"
[plan]
method = "operating-points"
[[point]]
name = "idle"
weight = 1
values = { "operating.speed" = "900 rpm", "operating.oil_temperature" = "90 degC" }
[[point]]
name = "full load"
weight = 3
values = { "operating.speed" = "3000 rpm", "operating.oil_temperature" = "120 degC" }
"""


class OperatingPoints(program.ProgramTest):
    def study(self, text=STUDY, folder="out"):
        (self.folder / "study.toml").write_text(text)
        return self.run_program("study", "study.toml", "-o", folder)

    def test_each_point_is_the_case_with_its_values(self):
        done = self.study()
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "out" / "study.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        settings = ("--set", "operating.speed=900 rpm", "--set", "operating.oil_temperature=90 degC")
        alone = json.loads(self.run_well("run", "case.toml", "--json", *settings))
        power = next(name for name in rows[0] if name.startswith("mean_power_loss"))
        self.assertAlmostEqual(float(rows[0][power]) / alone["mean_power_loss"], 1, delta=1e-6)

    def test_the_summary_has_points_and_their_weighted_mean(self):
        printed = self.study().stdout
        lines = {line.split("  ")[1]: line for line in printed.splitlines() if line.startswith("  ")}
        for name in ("idle", "full load", "weighted mean"):
            self.assertIn(name, lines)
        self.assertIn(b"mean_power_loss_weighted_mean", (self.folder / "out" / "study.nc").read_bytes())

    def test_the_mean_does_not_depend_on_the_unit_of_the_weights(self):
        def mean(text, folder):
            printed = self.study(text, folder).stdout
            return next(line.split() for line in printed.splitlines() if line.startswith("  weighted mean"))

        expected = mean(STUDY, "one")
        for one, three in (("5e307", "1.5e308"), ("1e-310", "3e-310")):
            text = STUDY.replace("weight = 1", f"weight = {one}").replace("weight = 3", f"weight = {three}")
            self.assertEqual(mean(text, one), expected)

    def test_texts_of_keys_are_choices(self):
        text = STUDY.replace('"operating.oil_temperature" = "90 degC"', '"film.cavitation" = "reynolds-exit"')
        text = text.replace('"operating.oil_temperature" = "120 degC"', '"film.cavitation" = "mass-conserving"')
        self.assertEqual(self.study(text).returncode, 0)

    def test_one_pressure_at_several_speeds_is_noted(self):
        kept = (
            'base "new": operating.speed goes from 900 to 3000 rpm, and the cylinder pressure stays the same, with a '
            "peak of 41.1556 bar"
        )
        self.assertIn(kept, self.study().stdout)
        self.assertIn(b"and the cylinder pressure stays the same", (self.folder / "out" / "study.nc").read_bytes())

    def test_a_pressure_of_its_own_at_each_point_is_not(self):
        (self.folder / "low.csv").write_text(program.TRACE.replace(".2", ".1"))
        text = STUDY
        for temperature, trace in (("90 degC", "low.csv"), ("120 degC", "trace.csv")):
            text = text.replace(
                f'"operating.oil_temperature" = "{temperature}"', f'"gas.cylinder_pressure" = "{trace}"'
            )
        done = self.study(text)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("stays the same", done.stdout)

    def test_refusals(self):
        for old, new, fragment in (
            ("weight = 1", "weight = 0", "the weight of a point is above 0"),
            (', "operating.oil_temperature" = "120 degC"', "", "the point has no operating.oil_temperature"),
            ('name = "full load"', 'name = "idle"', "two points have the name idle"),
            ('"900 rpm"', '"900"', "has no unit"),
            ('"operating-points"', '"sobol"', "[[point]] means nothing with this method"),
        ):
            with self.subTest(fragment):
                self.assert_refused(self.study(STUDY.replace(old, new)), fragment)


class Duty(program.ProgramTest):
    def notes(self, full_load):
        (self.folder / "life.toml").write_text(
            'case = "case.toml"\nhours = ["0 h"]\n[[state]]\nhours = "0 h"\ncase = "case.toml"\n'
            '[[state]]\nhours = "10 h"\ncase = "case.toml"\n'
            '[[duty.point]]\nname = "idle"\nweight = 1\nspeed = "900 rpm"\n'
            f'[[duty.point]]\nname = "full load"\nweight = 1\nspeed = "3000 rpm"\n{full_load}'
        )
        return [note["topic"] for note in json.loads(self.run_well("life", "life.toml", "--json"))["notes"]]

    def test_one_pressure_at_several_speeds_is_noted(self):
        self.assertIn("pressure-kept", self.notes(""))
        self.assertNotIn("pressure-kept", self.notes('peak_pressure = "80 bar"\n'))


if __name__ == "__main__":
    unittest.main(verbosity=2)
