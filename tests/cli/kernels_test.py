"""The same numbers on every kind of machine: RINGFILM_KERNELS, and a processor without AVX."""

import json
import os
import pathlib
import platform
import shutil
import subprocess
import unittest

import program

RUN = ("run", "case.toml", "--json")
EMULATOR = "qemu-x86_64"
# The kinds of machine differ in the rounding of fused products and of the mathematical library, 1e-16, of which the
# integration makes 1e-13 at the most of some hundred engines.
ROUNDING = 1e-9


class Kernels(program.ProgramTest):
    def run_with(self, kernels, *before):
        environment = {**os.environ, "RINGFILM_KERNELS": kernels}
        return subprocess.run(
            [*before, program.PROGRAM, *RUN],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=120,
            env=environment,
        )

    def values_of(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        return {name: value for name, value in json.loads(done.stdout).items() if isinstance(value, float)}

    def assert_same(self, values, expected):
        self.assertGreater(len(expected), 30)
        self.assertEqual(values.keys(), expected.keys())
        for name, value in expected.items():
            self.assertAlmostEqual(values[name], value, delta=ROUNDING * abs(value), msg=name)

    def emulator(self):
        if platform.machine() not in ("x86_64", "AMD64"):
            program.skip_loudly(self, "there are no older machines of this kind")
        if shutil.which(EMULATOR) is None:
            program.skip_loudly(self, f"{EMULATOR} is missing (Debian: qemu-user): no machine without AVX to try")
        if b"__asan_init" in pathlib.Path(program.PROGRAM).read_bytes():
            program.skip_loudly(self, "the address sanitizer does not run in an emulator")
        return EMULATOR, "-cpu", "Nehalem"

    def test_unknown_ones_are_refused_and_the_known_ones_named(self):
        self.assert_refused(self.run_with("nonsense"), '"nonsense"', "RINGFILM_KERNELS", "baseline")

    def test_every_width_gives_the_same_values(self):
        widest = self.values_of(self.run_with(""))
        self.assert_same(self.values_of(self.run_with("baseline")), widest)
        avx2 = self.run_with("avx2")
        if avx2.returncode == 2 and "that this machine can run" in avx2.stderr:
            program.skip_loudly(self, "this machine has no AVX2")
        self.assert_same(self.values_of(avx2), widest)

    def test_a_processor_without_avx_gives_the_same_values(self):
        emulated = self.emulator()
        self.assert_same(self.values_of(self.run_with("", *emulated)), self.values_of(self.run_with("baseline")))

    def test_a_processor_without_avx_is_offered_no_more_than_it_can_run(self):
        emulated = self.emulator()
        self.assert_refused(self.run_with("avx2", *emulated), "RINGFILM_KERNELS to one of baseline, or")


if __name__ == "__main__":
    unittest.main(verbosity=2)
