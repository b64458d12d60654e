"""A study is its files, wherever they lie and however they are named: it continues from any folder, and once moved."""

import csv
import shutil
import unittest

from program import CASE, TRACE
from study import STUDY, StudyFolder

ROWS = "study.part-{}-of-2.rows"


class StudyInAnyFolder(StudyFolder):
    """A study in a folder `a` whose base, trace and chosen traces lie in folders of their own."""

    def setUp(self):
        super().setUp()
        self.fill(self.folder / "a")

    def fill(self, folder):
        for name in ("cases", "traces"):
            (folder / name).mkdir(parents=True)
        (folder / "cases" / "base.toml").write_text(CASE.replace('"trace.csv"', '"../traces/trace.csv"'))
        (folder / "traces" / "trace.csv").write_text(TRACE)
        for name, share in (("low", 0.9), ("high", 1.1)):
            head, *rows = TRACE.splitlines()
            points = (row.split(",") for row in rows)
            text = head + "\n" + "".join(f"{angle},{share * float(p):.6f}\n" for angle, p in points)
            (folder / "traces" / f"{name}.csv").write_text(text)
        self.write_study(folder)

    def write_study(self, folder, case="cases/base.toml", low="traces/low.csv", high="traces/high.csv"):
        traces = f'[[factor]]\nname = "trace"\nkey = "gas.cylinder_pressure"\nvalues = ["{low}", "{high}"]\n[plan]\n'
        text = STUDY.replace('case = "case.toml"', f'case = "{case}"').replace("[plan]\n", traces)
        (folder / "s.toml").write_text(text.replace("SCENARIOS", "12"))

    def within(self, folder, *words):
        """The program started in a folder."""
        before, self.folder = self.folder, folder
        try:
            return self.run_program(*words)
        finally:
            self.folder = before

    def well(self, folder, *words):
        done = self.within(folder, *words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def numbers(self, path):
        with open(path, newline="") as file:
            return [list(row.values()) for row in csv.DictReader(file)]

    def test_a_study_that_was_run_in_its_folder_is_known_from_any_other(self):
        self.well(self.folder / "a", "study", "s.toml", "-o", "s.nc")
        (self.folder / "b").mkdir()
        for folder, study in (
            (self.folder, "a/s.toml"),
            (self.folder, "./b/../a/s.toml"),
            (self.folder / "b", "../a/s.toml"),
            (self.folder / "b", str(self.folder / "a" / "s.toml")),
        ):
            with self.subTest(study):
                output = study.replace(".toml", ".nc")
                printed = self.well(folder, "study", "status", study, "-o", output)
                self.assertIn("part 1 of 1: 12 of 12 scenarios, 0 not solved, finished\n", printed)
                before = (self.folder / "a" / "s.part-1-of-1.rows").read_bytes()
                self.well(folder, "study", study, "-o", output, "--resume")
                self.well(folder, "study", "merge", study, "-o", output)
                self.assertEqual((self.folder / "a" / "s.part-1-of-1.rows").read_bytes(), before)

    def test_parts_that_were_computed_in_different_folders_are_joined_in_another(self):
        a = self.folder / "a"
        self.well(a, "study", "s.toml", "-o", "whole")
        self.well(a, "study", "s.toml", "-o", "out", "--shard", "1/2")
        moved = self.folder / "deep" / "moved"
        moved.parent.mkdir()
        shutil.move(a, moved)
        self.well(self.folder, "study", "deep/moved/s.toml", "-o", "deep/moved/out", "--shard", "2/2")
        # What was begun is continued: cut off within its last block.
        rows = moved / "out" / ROWS.format(2)
        growing = rows.with_suffix(".growing")
        growing.write_bytes(rows.read_bytes()[:-1])
        rows.unlink()
        words = ("study", "submit", "moved/s.toml", "-o", "moved/out", "--engine", "slurm", "--dry-run")
        self.assertIn("#SBATCH --array=2\n", self.well(self.folder / "deep", *words))
        self.well(moved.parent, "study", "moved/s.toml", "-o", "moved/out", "--shard", "2/2", "--resume")
        self.well(self.folder, "study", "merge", "deep/moved/s.toml", "-o", "deep/moved/out")
        self.assertEqual(self.numbers(moved / "out" / "study.csv"), self.numbers(moved / "whole" / "study.csv"))

    def test_contents_decide_not_names(self):
        a = self.folder / "a"
        self.well(a, "study", "s.toml", "-o", "out")
        status = ("study", "status", "s.toml", "-o", "out")
        (a / "traces" / "low.csv").rename(a / "quiet.csv")
        (a / "cases" / "base.toml").rename(a / "traces" / "engine.toml")
        self.write_study(a, case="traces/engine.toml", low="./quiet.csv")
        self.assertIn("0 not solved, finished\n", self.well(a, *status))
        # The same files, exchanged.
        self.write_study(a, case="traces/engine.toml", low="traces/high.csv", high="quiet.csv")
        self.assertIn("these rows are of ", self.well(a, *status))
        # Under the same names, other contents.
        self.write_study(a, case="traces/engine.toml", low="quiet.csv")
        self.assertIn("0 not solved, finished\n", self.well(a, *status))
        (a / "quiet.csv").write_text(TRACE)
        self.assertIn("these rows are of other input files", self.well(a, *status))


if __name__ == "__main__":
    unittest.main(verbosity=2)
