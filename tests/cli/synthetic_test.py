"""`ringfilm synthetic`: surfaces of known statistics, read back by `ringfilm surface`."""

import json
import math
import unittest

import program

ENDINGS = ("x3p", "sur", "gsf", "csv")


class SyntheticTest(program.ProgramTest):
    def made(self, kind, name, *words):
        printed = self.run_well("synthetic", kind, name, *words)
        self.assertIn(f"SYNTHETIC: ringfilm synthetic {kind}", printed)
        self.assertIn(f"wrote {name}", printed)
        return printed

    def measured(self, name, *words):
        return json.loads(self.run_well("surface", name, "--json", *words))


class Kinds(SyntheticTest):
    def test_a_gaussian_surface_has_its_rms_height_and_correlation(self):
        for ending in ENDINGS:
            name = "a." + ending
            self.made(
                "gaussian",
                name,
                "--points",
                "256x128",
                "--step",
                "1 um",
                "--sq",
                "0.25 um",
                "--correlation-length",
                "8 um",
            )
            of = self.measured(name)
            self.assertEqual((of["points_x"], of["points_y"], of["missing"]), (256, 128, 0))
            self.assertAlmostEqual(of["width"] / 256e-6, 1, delta=1e-6)  # SUR keeps the step in single precision
            self.assertAlmostEqual(of["Sq"] / 0.25e-6, 1, delta=1e-5)  # SUR has steps of 1 pm, GSF single precision
            self.assertAlmostEqual(of["Sku"], 3, delta=0.5)  # 250 patches of a correlation area, 3 +- 0.15 each sigma
            # exp(-r^2/l^2) has slopes of variance 2 Sq^2/l^2 along x; neighbours at 1/8 of l see 0.8 % less of it.
            self.assertAlmostEqual(of["Sdq"] / (2 * 0.25 / 8), 1, delta=0.1)

    def test_n_beta_and_sigma_come_back(self):
        words = (
            "--points",
            "256x256",
            "--asperity-density",
            "0.05 um-2",
            "--asperity-radius",
            "2 um",
            "--roughness",
            "0.4 um",
        )
        for rule in ("Ra", "Rq"):
            self.made("gaussian", "a.x3p", *words, "--sigma", rule)
            of = self.measured("a.x3p", "--sigma", rule)
            self.assertAlmostEqual(of["asperity_density"] / 5e10, 1, delta=1e-8)  # X3P keeps every bit
            self.assertAlmostEqual(of["asperity_radius"] / 2e-6, 1, delta=1e-8)
            self.assertAlmostEqual(of["roughness"] / 0.4e-6, 1, delta=1e-8)

    def test_a_honed_surface_has_a_plateau_and_valleys(self):
        for ending in ENDINGS:
            self.made(
                "honed",
                "a." + ending,
                "--points",
                "256x256",
                "--step",
                "1 um",
                "--groove-depth",
                "3 um",
                "--groove-width",
                "10 um",
                "--groove-spacing",
                "50 um",
                "--sq",
                "0.05 um",
            )
            of = self.measured("a." + ending)
            self.assertLess(of["Ssk"], -1)  # grooves
            self.assertGreater(of["Svk"], 10 * of["Spk"])
            self.assertLess(of["min"], -1.5e-6)  # half the mean depth at least
            self.assertGreater(of["min"], -5e-6)  # three halves of it and the plateau

    def test_the_angle_of_the_hatch_turns_the_slopes(self):
        slopes = {}
        for angle in ("20 degree", "160 degree"):
            self.made("honed", "a.x3p", "--points", "512x512", "--step", "1 um", "--hatch-angle", angle)
            moments = {way: self.measured("a.x3p", "--direction", way) for way in ("x", "y")}
            slopes[angle] = moments["x"]["m2"] / moments["y"]["m2"]
        self.assertLess(slopes["20 degree"], 0.7)  # grooves nearly along x
        self.assertGreater(slopes["160 degree"], 1 / 0.7)

    def test_the_share_of_pores_holds(self):
        for ending in ENDINGS:
            self.made(
                "porous",
                "a." + ending,
                "--points",
                "128x128",
                "--sq",
                "0.01 um",
                "--pore-share",
                "0.2",
                "--pore-depth",
                "5 um",
                "--pore-length",
                "10 um",
            )
            self.run_well("surface", "a." + ending, "--heights", "h.csv")
            heights = [float(line.split(",")[2]) for line in (self.folder / "h.csv").read_text().splitlines()[1:]]
            deep = sum(z < -0.05e-6 for z in heights) / len(heights)  # five times the roughness
            self.assertAlmostEqual(deep, 0.2, delta=0.005)  # the rims of pores are shallower
            mean_depth = -sum(z for z in heights if z < -0.05e-6) / sum(z < -0.05e-6 for z in heights)
            self.assertAlmostEqual(mean_depth / 5e-6, 1, delta=0.03)

    def test_a_row_is_a_profile(self):
        self.made("gaussian", "a.x3p", "--points", "2000x1", "--sq", "0.2 um")
        of = self.measured("a.x3p")
        self.assertEqual((of["points_x"], of["points_y"]), (2000, 1))
        self.assertTrue(math.isclose(of["Rq"], 0.2e-6, rel_tol=1e-9))


