"""`ringfilm face`: traces with known shape in, the shape, its fragment and its pictures out."""

import json
import random
import unittest

import program

# Table 4 of Styles et al. 2014: x in mm, gap in um, highest power first.
RUN_IN = (-197.16, 578.85, -583.44, 200.37, 56.366, -62.709, 13.857)
NEW = (427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.30)
WIDTH = 1.2  # [mm]
NOISE = 0.05  # [um]
STATED = ("--heights", "material", "--width", "1.2 mm")
PLACED = (*STATED, "--start", "0.3 mm", "--tilt", "-3 mrad")
OUTPUTS = ("face.toml", "face.csv", "face.nc", "face.html")


def polynomial(coefficients, x):
    height = 0
    for coefficient in coefficients:
        height = height * x + coefficient
    return height


def trace(coefficients, noise=NOISE):
    """Heights as a stylus has them, 3 mrad of tilt, the face from 0.3 mm on between steep flanks."""
    numbers = random.Random(7)
    rows = ["x [mm],z [um]"]
    for i in range(3601):
        x = i * 0.0005 - 0.3
        inside = min(max(x, 0), WIDTH)
        gap = polynomial(coefficients, inside) + 400 * max(0, -x) + 400 * max(0, x - WIDTH)
        rows.append(f"{x + 0.3:.5f},{-gap + 3 * x + numbers.gauss(0, noise):.5f}")
    return "\n".join(rows) + "\n"


class FaceTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "trace_of_face.csv").write_text(trace(RUN_IN))
        self.inputs = self.names()

    def json_of(self, *words, path="trace_of_face.csv"):
        return json.loads(self.run_well("face", path, "--json", *words))


