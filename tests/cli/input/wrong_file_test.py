"""What a first day brings: files of another kind, data that are not found, examples of README.md."""

import os
import re
import shlex
import shutil
import unittest

import program

STUDY = '[[base]]\ncase = "case.toml"\n[plan]\nmethod = "grid"\n'
LIFE = 'case = "case.toml"\nhours = ["0 h"]\n'
OIL = 'name = "an oil"\nkinematic_viscosity = [{ temperature = "40 degC", value = "60 mm2/s" }]\n'
# A pack whose rings describe the gas between them, with the conditions of an engine.
PACK = (
    'conditions = "engine"\n'
    + program.CASE.split("[ring]\n")[0].replace('oil_temperature = "120 degC"\n', "")
    + "EXTRA[contact]"
    + program.CASE.split("[contact]")[1]
    + '[supply]\nfilm = "5 um"\nreach = "20 mm"\n'
)


class WrongKindTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "study.toml").write_text(STUDY)
        (self.folder / "life.toml").write_text(LIFE)
        (self.folder / "oil.toml").write_text(OIL)

    def refused_once(self, *words):
        done = self.run_program(*words)
        self.assert_refused(done)
        self.assertIn("\n1 error; nothing", done.stderr)
        return done.stderr

    def test_a_result_in_place_of_a_text_is_named_as_one(self):
        self.run_well("run", "case.toml", "--output", "x.nc")
        (self.folder / "names.toml").write_text(program.CASE.replace("trace.csv", "x.nc"))
        for command in ("run", "check", "gas", "life", "study", "conform"):
            with self.subTest(command):
                words = ("-o", "out") if command == "study" else ()
                refused = self.refused_once(command, "x.nc", *words)
                self.assertIn("x.nc: this is a NetCDF file that ringfilm wrote, not text", refused)
                self.assertIn("ringfilm report x.nc --output X.html", refused)
                self.assertNotIn("UTF-8", refused)
        self.assertIn("a NetCDF file that ringfilm wrote", self.refused_once("run", "names.toml"))
        self.run_well("report", "x.nc", "--output", "x.html")  # the remedy works

    def test_a_result_in_place_of_a_surface_is_named_as_one(self):
        self.run_well("run", "case.toml", "--output", "x.nc")
        for words in (("surface", "x.nc"), ("pair", "--ring", "x.nc", "--liner", "x.nc")):
            refused = self.refused_once(*words)
            self.assertIn("x.nc: this is a result that ringfilm wrote, not a measured surface", refused)
            self.assertNotIn("gwyddion", refused)

    def test_a_part_of_a_case_is_named_as_one(self):
        (self.folder / "part.toml").write_text('[contact]\nroughness = "0.5 um"\nasperity_density = "0.1 um-2"\n')
        refused = self.refused_once("run", "part.toml")
        self.assertIn("part.toml: this is a part of a case: it states no engine and no ring", refused)
        self.assertIn('include = ["part.toml"]', refused)

    def test_a_netcdf_file_of_another_program_is_named_as_one(self):
        for begin in (b"\x89HDF\r\n\x1a\n", b"CDF\x01", b"CDF\x02"):
            (self.folder / "map.nc").write_bytes(begin + bytes(100))
            self.assertIn("map.nc: this is a NetCDF file, not text", self.refused_once("run", "map.nc"))

    def test_a_file_of_another_kind_is_refused_with_its_command(self):
        cases = (
            (("life", "case.toml"), "is a case, not a life", "ringfilm run case.toml"),
            (("study", "case.toml", "-o", "out"), "is a case, not a study", "ringfilm run case.toml"),
            (("study", "life.toml", "-o", "out"), "is a life, not a study", "ringfilm life life.toml"),
            (("life", "study.toml"), "is a study, not a life", "ringfilm study study.toml --output FOLDER"),
            (("run", "study.toml"), "is a study, not a case", "ringfilm study study.toml --output FOLDER"),
            (("check", "life.toml"), "is a life, not a case", "ringfilm life life.toml"),
            (("gas", "life.toml"), "is a life, not a case", "ringfilm life life.toml"),
            (("conform", "study.toml"), "is a study, not a case", "ringfilm study study.toml"),
            (("run", "oil.toml"), "is an oil, not a case", 'lubricant.file = "oil.toml"'),
        )
        for words, message, remedy in cases:
            with self.subTest(words):
                refused = self.refused_once(*words)
                self.assertIn(f"{words[1]}: this file {message}", refused)
                self.assertIn(remedy, refused)

    def test_a_base_of_a_study_that_is_a_study_is_refused_where_it_is_named(self):
        (self.folder / "outer.toml").write_text(STUDY.replace("case.toml", "study.toml"))
        self.assertIn(
            "outer.toml:2:8: this file is a study, not a case", self.refused_once("study", "outer.toml", "-o", "out")
        )

    def test_a_slip_in_a_file_of_the_right_kind_is_reported_as_before(self):
        (self.folder / "study.toml").write_text(STUDY + "[rnig]\nx = 1\n")
        self.assertIn("unknown key rnig in a study", self.refused_once("study", "study.toml", "-o", "out"))


