"""Blow-by over the hours of a life whose ring belongs to a pack: `[pack]` and `[end_of_life] blow_by_flow`."""

import json
import math
import unittest

import life_test
import program

PACK = """\
title = "a pack"
[engine]
bore = "89.0 mm"
stroke = "79.5 mm"
connecting_rod_length = "138.1 mm"
[operating]
speed = "3000 rpm"
[gas]
model = "wiebe"
intake_pressure = "0.5 bar"
peak_pressure = "30 bar"
[gas_path]
model = "orifice-volume"
[[ring]]
kind = "compression"
face_width = "1.2 mm"
end_gap = "0.3 mm"
land_clearance = "0.25 mm"
groove_volume = "0.3 cm3"
volume_below = "0.5 cm3"
side_clearance = "50 um"
radial_thickness = "3.5 mm"
[[ring]]
kind = "oil"
gap_area = "0.3 mm2"
"""
ARCHARD = life_test.ARCHARD.replace("4e-18", "4e-16") + "jumps = 8\n"
WITH_PACK = '[pack]\ncase = "pack.toml"\n'
kLitrePerMinute = 1e-3 / 60  # [m3/s]


class BlowBy(life_test.LifeTest):
    def setUp(self):
        super().setUp()
        (self.folder / "pack.toml").write_text(PACK)

    def scenario(self, more="", text=ARCHARD):
        (self.folder / "life.toml").write_text(text + WITH_PACK + more)
        return self.life()

    def gas(self, gap_mm):
        """Blow-by of the pack alone with the gas of the case and this end gap [m3/s]."""
        (self.folder / "alone.toml").write_text(
            PACK[: PACK.index("[operating]")]
            + self.table("operating")
            + self.table("gas")
            + PACK[PACK.index("[gas_path]") :].replace('"0.3 mm"', f'"{gap_mm!r} mm"')
        )
        return json.loads(self.run_well("gas", "alone.toml", "--json"))["blow_by_flow"]

    @staticmethod
    def table(name):
        start = program.CASE.index(f"[{name}]")
        end = program.CASE.find("\n[", start)
        lines = program.CASE[start:end].splitlines()
        return "\n".join(line for line in lines if "oil_temperature" not in line) + "\n"

    def test_it_is_that_of_the_pack_with_its_gap_as_worn(self):
        """Speed and gas are those of the base case, not those of the file of the pack."""
        states = self.scenario()["states"]
        self.assertAlmostEqual(states[0]["blow_by_flow"] / self.gas(0.3), 1, delta=1e-9)
        worn = states[-1]
        self.assertAlmostEqual(worn["end_gap_growth"], 2 * math.pi * worn["largest_worn_depth"], delta=1e-15)
        self.assertGreater(worn["end_gap_growth"], 10e-6)
        self.assertAlmostEqual(worn["blow_by_flow"] / self.gas(0.3 + 1e3 * worn["end_gap_growth"]), 1, delta=1e-9)
        self.assertGreater(worn["blow_by_flow"], 1.01 * states[0]["blow_by_flow"])

    def test_the_film_is_that_of_the_case_unless_its_pressures_are_computed(self):
        (self.folder / "without.toml").write_text(ARCHARD)
        without = self.life("without.toml")["states"]
        for state, other in zip(self.scenario()["states"], without, strict=True):
            for name in ("mean_power_loss", "worn_area", "mean_absolute_oil_flow"):
                self.assertEqual(state[name], other[name])
        computed = self.scenario('pressures = "computed"\n')["states"]
        self.assertNotEqual(computed[-1]["worn_area"], without[-1]["worn_area"])

    def test_a_worn_liner_opens_the_gap_too(self):
        without = self.scenario()["states"][-1]
        text = ARCHARD + 'liner_coefficient = "4e-16 m2/N"\n'
        worn = self.scenario(text=text)["states"][-1]
        self.assertEqual(worn["largest_worn_depth"], without["largest_worn_depth"])
        most = 0.3 + 2e3 * math.pi * (worn["largest_worn_depth"] + max(worn["liner_worn_depth"]))
        self.assertGreater(worn["blow_by_flow"], without["blow_by_flow"])
        self.assertLess(worn["blow_by_flow"], self.gas(most))

    def test_a_limit_ends_the_life_at_its_hour(self):
        states = self.scenario()["states"]
        limit = 0.5 * (states[1]["blow_by_flow"] + states[2]["blow_by_flow"])
        reported = self.scenario(f'[end_of_life]\nblow_by_flow = "{limit / kLitrePerMinute!r} l/min"\n')
        (end,) = reported["end_of_life"]
        self.assertAlmostEqual(end["hours"], 2.5, delta=1e-6)
        self.assertEqual(reported["units"]["blow_by_flow"], "m3/s")

    def test_a_limit_is_met_before_the_first_reported_hour(self):
        hours = ARCHARD.replace('["0 h", "1 h", "4 h"]', '["4 h"]')
        first, last = self.gas(0.3), self.scenario(text=hours)["states"][0]["blow_by_flow"]
        limit = (0.75 * first + 0.25 * last) / kLitrePerMinute
        (end,) = self.scenario(f'[end_of_life]\nblow_by_flow = "{limit!r} l/min"\n', hours)["end_of_life"]
        self.assertEqual(end["starts"], "below")
        self.assertAlmostEqual(end["hours"], 1, delta=1e-5)

    def test_operating_points_have_theirs_and_the_duty_has_the_mean(self):
        state = self.scenario(life_test.DUTY)["states"][0]
        idle, full = state["points"]
        mean = 0.25 * idle["blow_by_flow"] + 0.75 * full["blow_by_flow"]
        self.assertAlmostEqual(state["blow_by_flow"] / mean, 1, delta=1e-12)
        self.assertNotEqual(idle["blow_by_flow"], full["blow_by_flow"])

    def test_a_path_of_one_datum_has_it(self):
        parabola = 'form = "parabola"\ncrown_height = "15 um"\n'
        for name, offset in (("first.toml", 0.0), ("second.toml", 8.0)):
            face = f'form = "polynomial"\ncoefficients = [40.0, -48.0, {14.4 + offset}]\n'
            (self.folder / name).write_text(
                program.CASE.replace(parabola, face + 'length_unit = "mm"\nheight_unit = "um"\n')
            )
        text = life_test.LIFE.replace("case.toml", "first.toml").replace("worn.toml", "second.toml")
        states = self.scenario('[path]\ndatum = "common"\n', text)["states"]
        gap = 0.3 + 2e3 * math.pi * 8e-6
        self.assertAlmostEqual(states[-1]["blow_by_flow"] / self.gas(gap), 1, delta=1e-9)
        low, high = states[1]["band"]["blow_by_flow"]
        self.assertLess(low, high)

    def test_netcdf_and_table_hold_it(self):
        (self.folder / "life.toml").write_text(ARCHARD + WITH_PACK)
        printed = self.run_well("life", "life.toml", "--output", "life.nc")
        self.assertRegex(printed, r"blow-by per cylinder\n.* l/min\n")
        self.assertIn(b"blow_by_flow", (self.folder / "life.nc").read_bytes())

    def test_refusals(self):
        self.refused(ARCHARD + '[pack]\ncase = "gone.toml"\n', "there is no such file")
        self.refused("pack = 3\n" + ARCHARD, "[pack] is not a table", "1 error;")
        self.refused(ARCHARD + WITH_PACK + "ring = 3\n", "pack.ring = 3 is not from 1 to 2")
        self.refused(ARCHARD + WITH_PACK + "ring = 2\n", "ring 2 of the pack states gap_area alone", "state end_gap")
        gap = 'end_gap = "0.3 mm"\nland_clearance = "0.25 mm"'
        second = PACK.replace('gap_area = "0.3 mm2"', gap)
        volume = 'volume_below = "0.5 cm3"\n'
        model = 'model = "orifice-volume"\n'
        for text, more, fragments in (
            (second.replace(volume, ""), "ring = 2\n", ("does not pass this gap", "state volume_below of ring 1")),
            (second, 'ring = 2\npressures = "computed"\n', ("is an oil ring", "a compression ring")),
            (PACK.replace(model, model + 'film = "breakthrough"\n'), "", ('gas_path.film = "breakthrough"',)),
            (
                PACK.replace(model, 'model = "given"\n').replace(volume, volume + 'pressure_below = "2 bar"\n'),
                "",
                ('state gas_path.model = "orifice-volume"',),
            ),
        ):
            (self.folder / "pack.toml").write_text(text)
            self.refused(ARCHARD + WITH_PACK + more, *fragments)
        self.refused(life_test.LIFE + WITH_PACK, "faces with data of their own do not determine it")
        (self.folder / "pack.toml").write_text(PACK.replace('"89.0 mm"', '"90.0 mm"'))
        self.refused(ARCHARD + WITH_PACK, "the pack has engine.bore = 90 mm, the base case 89 mm")
        (self.folder / "case.toml").write_text(program.CASE.replace("[ring]\n", '[ring]\npressure_below = "1 bar"\n'))
        (self.folder / "pack.toml").write_text(PACK)
        self.refused(ARCHARD + WITH_PACK + 'pressures = "computed"\n', "are stated, and computed by [pack]")


if __name__ == "__main__":
    unittest.main(verbosity=2)
