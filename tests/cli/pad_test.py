"""A film of stated shape: `ringfilm run PAD.toml --json --csv`, its numbers, its files, its refusals."""

import csv
import json
import math
import pathlib
import unittest

import program

PAD = """\
title = "a plane slider"
[pad]
length = "10 mm"
gap = "gap.csv"
speed = "5 m/s"
left_pressure = "0 bar"
right_pressure = "0 bar"
separation = "0 um"
[lubricant]
viscosity = "0.02 Pa s"
density = "850 kg/m3"
[film]
cavitation_pressure = "0 bar"
[solver]
cells = 100
"""
GAP = "x [mm],h [um]\n0,20\n10,10\n"
SLIDER_LOAD = 6 * (math.log(2) - 2 / 3) * 0.02 * 5 * 0.01**2 / 10e-6**2  # Rayleigh 1918, m = 2 [N/m]
CONTACT = """\
[contact]
composite_modulus = "134.8 GPa"
asperity_density = "0.1 um-2"
asperity_radius = "1.5 um"
roughness = "4 um"
"""
HISTORY = "time [s],h [um]\n0,10\n0.001,5\n0.002,10\n"


class PadTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "pad.toml").write_text(PAD)
        (self.folder / "gap.csv").write_text(GAP)
        (self.folder / "h.csv").write_text(HISTORY)

    def json_of(self, *words, case="pad.toml"):
        return json.loads(self.run_well("run", case, "--json", *words))

    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.reader(file))


