"""`ringfilm lateral-force`: loops that give Table 2 of the paper, and what is made of them."""

import json
import math
import random
import struct
import unittest

import program

TABLE_2 = {"new ring": 0.3581, "run-in ring": 0.2565, "bedded ring": 0.1423}
SILICON_SLOPE = 0.2  # [mV/nN]
REFERENCE = 0.19
LOADS = (5, 10, 20, 30, 40, 50)  # [nN]
ON_SILICON = ("--silicon", "silicon.csv", "--reference", "ahimou2007")
LEVER = """\
shape = "rectangular"
length = "450 um +- 5 um"
tip_height = "15 um +- 1 um"
poissons_ratio = 0.25
"""


def loops(name, slope, offset=1.0, noise=0.0, seed=1, unit="nN"):
    """Two loops a load with turn-around ends, the waves of the sample and noise."""
    numbers = random.Random(seed)
    rows = [f"# sample: {name}", f"load [{unit}],loop,position [um],trace [mV],retrace [mV]"]
    for load in LOADS:
        for number in (1, 2):
            tmr = offset + slope * load + numbers.gauss(0, noise)
            for i in range(101):
                there, back = min(1, i / 5), min(1, (100 - i) / 5)
                wave = 3 + math.sin(i / 4) + 0.05 * i
                rows.append(
                    f"{load},{number},{i / 10:.2f},{wave + tmr * (2 * there - 1):.9f},"
                    f"{wave - tmr * (2 * back - 1):.9f}"
                )
    return "\n".join(rows) + "\n"


def gwy(path, channels):
    """A Gwyddion file of square fields in volts, 20 nm apart."""

    def text(value):
        return value.encode() + b"\0"

    def item(name, kind, data):
        return text(name) + kind + data

    def thing(kind, body):
        return text(kind) + struct.pack("<I", len(body)) + body

    body = b""
    for number, (title, values) in enumerate(channels):
        size = round(math.sqrt(len(values)))
        field = b"".join(
            (
                item("xres", b"i", struct.pack("<i", size)),
                item("yres", b"i", struct.pack("<i", size)),
                item("xreal", b"d", struct.pack("<d", size * 20e-9)),
                item("yreal", b"d", struct.pack("<d", size * 20e-9)),
                item("si_unit_xy", b"o", thing("GwySIUnit", item("unitstr", b"s", text("m")))),
                item("si_unit_z", b"o", thing("GwySIUnit", item("unitstr", b"s", text("V")))),
                item("data", b"D", struct.pack("<I", len(values)) + struct.pack(f"<{len(values)}d", *values)),
            )
        )
        body += item(f"/{number}/data", b"o", thing("GwyDataField", field))
        body += item(f"/{number}/data/title", b"s", text(title))
    path.write_bytes(b"GWYP" + thing("GwyContainer", body))


class LateralForceTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "silicon.csv").write_text(loops("silicon", SILICON_SLOPE))
        self.rings = []
        for name, zeta in TABLE_2.items():
            self.rings.append(name.replace(" ", "_") + ".csv")
            (self.folder / self.rings[-1]).write_text(loops(name, SILICON_SLOPE * zeta / REFERENCE, offset=0.5))
        self.inputs = self.names()

    def json_of(self, *words):
        return json.loads(self.run_well("lateral-force", *words, "--json"))


