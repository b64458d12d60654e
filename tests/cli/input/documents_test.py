"""What `ringfilm new` writes around a case, engines of the user's own, and what `ringfilm cite` prints."""

import csv
import json
import os
import pathlib
import re
import unittest

import program

SHIPPED = pathlib.Path(os.environ["RINGFILM_DATA"])


class NewDocumentTest(program.ProgramTest):
    def test_studies_and_lives_of_a_ring_and_of_a_pack_are_read_unchanged(self):
        self.run_well("new", "ring.toml")
        self.run_well("new", "pack.toml", "--pack", "turbo-gasoline")
        engine = {"operating-points": ["--engine", "turbo-gasoline"]}
        for case in ("ring", "pack"):
            for kind in ("map", "uncertainty", "compare", "operating-points"):
                name = f"{kind}_{case}.toml"
                printed = self.run_well("new", "study", kind, name, "--case", f"{case}.toml", *engine.get(kind, []))
                self.assertIn(f"next: ringfilm study {name}", printed)
                self.assertLessEqual((self.folder / name).read_text().count("\n"), 60)
                status = self.run_well("study", "status", name, "-o", "none")
                self.assertIn("scenarios", status)
        printed = self.run_well("study", "compare_ring.toml", "-o", "compared")
        self.assertRegex(printed, r"  fmep  +[\d.]+ kPa  oil SAE .* rpm +[\d.]+ kPa  oil SAE .* rpm\n")
        self.assertRegex(printed, r'fmep against "SAE 5W-30".*\n  SAE 0W-20 .* % in the mean .* lower in \d of 4\n')
        self.run_well("new", "life", "life.toml", "--case", "ring.toml")
        self.assertEqual(len(json.loads(self.run_well("life", "life.toml", "--json"))["states"]), 4)

    def test_what_is_refused(self):
        self.run_well("new", "ring.toml")
        refuse = self.refused
        self.assertIn("--case my.toml", refuse("new", "study", "map", "map.toml"))
        self.assertIn("did you mean map?", refuse("new", "study", "mop", "map.toml", "--case", "ring.toml"))
        self.assertIn("a kind and a file", refuse("new", "study", "map.toml", "--case", "ring.toml"))
        self.assertIn("those of an engine", refuse("new", "study", "operating-points", "m.toml", "--case", "ring.toml"))
        self.assertIn("remove it", refuse("new", "study", "map", "m.toml", "--case", "ring.toml", "--load", "part"))
        self.assertIn("no such file", refuse("new", "life", "life.toml", "--case", "none.toml"))
        self.assertIn("remove it", refuse("new", "mine.toml", "--case", "ring.toml"))
        self.assertIn("one file is written", refuse("new", "a.toml", "b.toml"))
        self.run_well("new", "pack.toml", "--pack", "passenger-car")
        self.assertIn("follows one ring", refuse("new", "life", "life.toml", "--case", "pack.toml"))
        self.assertEqual(sorted(path.name for path in self.folder.glob("m*.toml")), [])

    def refused(self, *words):
        done = self.run_program(*words)
        self.assert_refused(done)
        return done.stderr


class OwnEngineTest(program.ProgramTest):
    def test_an_engine_of_the_users_own(self):
        text = (SHIPPED / "data/engines/passenger-car.toml").read_text()
        (self.folder / "mine.toml").write_text(text.replace('bore = "89 mm"', 'bore = "80 mm"'))
        self.run_well("new", "own.toml", "--engine", "mine.toml")
        self.assertIn('bore = "80 mm"', (self.folder / "own.toml").read_text())

    def test_what_is_wrong_with_it_is_reported_together(self):
        text = (SHIPPED / "data/engines/passenger-car.toml").read_text()
        (self.folder / "mine.toml").write_text(
            text.replace("stroke =", "strok =").replace("weight = 0.7", "weight = -1").replace("face_width", "width")
        )
        done = self.run_program("new", "own.toml", "--engine", "mine.toml")
        self.assert_refused(done, "a case has no key engine.strok", "states no engine.stroke", "weight")
        self.assertFalse((self.folder / "own.toml").exists())


class CiteTest(program.ProgramTest):
    def test_the_table_names_keys_choices_and_sources_that_exist(self):
        keys = self.run_well("fields")
        sources = set(re.findall(r"^@\w+\{([\w-]+),", (SHIPPED / "docs/references.bib").read_text(), re.MULTILINE))
        with open(SHIPPED / "data/citations.csv", encoding="utf-8") as rows:
            for row in csv.DictReader(rows):
                section, name = row["key"].rsplit(".", 1)
                part = keys.split(f"[{section}]\n", 1)[1].split("\n\n", 1)[0]
                self.assertRegex(
                    part, rf"(?m)^  {name} .*{'' if row['value'] == '*' else re.escape(row['value'])}", row
                )
                self.assertLessEqual(set(row["sources"].split()), sources, row)

    def test_a_case_and_its_result_have_the_same_laws(self):
        self.run_well("new", "mine.toml")
        self.run_well("run", "mine.toml", "-o", "mine.nc")
        cited = [
            set(re.findall(r"^@\w+\{([\w-]+),", self.run_well("cite", name), re.M)) for name in ("mine.toml", "mine.nc")
        ]
        self.assertLessEqual(
            {"ringfilm", "styles2014", "greenwood1966", "zhao2000", "roelands1966", "elrod1981"}, cited[1]
        )
        self.assertNotIn("greenwood1971", cited[1])
        self.assertLessEqual(cited[1], cited[0])
        self.assertIn("fauconnier2020", cited[0])  # named by a comment of the case

    def test_what_is_no_case(self):
        (self.folder / "notes.nc").write_text("x")
        self.assert_refused(self.run_program("cite", "notes.nc"))
        self.assert_refused(self.run_program("cite", "none.toml"), "no such file")


if __name__ == "__main__":
    unittest.main()
