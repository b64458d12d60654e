"""Starting a case of one's own: start cases, traces, shipped oils, assumptions, settings and terms of the trade."""

import json
import math
import re
import shlex
import unittest

import program


def section(printed, begin):
    """The indented lines after the line that begins so."""
    lines = printed.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith(begin))
    inside = []
    for line in lines[first + 1 :]:
        if not line.startswith("  "):
            break
        inside.append(line.strip())
    return inside


class StartTest(program.ProgramTest):
    def refused(self, *words):
        done = self.run_program(*words)
        self.assert_refused(done)
        return done.stderr

    def checked(self, name, *words):
        return json.loads(self.run_well("check", name, "--json", *words))

    def new(self, *words):
        """The start case as text, and what was printed."""
        (self.folder / "mine.toml").unlink(missing_ok=True)
        printed = self.run_well("new", "mine.toml", *words)
        return (self.folder / "mine.toml").read_text(), printed


class CheckTest(StartTest):
    def test_fits_a_screen_where_not_all_is_asked_for(self):
        self.new()
        lines = self.run_well("check", "mine.toml").splitlines()
        self.assertLessEqual(len(lines), 30)
        self.assertEqual([line for line in lines if len(line) > 120], [])

    def test_default_inputs_and_modelling_assumptions_are_two_lists(self):
        printed = self.run_well("check", "case.toml", "--all")
        inputs = section(printed, "default inputs")
        assumptions = section(printed, "modelling assumptions")
        self.assertTrue(any(line.startswith("film.cavitation = mass-conserving  (") for line in inputs))
        self.assertTrue(any(line.startswith("oil-supply: both edges are flooded") for line in assumptions))
        self.assertIn("additives lower it", printed)  # a consequence
        self.assertFalse(any(line.startswith("oil-supply") for line in inputs))
        self.assertIn(f"{len(inputs)} default inputs", printed.splitlines()[0])

    def test_json_has_the_same_two_lists(self):
        checked = self.checked("case.toml")
        printed = self.run_well("check", "case.toml", "--all")
        self.assertEqual(len(checked["default_inputs"]), len(section(printed, "default inputs")))
        self.assertIn("solver.cells", [entry["key"] for entry in checked["stated"]])
        self.assertIn("film.cavitation", [entry["key"] for entry in checked["default_inputs"]])
        topics = {entry["topic"]: entry for entry in checked["modelling_assumptions"]}
        self.assertIn("Newtonian", topics["shear-thinning"]["statement"])
        self.assertIn("multigrade", topics["shear-thinning"]["consequence"])
        self.assertEqual([note for note in checked["notes"] if not note["message"]], [])

    def test_json_of_a_bad_case_has_its_errors(self):
        self.assertEqual(self.checked("case.toml")["errors"], [])
        (self.folder / "case.toml").write_text(
            program.CASE.replace('bore = "89 mm"', 'bore = "89"').replace("[solver]", "[solver]\nmesh = 3")
        )
        done = self.run_program("check", "case.toml", "--json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("2 errors; nothing was run or written (exit code 2)", done.stderr)
        checked = json.loads(done.stdout)
        self.assertEqual(checked["case"], "case.toml")
        bore, mesh = checked["errors"]
        self.assertEqual((bore["file"], bore["line"], bore["column"]), ("case.toml", 3, 8))
        self.assertEqual(bore["line_text"], 'bore = "89"')
        self.assertIn("has no unit", bore["message"])
        self.assertIn("a length is required here", bore["remedy"])
        self.assertIn("unknown key solver.mesh", mesh["message"])
        done = self.run_program("check", "nowhere.toml", "--json")
        self.assertEqual(done.returncode, 2)
        self.assertIsNone(json.loads(done.stdout)["errors"][0]["line"])

    def test_the_summary_uses_the_same_two_terms(self):
        printed = self.run_well("run", "case.toml", "--all")
        self.assertRegex(printed, r"default inputs: \d+ keys that the case does not state")
        self.assertRegex(printed, r"modelling assumptions: \d+ \(oil-supply")

    def test_of_a_pack_the_second_ring_lists_what_differs(self):
        ring = '[ring]\nface_width = "1.2 mm"\nelastic_pressure = "0.2 MPa"\n[ring.face]\nform = "parabola"\n'
        ring += 'crown_height = "15 um"\n'
        self.assertIn(ring, program.CASE)
        one = ring.replace("[ring]", "[[ring]]").replace("[ring.face]\n", "").replace("form = ", "face.form = ")
        one = one.replace("crown_height = ", "face.crown_height = ")
        two = one.replace("0.2 MPa", "0.15 MPa")
        (self.folder / "case.toml").write_text(
            program.CASE.replace(ring, "") + one + 'pressure_below = "2.5 bar"\n' + two
        )
        printed = self.run_well("check", "case.toml", "--all")
        second = section(printed, "modelling assumptions of ring 2")
        self.assertTrue(any(line.startswith("ring-tension: the ring presses with 0.15 MPa") for line in second))
        self.assertFalse(any(line.startswith("shear-thinning") for line in second))
        self.assertEqual({one["ring"] for one in self.checked("case.toml")["modelling_assumptions"]}, {1, 2})
        done = self.run_program("check", "case.toml", "--set", "ring.2.tangential_force=9 N")
        self.assertIn("dropped: ring.2.elastic_pressure (case.toml:", done.stderr)

    def test_assumed_inputs_are_ranked_by_what_they_change(self):
        self.new()
        ranked = self.checked("mine.toml")["assumed_inputs"]
        changes = [abs(one["fmep_change"]) for one in ranked]
        self.assertEqual(changes, sorted(changes, reverse=True))
        self.assertTrue(all(one["solved"] for one in ranked))
        by_key = {one["key"]: one for one in ranked}
        self.assertTrue(by_key["supply.film"]["is_default"])
        self.assertFalse(by_key["engine.bore"]["is_default"])
        self.assertNotIn("gas.peak_angle", by_key)  # a default that nobody calls assumed
        zeta = by_key["contact.boundary_shear_strength_coefficient"]
        self.assertEqual(zeta["setting"], "contact.boundary_shear_strength_coefficient = 0.144")
        # As two runs on the usual cells have it; coarse ones are within 1 % each.
        fmep = json.loads(self.run_well("run", "mine.toml", "--json"))["fmep"]
        setting = zeta["setting"].replace(" ", "")
        changed = json.loads(self.run_well("run", "mine.toml", "--json", "--set", setting))["fmep"]
        self.assertAlmostEqual(zeta["fmep_change"], changed / fmep - 1, delta=0.02)
        rows = section(self.run_well("check", "mine.toml"), "assumed inputs that decide the result most")
        self.assertTrue(any(row.endswith("(0.8 um, default)") for row in rows))
        stated = self.checked("mine.toml", "--set", "engine.bore=89 mm")["assumed_inputs"]
        self.assertNotIn("engine.bore", [one["key"] for one in stated])

    def test_what_takes_long_is_computed_with_an_option(self):
        printed = self.run_well("check", "case.toml")
        self.assertRegex(printed, r"assumed inputs: \d+; --assumptions computes which of them decide the result most")
        self.assertIsNone(self.checked("case.toml")["assumed_inputs"])
        self.assertTrue(self.checked("case.toml", "--assumptions")["assumed_inputs"])

    def test_a_friction_that_depends_steeply_on_the_supply_is_noted(self):
        self.new("--engine", "heavy-duty")
        notes = json.loads(self.run_well("run", "mine.toml", "--json"))["notes"]
        steep = [note["message"] for note in notes if note["topic"] == "supply-steep"]
        self.assertEqual(len(steep), 1)
        self.assertRegex(steep[0], r"\(0.8 um, default\): with 20 % less oil on the liner the FMEP is \d+ % higher")
        flooded = json.loads(self.run_well("run", "mine.toml", "--json", "--set", "supply.film=4 um"))["notes"]
        self.assertNotIn("supply-steep", [note["topic"] for note in flooded])

    def test_a_pad_has_default_inputs_alone(self):
        pad = str(program.SOURCES / "verification/rayleigh1918_step/best.toml")
        self.assertNotIn("modelling assumptions", self.run_well("check", pad))
        self.assertEqual(self.checked(pad)["modelling_assumptions"], [])


class NewTest(StartTest):
    def test_a_start_case_has_forty_lines_and_all_of_it_states_the_same(self):
        for engine in ("passenger-car", "heavy-duty", "hydrogen"):
            text, _ = self.new("--engine", engine)
            self.assertLessEqual(len(text.splitlines()), 40)
            short = self.checked("mine.toml")
            self.new("--engine", engine, "--all")
            values = [{e["key"]: e["value"] for e in c["stated"]} for c in (short, self.checked("mine.toml"))]
            self.assertEqual(*values)
        refused = self.refused("new", "pack.toml", "--pack", "hydrogen", "--all")
        self.assertIn("--all is for the case of one ring", refused)

    def test_a_start_case_states_what_is_not_a_default(self):
        self.assertNotIn("cells", self.new()[0])
        text, _ = self.new("--all")
        self.assertRegex(text, r"(?m)^# cells = 200  # default$")
        self.assertNotRegex(text, r"(?m)^cells")
        checked = self.checked("mine.toml")
        for entry in checked["stated"]:
            if "lubricant." not in entry["key"]:  # those of the oil's file
                self.assertRegex(text, rf"(?m)^{entry['key'].split('.')[-1]} = .*  # ")
        self.assertIn("solver.cells", [entry["key"] for entry in checked["default_inputs"]])

    def test_the_result_of_a_start_case_has_fields_along_the_face(self):
        text, _ = self.new()
        self.assertRegex(text, r'(?m)^fields = "all"  # for the slider along the face in the report')
        self.run_well("run", "mine.toml", "--set", "solver.cells=60", "--output", "mine.nc")
        self.run_well("report", "mine.nc", "--output", "mine.html")
        self.assertNotIn('"stored_angles":0', (self.folder / "mine.html").read_text())

    def test_the_commented_defaults_are_the_defaults(self):
        for engine in ("passenger-car", "heavy-duty", "hydrogen"):
            text, _ = self.new("--engine", engine, "--all")
            before = self.checked("mine.toml")
            (self.folder / "stated.toml").write_text(re.sub(r"(?m)^# (\w+ = .*  # default)$", r"\1", text))
            after = self.checked("stated.toml")
            self.assertEqual(after["default_inputs"], [])
            values = {entry["key"]: entry["value"] for entry in before["stated"] + before["default_inputs"]}
            self.assertEqual({entry["key"]: entry["value"] for entry in after["stated"]}, values)

    def test_typical_numbers_are_marked_as_assumed(self):
        for words, speed, oil in (((), "1500 rpm", "5W-30"), (("--engine", "heavy-duty"), "1200 rpm", "15W-40")):
            text, _ = self.new(*words)
            self.assertIn(f'speed = "{speed}"  # typical, assumed', text)
            self.assertIn(f'grade = "SAE {oil}"  # typical, assumed', text)
            self.assertIn("boundary_shear_strength_coefficient = 0.12  # typical, assumed", text)
            for line in re.findall(r'(?m)^\w+ = (?:"[\d.]+ |[\d.]+ ).*$', text):
                self.assertIn("# typical, assumed", line)
            values = json.loads(self.run_well("run", "mine.toml", "--json", "--set", "solver.cells=60"))
            self.assertTrue(values["complete"])
            topics = {note["topic"] for note in values["notes"]}
            unusual = [
                topic for topic in topics if re.search("unusual|viscosity-(high|low)|ratio-too-low|gas-pressure", topic)
            ]
            self.assertEqual(unusual, [])
            self.assertNotIn("asperity-slopes-high", topics)
            self.assertLess(values["asperity_slope"], 0.2)

    def test_an_unknown_engine_is_refused(self):
        refused = self.refused("new", "mine.toml", "--engine", "heavy_duty")
        self.assertIn('no start case for the engine "heavy_duty"; did you mean heavy-duty?', refused)
        self.assertIn("one of: passenger-car, heavy-duty, hydrogen", refused)
        self.assertFalse((self.folder / "mine.toml").exists())

    def test_a_trace_is_read_and_what_it_does_not_show_is_asked_for(self):
        text, printed = self.new("--trace", "trace.csv")
        self.assertIn('cylinder_pressure = "trace.csv"', text)
        self.assertRegex(text, 'angle_zero = "firing-tdc"  # from the file: the highest pressure is at 1[0-9.]+ degree')
        self.assertIn('pressure in the column "cylinder_pressure", in bar', printed)
        self.assertIn("missing: gas.pressure_reference: absolute or gauge? The lowest pressure is", printed)
        self.assertEqual(printed.count("missing: "), 1)
        self.assertIn("the key gas.pressure_reference is missing", self.refused("check", "mine.toml"))
        text = text.replace('# pressure_reference = "absolute"', 'pressure_reference = "absolute"')
        (self.folder / "mine.toml").write_text(text)
        self.run_well("check", "mine.toml")

    def compressed(self, name, heading, offset=0.0, turn=0):
        """Writes the motored trace of the passenger-car engine at a ratio of 10 and an index of 1.33 [bar]."""

        def volume(deg):
            crank, rod = 39.75, 138.1
            angle = math.radians(deg)
            way = crank * (1 - math.cos(angle)) + rod - math.sqrt(rod**2 - (crank * math.sin(angle)) ** 2)
            return 2 * crank / 9 + way

        rows = []
        for deg in range(-360, 360):
            closed = -180 <= deg <= 180
            rows.append(f"{deg + turn};{offset + (0.95 * (volume(180) / volume(deg)) ** 1.33 if closed else 0.95):.5f}")
        (self.folder / name).write_text(heading + "\n" + "\n".join(rows) + "\n")

    def test_pressures_of_no_engine_and_a_shifted_tdc_are_noted(self):
        for number, (offset, turn, note) in enumerate(
            (
                (0, 0, None),
                (1, 0, "a polytropic index of 1 or less"),
                (-0.5, 0, "lower than the atmosphere into which it flows"),
                (0, -3, "about a peak at -3 degree"),
            )
        ):
            with self.subTest((offset, turn)):
                self.compressed("motored.csv", "CA [deg];p [bar]", offset, turn)
                text, printed = self.new("--trace", "motored.csv")
                self.assertEqual("note: " in printed, note is not None, printed)
                self.assertIn(note or "found in", printed)
                text = text.replace('# pressure_reference = "absolute"', 'pressure_reference = "absolute"')
                name = f"stated{number}.toml"
                (self.folder / name).write_text(text)
                checked = self.run_well("check", name)
                self.assertEqual("note: the cylinder pressure" in checked, bool(note), checked)
                self.assertIn(note or "no errors", " ".join(checked.split()))

    def test_german_exports_name_the_degree_grad(self):
        for unit in ("Grad", "GRAD", "Grad KW", "° KW"):
            self.compressed("export.csv", f"KW [{unit}];p [bar]")
            _, printed = self.new("--trace", "export.csv")
            self.assertIn("720 samples from -360 to 359 degree", printed)
        for unit, remedy in (("grad", "write degree, or gon"), ("Mrad", "write degree, rad or rev")):
            self.compressed("export.csv", f"KW angle [{unit}];p [bar]")
            self.assertIn(remedy, self.refused("new", "none.toml", "--trace", "export.csv"))

    def test_a_trace_without_units_and_with_several_columns(self):
        rows = "".join(f"{angle};{20 if angle == 370 else 1};3\n" for angle in range(0, 720, 10))
        (self.folder / "bench.csv").write_text("CAD;p_cyl;p_intake\n" + rows)
        _, printed = self.new("--trace", "bench.csv")
        self.assertIn('gas.pressure_column: which column is the pressure? "p_cyl", "p_intake"', printed)
        self.assertNotIn("gas.angle_unit", printed)  # 710 radians are not a cycle
        self.assertIn("gas.angle_zero: firing-tdc or gas-exchange-tdc?", printed)
        (self.folder / "bench.csv").write_text("CAD [deg];p_cyl [barg]\n" + re.sub(r";3\n", "\n", rows))
        text, printed = self.new("--trace", "bench.csv")
        self.assertIn('pressure_reference = "gauge"  # from the file', text)
        self.assertNotIn("barg in the header", printed)  # it is read as the gauge pressure that it states
        (self.folder / "bench.csv").write_text("CAD [deg];p_cyl [bar]\n" + re.sub(r";3\n", "\n", rows))
        self.assertIn('angle_zero = "gas-exchange-tdc"  # from the file', self.new("--trace", "bench.csv")[0])

    def test_a_trace_without_a_header_is_read_by_stated_columns(self):
        self.compressed("plain.csv", "CA [deg];p [bar]")
        lines = (self.folder / "plain.csv").read_text().split("\n")
        (self.folder / "bare.csv").write_text("\n".join(["bench 3", *lines[1:]]))
        stated = ("--columns", "CA [deg], p [bar]", "--skip-lines", "1")
        text, printed = self.new("--trace", "bare.csv", *stated)
        self.assertIn('columns = "CA [deg], p [bar]"', text)
        self.assertIn("skip_lines = 1", text)
        self.assertIn("720 samples from -360 to 359 degree", printed)
        self.assertIn("indicated mean effective pressure", printed)
        text = text.replace('# pressure_reference = "absolute"', 'pressure_reference = "absolute"')
        (self.folder / "bare.toml").write_text(text)
        self.run_well("check", "bare.toml")
        pegged = self.run_well("check", "bare.toml", "--set", "gas.pegging=intake", "gas.intake_pressure=1.2 bar")
        self.assertIn("the cylinder pressure was pegged", pegged)

    def test_a_part_of_a_cycle_asks_for_intake_and_exhaust(self):
        rows = "".join(f"{angle},{1 + 40 / (1 + (angle / 30) ** 2)}\n" for angle in range(-180, 181, 5))
        (self.folder / "part.csv").write_text("crank_angle [degree],pressure [bar]\n" + rows)
        _, printed = self.new("--trace", "part.csv")
        self.assertIn("missing: gas.intake_pressure: the trace covers a part of the cycle", printed)
        self.assertIn("missing: gas.exhaust_pressure", printed)

    def test_a_trace_is_named_from_the_folder_of_the_case(self):
        (self.folder / "cases").mkdir()
        self.run_well("new", "cases/mine.toml", "--trace", "trace.csv")
        self.assertIn('"../trace.csv"', (self.folder / "cases/mine.toml").read_text())

    def test_what_is_not_a_trace_is_refused_and_nothing_is_written(self):
        (self.folder / "x.csv").write_text("x [mm],height [um]\n0,1\n1,2\n")
        refused = self.refused("new", "my.toml", "--trace", "x.csv")
        self.assertIn("x.csv:1:1: no column of the file is a crank angle", refused)
        self.assertIn("no column of the file is a pressure", refused)
        self.assertIn("nowhere.csv", self.refused("new", "my.toml", "--trace", "nowhere.csv"))
        self.assertFalse((self.folder / "my.toml").exists())


class OilsTest(StartTest):
    def with_oil(self, lines):
        text = program.CASE[: program.CASE.index("[lubricant]")] + "[lubricant]\n" + lines + "[solver]\ncells = 60\n"
        (self.folder / "case.toml").write_text(text)

    def test_the_list_has_the_values_of_the_files(self):
        oils = {oil["grade"]: oil for oil in json.loads(self.run_well("oils", "--json"))}
        self.assertIn("SAE 10W-40, typical", self.run_well("oils"))
        for grade, oil in oils.items():
            stated = (program.SOURCES / oil["file"]).read_text()
            at_40, at_100 = re.findall(r'value = "([\d.]+) mm2/s"', stated)
            self.assertAlmostEqual(oil["kinematic_viscosity_40"] * 1e6, float(at_40), 6)
            self.assertAlmostEqual(oil["kinematic_viscosity_100"] * 1e6, float(at_100), 6)
            self.assertLess(oil["kinematic_viscosity_150"], oil["kinematic_viscosity_100"])
            # An oil of some 0.76 kg/l at 150 degC.
            self.assertAlmostEqual(oil["viscosity_150"] / oil["kinematic_viscosity_150"], 765, delta=45)
        self.assertTrue({"SAE 0W-20", "SAE 5W-30", "SAE 10W-40", "SAE 15W-40", "SAE 30", None} <= set(oils))

    def test_the_shipped_grades_keep_the_bounds_of_their_class(self):
        # SAE J300: kinematic viscosity at 100 degC [mm2/s], least HTHS viscosity [mPa s]. That of 40 is 3.5 of 0W, 5W
        # and 10W, else 3.7.
        bounds = {
            "8": (4.0, 6.1, 1.7),
            "12": (5.0, 7.1, 2.0),
            "16": (6.1, 8.2, 2.3),
            "20": (6.9, 9.3, 2.6),
            "30": (9.3, 12.5, 2.9),
            "40": (12.5, 16.3, 3.5),
            "50": (16.3, 21.9, 3.7),
        }
        grades = sorted((program.SOURCES / "data" / "lubricants").glob("sae-*.toml"))
        self.assertGreaterEqual(len(grades), 10)
        for grade in grades:
            words = grade.stem.split("-")
            low, high, hths = bounds[words[-1]]
            if words[-1] == "40" and words[1] not in ("0w", "5w", "10w"):
                hths = 3.7
            text = grade.read_text()
            at_100 = float(re.findall(r'value = "([\d.]+) mm2/s"', text)[1])
            self.assertTrue(low <= at_100 < high, grade.name)
            stated = re.search(r'hths_viscosity = "([\d.]+) mPa s"', text)
            self.assertTrue(stated is None or float(stated[1]) >= hths, grade.name)

    def test_a_grade_is_the_file_of_that_name(self):
        self.with_oil('file = "data/lubricants/sae-10w-40.toml"\n')
        by_file = json.loads(self.run_well("run", "case.toml", "--json"))
        for grade in ("SAE 10W-40", "10w-40", "sae 10W40"):
            self.with_oil(f'grade = "{grade}"\n')
            self.assertEqual(json.loads(self.run_well("run", "case.toml", "--json"))["fmep"], by_file["fmep"])

    def test_an_unknown_grade_lists_those_that_are_known(self):
        self.with_oil('grade = "SAE 10W-41"\n')
        refused = self.refused("check", "case.toml")
        self.assertIn('no shipped oil has the grade "SAE 10W-41"', refused)
        self.assertIn('choose one of "SAE 0W-12", "SAE 0W-16", "SAE 0W-20", "SAE 0W-8", "SAE 10W-40"', refused)
        self.assertNotIn("lubricant.density is missing", refused)

    def test_file_and_grade_together_are_refused_with_both_lines(self):
        self.with_oil('file = "data/lubricants/sae-30.toml"\ngrade = "SAE 30"\n')
        refused = self.refused("check", "case.toml")
        self.assertIn("lubricant.grade and lubricant.file are both given", refused)
        self.assertRegex(refused, r"delete line \d+ or line \d+ of case.toml")

    def test_a_grade_of_the_command_line_takes_the_place_of_the_oil_of_the_case(self):
        done = self.run_program("check", "case.toml", "--json", "--set", "lubricant.grade=SAE 30")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"^--set makes .*lubricant.kinematic_viscosity \(case.toml:\d+\).*\n$")
        shown = {entry["key"]: entry["shown"] for entry in json.loads(done.stdout)["stated"]}
        self.assertEqual(shown["lubricant.kinematic_viscosity"], "94 mm2/s at 40 degC; 11 mm2/s at 100 degC")


