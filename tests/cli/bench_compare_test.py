"""`script/bench-compare OLD.json NEW.json`: ratios, marks, and the errors of files that it cannot use."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import program

SCRIPT = program.SOURCES / "script" / "bench-compare"


def entry(name, time, unit="ms", repeats=2, **more):
    return {
        "name": f"{name}/iterations:1/repeats:{repeats}/manual_time",
        "run_type": "iteration",
        "iterations": 1,
        "real_time": time,
        "cpu_time": time,
        "time_unit": unit,
        **more,
    }


def run_of(*entries, **context):
    return json.dumps({"context": {"processor": "one", "kernels": "avx2", **context}, "benchmarks": entries})


OLD = run_of(
    entry("batched/200", 4.0, iterations_per_step=2.5),
    entry("batched/200", 2.0, iterations_per_step=2.5),
    entry("steady/200", 1.0),
    entry("gone/200", 1.0),
    {**entry("batched/200", 0.1), "run_type": "aggregate", "aggregate_name": "mean"},
)
NEW = run_of(
    entry("batched/200", 2500.0, "us", repeats=1, iterations_per_step=3.0),
    entry("steady/200", 1.04),
    entry("fresh/200", 1.0),
)


class BenchCompare(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="ringfilm-bench-")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def compare(self, old, new, *words):
        for name, text in (("old.json", old), ("new.json", new)):
            if text is not None:
                (self.folder / name).write_text(text)
        return subprocess.run(
            [sys.executable, str(SCRIPT), "old.json", "new.json", *words],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=60,
        )

    def row(self, done, name):
        """Old, new, ratio and mark of a benchmark."""
        self.assertEqual(done.returncode, 0, done.stderr)
        return next(line.split()[1:] for line in done.stdout.splitlines() if line.startswith(name + " "))

    def assert_refused(self, done, *fragments):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stdout, "")
        for fragment in fragments:
            self.assertIn(fragment, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_the_fastest_repetitions_are_compared_and_what_got_slower_is_marked(self):
        done = self.compare(OLD, NEW)
        self.assertEqual(self.row(done, "batched/200"), ["2", "ms", "2.5", "ms", "1.250", "-", "SLOWER"])
        self.assertEqual(self.row(done, "steady/200"), ["1", "ms", "1.04", "ms", "1.040", "-"])
        self.assertIn("1 of 2 slower by more than 10 %", done.stdout)

    def test_how_much_slower_is_stated(self):
        self.assertEqual(self.row(self.compare(OLD, NEW, "--slower", "30"), "batched/200")[-1], "-")
        self.assertEqual(self.row(self.compare(OLD, NEW, "--slower", "3"), "steady/200")[-1], "SLOWER")
        self.assert_refused(self.compare(OLD, NEW, "--slower", "-1"), "-1 is not a percentage")
        self.assert_refused(self.compare(OLD, NEW, "--slower", "some"), "--slower")

    def test_what_got_faster_is_reported(self):
        self.assertEqual(self.row(self.compare(NEW, OLD), "batched/200")[-1], "faster")

    def test_a_slower_machine_is_taken_out_in_a_column_of_its_own(self):
        done = self.compare(
            run_of(entry("fma-peak", 1.0), entry("batched/200", 2.0)),
            run_of(entry("fma-peak", 1.5), entry("batched/200", 3.0)),
        )
        self.assertEqual(self.row(done, "batched/200")[-3:], ["1.500", "1.000", "SLOWER"])

    def test_counts_that_differ_and_benchmarks_of_one_file_alone_are_reported(self):
        done = self.compare(OLD, NEW)
        self.assertIn("iterations_per_step: 2.5 -> 3\n", done.stdout)
        self.assertIn("only in old.json: gone/200\n", done.stdout)
        self.assertIn("only in new.json: fresh/200\n", done.stdout)

    def test_unlike_machines_are_reported(self):
        self.assertNotIn("NOTE", self.compare(OLD, NEW).stdout)
        self.assertIn("not the same kernels", self.compare(OLD, NEW.replace('"avx2"', '"avx512"')).stdout)

    def test_files_that_cannot_be_used_are_refused(self):
        self.assert_refused(self.compare(OLD, None), "cannot read new.json: No such file")
        self.assert_refused(self.compare(OLD, OLD[: len(OLD) // 2]), "new.json:1:", "broken off")
        self.assert_refused(self.compare("[1]", NEW), "old.json is not a file of Google Benchmark")
        self.assert_refused(self.compare(OLD, run_of({"name": "batched/200"})), "new.json: an entry without")
        self.assert_refused(self.compare(OLD, run_of(entry("steady/200", 0))), "steady/200 took 0 s")
        self.assert_refused(self.compare(OLD, run_of(entry("other/200", 1.0))), "no benchmark in common")


if __name__ == "__main__":
    unittest.main()
