"""The gas between the rings: `ringfilm gas PACK.toml --json --csv`, its numbers, its refusals, and the coupled run."""

import csv
import json
import math
import re
import unittest

import program

HEAD = """\
title = "a pack"
[engine]
bore = "89 mm"
stroke = "79.5 mm"
connecting_rod_length = "138.1 mm"
[operating]
speed = "1500 rpm"
[gas]
model = "trace"
cylinder_pressure = "trace.csv"
pressure_reference = "absolute"
angle_zero = "firing-tdc"
[gas_path]
model = "orifice-volume"
gas_constant = "287 J/(kg K)"
viscosity = "2.5e-5 Pa s"
chamber_temperature = "600 K"
"""
GROOVE = """\
groove_volume = "300 mm3"
groove_temperature = "500 K"
side_clearance = "50 um"
land_clearance = "0.2 mm"
radial_thickness = "3.5 mm"
mass = "8 g"
"""
TOP = (
    """\
[[ring]]
kind = "compression"
face_width = "1.2 mm"
elastic_pressure = "0.2 MPa"
gap_area = "0.08 mm2"
volume_below = "0.5 cm3"
temperature_below = "450 K"
"""
    + GROOVE
)
SECOND = (
    """\
[[ring]]
face_width = "1.5 mm"
elastic_pressure = "0.2 MPa"
end_gap = "0.4 mm"
volume_below = "300 mm3"
"""
    + GROOVE
)
OIL = '[[ring]]\nkind = "oil"\ngap_area = "0.3 mm2"\n'
FACE = """\
[[ring]]
kind = "oil"
gap_area = "0.3 mm2"
face_width = "0.4 mm"
elastic_pressure = "1 MPa"
[ring.face]
form = "parabola"
crown_height = "2 um"
"""


RAIL_NUMBERS = [(1, None), (2, None), (3, 1), (3, 2)]


class GasTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write(HEAD + TOP + SECOND + OIL)

    def write(self, text):
        (self.folder / "pack.toml").write_text(text)

    def json_of(self, *words):
        return json.loads(self.run_well("gas", "pack.toml", "--json", *words))

    def test_prints_blow_by_regions_and_mass_defect(self):
        found = self.json_of()
        names = [region["name"] for region in found["regions"]]
        self.assertEqual(names, ["chamber", "groove 1", "land 2", "groove 2", "land 3", "crankcase"])
        self.assertGreater(found["blow_by_per_cycle"], 1e-7)
        density = 101325 / (287 * 298.15)
        flow = found["blow_by_per_cycle"] / 0.08 / density  # [m3/s]
        self.assertAlmostEqual(found["blow_by_flow"] / flow, 1, delta=1e-12)
        self.assertEqual(found["units"]["blow_by_flow"], "m3/s")
        self.assertLess(found["mass_defect"], 1e-12)
        self.assertEqual(found["ring_events"], [])
        self.assertIn("gas_path.crankcase_temperature", found["assumed"])
        self.assertNotIn("lubricant.density", found["assumed"])

    def test_axial_motion_reports_events(self):
        events = self.json_of("--set", "gas_path.ring_motion=axial")["ring_events"]
        self.assertEqual({event["event"].split("-")[0] for event in events}, {"leaves", "lands"})
        self.assertEqual([event["crank_angle"] for event in events], sorted(e["crank_angle"] for e in events))

    def test_end_gaps_below_each_other_pass_more_gas(self):
        def blow_by(*settings):
            return self.json_of(*(word for one in settings for word in ("--set", one)))["blow_by_per_cycle"]

        apart = blow_by("ring.1.gap_position=0 degree", "ring.2.gap_position=180 degree")
        self.assertEqual(apart, blow_by(), "gaps that are apart are those without a position")
        aligned = blow_by("ring.1.gap_position=10 degree", "ring.2.gap_position=10 degree")
        self.assertGreater(aligned, 1.02 * apart)
        near = blow_by("ring.1.gap_position=-1 degree", "ring.2.gap_position=359.5 degree")
        self.assertTrue(apart < near < aligned)
        # The second gap is as large as the first, 0.4 mm by 0.2 mm: 0.08 mm2/sqrt(1 - 0.5).
        wider = blow_by(f"ring.2.end_gap={0.4 / math.sqrt(0.5)!r} mm")
        self.assertAlmostEqual(aligned / wider, 1, delta=1e-9)
        self.assertEqual(blow_by("ring.1.gap_position=0 degree"), apart, "one position alone has no effect")

    def test_another_tension_leaves_the_thickness_to_the_gas(self):
        done = self.run_program("gas", "pack.toml", "--json", "--set", "ring.1.tangential_force=30 N")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("ring.1.elastic_pressure", done.stderr)
        self.assertNotIn("ring.1.radial_thickness", done.stderr)

    def test_csv_has_each_degree(self):
        self.run_well("gas", "pack.toml", "--csv", "gas.csv")
        with open(self.folder / "gas.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["crank_angle [degree]"] for row in rows], [str(k) for k in range(720)])
        out = sum(float(row["flow_end_gap_3 [kg/s]"]) for row in rows) * 0.08 / 720
        self.assertAlmostEqual(out / self.json_of()["blow_by_per_cycle"], 1, delta=1e-3)
        self.assertIn("position_ring_2 [m]", rows[0])
        self.assertNotIn("position_ring_3 [m]", rows[0])

    def test_between_given_pressures_the_same_gas_flows(self):
        computed = self.json_of("--csv", "gas.csv")
        with open(self.folder / "gas.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        for number in (2, 3):
            lines = [f"{row['crank_angle [degree]']},{row[f'pressure_land_{number} [Pa]']}" for row in rows]
            text = "crank_angle [degree],pressure [Pa]\n" + "\n".join(lines) + "\n"
            (self.folder / f"land_{number}.csv").write_text(text)
        given = HEAD.replace("orifice-volume", "given")
        self.write(given + TOP + 'pressure_below = "land_2.csv"\n' + SECOND + 'pressure_below = "land_3.csv"\n' + OIL)
        found = self.json_of()
        self.assertLess(found["mass_defect"], 1e-12)
        for one, other in zip(found["regions"], computed["regions"], strict=True):
            self.assertEqual(one["name"], other["name"])
            self.assertAlmostEqual(one["peak_pressure"] / other["peak_pressure"], 1, delta=1e-3)
        for one, other in zip(found["paths"], computed["paths"], strict=True):
            self.assertAlmostEqual(one["mass_per_cycle"] * 1e6, other["mass_per_cycle"] * 1e6, delta=5e-3)
        self.assertAlmostEqual(found["blow_by_per_cycle"] / computed["blow_by_per_cycle"], 1, delta=2e-3)

    def test_one_file_for_two_outputs_is_refused(self):
        done = self.run_program("gas", "pack.toml", "-o", "same", "--csv", "same")
        self.assert_refused(done, "--output and --csv name the same file")

    def test_a_trace_that_was_computed_is_noted(self):
        shipped = str(program.SOURCES / "cases" / "ring-pack" / "two_rings.toml")
        found = json.loads(self.run_well("gas", shipped, "--json"))
        self.assertEqual([note["topic"] for note in found["notes"]], ["synthetic-trace", "ring-unseated"])

    def test_values_that_vary_are_combined(self):
        varied = ("--vary", "operating.speed=1000 rpm, 3000 rpm", "--vary", "ring.1.gap_area=0.05 mm2, 0.08 mm2")
        self.run_well("gas", "pack.toml", *varied, "--csv", "map.csv")
        with open(self.folder / "map.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["operating.speed"] for row in rows], 2 * ["1000 rpm"] + 2 * ["3000 rpm"])
        one = self.json_of("--set", "operating.speed=3000 rpm")
        self.assertEqual(float(rows[3]["blow_by_per_cycle [kg]"]), one["blow_by_per_cycle"])
        self.assertEqual(float(rows[3]["blow_by_flow [m3/s]"]), one["blow_by_flow"])
        self.assertEqual(float(rows[3]["peak_pressure_land_2 [Pa]"]), one["regions"][2]["peak_pressure"])
        self.assertLess(float(rows[0]["blow_by_flow [m3/s]"]), float(rows[1]["blow_by_flow [m3/s]"]))
        for words, text in (
            (("--vary", "operating.speed"), "is not a key with its values"),
            (("--vary", "operating.speed=1000 rpm, 5 m"), "--vary: operating.speed"),
            ((*varied, "--json"), "are of one"),
        ):
            self.assert_refused(self.run_program("gas", "pack.toml", *words), text)

    def test_combinations_with_other_regions_share_the_columns(self):
        self.run_well("gas", "pack.toml", "--vary", "ring.1.volume_below=0 mm3, 500 mm3", "--csv", "map.csv")
        with open(self.folder / "map.csv", encoding="utf-8", newline="") as file:
            without, whole = csv.DictReader(file)
        peaks = [name for name in whole if name.startswith("peak_pressure_")]
        regions = self.json_of("--set", "ring.1.volume_below=500 mm3")["regions"]
        self.assertEqual(peaks, [f"peak_pressure_{region['name'].replace(' ', '_')} [Pa]" for region in regions])
        self.assertEqual(without["peak_pressure_land_2 [Pa]"], "")
        self.assertAlmostEqual(float(without["peak_pressure_crankcase [Pa]"]), regions[-1]["peak_pressure"], delta=1)
        self.assertEqual((without["period_in_cycles"], without["reason"]), ("1", ""))

    def test_the_file_has_the_curves(self):
        self.run_well("gas", "pack.toml", "-o", "gas.nc")
        self.assertTrue((self.folder / "gas.nc").read_bytes().startswith(b"\x89HDF"))

    def test_the_file_is_drawn_as_a_page(self):
        self.run_well("gas", "pack.toml", "-o", "gas.nc")
        self.run_well("report", "gas.nc", "-o", "gas.html")
        page = (self.folder / "gas.html").read_text()
        drawn = json.loads(re.search(r'id="result-data">(.*?)</script>', page, re.DOTALL)[1])
        printed = self.json_of()
        self.assertEqual(drawn["gas"]["blow_by_per_cycle"], printed["blow_by_per_cycle"])
        self.assertEqual(len(drawn["gas"]["pressure"]), len(printed["regions"]))
        self.assertIn("ring.1.side_clearance", [entry["key"] for entry in drawn["inputs"]])
        self.assertEqual([file["role"] for file in drawn["files"]], ["case", "gas.cylinder_pressure"])

    def test_the_page_of_the_gas_is_of_one_file_without_films(self):
        self.run_well("gas", "pack.toml", "-o", "gas.nc")
        self.run_well("run", "case.toml", "-o", "film.nc")
        for words, text in (
            (("film.nc", "gas.nc", "-o", "x.html"), "gas.nc: the gas of a ring pack alone has a page of its own"),
            (("gas.nc", "--vts", "fields"), "has neither curves of films nor fields"),
        ):
            self.assert_refused(self.run_program("report", *words), text)
        cut = (self.folder / "gas.nc").read_bytes()
        (self.folder / "cut.nc").write_bytes(cut[:-100])
        self.assert_refused(self.run_program("report", "cut.nc", "-o", "x.html"), "cut.nc: the file does not end with")

    def test_keys_that_do_not_act_on_the_gas_are_refused_or_reported(self):
        for key, values in (
            ("title", "a, b"),
            ("ring.2.name", "a, b"),
            ("ring.3.rails", "1, 2"),
            ("gas_path.film", "sealing, breakthrough"),
            ("lubricant.grade", "SAE 30, SAE 40"),
            ("ring.1.conformity", "rigid, beam"),
        ):
            refused = self.run_program("gas", "pack.toml", "--vary", f"{key}={values}")
            self.assert_refused(
                refused, f"--vary {key} has no effect: the gas of a ring pack alone does not follow from it"
            )
        done = self.run_program("gas", "pack.toml", "--json", "--set", "ring.3.rails=2", "--set", "title=new")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "--set states keys that the gas alone does not use: ring.3.rails\n")
        self.assertEqual(json.loads(done.stdout)["title"], "new")

    def test_a_key_that_set_states_is_not_varied(self):
        self.assert_refused(
            self.run_program("gas", "pack.toml", "--set", "ring.1.mass=9 g", "--vary", "ring.1.mass=8 g, 10 g"),
            "ring.1.mass is stated by --set and by --vary",
        )

    def test_gas_through_films_is_noted_where_the_gas_alone_is_computed(self):
        self.write((HEAD + TOP + SECOND + OIL).replace("[gas_path]\n", '[gas_path]\nfilm = "breakthrough"\n'))
        messages = [note["message"] for note in self.json_of()["notes"]]
        self.assertTrue(any(message.startswith('gas_path.film = "breakthrough" is not used') for message in messages))

    def test_a_pad_has_no_ring_pack(self):
        pad = program.SOURCES / "cases" / "pad" / "pocket.toml"
        done = self.run_program("gas", str(pad))
        self.assert_refused(done, "a case with [pad] has no ring pack")
        self.assertIn("\n1 error; nothing", done.stderr)

    def test_run_of_the_gas_alone_names_the_command_for_it(self):
        self.write((HEAD + TOP + SECOND + OIL).replace("mass = ", 'land_below = "4 mm"\nmass = ', 1))
        for command in ("run", "check"):
            done = self.run_program(command, "pack.toml")
            self.assert_refused(done, "the case describes the gas of its rings alone", "ringfilm gas pack.toml")
            self.assertNotIn("land_below", done.stderr)
            self.assertIn("\n1 error; nothing", done.stderr)

    def test_static_twist_is_reported_of_rings_with_a_width(self):
        found = self.json_of()
        self.assertEqual(found["units"]["largest_static_twist"], "rad")
        pattern = re.compile(r"^ +[12] .* %\s+(none|\S+ degree at \d+)$", re.MULTILINE)
        shown = pattern.findall(self.run_well("gas", "pack.toml"))
        for ring, text in zip(found["ring_motion"], shown, strict=True):
            degree = math.degrees(ring["largest_static_twist"])
            self.assertLess(abs(degree), 1)
            if degree == 0:
                self.assertEqual(text, "none")
            else:
                self.assertAlmostEqual(float(text.split()[0]) / degree, 1, delta=0.05)
            self.assertLessEqual(ring["twisted_share"], 1 - ring["unseated_share"])
        self.write(HEAD + TOP.replace('face_width = "1.2 mm"\n', "") + SECOND + OIL)
        self.assertNotIn("largest_static_twist", self.json_of()["ring_motion"][0])

    def test_a_seated_ring_that_much_lifts_off_its_flank_is_noted(self):
        for motion in ("seated", "axial"):
            found = self.json_of("--set", f'gas_path.ring_motion="{motion}"')
            noted = [note["message"] for note in found["notes"] if note["topic"] == "ring-unseated"]
            lifted = [ring["ring"] for ring in found["ring_motion"] if ring.get("least_seating_force", 0) < -50]
            self.assertTrue(lifted)
            self.assertEqual(len(noted), len(lifted) if motion == "seated" else 0, motion)

    def test_mass_forward_and_back_is_that_of_the_curves(self):
        found = self.json_of("--csv", "gas.csv", "--set", "gas_path.ring_motion=axial")
        with open(self.folder / "gas.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        largest = max(path["mass_forward_per_cycle"] for path in found["paths"])
        text = self.run_well("gas", "pack.toml", "--set", "gas_path.ring_motion=axial")
        for path in found["paths"]:
            forward, back = path["mass_forward_per_cycle"], path["mass_back_per_cycle"]
            self.assertGreaterEqual(min(forward, back), 0)
            self.assertAlmostEqual((forward - back - path["mass_per_cycle"]) / largest, 0, delta=1e-12)
            flow = [float(row[f"flow_{path['name'].replace(' ', '_')} [kg/s]"]) * 0.08 / 720 for row in rows]
            # Sums over degrees, of flows that jump where a ring leaves or reaches a flank.
            self.assertAlmostEqual(sum(m for m in flow if m > 0) / largest, forward / largest, delta=0.02)
            self.assertAlmostEqual(-sum(m for m in flow if m < 0) / largest, back / largest, delta=0.02)
            shown = re.search(rf"^{path['name']} +(\S+) +(\S+) +(\S+)$", text, re.MULTILINE)
            self.assertAlmostEqual(float(shown[1]) * 1e-6 / largest, forward / largest, delta=1e-3)
            self.assertAlmostEqual(float(shown[2]) * 1e-6 / largest, back / largest, delta=1e-3)
        back = {path["name"]: path["mass_back_per_cycle"] for path in found["paths"]}
        self.assertGreater(back["end gap 1"], 1e-8)
        self.assertIn("per cylinder", text)

    def test_a_volume_that_fills_at_once_is_solved(self):
        self.write(HEAD + TOP + SECOND.replace('"300 mm3"', '"0.004 mm3"') + OIL)
        hot = ("--set", "ring.2.temperature_below=956 K", "--set", "ring.2.end_gap=7 mm")
        found = self.json_of(*hot, "--set", "ring.3.gap_area=0.00176 mm2")
        self.assertTrue(found["periodic"])
        self.assertLess(found["mass_defect"], 1e-12)

    def test_pack_without_oil_ring_is_noted(self):
        self.write(HEAD + TOP + SECOND.replace('volume_below = "300 mm3"\n', ""))
        self.assertIn("oil-ring-missing", [note["topic"] for note in self.json_of("-o", "gas.nc")["notes"]])
        self.assertTrue(b"note_topic" in (self.folder / "gas.nc").read_bytes())

    def test_bad_input_is_refused_with_its_line(self):
        whole = HEAD + TOP + SECOND + OIL
        for old, new, words in (
            ('groove_volume = "300 mm3"', 'groove_volume = "-1 mm3"', "is out of range"),
            ('gap_area = "0.08 mm2"', 'gap_area = "-0.08 mm2"', "is out of range"),
            ('chamber_temperature = "600 K"', 'chamber_temperature = "-5 K"', "is out of range"),
            ('end_gap = "0.4 mm"', 'end_gap = "400 mm"', "is wider than the circumference of the bore"),
            ('gap_area = "0.08 mm2"', 'gap_area = "80 mm2"', "a gap wider than the circumference"),
            ('land_clearance = "0.2 mm"', 'land_clearance = "4 mm"', "the ring has no flank in its groove"),
            (TOP, OIL + TOP, "rings out of order: ring 1 is an oil ring"),
            (OIL, "", "is a volume below the last ring"),
        ):
            self.write(whole.replace(old, new, 1))
            done = self.run_program("gas", "pack.toml")
            self.assert_refused(done, words)
            self.assertRegex(done.stderr, r"pack\.toml:\d+:\d+: ", words)

    def test_a_mistyped_model_is_the_only_error(self):
        done = self.run_program("gas", "pack.toml", "--set", "gas_path.model=orifice")
        self.assert_refused(done, 'choose one of "given", "orifice-volume"')
        self.assertIn("1 error", done.stderr)
        self.write((HEAD + TOP + SECOND + OIL).replace("orifice-volume", "orifice"))
        self.assertIn("1 error", self.run_program("gas", "pack.toml").stderr)

    def test_missing_keys_are_named_with_their_ring(self):
        self.write(HEAD + TOP.replace('side_clearance = "50 um"\n', "") + OIL)
        done = self.run_program("gas", "pack.toml")
        self.assert_refused(done, "ring 1: the key ring.side_clearance is missing")
        self.write(HEAD.replace('model = "orifice-volume"\n', "") + OIL)
        self.assert_refused(self.run_program("gas", "pack.toml"), "there is no gas to compute")

    def test_the_run_of_a_pack_takes_the_computed_pressures(self):
        common = program.CASE.replace("[ring]", "[lost]").split("[lost]")[0]
        film = "[contact]" + program.CASE.split("[contact]")[1]
        path = HEAD[HEAD.index("[gas_path]") :]
        face = '[ring.face]\nform = "parabola"\ncrown_height = "15 um"\n'
        second = SECOND.replace('volume_below = "300 mm3"\n', 'volume_below = "0.3 cm3"\n')
        self.write(common + path + film + TOP + face + second + face + FACE)
        pack = json.loads(self.run_well("run", "pack.toml", "--json", "-o", "pack.nc"))
        gas = json.loads(self.run_well("gas", "pack.toml", "--json"))
        rings = pack["rings"]
        self.assertEqual(len(rings), 3)
        self.assertIn("blow-by", " ".join(note["message"] for note in rings[0]["notes"]))
        # Each value of the gas in the same unit as of the gas alone; the page has the same.
        self.assertEqual(pack["gas"], {key: value for key, value in gas.items() if key in pack["gas"]})
        self.assertEqual(set(gas) - set(pack["gas"]), {"title", "notes", "assumed", "program", "commit", "compiler"})
        self.run_well("report", "pack.nc", "-o", "pack.html")
        page = (self.folder / "pack.html").read_text()
        for name in ("largest_static_twist", "unseated_share", "mass_back_per_cycle", "relaxation_sweeps"):
            self.assertIn(f'"{name}":', page)
        self.assertIn("blow-by per cylinder", self.run_well("run", "pack.toml"))
        self.assertIn("end gap 1", self.run_well("run", "pack.toml", "--all"))
        topics = self.run_well("check", "pack.toml", "--all")
        self.assertIn("gas-path: the gas between the rings", topics.replace("\n  ", " "))
        # The first ring carries what the gas in its groove presses, which is nearly that of the chamber.
        single = common + "[ring]\n" + program.CASE.split("[ring]\n")[1]
        (self.folder / "single.toml").write_text(single)
        alone = json.loads(self.run_well("run", "single.toml", "--json"))
        self.assertAlmostEqual(rings[0]["min_film_thickness"] / alone["min_film_thickness"], 1, delta=0.05)
        self.assertNotEqual(rings[0]["fmep"], alone["fmep"])


RAILS = """\
[[ring]]
kind = "oil"
gap_area = "0.3 mm2"
rails = 2
face_width = "0.4 mm"
rail_distance = "1.2 mm"
expander_force = "25 N"
[ring.face]
form = "parabola"
crown_height = "2 um"
"""


class ShippedPackTest(program.ProgramTest):
    def run_pack(self, *words):
        case = str(program.SOURCES / "cases" / "ring-pack" / "three_rings.toml")
        return json.loads(self.run_well("run", case, "--json", "--set", "solver.cells=60", *words))

    def test_gas_that_passes_the_films_adds_to_the_blow_by(self):
        sealed = self.run_pack()
        self.assertLess(sealed["gas"]["mass_defect"], 1e-12)
        self.assertGreater(sealed["oil"]["liner_film_after_power_stroke"], 1e-7)
        self.assertGreater(sealed["oil"]["oil_to_chamber_upper_bound"], sealed["oil"]["oil_left_at_tdc"])
        for ring in sealed["rings"]:
            for name in ("oil_replenished", "oil_scraped_up", "oil_scraped_down"):
                self.assertTrue(ring[name] == 0 or abs(ring[name]) > 1e-15, f"{name} {ring[name]}")  # no rounding
        passed = self.run_pack("--set", "gas_path.film=breakthrough")
        self.assertLess(passed["gas"]["mass_defect"], 1e-12)
        notes = " ".join(note["message"] for note in passed["rings"][0]["notes"])
        self.assertIn("gas passes the films where they do not hold it", notes)
        self.assertNotIn("still changes", notes)
        more = passed["gas"]["blow_by_per_cycle"] / sealed["gas"]["blow_by_per_cycle"]
        self.assertGreater(more, 1.0005)
        self.assertLess(more, 1.2)


GROOVE_OF_BENT = """\
kind = "compression"
land_clearance = "0.3 mm"
groove_volume = "500 mm3"
groove_temperature = "450 K"
side_clearance = "40 um"
volume_below = "1000 mm3"
temperature_below = "420 K"
"""


class BentRingTest(program.ProgramTest):
    """The ring of cases/distorted-bore as the first of a pack, above an oil ring that does not bend."""

    def setUp(self):
        super().setUp()
        folder = program.SOURCES / "cases" / "distorted-bore"
        text = (folder / "common.toml").read_text(encoding="utf-8").replace('"../', f'"{folder.parent}/')
        text = text.replace('"../', f'"{folder.parent.parent}/').replace("pressure_behind_ring = 1.0\n", "")
        text = text.replace('model = "given"', 'model = "orifice-volume"\nchamber_temperature = "600 K"')
        text = text.replace("[ring]\n", "[[ring]]\n" + GROOVE_OF_BENT)
        text = text.replace("[ring.face]", 'gap_position = "0 degree"\n[ring.face]')
        text = text.split("[output]")[0] + '[output]\ncrank_angles = "2 degree"\n'
        for one, other in (("cells = 100", "cells = 40"), ("cells_y = 180", "cells_y = 60"), ('"1 deg', '"2 deg')):
            text = text.replace(one, other)
        # The face of the first ring belongs to the last [[ring]] before it.
        self.oil = RAILS.replace('"0.3 mm2"', '"0.3 mm2"\nend_gap = "0.35 mm"')
        head, rest = text.split("[liner]")
        self.text = head + self.oil + '[liner]\ndistortion = [{ order = 4, amplitude = "8 um" }]' + rest

    def blow_by(self, text):
        (self.folder / "bent.toml").write_text('title = "bent"\n' + text, encoding="utf-8")
        pack = json.loads(self.run_well("run", "bent.toml", "--json"))
        self.assertLess(pack["gas"]["mass_defect"], 1e-12)
        return pack["gas"]["blow_by_per_cycle"], " ".join(note["message"] for note in pack["rings"][0]["notes"])

    def over_face(self, notes):
        self.assertNotIn("still changes", notes)
        return float(re.search(r"do not hold it: (\S+) mg per cycle over the face of the first ring", notes)[1])

    def test_gas_passes_where_a_ring_that_bends_is_lifted_off(self):
        sealed, _ = self.blow_by(self.text)
        opened = self.text.replace("[gas_path]\n", '[gas_path]\nfilm = "breakthrough"\n')
        passed, notes = self.blow_by(opened)
        round_bore, of_round = self.blow_by(opened.replace("8 um", "0 um"))
        # High pressure holds the ring on the bore. Where it falls, the piston land below has more than the chamber: gas
        # goes back, and does not reach the crankcase.
        self.assertLess(self.over_face(notes), -0.03)
        self.assertLess(passed, 0.995 * sealed)
        self.assertAlmostEqual(self.over_face(of_round), 0, delta=1e-3)
        self.assertAlmostEqual(round_bore / sealed, 1, delta=1e-4)

    def test_without_a_piston_land_below_the_gas_goes_to_the_crankcase(self):
        alone = self.text.replace(self.oil, "")
        for line in GROOVE_OF_BENT.splitlines()[-2:]:
            alone = alone.replace(line + "\n", "")
        sealed, _ = self.blow_by(alone)
        passed, notes = self.blow_by(alone.replace("[gas_path]\n", '[gas_path]\nfilm = "breakthrough"\n'))
        over_face = 1e-6 * self.over_face(notes)
        self.assertGreater(over_face, 5e-10)
        self.assertAlmostEqual((passed - sealed) / over_face, 1, delta=0.05)


class OilRingTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        common = program.CASE.replace("[ring]", "[lost]").split("[lost]")[0]
        film = "[contact]" + program.CASE.split("[contact]")[1]
        face = '[ring.face]\nform = "parabola"\ncrown_height = "15 um"\n'
        # No piston land between the compression rings: both are pressed on their lower flanks at all times.
        self.rings = [TOP + face, SECOND + face]
        self.head = common + HEAD[HEAD.index("[gas_path]") :] + film
        self.write(RAILS)

    def write(self, oil_ring):
        (self.folder / "pack.toml").write_text(self.head + "".join(self.rings) + oil_ring)

    def run_json(self, *words):
        return json.loads(self.run_well("run", "pack.toml", "--json", *words))

    def test_each_rail_has_a_film_and_the_ring_their_sum(self):
        pack = self.run_json("-o", "pack.nc", "--csv", "pack.csv")
        self.assertEqual([(ring["ring"], ring.get("rail")) for ring in pack["rings"]], RAIL_NUMBERS)
        self.assertEqual(pack["rings"][2]["title"].split(": ")[-1], "ring 3 (oil ring, upper rail)")
        by_ring = {one["ring"]: one["fmep"] for one in pack["by_ring"]}
        self.assertAlmostEqual(by_ring[3], pack["rings"][2]["fmep"] + pack["rings"][3]["fmep"], places=9)
        self.assertAlmostEqual(sum(by_ring.values()), pack["all_rings"]["fmep"], places=9)
        pressure = 2 * 25 / (0.089 * 2 * 0.4e-3)
        for rail in pack["rings"][2:]:
            self.assertAlmostEqual(rail["elastic_pressure"] / pressure, 1, places=12)
        gas = json.loads(self.run_well("gas", "pack.toml", "--json"))
        self.assertEqual(pack["gas"]["blow_by_per_cycle"], gas["blow_by_per_cycle"])
        self.assertEqual([region["name"] for region in pack["gas"]["regions"]], [r["name"] for r in gas["regions"]])
        self.run_well("report", "pack.nc", "-o", "pack.html")
        page = (self.folder / "pack.html").read_text()
        self.assertIn('"blow_by_per_cycle":', page)
        with open(self.folder / "pack.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        at_tdc = {
            row["ring"]: float(row["total_friction [N]"]) for row in rows if float(row["crank_angle [degree]"]) == 20
        }
        self.assertEqual(list(at_tdc), ["1", "2", "3.1", "3.2", "all"])
        self.assertAlmostEqual(at_tdc.pop("all"), sum(at_tdc.values()), places=9)

    def test_rails_are_those_of_two_narrow_rings(self):
        rail = RAILS.replace("rails = 2\n", "").replace('rail_distance = "1.2 mm"\n', "").replace("25 N", "12.5 N")
        together = self.run_json()
        self.write(rail + rail)
        apart = self.run_json()
        for one, other in zip(together["rings"], apart["rings"], strict=True):
            self.assertEqual(one["fmep"], other["fmep"])

    def test_keys_of_rails_are_checked(self):
        for old, new, words in (
            ("rails = 2", "rails = 0", "is out of range"),
            ('kind = "oil"', 'kind = "compression"', "ring.rails is not used in this case"),
            ('expander_force = "25 N"', "", "the tension of the ring is missing"),
        ):
            self.write(RAILS.replace(old, new))
            self.assert_refused(self.run_program("run", "pack.toml"), words)
        single = program.CASE.replace("[ring]\n", '[ring]\nkind = "oil"\nrails = 2\n')
        (self.folder / "single.toml").write_text(single)
        self.assert_refused(self.run_program("run", "single.toml"), "write the ring as [[ring]]")


if __name__ == "__main__":
    unittest.main()
