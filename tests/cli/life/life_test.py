"""The life of a ring: `ringfilm life LIFE.toml`, its numbers, its files, its refusals."""

import json
import math
import unittest

import program

LIFE = """\
title = "a small life"
case = "case.toml"
hours = ["0 h", "2 h", "10 h", "20 h"]
[[state]]
hours = "0 h"
case = "case.toml"
[[state]]
hours = "10 h"
case = "worn.toml"
"""
WORN = (
    program.CASE.replace("15 um", "9 um")
    .replace('"0.48 um"', '"0.40 um"')
    .replace("strength_coefficient = 0.3581", "strength_coefficient = 0.2")
)
SHIPPED = program.SOURCES / "cases" / "life" / "styles2014.toml"


class LifeTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "worn.toml").write_text(WORN)
        (self.folder / "life.toml").write_text(LIFE)

    def life(self, name="life.toml", *words):
        return json.loads(self.run_well("life", str(name), "--json", *words))

    def refused(self, text, *fragments):
        (self.folder / "life.toml").write_text(text)
        self.assert_refused(self.run_program("life", "life.toml"), *fragments)


class Path(LifeTest):
    def test_measured_states_are_the_cases_to_the_bit(self):
        states = self.life()["states"]
        for state, case in ((states[0], "case.toml"), (states[2], "worn.toml"), (states[3], "worn.toml")):
            alone = json.loads(self.run_well("run", case, "--json"))
            for name in ("mean_power_loss", "fmep", "mean_absolute_oil_flow", "peak_friction_coefficient_firing"):
                self.assertEqual(state[name], alone[name], f"{case}: {name}")

    def test_an_accuracy_is_that_of_all_states_on_nodes_that_they_share(self):
        exact = self.life()["states"]
        for name in ("case.toml", "worn.toml"):
            text = (self.folder / name).read_text()
            (self.folder / name).write_text(text.replace("[solver]\n", '[solver]\naccuracy = "1 %"\n'))
        reported = self.life()
        notes = {note["topic"]: note["message"] for note in reported["notes"]}
        self.assertIn("solver.accuracy = 1 %: computed on 64 uniform cells", notes["accuracy-asked-for"])
        for state, fine in zip(reported["states"], exact):
            self.assertAlmostEqual(state["fmep"] / fine["fmep"], 1, delta=0.01)

    def test_states_report_how_they_are_known(self):
        reported = self.life()
        self.assertEqual(
            [state["state_origin"] for state in reported["states"]], ["measured", "interpolated", "measured", "held"]
        )
        self.assertIn("state-held", [note["topic"] for note in reported["notes"]])
        self.assertIsNone(reported["states"][1]["worn_area"], "a path does not determine what was lost")

    def test_the_band_holds_the_value_and_closes_at_measured_states(self):
        for state in self.life()["states"]:
            low, high = state["band"]["mean_power_loss"]
            self.assertLessEqual(low, state["mean_power_loss"])
            self.assertGreaterEqual(high, state["mean_power_loss"])
            self.assertEqual(low == high, state["state_origin"] != "interpolated")

    def test_netcdf_holds_the_running_time(self):
        self.run_well("life", "life.toml", "--output", "life.nc")
        stored = (self.folder / "life.nc").read_bytes()
        for name in (b"running_time", b"mean_power_loss_high", b"face_height", b"ringfilm_life_schema"):
            self.assertIn(name, stored)
        refused = self.run_program("report", "life.nc", "--output", "life.html")
        self.assert_refused(refused, "life.nc: a life; a report is drawn of single cycles", "ringfilm life writes")

    def test_the_page_holds_the_life_and_fetches_nothing(self):
        self.run_well("life", "life.toml", "--html", "life.html")
        page = (self.folder / "life.html").read_text(encoding="utf-8")
        self.assertIn("a small life", page)
        self.assertIn('"state_origin":"interpolated"', page)
        self.assertIn("default-src 'none'", page)

    def test_the_number_of_threads_changes_nothing(self):
        self.assertEqual(self.life(), self.life("life.toml", "--threads", "1"))

    def test_the_shipped_life_has_the_values_of_an_independent_program(self):
        """Computed by another program with the equations of the paper; docs/theory/life.md."""
        power = (118.0, 107.6, 98.2, 84.9, 64.9, 51.4, 43.3)
        flow = (869, 914, 962, 1040, 1058, 1080, 1099)
        turned = (121.4, 106.6, 93.1, 76.9, 53.5, 41.1, 34.6)
        states = self.life(SHIPPED)["states"]
        for state, watts, mg_per_s, other in zip(states, power, flow, turned, strict=True):
            self.assertAlmostEqual(state["mean_power_loss"], watts, delta=0.06)
            self.assertAlmostEqual(state["mean_absolute_oil_flow"] * 1e6, mg_per_s, delta=0.6)
            self.assertAlmostEqual(state["turned"]["mean_power_loss"], other, delta=0.06)
        alone = states[-1]["attribution"]
        for part, watts in (("face", 117.9), ("roughness", 89.3), ("shear_strength", 54.0)):
            self.assertAlmostEqual(alone[part]["mean_power_loss"], watts, delta=0.06)


