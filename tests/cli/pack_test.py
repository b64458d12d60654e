"""Ring packs: a case with [[ring]] sections, and its results in every format."""

import csv
import json
import unittest

import program

HEAD = """
title = "pack"
[engine]
bore = "89 mm"
stroke = "79.5 mm"
connecting_rod_length = "138.1 mm"
[operating]
speed = "1500 rpm"
oil_temperature = "120 degC"
[gas]
model = "wiebe"
[contact]
asperity_density = "0.097 um-2"
asperity_radius = "1.56 um"
roughness = "0.48 um"
boundary_shear_strength_coefficient = 0.3581
[lubricant]
file = "data/lubricants/styles2014.toml"
[solver]
cells = 40
crank_step = "4 degree"
[output]
crank_angles = "4 degree"
fields = ["20 degree"]
"""
TOP = """
name = "top"
face_width = "1.2 mm"
elastic_pressure = "0.2 MPa"
face = { form = "parabola", crown_height = "15 um" }
pressure_below = "2.5 bar"
"""
SECOND = """
name = "second"
face_width = "1.5 mm"
tangential_force = "9 N"
face = { form = "parabola", crown_height = "10 um", apex = 0.6 }
"""
SECOND_CONTACT = 'contact = { roughness = "0.6 um" }\n'


STUDY = """
title = "speeds"
[[base]]
case = "pack.toml"
[plan]
method = "grid"
[[factor]]
key = "operating.speed"
values = ["1000 rpm", "2000 rpm"]
"""


class Pack(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("pack.toml", HEAD + "[[ring]]" + TOP + "[[ring]]" + SECOND + SECOND_CONTACT)
        self.write("top.toml", HEAD + "[ring]" + TOP)
        second = HEAD.replace('roughness = "0.48 um"', 'roughness = "0.6 um"')
        self.write("second.toml", second + "[ring]" + SECOND + 'pressure_above = "2.5 bar"\n')

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def refused(self, *words):
        done = self.run_program(*words)
        self.assert_refused(done)
        return done.stderr

    def rows(self, name):
        self.run_well("run", name, "--csv", "curves.csv")
        with open(self.folder / "curves.csv", newline="") as stream:
            return list(csv.reader(stream))

    def test_each_ring_has_the_bits_of_its_own_case(self):
        pack = self.rows("pack.toml")
        self.assertEqual(pack[0][0], "ring")
        singles = [self.rows("top.toml"), self.rows("second.toml")]
        self.assertEqual(pack[0][1:], singles[0][0])
        for ring, single in enumerate(singles, start=1):
            self.assertEqual([row[1:] for row in pack[1:] if row[0] == str(ring)], single[1:])

    def test_json_has_each_ring_and_the_sum(self):
        pack = json.loads(self.run_well("run", "pack.toml", "--json"))
        singles = [json.loads(self.run_well("run", name, "--json")) for name in ("top.toml", "second.toml")]
        for ring, single in zip(pack["rings"], singles, strict=True):
            self.assertEqual(ring["fmep"], single["fmep"])
            self.assertEqual(ring["effort"], single["effort"])
        self.assertEqual([ring["ring"] for ring in pack["rings"]], [1, 2])
        self.assertEqual(pack["rings"][1]["title"], "pack: ring 2 (second)")
        self.assertAlmostEqual(pack["all_rings"]["fmep"], sum(single["fmep"] for single in singles), places=9)

    def test_summary_shows_each_ring_and_the_sum(self):
        printed = self.run_well("run", "pack.toml")
        for fragment in ("pack: ring 1 (top)", "pack: ring 2 (second)", "all 2 rings:"):
            self.assertIn(fragment, printed)

    def test_report_of_the_file_shows_each_ring(self):
        self.run_well("run", "pack.toml", "--output", "pack.nc")
        self.run_well("report", "pack.nc", "--output", "pack.html")
        page = (self.folder / "pack.html").read_text()
        self.assertIn("pack: ring 1 (top)", page)
        self.assertIn("pack: ring 2 (second)", page)

    def test_keys_of_one_ring_are_set_on_the_command_line(self):
        before = json.loads(self.run_well("run", "pack.toml", "--json"))
        after = json.loads(self.run_well("run", "pack.toml", "--json", "--set", "ring.2.tangential_force=18 N"))
        self.assertEqual(before["rings"][0]["fmep"], after["rings"][0]["fmep"])
        self.assertGreater(after["rings"][1]["fmep"], 1.5 * before["rings"][1]["fmep"])

    def test_a_missing_land_pressure_and_one_that_is_stated_twice_are_refused(self):
        refused = self.refused("run", "pack.toml", "--set", "ring.1.pressure_below=")
        self.assertIn("ring.1.pressure_below is missing", refused)
        refused = self.refused("run", "pack.toml", "--set", "ring.2.pressure_above=3 bar")
        self.assertIn("ring.2.pressure_above is the pressure below ring 1", refused)

    def test_unknown_keys_rings_and_mixtures_are_refused(self):
        self.assertIn(
            "did you mean ring.2.face_width?", self.refused("run", "pack.toml", "--set", "ring.2.face_widht=1 mm")
        )
        self.assertIn("there are 3 rings", self.refused("run", "pack.toml", "--set", "ring.4.face_width=1 mm"))
        self.assertIn(
            "belongs to no ring of the pack", self.refused("run", "pack.toml", "--set", "ring.face_width=1 mm")
        )

    def test_missing_keys_name_their_ring(self):
        refused = self.refused("run", "pack.toml", "--set", "ring.2.face_width=")
        self.assertIn("ring 2: the key ring.face_width is missing", refused)

    def test_a_study_takes_one_ring(self):
        self.write("study.toml", STUDY)
        self.assertIn("one ring", self.refused("study", "study.toml"))


if __name__ == "__main__":
    unittest.main()
