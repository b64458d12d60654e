"""Studies that continue: corrupted rows, more scenarios, a narrower interval, parts under other names."""

import csv
import signal
import subprocess
import time
import unittest

from program import PROGRAM
from study import STUDY, StudyFolder

ROWS = "study.part-1-of-1.rows"


class ResumedStudy(StudyFolder):
    def setUp(self):
        super().setUp()
        self.write_scenarios(16)

    def write_study(self, text):
        (self.folder / "study.toml").write_text(text)

    def write_until(self, width, most=64, scenarios=8):
        self.write_study(
            STUDY.replace("SCENARIOS", str(scenarios)).replace(
                "[plan]\n", f'[plan]\nuntil = {{ value = "fmep", width = "{width}", most = {most} }}\n'
            )
        )

    def write_morris(self, trajectories):
        self.write_study(
            STUDY.replace('method = "sobol"', 'method = "morris"').replace(
                "scenarios = SCENARIOS", f"trajectories = {trajectories}"
            )
        )

    def study(self, *words, output="out"):
        return ["study", *words, "study.toml", "-o", output]

    def resume(self, output="out"):
        return self.run_well(*self.study(output=output), "--resume")

    def n_rows(self, output="out"):
        with open(self.folder / output / "study.csv", newline="") as file:
            return len(list(csv.DictReader(file)))

    def corrupt(self, path, at):
        content = bytearray(path.read_bytes())
        content[at] ^= 1
        path.write_bytes(content)

    def test_corrupted_rows_of_a_study_with_until_are_computed_again(self):
        self.write_until("1e-9 Pa")
        self.assertIn("gave up after 64 points", self.run_well(*self.study()))
        whole = self.contents("out")
        rows = self.folder / "out" / ROWS
        for at in (-100, 1200):  # in the last block, in the first
            self.corrupt(rows, at)
            self.assert_refused(
                self.run_program(*self.study("merge")),
                "not complete, since a block of it is corrupted",
                "ringfilm study study.toml -o out --resume",
            )
            self.assertIn("gave up after 64 points", self.resume())
            self.assertEqual(self.contents("out"), whole)

    def test_intact_rows_of_a_corrupted_part_are_not_computed_again(self):
        self.write_scenarios(600)  # three blocks at least
        self.run_well(*self.study())
        whole = self.contents("out")
        rows = self.folder / "out" / ROWS
        before = rows.read_bytes()
        self.corrupt(rows, -100)
        # Its disk is too small for one more row: what was intact is kept.
        import resource

        def small_disk():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (len(before) // 4, len(before) // 4))

        self.assertEqual(self.run_program(*self.study(), "--resume", preexec_fn=small_disk).returncode, 5)
        growing = rows.with_suffix(".growing").read_bytes()
        self.assertGreater(len(growing), len(before) // 4)
        self.assertEqual(growing, before[: len(growing)])
        self.resume()
        self.assertEqual(self.contents("out"), whole)

    def test_an_overwrite_that_was_stopped_continues(self):
        self.run_well(*self.study())
        self.write_scenarios(20000)
        rows = self.folder / "out" / ROWS
        run = subprocess.Popen(
            [PROGRAM, *self.study(), "--overwrite"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        growing = rows.with_suffix(".growing")
        while not growing.exists() or growing.stat().st_size < 2000:
            self.assertIsNone(run.poll(), "it ended before it was disturbed")
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        _, printed = run.communicate(timeout=100)
        self.assertEqual(run.returncode, 130, printed)
        self.assertIn("to continue: ringfilm study study.toml -o out --resume", printed)
        self.assertFalse(rows.exists())
        kept = growing.stat().st_size
        run = subprocess.Popen(
            [PROGRAM, *self.study(), "--resume"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        while run.poll() is None and growing.stat().st_size <= kept:
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        _, printed = run.communicate(timeout=100)
        self.assertEqual(run.returncode, 130, printed)
        self.assertGreater(growing.stat().st_size, kept)

    def test_a_report_of_a_study_names_its_page(self):
        self.run_well(*self.study())
        self.assert_refused(
            self.run_program("report", "out/study.nc", "-o", "page.html"),
            "out/study.nc: the result of a study",
            "out/study.html",
        )

    def test_the_status_reports_corrupted_rows(self):
        self.run_well(*self.study())
        rows = self.folder / "out" / ROWS
        self.assertIn("part 1 of 1: 16 of 16 scenarios, 0 not solved, finished", self.run_well(*self.study("status")))
        self.corrupt(rows, -100)
        printed = self.run_well(*self.study("status"))
        self.assertRegex(printed, r"part 1 of 1: \d+ of 16 scenarios, 0 not solved, corrupted after these")
        self.assertNotIn("finished", printed)
        self.corrupt(rows, -100)
        for at in (3, 20, 80, 200):  # size, digest, first line and plan of the header
            self.corrupt(rows, at)
            self.assertIn("the header of this file of rows is corrupted", self.run_well(*self.study("status")))
            self.assert_refused(
                self.run_program(*self.study(), "--resume"), "the header of this file of rows is corrupted"
            )
            self.corrupt(rows, at)

    def test_a_gas_model_without_its_trace_has_the_reason_that_a_case_has(self):
        case = (self.folder / "case.toml").read_text()
        gas = case[case.index("[gas]") : case.index("[ring]")]
        wiebe = '[gas]\nmodel = "wiebe"\ncompression_ratio = 17\npeak_pressure = "100 bar"\npeak_angle = "12 degree"\n'
        (self.folder / "case.toml").write_text(case.replace(gas, wiebe))
        self.write_study(
            STUDY[: STUDY.index("[[factor]]")] + '[[factor]]\nkey = "gas.model"\n'
            'values = ["wiebe", "trace"]\n[plan]\nmethod = "grid"\n'
        )
        self.run_well(*self.study())
        printed = self.run_well(*self.study("status"))
        self.assertIn("scenario 1: the key gas.cylinder_pressure is missing", printed)

    def test_a_narrower_interval_or_more_points_continue(self):
        self.write_until("1e9 Pa")
        self.assertIn("stopped after 8 points", self.run_well(*self.study()))
        self.write_until("1e-9 Pa")
        self.assert_refused(self.run_program(*self.study("merge")), "not complete", "--resume")
        self.assertIn("gave up after 64 points", self.resume())
        self.write_until("1e-9 Pa", most=128)
        self.assertIn("gave up after 128 points", self.resume())
        self.run_well(*self.study(output="whole"))
        self.assertEqual(self.contents("out"), self.contents("whole"))
        self.write_until("1e9 Pa", most=512, scenarios=256)
        self.assertIn("stopped after 256 points", self.resume())
        # What is there is more than is required: it is kept, and nothing is computed.
        self.write_until("1e9 Pa", most=512)
        self.assertIn("stopped after 256 points", self.resume())

    def test_more_scenarios_continue_from_those_that_are_there(self):
        for write, few, many in ((self.write_scenarios, 16, 40), (self.write_morris, 3, 7)):
            with self.subTest(write.__name__):
                write(few)
                out, whole = f"out-{write.__name__}", f"whole-{write.__name__}"
                self.run_well(*self.study(output=out))
                first = (self.folder / out / ROWS).read_bytes()
                write(many)
                self.assert_refused(self.run_program(*self.study("merge", output=out)), "not complete", "--resume")
                self.resume(out)
                self.run_well(*self.study(output=whole))
                self.assertEqual(self.contents(out), self.contents(whole))
                # The blocks that were there are in the file of rows, byte for byte, behind its header.
                tail = first[1200:]
                self.assertIn(tail, (self.folder / out / ROWS).read_bytes())
                write(few)
                self.assert_refused(
                    self.run_program(*self.study(output=out), "--resume"), "another number of scenarios"
                )

    def test_one_that_was_stopped_may_become_longer(self):
        self.run_well(*self.study())
        rows = self.folder / "out" / ROWS
        rows.rename(rows.with_suffix(".growing"))
        self.write_scenarios(32)
        self.resume()
        self.run_well(*self.study(output="whole"))
        self.assertEqual(self.contents("out"), self.contents("whole"))

    def test_parts_and_hypercubes_do_not_become_longer(self):
        self.run_well(*self.study(), "--shard", "1/2")
        self.write_scenarios(32)
        self.assert_refused(
            self.run_program(*self.study(), "--shard", "1/2", "--resume"), "another number of scenarios"
        )
        hypercube = STUDY.replace('"sobol"', '"latin-hypercube"')
        self.write_study(hypercube.replace("SCENARIOS", "16"))
        self.run_well(*self.study(output="cube"))
        self.write_study(hypercube.replace("SCENARIOS", "32"))
        self.assert_refused(self.run_program(*self.study(output="cube"), "--resume"), "another plan")

    def test_parts_under_other_names_are_refused(self):
        for part in (1, 2):
            self.run_well(*self.study(), "--shard", f"{part}/4")
            out = self.folder / "out"
            (out / f"study.part-{part}-of-4.rows").rename(out / f"study.part-{part}-of-2.rows")
        for words in (
            self.study("merge"),
            self.study("submit") + ["--engine", "slurm", "--dry-run"],
            self.study() + ["--shard", "1/2", "--resume"],
        ):
            self.assert_refused(self.run_program(*words), "these rows are of part 1 of 4")

    def with_kernels(self, name):
        import os

        return {**os.environ, "RINGFILM_KERNELS": name}

    def test_rows_of_other_kernels_are_reported(self):
        done = self.run_program("study", "study.toml", "-o", "out", "--shard", "1/2", env=self.with_kernels("baseline"))
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.run_program("study", "study.toml", "-o", "out", "--shard", "2/2", env=self.with_kernels("avx2"))
        if "RINGFILM_KERNELS" in done.stderr:
            from program import skip_loudly

            skip_loudly(self, "this machine has no avx2")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = self.folder / "out" / "study.part-1-of-2.rows"
        rows.rename(rows.with_suffix(".growing"))
        words = ["study", "study.toml", "-o", "out", "--shard", "1/2", "--resume"]
        self.assert_refused(
            self.run_program(*words, env=self.with_kernels("avx2")),
            "with the kernels baseline",
            "RINGFILM_KERNELS=baseline",
        )
        self.assertEqual(self.run_program(*words, env=self.with_kernels("baseline")).returncode, 0)
        printed = self.run_well(*self.study("merge"))
        self.assertIn("different kernels (avx2, baseline)", printed)

    def test_a_signal_that_is_ignored_stays_so(self):
        self.write_scenarios(1024)
        run = subprocess.Popen(
            [PROGRAM, "study", "study.toml", "-o", "out"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN),
        )
        while not (self.folder / "out" / "study.part-1-of-1.growing").exists():
            self.assertIsNone(run.poll(), "it ended before it was disturbed")
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        _, printed = run.communicate(timeout=100)
        self.assertEqual(run.returncode, 0, printed)
        self.assertEqual(self.n_rows(), 1024)

    def test_how_to_continue_can_be_copied(self):
        (self.folder / "a b").mkdir()
        for name in ("case.toml", "trace.csv"):
            (self.folder / "a b" / name).write_text((self.folder / name).read_text())
        (self.folder / "a b" / "study.toml").write_text(STUDY.replace("SCENARIOS", "100000"))
        run = subprocess.Popen(
            [PROGRAM, "study", "a b/study.toml", "-o", "c d", "--threads", "2"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        growing = self.folder / "c d" / "study.part-1-of-1.growing"
        while not growing.exists() or growing.stat().st_size < 2000:
            self.assertIsNone(run.poll(), "it ended before it was disturbed")
            time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        _, printed = run.communicate(timeout=100)
        self.assertEqual(run.returncode, 130, printed)
        self.assertIn("to continue: ringfilm study 'a b/study.toml' -o 'c d' --threads 2 --resume", printed)

    def test_choices_and_factors_of_like_names_have_variables_of_their_own(self):
        self.write_study(
            STUDY[: STUDY.index("[[factor]]")] + '[[factor]]\nname = "law"\n'
            'key = "lubricant.viscosity_pressure"\nvalues = ["roelands", "barus"]\n'
            '[[factor]]\nname = "law choice"\nkey = "operating.speed"\n'
            'values = ["1500 rpm", "2000 rpm"]\n[plan]\nmethod = "grid"\n'
        )
        self.run_well(*self.study())
        with open(self.folder / "out" / "study.csv", newline="") as file:
            header = next(csv.reader(file))
        self.assertIn("factor_law", header)
        self.assertIn("factor_law_choice_2 [rad/s]", header)

    def test_keys_that_nobody_reads_are_refused(self):
        grid = STUDY[: STUDY.index("[[factor]]")] + (
            '[[factor]]\nname = "speed"\nkey = "operating.speed"\n'
            'values = ["1500 rpm", "2000 rpm"]\n[plan]\nmethod = "grid"\n'
        )
        for text, *reported in (
            (grid + "scenarios = 8\n", "study.toml:", 'plan.scenarios means nothing with method = "grid"'),
            (grid + "trajectories = 8\n", "plan.trajectories means nothing"),
            (grid + 'list = "plan.csv"\n', "plan.list means nothing"),
            (grid.replace('"grid"', '"morris"') + "scenarios = 8\n", "plan.scenarios means nothing"),
            (STUDY.replace("SCENARIOS", "8") + "levels = 4\n", "plan.levels means nothing"),
            (
                grid.replace('values = ["1500 rpm", "2000 rpm"]\n', "").replace('"grid"', '"list"\nlist = "plan.csv"'),
                "plan.csv:1:",
                "the column sped is of no factor",
            ),
        ):
            with self.subTest(reported):
                (self.folder / "plan.csv").write_text("speed [rpm],sped [rpm]\n1200,1\n1800,2\n")
                self.write_study(text)
                self.assert_refused(self.run_program(*self.study(output="none")), *reported)
        self.assertNotIn("none", self.names())

    def test_widths_are_reported_in_their_units(self):
        self.write_until("-2 kPa")
        self.assert_refused(self.run_program(*self.study(output="none")), "study.toml:", '"-2 kPa"')
        self.write_until("1e9 Pa", most="1e2")
        self.assertRegex(self.run_well(*self.study()), r"is [0-9.]{1,6} kPa wide; required: 1e\+06 kPa")


if __name__ == "__main__":
    unittest.main(verbosity=2)
