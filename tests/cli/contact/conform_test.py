"""`ringfilm conform`: a ring in bores whose closure is known, and what is refused."""

import csv
import json
import math
import unittest

import program

CASE = """title = "Ring in its bore"
[engine]
bore = "89 mm"
[ring]
face_width = "1.2 mm"
radial_thickness = "3.5 mm"
youngs_modulus = "203 GPa"
tangential_force = "10.68 N"
end_gap = "0.35 mm"
[liner]
distortion = [{ order = 4, amplitude = "1 um", phase = "45 degree" }]
"""


class ConformTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "case.toml").write_text(CASE, encoding="utf-8")

    def closure(self, *options, case="case.toml"):
        return json.loads(self.run_well("conform", case, "--json", *options))

    def refused(self, words, *options):
        self.assert_refused(self.run_program("conform", "case.toml", *options), words)

    def test_lifted_tips_end_where_the_closed_form_has_them(self):
        found = self.closure("--set", "ring.end_gap=")
        first, last = found["contact_arcs"][0]
        self.assertEqual(len(found["contact_arcs"]), 1)
        self.assertAlmostEqual(first, 9.102177, places=6)  # verification/thin_ring_closure/reference.py
        self.assertAlmostEqual(last, 360 - first, places=6)
        self.assertAlmostEqual(found["contact_angle"], last - first, places=9)
        self.assertAlmostEqual(found["tangential_force"], 10.68, places=9)
        self.assertLess(found["unbalanced_share"], 1e-12)

    def test_a_pack_is_closed_by_its_first_ring_alone(self):
        alone = self.closure()
        second = '[[ring]]\nface_width = "1.5 mm"\n'
        (self.folder / "pack.toml").write_text(CASE.replace("[ring]", "[[ring]]") + second, encoding="utf-8")
        self.assertEqual(self.closure(case="pack.toml")["contact_arcs"], alone["contact_arcs"])

    def test_the_table_around_sums_up_to_the_values(self):
        found = self.closure("--csv", "around.csv")
        with open(self.folder / "around.csv", encoding="utf-8") as file:
            rows = [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]
        self.assertEqual(len(rows), 361)  # 1 to 359 degree, and both ends
        self.assertAlmostEqual(rows[-1][4], 2 * math.pi * found["mean_wall_force"], places=9)
        self.assertAlmostEqual(max(row[2] for row in rows), found["max_clearance"], delta=1e-9)
        self.assertAlmostEqual(rows[180][5], found["moment_at_back"], places=9)

    def test_the_gap_position_counts_against_the_phase(self):
        turned = self.closure(
            "--set",
            "ring.gap_position='30 degree'",
            "--set",
            "liner.distortion=[{ order = 4, amplitude = '1 um', phase = '75 degree' }]",
        )
        self.assertAlmostEqual(turned["open_area"], self.closure()["open_area"], delta=1e-18)

    def test_cold_and_hot_parts_add_up(self):
        half = "[{ order = 4, amplitude = '0.5 um', phase = '45 degree' }]"
        parts = self.closure("--set", f"liner.distortion={half}", "--set", f"liner.thermal_distortion={half}")
        self.assertAlmostEqual(parts["open_area"], self.closure()["open_area"], delta=1e-18)

    def test_a_map_is_the_bore_that_its_orders_are(self):
        rows = ["height [mm],angle [degree],deviation [um]"]
        for height, share in ((10, 0.5), (30, 1.5)):
            for angle in range(0, 360, 5):
                rows.append(f"{height},{angle},{share * math.cos(math.radians(4 * (angle - 45))):.12f}")
        (self.folder / "bore.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
        (self.folder / "map.toml").write_text(
            CASE.split("distortion =")[0] + 'distortion_map = "bore.csv"\n[conform]\nheight = "20 mm"\n',
            encoding="utf-8",
        )
        of_map = self.closure(case="map.toml")
        self.assertAlmostEqual(of_map["open_area"] / self.closure()["open_area"], 1, places=6)
        # A common slip: the radius in place of its deviation.
        of_radius = ["height [mm],angle [degree],deviation [mm]"] + [
            ",".join([*row.split(",")[:2], "44.4"]) for row in rows[1:]
        ]
        (self.folder / "bore.csv").write_text("\n".join(of_radius) + "\n", encoding="utf-8")
        self.refused(
            "not the radius itself", "--set", "liner.distortion_map=bore.csv", "--set", "conform.height='20 mm'"
        )
        missing = [row for row in rows if not row.startswith("30,100")]
        (self.folder / "bore.csv").write_text("\n".join(missing) + "\n", encoding="utf-8")
        self.refused("has holes", "--set", "liner.distortion_map=bore.csv", "--set", "conform.height='20 mm'")

    def test_a_whole_case_and_its_closure_alone_are_the_same(self):
        shipped = program.SOURCES / "cases/distorted-bore/followed.toml"
        found = self.closure(case=str(shipped))
        self.assertAlmostEqual(found["max_clearance"] * 1e6, 1.568, delta=0.001)
        opposite = self.closure("--set", "ring.gap_position='180 degree'", case=str(shipped))
        self.assertAlmostEqual(opposite["max_clearance"] * 1e6, 0.112, delta=0.001)

    def test_what_is_impossible_is_refused(self):
        for setting, words in (
            ("liner.distortion=[{ order = 2, amplitude = '60 mm' }]", "leave no bore"),
            ("liner.distortion=[{ order = 2, amplitude = 15 }]", "has no unit"),
            ("liner.distortion=[{ order = 2, amplitude = '15 um', height = '1 mm' }]", "conform.height is missing"),
            ("ring.end_gap='300 mm'", "circumference"),
            ("ring.radial_thickness='-1 mm'", "out of range"),
            ("ring.radial_thickness=", "ring.radial_thickness is missing"),
            ("ring.pressure_orders=[{ order = 1, amplitude = 0.1 }]", "is not an order"),
            ("conform.gas_pressure='-1 bar'", "out of range"),
        ):
            self.refused(words, "--set", setting)

    def test_a_cycle_states_that_its_bore_is_round(self):
        shipped = program.SOURCES / "cases/distorted-bore/followed.toml"
        checked = json.loads(self.run_well("check", str(shipped), "--set", "ring.conformity=rigid", "--json"))
        self.assertIn("bore-taken-as-round", json.dumps(checked["notes"]))
        bends = json.loads(self.run_well("check", str(shipped), "--json"))
        self.assertNotIn("bore-taken-as-round", json.dumps(bends["notes"]))

    def test_the_shipped_rings_bend_over_the_whole_cycle(self):
        coarse = ("--set", "solver.cells=50", "--set", "solver.cells_y=60", "--set", "solver.crank_step=4 degree")
        coarse += ("--set", "output.crank_angles=4 degree")
        clearance = {}
        for name in ("followed", "not-followed"):
            shipped = str(program.SOURCES / f"cases/distorted-bore/{name}.toml")
            found = json.loads(self.run_well("run", shipped, *coarse, "--json"))
            clearance[name] = found["peak_clearance"]
            self.assertLess(found["effort"]["max_load_residual"], 1e-6)
            self.assertGreater(found["mean_open_area"], 0)
        self.assertGreater(clearance["not-followed"], clearance["followed"])
        printed = " ".join(self.run_well("run", shipped, *coarse).split())
        self.assertIn("the ring bends: largest clearance", printed)

    def test_a_ring_that_bends_needs_its_thickness_and_the_whole_stroke(self):
        shipped = str(program.SOURCES / "cases/distorted-bore/followed.toml")
        for setting, words in (
            ("ring.radial_thickness=", "ring.radial_thickness is missing"),
            ("ring.conformity=soft", "ring.conformity"),
            (
                "liner.distortion=[{ order = 2, amplitude = '9 um', height = '0 mm' }, "
                "{ order = 2, amplitude = '5 um', height = '50 mm' }]",
                "the ring passes 0 to 79.5 mm",
            ),
        ):
            self.assert_refused(self.run_program("check", shipped, "--set", setting), words)


if __name__ == "__main__":
    unittest.main()
