"""Whatever is wrong with the input: exit code 2, stated where and what, and nothing written."""

import os
import resource
import unittest

import program


def replaced(old, new):
    assert program.CASE.count(old) == 1, old
    return program.CASE.replace(old, new)


class BadCase(program.ProgramTest):
    def refuse(self, *fragments, words=(), case="case.toml"):
        before = self.names()
        done = self.run_program("run", case, "--output", "out.nc", "--csv", "out.csv", *words)
        self.assert_refused(done, *fragments)
        self.assertEqual(self.names(), before, "something was written")

    def refuse_case(self, text, *fragments):
        (self.folder / "case.toml").write_text(text)
        self.refuse("case.toml", *fragments)

    def refuse_trace(self, text, *fragments):
        (self.folder / "trace.csv").write_text(text)
        self.refuse("trace.csv", *fragments)

    def test_unknown_key_is_named_with_the_nearest(self):
        self.refuse_case(replaced("face_width", "face_widht"), "case.toml:15:1", "ring.face_widht", "ring.face_width")

    def test_keys_of_earlier_versions_are_named_with_their_present_names(self):
        self.refuse(
            "unknown key contact.film_parameter; did you mean contact.lambda_ratio?",
            words=("--set", "contact.film_parameter=minimum"),
        )
        self.refuse_case(
            replaced("[contact]", '[contact]\nfilm_parameter = "minimum"'),
            "unknown key contact.film_parameter; did you mean contact.lambda_ratio?",
        )

    def test_a_choice_of_earlier_versions_is_refused_with_the_present_one(self):
        self.refuse('is not known; did you mean "coupled-newton"?', words=("--set", "solver.method=nested-secant"))

    def test_missing_key(self):
        self.refuse_case(replaced('bore = "89 mm"\n', ""), "engine.bore")

    def test_wrong_unit(self):
        self.refuse_case(replaced('"89 mm"', '"89 kg"'), "engine.bore", "case.toml:3:", "a length")

    def test_number_without_unit(self):
        self.refuse_case(replaced('"89 mm"', "0.089"), "engine.bore", "no unit", "^")

    def test_nan_and_infinity(self):
        for bad in ("nan", "inf", '"nan mm"', '"inf mm"'):
            with self.subTest(bad):
                self.refuse_case(replaced('"89 mm"', bad), "engine.bore")

    def test_negative_length(self):
        self.refuse_case(replaced('"89 mm"', '"-89 mm"'), "engine.bore", "-89 mm")

    def test_key_given_twice(self):
        self.refuse_case(replaced('bore = "89 mm"\n', 'bore = "89 mm"\nbore = "90 mm"\n'), "bore")

    def test_two_tensions(self):
        self.refuse_case(
            replaced('elastic_pressure = "0.2 MPa"', 'elastic_pressure = "0.2 MPa"\ntangential_force = "10 N"'),
            "ring.elastic_pressure",
            "ring.tangential_force",
        )

    def test_gauge_or_absolute_not_stated(self):
        self.refuse_case(replaced('pressure_reference = "absolute"\n', ""), "gas.pressure_reference")

    def test_angle_zero_not_stated(self):
        self.refuse_case(replaced('angle_zero = "firing-tdc"\n', ""), "gas.angle_zero")

    def test_all_faults_at_once(self):
        text = (
            replaced('"89 mm"', '"89 kg"').replace("face_width", "face_widht").replace('model = "trace"', 'model = "x"')
        )
        self.refuse_case(text, "engine.bore", "ring.face_widht", "gas.model")

    def test_empty_and_one_line_trace(self):
        self.refuse_trace("")
        self.refuse_trace("crank_angle [degree],cylinder_pressure [Pa]\n")
        self.refuse_trace("crank_angle [degree],cylinder_pressure [Pa]\n0,1e5\n")

    def test_angles_out_of_order_or_twice(self):
        lines = program.TRACE.splitlines()
        self.refuse_trace("\n".join(lines[:5] + [lines[7], lines[6]] + lines[8:]) + "\n")
        self.refuse_trace("\n".join(lines[:5] + [lines[5], lines[5]] + lines[6:]) + "\n")

    def test_trace_without_units(self):
        self.refuse_trace(program.TRACE.replace(" [bar]", ""), "unit")

    def test_decimal_comma_and_byte_order_mark_are_read_or_reported(self):
        traces = {"comma": program.TRACE.replace(",", ";").replace(".", ","), "mark": "\ufeff" + program.TRACE}
        for name, text in traces.items():
            with self.subTest(name):
                (self.folder / "trace.csv").write_text(text, encoding="utf-8")
                done = self.run_program("run", "case.toml")
                if done.returncode != 0:
                    self.assert_refused(done, "trace.csv")
                else:
                    self.assertIn("peak gas pressure 41.16 bar", done.stdout)
                    self.assertIn("note:", done.stdout)

    def test_face_points_that_do_not_cover_the_width(self):
        (self.folder / "face.csv").write_text("x [mm],height [um]\n0,5\n0.5,0\n1.0,5\n")
        self.refuse_case(
            replaced('form = "parabola"\ncrown_height = "15 um"', 'form = "points"\nfile = "face.csv"'),
            "face.csv",
            "mm",
        )

    def test_missing_files(self):
        self.refuse("nowhere.toml", case="nowhere.toml")
        (self.folder / "trace.csv").unlink()
        self.refuse("trace.csv")

    def test_folder_given_as_file(self):
        (self.folder / "folder.toml").mkdir()
        self.refuse("folder.toml", case="folder.toml")

    def test_binary_and_huge_case_files(self):
        (self.folder / "binary.toml").write_bytes(bytes(range(256)) * 50)
        self.refuse("binary.toml", case="binary.toml")
        with open(self.folder / "huge.toml", "wb") as file:
            file.truncate(100 << 20)
        self.refuse("huge.toml", case="huge.toml")

    def test_pipe_given_as_case_is_refused_at_once(self):
        os.mkfifo(self.folder / "pipe.toml")
        self.refuse("pipe.toml", "a device or a pipe", case="pipe.toml")

    def test_every_refusal_reports_what_to_do(self):
        (self.folder / "case.toml").write_text(program.CASE + "bore == 3\n")
        self.refuse("a line is key = value")
        (self.folder / "case.toml").write_text("")
        self.refuse("is it the right file?")
        (self.folder / "case.toml").write_text(program.CASE)
        self.refuse("include cannot be set", "into the case file", words=("--set", "include=x.toml"))
        self.refuse("--set gas.intake_pressure= on the command line", words=("--set", "gas.intake_pressure=1 bar"))
        self.refuse_trace("crank_angle [degree],p [bar]\n0,1\n1\n", "a value for each column")

    def test_thousands_of_unknown_sections_take_a_second(self):
        (self.folder / "case.toml").write_text("".join(f"[s{i}]\nx = 1\n" for i in range(20000)))

        def ten_seconds():  # of the processor; quadratic in the sections it took 18
            resource.setrlimit(resource.RLIMIT_CPU, (10, 10))

        done = self.run_program("check", "case.toml", preexec_fn=ten_seconds)
        self.assert_refused(
            done, "unknown section [s0]", "unknown section [s99]", " more\n200", " errors; nothing was run"
        )
        self.assertNotIn("[s100]", done.stderr)

    def test_a_long_list_in_one_line_does_not_fill_the_memory(self):
        if program.IS_SANITIZED:
            program.skip_loudly(self, "AddressSanitizer does not start under a limit of memory")
        (self.folder / "case.toml").write_text("include = [" + ",".join(["1"] * 20000) + "]\n")

        def one_gigabyte():
            resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))

        done = self.run_program("check", "case.toml", preexec_fn=one_gigabyte)
        self.assert_refused(done, "case.toml:1:12: include = 1 is not a file name", "20000 errors")

    def test_a_setting_is_given_once(self):
        self.refuse(
            "--set solver.cells is given more than once",
            "keep one of them",
            words=("--set", "solver.cells=60", "--set", "solver.cells=80"),
        )
        self.refuse("--set solver.cells is given more than once", words=("--set", "solver.cells=60", "solver.cells=60"))

    def test_settings_on_the_command_line(self):
        self.refuse("--set", "solver.cels", "solver.cells", words=("--set", "solver.cels=100"))
        self.refuse("operating.speed", words=("--set", "operating.speed=1500"))
        self.refuse("key=value", words=("--set", "operating.speed"))