ARCHARD = """\
title = "a wearing ring"
case = "case.toml"
mode = "archard"
hours = ["0 h", "1 h", "4 h"]
[wear]
coefficient = "4e-18 m2/N"
"""


class ReportPoints(LifeTest):
    def test_a_point_beside_the_duty_changes_nothing_of_it(self):
        point = '[[report_point]]\nname = "motored"\nspeed = "2500 rpm"\npeak_pressure = "20 bar"\n'
        (self.folder / "beside.toml").write_text(LIFE + DUTY + point)
        (self.folder / "life.toml").write_text(LIFE + DUTY)
        beside, without = self.life("beside.toml")["states"], self.life()["states"]
        for one, other in zip(beside, without, strict=True):
            name, share = one["points"][-1]["name"], one["points"][-1]["share"]
            self.assertEqual((name, share), ("motored", 0))
            self.assertEqual(one["points"][:-1], other["points"])
            self.assertEqual(
                {key: value for key, value in one.items() if key != "points"},
                {key: value for key, value in other.items() if key != "points"},
            )

    def test_its_values_are_those_of_the_case_at_that_point(self):
        (self.folder / "beside.toml").write_text(LIFE + '[[report_point]]\nname = "fast"\nspeed = "4000 rpm"\n')
        state = self.life("beside.toml")["states"][0]
        alone = json.loads(self.run_well("run", "case.toml", "--json", "--set", "operating.speed=4000 rpm"))
        self.assertEqual(state["points"][1]["mean_power_loss"], alone["mean_power_loss"])
        duty = json.loads(self.run_well("run", "case.toml", "--json"))
        self.assertEqual(state["mean_power_loss"], duty["mean_power_loss"])

    def test_it_does_not_wear(self):
        point = '[[report_point]]\nname = "fast"\nspeed = "6000 rpm"\n'
        worn = []
        for text in (ARCHARD, ARCHARD + point):
            (self.folder / "archard.toml").write_text(text)
            worn.append(self.life("archard.toml")["states"][-1]["worn_area"])
        self.assertEqual(*worn)

    def test_refusals(self):
        self.refused(LIFE + '[[report_point]]\nspeed = "900 rpm"\n', "name")
        self.refused(LIFE + '[[report_point]]\nname = "duty"\n', "two operating points have the name duty")
        self.refused(LIFE + '[[report_point]]\nname = "a"\nweight = 1\n', "unknown key weight")

    def test_many_points_are_refused_without_reading_all_their_cases(self):
        points = "".join(f'[[report_point]]\nname = "p{k}"\nspeed = "-{k + 1} rpm"\n' for k in range(2000))
        self.refused(LIFE + points, "1990 more operating points were not read", "11 errors")
        (self.folder / "life.toml").write_text(LIFE.replace('"20 h"]', '"5 h"]') + points)
        refused = self.run_program("life", "life.toml")
        self.assert_refused(refused, "the running time 5 h does not follow 10 h")
        self.assertNotIn("operating.speed", refused.stderr)


