"""The film on the unrolled ring: from the case to what is printed and written."""

import csv
import json
import unittest

import program

SMALL = ("--set", "solver.cells=40", "--set", "solver.crank_step=4 degree", "--set", "output.crank_angles=4 degree")
UNROLLED = (*SMALL, "--set", "film.dimension=unrolled", "--set", "solver.cells_y=32")
GAP = ("--set", "ring.end_gap=0.3 mm")


class Unrolled(program.ProgramTest):
    def values(self, *words):
        return json.loads(self.run_well("run", "case.toml", "--json", *words))

    def test_a_closed_ring_is_the_film_across_the_face(self):
        face, ring = self.values(*SMALL), self.values(*UNROLLED)
        for name, value in face.items():
            if isinstance(value, float) and face["units"].get(name) not in (None, "degree"):
                # solver.tolerance is 1e-8, of each of some hundred steps; a net flow is what is left of to and fro
                scale = max(abs(value), face["mean_absolute_oil_flow"] if name == "net_oil_flow" else 0)
                self.assertAlmostEqual(ring[name], value, delta=1e-6 * scale, msg=name)
        self.assertEqual(ring["mean_gap_leakage"], 0)
        self.assertNotIn("mean_gap_leakage", face)

    def test_a_gap_leaks_in_the_table_the_json_and_the_csv(self):
        values = self.values(*UNROLLED, *GAP, "--csv", "curves.csv")
        self.assertGreater(values["mean_absolute_gap_leakage"], 0)
        self.assertEqual(values["units"]["mean_gap_leakage"], "kg/s")
        self.assertEqual(values["units"]["ends_share_friction_power"], "1")
        with open(self.folder / "curves.csv", newline="") as stream:
            rows = list(csv.DictReader(stream))
        leakage = [float(row["gap_leakage [kg/s]"]) for row in rows]
        self.assertAlmostEqual(
            sum(leakage) / len(leakage), values["mean_gap_leakage"], delta=1e-9 * values["mean_absolute_gap_leakage"]
        )
        self.assertAlmostEqual(
            float(rows[0]["applied_load [N]"]),
            (0.2e6 + float(rows[0]["gas_pressure [Pa]"])) * 1.2e-3 * (3.141592653589793 * 0.089 - 0.3e-3),
            places=6,
        )
        printed = " ".join(self.run_well("run", "case.toml", "--all", *UNROLLED, *GAP).split())
        for fragment in (
            "film on the unrolled ring: 40 x 32 cells",
            "gap of 0.3 mm",
            "oil into the gap",
            "share of the ends in load",
            "note: the cells at the ends of the gap",
        ):
            self.assertIn(fragment, printed)

    def test_the_result_holds_the_fields_in_full_or_by_strips(self):
        try:
            import netCDF4
        except ImportError:
            program.skip_loudly(self, "python3-netcdf4 is not installed")
        fields = ("--set", 'output.fields=["0 degree", "20 degree"]')
        self.run_well("run", "case.toml", *UNROLLED, *GAP, *fields, "--output", "full.nc")
        with netCDF4.Dataset(self.folder / "full.nc") as file:
            pressure = file["unrolled_film_pressure"]
            self.assertEqual(pressure.dimensions, ("field_crank_angle", "y", "x"))
            self.assertEqual(pressure.shape, (2, 33, 41))
            self.assertAlmostEqual(
                float(pressure[1, 0, 20] / ((file["gas_pressure"][5] + file["crankcase_pressure"][5]) / 2)), 1, places=6
            )
            self.assertEqual(file["strip_asperity_load"].dimensions, ("field_crank_angle", "y"))
            self.assertGreater(float(file["cycle_mean_absolute_gap_leakage"][...]), 0)
            (self.folder / "again.toml").write_text(str(file["resolved_case"][...]))
        self.run_well("run", "again.toml", "--output", "again.nc")
        with netCDF4.Dataset(self.folder / "full.nc") as a, netCDF4.Dataset(self.folder / "again.nc") as b:
            self.assertEqual(a["gap_leakage"][:].tolist(), b["gap_leakage"][:].tolist())
        self.run_well(
            "run",
            "case.toml",
            *UNROLLED,
            *GAP,
            *fields,
            "--set",
            "output.reduction=along-face",
            "--output",
            "strips.nc",
        )
        with netCDF4.Dataset(self.folder / "strips.nc") as file:
            self.assertEqual(file["strip_peak_film_pressure"].dimensions, ("field_crank_angle", "y"))
            self.assertNotIn("unrolled_film_pressure", file.variables)

    def test_errors_and_ledger_are_those_of_the_whole_ring(self):
        values = self.values(*UNROLLED, *GAP, "--error-estimate")
        self.assertEqual([run["cells_y"] for run in values["error_estimate"]["runs"]], [32, 64, 16, 32, 32])
        self.assertGreater(values["errors"]["fmep"], 0)

    def test_a_ring_that_bends_on_smooth_surfaces_flattens(self):
        # Between rigid ones a film of 0.2 nm would carry 1.3 GPa: at 0.2 um no film was found (exit code 3).
        shipped = str(program.SOURCES / "cases" / "distorted-bore" / "followed.toml")
        coarse = ("--set", "solver.cells=40", "--set", "solver.cells_y=90")
        found = {}
        for roughness in ("0.48 um", "0.2 um"):
            words = ("--set", f"contact.roughness={roughness}", *coarse)
            found[roughness] = json.loads(self.run_well("run", shipped, "--json", *words))
        noted = [[note["topic"] for note in of["notes"]].count("surfaces-flattened") for of in found.values()]
        self.assertEqual(noted, [0, 1])
        smooth = found["0.2 um"]
        self.assertGreater(smooth["min_film_thickness"], 0.1 * 0.2e-6)  # what the valleys hold
        self.assertLess(smooth["fmep"], found["0.48 um"]["fmep"])
        self.assertLess(smooth["effort"]["max_load_residual"], 0.01)

    def test_bad_input_is_refused(self):
        cases = {
            "the circumference of the bore": ("film.dimension=unrolled", "ring.end_gap=280 mm"),
            "then the ring is closed": ("film.dimension=unrolled", "ring.end_gap=0 mm"),
            'ring.end_gap = "-0.3 mm" is out of range': ("film.dimension=unrolled", "ring.end_gap=-0.3 mm"),
            'film.dimension = "unrolled"': ("ring.end_gap=0.3 mm",),
            "ring.gap_position": ("film.dimension=unrolled", "ring.gap_position=10 degree"),
            "coupled-newton": ("film.dimension=unrolled", "solver.method=point-relaxation"),
            "solver.cells_y": ("film.dimension=unrolled", "solver.cells_y=3"),
            "take 57 or more": ("film.dimension=unrolled", "ring.end_gap=0.3 mm", "solver.cells_y=20"),
            "solver.end_cell": ("film.dimension=unrolled", "ring.end_gap=0.3 mm", "solver.end_cell=2 mm"),
            "MB": ("film.dimension=unrolled", "output.fields=all", "solver.cells=200"),
            "output.reduction": ("output.fields=all", "output.reduction=along-face"),
        }
        for fragment, settings in cases.items():
            with self.subTest(fragment):
                before = self.names()
                words = [word for setting in settings for word in ("--set", setting)]
                self.assert_refused(self.run_program("run", "case.toml", "--output", "out.nc", *words), fragment)
                self.assertEqual(self.names(), before)


if __name__ == "__main__":
    unittest.main(verbosity=2)