class Numbers(PadTest):
    def test_csv_without_a_name_takes_that_of_the_case(self):
        self.run_well("run", "pad.toml", "--json", "--csv")
        self.assertEqual(self.rows("pad.csv")[0][:2], ["time [s]", "x [m]"])

    def test_film_content_has_two_values_at_a_step_inside_a_cavity(self):
        """The same oil flows through both gaps: theta h is one number at a step where no pressure drives any."""
        (self.folder / "gap.csv").write_text("x [mm],h [um]\n0,10\n3,10\n3,14\n6,14\n6,20\n10,20\n")
        self.run_well("run", "pad.toml", "--csv", "film.csv")
        rows = [[float(word) for word in row] for row in self.rows("film.csv")[1:]]
        at = [row for row in rows if abs(row[1] - 6e-3) < 1e-9]
        self.assertEqual(len(at), 2)
        (_, _, h_left, _, content_left), (_, _, h_right, _, content_right) = at
        self.assertAlmostEqual(content_left * h_left, content_right * h_right, delta=1e-12)
        self.assertLess(content_right, content_left)
        at = [row for row in rows if abs(row[1] - 3e-3) < 1e-9]
        self.assertEqual(at[0][4], 1, "the film is full up to where it ruptures")

    def test_json_reports_load_friction_flow_and_fronts_in_si(self):
        reported = self.json_of()
        self.assertAlmostEqual(reported["load"] / SLIDER_LOAD, 1, delta=2e-4)  # second order at 100 cells
        self.assertAlmostEqual(reported["flow_left"] / (5 * 10e-6 * 2 / 3), 1, delta=2e-4)
        self.assertAlmostEqual(reported["mass_flow_left"], 850 * reported["flow_left"])
        self.assertEqual(reported["rupture_positions"], [])
        self.assertEqual(reported["reformation_positions"], [])
        self.assertEqual(reported["units"]["load"], "N/m")
        self.assertTrue(reported["complete"])
        self.assertEqual(reported["assumed"]["lubricant.viscosity_pressure"], "none")
        self.assertNotIn("history", reported)
        for name in ("friction_moving", "friction_fixed", "flow_right", "peak_film_pressure", "peak_position"):
            self.assertGreater(reported[name], 0, name)

    def test_csv_has_a_row_for_each_node(self):
        self.run_well("run", "pad.toml", "--csv", "out.csv")
        rows = self.rows("out.csv")
        self.assertEqual(rows[0], ["time [s]", "x [m]", "film_thickness [m]", "pressure [Pa]", "film_content"])
        self.assertEqual(len(rows), 1 + 101)
        self.assertEqual([float(v) for v in rows[1]], [0, 0, 20e-6, 0, 1])
        self.assertEqual([float(v) for v in rows[-1]], [0, 0.01, 10e-6, 0, 1])

    def test_a_step_is_repeated_in_the_csv(self):
        (self.folder / "gap.csv").write_text("x [mm],h [um]\n0,20\n7,20\n7,10\n10,10\n")
        self.run_well("run", "pad.toml", "--csv", "out.csv")
        at_step = [row for row in self.rows("out.csv")[1:] if float(row[1]) == 0.007]
        self.assertEqual([float(row[2]) for row in at_step], [20e-6, 10e-6])
        self.assertEqual(at_step[0][3], at_step[1][3])

    def test_netcdf_holds_the_film_along_the_pad(self):
        self.run_well("run", "pad.toml", "--output", "film.nc")
        film = (self.folder / "film.nc").read_bytes()
        self.assertEqual(film[:4], b"\x89HDF")
        for name in (b"film_thickness", b"pressure", b"film_content", b"load", b"ringfilm_pad_schema"):
            self.assertIn(name, film)

    def test_a_load_finds_its_separation(self):
        reported = self.json_of("--set", "pad.separation=", "--set", "pad.load=100 kN/m")
        self.assertAlmostEqual(reported["load"] / 1e5, 1, delta=1e-7)
        self.assertLess(reported["min_film_thickness"], 10e-6)
        self.assertIn("pressed-closer-than-gap", [note["topic"] for note in reported["notes"]])

    def test_a_separation_on_top_of_a_gap_is_reported(self):
        reported = self.json_of("--set", "pad.separation=5 um")
        self.assertAlmostEqual(reported["min_film_thickness"], 15e-6, delta=1e-15)
        self.assertIn("separation-adds-to-gap", [note["topic"] for note in reported["notes"]])

    def test_a_history_gives_arrays_over_time_and_the_last_instant(self):
        reported = self.json_of(
            "--csv",
            "out.csv",
            "--set",
            "pad.separation=",
            "--set",
            "pad.separation_history=h.csv",
            "--set",
            "pad.time_step=0.25 ms",
        )
        history = reported["history"]
        self.assertEqual(len(history["time"]), 9)
        for name in (
            "load",
            "friction_moving",
            "flow_left",
            "peak_film_pressure",
            "rupture_positions",
            "reformation_positions",
            "min_film_thickness",
            "cavitated_fraction",
        ):
            self.assertEqual(len(history[name]), 9, name)
        self.assertEqual(reported["time"], 0.002)
        self.assertEqual(reported["load"], history["load"][-1])
        self.assertAlmostEqual(history["min_film_thickness"][4], 15e-6, delta=1e-15)
        self.assertGreater(history["load"][4], history["load"][0])  # closing adds to the wedge
        self.assertEqual(len(self.rows("out.csv")), 1 + 9 * 101)

    def test_only_the_requested_instants_are_kept(self):
        reported = self.json_of(
            "--set",
            "pad.separation=",
            "--set",
            "pad.separation_history=h.csv",
            "--set",
            "pad.time_step=0.1 ms",
            "--set",
            "pad.output_step=1 ms",
            "--set",
            "pad.end_time=1.5 ms",
        )
        self.assertEqual([round(1e3 * t, 9) for t in reported["history"]["time"]], [0, 1, 1.5])
        self.assertEqual(reported["effort"]["time_steps"], 15)

    def test_the_gap_by_a_formula_is_that_of_its_points(self):
        line = ("pad.face.form=polynomial", "pad.face.coefficients=[-1, 20]")
        units = ("pad.face.length_unit=mm", "pad.face.height_unit=um")
        words = [word for setting in ("pad.gap=", *line, *units) for word in ("--set", setting)]
        self.assertAlmostEqual(self.json_of(*words)["load"] / self.json_of()["load"], 1, delta=1e-12)

    def test_the_other_direction_is_the_mirror(self):
        (self.folder / "gap.csv").write_text("x [mm],h [um]\n0,10\n10,20\n")
        reported = self.json_of("--set", "pad.direction=-x")
        self.assertAlmostEqual(reported["load"] / SLIDER_LOAD, 1, delta=2e-4)
        self.assertLess(reported["flow_left"], 0)
        self.assertGreater(reported["friction_moving"], 0)

    def test_barus_and_dowson_higginson_change_the_film(self):
        plain = self.json_of()["load"]
        barus = self.json_of(
            "--set", "lubricant.viscosity_pressure=barus", "--set", "lubricant.pressure_viscosity_coefficient=2e-8 m2/N"
        )["load"]
        self.assertGreater(barus, 1.01 * plain)
        dense = self.json_of(
            "--set", "lubricant.compressibility=dowson-higginson", "--set", "lubricant.dh_a=1e-8 1/Pa"
        )["load"]
        self.assertNotAlmostEqual(dense / plain, 1, delta=1e-4)

    def test_a_case_without_title_is_complete(self):
        (self.folder / "pad.toml").write_text(PAD.split("\n", 1)[1])
        self.assertEqual(self.json_of()["title"], "pad")

    def test_the_table_for_people(self):
        reported = self.run_well("run", "pad.toml")
        self.assertIn("15.89 kN/m   load carried, with the gas at the edges", reported)
        self.assertIn("per metre of width", reported)

    def test_check_reads_a_pad(self):
        self.assertIn("no errors", self.run_well("check", "pad.toml"))

    def test_shipped_pads_run(self):
        shipped = sorted((pathlib.Path(program.SOURCES) / "cases" / "pad").glob("*.toml"))
        self.assertGreaterEqual(len(shipped), 4)
        for path in shipped:
            with self.subTest(path.name):
                reported = self.json_of(case=str(path))
                self.assertTrue(reported["complete"])
                self.assertEqual(reported["effort"]["cut_steps"] + reported["effort"]["eased_starts"], 0)