class SettingsTest(StartTest):
    def dropped(self, *settings):
        done = self.run_program("check", "case.toml", "--json", *settings)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        return done.stderr, {entry["key"] for entry in json.loads(done.stdout)["stated"]}

    def test_a_setting_drops_the_keys_that_it_makes_unused(self):
        text = program.CASE.replace("[ring]\n", '[ring]\nyoungs_modulus = "200 GPa"\n')
        (self.folder / "case.toml").write_text(text)
        line = text.splitlines().index('youngs_modulus = "200 GPa"') + 1
        said, stated = self.dropped("--set", "contact.composite_modulus=190 GPa")
        self.assertEqual(
            said, f"--set makes keys of the case unused, they are dropped: ring.youngs_modulus (case.toml:{line})\n"
        )
        self.assertNotIn("ring.youngs_modulus", stated)
        said, stated = self.dropped("--set", "gas.model=wiebe")
        for key in ("cylinder_pressure", "pressure_reference", "angle_zero"):
            self.assertIn("gas." + key, said)
        said, _ = self.dropped("--set", "thermal.liner=150 degC", "thermal.ring=180 degC")
        self.assertIn("operating.oil_temperature", said)

    def test_other_conditions_replace_what_the_case_states_and_the_same_ones_nothing(self):
        said, stated = self.dropped("--set", "conditions=engine")
        self.assertIn("operating.oil_temperature", said)
        self.assertIn("conditions", stated)
        (self.folder / "case.toml").write_text('conditions = "engine"\n' + program.CASE)
        done = self.run_program("check", "case.toml", "--json", "--set", "conditions=engine")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("operating.oil_temperature", {entry["key"] for entry in json.loads(done.stdout)["stated"]})
        study = (
            'title = "conditions"\nkind = "map"\n[[base]]\nname = "a"\ncase = "case.toml"\n'
            '[[factor]]\nkey = "conditions"\nvalues = ["engine", "as-in-the-paper"]\n[plan]\nmethod = "grid"\n'
        )
        (self.folder / "study.toml").write_text(study)
        self.run_well("study", "study.toml", "--output", "study.nc")
        try:
            import netCDF4
        except ImportError:
            program.skip_loudly(self, "no module netCDF4")
        with netCDF4.Dataset(self.folder / "study.nc") as file:
            self.assertEqual(len(set(file["fmep"][:].flatten().tolist())), 2)

    def test_a_trace_of_the_whole_cycle_drops_the_pressures_that_a_part_of_it_needed(self):
        rows = "".join(f"{angle},{1 + 40 / (1 + (angle / 30) ** 2)}\n" for angle in range(-180, 181, 5))
        (self.folder / "part.csv").write_text("crank_angle [degree],pressure [bar]\n" + rows)
        part = 'cylinder_pressure = "part.csv"\nintake_pressure = "1 bar"\nexhaust_pressure = "1 bar"\n'
        text = program.CASE.replace('cylinder_pressure = "trace.csv"\n', part)
        (self.folder / "case.toml").write_text(text)
        said, stated = self.dropped("--set", "gas.cylinder_pressure=trace.csv")
        for key in ("gas.intake_pressure", "gas.exhaust_pressure"):
            self.assertIn(key, said)
            self.assertNotIn(key, stated)

    def test_another_way_to_state_the_tension_replaces_the_one_of_the_case(self):
        said, stated = self.dropped("--set", "ring.tangential_force=12.5 N")
        self.assertIn("ring.elastic_pressure (case.toml:", said)
        self.assertIn("ring.tangential_force", stated)
        self.assertNotIn("ring.elastic_pressure", stated)

    def test_for_files_and_for_a_setting_that_is_unused_itself_the_rule_is_strict(self):
        self.assertIn(
            "gas.peak_pressure is not used", self.refused("check", "case.toml", "--set", "gas.peak_pressure=80 bar")
        )
        (self.folder / "case.toml").write_text(program.CASE.replace("[gas]\n", '[gas]\npeak_pressure = "80 bar"\n'))
        self.assertIn("gas.peak_pressure is not used", self.refused("check", "case.toml", "--set", "solver.cells=70"))

    def test_settings_can_be_typed_as_the_ledger_prints_them(self):
        printed = self.run_well("run", "case.toml", "--ledger")
        settings = re.findall(r"(?m)^  (\S+ = .*?)(?:  | not solved)", printed)
        self.assertGreater(len(settings), 10)
        for setting in settings:
            key = setting.split(" = ")[0]
            for words in (shlex.split(setting), [setting]):
                done = self.run_program("check", "case.toml", "--json", "--set", *words)
                self.assertEqual(done.returncode, 0, setting + "\n" + done.stderr)
                entries = {entry["key"]: entry["shown"] for entry in json.loads(done.stdout)["stated"]}
                self.assertEqual(entries[key], shlex.split(setting)[-1])


