"""`ringfilm verify --trends` as its users meet it; the trends themselves are tests of their own."""

import json
import os
import re
import shutil
import tomllib
import unittest

from program import SOURCES, ProgramTest

TRENDS = SOURCES / "verification" / "measured_trends"
FAST = "blow-by-heavy-duty"  # the gas alone, of a case of the folder


class TrendsTest(ProgramTest):
    def with_change(self, before, after, *words):
        """Runs the trends of a shipped folder of our own, in which a text is replaced."""
        shipped = self.folder / "shipped"
        shutil.rmtree(shipped, ignore_errors=True)
        (shipped / "cases").mkdir(parents=True)
        shutil.copytree(SOURCES / "data", shipped / "data")
        shutil.copytree(TRENDS, shipped / "verification" / "measured_trends")
        path = shipped / "verification" / "measured_trends" / "trends.toml"
        text = path.read_text()
        self.assertIn(before, text)
        path.write_text(text.replace(before, after, 1))
        return self.run_program("verify", "--trends", *words, env={**os.environ, "RINGFILM_DATA": str(shipped)})

    def test_prints_what_was_published_and_what_is_computed(self):
        printed = self.run_well("verify", "--trends", FAST)
        self.assertRegex(printed, rf"^{FAST}: agrees\n  published .*\n  source .*\n  compared .*\n  computed .* l/min")
        self.assertIn("1 of 1 trends agree, 1 are as recorded; 0 cannot be expressed", printed)

    def test_json_has_the_same(self):
        found = json.loads(self.run_well("verify", "--trends", FAST, "top-ring-nitriding", "--json"))
        (trend,) = found["trends"]
        self.assertEqual((trend["id"], trend["outcome"], trend["as_recorded"]), (FAST, "agrees", True))
        self.assertLess(trend["limits"][0], trend["levels"][0]["value"])
        self.assertEqual([one["id"] for one in found["inexpressible"]], ["top-ring-nitriding"])

    def test_lists_every_trend(self):
        tables = tomllib.loads((TRENDS / "trends.toml").read_text())
        ids = [trend["id"] for kind in ("trend", "inexpressible") for trend in tables[kind]]
        printed = self.run_well("verify", "--trends", "--list")
        self.assertEqual([line.split()[0] for line in printed.splitlines()], ids)

    def test_each_source_is_an_entry_of_the_bibliography_or_no_key(self):
        keys = set(re.findall(r"^@\w+\{(\w+),", (SOURCES / "docs" / "references.bib").read_text(), re.M))
        tables = tomllib.loads((TRENDS / "trends.toml").read_text())
        for trend in tables["trend"] + tables["inexpressible"]:
            for key in re.findall(r"\b[a-z]+(?:19|20)\d\d\b", trend["source"]):
                self.assertIn(key, keys, trend["id"])

    def test_an_outcome_that_is_not_the_recorded_one_fails_with_exit_code_4(self):
        done = self.with_change('limits = ["3.5 l/min", "14 l/min"]', 'limits = ["1 l/min", "2 l/min"]', FAST)
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertIn(f"{FAST}: disagrees, NOT AS RECORDED (agrees)", done.stdout)
        better = 'limits = ["3.5 l/min", "14 l/min"]\nknown = "disagrees"\nreason = "none"\n#'
        done = self.with_change('limits = ["3.5 l/min", "14 l/min"]\n', better, FAST)
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertIn(f"{FAST}: agrees, NOT AS RECORDED (disagrees)", done.stdout)

    def test_faults_are_reported_with_their_place(self):
        self.assert_refused(
            self.with_change('quantity = "blow_by_flow"', 'quantity = "blow_by"', FAST),
            "trends.toml:",
            'trend.quantity = "blow_by" is not a value of the cycle or of the gas between rings',
        )
        self.assert_refused(self.with_change('expect = "within"', 'expect = "witin"', FAST), "did you mean within?")
        self.assert_refused(
            self.with_change('base = "heavy-duty pack"', 'base = "heavy duty"', FAST), "is not the name of a [[base]]"
        )
        self.assert_refused(
            self.with_change('{ name = "1800 rpm", set = [] }', '{ name = "1800 rpm", set = ["x=1"] }', FAST),
            f"trend {FAST}, 1800 rpm: ",
        )

    def test_what_is_unknown_or_without_meaning_is_refused(self):
        self.assert_refused(self.run_program("verify", "--trends", "sped"), "no trend has sped in its id")
        self.assert_refused(self.run_program("verify", "--trends", "-o", "x.html"), "--trends has no page")


if __name__ == "__main__":
    unittest.main(verbosity=2)