class Contact(PadTest):
    def test_adds_a_load_and_friction(self):
        smooth = self.json_of()
        (self.folder / "pad.toml").write_text(PAD + CONTACT)
        rough = self.json_of()
        self.assertEqual(smooth["asperity_load"], 0)
        self.assertGreater(rough["asperity_load"], 0)
        self.assertEqual(rough["film_load"], smooth["film_load"])
        self.assertAlmostEqual(rough["load"], rough["film_load"] + rough["asperity_load"], delta=1e-9 * rough["load"])
        self.assertGreater(rough["boundary_friction"], 0, "of the Eyring stress alone")
        self.assertEqual(rough["assumed"]["contact.boundary_shear_strength_coefficient"], "0")
        self.assertEqual(rough["units"]["asperity_load"], "N/m")

    def test_is_for_an_infinitely_wide_pad(self):
        text = PAD.replace('separation = "0 um"', 'separation = "0 um"\nwidth = "10 mm"\nsides = "closed"')
        (self.folder / "pad.toml").write_text(text + CONTACT)
        self.assert_refused(
            self.run_program("run", "pad.toml"), "contact.composite_modulus is for a pad without pad.width", "[contact]"
        )

    def test_needs_the_modulus(self):
        (self.folder / "pad.toml").write_text(PAD + CONTACT.replace('composite_modulus = "134.8 GPa"\n', ""))
        self.assert_refused(
            self.run_program("run", "pad.toml"),
            "contact.asperity_density is not used in this case",
            "contact.composite_modulus is stated",
        )

    def test_names_the_keys_that_are_missing(self):
        (self.folder / "pad.toml").write_text(PAD + '[contact]\ncomposite_modulus = "134.8 GPa"\n')
        self.assert_refused(
            self.run_program("run", "pad.toml"),
            "the key contact.asperity_density is missing",
            "the key contact.asperity_radius is missing",
            "the key contact.roughness is missing",
        )


