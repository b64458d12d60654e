"""`ringfilm fit`: hidden parameters recovered, what cannot be distinguished, files, refusals."""

import json
import math
import pathlib
import shutil
import unittest

import program

SHIPPED = program.SOURCES / "cases" / "inverse"

FIT = """\
title = "viscosity and film"
case = "slider.toml"
[[measured]]
file = "load.csv"
quantity = "load"
relative_error = 0.01
[[parameter]]
key = "lubricant.viscosity"
lower = "5 mPa s"
upper = "50 mPa s"
"""


def slider_load(viscosity, speed, film):
    """Rayleigh (1918), of the shipped slider: 10 mm long, 10 um higher at its inlet [N/m]."""
    k = 10e-6 / film
    return 6 * viscosity * speed * 0.01**2 / film**2 * (math.log(1 + k) - 2 * k / (2 + k)) / k**2


class FitTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        for name in ("slider.toml", "slider_load.csv", "slider_friction.csv", "fit_slider.toml"):
            shutil.copy(SHIPPED / name, self.folder)
        rows = "".join(f"{speed},{slider_load(0.013, speed, 10e-6)}\n" for speed in (1, 2, 3))
        (self.folder / "load.csv").write_text("pad.speed [m/s],load [N/m]\n" + rows)
        (self.folder / "fit.toml").write_text(FIT)

    def fitted(self, file="fit.toml", *words):
        found = json.loads(self.run_well("fit", file, "--json", *words))
        return found, {one["key"]: one for one in found["parameters"]}

    def edited(self, old, new, name="edited.toml"):
        self.assertIn(old, FIT)
        (self.folder / name).write_text(FIT.replace(old, new))
        return name


class Recovers(FitTest):
    def test_exact_measurement_gives_the_hidden_viscosity(self):
        found, parameters = self.fitted()
        viscosity = parameters["lubricant.viscosity"]
        # 200 cells have the load to 5e-5 of the closed form.
        self.assertAlmostEqual(viscosity["value"], 0.013, delta=2e-6)
        self.assertTrue(viscosity["identified"])
        # Three values of 1 %, to which the load is proportional: 1.96 x 1 %/sqrt(3), relative; profile within 2 %.
        half = 1.96 * 0.01 / math.sqrt(3) * 0.013
        self.assertAlmostEqual(viscosity["high"] - viscosity["value"], half, delta=0.03 * half)
        self.assertLess(found["residual_rms"], 0.02)

    def test_shipped_fit_covers_what_its_measurement_was_made_with(self):
        found, parameters = self.fitted("fit_slider.toml")
        for key, truth in (("lubricant.viscosity", 0.013), ("pad.separation", 12e-6)):
            self.assertTrue(parameters[key]["identified"], key)
            # The seed of the measurement is one of the 99 % that lie within 1.3 intervals.
            reach = 1.3 * (parameters[key]["high"] - parameters[key]["low"]) / 2
            self.assertAlmostEqual(parameters[key]["value"], truth, delta=reach)
        self.assertLess(found["residual_rms"], 1.6)

    def test_factors_of_a_product_are_reported_as_not_identified(self):
        more = '[[parameter]]\nkey = "pad.speed"\nlower = "1 m/s"\nupper = "10 m/s"\n'
        measured = FIT.replace('file = "load.csv"', 'value = "6000 N/m"') + more
        (self.folder / "product.toml").write_text(measured)
        found, parameters = self.fitted("product.toml")
        self.assertFalse(parameters["lubricant.viscosity"]["identified"])
        self.assertFalse(parameters["pad.speed"]["identified"])
        self.assertEqual(found["not_identified"], ["only the product lubricant.viscosity x pad.speed is determined"])

    def test_curve_of_a_ring_with_shift_and_gap(self):
        name = "fit_friction.toml"
        text = (SHIPPED / name).read_text().replace('"../styles2014', f'"{SHIPPED.parent}/styles2014')
        (self.folder / name).write_text(text.replace("[[measured]]", "[fit]\nstarts = 1\n[[measured]]"))
        shutil.copy(SHIPPED / "friction_trace.csv", self.folder)
        found, parameters = self.fitted(name)
        zeta = parameters["contact.boundary_shear_strength_coefficient"]
        self.assertAlmostEqual(zeta["value"], 0.25, delta=0.01)
        self.assertTrue(zeta["identified"])
        self.assertAlmostEqual(found["measured"][0]["angle_shift"]["value"], -0.3, delta=0.2)


class Files(FitTest):
    def test_fitted_case_and_study_are_valid(self):
        self.run_well("fit", "fit_slider.toml", "-o", "out")
        self.run_well("check", "out/fitted.toml")
        load = json.loads(self.run_well("run", "out/fitted.toml", "--json"))["load"]
        stored = json.loads((self.folder / "out" / "fit.json").read_text())
        self.assertAlmostEqual(load, stored["predictions"]["load"]["value"], delta=1e-9 * load)
        self.assertIn('key = "pad.separation"', (self.folder / "out" / "fitted_study.toml").read_text())
        self.assertIn("computed", (self.folder / "out" / "residuals.csv").read_text().splitlines()[0])

    def test_cases_that_are_stored_are_not_computed_again(self):
        first, _ = self.fitted("fit.toml", "-o", "out")
        # A kill may cut off the last line.
        points = self.folder / "out" / "points.jsonl"
        points.write_bytes(points.read_bytes()[:-20])
        second, _ = self.fitted("fit.toml", "-o", "out", "--resume")
        self.assertEqual(second["cases_computed"], 1)
        self.assertEqual(second["parameters"], first["parameters"])

    def test_threads_do_not_change_the_fit(self):
        one, _ = self.fitted("fit_slider.toml", "-o", "one", "--threads", "1")
        two, _ = self.fitted("fit_slider.toml", "-o", "two", "--threads", "2")
        self.assertEqual(one["parameters"], two["parameters"])


class Refusals(FitTest):
    def refused(self, file, *fragments):
        self.assert_refused(self.run_program("fit", file), *fragments)

    def test_bounds_reversed(self):
        self.refused(self.edited('"5 mPa s"', '"80 mPa s"'), "lower", "is not below upper", "edited.toml:9")

    def test_measurement_without_an_error(self):
        self.refused(self.edited("relative_error = 0.01\n", ""), "has no error", "standard_deviation")

    def test_quantity_that_does_not_exist(self):
        self.refused(self.edited('"load"', '"laod"'), "laod", "did you mean load")

    def test_key_that_does_not_exist(self):
        self.refused(self.edited("lubricant.viscosity", "lubricant.viscosty"), "did you mean lubricant.viscosity")

    def test_curve_without_overlap(self):
        (self.folder / "curve.csv").write_text("crank_angle [degree],total_friction [N]\n100,3\n110,4\n")
        (self.folder / "ring.toml").write_text(
            'case = "case.toml"\n[[measured]]\nfile = "curve.csv"\nquantity = "total_friction"\n'
            'standard_deviation = "2 N"\ncrank_range = ["-30 degree", "60 degree"]\n'
            '[[parameter]]\nkey = "contact.boundary_shear_strength_coefficient"\nlower = 0.05\nupper = 0.3\n'
        )
        self.refused("ring.toml", "not one of 2 measured crank angles lies within crank_range", "must overlap")

    def test_values_that_no_column_tells_apart(self):
        (self.folder / "load.csv").write_text("load [N/m]\n1\n2\n")
        self.refused("fit.toml", "no column is a key of the case")

    def test_study_is_not_a_fit(self):
        self.refused(pathlib.Path("slider.toml").name, "this file is a case, not a fit")


if __name__ == "__main__":
    unittest.main()