class CommonDatum(LifeTest):
    def test_worn_area_and_depth_are_those_between_the_faces(self):
        """A parabola that is 1 um farther from the liner everywhere."""
        parabola = '[ring.face]\nform = "polynomial"\n'
        heights = {}
        for name, offset in (("first.toml", 0.0), ("second.toml", 1.0)):
            heights[name] = f"coefficients = [40.0, -48.0, {14.4 + offset}]"
        for name, line in heights.items():
            text = program.CASE
            start = text.index("[ring.face]")
            end = text.find("\n[", start + 1)
            (self.folder / name).write_text(
                text[:start] + parabola + line + '\nlength_unit = "mm"\nheight_unit = "um"\n' + text[end:]
            )
        text = LIFE.replace("case.toml", "first.toml").replace("worn.toml", "second.toml")
        (self.folder / "life.toml").write_text(text + '[path]\ntime_scale = "linear"\ndatum = "common"\n')
        states = self.life()["states"]
        for state, depth in zip(states, (0, 0.2e-6, 1e-6, 1e-6), strict=True):
            self.assertAlmostEqual(state["largest_worn_depth"], depth, delta=1e-15)
            self.assertAlmostEqual(state["worn_area"], depth * 1.2e-3, delta=1e-18)
        self.assertNotIn("wear-not-determined", [note["topic"] for note in self.life()["notes"]])
        swapped = text.replace("first.toml", "x").replace("second.toml", "first.toml").replace("x", "second.toml")
        self.refused(swapped + '[path]\ndatum = "common"\n', "has gained 1 um of material")

    def test_limits_on_other_interpolations_use_their_own_depth(self):
        """The same parabolas; between 0 and 10 h the depth is a share of 1 um, straight between the reported hours."""
        for name, offset in (("first.toml", 0.0), ("second.toml", 1.0)):
            face = f'form = "polynomial"\ncoefficients = [40.0, -48.0, {14.4 + offset}]\n'
            (self.folder / name).write_text(
                program.CASE.replace(
                    'form = "parabola"\ncrown_height = "15 um"\n', face + 'length_unit = "mm"\nheight_unit = "um"\n'
                )
            )
        text = LIFE.replace("case.toml", "first.toml").replace("worn.toml", "second.toml")
        limit = '[path]\ndatum = "common"\n[end_of_life]\nlargest_worn_depth = "0.5 um"\n'
        (self.folder / "life.toml").write_text(text + limit)
        reported = self.life()
        (end,) = reported["end_of_life"]
        share = math.log(3) / math.log(11)
        self.assertAlmostEqual(end["hours"], 2 + 8 * (0.5 - share) / (1 - share), delta=1e-6)
        self.assertAlmostEqual(end["interpolations"]["linear in time"], 2 + 8 * 0.3 / 0.8, delta=1e-6)
        low, high = reported["states"][1]["band"]["largest_worn_depth"]
        self.assertAlmostEqual(low, 0.2e-6, delta=1e-12)
        self.assertGreater(high, share * 1e-6)

    def test_the_faces_of_the_paper_have_no_common_datum(self):
        shipped = SHIPPED.read_text(encoding="utf-8").replace("../styles2014", str(SHIPPED.parents[1] / "styles2014"))
        self.refused(shipped.replace("[path]", '[path]\ndatum = "common"'), "has gained 23", "at 1.2 mm")

    def test_without_one_there_are_lower_bounds_alone(self):
        states = self.life(SHIPPED)["states"]
        self.assertTrue(all(state["worn_area"] is None for state in states))
        self.assertEqual(
            [bool(state.get("least_wear")) for state in states], [False] * 3 + [True] + [False] * 2 + [True]
        )
        self.assertAlmostEqual(states[-1]["least_wear"][0]["worn_area"] * 1e9, 19.2, delta=0.06)


class EndOfLife(LifeTest):
    def test_blow_by_without_a_pack_is_refused(self):
        self.refused(
            LIFE + '[end_of_life]\nblow_by_flow = "20 l/min"\n',
            "life.toml:11:1",
            "end_of_life.blow_by_flow needs the gas of a ring pack",
            "write [pack]",
        )

    def test_a_limit_that_the_mode_does_not_determine_is_noted(self):
        (self.folder / "life.toml").write_text(LIFE + '[end_of_life]\nworn_area = "5 um mm"\n')
        self.assertIn("end-of-life-not-known", [note["topic"] for note in self.life()["notes"]])

    def test_a_limit_is_reached_between_two_hours(self):
        states = self.life()["states"]
        powers = [state["mean_power_loss"] for state in states]
        limit = 0.5 * (powers[1] + powers[2])
        (self.folder / "life.toml").write_text(LIFE + f'[end_of_life]\nmean_power_loss = "{limit!r} W"\n')
        (end,) = self.life()["end_of_life"]
        self.assertAlmostEqual(end["hours"], 6, delta=1e-6)
        self.assertEqual(set(end["interpolations"]), set(states[0]["interpolations"]))

    def test_a_limit_that_is_not_reached_is_null(self):
        (self.folder / "life.toml").write_text(LIFE + '[end_of_life]\nlargest_worn_depth = "5 um"\n')
        self.assertIsNone(self.life()["end_of_life"][0]["hours"])

    def test_an_unknown_limit(self):
        self.refused(LIFE + '[end_of_life]\noil_flow = "1 mg/s"\n', "unknown key oil_flow in [end_of_life]")


