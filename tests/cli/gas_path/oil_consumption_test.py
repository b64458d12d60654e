"""The oil consumption of a pack: its bands, closed forms, refusals."""

import csv
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
            ("lubricant.noack=0.6", "out of range"),
            ("operating.brake_power=25 kW", "engine.cylinders"),
            ("engine.cylinders=3.5", "is not whole"),
        ):
            self.assert_refused(self.run_program("run", PACK, "--set", setting), text)

    def test_volatility_is_stated_in_one_way(self):
        case = (
            (self.folder / "case.toml")
            .read_text()
            .replace("[lubricant]\n", f'[lubricant]\nnoack = 0.12\n{ONE_FRACTION.split(".", 1)[1]}\n')
        )
        (self.folder / "both.toml").write_text(case)
        done = self.run_program("run", "both.toml", "--set", "conditions=engine")
        self.assert_refused(done, "lubricant.noack and lubricant.distillation are both stated")

    def test_case_without_a_ring_is_refused(self):
        case = (self.folder / "case.toml").read_text()
        head, tail = case.split("[ring]", 1)
        (self.folder / "none.toml").write_text("ring = []\n" + head + "[contact]" + tail.split("[contact]", 1)[1])
        self.assert_refused(self.run_program("run", "none.toml"), "ring = [] has no ring")
        (self.folder / "none.toml").write_text(head + "[contact]" + tail.split("[contact]", 1)[1])
        self.assert_refused(self.run_program("run", "none.toml"), "ring.face_width is missing")

    def test_noack_loss_takes_the_place_of_the_fractions_of_the_oil(self):
        light = self.run_pack("lubricant.noack=0.2")["oil_consumption"]
        heavy = self.run_pack("lubricant.noack=0.05")["oil_consumption"]
        self.assertGreater(light["evaporation"]["value"], 1.5 * heavy["evaporation"]["value"])
        self.assertEqual(light["carried_by_gas"], heavy["carried_by_gas"])

    def test_what_narrows_the_band_comes_in_order(self):
        found = self.run_pack("oil_transport.gas_load=0.005")["oil_consumption"]
        bands = found["narrowed_by"]
        self.assertGreater(len(bands), 0)
        self.assertEqual([band["band_share"] for band in bands], sorted((b["band_share"] for b in bands), reverse=True))
        self.assertNotIn("oil_transport.gas_load", [band["input"] for band in bands])
        for band in bands:
            self.assertGreaterEqual(band["low"], found["low"])
            self.assertLessEqual(band["high"], found["high"])

    def test_study_has_the_consumption_of_each_operating_point(self):
        (self.folder / "pack.toml").write_text(f'include = ["{PACK}"]\n[solver]\ncells = 60\n[engine]\ncylinders = 4\n')
        (self.folder / "study.toml").write_text(
            'title = "points"\nkind = "compare"\n[[base]]\nname = "pack"\ncase = "pack.toml"\n'
            '[plan]\nmethod = "operating-points"\n[accuracy]\nsample = 0\n'
            + "".join(
                f'[[point]]\nname = "{name}"\nweight = {weight}\n'
                f'values = {{ "oil_transport.gas_load" = {load}, "operating.brake_power" = "{power} kW" }}\n'
                for name, weight, load, power in (("one", 0.25, 0.004, 10), ("two", 0.75, 0.008, 20))
            )
        )
        done = self.run_program("study", "study.toml", "-o", "out")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("oil_consumption", done.stdout)
        with open(self.folder / "out" / "study.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertEqual(len(rows), 2)

        def value(row, name):
            return float(next(cell for key, cell in row.items() if key.split(" ")[0] == name))

        parts = ("oil_evaporation", "oil_loss_scraped_up", "oil_carried_by_gas", "oil_thrown_off")
        for row in rows:
            total = value(row, "oil_consumption")
            self.assertAlmostEqual(sum(value(row, part) for part in parts) / total, 1, delta=1e-12)
            self.assertAlmostEqual(value(row, "oil_consumption_engine") / total, 4, delta=1e-12)
        ratio = value(rows[1], "oil_carried_by_gas") / value(rows[0], "oil_carried_by_gas")
        self.assertAlmostEqual(ratio, 2, delta=1e-9)
        power = value(rows[0], "oil_consumption_engine") / value(rows[0], "oil_consumption_brake_specific")
        self.assertAlmostEqual(power, 10e3, delta=1e-3)

    def test_case_without_the_oil_on_the_liner_has_no_evaporation(self):
        done = self.run_program("run", "case.toml", "--set", "evaporation.mass_transfer_coefficient=0.05 m/s")
        self.assert_refused(done, "evaporation.mass_transfer_coefficient is not used in this case")


if __name__ == "__main__":
    unittest.main()