class Numbers(FaceTest):
    def test_the_run_in_face_of_table_4_comes_back(self):
        reported = self.json_of(*PLACED)
        self.assertEqual(reported["kind"], "face")
        fitted = [
            reported[f"coefficient_{letter}"] * 1e6 * 1e-3**power
            for letter, power in zip("abcdef", range(6, 0, -1), strict=True)
        ]
        for x in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.15):
            # Shapes agree but for a constant. 2401 points of 50 nm fix a fit of 7 numbers to 3 nm inside.
            got = polynomial((*fitted, 0), x) - polynomial((*fitted, 0), 0.6)
            true = polynomial(RUN_IN, x) - polynomial(RUN_IN, 0.6)
            self.assertAlmostEqual(got, true, delta=0.02, msg=f"x = {x}")
        self.assertAlmostEqual(reported["noise"], NOISE * 1e-6, delta=0.1 * NOISE * 1e-6)
        self.assertAlmostEqual(reported["polynomial_residual_rms"], NOISE * 1e-6, delta=0.1 * NOISE * 1e-6)
        # 13.9 and 7.8 um above its minimum at both edges.
        self.assertAlmostEqual(reported["polynomial_end_0"], 12.95e-6 + 0.9e-6, delta=0.1e-6)
        self.assertAlmostEqual(reported["polynomial_end_b"], 7.8e-6, delta=0.1e-6)
        self.assertAlmostEqual(reported["tilt"], -3e-3)

    def test_the_fall_of_table_4_in_its_last_60_um_is_reported(self):
        reported = self.json_of(*PLACED)
        rows = reported["tables"]["fit_artifact"]
        self.assertIn("falls towards the edge", json.dumps(rows))
        self.assertTrue(any("1.14 to 1.2 mm" in note for note in reported["notes"]), reported["notes"])

    def test_a_running_surface_that_is_not_flat_is_reported(self):
        (self.folder / "trace_of_face.csv").write_text(trace(NEW))
        reported = self.json_of(*STATED, "--start", "0.3 mm", "--running-surface-height", "2 um")
        self.assertNotAlmostEqual(
            reported["tilt_half_running_surface"], reported["tilt_double_running_surface"], delta=1e-3
        )
        self.assertIn("the running surface is not flat", " ".join(reported["notes"]))
        self.assertNotIn("the running surface is not flat", " ".join(self.json_of(*PLACED)["notes"]))

    def test_a_spline_that_is_too_stiff_for_the_edges_is_reported(self):
        (self.folder / "trace_of_face.csv").write_text(trace(NEW, 0.01))
        stiff = self.json_of(*PLACED, "--spline-cutoff", "200 um")
        self.assertIn("the spline misses the trace", " ".join(stiff["notes"]))
        soft = self.json_of(*PLACED, "--spline-cutoff", "15 um")
        self.assertNotIn("the spline misses the trace", " ".join(soft["notes"]))

    def test_gap_and_material_are_mirrors(self):
        rows = (self.folder / "trace_of_face.csv").read_text().splitlines()
        turned = [rows[0]] + [f"{row.split(',')[0]},{-float(row.split(',')[1]):.5f}" for row in rows[1:]]
        (self.folder / "gap.csv").write_text("\n".join(turned) + "\n")
        gap = self.json_of("--heights", "gap", *PLACED[2:], path="gap.csv")
        self.assertAlmostEqual(gap["polynomial_end_0"], self.json_of(*PLACED)["polynomial_end_0"], delta=1e-15)

    def test_turned_exchanges_the_edges(self):
        straight, turned = self.json_of(*PLACED), self.json_of(*PLACED, "--direction", "turned")
        self.assertAlmostEqual(turned["spline_end_0"], straight["spline_end_b"], delta=1e-12)
        self.assertAlmostEqual(turned["running_surface_from"], 1.2e-3 - straight["running_surface_to"], delta=1e-12)

    def test_units_of_a_file_without_them_are_stated(self):
        rows = (self.folder / "trace_of_face.csv").read_text().replace("x [mm],z [um]", "x,z")
        (self.folder / "bare.csv").write_text(rows)
        self.assert_refused(self.run_program("face", "bare.csv", *STATED), "bare.csv", "--unit um")
        reported = self.json_of(*PLACED, "--unit", "um", "--lateral-unit", "mm", path="bare.csv")
        self.assertEqual(reported["polynomial_end_0"], self.json_of(*PLACED)["polynomial_end_0"])

    def test_a_height_far_from_all_others_is_noted_in_the_fragment_too(self):
        rows = (self.folder / "trace_of_face.csv").read_text().splitlines()
        rows[101] = rows[101].split(",")[0] + ",1000"
        (self.folder / "spike.csv").write_text("\n".join(rows) + "\n")
        found = "1 height lies far from the rest, for example 1000 um in point 101"
        self.assertIn(found, " ".join(self.run_well("face", "spike.csv", *PLACED, "--fragment", "face.toml").split()))
        self.assertIn(found, " ".join((self.folder / "face.toml").read_text().split()))
        rows[101] = rows[101].split(",")[0] + ",-9999"
        (self.folder / "spike.csv").write_text("\n".join(rows) + "\n")
        self.assert_refused(self.run_program("face", "spike.csv", *PLACED), "-9999 um in point 101", "write nan")

    def test_the_table_for_people(self):
        reported = self.run_well("face", "trace_of_face.csv", *PLACED)
        for words in (
            "the stated tilt of -3 mrad was removed",
            "residual rms",
            "running surface",
            "edge x = b",
            "Where the polynomial invents shape",
            'ring.face_width = "1.2 mm"',
        ):
            self.assertIn(words, reported)


class Fragments(FaceTest):
    """A case with the fragment is read, and is the fitted face."""

    def setUp(self):
        super().setUp()
        case = program.CASE.replace('[ring.face]\nform = "parabola"\ncrown_height = "15 um"\n', "")
        (self.folder / "case.toml").write_text('include = ["face.toml"]\n' + case)

    def fit(self, *words):
        self.run_well("face", "trace_of_face.csv", *PLACED, "--fragment", "face.toml", *words)
        self.assertIn("no errors", self.run_well("check", "case.toml"))
        return (self.folder / "face.toml").read_text()

    def least_film(self):
        return json.loads(self.run_well("run", "case.toml", "--json"))["min_film_thickness"]

    def test_polynomial_and_points_give_one_film(self):
        fragment = self.fit()
        self.assertIn('form = "polynomial"', fragment)
        self.assertIn("fit_artifact", fragment)
        self.assertIn("stated tilt, -3 mrad removed", fragment)
        self.assertNotIn("face.csv", self.names())
        of_polynomial = self.least_film()
        fragment = self.fit("--as", "points")
        self.assertIn('file = "face.csv"', fragment)
        points = (self.folder / "face.csv").read_text().splitlines()
        self.assertEqual(points[0], "x [mm],height [um]")
        self.assertEqual(float(points[-1].split(",")[0]), 1.2)
        # Both follow one trace to the noise that is left, some 10 nm.
        self.assertAlmostEqual(self.least_film() / of_polynomial, 1, delta=0.02)

    def test_points_require_a_fragment(self):
        self.assert_refused(
            self.run_program("face", "trace_of_face.csv", *PLACED, "--as", "points"),
            "beside the fragment",
            "--fragment face.toml",
        )

    def test_points_do_not_replace_the_trace(self):
        before = (self.folder / "trace_of_face.csv").read_bytes()
        done = self.run_program(
            "face", "trace_of_face.csv", *PLACED, "--as", "points", "--fragment", "trace_of_face.toml"
        )
        self.assert_refused(done, "which is the trace")
        self.assertEqual((self.folder / "trace_of_face.csv").read_bytes(), before)


