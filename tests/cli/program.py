"""The program under test, a scratch folder, and a small case that is valid until a test corrupts it."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("RINGFILM_PROGRAM", "")
SOURCES = pathlib.Path(__file__).resolve().parents[2]

TRACE = "crank_angle [degree],cylinder_pressure [bar]\n" + "".join(
    # A bell of 40 bar at 15 degree on 1.2 bar, all through the cycle.
    f"{angle},{1.2 + 40 / (1 + ((angle + 180) % 720 - 195) ** 2 / 900):.6f}\n"
    for angle in range(0, 720, 2)
)

CASE = """\
title = "a small case"
[engine]
bore = "89 mm"
stroke = "79.5 mm"
connecting_rod_length = "138.1 mm"
[operating]
speed = "1500 rpm"
oil_temperature = "120 degC"
[gas]
model = "trace"
cylinder_pressure = "trace.csv"
pressure_reference = "absolute"
angle_zero = "firing-tdc"
[ring]
face_width = "1.2 mm"
elastic_pressure = "0.2 MPa"
[ring.face]
form = "parabola"
crown_height = "15 um"
[contact]
asperity_density = "0.097 um-2"
asperity_radius = "1.56 um"
roughness = "0.48 um"
boundary_shear_strength_coefficient = 0.3581
[lubricant]
kinematic_viscosity = [{ temperature = "40 degC", value = "59.99 mm2/s" },
                       { temperature = "100 degC", value = "9.59 mm2/s" }]
density = [{ temperature = "15 degC", value = "849.7 kg/m3" }, { temperature = "40 degC", value = "833.8 kg/m3" }]
[solver]
cells = 60
"""


# What a study that takes longer than ten seconds reports.
PROGRESS = re.compile(r"^\S+: \d+ of \d+ done, .*\n", re.MULTILINE)

# AddressSanitizer reserves terabytes of addresses: a limit of memory ends it at its start.
IS_SANITIZED = os.environ.get("RINGFILM_SANITIZED", "") == "1"

LONGEST = 900 if IS_SANITIZED else 120  # a run of the program, in seconds


def skip_loudly(test, reason):
    print(f"\nSKIPPED {test.id()}: {reason}", flush=True)
    test.skipTest(reason)


class ProgramTest(unittest.TestCase):
    """Each test has a folder of its own with case.toml and trace.csv, the working folder of the program."""

    def setUp(self):
        if not PROGRAM:
            self.fail("set RINGFILM_PROGRAM to the program to test")
        scratch = tempfile.TemporaryDirectory(prefix="ringfilm-cli-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "trace.csv").write_text(TRACE)
        (self.folder / "case.toml").write_text(CASE)

    def run_program(self, *words, **how):
        how.setdefault("timeout", LONGEST)
        return subprocess.run([PROGRAM, *words], cwd=self.folder, capture_output=True, text=True, **how)

    def run_well(self, *words, **how):
        done = self.run_program(*words, **how)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(PROGRESS.sub("", done.stderr), "")
        return done.stdout

    def names(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))

    def assert_refused(self, done, *fragments):
        """Exit code 2, every fragment stated on standard error, nothing on standard output."""
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertIn("nothing was run or written (exit code 2)", done.stderr)
        for fragment in fragments:
            self.assertIn(fragment, done.stderr)