class Numbers(LateralForceTest):
    def test_table_2_comes_back(self):
        reported = self.json_of(*self.rings, *ON_SILICON)
        self.assertEqual(reported["kind"], "lateral-force")
        for name, zeta in TABLE_2.items():
            word = name.replace(" ", "_").replace("-", "_")
            # Loops without noise, written with nine places: rounding is all there is.
            self.assertAlmostEqual(reported[f"boundary_shear_strength_coefficient_{word}"], zeta, delta=1e-7)
            self.assertAlmostEqual(reported[f"reference_deviation_{word}"], zeta * 0.1 / 0.19, delta=1e-7)
            value = reported["values"][f"boundary_shear_strength_coefficient_{word}"]
            self.assertAlmostEqual(value["standard_error"], zeta * 0.1 / 0.19, delta=1e-6)
        self.assertAlmostEqual(reported["psi"], REFERENCE / 2e5, delta=1e-12)  # [N/V]
        self.assertIn("53 %", " ".join(reported["notes"]))

    def test_one_sample_has_plain_names_and_its_shares_apart(self):
        (self.folder / "rough.csv").write_text(loops("rough", 0.3, noise=0.3))
        reported = self.json_of("rough.csv", *ON_SILICON)
        shares = [reported[f"{share}_deviation"] for share in ("slope", "calibration", "reference")]
        self.assertGreater(shares[0], 0)
        value = reported["values"]["boundary_shear_strength_coefficient"]
        self.assertAlmostEqual(value["standard_error"], math.hypot(*shares), delta=1e-12)
        self.assertLess(reported["low"], reported["boundary_shear_strength_coefficient"])

    def test_samples_of_one_calibration_are_correlated(self):
        text = self.run_well("lateral-force", *self.rings, *ON_SILICON)
        self.assertIn("Correlation of the coefficients", text)
        self.assertIn("0.3581", text)
        self.assertIn("0.2565", text)
        self.assertIn("0.1423", text)

    def test_a_reference_of_ones_own(self):
        reported = self.json_of(self.rings[0], "--silicon", "silicon.csv", "--reference", "0.38 \u00b1 0.01")
        self.assertAlmostEqual(reported["boundary_shear_strength_coefficient"], 2 * 0.3581, delta=1e-6)

    def test_a_reference_without_its_error_is_reported(self):
        exact = self.json_of(self.rings[0], "--silicon", "silicon.csv", "--reference", "0.19")
        self.assertEqual(exact["reference_deviation"], 0)
        self.assertTrue(any("taken as exact" in note for note in exact["notes"]))
        known = self.json_of(self.rings[0], "--silicon", "silicon.csv", "--reference", "0.19 +- 0.03")
        self.assertFalse(any("taken as exact" in note for note in known["notes"]))

    def test_a_summary_is_as_good_as_loops(self):
        rows = "".join(f"{load},{0.5 + SILICON_SLOPE * 0.3581 / REFERENCE * load}\n" for load in LOADS)
        (self.folder / "summary.csv").write_text("# sample: summary\nload [nN],tmr [mV]\n" + rows)
        reported = self.json_of("summary.csv", *ON_SILICON)
        self.assertAlmostEqual(reported["boundary_shear_strength_coefficient"], 0.3581, delta=1e-7)

    def test_files_of_one_sample_are_one_sample(self):
        whole = (self.folder / self.rings[0]).read_text().splitlines()
        head, rows = whole[:2], whole[2:]
        half = len(rows) // 2
        (self.folder / "a.csv").write_text("\n".join(head + rows[:half]) + "\n")
        (self.folder / "b.csv").write_text("\n".join(head + rows[half:]) + "\n")
        both, one = self.json_of("a.csv", "b.csv", *ON_SILICON), self.json_of(self.rings[0], *ON_SILICON)
        self.assertEqual(both["boundary_shear_strength_coefficient"], one["boundary_shear_strength_coefficient"])

    def test_a_lever(self):
        """Eqs A-5 and A-9 for loads in volts: psi = L/R/(1 + nu)."""
        (self.folder / "lever.toml").write_text(LEVER)
        (self.folder / "volts.csv").write_text(loops("volts", 0.01, unit="V"))
        reported = self.json_of("volts.csv", "--lever", "lever.toml")
        self.assertAlmostEqual(reported["psi"], 450 / 15 / 1.25, delta=1e-12)
        self.assertAlmostEqual(reported["boundary_shear_strength_coefficient"], 24 * 1e-5, delta=1e-9)
        self.assertAlmostEqual(reported["calibration_deviation"] / 24e-5, math.hypot(5 / 450, 1 / 15), delta=1e-6)

    def test_a_wedge(self):
        """Loops by the balance of forces on facets of +-40 degrees, friction 0.25, 2 nN/mV, with cross-talk."""
        for name, sign in (("up", 1), ("down", -1)):
            angle = math.radians(40) * sign
            rows = [f"# sample: {name}", "load [nN],position [um],trace [mV],retrace [mV]"]
            for load in LOADS:

                def force(s, load=load, angle=angle):
                    return (load * (math.sin(angle) + s * 0.25 * math.cos(angle)) + s * 0.25 * 5) / (
                        math.cos(angle) - s * 0.25 * math.sin(angle)
                    )

                cross_talk = 0.05 * load
                for i in range(40):
                    rows.append(f"{load},{i / 10},{force(1) / 2 + cross_talk},{force(-1) / 2 + cross_talk}")
            (self.folder / f"{name}.csv").write_text("\n".join(rows) + "\n")
        reported = self.json_of(
            self.rings[0],
            "--wedge",
            "up.csv",
            "--wedge",
            "down.csv",
            "--wedge-angle",
            "40 deg +- 0.5 deg",
            "--wedge-angle",
            "-40 deg +- 0.5 deg",
        )
        self.assertAlmostEqual(reported["psi"], 2e-9 / 1e-3, delta=1e-12)
        self.assertAlmostEqual(reported["grating_friction"], 0.25, delta=1e-6)
        self.assertGreater(reported["reference_deviation"], 0)

    def test_scans_of_an_instrument(self):
        """Two lateral channels a load; every line of the scan is a loop."""
        words = []
        for load in LOADS:
            tmr = (0.5 + SILICON_SLOPE * 0.3581 / REFERENCE * load) * 1e-3
            wave = [1e-3 * math.sin(i) for i in range(24 * 24)]
            gwy(
                self.folder / f"scan_{load}.gwy",
                [("Height", [0.0] * 576), ("Trace", [w + tmr for w in wave]), ("Retrace", [w - tmr for w in wave])],
            )
            words += ["--load", f"{load} nN"]
        files = [f"scan_{load}.gwy" for load in LOADS]
        for channels in (("2", "3"), ("Trace", "Retrace")):
            reported = self.json_of(*files, *words, "--channels", *channels, "--name", "scanned", *ON_SILICON)
            self.assertAlmostEqual(reported["boundary_shear_strength_coefficient"], 0.3581, delta=1e-7)
        self.assertIn("24 of 24 lines at 5 nN", " ".join(reported["sources"]))
        self.assert_refused(
            self.run_program("lateral-force", *files, *words, "--channels", "2", "2", *ON_SILICON),
            "trace and retrace are one channel",
        )
        self.assert_refused(
            self.run_program("lateral-force", *files, *words, "--channels", "2", "9", *ON_SILICON),
            "scan_5.gwy",
            "there is no channel 9",
            "Retrace",
        )
        self.assert_refused(
            self.run_program("lateral-force", *files, *words[2:], "--channels", "2", "3", *ON_SILICON),
            "6 scans, but 5 loads",
        )


