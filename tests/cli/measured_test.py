"""From instrument files to the cycle: `ringfilm reproduce measured`, and the same with the commands of the manual."""

import json
import os
import re
import shutil
import subprocess
import tomllib
import unittest

import program
from program import SOURCES

RINGS = ("new", "run_in", "embedded")
PARTS = ("contact", "face", "shear_strength")

# Tables 1, 2 and 4 of the paper, written down here once more.
PAPER = {
    "new": (0.097, 1.56, 0.48, 0.3581, [427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.30]),
    "run_in": (0.100, 1.34, 0.50, 0.2565, [-197.16, 578.85, -583.44, 200.37, 56.366, -62.709, 13.857]),
    "embedded": (0.101, 1.82, 0.35, 0.1423, [-6.493, -49.845, 143.22, -98.541, 27.351, -17.338, 7.4986]),
}
# The independent implementation, cases/styles2014/published.toml: mean friction power [W].
POWER = {"new": 118.0, "run_in": 84.9, "embedded": 43.3}


def height(coefficients, x):
    value = 0.0
    for c in coefficients:
        value = value * x + c
    return value


def number(text):
    return float(text.split()[0])


def fragment_numbers(path):
    """All keys of a fragment; numbers as numbers, whatever their unit."""

    def flat(table, head=""):
        for key, value in table.items():
            if isinstance(value, dict):
                yield from flat(value, head + key + ".")
            else:
                yield head + key, value

    return dict(flat(tomllib.loads(path.read_text())))


class MeasuredTest(program.ProgramTest):
    def values_of(self, folder, ring):
        of = {part: tomllib.loads((folder / f"{ring}_{part}.toml").read_text()) for part in PARTS}
        contact = of["contact"]["contact"]
        return (
            number(contact["asperity_density"]),
            number(contact["asperity_radius"]),
            number(contact["roughness"]),
            of["shear_strength"]["contact"]["boundary_shear_strength_coefficient"],
            of["face"]["ring"]["face"]["coefficients"],
        ), of

    def assert_gives_the_paper_back(self, folder):
        for ring in RINGS:
            (density, radius, roughness, zeta, face), of = self.values_of(folder, ring)
            expected = PAPER[ring]
            for got, want in ((density, expected[0]), (radius, expected[1]), (roughness, expected[2])):
                self.assertAlmostEqual(got / want, 1, delta=1e-4, msg=ring)  # the files round heights far below
            self.assertAlmostEqual(zeta / expected[3], 1, delta=1e-4, msg=ring)  # voltages have four decimals
            measured = of["shear_strength"]["contact"]["measured"]["shear_strength"]
            self.assertGreater(measured["reference_deviation"], 5 * measured["slope_deviation"])
            self.assertAlmostEqual(measured["reference_deviation"] / zeta, 0.03 / 0.18, delta=1e-4)
            # Noise of 0.01 um on 1200 points: 7 coefficients hold 0.01 sqrt(7/1200) = 0.0008 um rms, six times that at
            # the edges.
            far = max(abs(height(face, 0.001 * k) - height(expected[4], 0.001 * k)) for k in range(1201))
            self.assertLess(far, 0.005, ring)
            self.assertGreater(far, 1e-5, "the trace has noise")
            self.assertAlmostEqual(number(of["face"]["ring"]["face"]["measured"]["residual_rms"]), 0.01, delta=0.001)

    def cycle_of(self, path):
        """The values of a case's cycle."""
        printed = json.loads(self.run_well("run", str(path), "--json"))
        return {name: value for name, value in printed.items() if isinstance(value, (int, float))}

    def shipped_copy(self):
        """cases/ and data/ of the checkout, to be corrupted."""
        folder = self.folder / "shipped"
        for name in ("cases", "data"):
            shutil.copytree(SOURCES / name, folder / name)
        return folder

    def with_shipped(self, folder, *words):
        return self.run_program(*words, env={**os.environ, "RINGFILM_DATA": str(folder)})