class Temperatures(PadTest):
    THERMAL = '[thermal]\nring = "140 degC"\nliner = "100 degC"\n[lubricant]\n'

    def setUp(self):
        super().setUp()
        text = PAD.replace('viscosity = "0.02 Pa s"\ndensity = "850 kg/m3"\n', 'grade = "SAE 10W-40"\n')
        self.text = text.replace("[lubricant]\n", self.THERMAL + 'viscosity_pressure = "none"\n')
        (self.folder / "pad.toml").write_text(self.text)

    def test_give_the_oil_its_viscosity(self):
        reported = self.json_of()
        self.assertAlmostEqual(reported["film_temperature"], 273.15 + 120)
        self.assertGreater(reported["viscous_heating_rise"], 0)
        self.assertGreater(self.json_of("--set", "thermal.film=liner")["load"], reported["load"])
        self.assertEqual(self.json_of("--set", "thermal.film=liner")["film_temperature"], 373.15)

    def test_are_one_of_each_wall(self):
        (self.folder / "pad.toml").write_text(
            self.text.replace('"100 degC"', '[["0 mm", "180 degC"], ["79 mm", "110 degC"]]')
        )
        self.assert_refused(
            self.run_program("run", "pad.toml"), "thermal.liner has several temperatures", "one temperature"
        )

    def test_take_the_place_of_the_viscosity(self):
        (self.folder / "pad.toml").write_text(self.text.replace("grade =", 'viscosity = "5 mPa s"\ngrade ='))
        self.assert_refused(self.run_program("run", "pad.toml"), "lubricant.viscosity is not used", "thermal.ring")

    def test_are_complete(self):
        (self.folder / "pad.toml").write_text(self.text.replace('liner = "100 degC"\n', ""))
        self.assert_refused(self.run_program("run", "pad.toml"), "thermal.liner is not stated")


