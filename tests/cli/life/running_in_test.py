"""A roughness that runs in over the life of a ring: `[running_in]`, its numbers, its outputs, its refusals."""

import json
import math
import unittest

import life_test
import program

kStart, kLimit, kScale = 0.48e-6, 0.35e-6, 0.1e-6  # [m]
kLiner = 3e-15  # [m2/N]
kMeanPeak = 1 / math.sqrt(2 * math.pi)  # mean height above the mean plane of a Gaussian surface, over its rms
SCENARIO = f"""\
title = "a ring that runs in"
case = "case.toml"
mode = "archard"
hours = ["0 h", "0.25 h", "0.5 h", "1 h", "2 h", "6 h"]
[wear]
coefficient = "1e-19 m2/N"
liner_coefficient = "{kLiner} m2/N"
"""
RUNNING_IN = '[running_in]\nroughness_limit = "0.35 um"\ndepth_scale = "0.1 um"\n'
PLATEAU = '[contact.plateau]\nRpq = "0.2 um"\nRvq = "1 um"\nRmq = 0.8\nring_roughness = "0.1 um"\n[lubricant]'


def with_plateau(text):
    return text.replace('roughness = "0.48 um"\n', "").replace("[lubricant]", PLATEAU, 1)


def mean_roughness(depths, start=kStart, limit=kLimit, scale=kScale):
    """Mean over places, each weighted with its depth, of a roughness that falls exponentially with it."""
    left = sum(depth * math.exp(-depth / scale) for depth in depths) / sum(depths)
    return limit + (start - limit) * left


