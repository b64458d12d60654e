"""What a study states of its factors: listed texts that nothing can be run with, numbers to which friction is flat."""

import csv
import unittest

import program

GAS = (
    program.CASE + '[film]\nchamber_edge = "gas"\ncrankcase_edge = "gas"\nsupply = "given"\n[supply]\nfilm = "0.9 um"\n'
)
BASE = '[[base]]\ncase = "gas.toml"\n'
GRID = '[plan]\nmethod = "grid"\n'


def factor(key, values):
    return f"[[factor]]\nname = \"{key.split('.')[-1]}\"\nkey = \"{key}\"\nvalues = {values}\n"


CAVITATION = factor("film.cavitation", '["reynolds-exit", "mass-conserving"]')


class FactorsTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "gas.toml").write_text(GAS)

    def study(self, *parts):
        (self.folder / "study.toml").write_text("".join((BASE, *parts, GRID)))
        return self.run_program("study", "study.toml", "-o", "out")

    def test_a_text_that_no_scenario_can_have_is_refused_before_anything_is_run(self):
        speed = factor("operating.speed", '["1000 rpm", "1200 rpm", "1500 rpm"]')
        done = self.study(CAVITATION, speed)
        self.assert_refused(
            done,
            'study.toml:6:11: factor "cavitation" = "reynolds-exit": no scenario with it can be run, of 3 tried; the '
            'first is refused because film.chamber_edge = "gas" requires film.cavitation = "mass-conserving"',
        )
        self.assertIn("\n1 error; nothing", done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_text_that_some_scenarios_can_have_is_run_with_these(self):
        edges = factor("film.chamber_edge", '["gas", "oil"]').replace(
            'key = "film.chamber_edge"', 'keys = ["film.chamber_edge", "film.crankcase_edge"]'
        )
        (self.folder / "gas.toml").write_text(program.CASE)
        done = self.study(CAVITATION, edges)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "out" / "study.csv", newline="") as file:
            solved = [row["reason"] == "" for row in csv.DictReader(file)]
        self.assertEqual(solved, [False, True, True, True])

    def test_a_number_to_which_friction_is_flat_is_noted_as_one_that_cannot_be_fitted(self):
        done = self.study(factor("supply.film", '["0.2 um", "0.4 um", "5 um", "10 um", "20 um"]'))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(
            'note: the friction mean effective pressure changes by less than 2 % with "film" from 5 um to 20 um, '
            "the other factors unchanged: such a factor cannot be fitted to a measured one",
            done.stdout,
        )
        self.assertIn(b"cannot be fitted to a measured one", (self.folder / "out" / "study.nc").read_bytes())

    def test_a_number_that_counts_is_not(self):
        done = self.study(factor("contact.boundary_shear_strength_coefficient", "[0.08, 0.12, 0.2]"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("the friction mean effective pressure changes", done.stdout)
        self.assertIn("the minimum film thickness changes by less than", done.stdout)

    def test_numbers_that_change_no_measured_value_at_all_are_noted_as_well(self):
        done = self.study(factor("lubricant.specific_heat", '["1900 J/(kg K)", "2300 J/(kg K)"]'))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, '"specific_heat" changes no value|pressure changes by less than 2 % with "spec')


if __name__ == "__main__":
    unittest.main(verbosity=2)