class BadOutput(program.ProgramTest):
    def refuse(self, *words):
        before = self.names()
        done = self.run_program("run", "case.toml", *words)
        self.assert_refused(done)
        self.assertEqual(self.names(), before, "something was written")
        return done.stderr

    def test_folder_that_does_not_exist(self):
        self.assertIn("nowhere does not exist", self.refuse("--output", "nowhere/out.nc"))
        self.assertIn("nowhere does not exist", self.refuse("--csv", "nowhere/out.csv"))

    def test_folder_given_as_output(self):
        self.assertIn("folder", self.refuse("--output", "."))

    def test_a_name_that_is_too_long_is_refused_before_anything_is_computed(self):
        for name in ("x" * 250 + ".nc", "x" * 300, "d/" * 2100 + "x.nc"):
            with self.subTest(len(name)):
                self.assertIn("the name of the file is too long", self.refuse("--output", name))
        self.run_well("run", "case.toml", "--output", "x" * 230 + ".nc")

    def test_a_device_that_takes_nothing_is_refused_before_anything_is_computed(self):
        if not os.path.exists("/dev/full"):
            program.skip_loudly(self, "there is no /dev/full")
        self.assertIn("/dev/full: nothing can be written to this device", self.refuse("--csv", "/dev/full"))

    def test_output_that_would_replace_its_own_input(self):
        self.assertIn("trace.csv", self.refuse("--csv", "trace.csv"))
        self.assertIn("case.toml", self.refuse("--output", "./case.toml"))
        self.assertEqual((self.folder / "trace.csv").read_text(), program.TRACE)

    def test_two_outputs_of_one_name(self):
        self.refuse("--output", "out", "--csv", "./out")

    def test_device_for_netcdf(self):
        self.assertIn("/dev/null", self.refuse("--output", "/dev/null"))

    def test_folder_that_is_not_writable(self):
        how = {}
        if os.geteuid() == 0:
            how = {"user": 65534, "group": 65534, "extra_groups": []}
            self.folder.chmod(0o755)
            if not self.can_start(**how):
                program.skip_loudly(self, "another user than root cannot start the program where it lies")
        else:
            self.folder.chmod(0o555)
            self.addCleanup(self.folder.chmod, 0o755)
        done = self.run_program("run", "case.toml", "--output", "out.nc", **how)
        self.assert_refused(done, "not writable")
        self.assertNotIn("out.nc", self.names())

    def can_start(self, **how):
        try:
            return self.run_program("--version", **how).returncode == 0
        except PermissionError:
            return False


