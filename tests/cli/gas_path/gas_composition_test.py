"""The composition of the gas in a pack: what reaches the crankcase, properties of mixtures, oil that holds fuel."""

import csv
import io
import json
import unittest

import program

PACK = str(program.SOURCES / "cases" / "ring-pack" / "two_rings.toml")
HYDROGEN = ("gas.composition.fuel=hydrogen", "gas.composition.excess_air_ratio=2")


class GasCompositionTest(program.ProgramTest):
    def gas(self, *settings, command=("gas", PACK, "--json")):
        words = [word for setting in settings for word in ("--set", setting)]
        return self.run_well(*command, *words)

    def found(self, *settings):
        return json.loads(self.gas(*settings))

    def test_gases_reach_the_crankcase_as_the_blow_by(self):
        found = self.found(*HYDROGEN)
        gases = {row["name"]: row for row in found["composition"]}
        self.assertEqual(list(gases), ["fresh charge", "burnt gas", "air", "hydrogen", "water"])
        entered = sum(gases[name]["crankcase_per_cycle"] for name in ("fresh charge", "burnt gas", "air"))
        self.assertAlmostEqual(entered / found["blow_by_per_cycle"], 1, delta=1e-9)
        self.assertLess(found["composition_defect"], 1e-12)
        self.assertEqual(found["fuel_to_crankcase"], gases["hydrogen"]["crankcase_flow"])
        self.assertEqual(found["units"]["crankcase_flow"], "kg/s")
        # The properties are those that the case states, and so are the flows.
        self.assertEqual(found["blow_by_per_cycle"], self.found()["blow_by_per_cycle"])
        self.assertNotIn("composition", self.found())

    def test_a_flame_that_comes_last_sends_more_fuel_to_the_crankcase(self):
        mixed, last = (
            self.found(*HYDROGEN, f"gas.composition.burn={burn}")["fuel_to_crankcase"] for burn in ("wiebe", "step")
        )
        self.assertGreater(last, mixed)

    def test_ventilation_dilutes_the_fuel(self):
        without = self.found(*HYDROGEN)
        with_air = self.found(*HYDROGEN, "gas.composition.crankcase_air=20 kg/h")
        self.assertLess(with_air["crankcase_fuel_share"], 0.2 * without["crankcase_fuel_share"])
        topics = [{note["topic"] for note in found["notes"]} for found in (without, with_air)]
        self.assertIn("crankcase-flammable", topics[0])
        self.assertNotIn("crankcase-flammable", topics[1])
        self.assertIn("water-condenses", topics[0])

    def test_curves_add_up(self):
        self.gas(*HYDROGEN, command=("gas", PACK, "--csv", "gas.csv"))
        rows = list(csv.DictReader(io.StringIO((self.folder / "gas.csv").read_text())))
        for row in rows[::60]:
            shares = (float(row[f"share_{gas}_land_2 [-]"]) for gas in ("fresh_charge", "burnt_gas", "air"))
            self.assertAlmostEqual(sum(shares), 1, delta=1e-10)

    def test_properties_of_the_mixture_set_the_flows(self):
        stated = self.found(*HYDROGEN)
        settings = (*HYDROGEN, "gas_path.properties=mixture", "gas_path.mixture_burnt_share=0")
        words = [word for setting in settings for word in ("--set", setting)]
        done = self.run_program("gas", PACK, "--json", *words)
        self.assertIn("makes keys of the case unused", done.stderr)  # the properties that the pack states
        mixture = json.loads(done.stdout)
        # Fresh hydrogen charge has R of 343 J/(kg K): the flow of an orifice goes with R^-1/2.
        ratio = mixture["blow_by_per_cycle"] / stated["blow_by_per_cycle"]
        self.assertAlmostEqual(ratio, (287 / 343) ** 0.5, delta=0.05)

    def test_start_case_of_a_hydrogen_engine_runs(self):
        self.run_well("new", "hydrogen.toml", "--pack", "hydrogen")
        found = json.loads(self.run_well("gas", "hydrogen.toml", "--json"))
        self.assertGreater(found["fuel_to_crankcase"], 0)

    def test_what_does_not_fit_is_refused(self):
        for settings, text in (
            ((*HYDROGEN, "gas_path.model=given"), "pressures between the rings are not computed"),
            (("gas_path.properties=mixture",), "gas.composition.fuel is not stated"),
            (("gas.composition.humidity=0.02",), "gas.composition.humidity is not used in this case"),
            (("gas.composition.fuel=petrol",), "gas.composition.fuel"),
            ((*HYDROGEN, "gas.composition.residual_share=0"), "gas.composition.residual_share"),
        ):
            words = [word for setting in settings for word in ("--set", setting)]
            self.assert_refused(self.run_program("gas", PACK, *words), text)

    def test_fuel_thins_the_oil_and_water_thickens_it_a_little(self):
        values = {}
        for name, setting in (("fresh", "fuel=0"), ("fuel", "fuel=0.05"), ("water", "water=0.02")):
            words = ("--set", f"lubricant.{setting}", "--set", "solver.cells=40", "--json")
            values[name] = json.loads(self.run_well("run", "case.toml", *words))
        viscosity = {name: found["oil_viscosity"] for name, found in values.items()}
        self.assertLess(viscosity["fuel"], 0.9 * viscosity["fresh"])
        self.assertAlmostEqual(viscosity["water"] / viscosity["fresh"], 1.018, delta=0.005)
        self.assertIn("oil-diluted", {note["topic"] for note in values["fuel"]["notes"]})
        self.assertNotIn("oil-diluted", {note["topic"] for note in values["fresh"]["notes"]})


if __name__ == "__main__":
    unittest.main()
