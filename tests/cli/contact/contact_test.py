"""The contact law of measured pairs: `ringfilm contact` on maps with known answers. Every map is made here."""

import json
import math
import random
import re
import unittest

import program

POINTS = 256
LENGTH = 256e-6  # [m], of the wave and of the map
STEP = LENGTH / POINTS
AMPLITUDE = 1e-6
E_STAR = 67.4e9
FULL = math.pi * E_STAR * AMPLITUDE / LENGTH  # mean pressure that closes the wave, per unit of its wave length
MODULUS = ("--composite-modulus", "134.8 GPa")


def matrix_text(rows):
    return "".join(",".join("" if z is None else f"{1e6 * z:.12g}" for z in row) + "\n" for row in rows)


def map_text(height, columns=POINTS, rows=8):
    return matrix_text([[height(i, j) for i in range(columns)] for j in range(rows)])


def wave(i, j):
    return AMPLITUDE * math.cos(2 * math.pi * i / POINTS)


def rough(columns, rows, seed, waves=40):
    """A sum of random periodic waves of rms 0.5 um."""
    random.seed(seed)
    parts = [(random.randint(1, 10), random.randint(0, 10), random.uniform(0, 2 * math.pi)) for _ in range(waves)]

    def height(i, j):
        total = sum(math.cos(2 * math.pi * (a * i / columns + b * j / rows) + phase) for a, b, phase in parts)
        return 0.5e-6 * total * math.sqrt(2 / waves)

    return map_text(height, columns, rows)


class ContactTest(program.ProgramTest):
    STATED = ("--unit", "um", "--step-x", f"{1e6 * STEP} um", "--layout", "matrix")

    def setUp(self):
        super().setUp()
        (self.folder / "wave.csv").write_text(map_text(wave))
        (self.folder / "ring.csv").write_text(rough(64, 48, 1))
        (self.folder / "liner.csv").write_text(rough(64, 48, 2))

    def json_of(self, *words):
        return json.loads(self.run_well("contact", *words, *self.STATED, *MODULUS, "--json"))

    def refused(self, *words):
        result = self.run_program("contact", *words, *self.STATED)
        self.assertEqual(result.returncode, 2, result.stderr)
        return result.stderr