class OneCommand(MeasuredTest):
    def test_tables_cycles_pages_and_report_come_from_the_files(self):
        printed = self.run_well("reproduce", "measured", "--output", "out")
        out = self.folder / "out"
        self.assert_gives_the_paper_back(out)
        self.assertEqual(printed.count("Table 1: N [um-2]"), 3)
        self.assertNotIn("TOO FAR OFF", printed)
        self.assertIn("SYNTHETIC", printed)
        self.assertIn("one region +- ", printed)
        for ring in RINGS:
            values = self.cycle_of(f"out/{ring}.toml")
            self.assertAlmostEqual(values["mean_power_loss"] / POWER[ring], 1, delta=0.005, msg=ring)
            self.assertTrue((out / f"{ring}.nc").stat().st_size > 10000)
            for part in PARTS:
                page = (out / f"{ring}_{part}.html").read_text()
                self.assertIn("</html>", page)
                self.assertTrue((out / f"{ring}_{part}.nc").is_file())
            self.assertIn("</html>", (out / f"surface_{ring}.html").read_text())
        self.assertIn("</html>", (out / "surface_liner.html").read_text())
        report = (out / "report.html").read_text()
        for word in ("new", "run-in", "embedded"):
            self.assertIn(f"Measured chain, {word} ring (synthetic instrument files)", report)
        lines = [line for line in printed.splitlines() if "styles2014  " in line or "measured  " in line]
        self.assertEqual(len(lines), 12)  # six values, each of both

    @unittest.skipUnless("RINGFILM_TEST_ALL" in os.environ, "a minute: script/test --all")
    def test_band_of_friction_has_every_law(self):
        printed = self.run_well("reproduce", "measured", "--output", "out", "--friction-band")
        for ring in RINGS:
            for part in ("law", "friction_band"):
                self.assertIn("</html>", (self.folder / "out" / f"{ring}_{part}.html").read_text())
        lines = [line for line in printed.splitlines() if line.startswith("  Greenwood-Tripp as")]
        power = [float(line.split()[-4]) for line in lines[1::2]]  # after lambda ratio and film
        self.assertEqual(len(power), len(RINGS))
        for found, expected in zip(power, POWER.values()):
            self.assertAlmostEqual(found / expected, 1, delta=0.005)

    def test_shipped_fragments_are_those_that_the_chain_writes(self):
        self.run_well("reproduce", "measured", "--output", "out")
        for ring in RINGS:
            for part in PARTS:
                name = f"{ring}_{part}.toml"
                here = fragment_numbers(self.folder / "out" / name)
                there = fragment_numbers(SOURCES / "cases" / "measured" / "fragments" / name)
                self.assertEqual(list(here), list(there), name)
                for key, value in here.items():
                    if isinstance(value, str) and re.match(r"-?\d", value):
                        self.assertEqual(value.split()[1:], there[key].split()[1:], f"{name}: {key}")
                        value, other = number(value), number(there[key])
                    else:
                        other = there[key]
                    for a, b in zip(value, other) if isinstance(value, list) else [(value, other)]:
                        if isinstance(a, str):
                            self.assertEqual(a, b, f"{name}: {key}")
                        else:  # another libm may round the last digits differently
                            self.assertAlmostEqual(a, b, delta=1e-6 * abs(b) + 1e-12, msg=f"{name}: {key}")

    def test_shipped_cases_run(self):
        for ring in RINGS:
            values = self.cycle_of(SOURCES / "cases" / "measured" / f"{ring}.toml")
            self.assertAlmostEqual(values["mean_power_loss"] / POWER[ring], 1, delta=0.005, msg=ring)

    def test_files_that_give_something_else_are_reported(self):
        shipped = self.shipped_copy()
        loops = shipped / "cases" / "measured" / "loops_new.csv"
        lines = loops.read_text().splitlines()
        for i, line in enumerate(lines):
            cells = line.split(",")
            if len(cells) == 5 and cells[0][0].isdigit():
                # 5 % more friction: the part in which both ways differ.
                trace, retrace = float(cells[3]), float(cells[4])
                more = 0.05 * (trace - retrace) / 2
                lines[i] = ",".join(cells[:3] + [f"{trace + more:.4f}", f"{retrace - more:.4f}"])
        loops.write_text("\n".join(lines) + "\n")
        done = self.with_shipped(shipped, "reproduce", "measured", "--output", "out")
        self.assertEqual(done.returncode, 4, done.stderr)
        reported = [line for line in done.stdout.splitlines() if "TOO FAR OFF" in line]
        self.assertEqual(len(reported), 1, reported)
        self.assertIn("Table 2: zeta", reported[0])
        self.assertIn("+5.0", reported[0])
        self.assertTrue((self.folder / "out" / "report.html").is_file())

    def test_a_damaged_file_is_refused_with_its_name(self):
        shipped = self.shipped_copy()
        liner = shipped / "cases" / "measured" / "liner.sur"
        liner.write_bytes(liner.read_bytes()[:1000])
        done = self.with_shipped(shipped, "reproduce", "measured", "--output", "out")
        self.assert_reported(done, "liner.sur")

    def test_inputs_are_not_written_over(self):
        shipped = self.shipped_copy()
        measured = shipped / "cases" / "measured"
        before = {path.name: path.stat().st_mtime_ns for path in measured.iterdir()}
        done = self.with_shipped(shipped, "reproduce", "measured", "--output", str(measured))
        self.assert_refused(done, "is the folder of what is read")
        self.assertEqual(before, {path.name: path.stat().st_mtime_ns for path in measured.iterdir()})

    def test_other_names_are_refused_with_those_that_are_known(self):
        done = self.run_program("reproduce", "measurd")
        self.assert_refused(done, "no publication is called measurd", "styles2014, and measured")

    def assert_reported(self, done, *fragments):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for fragment in fragments:
            self.assertIn(fragment, done.stderr)


class SingleCommands(MeasuredTest):
    def test_the_commands_of_the_manual_give_the_same(self):
        page = (SOURCES / "docs" / "manual" / "measured-chain.md").read_text()
        blocks = re.findall(r"^```sh\n(.*?)^```$", page, re.M | re.S)
        self.assertEqual(len(blocks), 3)
        self.assertEqual(blocks.pop(0), "ringfilm reproduce measured\n")  # tested by itself
        for name in ("cases", "data"):
            (self.folder / name).symlink_to(SOURCES / name)
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "ringfilm").symlink_to(program.PROGRAM)
        environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}"}
        for block in blocks:
            done = subprocess.run(
                ["sh", "-e"], input=block, cwd=self.folder, env=environment, capture_output=True, text=True, timeout=200
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual(done.stderr, "")
        chain = self.folder / "chain"
        self.assert_gives_the_paper_back(chain)
        self.assertIn("</html>", (chain / "report.html").read_text())
        self.run_well("reproduce", "measured", "--output", "out")
        for ring in RINGS:
            for part in PARTS:
                name = f"{ring}_{part}.toml"
                self.assertEqual(fragment_numbers(chain / name), fragment_numbers(self.folder / "out" / name), name)
            self.assertEqual(self.cycle_of(chain / f"{ring}.toml"), self.cycle_of(f"out/{ring}.toml"), ring)
        for name in ("flat.x3p", "rough.sur", "liner.gsf", "sprayed.csv"):
            self.assertGreater((self.folder / name).stat().st_size, 10000, name)


if __name__ == "__main__":
    unittest.main()
