"""A measured input that nobody made for this program: the heavy-duty traces of four loads, over part of the cycle."""

import csv
import json
import unittest

import program

TRACES = program.SOURCES.parent / "shared" / "data" / "pressure_hd_1200rpm_libicepost.csv"

CASE = """\
title = "a heavy-duty engine, load {load} %"
[engine]
bore = "128 mm"
stroke = "144 mm"
connecting_rod_length = "241.5 mm"
[operating]
speed = "1200 rpm"
oil_temperature = "120 degC"
[gas]
model = "trace"
cylinder_pressure = "{traces}"
pressure_column = "p_Pa_load{load}"
angle_column = "CAD_0=firing_TDC"
pressure_unit = "Pa"
angle_unit = "degree"
pressure_reference = "absolute"
angle_zero = "firing-tdc"
intake_pressure = "{intake} Pa"
exhaust_pressure = "{exhaust} Pa"
[ring]
face_width = "3 mm"
elastic_pressure = "0.2 MPa"
[ring.face]
form = "polynomial"
coefficients = [427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.3]
length_unit = "{length_unit}"
height_unit = "um"
[contact]
asperity_density = "0.097 um-2"
asperity_radius = "1.56 um"
roughness = "0.48 um"
boundary_shear_strength_coefficient = 0.3581
[lubricant]
file = "data/lubricants/styles2014.toml"
[film]
cavitation = "{cavitation}"
"""


class HeavyDuty(program.ProgramTest):
    def setUp(self):
        super().setUp()
        if not TRACES.exists():
            program.skip_loudly(self, f"no measured traces beside the checkout: {TRACES}")
        with open(TRACES, newline="") as stream:
            self.rows = list(csv.DictReader(stream))

    def check_run(self, load, length_unit, cavitation):
        pressures = [float(row[f"p_Pa_load{load}"]) for row in self.rows]
        (self.folder / "case.toml").write_text(
            CASE.format(
                load=load,
                traces=TRACES,
                intake=pressures[0],
                exhaust=1.2 * pressures[0],
                length_unit=length_unit,
                cavitation=cavitation,
            )
        )
        values = json.loads(self.run_well("run", "case.toml", "--json"))
        self.assertIs(values["complete"], True)
        self.assertAlmostEqual(values["peak_gas_pressure"], max(pressures), delta=1e-9 * max(pressures))
        # Newton stops at 1e-8 of film and pressure; the rest is room for the slope of the load.
        self.assertLess(values["effort"]["max_load_residual"], 1e-6)
        self.assertIn("liner.youngs_modulus", values["assumed"])
        self.assertNotIn("gas.intake_pressure", values["assumed"])
        self.assertGreater(values["min_film_thickness"], 0)

    def test_face_stretched_to_the_width_runs_at_every_load(self):
        for load in (25, 50, 75, 100):
            for cavitation in ("reynolds-exit", "mass-conserving"):
                with self.subTest(load=load, cavitation=cavitation):
                    self.check_run(load, "2.5 mm", cavitation)

    def test_face_taken_at_its_word_runs_at_every_load(self):
        for load in (25, 50, 75, 100):
            for cavitation in ("reynolds-exit", "mass-conserving"):
                with self.subTest(load=load, cavitation=cavitation):
                    self.check_run(load, "mm", cavitation)


if __name__ == "__main__":
    unittest.main(verbosity=2)