class Numbers(ContactTest):
    def test_a_wave_carries_what_westergaard_found(self):
        shares = (0.5, 0.2, 0.05)
        separations = [AMPLITUDE * (1 - p + p * math.log(p)) for p in shares]
        text = ", ".join(f"{1e9 * h:.9f} nm" for h in separations)
        of = self.json_of("--surface", "wave.csv", "--periodic", "--separations", text)
        for k, share in enumerate(shares):
            self.assertAlmostEqual(of["separation"][k] / separations[k], 1, delta=1e-9)
            self.assertAlmostEqual(of["contact_pressure"][k] / (share * FULL), 1, delta=2e-3)
            self.assertAlmostEqual(of["real_area"][k], 2 / math.pi * math.asin(math.sqrt(share)), delta=1 / POINTS)
            self.assertEqual(of["share_at_cap"][k], 0)
            self.assertAlmostEqual(of["mean_gap"][k] / separations[k], 1, delta=1e-6)  # no material vanishes
        self.assertLess(of["complementarity_residual"], 1e-6)

    def test_a_soft_wave_flows_all_over(self):
        hardness = f"{0.1e-9 * FULL:.12g} GPa"
        words = ("--surface", "wave.csv", "--periodic", "--hardness", hardness, "--separations", "0.5 um")
        of = self.json_of(*words)
        self.assertAlmostEqual(of["real_area"][0], 0.3250226, delta=1.5 / POINTS)
        self.assertAlmostEqual(of["contact_pressure"][0] / (0.1 * FULL), 0.3250226, delta=1.5 / POINTS)
        self.assertGreater(of["share_at_cap"][0], 0.97)
        self.assertGreater(of["mean_gap"][0], 0.5e-6)  # material that is pressed away vanishes

    def test_two_surfaces_are_their_sum(self):
        (self.folder / "half.csv").write_text(map_text(lambda i, j: wave(i, j) / 2))
        of = self.json_of("--surface", "half.csv", "--surface", "half.csv", "--periodic", "--separations", "0.4781 um")
        whole = self.json_of("--surface", "wave.csv", "--periodic", "--separations", "0.4781 um")
        self.assertAlmostEqual(of["contact_pressure"][0] / whole["contact_pressure"][0], 1, delta=1e-6)

    def test_a_wave_along_y_is_one_along_x(self):
        (self.folder / "turned.csv").write_text(map_text(lambda i, j: wave(j, i), 8, POINTS))
        separations = ("--periodic", "--separations", "0.5 um")
        turned = self.json_of("--surface", "turned.csv", *separations)
        along = self.json_of("--surface", "wave.csv", *separations)
        for name in ("contact_pressure", "real_area", "mean_gap"):
            self.assertAlmostEqual(turned[name][0] / along[name][0], 1, delta=1e-9)

    def test_relative_positions_have_a_scatter(self):
        pair = ("--surface", "ring.csv", "--surface", "liner.csv", "--hardness", "2.5 GPa")
        one = self.json_of(*pair, "--separations", "0.9 um")
        self.assertTrue(any("--shifts" in note for note in one["notes"]))
        several = self.json_of(*pair, "--separations", "0.9 um", "--shifts", "4")
        self.assertEqual(several["relative_positions"], 4)
        self.assertNotIn("contact_pressure_deviation", one)  # one position has no scatter
        self.assertGreater(several["contact_pressure_deviation"][0], 0)

    def test_without_separations_a_table_from_the_highest_point_down(self):
        of = self.json_of("--surface", "ring.csv", "--hardness", "2.5 GPa", "-o", "law.nc", "--html", "law.html")
        self.assertGreaterEqual(len(of["separation"]), 6)
        self.assertLess(of["separation"][0], of["highest_point"])
        self.assertEqual(of["separation"], sorted(of["separation"], reverse=True))
        self.assertEqual(of["contact_pressure"], sorted(of["contact_pressure"]))
        self.assertLess(max(of["real_area"]), 0.34)
        self.assertTrue((self.folder / "law.nc").exists())
        page = (self.folder / "law.html").read_text()
        self.assertIn("Contact map", page)
        heads = re.search(r'"key_values":\[([^]]*)\]', page).group(1)
        self.assertEqual(heads, '"composite_roughness","highest_point","last_supported_separation"')  # no input

    def test_maps_are_levelled_unless_they_repeat(self):
        (self.folder / "tilted.csv").write_text(map_text(lambda i, j: wave(i, j) / 4 + 1e-9 * j, POINTS, 64))
        of = self.json_of("--surface", "tilted.csv", "--separations", "0.1 um")
        self.assertTrue(any("plane" in line for line in of["statements"]))
        of = self.json_of("--surface", "tilted.csv", "--separations", "0.1 um", "--periodic")
        self.assertFalse(any("plane" in line and "least" in line for line in of["statements"]))


