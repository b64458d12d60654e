"""A liner made in two steps: `[contact.plateau]` from a drawing and from a scan, with all commands that use it."""

import json
import math
import unittest

import program

DRAWING = {"Rpq": '"0.1 um"', "Rvq": '"0.9 um"', "Rmq": "0.82", "ring_roughness": '"0.1 um"'}
CORE = {"Rk": '"0.3 um"', "Rpk": '"0.1 um"', "Rvk": '"1.2 um"', "Mr2": "0.8", "ring_roughness": '"0.1 um"'}


def section(values):
    return "\n[contact.plateau]\n" + "".join(f"{key} = {value}\n" for key, value in values.items())


class PlateauTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        text = (self.folder / "case.toml").read_text()
        self.whole = text
        self.bare = "".join(line for line in text.splitlines(True) if not line.startswith("roughness"))

    def write(self, values, text=None):
        (self.folder / "case.toml").write_text((text or self.bare) + section(values))

    def law(self, *words):
        return json.loads(self.run_well("contact", "--case", "case.toml", *words, "--json"))


class FromADrawing(PlateauTest):
    def test_resolved_values_are_in_law_and_result(self):
        self.write(DRAWING)
        law, result = self.law(), json.loads(self.run_well("run", "case.toml", "--json"))
        for of in (law, result):
            self.assertAlmostEqual(of["Rpq"], 0.1e-6, delta=1e-15)
            self.assertAlmostEqual(of["Rmq"], 0.82, delta=1e-12)
            self.assertAlmostEqual(of["plateau_roughness"], math.hypot(0.1e-6, 0.1e-6), delta=1e-15)
            # 0.8 um times the mean of what a normal variable exceeds 0.9154, its value at 82 %.
            self.assertAlmostEqual(of["plateau_offset"], 0.8e-6 * 0.0976343, delta=1e-12)
            self.assertGreater(of["roughness"], 2 * of["plateau_roughness"])
        self.assertIn("Plateau of the liner", self.run_well("contact", "--case", "case.toml"))

    def test_core_values_become_the_two_lines(self):
        self.write(CORE)
        of = self.law()
        self.assertAlmostEqual(of["Rpq"] / (0.4e-6 / 3.51899), 1, delta=1e-4)
        self.assertGreater(of["Rvq"], 5 * of["Rpq"])
        self.assertTrue(0.5 < of["Rmq"] < 0.8)

    def test_the_ledger_compares_it_with_the_whole_gaussian_surface(self):
        self.write(DRAWING)
        printed = self.run_well("run", "case.toml", "--ledger", "--json")
        entry = next(one for one in json.loads(printed)["ledger"] if one["topic"] == "plateau")
        self.assertIn("Rmq 82 %", entry["statement"])
        self.assertIn("without [contact.plateau]", json.dumps(entry))

    def test_bad_values_are_refused_with_their_line_and_the_remedy(self):
        for changes, *printed in (
            ({"Rmq": "0"}, "case.toml:", "leaves no plateau", "between 0 and 1"),
            ({"Rmq": "1"}, "leaves no valleys", "state contact.roughness"),
            ({"Rmq": "82"}, "contact.plateau.Rmq"),
            ({"Rpq": '"2 um"'}, "is not below contact.plateau.Rvq = 0.9 um", "exchanged"),
            ({"surface_roughness": '"0.05 um"'}, "is below the Rpq of its plateau", "omit it"),
            ({"Rpq": "0.1"}, "contact.plateau.Rpq", "um"),
            ({"Rk": '"0.3 um"'}, "states both contact.plateau.Rpq and contact.plateau.Rk"),
        ):
            with self.subTest(changes):
                self.write({**DRAWING, **changes})
                self.assert_refused(self.run_program("check", "case.toml"), *printed)
        self.write({key: value for key, value in DRAWING.items() if key != "ring_roughness"})
        self.assert_refused(self.run_program("check", "case.toml"), "contact.plateau.ring_roughness is missing")
        self.write(DRAWING, self.whole)
        self.assert_refused(self.run_program("check", "case.toml"), "contact.roughness is not used")


class FromAScan(PlateauTest):
    def setUp(self):
        super().setUp()
        size = ("--points", "256x256", "--step", "1 um")
        self.run_well("synthetic", "honed", "liner.x3p", *size, "--seed", "4")
        self.run_well("synthetic", "gaussian", "ring.x3p", *size, "--sq", "0.1 um", "--seed", "1")

    def test_the_fragment_of_a_surface_is_completed_by_the_ring(self):
        of = json.loads(self.run_well("surface", "liner.x3p", "--fragment", "plateau.toml", "--json"))
        text = (self.folder / "plateau.toml").read_text()
        self.assertIn("[contact.plateau]", text)
        self.assertNotIn("\nring_roughness", text)
        self.assertGreater(of["plateau_asperity_density"], 0)
        case = 'include = ["plateau.toml"]\n' + self.bare
        (self.folder / "case.toml").write_text(case + section({"ring_roughness": '"0.1 um"'}))
        law = self.law()
        for key in ("Rpq", "Rvq", "Rmq"):
            self.assertAlmostEqual(law[key] / of[key.replace("R", "S")], 1, delta=1e-6)  # names of a map
        # Rq of the map is stated, too: the whole surface is as rough as it was measured.
        self.assertAlmostEqual(law["roughness"] / math.hypot(0.1e-6, of["Sq"]), 1, delta=1e-6)

    def test_the_fragment_of_a_pair_is_complete(self):
        words = ("--ring", "ring.x3p", "--liner", "liner.x3p", "--plateau", "--fragment", "contact.toml")
        of = json.loads(self.run_well("pair", *words, "--json"))
        bare = "".join(line for line in self.bare.splitlines(True) if not line.startswith("asperity_"))
        (self.folder / "case.toml").write_text('include = ["contact.toml"]\n' + bare)
        law = self.law()
        self.assertAlmostEqual(law["plateau_roughness"] / of["roughness"], 1, delta=1e-6)
        self.assertAlmostEqual(law["plateau_offset"] / of["plateau_offset"], 1, delta=1e-5)

    def test_a_surface_made_in_one_step_is_refused(self):
        words = ("surface", "ring.x3p", "--fragment", "plateau.toml")
        self.assert_refused(self.run_program(*words), "ring.x3p has no plateau", "leave --fragment out")
        self.assertFalse((self.folder / "plateau.toml").exists())
        words = ("pair", "--ring", "liner.x3p", "--liner", "ring.x3p", "--plateau")
        self.assert_refused(self.run_program(*words), "ring.x3p has no plateau", "without --plateau")
        words = ("pair", "--ring", "ring.x3p", "--liner", "liner.x3p", "--plateau", "--sigma", "Ra")
        self.assert_refused(self.run_program(*words), "--sigma Ra and --plateau contradict each other")
        words = ("surface", "ring.x3p", "liner.x3p", "--fragment", "plateau.toml")
        self.assert_refused(self.run_program(*words), "--fragment states the plateau of one file")


if __name__ == "__main__":
    unittest.main(verbosity=2)