class MessagesTest(StartTest):
    def check(self, old, new):
        self.assertIn(old, program.CASE)
        (self.folder / "case.toml").write_text(program.CASE.replace(old, new))
        return self.refused("check", "case.toml")

    def test_a_key_given_twice_names_the_lines_to_delete(self):
        reported = self.check('bore = "89 mm"\n', 'bore = "89 mm"\nbore = "90 mm"\n')
        self.assertIn("bore is given twice", reported)
        self.assertIn("delete line 3 or line 4 of case.toml", reported)
        reported = self.check("[solver]\n", '[engine]\nbore = "90 mm"\n[solver]\n')
        self.assertIn("[engine] is given twice", reported)
        self.assertRegex(reported, r"move its keys below line 2 and delete line \d+")
        (self.folder / "part.toml").write_text('[engine]\nbore = "90 mm"\n')
        reported = self.check("[engine]\n", 'include = ["part.toml"]\n[engine]\n')
        self.assertIn("engine.bore is given twice", reported)
        self.assertIn("delete line 2 of part.toml or line 4 of case.toml", reported)

    def test_terms_of_the_trade_lead_to_the_key(self):
        for word, key in (
            ("closed_gap", "ring.end_gap"),
            ("tangential_load", "ring.tangential_force"),
            ("barrel_drop", "ring.face.crown_height"),
            ("gauge_width", "ring.face.crown_height"),
            ("axial_width", "ring.face_width"),
            ("diametral_force", "ring.tangential_force"),
        ):
            reported = self.check("[ring]\n", f'[ring]\n{word} = "1 mm"\n')
            self.assertIn(f"unknown key ring.{word}; did you mean {key}?", reported)
        self.assertIn(
            "barrel drop (face width/gauge width)^2", self.check("[ring]\n", '[ring]\nbarrel_drop = "8 um"\n')
        )

    def test_what_is_not_modelled_is_named_with_what_to_state_instead(self):
        for key, word in (("edge_chamfer", "chamfer"), ("chamfer", "chamfer")):
            reported = self.check("[ring]\n", f"[ring]\n{key} = 6\n")
            self.assertIn(f"unknown key ring.{key}: {word} is not modelled", reported)
            self.assertIn('ring.face.form = "points"', reported)
        self.assertIn(
            "[ring.chamfer]: chamfer is not modelled", self.check("[solver]\n", "[ring.chamfer]\nangle = 1\n[solver]\n")
        )


if __name__ == "__main__":
    unittest.main()