class Files(SyntheticTest):
    def test_the_same_words_give_the_same_bytes_and_another_seed_others(self):
        for kind in ("gaussian", "honed", "porous"):
            for ending in ENDINGS:
                bytes_of = {}
                for name, seed in (("a", "1"), ("b", "1"), ("c", "2")):
                    self.made(kind, f"{name}.{ending}", "--points", "64x64", "--seed", seed)
                    bytes_of[name] = (self.folder / f"{name}.{ending}").read_bytes()
                self.assertEqual(bytes_of["a"], bytes_of["b"], kind + ending)
                self.assertNotEqual(bytes_of["a"], bytes_of["c"], kind + ending)

    def test_the_seed_is_reported_where_none_was_named(self):
        self.assertIn("seed 1\n", self.made("gaussian", "a.x3p", "--points", "64x64"))
        self.made("gaussian", "b.x3p", "--points", "64x64", "--seed", "1")
        self.assertEqual((self.folder / "a.x3p").read_bytes(), (self.folder / "b.x3p").read_bytes())

    def test_files_state_that_they_are_synthetic_and_how_they_were_made(self):
        words = ("--points", "64x64", "--sq", "0.2 um", "--seed", "17")
        for ending in ENDINGS:
            self.made("gaussian", "a." + ending, *words)
            raw = (self.folder / ("a." + ending)).read_bytes()
            for text in (b"SYNTHETIC", b"ringfilm synthetic gaussian --points 64x64", b'--sq "0.2 um"', b"seed 17"):
                if ending != "x3p":  # an archive
                    self.assertIn(text, raw, ending)
        self.made("gaussian", "a.x3p", *words)
        self.made("gaussian", "a.sur", *words)
        for name in ("a.x3p", "a.sur"):
            printed = " ".join(self.run_well("surface", name).split())
            self.assertIn('ringfilm synthetic gaussian --points 64x64 --step "0.5 um" --sq "0.2 um", seed 17', printed)


class Refusals(SyntheticTest):
    def refused(self, *words, fragments):
        before = self.names()
        self.assert_refused(self.run_program("synthetic", *words), *fragments)
        self.assertEqual(self.names(), before)

    def test_an_ending_that_is_not_a_format(self):
        self.refused("gaussian", "a.sdf", fragments=["a.sdf: the ending", ".x3p, .sur, .gsf or .csv"])

    def test_all_that_is_wrong_is_reported_at_once(self):
        self.refused(
            "honed",
            "a.x3p",
            "--points",
            "4x4",
            "--seed",
            "one",
            "--sq",
            "0.1",
            "--groove-depth",
            "-1 um",
            "--hatch-angle",
            "45 um",
            fragments=[
                "--points 4x4",
                "--seed one",
                '--sq "0.1" has no unit',
                '--groove-depth "-1 um"',
                '--hatch-angle "45 um"',
                "5 errors",
            ],
        )

    def test_sizes_that_fit_no_memory(self):
        for points in ("1000000x1000000", "18446744073709551615x2", "512", "512x", "512x512x2", "-5x16"):
            self.refused("gaussian", "a.x3p", "--points=" + points, fragments=["this is not a size of a map"])

    def test_two_ways_to_state_the_target(self):
        expected = ("--asperity-density", "0.05 um-2", "--asperity-radius", "2 um", "--roughness", "0.4 um")
        self.refused("gaussian", "a.x3p", *expected, "--sq", "0.2 um", fragments=["another way to define"])
        self.refused("gaussian", "a.x3p", *expected[:4], fragments=["belong together"])

    def test_a_surface_that_no_spectrum_has(self):
        self.refused(
            "gaussian",
            "a.x3p",
            "--points",
            "64x64",
            "--asperity-density",
            "5 um-2",
            "--asperity-radius",
            "2 um",
            "--roughness",
            "0.4 um",
            fragments=["no surface with the target roughness"],
        )

    def test_shares_and_grooves_out_of_range(self):
        self.refused("porous", "a.x3p", "--pore-share", "0.95", fragments=["--pore-share 0.95", "between 0 and 0.9"])
        self.refused("honed", "a.x3p", "--groove-spacing", "1 pm", fragments=["too fine for the map"])

    def test_a_folder_that_is_not_there(self):
        self.refused("gaussian", "nowhere/a.x3p", fragments=["nowhere"])

    def test_a_kind_that_is_not_known(self):
        done = self.run_program("synthetic", "shiny", "a.x3p")
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
