"""The accuracy of a study: which one is asked for, and what a sample of its scenarios shows."""

import csv
import json
import re
import unittest

from program import CASE
from study import STUDY, StudyFolder

SAMPLE = "[accuracy]\nsample = 4\n"
WITHOUT_CELLS = CASE.replace("[solver]\ncells = 60\n", "")


class StudyAccuracyTest(StudyFolder):
    def write_study(self, further=""):
        (self.folder / "study.toml").write_text(STUDY.replace("SCENARIOS", "8") + further)

    def write_case(self, text):
        (self.folder / "case.toml").write_text(text)

    def rows(self, output):
        with open(self.folder / output / "study.csv", newline="") as file:
            return list(csv.DictReader(file))

    def page_data(self, output):
        page = (self.folder / output / "study.html").read_text()
        data = page[page.index('id="result-data">') + len('id="result-data">') :]
        return json.loads(data[: data.index("</script>")])

    def test_half_a_percent_is_asked_for_where_no_cells_are_stated(self):
        self.write_case(WITHOUT_CELLS)
        self.write_study(SAMPLE)
        printed = self.run_well("study", "study.toml", "-o", "out")
        self.assertIn("8 of 8  accuracy-asked-for: solver.accuracy = 0.5 %: computed on 72 by-gap cells", printed)
        self.assertIn("integrating 4 of 8 scenarios again", printed)
        self.assertRegex(printed, r"  \d+\.\d % of their \d+ values are within the 0\.5 % asked for")
        self.assertRegex(printed, r"relative error, 95 % quantile: .*fmep \S+ %")
        self.write_case(WITHOUT_CELLS + '[solver]\naccuracy = "0.5 %"\n')
        self.run_well("study", "study.toml", "-o", "stated")
        values = [[{**row, "scenario": ""} for row in self.rows(output)] for output in ("out", "stated")]
        self.assertEqual(*values)

    def test_stated_cells_are_kept_and_not_checked(self):
        self.write_study()
        printed = self.run_well("study", "study.toml", "-o", "out")
        self.assertNotIn("accuracy", printed)
        self.assertIsNone(self.page_data("out")["error"])
        self.write_study(SAMPLE)
        printed = self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertIn("integrating 4 of 8 scenarios again", printed)
        self.assertNotIn("% asked for", printed)
        error = self.page_data("out")["error"]
        self.assertEqual((error["count"], error["coverage"]), (4, None))
        self.assertLess(error["quantiles"]["fmep"], 0.05)

    def test_parts_and_continued_runs_have_the_same_estimate(self):
        self.write_study(SAMPLE)
        self.run_well("study", "study.toml", "-o", "whole", "--threads", "1")
        for part in ("2/3", "1/3", "3/3"):
            self.run_well("study", "study.toml", "-o", "parts", "--shard", part)
        self.run_well("study", "merge", "study.toml", "-o", "parts")
        self.assertEqual(self.contents("whole"), self.contents("parts"))
        for name in ("study.nc", "study.csv", "study.html"):
            (self.folder / "whole" / name).unlink()
        self.run_well("study", "study.toml", "-o", "whole", "--resume")
        self.assertEqual(self.contents("whole"), self.contents("parts"))

    def test_a_larger_error_of_coarse_cells_is_seen(self):
        errors = []
        for cells in (20, 80):
            self.write_case(CASE.replace("cells = 60", f"cells = {cells}"))
            self.write_study(SAMPLE)
            self.run_well("study", "study.toml", "-o", f"out{cells}")
            errors.append(self.page_data(f"out{cells}")["error"]["quantiles"])
        for name in ("mean_viscous_power", "min_film_thickness"):
            self.assertGreater(errors[0][name], errors[1][name], name)

    def test_a_sample_that_cannot_be_taken_is_refused(self):
        for lines, words in (
            ("[accuracy]\nsample = -1\n", "sample = -1 is not a whole number"),
            ("[accuracy]\nsample = 20000\n", "accuracy.sample = 20000 is out of range"),
            ("[accuracy]\nsamples = 4\n", "unknown key samples in [accuracy]; did you mean sample?"),
        ):
            self.write_study(lines)
            refused = self.run_program("study", "study.toml", "-o", "out")
            self.assert_refused(refused, words)
            self.assertTrue(re.search(r"study\.toml:\d+:\d+: ", refused.stderr), refused.stderr)


if __name__ == "__main__":
    unittest.main()