class BadCommandLine(program.ProgramTest):
    def test_usage_errors_are_exit_code_2(self):
        for words in (
            (),
            ("run",),
            ("fly",),
            ("run", "case.toml", "--nonsense"),
            ("report", "a.nc"),
            ("report", "--output", "x.html"),
            ("run", "case.toml", "case.toml"),
        ):
            with self.subTest(words):
                done = self.run_program(*words)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertNotEqual(done.stderr, "")

    def test_an_option_that_is_given_twice_or_without_its_value_is_reported_in_plain_words(self):
        for words, printed in (
            (("run", "case.toml", "--output", "a.nc", "--output=b.nc"), "--output is given twice"),
            (("run", "case.toml", "-o", "a.nc", "-o", "b.nc", "--output", "c.nc"), "--output is given 3 times"),
            (("run", "case.toml", "-oa.nc", "-ob.nc"), "--output is given twice"),
            (("study", "study.toml", "--threads", "2", "--threads", "3"), "--threads is given twice"),
            (("run", "case.toml", "--output"), "--output has no value"),
        ):
            with self.subTest(words):
                done = self.run_program(*words)
                self.assert_refused(done, printed)
                self.assertNotIn("required", done.stderr)

    def test_a_misspelt_command_or_option_is_named_with_the_nearest(self):
        for words, fragments in (
            (("runn", "case.toml"), ("ringfilm runn: this is not a command; did you mean run?", "lateral-force")),
            (("fly",), ("ringfilm fly: this is not a command",)),
            (("run", "case.toml", "--jsn"), ("--jsn: ringfilm run has no such option; did you mean --json?",)),
            (("run", "--outptu=x.nc"), ("--outptu: ringfilm run has no such option; did you mean --output?",)),
            (("study", "submit", "study.toml", "--resme", "--", "--partiton=long"), ("did you mean --resume?",)),
        ):
            with self.subTest(words):
                self.assert_refused(self.run_program(*words), *fragments)

    def test_text_of_arguments_and_files_cannot_command_the_terminal(self):
        done = self.run_program("run", "\x1b[31mx\u009b2J.toml")
        self.assert_refused(done, "\\x1B[31mx\\x9B2J.toml: there is no such file")
        self.assertNotIn("\x1b", done.stderr)
        name = "\x1b]0;title\x07.csv"
        done = self.run_program("run", "case.toml", "--csv", name)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("wrote \\x1B]0;title\\x07.csv", done.stdout)
        self.assertNotIn("\x1b", done.stdout)
        self.assertIn(name, self.names())

    def test_a_number_in_quotes_is_called_so(self):
        (self.folder / "study.toml").write_text(
            '[[base]]\ncase = "case.toml"\n[[factor]]\nkey = "contact.boundary_shear_strength_coefficient"\n'
            'values = ["1"]\n[plan]\nmethod = "grid"\n'
        )
        done = self.run_program("study", "study.toml", "-o", "out")
        self.assert_refused(
            done, 'values = "1" is a number in quotes', "a number without unit is required here, for example 1\n"
        )

    def test_unknown_publication(self):
        self.assert_refused(self.run_program("reproduce", "smith2020"), "smith2020", "styles2014")

    def test_invalid_number_of_threads(self):
        for number in ("0", "1025", "-3", "two", "2.5"):
            for option, *command in (
                ("--jobs", "run", "case.toml"),
                ("--jobs", "reproduce", "styles2014"),
                ("--threads", "study", "study.toml"),
                ("--threads", "life", "life.toml"),
            ):
                with self.subTest(command=command, number=number):
                    done = self.run_program(*command, f"{option}={number}")
                    self.assert_refused(done, f"{option} {number}", "from 1 to 1024")


if __name__ == "__main__":
    unittest.main(verbosity=2)
