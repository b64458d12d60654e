"""A pad with a width: its gap over x and y, the pressures at its sides, what is reported of it, what is refused."""

import unittest

from pad_test import PAD, PadTest

SHEET = PAD.replace(
    'right_pressure = "0 bar"\n',
    'right_pressure = "0 bar"\nwidth = "20 mm"\nfront_pressure = "0 bar"\nback_pressure = "0 bar"\n',
).replace("cells = 100", "cells = 24\ncells_y = 24")
MAP = "x [mm],y [mm],h [um]\n0,0,20\n10,0,10\n0,20,20\n10,20,10\n"
HEAD = "x [mm],y [mm],h [um]\n"
PERIODIC = ("--set", "pad.front_pressure=", "--set", "pad.back_pressure=", "--set", "pad.sides=periodic")


class Film2dTest(PadTest):
    def setUp(self):
        super().setUp()
        (self.folder / "pad.toml").write_text(SHEET)
        (self.folder / "map.csv").write_text(MAP)


class Numbers(Film2dTest):
    def test_totals_side_flows_and_the_place_of_the_peak_are_reported(self):
        reported = self.json_of()
        self.assertAlmostEqual(reported["total_load"] / (0.02 * reported["load"]), 1, delta=1e-12)
        self.assertAlmostEqual(reported["total_friction_moving"] / (0.02 * reported["friction_moving"]), 1, delta=1e-12)
        self.assertLess(reported["flow_front"], 0, "out through the front is in -y")
        self.assertAlmostEqual(reported["flow_front"] / -reported["flow_back"], 1, delta=1e-6)  # of a symmetric film
        self.assertAlmostEqual(reported["mass_flow_back"] / (850 * reported["flow_back"]), 1, delta=1e-12)
        self.assertAlmostEqual(reported["peak_position_y"], 0.01, delta=1e-6)
        self.assertEqual(reported["units"]["flow_front"], "m3/s")
        # What comes in at the left goes out at the right and at the sides.
        inflow, outflow = (
            0.02 * reported["flow_left"],
            0.02 * reported["flow_right"] + reported["flow_back"] - reported["flow_front"],
        )
        self.assertAlmostEqual(inflow / outflow, 1, delta=1e-7)
        self.assertLess(reported["mass_residual"], 1e-7)

    def test_an_infinitely_wide_pad_has_no_side_flows(self):
        (self.folder / "pad.toml").write_text(PAD)
        self.assertNotIn("total_load", self.json_of())

    def test_flow_through_joined_sides_is_not_reported_and_through_closed_ones_is_zero(self):
        joined = self.json_of(*PERIODIC)
        self.assertEqual([name for name in joined if "front" in name or "back" in name], [])
        self.assertNotIn("flow_front", joined["units"])
        self.assertIn("total_load", joined)
        self.assertNotIn("through y = 0", self.run_well("run", "pad.toml", *PERIODIC))
        self.run_well("run", "pad.toml", *PERIODIC, "--output", "joined.nc")
        self.assertNotIn(b"flow_front", (self.folder / "joined.nc").read_bytes())
        closed = [word.replace("periodic", "closed") for word in PERIODIC]
        reported = self.run_well("run", "pad.toml", *closed)
        self.assertIn("through y = 0", reported)
        self.assertNotIn("-0 ", reported)
        self.assertEqual(self.json_of(*closed)["flow_front"], 0)

    def test_a_map_and_the_same_gap_along_x_give_the_same(self):
        along = self.json_of()
        over = self.json_of("--set", "pad.gap=map.csv")
        self.assertAlmostEqual(over["load"] / along["load"], 1, delta=1e-9)

    def test_side_flows_are_reported_in_milligrams_and_no_number_fills_the_line(self):
        printed = self.run_well("run", "pad.toml")
        self.assertRegex(printed, r"-[\d.]+ mg/s +mass flow through y = 0")
        thin = self.run_well("run", "pad.toml", "--set", "pad.gap=map.csv", "--set", "pad.separation=-9.99999999 um")
        self.assertIn("length of molecules of oil", thin)
        self.assertNotRegex(thin, r"\d{11}")

    def test_a_load_finds_its_separation(self):
        reported = self.json_of("--set", "pad.separation=", "--set", "pad.load=20 kN/m")
        self.assertAlmostEqual(reported["total_load"] / 400, 1, delta=1e-6)

    def test_csv_is_the_film_at_mid_width(self):
        self.run_well("run", "pad.toml", "--csv", "film.csv")
        rows = self.rows("film.csv")
        self.assertEqual(rows[0], ["time [s]", "x [m]", "film_thickness [m]", "pressure [Pa]", "film_content"])
        self.assertEqual(len(rows), 1 + 25)
        self.assertGreater(float(rows[13][3]), 1e5)

    def test_netcdf_holds_the_fields(self):
        reported = self.run_well("run", "pad.toml", "--output", "film.nc")
        self.assertIn("wrote film.nc", reported)
        self.assertIn("pad of 10 x 20 mm", reported)
        film = (self.folder / "film.nc").read_bytes()
        self.assertEqual(film[:4], b"\x89HDF")
        for name in (b"film_thickness", b"pressure", b"film_content", b"total_load", b"ringfilm_pad_schema"):
            self.assertIn(name, film)
        self.assert_refused(self.run_program("report", "film.nc", "--output", "film.html"), "the film of a pad")

    def test_a_history_has_its_numbers_over_time(self):
        reported = self.json_of(
            "--set", "pad.separation=", "--set", "pad.separation_history=h.csv", "--set", "pad.time_step=0.5 ms"
        )
        self.assertEqual(len(reported["history"]["total_load"]), 5)
        self.assertGreater(reported["history"]["total_load"][2], reported["history"]["total_load"][0])