class FlowFactors(ContactTest):
    def test_a_wavy_gap_has_the_factors_of_its_closed_forms(self):
        e = 0.6
        words = ("--surface", "wave.csv", "--periodic", "--flow-factors", "--separations", f"{1 / e} um")
        of = self.json_of(*words)
        self.assertEqual((of["contact_pressure"], of["real_area"]), ([0], [0]))
        self.assertAlmostEqual(of["phi_x"][0], (1 - e * e) ** 2.5 / (1 + e * e / 2), delta=1e-5)
        self.assertAlmostEqual(of["phi_y"][0], 1 + 1.5 * e * e, delta=1e-5)
        couette = (1 - e * e) / (1 + e * e / 2)  # 2 Q/(U h)
        self.assertAlmostEqual(of["phi_s"][0], (1 - couette) / e * math.sqrt(2), delta=1e-3)

    def test_two_walls_alike_have_no_shear_flow(self):
        words = ("--surface", "ring.csv", "--surface", "ring.csv", "--flow-factors", "--separations", "3 um")
        self.assertAlmostEqual(self.json_of(*words)["phi_s"][0], 0, delta=1e-12)

    def test_maps_of_unequal_steps_are_interpolated_with_a_note(self):
        coarse = [[wave(2 * i, j) / 4 for i in range(POINTS // 2)] for j in range(8)]
        (self.folder / "coarse.csv").write_text(matrix_text(coarse))
        (self.folder / "fine.csv").write_text(map_text(lambda i, j: wave(i, j) / 4, rows=16))
        self.run_well(
            "surface", "coarse.csv", "--unit", "um", "--step-x", "2 um", "--layout", "matrix", "--heights", "c.csv"
        )
        self.run_well(
            "surface", "fine.csv", "--unit", "um", "--step-x", "1 um", "--layout", "matrix", "--heights", "f.csv"
        )
        words = ("--separations", "0.2 um", *MODULUS, "--json", "--form", "mean")
        of = json.loads(self.run_well("contact", "--surface", "c.csv", "--surface", "f.csv", *words))
        self.assertTrue(any("interpolated to 1 um" in note for note in of["notes"]), of["notes"])
        same = json.loads(self.run_well("contact", "--surface", "f.csv", "--surface", "f.csv", *words))
        self.assertAlmostEqual(of["contact_pressure"][0] / same["contact_pressure"][0], 1, delta=1e-2)
        result = self.run_program("contact", "--surface", "c.csv", "--surface", "f.csv", *MODULUS, "--periodic")
        self.assertEqual(result.returncode, 2)
        self.assertIn("steps of the two maps differ", result.stderr)

    def test_scatter_is_over_positions_regions_and_cutoffs(self):
        for name, seed in (("ring.csv", 1), ("liner.csv", 2)):
            (self.folder / name).write_text(rough(96, 96, seed, 60))
        pair = ("--surface", "ring.csv", "--surface", "liner.csv", "--hardness", "2.5 GPa")
        of = self.json_of(*pair, "--shifts", "3", "--grid", "2x2", "--short-cutoff", "5 um")
        self.assertEqual(of["law_samples"], 3 + 4 - 1)
        self.assertGreater(of["shift_deviation"], 0)
        self.assertLessEqual(abs(of["shift_pressure_correlation"]), 1)
        middle = len(of["separation"]) // 2
        self.assertGreater(of["contact_pressure_deviation_of_regions"][middle], 0)
        self.assertLess(of["pressure_ratio_twice_cutoff"][middle], 1)
        self.assertGreater(of["pressure_ratio_half_cutoff"][middle], 0.99)
        of = self.json_of(*pair)
        self.assertNotIn("shift_deviation", of)
        self.assertNotIn("pressure_ratio_half_cutoff", of)


class LawOfACase(ContactTest):
    PAIR = ("contact.summit_plane=nayak",)

    def case_json(self, *settings, ratios="1,1.286,2,3"):
        words = [word for setting in settings for word in ("--set", setting)]
        return json.loads(self.run_well("contact", "--case", "case.toml", "--lambda", ratios, *words, "--json"))

    def setUp(self):
        super().setUp()
        self.modulus = "contact.composite_modulus='134.8 GPa'"

    def test_that_of_the_paper_is_greenwood_and_tripp_with_its_validity(self):
        of = self.case_json(self.modulus)
        for got, expected in zip(of["separation"], (0.48e-6, 0.61728e-6, 0.96e-6, 1.44e-6)):
            self.assertAlmostEqual(got / expected, 1, delta=1e-12)
        self.assertAlmostEqual(of["contact_pressure"][1], 37.424423e6, delta=10)
        self.assertAlmostEqual(of["real_area"][1], 0.002025883, delta=1e-9)
        self.assertAlmostEqual(
            of["mean_real_pressure"][1] * of["real_area"][1] / of["contact_pressure"][1], 1, delta=1e-12
        )
        self.assertAlmostEqual(of["plasticity_index"], 14.68, delta=0.01)
        self.assertAlmostEqual(of["slope_index"], 9.13, delta=0.01)
        self.assertAlmostEqual(of["summit_offset_ratio"], 0.6325, delta=1e-4)
        self.assertAlmostEqual(of["summit_plane_offset"], 0.6325 * 0.48e-6, delta=1e-10)

    def test_other_laws_carry_what_their_formulas_state(self):
        of = self.case_json(self.modulus, "contact.model=greenwood-williamson", "contact.summit_plane=nayak")
        self.assertAlmostEqual(of["contact_pressure"][1] / 486.86444e6, 1, delta=1e-4)
        self.assertAlmostEqual(of["real_area"][1] / 0.03263409, 1, delta=1e-4)
        pairs = self.case_json(self.modulus, "contact.summit_plane=nayak", "contact.moments=one-surface")
        for got, expected in zip(pairs["contact_pressure"], (729e6, 416e6, 81.3e6, 4.37e6)):
            self.assertAlmostEqual(got / expected, 1, delta=5e-3)
        hardness = "contact.hardness='2.5 GPa'"
        plastic = self.case_json("contact.model=plastic", hardness)
        for ratio, share in zip(plastic["lambda_ratio"], plastic["real_area"]):
            self.assertAlmostEqual(share / (0.5 * math.erfc(ratio / math.sqrt(2))), 1, delta=1e-4)

    def test_laws_that_flow_need_the_hardness(self):
        words = ("--case", "case.toml", "--set", "contact.asperity=jackson-green")
        result = self.run_program("contact", *words)
        self.assertEqual(result.returncode, 2)
        self.assertIn("contact.hardness is missing", result.stderr)

    def test_a_case_has_its_own_surfaces(self):
        self.assertIn("its own surfaces", self.refused("--case", "case.toml", "--surface", "wave.csv"))


class TableInACase(ContactTest):
    def setUp(self):
        super().setUp()
        for name, seed in (("ring.csv", 1), ("liner.csv", 2)):
            (self.folder / name).write_text(rough(128, 128, seed, 60))
        pair = ("--surface", "ring.csv", "--surface", "liner.csv", "--hardness", "2.5 GPa", "-o", "law.nc")
        self.law = self.json_of(*pair)
        text = (self.folder / "case.toml").read_text()
        lines = [line for line in text.splitlines() if not line.startswith(("asperity_", "roughness"))]
        (self.folder / "case.toml").write_text(
            "\n".join(lines).replace("[contact]", '[contact]\nmodel = "table"\nlaw = "law.nc"') + "\n"
        )

    def test_the_ring_runs_with_it_and_meets_its_rows(self):
        sigma = self.law["composite_roughness"]
        ratios = [h / sigma for h in self.law["separation"] if h <= self.law["last_supported_separation"]]
        of = json.loads(
            self.run_well("contact", "--case", "case.toml", "--lambda", ",".join(map(repr, ratios)), "--json")
        )
        rows = dict(zip(self.law["separation"], self.law["contact_pressure"]))
        for h, p in zip(of["separation"], of["contact_pressure"]):
            nearest = min(rows, key=lambda row: abs(row - h))
            self.assertAlmostEqual(p / rows[nearest], 1, delta=1e-3)
        run = json.loads(self.run_well("run", "case.toml", "--json"))
        self.assertGreater(run["mean_power_loss"], 0)
        self.assertNotIn("plasticity_index", run)

    def test_the_film_takes_the_flow_through_the_same_gap(self):
        measured = ("flow_factors", "shear_flow", "stress_factors", "average_gap")
        settings = [word for name in measured for word in ("--set", f"film.{name}=measured")]
        result = self.run_program("run", "case.toml", *settings)
        self.assertEqual(result.returncode, 2)
        self.assertIn("contact.law has no flow factors", result.stderr)
        pair = ("--surface", "ring.csv", "--surface", "liner.csv", "--hardness", "2.5 GPa", "--flow-factors")
        law = self.json_of(*pair, "-o", "law.nc")
        self.assertGreater(law["separation"][0], 1.9 * law["highest_point"])
        smooth = json.loads(self.run_well("run", "case.toml", "--json"))
        rough_film = json.loads(self.run_well("run", "case.toml", "--json", *settings))
        ratio = rough_film["mean_power_loss"] / smooth["mean_power_loss"]
        self.assertTrue(0.5 < ratio < 1.5 and abs(ratio - 1) > 1e-3, ratio)
        result = self.run_program("run", "case.toml", *settings, "--set", "contact.eyring_shear_stress='0 Pa'")
        self.assertEqual(result.returncode, 2)
        self.assertIn("eyring_shear_stress above 0", result.stderr)

    def test_the_law_moves_and_scales(self):
        ratio = ("--lambda", "1.5", "--json")
        plain = json.loads(self.run_well("contact", "--case", "case.toml", *ratio))
        scaled = json.loads(self.run_well("contact", "--case", "case.toml", *ratio, "--set", "contact.law_factor=1.5"))
        self.assertAlmostEqual(scaled["contact_pressure"][0] / plain["contact_pressure"][0], 1.5, delta=1e-6)
        moved = json.loads(
            self.run_well("contact", "--case", "case.toml", *ratio, "--set", "contact.law_shift='20 nm'")
        )
        self.assertGreater(moved["contact_pressure"][0], plain["contact_pressure"][0])

    def test_other_files_are_refused(self):
        self.run_well("surface", "ring.csv", *self.STATED, "-o", "surface.nc")
        for name, message in (
            ("surface.nc", "not a contact law"),
            ("ring.csv", "ring.csv"),
            ("none.nc", "no such file"),
        ):
            result = self.run_program("run", "case.toml", "--set", f"contact.law={name}")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(message, result.stderr)
        self.run_well("contact", "--case", "case.toml", "-o", "of_case.nc")
        for name, command in (("surface.nc", "surface"), ("of_case.nc", "contact")):
            result = self.run_program("report", name, "-o", "page.html")
            self.assert_refused(result, f"{name}: a measurement by ringfilm {command}", "writes its page with --html")
        (self.folder / "cut.nc").write_bytes((self.folder / "surface.nc").read_bytes()[:-200])
        result = self.run_program("run", "case.toml", "--set", "contact.law=cut.nc")
        self.assert_refused(result, "contact.law: cut.nc: the file does not end with the SHA-256 digest")
        result = self.run_program("run", "case.toml", "--set", "contact.law=")
        self.assertEqual(result.returncode, 2)
        self.assertIn("contact.law", result.stderr)


class BoundaryFriction(ContactTest):
    def test_the_library_lists_dry_and_lubricated_pairs(self):
        pairs = {pair["name"]: pair for pair in json.loads(self.run_well("pairs", "--json"))["pairs"]}
        crn = pairs["crn-on-grey-iron"]
        self.assertEqual((crn["state"], crn["friction"], crn["hardness"]), ("lubricated", 0.12, 2.5e9))
        self.assertTrue(crn["friction_low"] < crn["friction"] < crn["friction_high"])
        self.assertEqual(pairs["styles2014-new-dry"]["state"], "dry")
        self.assertTrue(all(pair["source"] for pair in pairs.values()))
        self.assertIn("crn-on-grey-iron", self.run_well("pairs"))

    def test_the_library_lists_liners_and_rings_in_their_states(self):
        library = json.loads(self.run_well("pairs", "--json"))
        self.assertEqual(list(library), ["pairs", "liners", "rings"])
        liners = {(liner["name"], liner["state"]): liner for liner in library["liners"]}
        rings = {(ring["name"], ring["state"]): ring for ring in library["rings"]}
        self.assertAlmostEqual(liners["plateau-honed-grey-iron", "run-in"]["Rpq"], 0.08e-6, delta=1e-12)
        self.assertAlmostEqual(rings["nitrided", "worn"]["roughness"], 0.07e-6, delta=1e-12)
        for liner in liners.values():
            self.assertTrue(0 < liner["Rpq"] < liner["Rvq"] and 0 < liner["Rmq"] < 1 and liner["source"], liner)
        for name, state in (*liners, *rings):  # what wears gets smoother
            values, key = (liners, "Rpq") if (name, state) in liners else (rings, "roughness")
            if state == "worn":
                falling = [values[name, one][key] for one in ("new", "run-in", "worn")]
                self.assertEqual(falling, sorted(falling, reverse=True), name)
        shown = self.run_well("pairs")
        for words in ("liner ", "ring ", "0.07 um", "sprayed-mirror-bore", "molybdenum"):
            self.assertIn(words, shown)

    def test_a_case_takes_the_plateau_of_a_class_of_liners(self):
        liner = next(x for x in json.loads(self.run_well("pairs", "--json"))["liners"] if x["state"] == "run-in")
        text = (self.folder / "case.toml").read_text()
        lines = [line for line in text.splitlines() if not line.startswith("roughness")]
        plateau = f'[contact.plateau]\nRpq = "{liner["Rpq"]} m"\nRvq = "{liner["Rvq"]} m"\nRmq = {liner["Rmq"]}\n'
        (self.folder / "plateau.toml").write_text("\n".join(lines) + "\n" + plateau + 'ring_roughness = "0.07 um"\n')
        law = json.loads(self.run_well("contact", "--case", "plateau.toml", "--json"))
        self.assertAlmostEqual(law["Rpq"], liner["Rpq"], delta=1e-15)

    def test_a_case_takes_its_friction_from_a_pair(self):
        text = (self.folder / "case.toml").read_text()
        lines = [line for line in text.splitlines() if not line.startswith("boundary_shear_strength_coefficient")]
        text = "\n".join(lines).replace("[contact]", '[contact]\nfriction_pair = "crn-on-grey-iron"') + "\n"
        (self.folder / "pair.toml").write_text(text)
        own = json.loads(
            self.run_well("run", "case.toml", "--json", "--set", "contact.boundary_shear_strength_coefficient=0.12")
        )
        of_pair = json.loads(self.run_well("run", "pair.toml", "--json"))
        self.assertEqual(own["mean_power_loss"], of_pair["mean_power_loss"])
        law = json.loads(self.run_well("contact", "--case", "pair.toml", "--json"))
        self.assertEqual((law["hardness"], law["boundary_friction_coefficient"]), (2.5e9, 0.12))
        self.assertAlmostEqual(law["friction_at_hardness"], 0.12 + 2e6 / 2.5e9, delta=1e-12)
        dry = self.run_well("check", "pair.toml", "--all", "--set", "contact.friction_pair=styles2014-new-dry")
        self.assertIn("probe without oil", " ".join(dry.split()))
        both = ("--set", "contact.boundary_shear_strength_coefficient=0.1")
        for words, message in ((("--set", "contact.friction_pair=other"), "choose one of"), (both, "not used")):
            result = self.run_program("run", "pair.toml", *words)
            self.assertEqual(result.returncode, 2, result.stdout)
            self.assertIn(message, result.stderr)

    def test_a_law_is_written_where_a_case_reads_it_and_only_there(self):
        written = refused = 0
        for seed in range(12):  # white noise, whose contact area hardly falls from one separation to the next
            random.seed(seed)
            (self.folder / "noise.csv").write_text(map_text(lambda i, j: random.gauss(0, 1e-7), 16, 16))
            words = ("contact", "--surface", "noise.csv", *self.STATED, *MODULUS, "--periodic")
            result = self.run_program(*words, "-o", f"law{seed}.nc")
            shown = self.run_well(*words)
            self.assertEqual("does not read this law" in " ".join(shown.split()), result.returncode == 2, shown)
            if result.returncode == 2:
                refused += 1
                self.assertIn('contact.model = "table" does not read this law', result.stderr)
                self.assertFalse((self.folder / f"law{seed}.nc").exists())
            else:
                written += 1
                law = f'model = "table"\nlaw = "law{seed}.nc"\n'
                numbers = re.compile(r"asperity_density = .*\nasperity_radius = .*\nroughness = .*\n")
                (self.folder / "table.toml").write_text(numbers.sub(law, program.CASE))
                self.run_well("check", "table.toml")
        self.assertGreater(refused, 0)
        self.assertGreater(written, 0)

    def test_a_pair_writes_what_the_laws_need(self):
        for name, seed in (("ring.x3p", "1"), ("liner.x3p", "2")):
            self.run_well("synthetic", "gaussian", name, "--points", "96x96", "--seed", seed)
        pair = ("pair", "--ring", "ring.x3p", "--liner", "liner.x3p", "--form", "tilt")
        self.run_well(*pair, "--hardness", "2.5 GPa", "--fragment", "contact.toml")
        text = (self.folder / "contact.toml").read_text()
        for line in ('model = "greenwood-williamson"', 'summit_plane = "nayak"', 'hardness = "2.5 GPa"'):
            self.assertIn(line, text)
        self.assertIn("root of the sum of squares of Rq", text)
        result = self.run_program(*pair, "--hardness", "2.5 GPa", "--sigma", "Ra")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--sigma Ra and --hardness contradict", result.stderr)
        law = ("--law", "law.nc", "--shifts", "2")
        self.run_well(*pair, "--hardness", "2.5 GPa", *MODULUS, *law, "--fragment", "contact.toml")
        text = (self.folder / "contact.toml").read_text()
        for line in ('law = "law.nc"', 'flow_factors = "measured"'):
            self.assertIn(line, text)
        own = [
            line
            for line in (self.folder / "case.toml").read_text().splitlines()
            if not line.startswith(("asperity_", "roughness"))
        ]
        (self.folder / "measured.toml").write_text('include = ["contact.toml"]\n' + "\n".join(own) + "\n")
        self.run_well("run", "measured.toml")
        result = self.run_program(*pair, *law)
        self.assertEqual(result.returncode, 2)
        self.assertIn("belong together", result.stderr)


class Refusals(ContactTest):
    def test_what_cannot_be_computed_is_named(self):
        wave_at = ("--surface", "wave.csv", "--periodic", "--separations")
        self.assertIn("beyond the highest point", self.refused(*wave_at, "1.5 um", *MODULUS))
        self.assertIn("more than 50 %", self.refused(*wave_at, "1 nm", *MODULUS))
        self.assertIn("no unit", self.refused(*wave_at, "0.5", *MODULUS))
        self.assertIn("above", self.refused(*wave_at, "-0.5 um", *MODULUS))
        self.assertIn("--composite-modulus is missing", self.refused(*wave_at, "0.5 um"))
        for hardness in ("0 GPa", "-2 GPa"):
            self.assertIn("is not above 0", self.refused(*wave_at, "0.5 um", *MODULUS, "--hardness", hardness))
        for option in ("--hardness", "--composite-modulus"):
            modulus = () if option == "--composite-modulus" else MODULUS
            refused = self.refused(*wave_at, "0.5 um", *modulus, option, "2.5 kg")
            self.assertIn(f'{option} "2.5 kg" is not a pressure', refused)
            self.assertIn("\n1 error; nothing", refused)
        self.assertIn("\n2 errors; nothing", self.refused(*wave_at, "1 kg, 2 kg", *MODULUS))
        self.assertIn("contradict", self.refused(*wave_at, "0.5 um", *MODULUS, "--mirrored"))
        self.assertIn("there is one", self.refused(*wave_at, "0.5 um", *MODULUS, "--shifts", "8"))
        self.assertIn("not a count", self.refused(*wave_at, "0.5 um", *MODULUS, "--shifts", "none"))

    def test_missing_points_are_noted_and_too_many_refused(self):
        random.seed(3)
        for share, code in ((0.3, 0), (0.6, 2)):
            rows = [
                [None if random.random() < share else wave(3 * i, 5 * j) / 4 + wave(7 * j, i) / 4 for i in range(64)]
                for j in range(64)
            ]
            (self.folder / "holes.csv").write_text(matrix_text(rows))
            words = ("--surface", "holes.csv", "--separations", "0.2 um", *MODULUS, *self.STATED)
            result = self.run_program("contact", *words)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn("have no height", result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