class RunningInTest(life_test.LifeTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plateau.toml").write_text(with_plateau(program.CASE))

    def scenario(self, more=RUNNING_IN, text=SCENARIO, *words):
        (self.folder / "life.toml").write_text(text + more)
        return self.life("life.toml", *words)

    def frozen(self, roughness):
        """Wear of the liner per hour [m/h] and FMEP of the ring with this roughness, which stays."""
        (self.folder / "frozen.toml").write_text(
            program.CASE.replace('"0.48 um"', f'"{1e6 * roughness!r} um"').replace(
                '"1.56 um"', f'"{1.56 * kStart / roughness!r} um"'
            )
        )
        text = SCENARIO.replace("case.toml", "frozen.toml")
        hours = text.split("\n")[3]
        first = self.scenario("", text.replace(hours, 'hours = ["0 h", "0.001 h"]'))["states"]
        return [1e3 * depth for depth in first[1]["liner_worn_depth"]], first[0]["fmep"]


class Law(RunningInTest):
    def test_it_starts_as_the_case(self):
        first = self.scenario()["states"][0]
        alone = json.loads(self.run_well("run", "case.toml", "--json"))
        self.assertAlmostEqual(first["running_in_roughness"] / kStart, 1, delta=1e-14)
        for name in ("mean_power_loss", "fmep", "mean_absolute_oil_flow"):
            self.assertEqual(first[name], alone[name])

    def test_friction_falls_in_the_first_hours_and_levels_off(self):
        states = self.scenario()["states"]
        for name in ("fmep", "roughness", "running_in_roughness", "smoothing_share"):
            values = [state[name] for state in states]
            self.assertEqual(values, sorted(values, reverse=True), name)
        fmep = {state["hours"]: state["fmep"] for state in states}
        self.assertLess(fmep[0.5], 0.9 * fmep[0])
        self.assertLess(fmep[2] - fmep[6], 0.1 * (fmep[0] - fmep[2]))
        self.assertGreater(states[-1]["roughness"], kLimit)
        self.assertLess(states[-1]["roughness"], 1.03 * kLimit)

    def test_the_roughness_is_the_mean_over_what_the_liner_has_lost(self):
        for state in self.scenario()["states"][1:]:
            expected = mean_roughness(state["liner_worn_depth"])
            self.assertAlmostEqual(state["running_in_roughness"] / expected, 1, delta=1e-12)
            self.assertEqual(state["roughness"], state["running_in_roughness"])

    def test_it_is_that_of_frozen_lives_step_by_step(self):
        """Heun's scheme over lives whose roughness stays, eight steps to 2 h: within 0.02 % of 32 steps."""
        depths, roughness, step = [0.0] * 100, kStart, 0.25
        for _ in range(8):
            rate, _ = self.frozen(roughness)
            first = [depth + step * one for depth, one in zip(depths, rate, strict=True)]
            later, _ = self.frozen(mean_roughness(first))
            depths = [depth + 0.5 * step * (one + other) for depth, one, other in zip(depths, rate, later, strict=True)]
            roughness = mean_roughness(depths)
        _, fmep = self.frozen(roughness)
        (state,) = (state for state in self.scenario()["states"] if state["hours"] == 2)
        self.assertAlmostEqual(state["roughness"] / roughness, 1, delta=2e-3)  # jumps within which it changes by 2 %
        self.assertAlmostEqual(state["fmep"] / fmep, 1, delta=5e-3)  # the face has lost some nanometres

    def test_peaks_keep_their_density_and_become_blunter(self):
        first, last = (self.scenario()["states"][k] for k in (0, -1))
        self.assertEqual(last["asperity_density"], first["asperity_density"])
        product = first["asperity_radius"] * first["roughness"]
        self.assertAlmostEqual(last["asperity_radius"] * last["roughness"] / product, 1, delta=1e-12)
        self.assertEqual(last["boundary_shear_strength_coefficient"], first["boundary_shear_strength_coefficient"])

    def test_the_ring_may_be_what_is_smoothed(self):
        text = SCENARIO.replace("1e-19", "4e-18").split("liner_coefficient")[0]
        last = self.scenario(RUNNING_IN + 'surface = "ring"\n', text)["states"][-1]
        self.assertLess(last["roughness"], kStart)
        least = kLimit + (kStart - kLimit) * math.exp(-last["largest_worn_depth"] / kScale)
        self.assertGreater(last["roughness"], least)

    def test_a_life_without_it_keeps_its_roughness(self):
        states = self.scenario("")["states"]
        self.assertEqual(states[-1]["roughness"], states[0]["roughness"])
        self.assertNotIn("running_in_roughness", states[-1])
        self.assertNotIn("smoothing_share", states[-1])


class Volume(RunningInTest):
    def test_smoothing_is_a_share_of_the_worn_volume(self):
        states = self.scenario()["states"]
        self.assertAlmostEqual(states[0]["smoothing_share"], kMeanPeak * (kStart - kLimit) / kScale, delta=1e-12)
        for state in states[1:]:
            depths = state["liner_worn_depth"]
            removed = [kMeanPeak * (kStart - kLimit) * -math.expm1(-depth / kScale) for depth in depths]
            self.assertTrue(all(peak <= depth for peak, depth in zip(removed, depths, strict=True)))
            self.assertAlmostEqual(state["smoothing_share"], sum(removed) / sum(depths), delta=1e-12)

    def test_the_worn_volume_is_that_of_archard(self):
        """Ring and liner carry the same load over the same sliding length: their volumes are as their coefficients."""
        reported = self.scenario()
        self.assertLess(reported["wear"]["volume_balance_error"], 1e-12)
        bin_length = 79.5e-3 / len(reported["liner_position"])
        for state in reported["states"][1:]:
            ratio = bin_length * sum(state["liner_worn_depth"]) / state["worn_area"]
            self.assertAlmostEqual(ratio / (kLiner / 1e-19), 1, delta=1e-3)  # samples of a cycle along the stroke

    def test_peaks_that_would_lose_more_than_is_worn_are_refused(self):
        self.refused(
            SCENARIO + RUNNING_IN.replace("0.1 um", "0.05 um"),
            "life.toml:10:15",
            "running_in.depth_scale = 0.05 um would take more material from the peaks than is worn",
            "at first 1.04 times as much",
            "state 0.0521 um or more",
        )
        self.scenario(RUNNING_IN.replace("0.1 um", "0.0521 um"))


class Plateau(RunningInTest):
    TEXT = SCENARIO.replace("case.toml", "plateau.toml")
    LIMIT = RUNNING_IN.replace("0.35 um", "0.1 um")

    def test_the_plateau_falls_to_its_limit_and_the_valleys_stay(self):
        states = self.scenario(self.LIMIT, self.TEXT)["states"]
        for state in states[1:]:
            expected = mean_roughness(state["liner_worn_depth"], 0.2e-6, 0.1e-6)
            self.assertAlmostEqual(state["running_in_roughness"] / expected, 1, delta=1e-12)
        first, last = states[0], states[-1]
        self.assertAlmostEqual(first["running_in_roughness"] / 0.2e-6, 1, delta=1e-14)
        self.assertLess(last["fmep"], 0.85 * first["fmep"])
        self.assertLess(last["roughness"], first["roughness"])
        self.assertGreater(last["roughness"], 0.7 * first["roughness"], "the valleys are as deep as before")
        carries = [math.hypot(0.1e-6, state["running_in_roughness"]) for state in (first, last)]
        product = last["asperity_radius"] * carries[1] / (first["asperity_radius"] * carries[0])
        self.assertAlmostEqual(product, 1, delta=1e-12)

    def test_a_state_has_the_values_of_a_case_with_its_plateau(self):
        last = self.scenario(self.LIMIT, self.TEXT.replace("1e-19", "1e-25"))["states"][-1]
        rpq, radius = (1e6 * last[name] for name in ("running_in_roughness", "asperity_radius"))
        text = with_plateau(program.CASE).replace('Rpq = "0.2 um"', f'Rpq = "{rpq!r} um"')
        (self.folder / "last.toml").write_text(text.replace('"1.56 um"', f'"{radius!r} um"'))
        alone = json.loads(self.run_well("run", "last.toml", "--json"))
        self.assertAlmostEqual(last["fmep"] / alone["fmep"], 1, delta=1e-4)  # a face by its points

    def test_the_ring_does_not_smooth_the_plateau_of_the_liner(self):
        self.refused(self.TEXT + self.LIMIT + 'surface = "ring"\n', 'has surface = "ring"', "that of the liner")

    def test_a_limit_above_the_plateau(self):
        self.refused(self.TEXT + RUNNING_IN, "is not below Rpq of [contact.plateau] of the base case, 0.2 um")


class Outputs(RunningInTest):
    def test_each_has_the_roughness(self):
        limit = '[end_of_life]\nrunning_in_roughness = "0.4 um"\n'
        (self.folder / "life.toml").write_text(SCENARIO + RUNNING_IN + limit)
        printed = self.run_well("life", "life.toml", "--output", "life.nc", "--html", "life.html")
        self.assertIn("running-in roughness", printed)
        self.assertIn("share from the peaks", printed)
        self.assertIn("end of life by running_in_roughness: after", printed)
        stored = (self.folder / "life.nc").read_bytes()
        page = (self.folder / "life.html").read_text(encoding="utf-8")
        for name in ("running_in_roughness", "smoothing_share"):
            self.assertIn(name.encode(), stored)
            self.assertIn(f'"name":"{name}"', page)

    def test_the_law_is_echoed_and_noted(self):
        reported = self.scenario()
        self.assertEqual(reported["wear"]["surface"], "running-in")
        law = reported["wear"]["running_in"]
        self.assertEqual(law["surface"], "liner")
        self.assertAlmostEqual(law["roughness_limit"] / kLimit, 1, delta=1e-14)
        self.assertAlmostEqual(law["depth_scale"] / kScale, 1, delta=1e-14)
        self.assertIn("roughness-runs-in", [note["topic"] for note in reported["notes"]])

    def test_the_shipped_life_falls_by_a_quarter(self):
        """Lives with frozen roughness step by step, as above; docs/theory/life.md."""
        states = self.life(program.SOURCES / "cases" / "life" / "running_in.toml")["states"]
        roughness, fmep = (0.480, 0.449, 0.428, 0.392, 0.371, 0.360, 0.356), (14.83, 13.9, 13.3, 12.2, 11.5, 11.2, 11.2)
        for state, micrometres, kilopascal in zip(states, roughness, fmep, strict=True):
            self.assertAlmostEqual(state["roughness"] * 1e6, micrometres, delta=0.002)
            self.assertAlmostEqual(state["fmep"] * 1e-3 / kilopascal, 1, delta=0.015)


class Refusals(RunningInTest):
    def test_a_limit_that_is_not_below_the_roughness(self):
        for limit in ("0.6 um", "0.48 um"):
            self.refused(
                SCENARIO + RUNNING_IN.replace("0.35 um", limit),
                "life.toml:9:19",
                f"running_in.roughness_limit = {limit} is not below contact.roughness of the base case, 0.48 um",
                "state a smaller limit",
            )

    def test_lengths_that_are_not_above_zero(self):
        for old, key in (("0.35 um", "roughness_limit"), ("0.1 um", "depth_scale")):
            for length in ("0 um", "-0.1 um"):
                self.refused(
                    SCENARIO + RUNNING_IN.replace(old, length), f'running_in.{key} = "{length}" is not above 0'
                )

    def test_keys_that_are_absent_or_unknown(self):
        for key in ("roughness_limit", "depth_scale"):
            self.refused(SCENARIO + "[running_in]\n", f"[running_in] has no {key}")
        self.refused(SCENARIO + RUNNING_IN + "depth = 1\n", "unknown key depth in [running_in]")
        self.refused(SCENARIO + RUNNING_IN + 'surface = "piston"\n', "piston")

    def test_a_liner_that_does_not_wear(self):
        self.refused(
            SCENARIO.split("liner_coefficient")[0] + RUNNING_IN,
            "life.toml:7:",
            "[running_in] smooths the liner by its worn depth, and [wear] has no liner_coefficient",
            "state wear.liner_coefficient",
        )

    def test_a_path_has_no_coefficient(self):
        self.refused(life_test.LIFE + RUNNING_IN, '[running_in] needs the worn depth, and mode = "measured-path"')

    def test_a_surface_that_follows_the_path(self):
        states = '[[state]]\nhours = "0 h"\ncase = "case.toml"\n[[state]]\nhours = "10 h"\ncase = "worn.toml"\n'
        self.refused(SCENARIO + 'surface = "path"\n' + states + RUNNING_IN, 'combined with wear.surface = "path"')

    def test_a_fit(self):
        states = '[[state]]\nhours = "0 h"\ncase = "case.toml"\n[[state]]\nhours = "10 h"\ncase = "worn.toml"\n'
        self.refused(SCENARIO.replace("1e-19 m2/N", "fit") + states + RUNNING_IN, 'combined with coefficient = "fit"')


if __name__ == "__main__":
    unittest.main(verbosity=2)
