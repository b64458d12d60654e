"""`script/test-summary FILE`: a skipped test is not a passed one, and is listed with its reason."""

import pathlib
import subprocess
import sys
import tempfile
import unittest
from xml.sax.saxutils import escape, quoteattr

import program

SCRIPT = program.SOURCES / "script" / "test-summary"

GOOGLETEST = """\
[ RUN      ] AtomicFile.IsRefused
/tests/atomic_file_test.cpp:142: Skipped
root may write
everywhere

[  SKIPPED ] AtomicFile.IsRefused (0 ms)
"""


def entry(name, output="", status="run", skipped=None):
    mark = "" if skipped is None else f"<skipped message={quoteattr(skipped)}/>"
    return (
        f'<testcase name={quoteattr(name)} status="{status}">{mark}<system-out>{escape(output)}</system-out></testcase>'
    )


class TestSummary(unittest.TestCase):
    def summary(self, *entries):
        with tempfile.TemporaryDirectory(prefix="ringfilm-summary-") as folder:
            path = pathlib.Path(folder) / "tests.xml"
            path.write_text(f"<testsuite>{''.join(entries)}</testsuite>")
            done = subprocess.run([sys.executable, SCRIPT, path], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.splitlines()

    def test_a_skipped_test_of_googletest_is_not_counted_as_passed_and_has_its_reason(self):
        lines = self.summary(
            entry("A.B"), entry("AtomicFile.IsRefused", GOOGLETEST, "notrun", "SKIP_REGULAR_EXPRESSION_MATCHED")
        )
        self.assertEqual(
            lines, ["1 passed, 0 failed, 1 skipped", "skipped: AtomicFile.IsRefused: root may write everywhere"]
        )

    def test_what_a_program_skipped_inside_is_counted_one_by_one(self):
        lines = self.summary(
            entry("cli.run_test", "\nSKIPPED run_test.Run.test_it: python3-xarray is not installed\nOK (skipped=1)\n"),
            entry("python.run_test", "SKIPPED [2] run_test.py:132: this case is solved by now\n5 passed, 2 skipped\n"),
        )
        self.assertEqual(
            lines,
            [
                "2 passed, 0 failed, 3 skipped",
                "skipped: cli.run_test run_test.Run.test_it: python3-xarray is not installed",
                "skipped: python.run_test run_test.py:132: this case is solved by now (2 tests)",
            ],
        )

    def test_a_whole_program_that_was_skipped_has_its_reason(self):
        lines = self.summary(
            entry("page", "SKIPPED: no chromium is installed.\n", "notrun", "SKIP_RETURN_CODE=77"),
            entry(
                "kernels",
                'C++ exception: there are no kernels "avx2" here\n',
                "notrun",
                "SKIP_REGULAR_EXPRESSION_MATCHED",
            ),
            entry("off", "", "disabled", "Disabled"),
        )
        self.assertEqual(
            lines,
            [
                "0 passed, 0 failed, 3 skipped",
                'skipped: kernels: C++ exception: there are no kernels "avx2" here',
                "skipped: off: the test is disabled",
                "skipped: page: no chromium is installed.",
            ],
        )

    def test_a_skipped_test_without_a_reason_reports_it(self):
        lines = self.summary(entry("cli.silent_test", "OK (skipped=1)\n"))
        self.assertEqual(
            lines, ["1 passed, 0 failed, 1 skipped", "skipped: cli.silent_test: the test states no reason"]
        )

    def test_a_test_that_failed_or_could_not_be_started_is_a_failed_one(self):
        lines = self.summary(
            entry("A.B", "boom", "fail"), entry("gone", "", "notrun", "Unable to find executable: gone")
        )
        self.assertEqual(
            lines, ["0 passed, 2 failed, 0 skipped", "failed: A.B", "failed: gone: Unable to find executable: gone"]
        )


if __name__ == "__main__":
    unittest.main()
