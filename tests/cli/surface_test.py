"""Measured surfaces: `ringfilm surface` and `ringfilm pair`, numbers, files and refusals. Every map is made here."""

import csv
import json
import math
import unittest

import program

STEP = 0.5e-6  # [m]
SIZE = 48


def wave(i, j, amplitude=0.2e-6, across=12, down=16):
    """A sum of two sines, a whole number of waves along x and y [m]."""
    return amplitude * (math.sin(2 * math.pi * i / across) + math.sin(2 * math.pi * j / down))


def heights(of=wave, size=SIZE):
    return [[of(i, j) for i in range(size)] for j in range(size)]


def matrix_text(rows):
    return "".join(",".join("" if z is None else f"{1e6 * z:.9f}" for z in row) + "\n" for row in rows)


def moments_of(rows):
    """Mean of the squares of central differences over whole waves, from the sums of sines themselves [-, 1/m2]."""

    def one(waves, amplitude):
        k = 2 * math.pi / waves
        slope = 2 / STEP * math.sin(k / 2)  # of two neighbours
        return amplitude**2 / 2 * slope**2, amplitude**2 / 2 * slope**4

    (m2_x, m4_x), (m2_y, m4_y) = one(12, 0.2e-6), one(16, 0.2e-6)
    return (m2_x + m2_y) / 2, (m4_x + m4_y) / 2


class SurfaceTest(program.ProgramTest):
    STATED = ("--unit", "um", "--step-x", "0.5 um", "--layout", "matrix")

    def setUp(self):
        super().setUp()
        (self.folder / "map.csv").write_text(matrix_text(heights()))

    def json_of(self, *words):
        return json.loads(self.run_well("surface", *words, "--json"))


