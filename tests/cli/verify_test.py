"""`ringfilm verify` as its users meet it, and the independent scripts behind its numbers."""

import json
import os
import re
import shutil
import subprocess
import tomllib
import unittest

from program import LONGEST, SOURCES, ProgramTest

CASES = SOURCES / "verification"


class VerifyTest(ProgramTest):
    def copy_of_shipped(self, *names):
        """A shipped folder of our own with some of the verifications."""
        shipped = self.folder / "shipped"
        for name in ("cases", "data"):
            (shipped / name).mkdir(parents=True)
        for name in names:
            shutil.copytree(CASES / name, shipped / "verification" / name)
        shutil.copy(CASES / "not-covered.toml", shipped / "verification")
        return shipped

    def verify_in(self, shipped, *words):
        return self.run_program("verify", *words, env={**os.environ, "RINGFILM_DATA": str(shipped)})

    def test_prints_names_expected_numbers_and_verdicts(self):
        printed = self.run_well("verify", "rayleigh1918_step")
        self.assertIn("load of the best step", printed)
        self.assertRegex(printed, r"8 of 8 checks hold in 1 cases?")
        self.assertNotIn("FAILS", printed)

    def test_the_page_is_named_by_html_as_of_the_measuring_commands(self):
        self.run_well("verify", "rayleigh1918_step", "--output", "a.html")
        self.assertIn("wrote b.html", self.run_well("verify", "rayleigh1918_step", "--html", "b.html"))
        self.assertEqual((self.folder / "a.html").read_bytes(), (self.folder / "b.html").read_bytes())

    def test_a_page_never_replaces_what_the_checks_are_read_from(self):
        shipped = self.copy_of_shipped("rayleigh1918_step")
        reference = shipped / "verification" / "rayleigh1918_step" / "reference.toml"
        before = reference.read_bytes()
        self.assertEqual(self.verify_in(shipped, "--output", str(reference)).returncode, 2)
        self.assertEqual(reference.read_bytes(), before)

    def test_a_folder_without_its_numbers_is_a_fault_and_not_passed_over(self):
        shipped = self.copy_of_shipped("rayleigh1918_step", "reynolds1886_channel")
        (shipped / "verification" / "reynolds1886_channel" / "reference.toml").unlink()
        done = self.verify_in(shipped)
        self.assertEqual(done.returncode, 2)
        self.assertIn("reynolds1886_channel", done.stderr)

    def test_lists_every_folder_that_holds_numbers(self):
        printed = self.run_well("verify", "--list")
        folders = sorted(path.parent.name for path in CASES.glob("*/reference.toml"))
        self.assertEqual([line.split()[0] for line in printed.splitlines()], folders)
        self.assertGreaterEqual(len(folders), 15)

    def test_is_the_same_every_time(self):
        names = ("ausas2009_oscillating_squeeze", "roache2002_manufactured")
        self.assertEqual(self.run_well("verify", "--json", *names), self.run_well("verify", "--json", *names))

    def test_wrong_expectation_fails_with_exit_code_4(self):
        shipped = self.copy_of_shipped("rayleigh1918_step")
        path = shipped / "verification" / "rayleigh1918_step" / "reference.toml"
        path.write_text(re.sub(r'expected = "20626\.\d+ N/m"', 'expected = "20627.7 N/m"', path.read_text()))
        done = self.verify_in(shipped)
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertIn("(exit code 4)", done.stderr)
        self.assertRegex(done.stdout, r"load of the best step .* FAILS")
        self.assertIn("7 of 8 checks hold", done.stdout)
        page = self.verify_in(shipped, "--output", "page.html")
        self.assertEqual(page.returncode, 4)
        self.assertIn('"verdict":"fails"', (self.folder / "page.html").read_text())

    def test_wrong_order_fails_with_exit_code_4(self):
        shipped = self.copy_of_shipped("barus1893_slider")
        path = shipped / "verification" / "barus1893_slider" / "reference.toml"
        path.write_text(path.read_text().replace("order = 2", "order = 3"))
        done = self.verify_in(shipped, "--json")
        self.assertEqual(done.returncode, 4)
        rows = {row["label"]: row["verdict"] for row in json.loads(done.stdout)["cases"][0]["rows"]}
        self.assertEqual(rows["order in cells"], "fails")
        self.assertEqual(rows["load"], "holds")

    def test_names_what_it_does_not_cover_and_its_page_carries_every_case_and_asks_nobody(self):
        printed = self.run_well("verify", "--output", "verification.html", timeout=2 * LONGEST)
        self.assertIn("NOT COVERED", printed)
        self.assertIn("distorted bore", printed)
        page = (self.folder / "verification.html").read_text()
        self.assertIn("wrote verification.html", printed)
        for folder in CASES.glob("*/reference.toml"):
            self.assertIn(folder.parent.name, page)
        self.assertNotIn("<script src", page)

    def test_faults_of_a_reference_are_reported_with_their_place(self):
        shipped = self.copy_of_shipped("rayleigh1918_step")
        path = shipped / "verification" / "rayleigh1918_step" / "reference.toml"
        text = path.read_text()
        text = text.replace('quantity = "load"', 'quantity = "laod"', 1).replace("relative_tolerance", "tolerance", 1)
        path.write_text(text.replace('expected = "4125347.7 Pa"', "expected = 4125347.7"))
        done = self.verify_in(shipped)
        self.assert_refused(
            done,
            "reference.toml:4:12",
            "did you mean load?",
            "value.expected = 4125347.7 has no unit",
            "unknown key tolerance in [[value]]",
        )

    def test_a_pack_has_no_single_value(self):
        shipped = self.copy_of_shipped("rayleigh1918_step")
        folder = shipped / "verification" / "rayleigh1918_step"
        for name in ("cases", "data"):
            shutil.copytree(SOURCES / name, shipped / name, dirs_exist_ok=True)
        (folder / "reference.toml").write_text(
            '[[value]]\nlabel = "friction"\ncase = "../../cases/ring-pack/three_rings.toml"\nquantity = "fmep"\n'
            'expected = "9 kPa"\nrelative_tolerance = 0.5\nsource = "none"\nbecause = "of one ring"\n'
        )
        self.assert_refused(
            self.verify_in(shipped), "reference.toml", "three_rings.toml is a pack of 3 rings", "a case of one ring"
        )

    def test_ladders_times_and_columns_that_cannot_be_are_reported_with_their_place(self):
        shipped = self.copy_of_shipped(
            "roache2002_manufactured", "reynolds1886_squeezed_plates", "styles2014_independent_model"
        )
        shutil.copytree(SOURCES / "cases" / "styles2014", shipped / "cases" / "styles2014")

        def with_change(name, file, before, after):
            path = shipped / "verification" / name / file
            text = path.read_text()
            self.assertIn(before, text)
            path.write_text(text.replace(before, after, 1))
            done = self.verify_in(shipped, name)
            path.write_text(text)
            return done

        manufactured = lambda before, after: with_change("roache2002_manufactured", "reference.toml", before, after)
        self.assert_refused(manufactured("cells = 1600\n", ""), "[[order]] has no cells")
        self.assert_refused(
            manufactured("cells = 1600", "cells = -2"),
            "order.cells = -2 is not a whole number",
            "whole number from 2 to 100000",
        )
        self.assert_refused(manufactured("[50, 100", "[50.5, 100"), "order.cells = 50.5 is not a whole number")
        plates = lambda before, after: with_change("reynolds1886_squeezed_plates", "reference.toml", before, after)
        self.assert_refused(
            plates('time = "5 ms"', 'time = "10 s"'), "reference.toml:5:8", "outside the history of approach.toml"
        )
        curve = lambda file, before, after: with_change("styles2014_independent_model", file, before, after)
        self.assert_refused(
            curve("new_1500_reynolds.csv", "hmin_m,", "hmin_m [s],"), "new_1500_reynolds.csv:1:", "hmin_m"
        )
        self.assert_refused(
            curve("reference.toml", 'column = "hmin_m"', 'column = "xcav1_m"'),
            "new_1500_reynolds.csv:2:",
            "nan is not a finite number",
        )

    def test_unknown_name_is_refused(self):
        done = self.run_program("verify", "rayleigh1918_stepp")
        self.assert_refused(done, "no verification is called rayleigh1918_stepp")