class Fragments(LateralForceTest):
    def setUp(self):
        super().setUp()
        case = program.CASE.replace("boundary_shear_strength_coefficient = 0.3581\n", "")
        (self.folder / "case.toml").write_text('include = ["shear.toml"]\n' + case)

    def test_a_case_reads_it(self):
        self.assert_refused(self.run_program("check", "case.toml"), "shear.toml")
        self.run_well("lateral-force", self.rings[0], *ON_SILICON, "--fragment", "shear.toml")
        fragment = (self.folder / "shear.toml").read_text()
        self.assertIn("boundary_shear_strength_coefficient = 0.3581", fragment)
        self.assertIn('method = "silicon"', fragment)
        self.assertIn("reference_deviation = 0.188", fragment)
        self.assertIn("no errors", self.run_well("check", "case.toml"))

    def test_several_samples_require_one_named(self):
        before = self.names()
        self.assert_refused(
            self.run_program("lateral-force", *self.rings, *ON_SILICON, "--fragment", "shear.toml"),
            "3 samples",
            "--sample NAME",
            "bedded ring",
        )
        self.assert_refused(
            self.run_program("lateral-force", *self.rings, *ON_SILICON, "--sample", "old ring"),
            "there is no such sample",
            "new ring, run-in ring, bedded ring",
        )
        self.assertEqual(self.names(), before)
        self.run_well("lateral-force", *self.rings, *ON_SILICON, "--sample", "run-in ring", "--fragment", "shear.toml")
        self.assertIn("coefficient = 0.2565", (self.folder / "shear.toml").read_text())

    def test_samples_of_one_calibration_carry_one_name(self):
        names = []
        for ring in self.rings:
            reported = self.json_of(ring, *ON_SILICON)
            names.append([line for line in reported["fragment"].splitlines() if line.startswith("calibration =")])
        self.assertEqual(len(names[0]), 1)
        self.assertEqual(names[0], names[1])
        other = self.json_of(self.rings[0], "--silicon", "silicon.csv", "--reference", "warmack1994")["fragment"]
        self.assertNotIn(names[0][0], other)
        own = self.json_of(self.rings[0], *ON_SILICON, "--calibration", "tip 4")["fragment"]
        self.assertIn('calibration = "tip 4"', own)


class Outputs(LateralForceTest):
    WRITTEN = ("out.nc", "out.html", "out.toml")
    WORDS = ("--output", "out.nc", "--html", "out.html", "--fragment", "out.toml")

    def test_all_are_written(self):
        self.run_well("lateral-force", self.rings[0], *ON_SILICON, *self.WORDS)
        for name in self.WRITTEN:
            self.assertIn(name, self.names())
        page = (self.folder / "out.html").read_text()
        for words in ("Friction against load", "Friction loops, new ring", "Friction loops, silicon"):
            self.assertIn(words, page)

    def test_a_refusal_leaves_what_stood_there(self):
        for name in self.WRITTEN:
            (self.folder / name).write_text("kept")
        (self.folder / "falling.csv").write_text(loops("falling", -0.1, offset=20))
        self.assert_refused(
            self.run_program("lateral-force", "falling.csv", *ON_SILICON, *self.WORDS),
            "falling does not rise with load",
        )
        for name in self.WRITTEN:
            self.assertEqual((self.folder / name).read_text(), "kept")

    def test_outputs_do_not_replace_inputs(self):
        self.assert_refused(
            self.run_program("lateral-force", self.rings[0], *ON_SILICON, "--output", "silicon.csv"),
            "would replace what is read",
        )


