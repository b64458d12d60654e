"""The oil consumption of a pack: its bands, closed forms, refusals."""

import json
import math
import unittest

import program

PACK = str(program.SOURCES / "cases" / "ring-pack" / "three_rings.toml")
PARTS = ("evaporation", "scraped_up", "carried_by_gas", "thrown_off")
ONE_FRACTION = 'lubricant.distillation=[{share=1.0, boiling_point="520 degC", molar_mass="400 g/mol"}]'


class OilConsumptionTest(program.ProgramTest):
    def run_pack(self, *settings):
        words = [word for setting in ("solver.cells=60", *settings) for word in ("--set", setting)]
        done = self.run_program("run", PACK, "--json", *words)  # which reports what --set drops of the oil's file
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_car_pack_has_the_consumption_of_car_engines(self):
        pack = self.run_pack("engine.cylinders=4", "operating.fuel_rate=6.7 kg/h", "operating.brake_power=25 kW")
        found = pack["oil_consumption"]
        for end in ("low", "value", "high"):
            self.assertAlmostEqual(found[end] / sum(found[part][end] for part in PARTS), 1, delta=1e-12)
            self.assertAlmostEqual(found["engine"][end] / found[end], 4, delta=1e-12)
        for part in PARTS:
            self.assertLessEqual(found[part]["low"], found[part]["value"], part)
            self.assertLessEqual(found[part]["value"], found[part]["high"], part)
            self.assertTrue(found[part]["assumption"], part)
        # Cars on the road: 0.016 to 0.114 % of the fuel (SAE 2013-01-0884), mostly at part load; here is full load.
        self.assertLess(found["fuel_share"]["low"], 0.114e-2)
        self.assertGreater(found["fuel_share"]["high"], 0.114e-2)
        self.assertLess(found["high"] / found["low"], 30)
        self.assertEqual(found["units"]["brake_specific"], "kg/J")
        # What gas carries of a car cylinder: 6 to 20 ug per cycle.
        per_cycle = 120 / 1500
        self.assertAlmostEqual(found["carried_by_gas"]["low"] * per_cycle * 1e9, 6, delta=1.5)
        self.assertAlmostEqual(found["carried_by_gas"]["high"] * per_cycle * 1e9, 20, delta=5)

    def test_one_fraction_evaporates_as_the_closed_form(self):
        beta, molar_mass, boiling, wall = 0.02, 0.4, 793.15, 413.15
        found = self.run_pack(ONE_FRACTION, "evaporation.mass_transfer_coefficient=0.02 m/s", "thermal.liner=140 degC")[
            "oil_consumption"
        ]["evaporation"]
        pressure = 101325 * math.exp((4.4 + math.log(boiling)) * (1 - boiling / wall))
        radius, rod, n = 0.0795 / 2, 0.1381, 3600
        mean = 0
        for k in range(n):
            phi = 2 * math.pi * k / n
            mean += (radius * (1 - math.cos(phi)) + rod - math.sqrt(rod**2 - (radius * math.sin(phi)) ** 2)) / n
        expected = beta * molar_mass * pressure / (8.314462618 * wall) * math.pi * 0.089 * mean
        self.assertAlmostEqual(found["high"] / expected, 1, delta=1e-9)
        self.assertAlmostEqual(found["value"] / expected, 1, delta=1e-9)

    def test_gas_flows_both_ways_and_keeps_its_mass(self):
        gas = self.run_pack("engine.cylinders=4")["gas"]
        paths = {path["name"]: path for path in gas["paths"]}
        back = sum(paths[name]["mass_back_per_cycle"] for name in ("end gap 1", "below ring 1"))
        self.assertAlmostEqual(gas["reverse_blow_by_per_cycle"] / back, 1, delta=1e-12)
        entered = sum(paths[name]["mass_per_cycle"] for name in ("end gap 1", "above ring 1"))
        # Periodic to about 1e-8 of the pressures.
        self.assertAlmostEqual(entered / gas["blow_by_per_cycle"], 1, delta=1e-6)
        for path in gas["paths"]:
            net = path["mass_forward_per_cycle"] - path["mass_back_per_cycle"]
            self.assertAlmostEqual(net, path["mass_per_cycle"], delta=1e-15 * max(1, path["mass_forward_per_cycle"]))
        share = gas["reverse_blow_by_per_cycle"] / gas["trapped_mass"]
        self.assertAlmostEqual(gas["reverse_blow_by_charge_share"] / share, 1, delta=1e-12)
        self.assertAlmostEqual(gas["engine"]["blow_by_per_cycle"] / gas["blow_by_per_cycle"], 4, delta=1e-12)

    def test_what_does_not_fit_is_refused(self):
        light, heavy = '{share=0.3, boiling_point="440 degC"}', '{share=0.7, boiling_point="540 degC"}'
        for setting, text in (
            (f"lubricant.distillation=[{light}]", "add up to 0.3, not 1"),
            (f"lubricant.distillation=[{heavy}, {light}]", "rising boiling points"),
            ('lubricant.distillation=[{share=1.0, boiling_point="120 degC"}]', "above the last boiling point"),
            ("lubricant.distillation=[{share=1.0}]", "requires a share and a boiling point"),
            ("operating.brake_power=25 kW", "engine.cylinders"),
            ("engine.cylinders=3.5", "is not whole"),
        ):
            self.assert_refused(self.run_program("run", PACK, "--set", setting), text)

    def test_case_without_the_oil_on_the_liner_has_no_evaporation(self):
        done = self.run_program("run", "case.toml", "--set", "evaporation.mass_transfer_coefficient=0.05 m/s")
        self.assert_refused(done, "evaporation.mass_transfer_coefficient is not used in this case")


if __name__ == "__main__":
    unittest.main()