class OracleTest(ProgramTest):
    """The numbers of reference.toml are those that the scripts beside them work out, with no line of the program."""

    def test_scripts_work_out_the_expected_numbers(self):
        worked_out = 0
        for name in sorted(path.parent.name for path in CASES.glob("*/reference.py")):
            (case,) = json.loads(self.run_well("verify", "--json", name))["cases"]
            script = CASES / case["name"] / "reference.py"
            numbers = json.loads(
                subprocess.run(["/usr/bin/python3", str(script)], capture_output=True, text=True, check=True).stdout
            )
            labels = {row["label"] for row in case["rows"]}
            self.assertLessEqual(set(numbers), labels, case["name"])
            for row in case["rows"]:
                # An order is compared with the slope that the scheme claims; its known number is held below.
                if row["label"] not in numbers or row["quantity"].startswith("order in"):
                    continue
                # Eight digits are in the file.
                self.assertAlmostEqual(row["expected"] / numbers[row["label"]], 1, delta=6e-8, msg=row["label"])
                worked_out += 1
        self.assertGreater(worked_out, 60)

    def test_orders_and_bounds_rest_on_the_numbers_of_their_values(self):
        held = 0
        for path in CASES.glob("*/reference.toml"):
            tables = tomllib.loads(path.read_text())
            known = {(v["case"], v["quantity"], v.get("time")): v["expected"] for v in tables.get("value", [])}
            for check in tables.get("order", []) + tables.get("bound", []):
                key = (check.get("case"), check.get("quantity"), check.get("time"))
                if key in known:
                    self.assertEqual(check["expected"], known[key], f"{path.parent.name}: {check['label']}")
                    held += 1
        self.assertGreater(held, 10)

    def test_maps_are_those_that_the_oracles_write(self):
        written = {
            "bertocchi2013_pocketed_pad/gap_10.csv": ["--gap", "10"],
            "bertocchi2013_pocketed_pad/gap_300.csv": ["--gap", "300"],
            "woloszynski2015_textured_pad/gap.csv": ["--gap"],
        }
        for file, options in written.items():
            script = (CASES / file).parent / "oracle.py"
            rows = subprocess.run(
                ["/usr/bin/python3", str(script), *options], capture_output=True, text=True, check=True
            )
            self.assertEqual(rows.stdout, (CASES / file).read_text(), file)


if __name__ == "__main__":
    unittest.main(verbosity=2)