class Refusals(Film2dTest):
    def refuse(self, *fragments, words=()):
        before = self.names()
        self.assert_refused(self.run_program("run", "pad.toml", "--csv", "out.csv", *words), *fragments)
        self.assertEqual(self.names(), before, "something was written")

    def refuse_map(self, text, *fragments, words=()):
        """A map that is right by itself or not; its own faults start with its name."""
        (self.folder / "map.csv").write_text(text)
        self.refuse(*fragments, words=("--set", "pad.gap=map.csv", *words))

    def refuse_netcdf(self, content, *fragments):
        (self.folder / "map.nc").write_bytes(content)
        self.refuse("pad.gap: map.nc", *fragments, words=("--set", "pad.gap=map.nc"))

    def test_sides_without_their_pressures(self):
        self.refuse("pad.front_pressure is missing", words=("--set", "pad.front_pressure="))
        self.refuse("pad.back_pressure is missing", words=("--set", "pad.back_pressure="))

    def test_pressures_at_sides_that_have_none(self):
        for sides in ("periodic", "closed"):
            (self.folder / "pad.toml").write_text(
                SHEET.replace('width = "20 mm"\n', f'width = "20 mm"\nsides = "{sides}"\n')
            )
            self.refuse("pad.front_pressure is not used", "pad.back_pressure is not used", 'pad.sides = "open"')

    def test_keys_of_a_ring_name_themselves_and_not_the_section_that_pads_need(self):
        self.refuse("take film.dimension out", words=("--set", "film.dimension=unrolled"))

    def test_a_faulty_width_is_all_that_is_reported(self):
        self.refuse("pad.width", "1 error", words=("--set", "pad.width=0 mm"))

    def test_keys_of_a_width_without_one(self):
        (self.folder / "pad.toml").write_text(SHEET.replace('width = "20 mm"\n', ""))
        for key in ("pad.front_pressure", "pad.back_pressure", "solver.cells_y"):
            self.refuse(f"{key} is not used", "pad.width is given")

    def test_a_setting_that_takes_the_width_out_drops_its_keys(self):
        done = self.run_program("run", "pad.toml", "--json", "--set", "pad.width=")
        self.assertEqual(done.returncode, 0, done.stderr)
        for key in ("pad.front_pressure", "pad.back_pressure", "solver.cells_y"):
            self.assertIn(key, done.stderr)

    def test_edges_below_the_cavitation_pressure(self):
        for side in ("left", "right", "front", "back"):
            self.refuse(
                f"pad.{side}_pressure = -1 bar is below film.cavitation_pressure = 0 bar",
                "lower film.cavitation_pressure",
                words=("--set", f"pad.{side}_pressure=-1 bar"),
            )

    def test_a_map_and_no_width(self):
        words = (
            "--set",
            "pad.width=",
            "--set",
            "pad.front_pressure=",
            "--set",
            "pad.back_pressure=",
            "--set",
            "solver.cells_y=",
            "--set",
            "pad.gap=map.csv",
        )
        self.refuse("a map over x and y", "state pad.width", words=words)

    def test_a_map_of_another_size(self):
        self.refuse_map(MAP.replace("10,", "9,"), "from x = 0 to 9 mm", "the pad from 0 to 10 mm", "pad.length")
        self.refuse_map(MAP.replace(",20,", ",18,"), "from y = 0 to 18 mm", "the pad from 0 to 20 mm", "pad.width")

    def test_a_map_that_is_not_a_full_rectangle(self):
        self.refuse_map(
            HEAD + "0,0,20\n10,0,10\n0,20,20\n", "map.csv:4:3", "the last y has 1 points, the first 2", "full rectangle"
        )
        self.refuse_map(
            HEAD + "0,0,20\n5,0,15\n10,0,10\n0,20,20\n6,20,15\n10,20,10\n",
            "map.csv:6:1",
            "x = 6 mm is given here, where the first y has x = 5 mm",
        )
        self.refuse_map(
            HEAD + "0,0,20\n5,0,15\n10,0,10\n0,20,20\n5,20,15\n10,21,10\n", "map.csv:7:4", "y changes after 2 points"
        )
        self.refuse_map(HEAD + "0,0,20\n10,0,10\n", "only one y")

    def test_a_map_whose_places_do_not_rise(self):
        self.refuse_map(HEAD + "0,0,1\n10,0,1\n0,20,1\n10,20,1\n0,10,1\n10,10,1\n", "map.csv:6:3", "y falls")
        step = "0,{0},1\n5,{0},1\n5,{0},1\n5,{0},1\n10,{0},1\n"
        self.refuse_map(HEAD + step.format(0) + step.format(20), "map.csv:5:1", "this x comes three times")
        rows = "0,0,1\n10,0,1\n0,20,1\n10,20,1\n0,20,2\n10,20,2\n"
        self.refuse_map(HEAD + rows, "map.csv:6:3", "a step at an end")

    def test_a_map_with_holes(self):
        self.refuse_map(MAP.replace("0,20,20", "0,20,nan"), "map.csv:4", "not a finite number")
        self.refuse_map(MAP.replace("0,20,20", "0,20,"), "map.csv:4", "a value is missing")

    def test_heights_beyond_reason(self):
        self.refuse_map(
            MAP.replace("0,20,20", "0,20,9.969e36"), "map.csv:4", "not the thickness of an oil film", "marks a hole"
        )

    def test_classic_and_damaged_netcdf(self):
        self.refuse_netcdf(b"CDF\x01" + bytes(60), "only NetCDF-4 is read", "nccopy -k nc4 map.nc map-nc4.nc")
        self.refuse_netcdf(b"\x89HDF\r\n\x1a\n" + bytes(60), "cannot be read as NetCDF")

    def test_a_film_of_no_thickness_reports_both_places(self):
        self.refuse_map(
            MAP.replace("10,20,10", "10,20,-1"), "at x = 10 mm, y = 20 mm the gap is -1 um", "no film is left"
        )

    def test_joined_sides_of_different_gaps(self):
        self.refuse_map(
            MAP.replace("0,20,20", "0,20,21"),
            "joins the sides",
            "20 um at y = 0 and 21 um at y = width",
            words=PERIODIC,
        )

    def test_grids_beyond_reason(self):
        self.refuse("more than 2e+06", "fewer cells", words=("--set", "solver.cells_y=100000"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