class Numbers(SurfaceTest):
    def test_the_content_of_the_file_is_at_the_top_in_si(self):
        of = self.json_of("map.csv", *self.STATED)
        self.assertEqual((of["points_x"], of["points_y"], of["missing"]), (SIZE, SIZE, 0))
        self.assertAlmostEqual(of["width"], SIZE * STEP, delta=1e-18)
        self.assertAlmostEqual(of["height"], SIZE * STEP, delta=1e-18)
        self.assertAlmostEqual(of["max"], 0.4e-6, delta=1e-14)  # as far as nine digits of the file
        self.assertAlmostEqual(of["min"], -0.4e-6, delta=1e-14)
        self.assertAlmostEqual(of["Sq"], 0.2e-6, delta=1e-14)  # each sine has a mean square of a^2/2

    def test_n_and_beta_are_those_of_the_differences_of_the_sines(self):
        of = self.json_of("map.csv", *self.STATED)
        m2, m4 = moments_of(heights())
        # Complete stencils omit the rim, where the sines are not at their mean: 2 of 48 rows and columns.
        self.assertAlmostEqual(of["asperity_density"] / (m4 / m2 / (6 * math.pi * math.sqrt(3))), 1, delta=0.08)
        self.assertAlmostEqual(of["asperity_radius"] / (3 / 8 * math.sqrt(math.pi / m4)), 1, delta=0.08)
        self.assertAlmostEqual(of["roughness"], of["Sa"], delta=1e-20)

    def test_tilt_is_kept_and_reported_unless_it_is_removed(self):
        (self.folder / "tilted.csv").write_text(matrix_text(heights(lambda i, j: wave(i, j) + 2e-8 * i)))
        text = self.run_well("surface", "tilted.csv", *self.STATED)
        self.assertIn("tilt was left in", text)
        as_read = self.json_of("tilted.csv", *self.STATED)
        level = self.json_of("tilted.csv", *self.STATED, "--form", "tilt")
        self.assertGreater(as_read["Sq"], 0.3e-6)
        self.assertAlmostEqual(level["Sq"], 0.2e-6, delta=0.01e-6)  # the sines lean a little too
        self.assertEqual(level["max"], as_read["max"])  # of the file, whatever was removed

    def test_half_of_a_wave_at_the_cut_off_passes(self):
        (self.folder / "one.csv").write_text(matrix_text(heights(lambda i, j: 1e-6 * math.cos(2 * math.pi * i / 12))))
        all_of_it = self.json_of("one.csv", *self.STATED)
        half = self.json_of("one.csv", *self.STATED, "--short-cutoff", "6 um")  # 12 steps of 0.5 um
        self.assertAlmostEqual(half["Sq"] / all_of_it["Sq"], 0.5, delta=0.02)  # the ends are renormalised

    def test_missing_points_stay_missing_and_are_no_zeros(self):
        rows = heights(lambda i, j: 5e-6 + wave(i, j))
        for j, i in [(3, 3), (10, 20), (10, 21)]:
            rows[j][i] = None
        (self.folder / "holes.csv").write_text(matrix_text(rows))
        of = self.json_of("holes.csv", *self.STATED, "--heights", "out.csv")
        self.assertEqual(of["missing"], 3)
        self.assertGreater(of["min"], 4e-6)
        with open(self.folder / "out.csv", newline="") as file:
            read = list(csv.DictReader(file))
        self.assertEqual(len(read), SIZE * SIZE)
        self.assertEqual([row["z [m]"] for row in read].count(""), 3)
        self.assertEqual(read[3 * SIZE + 3]["z [m]"], "")
        self.assertAlmostEqual(float(read[3 * SIZE + 4]["z [m]"]), rows[3][4], delta=1e-14)
        self.assertAlmostEqual(float(read[3 * SIZE + 4]["x [m]"]), 4 * STEP, delta=1e-18)
        self.assertAlmostEqual(float(read[3 * SIZE + 4]["y [m]"]), 3 * STEP, delta=1e-18)

    def test_heights_that_were_written_are_read_again_without_options(self):
        self.assertIn("wrote out.csv", self.run_well("surface", "map.csv", *self.STATED, "--heights", "out.csv"))
        again = self.json_of("out.csv")
        first = self.json_of("map.csv", *self.STATED)
        for name in ("points_x", "points_y", "missing", "min", "max", "Sq"):
            self.assertEqual(again[name], first[name], name)
        self.assertAlmostEqual(again["width"], first["width"], delta=1e-15)

    def test_a_small_map_has_the_values_that_it_allows(self):
        (self.folder / "tiny.csv").write_text("1,2,3,4\n2,3,1,5\n1,1,2,2\n")
        of = self.json_of("tiny.csv", *self.STATED)
        self.assertEqual((of["points_x"], of["points_y"]), (4, 3))
        self.assertIn("Sq", of)
        self.assertNotIn("asperity_density", of)
        self.assertTrue(any("no N, beta and sigma" in note for note in of["notes"]))

    def test_regions_give_a_mean_with_its_error(self):
        rough = heights(lambda i, j: wave(i, j, 0.2e-6 + 2e-9 * i, 12 + j // 24))
        (self.folder / "rough.csv").write_text(matrix_text(rough))
        of = self.json_of("rough.csv", *self.STATED, "--grid", "2x2")
        self.assertGreater(of["values"]["asperity_density"]["standard_error"], 0)
        self.assertEqual(len(of["tables"]["regions"]["row_labels"]), 4)
        self.assertFalse(any("overlap" in note for note in of["notes"]))
        of = self.json_of("rough.csv", *self.STATED, "--grid", "2x2", "--region", "8, 8, 8, 8 um")
        self.assertTrue(any("overlap" in note for note in of["notes"]))

    def test_files_of_one_surface_give_a_mean_and_a_covariance(self):
        (self.folder / "other.csv").write_text(matrix_text(heights(lambda i, j: wave(i, j, 0.3e-6))))
        both = self.json_of("map.csv", "other.csv", *self.STATED)
        one, other = self.json_of("map.csv", *self.STATED), self.json_of("other.csv", *self.STATED)
        self.assertAlmostEqual(both["roughness"], (one["roughness"] + other["roughness"]) / 2, delta=1e-14)
        # N does not depend on the amplitude; ln sigma differs by ln 1.5: a variance of half its square.
        covariance = both["tables"]["covariance"]["columns"]
        self.assertAlmostEqual(covariance["covariance_with_roughness"]["values"][2], math.log(1.5) ** 2 / 2, delta=1e-7)
        self.assertAlmostEqual(covariance["covariance_with_asperity_density"]["values"][0], 0, delta=1e-7)

    def test_rz_of_a_profile_is_the_mean_over_its_sampling_lengths(self):
        # Five waves of 40 points, 1 to 5 um from pit to peak: a fifth of the profile each.
        heights = [(1 + i // 40) / 2 * math.sin(math.pi * (i + 0.5) / 20) for i in range(200)]
        (self.folder / "trace.csv").write_text("".join(f"{0.5 * i},{z:.9f}\n" for i, z in enumerate(heights)))
        stated = ("trace.csv", "--layout", "profile", "--unit", "um", "--lateral-unit", "um")
        of = self.json_of(*stated)
        rounding = 1 - math.cos(math.pi / 40)  # by which the points next to a crest lie below it
        self.assertAlmostEqual(of["Rz"], 3e-6 * (1 - rounding), delta=1e-14)
        self.assertAlmostEqual(of["Rt"], 5e-6 * (1 - rounding), delta=1e-14)
        self.assertEqual(of["sampling_lengths"], 5)
        self.assertAlmostEqual(of["sampling_length"], 20e-6, delta=1e-18)
        self.assertIn("mean of 5 sampling lengths of 20 um", of["values"]["Rz"]["remark"])
        of = self.json_of(*stated, "--long-cutoff", "40 um")
        self.assertEqual(of["sampling_lengths"], 2)
        self.assertAlmostEqual(of["sampling_length"], 40e-6, delta=1e-18)

    def test_slopes_at_an_angle_and_cavities_of_a_depth(self):
        of = self.json_of("map.csv", *self.STATED, "--angle", "90 deg", "--cavity-depth", "0.39 um")
        self.assertAlmostEqual(of["m2_at_angle"] / of["m2_y"], 1, delta=0.02)  # another set of complete stencils
        deep = sum(z < -0.39e-6 for row in heights() for z in row) / SIZE**2  # the median of the sines is 0
        self.assertAlmostEqual(of["cavity_area_share"], deep, delta=1e-3)


class Files(SurfaceTest):
    def test_netcdf_and_page_appear_beside_the_table(self):
        self.run_well("surface", "map.csv", *self.STATED, "--output", "map.nc", "--html", "map.html")
        self.assertEqual((self.folder / "map.nc").read_bytes()[:4], b"\x89HDF")
        self.assertIn("<html", (self.folder / "map.html").read_text())

    def test_the_fragment_of_a_pair_is_read_by_a_case(self):
        (self.folder / "other.csv").write_text(matrix_text(heights(lambda i, j: wave(j, i, 0.1e-6))))
        self.run_well(
            "pair",
            "--ring",
            "map.csv",
            "--liner",
            "map.csv",
            "other.csv",
            *self.STATED,
            "--grid",
            "2x2",
            "--fragment",
            "contact.toml",
        )
        lines = program.CASE.splitlines()
        begin, end = lines.index("[contact]"), lines.index("[lubricant]")
        case = [
            'include = ["contact.toml"]',
            *lines[:begin],
            "[contact]",
            "boundary_shear_strength_coefficient = 0.3581",
            *lines[end:],
        ]
        (self.folder / "case.toml").write_text("\n".join(case) + "\n")
        self.run_well("check", "case.toml")
        shown = self.run_well("run", "case.toml", "--json")
        self.assertIn("min_film_thickness", shown)


def uneven(i, j):
    """Heights without any order, 0.6 um at the most [m]."""
    return 0.3e-6 * (math.sin(1.7 * i * i + j) + math.cos(2.3 * j * j + 0.9 * i))


class StandardSurfaces(SurfaceTest):
    def test_each_value_of_the_s_f_and_s_l_surface_has_its_settings(self):
        # Waves of 6 and 8 um: an S-index of 2 um, the smallest of three steps of 0.5 um, keeps 93 and 96 % of them.
        found = self.json_of("map.csv", *self.STATED)
        passed = [2 ** -((2 / wave) ** 2) for wave in (6, 8)]
        expected = 0.2e-6 * math.sqrt((passed[0] ** 2 + passed[1] ** 2) / 2)
        self.assertAlmostEqual(found["SF_Sq"] / expected, 1, delta=0.05)  # edges of three and four waves
        self.assertLess(found["SL_Sq"], found["Sq"])
        printed = " ".join(self.run_well("surface", "map.csv", *self.STATED).split())
        self.assertIn("S-filter 2 um; pixel 0.5 um; ISO 25178-2", printed)
        self.assertIn("S-filter 2 um, L-filter 20 um; pixel 0.5 um", printed)  # of a side of 24 um
        self.assertNotIn("SF_Sq", self.json_of("map.csv", *self.STATED, "--standard-surfaces", "none"))


class Doubts(SurfaceTest):
    """What was read without an error and may not be a surface is noted wherever it is used, or refused."""

    def setUp(self):
        super().setUp()
        rows = heights(uneven)
        (self.folder / "good.csv").write_text(matrix_text(rows))
        rows[10][20] = rows[30][40] = 9e-6
        rows[-1] = [-0.7e-6] * SIZE
        (self.folder / "odd.csv").write_text(matrix_text(rows))
        counted = [[1e-6 * j, *row] for j, row in enumerate(heights(uneven))]
        (self.folder / "counted.csv").write_text(matrix_text(counted))

    SPIKE = "2 points far from the rest repeat one value, 9 um, the first of them row 11, column 21"
    LINE = "row 48 holds one value throughout, -0.7 um"

    def assert_noted(self, notes, *fragments):
        for fragment in fragments:
            self.assertTrue(any(fragment in note for note in notes), notes)

    def test_in_surface(self):
        self.assertFalse(any("far from the rest" in note for note in self.json_of("good.csv", *self.STATED)["notes"]))
        self.assert_noted(self.json_of("odd.csv", *self.STATED)["notes"], self.SPIKE, self.LINE)
        both = self.json_of("good.csv", "odd.csv", *self.STATED)["notes"]
        self.assert_noted(both, "odd.csv: " + self.SPIKE)
        self.assert_noted(
            self.json_of("good.csv", *self.STATED, "--noise", "odd.csv")["notes"], "odd.csv: " + self.SPIKE
        )

    def test_in_a_pair_and_in_its_fragment(self):
        words = ("--ring", "good.csv", "--liner", "odd.csv", *self.STATED, "--fragment", "contact.toml", "--json")
        self.assert_noted(json.loads(self.run_well("pair", *words))["notes"], "odd.csv: " + self.SPIKE)
        fragment = (self.folder / "contact.toml").read_text()
        self.assertIn("odd.csv: 2 points far from the rest repeat one value, 9 um", " ".join(fragment.split()))

    def test_in_the_law_of_a_pair(self):
        words = ("--surface", "good.csv", "--surface", "odd.csv", "--composite-modulus", "134.8 GPa", "--json")
        self.assert_noted(json.loads(self.run_well("contact", *words, *self.STATED))["notes"], "odd.csv: " + self.SPIKE)

    def test_an_option_against_the_file_is_noted(self):
        self.run_well("surface", "good.csv", *self.STATED, "--heights", "in_metres.csv")
        words = ("--ring", "in_metres.csv", "--liner", "good.csv", *self.STATED[:-2], "--json")
        # The unit of the liner holds for the ring, too, whose heights are then a millionth.
        self.assert_refused(
            self.run_program("pair", *words),
            "the file states the heights in m, and um is used in its place",
            "below the size of an atom",
        )

    def test_row_numbers_are_refused_in_all_commands(self):
        for words in (
            ("surface", "counted.csv"),
            ("pair", "--ring", "good.csv", "--liner", "counted.csv", "--fragment", "contact.toml"),
            ("contact", "--surface", "counted.csv", "--composite-modulus", "134.8 GPa"),
        ):
            with self.subTest(words):
                before = self.names()
                self.assert_refused(
                    self.run_program(*words, *self.STATED),
                    "counted.csv: column 1 goes in even steps from 0 um to 47 um",
                    "remove this column",
                )
                self.assertEqual(self.names(), before)


class Refusals(SurfaceTest):
    def refused(self, *words, fragments):
        before = self.names()
        self.assert_refused(self.run_program(*words), *fragments)
        self.assertEqual(self.names(), before)

    def test_what_the_file_does_not_state_is_asked_for(self):
        self.refused("surface", "map.csv", fragments=["--unit"])
        self.refused("surface", "map.csv", "--unit", "um", fragments=["--step-x"])
        self.refused("surface", "map.csv", "--unit", "kg", "--step-x", "1 um", fragments=["kg"])

    def test_invalid_words(self):
        for words, printed in [
            (("--form", "sphere"), "--form sphere"),
            (("--form", "polynomial-99"), "0 to 12"),
            (("--short-cutoff", "5"), '--short-cutoff "5"'),
            (("--short-cutoff", "-5 um"), '--short-cutoff "-5 um"'),
            (("--short-cutoff", "9 um", "--long-cutoff", "3 um"), "not below"),
            (("--short-cutoff", "0.6 um"), "two steps"),
            (("--robust",), "--robust"),
            (("--grid", "0x3"), "--grid 0x3"),
            (("--region", "0, 0, 9 um"), "--region"),
            (("--region", "0, 0, 900, 900 um"), "does not lie on the map"),
            (("--prominent", "4"), "--prominent 4"),
            (("--sigma", "Rz"), "--sigma Rz"),
            (("--channel", "7"), "channel"),
            (("--noise", "nosuch.csv"), "nosuch.csv"),
            (("--sigma", "Rz", "--short-cutoff", "5"), "2 errors"),
            (("--grid", "0x3", "--form", "sphere", "--region", "0, 0, 9 um", "--prominent", "4"), "4 errors"),
            (("--angle", "30 mm"), '--angle "30 mm"'),
            (("--cavity-depth", "deep"), '--cavity-depth "deep"'),
            (("map.csv", "--heights", "out.csv"), "one file"),
            (("--output", "nosuch/map.nc"), "nosuch"),
            (("--output", "map.csv"), "map.csv"),
            (("--output", "a.nc", "--heights", "a.nc"), "--heights and --output name the same file a.nc"),
            (("--heights", "map.csv"), "--heights map.csv would replace"),
        ]:
            with self.subTest(words):
                self.refused("surface", "map.csv", *self.STATED, *words, fragments=[printed])

    def test_invalid_files(self):
        for name, bytes_ in [
            ("empty.csv", b""),
            ("zeros.x3p", b"PK\x03\x04" + bytes(40)),
            ("words.csv", b"a,b\nc,d\n"),
        ]:
            (self.folder / name).write_bytes(bytes_)
            with self.subTest(name):
                self.refused("surface", name, *self.STATED, fragments=[name])

    def test_a_flat_surface_is_in_contact_with_nothing(self):
        (self.folder / "flat.csv").write_text(matrix_text([[1e-6] * 20] * 20))
        self.refused("pair", "--ring", "flat.csv", "--liner", "map.csv", *self.STATED, fragments=["same"])


if __name__ == "__main__":
    unittest.main()