class Archard(LifeTest):
    def worn(self, more="", text=ARCHARD):
        (self.folder / "archard.toml").write_text(text + more)
        return self.life("archard.toml")

    def test_nothing_is_worn_at_the_start_and_its_values_are_those_of_the_case(self):
        first = self.worn()["states"][0]
        alone = json.loads(self.run_well("run", "case.toml", "--json"))
        self.assertEqual((first["worn_area"], first["largest_worn_depth"]), (0, 0))
        for name in ("mean_power_loss", "fmep", "mean_absolute_oil_flow"):
            self.assertEqual(first[name], alone[name])

    def test_volume_is_balanced_to_round_off(self):
        self.assertLess(self.worn()["wear"]["volume_balance_error"], 1e-12)

    def test_halving_the_jumps_changes_the_depth_by_less_than_the_stages(self):
        four, eight = (self.worn(f"jumps = {n}\n") for n in (4, 8))
        change = abs(four["states"][-1]["largest_worn_depth"] - eight["states"][-1]["largest_worn_depth"])
        self.assertLess(change, four["wear"]["stage_difference"])
        ratio = four["states"][-1]["worn_area"] / eight["states"][-1]["worn_area"]
        self.assertAlmostEqual(ratio, 1, delta=1e-3)

    def test_chosen_jumps_agree_with_many_equal_ones(self):
        chosen, many = self.worn()["states"][-1], self.worn("jumps = 64\n")["states"][-1]
        self.assertAlmostEqual(chosen["worn_area"] / many["worn_area"], 1, delta=1e-3)
        self.assertAlmostEqual(chosen["largest_worn_depth"], many["largest_worn_depth"], delta=0.02e-6)

    def test_euler_converges_to_the_same(self):
        euler, heun = (self.worn(f'jumps = 64\nscheme = "{name}"\n')["states"][-1] for name in ("euler", "heun"))
        self.assertAlmostEqual(euler["worn_area"] / heun["worn_area"], 1, delta=1e-3)

    def test_a_coefficient_in_mm3_per_nm_is_the_same(self):
        other = self.worn(text=ARCHARD.replace("4e-18 m2/N", "4e-9 mm3/Nm"))
        self.assertEqual(other["states"], self.worn()["states"])

    def test_the_coating_that_is_left_is_stored(self):
        (self.folder / "archard.toml").write_text(ARCHARD + 'coating_thickness = "50 um"\n')
        last = self.life("archard.toml", "--output", "life.nc")["states"][-1]
        self.assertAlmostEqual(last["coating_left"], 50e-6 - last["largest_worn_depth"], delta=1e-15)
        self.assertIn(b"coating_left", (self.folder / "life.nc").read_bytes())

    def test_a_coating_that_is_worn_through_ends_it_with_the_hour(self):
        (self.folder / "archard.toml").write_text(ARCHARD + 'coating_thickness = "0.1 um"\n')
        done = self.run_program("life", "archard.toml", "--json")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("the coating is worn through after", done.stderr)
        reported = json.loads(done.stdout)
        self.assertLess(len(reported["states"]), 3)
        self.assertGreater(reported["wear"]["coating_worn_through_hours"], 0)

    def test_limits_of_depth_are_met_before_the_first_reported_hour(self):
        text = ARCHARD.replace('["0 h", "1 h", "4 h"]', '["4 h"]') + 'coating_thickness = "0.1 um"\n'
        (self.folder / "archard.toml").write_text(text + '[end_of_life]\nlargest_worn_depth = "0.05 um"\n')
        done = self.run_program("life", "archard.toml", "--json")
        self.assertEqual(done.returncode, 4, done.stderr)
        reported = json.loads(done.stdout)
        self.assertEqual(reported["states"], [])
        through, (end,) = reported["wear"]["coating_worn_through_hours"], reported["end_of_life"]
        self.assertAlmostEqual(end["hours"] / through, 0.5, delta=1e-9)
        self.assertIsNone(end["turned"])

    def test_a_coefficient_that_wears_all_at_once_is_answered_by_few_jumps(self):
        """100 um of the assumed coating, lost long before the first reported hour; at most 0.15 um a jump else."""
        (self.folder / "archard.toml").write_text(ARCHARD.replace("4e-18", "4e-12"))
        done = self.run_program("life", "archard.toml", "--json")
        self.assertEqual(done.returncode, 4, done.stderr)
        reported = json.loads(done.stdout)
        self.assertLess(reported["wear"]["jumps"], 200)
        self.assertIn("jumps-coarse", [note["topic"] for note in reported["notes"]])
        self.assertLess(reported["wear"]["coating_worn_through_hours"], 0.1)

    def test_a_coefficient_that_runs_away_ends_with_the_hour(self):
        text = ARCHARD.replace("4e-18", "4e-12").replace('["0 h", "1 h", "4 h"]', '["0 h", "0.01 h"]')
        (self.folder / "archard.toml").write_text(text + "jumps = 4\n")
        done = self.run_program("life", "archard.toml", "--json")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("the coating is worn through after", done.stderr)
        self.assertIn("(assumed: state wear.coating_thickness)", done.stdout)

    def test_equal_jumps_that_are_too_long_are_noted(self):
        topics = lambda more: [note["topic"] for note in self.worn(more)["notes"]]
        self.assertIn("jumps-few", topics("jumps = 1\n"))
        self.assertNotIn("jumps-few", topics("jumps = 16\n"))

    def test_the_ring_turned_over_wears_otherwise(self):
        last = self.worn('orientations = "both"\n')["states"][-1]
        self.assertNotIn("turned", self.worn()["states"][-1])
        self.assertGreater(last["turned"]["worn_area"], 0)
        self.assertIn("mean_power_loss", last["turned"])

    def test_the_surface_follows_the_path(self):
        states = '[[state]]\nhours = "0 h"\ncase = "case.toml"\n[[state]]\nhours = "10 h"\ncase = "worn.toml"\n'
        reported = self.worn(f'surface = "path"\n{states}')
        self.assertLess(reported["states"][-1]["roughness"], reported["states"][0]["roughness"])
        self.assertGreater(reported["states"][-1]["worn_area"], 0)

    def test_a_scenario_is_compared_with_the_measured_faces(self):
        states = '[[state]]\nhours = "0 h"\ncase = "case.toml"\n[[state]]\nhours = "4 h"\ncase = "worn.toml"\n'
        reported = self.worn(f'surface = "path"\n{states}')
        first, last = reported["states"][0], reported["states"][-1]
        self.assertEqual([row["half_width"] for row in first["measured_face_distance"]], [0.5e-3, 0.3e-3])
        self.assertLess(first["measured_face_distance"][0]["rms"], 1e-9)
        self.assertGreater(last["measured_face_distance"][0]["rms"], 0.1e-6)
        low, high = reported["wear"]["implied_coefficient"]
        self.assertLess(low, high)

    def test_a_spread_of_tilt_wears_a_wider_zone(self):
        level, tilted = self.worn(), self.worn('tilt_spread = "20 arcminute"\ntilt_samples = 4\n')
        self.assertGreater(level["states"][-1]["largest_worn_depth"], tilted["states"][-1]["largest_worn_depth"])
        self.assertLess(tilted["wear"]["volume_balance_error"], 1e-12)

    def test_the_sampling_of_the_tilt_has_converged(self):
        spread = 'tilt_spread = "20 arcminute"\njumps = 2\ntilt_samples = '
        few, many = self.worn(spread + "6\n"), self.worn(spread + "12\n")
        ratio = few["states"][-1]["worn_area"] / many["states"][-1]["worn_area"]
        self.assertAlmostEqual(ratio, 1, delta=2e-3)
        coarse = self.worn('tilt_spread = "60 arcminute"\njumps = 2\ntilt_samples = 2\n')
        self.assertIn("tilt-samples-few", [note["topic"] for note in coarse["notes"]])

    def test_the_liner_wears_along_the_stroke(self):
        reported = self.worn('liner_coefficient = "1e-18 m2/N"\n')
        depths = reported["states"][-1]["liner_worn_depth"]
        self.assertEqual(len(depths), len(reported["liner_position"]))
        self.assertEqual(max(depths), max(depths[:30]), "asperities carry most near TDC")