class Refusals(PadTest):
    def refuse(self, *fragments, words=()):
        before = self.names()
        self.assert_refused(self.run_program("run", "pad.toml", "--csv", "out.csv", *words), *fragments)
        self.assertEqual(self.names(), before, "something was written")

    def refuse_set(self, setting, *fragments):
        self.refuse(*fragments, words=("--set", setting))

    def refuse_gap(self, text, *fragments):
        (self.folder / "gap.csv").write_text(text)
        self.refuse("gap.csv", *fragments)

    def test_neither_or_both_of_separation_and_load(self):
        self.refuse_set("pad.separation=", "exactly one of")
        text = PAD.replace('separation = "0 um"\n', 'separation = "0 um"\nload = "1 kN/m"\n')
        (self.folder / "pad.toml").write_text(text)
        self.refuse("pad.separation and pad.load", "exactly one of", "with [pad.oscillation]")
        self.assertRegex(self.run_program("check", "pad.toml").stderr, r"delete line \d+ or line \d+ of pad.toml")

    def test_a_load_of_the_command_line_takes_the_place_of_the_separation(self):
        done = self.run_program("run", "pad.toml", "--json", "--set", "pad.load=100 kN/m")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"^--set makes .*: pad.separation \(pad.toml:\d+\)\n$")
        oscillation = '[pad.oscillation]\namplitude = "5 um"\nperiod = "0.1 s"\n'
        (self.folder / "pad.toml").write_text(PAD.replace("[lubricant]", oscillation + "[lubricant]"))
        done = self.run_program("run", "pad.toml", "--json", "--set", "pad.load=100 kN/m")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"pad.separation .*, pad.oscillation.amplitude .*, pad.oscillation.period ")

    def test_keys_of_an_engine(self):
        (self.folder / "pad.toml").write_text(
            PAD + '[engine]\nbore = "89 mm"\nstroke = "80 mm"\n[ring]\nface_width = "1 mm"\n'
        )
        self.refuse("pad.toml:17:1", "engine.bore", "without engine, gas and ring", "take [ring] out", "2 errors")

    def test_missing_keys(self):
        for key in ("length", "gap", "speed", "left_pressure", "right_pressure"):
            with self.subTest(key):
                self.refuse_set(f"pad.{key}=", f"pad.{key} is missing")
        self.refuse_set("lubricant.viscosity=", "lubricant.viscosity is missing")
        self.refuse_set("lubricant.density=", "lubricant.density is missing")

    def test_units(self):
        self.refuse_set("pad.load=1 N", "a load per width")
        self.refuse_set("pad.speed=5 rpm", "a speed")
        self.refuse_set("pad.length=0.01", "has no unit")
        self.refuse_set("pad.speed=-5 m/s", "out of range")
        self.refuse_set("pad.left_pressure=1 barg", "left_pressure")

    def test_invalid_gaps(self):
        head = "x [mm],h [um]\n"
        self.refuse_gap(head + "0,20\n9,10\n", "from x = 0 to 9 mm", "pad.length")
        self.refuse_gap(head + "1,20\n10,10\n", "pad.length")
        self.refuse_gap(head + "10,20\n0,10\n", "gap.csv:3:1", "x falls")
        self.refuse_gap(head + "0,20\n5,20\n5,15\n5,10\n10,10\n", "gap.csv:5:1", "three times")
        self.refuse_gap(head + "0,20\n0,15\n10,10\n", "gap.csv:3:1", "at an end")
        self.refuse_gap(head + "0,20\n10,15\n10,10\n", "gap.csv:4:1", "at an end")
        self.refuse_gap(head + "0,nan\n10,10\n", "not a finite number")
        self.refuse_gap("x [mm],h [kg]\n0,20\n10,10\n", "h", "a length")
        self.refuse_gap("x [mm],thickness [um]\n0,20\n10,10\n", "no column h")
        self.refuse_gap("", "gap.csv")
        self.refuse_gap(head, "no row")

    def test_a_film_of_no_thickness(self):
        self.refuse_set("pad.separation=-10 um", "at x = 10 mm", "no film is left")
        (self.folder / "gap.csv").write_text("x [mm],h [um]\n0,20\n5,-1\n10,10\n")
        self.refuse("at x = 5 mm the gap is -1 um", "no film is left")

    def test_invalid_histories(self):
        words = ("--set", "pad.separation=", "--set", "pad.separation_history=h.csv")
        step = ("--set", "pad.time_step=0.1 ms")
        self.refuse("pad.time_step is missing", words=words)
        self.refuse("pad.end_time = 0 s", words=(*words, *step, "--set", "pad.end_time=0 s"))
        self.refuse("pad.end_time = 1 s", words=(*words, *step, "--set", "pad.end_time=1 s"))
        self.refuse("asks for 2e+09 steps", words=(*words, "--set", "pad.time_step=1e-12 s"))
        self.refuse("out of range", words=(*words, "--set", "pad.time_step=0 s"))
        self.refuse("not a whole number of time steps", words=(*words, *step, "--set", "pad.output_step=0.15 ms"))
        self.refuse("longer pad.output_step", words=(*words, "--set", "pad.time_step=1e-8 s"))
        (self.folder / "h.csv").write_text("time [s],h [um]\n0,10\n0,5\n")
        self.refuse("h.csv:3:1", "twice", words=(*words, *step))
        (self.folder / "h.csv").write_text("time [s],h [um]\n0,10\n1,-10\n")
        self.refuse("no film is left", words=(*words, *step))

    def test_formulas_of_the_gap(self):
        def refuse(*fragments, stated):
            words = [word for setting in ("pad.gap=", *stated) for word in ("--set", setting)]
            self.refuse(*fragments, words=words)

        refuse("pad.face.crown_height is missing", stated=["pad.face.form=cosine"])
        refuse("pad.gap is missing", "[pad.face] gives the gap by a formula", 'gap = "gap.csv"', "1 error", stated=[])
        refuse(
            "pad.face.coefficients is missing", "pad.face.length_unit is missing", stated=["pad.face.form=polynomial"]
        )
        units = ["pad.face.form=polynomial", "pad.face.length_unit=mm", "pad.face.height_unit=um"]
        refuse("pad.face.coefficients", stated=[*units, "pad.face.coefficients=[]"])
        refuse("no film is left", stated=[*units, "pad.face.coefficients=[1, -5]"])
        parabola = ["pad.face.form=parabola", "pad.face.crown_height=10 um", "pad.separation=10 um"]
        refuse("pad.face.length_unit is not used", stated=[*parabola, "pad.face.length_unit=mm"])
        refuse('pad.length = "0 mm" is out of range', "1 error", stated=[*parabola, "pad.length=0 mm"])
        self.refuse(
            "pad.face.crown_height is not used",
            'pad.face.form = "parabola" or "cosine"',
            words=("--set", "pad.face.crown_height=10 um"),
        )

    def test_grooves_and_journals(self):
        cosine = ("pad.gap=", "pad.face.form=cosine", "pad.face.crown_height=10 um", "pad.separation=10 um")

        def refuse(*fragments, stated):
            self.refuse(*fragments, words=[word for setting in (*cosine, *stated) for word in ("--set", setting)])

        size = ["pad.grooves.width=1 mm", "pad.grooves.depth=1 mm"]
        refuse("pad.grooves.width is missing", "pad.grooves.depth is missing", stated=["pad.grooves.positions=[0]"])
        refuse("1.2 of a groove is not on the pad", stated=[*size, "pad.grooves.positions=[0, 1.2]"])
        refuse("0.25 is not beyond the one before it", stated=[*size, "pad.grooves.positions=[0.2, 0.25]"])
        refuse("at the lowest point of the gap, x = 5 mm", stated=[*size, "pad.grooves.positions=[0.5]"])
        self.refuse_set("pad.grooves.positions=[0.5]", "is not used", 'pad.face.form is not "points"')
        self.refuse_set("pad.journal_radius=1 mm", "more than the journal has around it")
        self.refuse(
            "pad.journal_radius excludes pad.load",
            words=("--set", "pad.journal_radius=5 mm", "--set", "pad.separation=", "--set", "pad.load=1 kN/m"),
        )

    def test_a_file_and_a_formula_of_the_gap(self):
        face = '[pad.face]\nform = "parabola"\ncrown_height = "10 um"\n'
        (self.folder / "pad.toml").write_text(PAD.replace("0 um", "9 um") + face)
        self.refuse(
            "pad.toml:4:1: pad.gap is not used in this case",
            'where pad.face.form = "points", and pad.face.form is at pad.toml:17;',
            "1 error",
        )

    def test_oscillations(self):
        step = ("--set", "pad.time_step=1 ms", "--set", "pad.oscillation.amplitude=5 um")
        words = ("--set", "pad.separation=20 um", *step)
        period, end = ("--set", "pad.oscillation.period=0.1 s"), ("--set", "pad.end_time=0.05 s")
        reported = self.json_of(*words, *period, *end)
        self.assertAlmostEqual(reported["history"]["separation"][0], 25e-6, delta=1e-15)
        self.assertAlmostEqual(reported["separation"], 15e-6, delta=1e-15)
        self.refuse("pad.oscillation.period is missing", words=(*words, *end))
        self.refuse("pad.end_time is not stated", "an oscillation has no end", words=(*words, *period))
        self.refuse("pad.end_time = -1 s is not above 0 s", words=(*words, *period, "--set", "pad.end_time=-1 s"))
        self.refuse(
            "less pad.oscillation.amplitude = 5 um no film is left",
            words=(*step, *period, *end, "--set", "pad.separation=-5 um"),
        )
        self.refuse(
            "pad.oscillation.amplitude is not used",
            "pad.separation is given",
            words=(*step, *period, *end, "--set", "pad.separation=", "--set", "pad.load=1 kN/m"),
        )

    def test_oil_that_is_not_enough(self):
        self.refuse_set("lubricant.viscosity_pressure=barus", "pressure_viscosity_coefficient is not stated")
        self.refuse_set('lubricant.density=[{ temperature = "15 degC", value = "850 kg/m3" }]', "no temperature")

    def test_outputs_of_a_cycle(self):
        self.refuse("--ledger", words=("--ledger",))

    def test_a_load_that_nothing_carries_is_exit_code_3(self):
        done = self.run_program(
            "run",
            "pad.toml",
            "--set",
            "pad.separation=",
            "--set",
            "pad.load=1 N/m",
            "--set",
            "pad.left_pressure=1 bar",
            "--set",
            "pad.right_pressure=1 bar",
            "--csv",
            "out.csv",
        )
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("films were searched from 1e+04 um, the length of the pad", done.stderr)
        self.assertIn("the smallest one 1000 N/m", done.stderr)
        self.assertNotIn("out.csv", self.names())


if __name__ == "__main__":
    unittest.main(verbosity=2)
