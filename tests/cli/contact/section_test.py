"""The section of a ring in `ringfilm conform` and `ringfilm gas`, and what is refused."""

import json
import unittest

import program

CASE = """title = "Ring with a section"
[engine]
bore = "89 mm"
[ring]
face_width = "1.2 mm"
youngs_modulus = "203 GPa"
tangential_force = "10.7 N"
section = [
  ["0 mm", "0 mm"],
  ["1.2 mm", "0 mm"],
  ["1.2 mm", "3.5 mm"],
  ["0.6 mm", "3.5 mm"],
  ["0 mm", "2.9 mm"],
]
[liner]
distortion = [{ order = 4, amplitude = "1 um", phase = "45 degree" }]
"""


class SectionTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "case.toml").write_text(CASE, encoding="utf-8")

    def section(self, *options):
        return json.loads(self.run_well("conform", "case.toml", "--json", *options))["section"]

    def refused(self, words, *options):
        self.assert_refused(self.run_program("conform", "case.toml", *options), words)

    def test_values_are_those_of_the_closed_forms(self):
        found = self.section()  # verification/ring_sections/reference.py
        self.assertAlmostEqual(1e6 * found["area"], 4.02, places=9)
        for got, expected in zip(found["centroid"], (0.6179104478e-3, 1.680597015e-3)):
            self.assertAlmostEqual(got / expected, 1, places=8)
        for got, expected in zip(found["second_moments"], (4.703104478e-13, 3.832086567e-12, 1.147970149e-13)):
            self.assertAlmostEqual(got / expected, 1, places=8)
        low, high = found["torsion_bounds"]
        self.assertLess(low, found["torsion_constant"])
        self.assertLess(found["torsion_constant"], high)
        self.assertLess(high / low - 1, 2e-5)
        self.assertAlmostEqual(found["assembly_twist"], 0.006201073488, places=10)

    def test_a_form_is_the_polygon_of_its_lengths(self):
        by_corners = self.section()
        by_form = self.section(
            "--set",
            "ring.section=",
            "--set",
            "ring.radial_thickness='3.5 mm'",
            "--set",
            "ring.section_form=inner-bevel",
            "--set",
            "ring.bevel_width='0.6 mm'",
        )
        for name, value in by_corners.items():
            for got, expected in zip([value] if isinstance(value, float) else value, self.listed(by_form[name])):
                self.assertAlmostEqual(got / expected, 1, places=9, msg=name)

    @staticmethod
    def listed(value):
        return [value] if isinstance(value, float) else value

    def test_no_section_no_values(self):
        options = ("--set", "ring.section=", "--set", "ring.radial_thickness='3.5 mm'")
        self.assertNotIn("section", json.loads(self.run_well("conform", "case.toml", "--json", *options)))

    def test_wrong_sections_are_refused_at_their_line(self):
        crossing = CASE.replace(
            '["1.2 mm", "0 mm"],\n  ["1.2 mm", "3.5 mm"]', '["1.2 mm", "3.5 mm"],\n  ["1.2 mm", "0 mm"]'
        )
        (self.folder / "case.toml").write_text(crossing, encoding="utf-8")
        done = self.run_program("conform", "case.toml")
        self.assert_refused(done, "overlaps itself")
        self.assertIn("case.toml:8", done.stderr)

    def test_wrong_units_and_lengths_are_refused(self):
        self.refused("has no unit", "--set", "ring.section=[[0, 0], [1.2, 0], [1.2, 3.5]]")
        self.refused("out of range", "--set", "ring.section=[['0 m', '0 m'], ['1.2 m', '0 m'], ['1.2 m', '3.5 m']]")
        self.refused("no area", "--set", "ring.section=[['0 mm', '0 mm'], ['1.2 mm', '0 mm'], ['0.6 mm', '0 mm']]")
        self.refused("has 2 corners", "--set", "ring.section=[['0 mm', '0 mm'], ['1.2 mm', '0 mm']]")
        self.refused("stated twice", "--set", "ring.section_form=rectangular")
        self.refused("less than its face is wide", "--set", "ring.face_width='2 mm'")


if __name__ == "__main__":
    unittest.main()