class Refusals(LateralForceTest):
    def refuse(self, *fragments, words):
        self.assert_refused(self.run_program("lateral-force", *words, "--output", "out.nc"), *fragments)
        self.assertNotIn("out.nc", self.names())

    def test_no_calibration_or_two(self):
        self.refuse("no calibration is named", "--silicon FILE", words=(self.rings[0],))
        self.refuse("more than one calibration", words=(self.rings[0], *ON_SILICON, "--lever", "lever.toml"))

    def test_a_sample_is_not_its_own_calibration(self):
        same = ("the sample ", "the calibration on silicon ", "have the same loops", "name another file")
        self.refuse(*same, words=("silicon.csv", *ON_SILICON))
        (self.folder / "copy.csv").write_bytes((self.folder / "silicon.csv").read_bytes())
        self.refuse(*same, "copy.csv", words=("copy.csv", *ON_SILICON))
        # The numbers are compared, not the bytes of the files.
        (self.folder / "sub").mkdir()
        (self.folder / "sub" / "copy.csv").write_text((self.folder / "silicon.csv").read_text() + "\n")
        self.refuse(*same, "(sub/copy.csv)", "(silicon.csv)", words=("sub/copy.csv", *ON_SILICON))

    def test_no_reference_is_a_default(self):
        self.refuse(
            "--silicon without --reference",
            "ahimou2007",
            "warmack1994",
            words=(self.rings[0], "--silicon", "silicon.csv"),
        )
        self.refuse(
            "has more than a number", words=(self.rings[0], "--silicon", "silicon.csv", "--reference", "0.19 N")
        )
        self.refuse(
            "a deviation below zero", words=(self.rings[0], "--silicon", "silicon.csv", "--reference", "0.19 +- -0.1")
        )

    def test_values(self):
        self.refuse("is not between 0 and 0.49", words=(self.rings[0], *ON_SILICON, "--end-share", "0.5"))
        self.refuse("one of: from-residuals, stated", words=(self.rings[0], *ON_SILICON, "--deviations", "none"))
        self.refuse("--load-deviation", "a force", words=(self.rings[0], *ON_SILICON, "--load-deviation", "1 um"))
        self.refuse("state the load of each file", words=(self.rings[0], *ON_SILICON, "--channels", "2", "3"))
        self.refuse("which channels are trace and retrace", words=(self.rings[0], *ON_SILICON, "--load", "5 nN"))
        self.refuse("two facets, each with its angle", words=(self.rings[0], "--wedge", "silicon.csv"))

    def test_files(self):
        rows = (self.folder / self.rings[0]).read_text().splitlines()
        rows[9] = "5,1,text,1,1"
        (self.folder / "broken.csv").write_text("\n".join(rows) + "\n")
        self.refuse("broken.csv:10", "missing.csv", words=("broken.csv", "missing.csv", *ON_SILICON))
        self.refuse("trace.csv:1", "neither friction loops nor their summary", words=("trace.csv", *ON_SILICON))
        self.refuse("given twice", words=(self.rings[0], self.rings[0], *ON_SILICON))
        (self.folder / "volts.csv").write_text(loops("volts", 0.1, unit="V"))
        self.refuse("not in one kind of unit", words=("volts.csv", *ON_SILICON))

    def test_levers(self):
        def lever(text, *fragments):
            (self.folder / "lever.toml").write_text(text)
            self.refuse(*fragments, words=(self.rings[0], "--lever", "lever.toml"))

        lever(LEVER, "youngs_modulus is missing: the loads are in newtons", "4 errors")
        lever(LEVER.replace("rectangular", "v-shaped"), "youngs_modulus", "missing")
        lever(LEVER.replace("length", "lenght"), "lever.toml:2:1", "did you mean length?")
        lever(LEVER.replace('"450 um +- 5 um"', "450"), "lever.toml:2", "has no unit")
        (self.folder / "volts.csv").write_text(loops("volts", 0.1, unit="V"))
        (self.folder / "lever.toml").write_text(LEVER.replace("rectangular", "v-shaped"))
        self.refuse("this one is V-shaped", "calibrate it on silicon", words=("volts.csv", "--lever", "lever.toml"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