class Outputs(FaceTest):
    def test_all_are_written(self):
        reported = self.run_well(
            "face",
            "trace_of_face.csv",
            *PLACED,
            "--output",
            "face.nc",
            "--html",
            "face.html",
            "--fragment",
            "face.toml",
            "--as",
            "points",
        )
        for name in OUTPUTS:
            self.assertIn(name, self.names())
        self.assertIn("wrote face.nc", reported)
        self.assertIn("Residuals of the fits", (self.folder / "face.html").read_text())

    def test_a_refusal_leaves_what_stood_there(self):
        for name in OUTPUTS:
            (self.folder / name).write_text("kept")
        done = self.run_program(
            "face",
            "trace_of_face.csv",
            "--heights",
            "material",
            "--width",
            "5 mm",
            "--output",
            "face.nc",
            "--html",
            "face.html",
            "--fragment",
            "face.toml",
            "--as",
            "points",
        )
        self.assert_refused(done, "does not cover the face")
        for name in OUTPUTS:
            self.assertEqual((self.folder / name).read_text(), "kept")

    def test_outputs_are_apart(self):
        self.assert_refused(
            self.run_program("face", "trace_of_face.csv", *PLACED, "--html", "trace_of_face.csv"),
            "would replace what is read",
        )
        self.assert_refused(
            self.run_program("face", "trace_of_face.csv", *PLACED, "--fragment", "a", "--html", "a"),
            "--fragment and --html name the same file a",
        )


class Refusals(FaceTest):
    def refuse(self, *fragments, words=(), path="trace_of_face.csv"):
        self.assert_refused(self.run_program("face", path, *words, "--fragment", "face.toml"), *fragments)
        self.assertEqual(self.names(), self.inputs, "something was written")

    def test_everything_that_is_missing_is_reported_at_once(self):
        self.refuse(
            "--heights is missing",
            "--width is missing",
            "--running-surface-height",
            "has no unit",
            "one of: running-surface, none",
            "4 errors",
            words=("--running-surface-height", "1", "--levelling", "flat"),
        )

    def test_options_of_earlier_versions_are_named_with_their_present_names(self):
        self.refuse(
            "--land-height: ringfilm face has no such option; did you mean --running-surface-height?",
            words=(*STATED, "--land-height", "1 um"),
        )
        self.refuse("did you mean --levelling running-surface?", words=(*STATED, "--levelling", "land"))

    def test_values(self):
        self.refuse("is not a length above zero", words=(*STATED[:3], "-1 mm"))
        self.refuse("a length", words=(*STATED, "--spline-cutoff", "3 N"))
        self.refuse("the tilt of the face is 2 rad", "-0.1 to 0.1", words=(*STATED, "--tilt", "2 rad"))
        self.refuse("two rules for one tilt", words=(*STATED, "--tilt", "1 mrad", "--levelling", "none"))
        self.refuse("is not between 1 and 12", words=(*STATED, "--degree", "13"))
        self.refuse("is not a whole number", words=(*STATED, "--degree", "2.5"))
        self.refuse("does not lie in the trace", words=(*STATED, "--start", "1 mm"))
        self.refuse("one of: polynomial, points", words=(*STATED, "--as", "spline"))

    def test_files(self):
        self.refuse("missing.csv", words=STATED, path="missing.csv")
        rows = (self.folder / "trace_of_face.csv").read_text().splitlines()
        rows[11] = "0.005,text"
        (self.folder / "trace_of_face.csv").write_text("\n".join(rows) + "\n")
        self.refuse("trace_of_face.csv:12", words=STATED)


if __name__ == "__main__":
    unittest.main(verbosity=2)
