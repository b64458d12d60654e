"""The lift of a land on a honed liner: `ringfilm land`, and a case that takes its table."""

import json
import unittest

import program


class LandTest(program.ProgramTest):
    STATED = ("--width", "0.06 mm", "--speed", "8 m/s", "--viscosity", "6 mPa s")

    def setUp(self):
        super().setUp()
        self.run_well("synthetic", "honed", "hone.x3p", "--points", "64x64", "--step", "1 um", "--seed", "2",
                      "--groove-spacing", "30 um")  # fmt: skip

    def land(self, *words):
        return json.loads(self.run_well("land", "--surface", "hone.x3p", *self.STATED, *words, "--json"))

    def test_lists_in_the_order_asked_for(self):
        of = self.land("--separations", "2 um, 1.4 um", "--mirrored")
        self.assertEqual(of["separation"], [2e-6, 1.4e-6])
        self.assertGreater(of["lift"][1], of["lift"][0])
        self.assertGreater(of["friction_stress"][1], of["friction_stress"][0])
        for name in ("mean_gap", "lift_scatter", "lowest_gap"):
            self.assertEqual(len(of[name]), 2)
        self.assertEqual(of["lift_scatter"], [0, 0])  # one patch

    def test_a_case_takes_the_table(self):
        self.land("--separations", "1.2 um, 1.4 um, 1.7 um, 2 um", "--cavitation-pressure", "1 bar", "-o", "land.nc")
        with_lift = ("--set", "film.land_lift=table", "--set", "film.land_law=land.nc")
        plain = json.loads(self.run_well("run", "case.toml", "--json"))
        lifted = json.loads(self.run_well("run", "case.toml", "--json", *with_lift))
        self.assertGreater(lifted["min_film_thickness"], plain["min_film_thickness"])

    def test_what_is_refused(self):
        hone = ("land", "--surface", "hone.x3p")
        self.assert_refused(self.run_program(*hone, *self.STATED, "--separations", "0.1 um"), "touch", "20 nm")
        wide = ("--width", "3 mm", "--speed", "8 m/s", "--viscosity", "6 mPa s")
        self.assert_refused(self.run_program(*hone, *wide, "--separations", "2 um"), "wide", "larger map")
        self.assert_refused(self.run_program(*hone, *self.STATED), "--separations is missing")
        unit = ("--width", "3", "--speed", "8 m/s", "--viscosity", "6 mPa s", "--separations", "2 um")
        self.assert_refused(self.run_program(*hone, *unit), "--width")
        (self.folder / "law.nc").write_text("x")
        words = ("run", "case.toml", "--set", "film.land_lift=table", "--set", "film.land_law=law.nc")
        self.assertEqual(self.run_program(*words).returncode, 2)


if __name__ == "__main__":
    unittest.main()
