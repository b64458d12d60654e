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

    def test_close_to_contact_the_film_is_found_from_that_of_a_wider_gap(self):
        highest = self.land("--separations", "2 um")["highest_point"]
        nearest = f"{1e6 * highest + 0.021:.4f} um"
        of = self.land("--separations", f"{nearest}, 2 um", "--cavitation-pressure", "1 bar")
        self.assertGreater(of["lift"][0], of["lift"][1])
        self.assertLess(of["lowest_gap"][0], 0.03e-6)

    def test_a_table_as_csv_is_that_of_the_netcdf(self):
        stated = ("--separations", "1.2 um, 1.4 um, 1.7 um, 2 um", "--cavitation-pressure", "1 bar", "-o", "land.nc")
        of = self.land(*stated)
        row = "{},{},{},{},0.06,8,6,{},{}\n"
        heads = "separation [um],lift [kPa],friction_factor [-],lowest_gap [nm],land_width [mm],speed [m/s],"
        heads += "viscosity [mPa s],roughness [um],speed_exponent [1]\n"
        text = heads + "".join(
            row.format(1e6 * s, p / 1e3, f, 1e9 * h, 1e6 * of["roughness"], of["speed_exponent"])
            for s, p, f, h in zip(of["separation"], of["lift"], of["friction_factor"], of["lowest_gap"])
        )
        (self.folder / "land.csv").write_text(text)
        with_lift = ("run", "case.toml", "--json", "--set", "film.land_lift=table", "--set")
        one, other = (
            json.loads(self.run_well(*with_lift, f"film.land_law={name}")) for name in ("land.nc", "land.csv")
        )
        self.assertAlmostEqual(one["fmep"], other["fmep"], delta=1e-9 * one["fmep"])
        (self.folder / "land.csv").write_text(text.replace(",8,6,", ",7,6,", 1))
        self.assert_refused(self.run_program(*with_lift, "film.land_law=land.csv"), "speed is another one", "each")
        (self.folder / "land.csv").write_text(text.replace("viscosity [mPa s]", "eta [mPa s]"))
        self.assert_refused(self.run_program(*with_lift, "film.land_law=land.csv"), "no column viscosity")

    def test_a_pack_has_the_lift_at_the_rings_that_state_it(self):
        self.run_well("new", "pack.toml", "--pack", "passenger-car")
        checked = json.loads(self.run_well("check", "pack.toml", "--json"))
        stated = [entry["key"] for entry in checked["stated"]]
        self.assertIn("ring.3.film.land_law", stated)
        self.assertNotIn("ring.1.film.land_law", stated)
        other = self.run_program("run", "pack.toml", "--set", "ring.2.film.cavitation=reynolds-exit")
        self.assert_refused(other, "unknown key")  # the film is that of the engine, its lift that of a ring

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