DUTY = """\
[duty]
repeat = 30
[[duty.segment]]
name = "idle"
duration = "10 min"
speed = "900 rpm"
peak_pressure = "12 bar"
[[duty.segment]]
name = "full load"
duration = "30 min"
speed = "3000 rpm"
oil_temperature = "130 degC"
"""


class Duty(LifeTest):
    def test_means_are_weighted_by_time_and_by_cycles(self):
        (self.folder / "life.toml").write_text(LIFE + DUTY)
        state = self.life()["states"][1]
        idle, full = state["points"]
        self.assertAlmostEqual(idle["share"], 0.25)
        power = 0.25 * idle["mean_power_loss"] + 0.75 * full["mean_power_loss"]
        self.assertAlmostEqual(state["mean_power_loss"] / power, 1, delta=1e-12)
        cycles = (0.25 * 900, 0.75 * 3000)
        fmep = (cycles[0] * idle["fmep"] + cycles[1] * full["fmep"]) / sum(cycles)
        self.assertAlmostEqual(state["fmep"] / fmep, 1, delta=1e-12)
        self.assertEqual(state["min_film_thickness"], min(idle["min_film_thickness"], full["min_film_thickness"]))

    def test_a_point_is_the_case_with_its_values(self):
        (self.folder / "life.toml").write_text(LIFE + DUTY)
        full = self.life()["states"][0]["points"][1]
        settings = ("--set", "operating.speed=3000 rpm", "--set", "operating.oil_temperature=130 degC")
        alone = json.loads(self.run_well("run", "case.toml", "--json", *settings))
        self.assertEqual(full["mean_power_loss"], alone["mean_power_loss"])

    def test_points_with_weights_and_another_gas_model(self):
        points = """\
[[duty.point]]
name = "a"
weight = 1
[[duty.point]]
name = "b"
weight = 3
speed = "2000 rpm"
set = { "gas.model" = "wiebe", "gas.peak_pressure" = "50 bar" }
"""
        (self.folder / "life.toml").write_text(LIFE + points)
        self.assertEqual([point["share"] for point in self.life()["states"][0]["points"]], [0.25, 0.75])

    def test_wear_is_the_mean_of_the_points(self):
        """A point of which half the time is spent at the same conditions changes nothing."""
        (self.folder / "archard.toml").write_text(ARCHARD + "jumps = 2\n")
        alone = self.life("archard.toml")["states"][-1]["worn_area"]
        halves = '[[duty.point]]\nname = "a"\nweight = 1\n[[duty.point]]\nname = "b"\nweight = 1\n'
        (self.folder / "archard.toml").write_text(ARCHARD + "jumps = 2\n" + halves)
        self.assertAlmostEqual(self.life("archard.toml")["states"][-1]["worn_area"] / alone, 1, delta=1e-9)

    def test_refusals(self):
        for old, new, fragment in (
            ('"10 min"', '"0 min"', "is not above 0"),
            ('duration = "10 min"\n', "", "[[duty.segment]] has no duration"),
            ("repeat = 30", "repeat = 3", "the running time 10 h is after the end of the duty, 2 h"),
            ('"12 bar"', '"0.5 bar"', "is not above the least pressure of the trace"),
            ('"900 rpm"', '"900"', "has no unit"),
            ('name = "full load"', 'name = "idle"', "two operating points have the name idle"),
        ):
            with self.subTest(fragment):
                self.refused(LIFE + DUTY.replace(old, new), "life.toml", fragment)
        self.refused(LIFE + "[duty]\n", "[duty] has neither segments nor points")