class GasOfPackTest(program.ProgramTest):
    def pack(self, extra=""):
        shipped = program.SOURCES / "data" / "packs" / "passenger-car.toml"
        (self.folder / "pack.toml").write_text(f'include = ["{shipped}"]\n' + PACK.replace("EXTRA", extra))

    def test_keys_of_the_gas_without_its_model_are_one_fault(self):
        self.pack()
        done = self.run_program("check", "pack.toml")
        self.assert_refused(done, "passenger-car.toml:8:1: ring.1.end_gap and 20 more keys", "in [gas_path]")
        self.assertIn("\n1 error; nothing", done.stderr)

    def test_gas_alone_names_the_model_and_not_what_it_computes(self):
        self.pack()
        done = self.run_program("gas", "pack.toml")
        self.assert_refused(done, "gas_path.model is not stated: there is no gas to compute", "orifice-volume")
        self.assertNotIn("pressure_below", done.stderr)
        self.assertIn("\n1 error; nothing", done.stderr)

    def test_other_faults_beside_it_are_reported(self):
        self.pack("[operating_x]\n")
        done = self.run_program("check", "pack.toml")
        self.assert_refused(done, "unknown section [operating_x]", "and 20 more keys")

    def test_the_remedy_works(self):
        self.pack('[gas_path]\nmodel = "orifice-volume"\n')
        self.run_well("check", "pack.toml")


class FieldsTest(program.ProgramTest):
    def test_of_a_section_or_a_word(self):
        ring = self.run_well("fields", "ring")
        self.assertIn("face_width", ring)
        self.assertNotIn("  bore  ", ring)
        self.assertIn("[ring.face]", self.run_well("fields", "ring.face"))
        self.assert_refused(self.run_program("fields", "rnig"), "fields rnig: there is no such section or key")


class ReadmeTest(program.ProgramTest):
    def test_the_example_of_face_measures_the_shipped_trace(self):
        text = (program.SOURCES / "README.md").read_text()
        examples = re.findall(r"`build/ringfilm (face [^`]*)`", text)
        self.assertTrue(examples)
        for example in examples:
            words = [word.replace("cases/", f"{program.SOURCES}/cases/") for word in shlex.split(example)]
            self.assertIn("Ring face", self.run_well(*words))

    def test_a_face_that_cannot_be_made_level_is_refused_with_options_that_work(self):
        words = ("face", f"{program.SOURCES}/cases/measured/face_new.csv", "--heights", "material", "--width", "1.2 mm")
        done = self.run_program(*words)
        self.assert_refused(done, "cannot be made level")
        options = re.findall(r"\((--[^)]*)\)", done.stderr)
        self.assertEqual(len(options), 3)
        for option in options:
            self.run_well(*words, *shlex.split(option))


class ShippedDataTest(program.ProgramTest):
    def with_data(self, value, *words):
        environment = {name: text for name, text in os.environ.items() if name != "RINGFILM_DATA"}
        return self.run_program(*words, env={**environment, **({} if value is None else {"RINGFILM_DATA": value})})

    def test_the_data_folder_itself_is_refused_with_the_folder_to_state(self):
        self.run_well("new", "mine.toml")
        for inside in ("data", "cases"):
            done = self.with_data(f"{program.SOURCES}/{inside}/", "run", "mine.toml")
            self.assert_refused(done, f"RINGFILM_DATA is {program.SOURCES}/{inside}/, which holds no cases/ and data/")
            self.assertIn(f"set RINGFILM_DATA to {program.SOURCES}, ", done.stderr)
        (self.folder / "named.toml").write_text(
            program.CASE.split("kinematic_viscosity")[0] + 'file = "data/lubricants/sae-5w-30.toml"\n'
        )
        self.assert_refused(self.with_data(f"{program.SOURCES}/data", "run", "named.toml"), "set RINGFILM_DATA to")

    def test_a_copied_program_states_that_its_data_are_missing(self):
        (self.folder / "bin").mkdir()
        copy = shutil.copy(program.PROGRAM, self.folder / "bin" / "ringfilm")
        environment = {name: text for name, text in os.environ.items() if name != "RINGFILM_DATA"}
        environment["XDG_DATA_DIRS"] = str(self.folder)
        written = program.subprocess.run(
            [copy, "new", "mine.toml"], cwd=self.folder, capture_output=True, text=True, env=environment
        )
        self.assertEqual(written.returncode, 2, written.stdout)
        self.assertIn("the shipped cases and data are not found\n    set the environment variable", written.stderr)
        self.assertFalse((self.folder / "mine.toml").exists())
        self.assertTrue(self.run_well("new", "other.toml").endswith("next: ringfilm run other.toml\n"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
