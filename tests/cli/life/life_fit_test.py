"""Wear coefficients fitted to measured faces: `coefficient = "fit"` in a life."""

import math
import unittest

import life_test
import program

FIT = (
    life_test.ARCHARD.replace('"4e-18 m2/N"', '"fit"')
    + '[[state]]\nhours = "0 h"\ncase = "case.toml"\n[[state]]\nhours = "4 h"\ncase = "worn.toml"\n'
)


class Fit(life_test.LifeTest):
    """Coefficients that measured faces allow."""

    def fit(self):
        if not hasattr(Fit, "result"):
            (self.folder / "fit.toml").write_text(FIT)
            Fit.result = self.life("fit.toml")
        return Fit.result

    def skip_under_sanitizers(self):
        if program.IS_SANITIZED:
            program.skip_loudly(self, "computes hundreds of lives; the other fits run the same code")

    def test_it_is_a_range_and_no_single_number(self):
        fit = self.fit()["wear"]["fit"]
        low, high = fit["coefficient"]
        self.assertLess(low, high)
        self.assertEqual(
            {(row["hours"], row["basis"]) for row in fit["rows"]}, {(4, "least-wear"), (4, "closest-face")}
        )
        known = [row["coefficient"] for row in fit["rows"] if row["coefficient"]]
        self.assertEqual((min(known), max(known)), (low, high))
        self.assertIn("coefficient-fitted", [note["topic"] for note in self.fit()["notes"]])

    def test_a_scenario_with_a_fitted_coefficient_loses_the_area_of_its_row(self):
        row = next(row for row in self.fit()["wear"]["fit"]["rows"] if row["basis"] == "least-wear")
        text = life_test.ARCHARD.replace("4e-18", repr(row["coefficient"]))
        (self.folder / "archard.toml").write_text(text)
        worn = self.life("archard.toml")["states"][-1]["worn_area"]
        self.assertAlmostEqual(worn / row["worn_area"], 1, delta=0.01)

    def test_the_band_is_that_of_both_ends(self):
        last = self.fit()["states"][-1]
        low, high = last["band"]["worn_area"]
        self.assertLess(low, last["worn_area"])
        self.assertGreater(high, last["worn_area"])
        ends = [last["interpolations"][f"{end} fitted coefficient"]["mean_power_loss"] for end in ("lowest", "highest")]
        self.assertEqual(
            [min(*ends, last["mean_power_loss"]), max(*ends, last["mean_power_loss"])], last["band"]["mean_power_loss"]
        )

    def test_the_coefficient_that_was_used_is_the_geometric_mean(self):
        wear = self.fit()["wear"]
        low, high = wear["fit"]["coefficient"]
        self.assertAlmostEqual(wear["coefficient"] / math.sqrt(low * high), 1, delta=1e-12)
        (note,) = (note for note in self.fit()["notes"] if note["topic"] == "wear-scenario")
        self.assertIn("is fitted to the measured faces", note["message"])
        for name in ("coefficient", "rms", "half_width", "untrusted_margin", "tilt", "largest_worn_area"):
            self.assertIn(name, self.fit()["units"])

    def test_a_state_that_need_not_have_lost_anything_has_no_coefficient(self):
        between = '[[state]]\nhours = "2 h"\ncase = "case.toml"\n'
        (self.folder / "fit.toml").write_text(
            FIT.replace('[[state]]\nhours = "4 h"', between + '[[state]]\nhours = "4 h"')
        )
        rows = self.life("fit.toml")["wear"]["fit"]["rows"]
        self.assertEqual([row["coefficient"] for row in rows if row["hours"] == 2], [None] * 6)
        self.assertTrue(all(row["coefficient"] for row in rows if row["hours"] == 4))

    def test_a_flat_face_gives_no_coefficient_by_its_distance(self):
        """From 15 um to 0.02 um of crown: once the scenario is flat its distance from that face no longer changes."""
        (self.folder / "flat.toml").write_text(program.CASE.replace("15 um", "0.02 um"))
        (self.folder / "fit.toml").write_text(FIT.replace("worn.toml", "flat.toml"))
        rows = self.life("fit.toml")["wear"]["fit"]["rows"]
        closest = [row for row in rows if row["basis"] == "closest-face"]
        self.assertEqual([row["face_is_flat"] for row in closest], [True, True])
        self.assertEqual([row["coefficient"] for row in closest], [None, None])
        self.assertTrue(all(row["coefficient"] for row in rows if row["basis"] == "least-wear"))
        self.assertIn("face is flat", self.run_well("life", "fit.toml"))

    def test_a_face_that_a_scenario_made_gives_its_coefficient(self):
        """Its middle is flat, so that the distance within 0.3 mm of it states nothing; that within 0.5 mm does."""
        self.skip_under_sanitizers()
        flat = program.CASE.replace("15 um", "4 um")
        (self.folder / "flat.toml").write_text(flat)
        coefficient = 1.5e-16
        archard = life_test.ARCHARD.replace("case.toml", "flat.toml").replace("4e-18", repr(coefficient))
        (self.folder / "archard.toml").write_text(archard)
        made = self.life("archard.toml")
        last = made["states"][-1]
        points = "".join(f"{x * 1e3!r},{h * 1e6!r}\n" for x, h in zip(made["x"], last["face_height"], strict=True))
        (self.folder / "face.csv").write_text("x [mm],height [um]\n" + points)
        parabola = 'form = "parabola"\ncrown_height = "4 um"\n'
        (self.folder / "made.toml").write_text(flat.replace(parabola, 'form = "points"\nfile = "face.csv"\n'))
        (self.folder / "fit.toml").write_text(FIT.replace("case.toml", "flat.toml").replace("worn.toml", "made.toml"))
        rows = self.life("fit.toml")["wear"]["fit"]["rows"]
        wide, narrow = (row for row in rows if row["basis"] == "closest-face")
        self.assertAlmostEqual(wide["coefficient"] / coefficient, 1, delta=0.02)
        self.assertLess(wide["rms"], 0.01e-6)
        self.assertEqual((wide["face_is_flat"], narrow["face_is_flat"]), (False, True))
        self.assertIsNone(narrow["coefficient"])

    def test_the_shipped_fit_gives_the_table_of_the_theory(self):
        """With half of the cells and crank steps; the nodes within a half width are others then."""
        self.skip_under_sanitizers()
        shipped = (life_test.SHIPPED.parent / "fitted.toml").read_text(encoding="utf-8")
        shipped = shipped.replace("../styles2014", str(life_test.SHIPPED.parents[1] / "styles2014"))
        coarse = 'set = { "solver.cells" = 60, "solver.crank_step" = "4 degree" }\nspeed'
        (self.folder / "fit.toml").write_text(shipped.replace("\nspeed", "\n" + coarse))
        rows = self.life("fit.toml")["wear"]["fit"]["rows"]
        theory = (program.SOURCES / "docs" / "theory" / "life.md").read_text(encoding="utf-8")
        table = [
            [float(cell) for cell in line.split("|")[2:6]]
            for line in theory.splitlines()
            if line.startswith(("| least wear", "| closest face"))
        ]
        for k, (first_area, first, last_area, last) in enumerate(table):
            for row, area, coefficient in ((rows[k], first_area, first), (rows[k + len(table)], last_area, last)):
                with self.subTest(basis=row["basis"], hours=row["hours"], trusted=k):
                    delta = 0.06 if row["basis"] == "least-wear" else 0.3
                    self.assertAlmostEqual(row["worn_area"] * 1e9 / area, 1, delta=delta)
                    self.assertAlmostEqual(row["coefficient"] / coefficient, 1, delta=delta)

    def test_the_coating_of_each_scenario_of_the_band_is_reported(self):
        text = FIT.replace('"4 h"]', '"4 h", "8 h"]').replace('"fit"', '"fit"\ncoating_thickness = "6 um"')
        (self.folder / "fit.toml").write_text(text + '[end_of_life]\nlargest_worn_depth = "5.9 um"\n')
        reported = self.life("fit.toml")
        self.assertIsNone(reported["wear"]["coating_worn_through_hours"])
        (note,) = (note["message"] for note in reported["notes"] if note["topic"] == "coating-worn-through")
        self.assertRegex(note, r"worn through after [4-8]\.?\d* h with the highest fitted coefficient; nothing later")
        (end,) = reported["end_of_life"]
        self.assertIsNone(end["hours"])
        self.assertGreater(end["interpolations"]["highest fitted coefficient"], 4)

    def test_refusals(self):
        self.refused(
            FIT.replace('"fit"', '"fit"\nrunning_in_time = "2 h"'), "running_in_time means nothing with coefficient"
        )
        self.refused(FIT.replace('"fit"', '"fit"\nsurface = "path"'), 'wear.surface = "path" cannot be combined')
        self.refused(
            FIT.replace('"case.toml"\nmode', '"worn.toml"\nmode'), "the face of the base case and that of the first"
        )
        self.refused(
            FIT.replace("[[state]]", 'running_in_coefficient = "1e-17 m2/N"\n[[state]]', 1),
            'wear.running_in_coefficient means nothing with coefficient = "fit"',
        )
        self.refused(FIT.replace("[[state]]", "jumps = 3\n[[state]]", 1), "wear.jumps means nothing")
        self.refused(FIT.replace("worn.toml", "case.toml"), "nothing need have been lost")
        self.refused(life_test.ARCHARD.replace('"4e-18 m2/N"', '"fit"'), "at least two measured states")

    def test_the_page_of_a_fit_holds_the_measured_faces_and_the_range(self):
        (self.folder / "fit.toml").write_text(FIT)
        self.run_well("life", "fit.toml", "--html", "fit.html")
        page = (self.folder / "fit.html").read_text(encoding="utf-8")
        for part in ('"measured_faces"', '"closest-face"', "Wear coefficients that the measured faces allow"):
            self.assertIn(part, page)


if __name__ == "__main__":
    unittest.main(verbosity=2)