class Faces(LifeTest):
    def test_bounds_of_the_three_rings(self):
        """Bounds of another program on a grid of its own; docs/theory/life.md."""
        rings = [
            str(program.SOURCES / "cases" / "styles2014" / f"{ring}.toml") for ring in ("new", "run-in", "embedded")
        ]
        reported = json.loads(self.run_well("life", "faces", *rings, "--json"))
        self.assertEqual([pair["later"] for pair in reported["pairs"]], ["run-in", "embedded", "embedded"])
        for pair, depth in zip(reported["pairs"], (16.8, 3.0, 19.3), strict=True):
            self.assertAlmostEqual(pair["tilted"][0]["depth_at_middle"] * 1e6, depth, delta=0.08)
        self.assertEqual([len(face["concave"]) for face in reported["faces"]], [0, 1, 1])

    def test_refusals(self):
        self.assert_refused(self.run_program("life", "faces", "case.toml"), "wear is a difference of faces")
        narrow = program.CASE.replace('face_width = "1.2 mm"', 'face_width = "1.0 mm"')
        (self.folder / "narrow.toml").write_text(narrow)
        self.assert_refused(self.run_program("life", "faces", "case.toml", "narrow.toml"), "1 mm wide")


class Refusals(LifeTest):
    def test_wear_without_a_coefficient(self):
        self.refused(ARCHARD.replace("coefficient", "jumps").replace('"4e-18 m2/N"', "3"), "[wear] has no coefficient")

    def test_a_coefficient_beyond_any_metal(self):
        for text in ("1e300", "4e-8"):
            self.refused(ARCHARD.replace("4e-18", text), "is above 1e-09 m2/N", "1/(3H)")
        self.refused(ARCHARD.replace("4e-18", "nan"), "is not a finite number")
        self.refused(ARCHARD.replace('"4e-18 m2/N"', '""'), "does not start with a number")

    def test_edges_that_are_none(self):
        self.refused(ARCHARD + "edge_factor = 1e30\n", "wear.edge_factor = 1e+30 is not from 0.001 to 1000")
        self.refused(ARCHARD + 'edge_factor = 10\nedge_distance = "5 mm"\n', "5 mm from the middle of a face")

    def test_hours_beyond_a_century(self):
        self.refused(ARCHARD.replace('"4 h"', '"1e300 h"'), "the running time 1e+300 h is more than a century")

    def test_a_datum_of_a_scenario(self):
        self.refused(ARCHARD + '[path]\ndatum = "common"\n', "path.datum means nothing")

    def test_a_coefficient_below_zero(self):
        self.refused(ARCHARD.replace("4e-18", "-4e-18"), "wear.coefficient", "is not above 0")

    def test_jumps_below_the_size_of_an_atom(self):
        self.refused(ARCHARD + 'largest_depth = "1e-9 um"\n', 'wear.largest_depth = "1e-9 um" is below 1 nm')
        self.refused(ARCHARD + 'jump_error = "1e-9 um"\n', 'wear.jump_error = "1e-9 um" is below 0.1 nm')

    def test_durations_beyond_a_century(self):
        segment = '[[duty.segment]]\nname = "a"\nduration = "1e300 h"\n'
        self.refused(ARCHARD + segment, 'duty.segment.duration = "1e300 h" is more than a century')

    def test_equal_jumps_and_their_error(self):
        self.refused(ARCHARD + 'jumps = 4\njump_error = "0.01 um"\n', "wear.jump_error means nothing with jumps")

    def test_wear_in_a_path(self):
        self.refused(LIFE + '[wear]\ncoefficient = "4e-18 m2/N"\n', '[wear] means nothing with mode = "measured-path"')

    def test_states_of_a_frozen_surface(self):
        state = '[[state]]\nhours = "0 h"\ncase = "case.toml"\n'
        self.refused(ARCHARD + state, '[[state]] means nothing with wear.surface = "frozen"')

    def test_states_out_of_order(self):
        self.refused(LIFE.replace('"10 h"\ncase', '"-1 h"\ncase'), "life.toml:8:9", "is before the start of the life")

    def test_a_state_without_hours(self):
        self.refused(LIFE.replace('hours = "10 h"\n', ""), "[[state]] has no hours")

    def test_hours_without_a_unit(self):
        self.refused(LIFE.replace('"2 h"', "2"), "life.toml:3:17: hours = 2 has no unit", 'for example "10 h"')

    def test_an_unknown_key(self):
        self.refused(LIFE.replace("hours = [", "hour = ["), "unknown key hour", "did you mean hours?")

    def test_a_time_constant_of_zero(self):
        self.refused(LIFE + '[path]\ntime_constant = "0 h"\n', 'path.time_constant = "0 h" is not above 0')

    def test_an_output_that_is_an_input(self):
        done = self.run_program("life", "life.toml", "--output", "life.toml")
        self.assert_refused(done, "life.toml")


if __name__ == "__main__":
    unittest.main(verbosity=2)
