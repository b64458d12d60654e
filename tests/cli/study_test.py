"""Studies: results that do not depend on threads, kills and sharding, refusals, what is left after a full disk."""

import csv
import json
import math
import os
import random
import resource
import signal
import subprocess
import time
import unittest

import program
from program import PROGRAM, SOURCES, ProgramTest
from study import STUDY


class StudyTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write_study(STUDY.replace("SCENARIOS", "16"))

    def write_study(self, text, name="study.toml"):
        (self.folder / name).write_text(text)

    def table(self, output="out"):
        with open(self.folder / output / "study.csv", newline="") as file:
            return list(csv.DictReader(file))

    def contents(self, output):
        return [(self.folder / output / name).read_bytes() for name in ("study.nc", "study.csv", "study.html")]

    def test_runs_to_the_end_with_results_and_quantiles(self):
        printed = self.run_well("study", "study.toml", "-o", "out")
        self.assertIn("95 %", printed)
        self.assertIn("wrote out/study.nc", printed)
        rows = self.table()
        self.assertEqual([row["scenario"] for row in rows], [str(i) for i in range(16)])
        for row in rows:
            self.assertEqual(row["reason"], "")
            self.assertGreater(float(row["fmep [Pa]"]), 0)
        speeds = [float(row["factor_speed [rad/s]"]) for row in rows]
        rpm = math.pi / 30
        self.assertEqual(len(set(speeds)), 16)
        self.assertTrue(all(1000 * rpm <= speed <= 3000 * rpm for speed in speeds))

    def test_writes_a_page_that_needs_nothing_else(self):
        self.write_study(STUDY.replace("SCENARIOS", "16").replace("a small study", "</script><b>small"))
        self.assertIn("wrote out/study.html", self.run_well("study", "study.toml", "-o", "out"))
        page = (self.folder / "out" / "study.html").read_text()
        for outside in ('src="http', "src='http", 'href="http', "@import", "url(http"):
            self.assertNotIn(outside, page)
        self.assertIn("default-src 'none'", page)
        data = page[page.index('id="result-data">') + len('id="result-data">') :]
        data = json.loads(data[: data.index("</script>")])
        self.assertEqual(data["title"], "</script><b>small")
        self.assertEqual(data["statistics"]["fmep"][0]["n"], 16)
        mean = sum(float(row["fmep [Pa]"]) for row in self.table()) / 16
        self.assertAlmostEqual(data["statistics"]["fmep"][0]["mean"][0] / mean, 1, delta=1e-5)  # six digits

    def test_screening_ranks_its_factors(self):
        self.write_study(
            STUDY.replace('method = "sobol"', 'method = "morris"')
            .replace("scenarios = SCENARIOS", "trajectories = 4")
            .replace('kind = "uncertainty"', 'kind = "screening"')
        )
        printed = self.run_well("study", "study.toml", "-o", "out")
        self.assertIn("elementary effects on fmep", printed)
        ranked = [line.split()[0] for line in printed.splitlines() if "mu*" in line]
        self.assertEqual(sorted(ranked), ["roughness", "speed"])
        self.assertEqual(len(self.table()), 4 * 3)

    def test_one_scenario_is_the_case_itself(self):
        self.write_study(
            STUDY[: STUDY.index("[[factor]]")] + '[[factor]]\nkey = "operating.speed"\n'
            'values = ["1500 rpm", "2000 rpm"]\n[plan]\nmethod = "grid"\n'
        )
        self.run_well("study", "study.toml", "-o", "out")
        alone = json.loads(self.run_well("run", "case.toml", "--json"))
        # Lanes of a vector add in another order than a case that is integrated alone.
        fmep = alone["fmep"]
        self.assertAlmostEqual(float(self.table()[0]["fmep [Pa]"]) / fmep, 1, delta=1e-6)

    def test_threads_change_no_byte(self):
        self.run_well("study", "study.toml", "-o", "one", "--threads", "1")
        self.run_well("study", "study.toml", "-o", "two", "--threads", "2")
        self.assertEqual(self.contents("one"), self.contents("two"))

    def test_shards_joined_are_the_whole(self):
        self.run_well("study", "study.toml", "-o", "whole")
        for part in ("3/3", "1/3"):
            self.run_well("study", "study.toml", "-o", "out", "--shard", part)
        self.assert_refused(
            self.run_program("study", "merge", "study.toml", "-o", "out"), "part 2 of 3 is missing", "--shard 2/3"
        )
        self.assertIn("part 2 of 3: not begun", self.run_well("study", "status", "study.toml", "-o", "out"))
        self.assertNotIn("out/study.nc", self.names())
        self.run_well("study", "study.toml", "-o", "out", "--shard", "2/3")
        self.run_well("study", "merge", "study.toml", "-o", "out")
        self.assertEqual(self.contents("whole"), self.contents("out"))

    def test_a_finished_part_is_not_computed_again(self):
        self.run_well("study", "study.toml", "-o", "out", "--shard", "1/2")
        self.assertIn("there already", self.run_well("study", "study.toml", "-o", "out", "--shard", "1/2", "--resume"))

    def test_a_finished_study_is_replaced_with_overwrite_only(self):
        self.run_well("study", "study.toml", "-o", "out")
        before = self.contents("out")
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "out"),
            "a finished study of this plan",
            "--overwrite",
            "--resume",
            "another output",
        )
        self.write_study(STUDY.replace("SCENARIOS", "16").replace("seed = 5", "seed = 6"))
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "out"), "a finished study of another plan", "--overwrite"
        )
        (self.folder / "out" / "study.part-1-of-1.rows").unlink()
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "out"), "out/study.nc: there are results", "--overwrite"
        )
        self.assertEqual(self.contents("out"), before)
        nc = self.folder / "out" / "study.nc"
        nc.rename(self.folder / "kept.nc")
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "out"),
            "out/study.csv: there are results",
            "out/study.html: there are results",
            "--overwrite",
        )
        (self.folder / "kept.nc").rename(nc)
        self.run_well("study", "study.toml", "-o", "out", "--overwrite")
        self.assertNotEqual(self.contents("out"), before)
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "out", "--overwrite", "--resume"), "keep one of the two"
        )
        self.run_well("study", "study.toml", "-o", "parts", "--shard", "1/2")
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "parts", "--shard", "1/2"),
            "a finished part of this plan",
            "--overwrite",
        )

    def test_processes_that_replace_one_study_leave_a_whole_one(self):
        self.write_study(STUDY.replace("SCENARIOS", "64"))
        self.run_well("study", "study.toml", "-o", "out")
        before = self.contents("out")
        for _ in range(4):
            runs = [
                subprocess.Popen(
                    [PROGRAM, "study", "study.toml", "-o", "out", "--overwrite"],
                    cwd=self.folder,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE,
                    text=True,
                )
                for _ in range(3)
            ]
            printed = [run.communicate(timeout=100)[1] for run in runs]
            self.assertIn(0, [run.returncode for run in runs], printed)
            for run, words in zip(runs, printed):
                self.assertIn(run.returncode, (0, 2), words)
                if run.returncode == 2:
                    self.assertRegex(words, "another process (computes|has just finished) this part")
            self.assertEqual(self.contents("out"), before)

    def test_a_study_that_runs_is_not_advised_to_be_deleted(self):
        self.write_study(STUDY.replace("SCENARIOS", "100000"))
        run = subprocess.Popen(
            [PROGRAM, "study", "study.toml", "-o", "out"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            while not (self.folder / "out" / "study.part-1-of-1.growing").exists():
                self.assertIsNone(run.poll(), "it ended before it was disturbed")
                time.sleep(0.01)
            for words in ([], ["--resume"], ["--overwrite"]):
                done = self.run_program("study", "study.toml", "-o", "out", *words)
                self.assert_refused(done, "another process computes this part", "name another output")
                self.assertNotIn("delete", done.stderr)
        finally:
            run.terminate()
            run.wait(timeout=100)
        done = self.run_program("study", "study.toml", "-o", "out")
        self.assert_refused(done, "was not finished", "--resume", "--overwrite")
        self.write_study(STUDY.replace("SCENARIOS", "16"))
        self.run_well("study", "study.toml", "-o", "out", "--overwrite")

    def test_parts_of_another_plan_program_or_input_are_refused(self):
        self.run_well("study", "study.toml", "-o", "out", "--shard", "1/2")
        self.write_study(STUDY.replace("SCENARIOS", "16").replace("seed = 5", "seed = 6"))
        self.run_well("study", "study.toml", "-o", "out", "--shard", "2/2")
        self.assert_refused(
            self.run_program("study", "merge", "study.toml", "-o", "out"), "part-1-of-2", "another plan"
        )
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "out", "--shard", "1/2"),
            "a finished part of another plan",
            "--overwrite",
        )
        trace = self.folder / "trace.csv"
        trace.write_text("# another day\n" + trace.read_text())
        self.assert_refused(
            self.run_program("study", "study.toml", "-o", "out", "--shard", "2/2", "--resume"),
            "have changed since",
            "must not be mixed",
        )

    def test_another_number_of_parts_is_refused(self):
        self.run_well("study", "study.toml", "-o", "out", "--shard", "1/2")
        self.run_well("study", "study.toml", "-o", "out", "--shard", "1/3")
        self.assert_refused(self.run_program("study", "merge", "study.toml", "-o", "out"), "parts of 2 and parts of 3")

    def killed(self, output, seconds, number):
        run = subprocess.Popen(
            [PROGRAM, "study", "study.toml", "-o", output, "--resume"],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        time.sleep(seconds)
        run.send_signal(number)
        _, printed = run.communicate(timeout=100)
        return run.returncode, printed

    def test_kills_at_any_moment_leave_the_result_as_it_is(self):
        self.write_study(STUDY.replace("SCENARIOS", "1024"))
        begun = time.monotonic()
        self.run_well("study", "study.toml", "-o", "whole")
        whole = time.monotonic() - begun
        moments = random.Random(1)
        n_killed = 0
        for _ in range(5):
            code, _ = self.killed("out", moments.uniform(0.05, 0.5) * whole, signal.SIGKILL)
            n_killed += code == -signal.SIGKILL
        self.assertGreater(n_killed, 0)
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(self.contents("whole"), self.contents("out"))

    def test_rows_that_were_cut_off_or_corrupted_are_computed_again(self):
        self.run_well("study", "study.toml", "-o", "whole")
        rows = self.folder / "whole" / "study.part-1-of-1.rows"
        bytes_ = rows.read_bytes()
        (self.folder / "out").mkdir()
        growing = self.folder / "out" / "study.part-1-of-1.growing"
        for n in (0, 3, 80, 200, len(bytes_) // 2, len(bytes_) - 1):
            growing.write_bytes(bytes_[:n])
            self.run_well("study", "study.toml", "-o", "out", "--resume")
            self.assertEqual(self.contents("whole"), self.contents("out"))
            os.remove(self.folder / "out" / "study.part-1-of-1.rows")
        corrupted = bytearray(bytes_)
        corrupted[-100] ^= 1
        growing.write_bytes(corrupted)
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(self.contents("whole"), self.contents("out"))

    def curves_of(self, kind, extra="", output="out"):
        """Runs the small study with curves and opens its result."""
        try:
            import netCDF4  # noqa: F401
            import xarray
        except ImportError:
            program.skip_loudly(self, "python3-xarray and python3-netcdf4 are not installed")
        study = STUDY.replace("SCENARIOS", "16").replace("deviation = 0.1\ntruncate = [0.5, 1.5]", "deviation = 0.5")
        self.write_study(study + f'[keep]\ncurves = "{kind}"\n{extra}')
        self.run_well("study", "study.toml", "-o", output)
        with xarray.open_dataset(self.folder / output / "study.nc") as data:
            return data.load()

    def test_curves_in_full_are_over_scenario_crank_angle_and_ring(self):
        data = self.curves_of("all")
        self.assertEqual(data.curve_total_friction.dims, ("scenario", "crank_angle", "ring"))
        self.assertEqual(data.curve_total_friction.attrs["units"], "N")
        self.assertEqual(data.crank_angle.values.tolist(), [float(x) for x in range(-360, 360, 2)])
        self.assertEqual(data.ring.size, 1)
        self.assertIn("factor_speed", data.curve_total_friction.coords)
        self.assertIn("base", data.fmep.coords)
        self.assertEqual(data.fmep.dims, ("scenario",))
        solved = data.solved.values == 1
        self.assertTrue(0 < solved.sum() < 16)  # a deviation of half the roughness takes some below 0
        curves = data.curve_min_film_thickness.values[:, :, 0]
        for i in range(16):
            self.assertEqual(bool(solved[i]), not any(map(math.isnan, curves[i])))
        # The curve passes every second step of the integration, of which the value of the cycle is the smallest of all.
        smallest = curves[solved].min(axis=1) / data.min_film_thickness.values[solved]
        self.assertTrue(((smallest >= 1 - 1e-6) & (smallest < 1.05)).all(), smallest)

    def test_rows_of_a_sample_are_marked(self):
        try:
            import netCDF4
        except ImportError:
            program.skip_loudly(self, "python3-netcdf4 is not installed")
        self.write_study(STUDY.replace("SCENARIOS", '4\nindices = "first-and-total"'))
        printed = self.run_well("study", "study.toml", "-o", "out")
        self.assertIn("indices from 4 rows, fewer than 64", printed)
        with netCDF4.Dataset(self.folder / "out" / "study.nc") as file:
            self.assertEqual(file["sample"][:].tolist(), [1, 1, 0, 0] * 4)
            speeds = file["factor_speed"][:].tolist()
        # Where a scenario does not belong to the sample, it has its speed from another one.
        self.assertEqual(len(set(speeds)), 8)

    def test_curve_of_a_scenario_is_that_of_its_case(self):
        self.write_study(
            STUDY[: STUDY.index("[[factor]]")] + '[[factor]]\nkey = "operating.speed"\n'
            'values = ["2000 rpm"]\n[plan]\nmethod = "grid"\n[keep]\ncurves = "all"\n'
            'quantities = ["friction_on_liner"]\ncrank_step = "10 degree"\n'
        )
        self.run_well("study", "study.toml", "-o", "out")
        self.run_well("run", "case.toml", "--set", 'operating.speed="2000 rpm"', "--csv", "case.csv")
        with open(self.folder / "case.csv", newline="") as stream:
            case = {
                float(row["crank_angle [degree]"]): float(row["friction_on_liner [N]"])
                for row in csv.DictReader(stream)
            }
        try:
            import netCDF4
        except ImportError:
            program.skip_loudly(self, "python3-netcdf4 is not installed")
        with netCDF4.Dataset(self.folder / "out" / "study.nc") as file:
            angles, curve = file["crank_angle"][:], file["curve_friction_on_liner"][0, :, 0]
        self.assertEqual(len(angles), 72)
        for angle, value in zip(angles, curve):
            # Single precision.
            self.assertAlmostEqual(value, case[angle % 720], delta=1e-6 * abs(case[angle % 720]))

    def test_quantiles_of_curves_are_those_of_the_curves_in_full(self):
        full = self.curves_of("all", output="full")
        data = self.curves_of("quantiles")
        import numpy

        band = data.curve_power_loss_quantile
        self.assertEqual(band.dims, ("base_case", "quantile", "crank_angle", "ring"))
        self.assertEqual(data["quantile"].values.tolist(), [0.05, 0.25, 0.5, 0.75, 0.95])
        self.assertNotIn("curve_power_loss", data)
        curves = full.curve_power_loss.values[full.solved.values == 1, :, 0]
        expected = numpy.quantile(curves.astype(float), data["quantile"].values, axis=0, method="median_unbiased")
        # What is kept is in single precision, and so is the quantile.
        numpy.testing.assert_allclose(band.values[0, :, :, 0], expected, rtol=3e-7)
        self.assertEqual(full.fmep.values.tobytes(), data.fmep.values.tobytes())

    def test_values_of_the_cycle_are_the_same_whatever_curves_are_kept(self):
        def values():
            return (self.folder / "out" / "study.csv").read_bytes()

        tables = []
        for keep in ("", '[keep]\ncurves = "all"\n', '[keep]\ncurves = "quantiles"\ncrank_step = "8 degree"\n'):
            self.write_study(STUDY.replace("SCENARIOS", "16") + keep)
            self.run_well("study", "study.toml", "-o", "out", "--overwrite")
            tables.append(values())
        self.assertEqual(len(set(tables)), 1)

    def test_kills_leave_curves_as_they_are_and_other_curves_are_not_mixed_in(self):
        keep = '[keep]\ncurves = "all"\ncrank_step = "4 degree"\n'
        self.write_study(STUDY.replace("SCENARIOS", "512") + keep)
        begun = time.monotonic()
        self.run_well("study", "study.toml", "-o", "whole")
        whole = time.monotonic() - begun
        moments = random.Random(2)
        n_killed = sum(
            self.killed("out", moments.uniform(0.1, 0.5) * whole, signal.SIGKILL)[0] == -signal.SIGKILL
            for _ in range(3)
        )
        self.assertGreater(n_killed, 0)
        if (self.folder / "out" / "study.part-1-of-1.growing").exists():
            self.write_study(STUDY.replace("SCENARIOS", "512") + keep.replace("4 degree", "8 degree"))
            self.assert_refused(self.run_program("study", "study.toml", "-o", "out", "--resume"), "other curves")
            self.write_study(STUDY.replace("SCENARIOS", "512") + keep)
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(self.contents("whole"), self.contents("out"))
        for part in (1, 2, 3):
            self.run_well("study", "study.toml", "-o", "parts", "--shard", f"{part}/3")
        self.run_well("study", "merge", "study.toml", "-o", "parts")
        self.assertEqual(self.contents("whole"), self.contents("parts"))

    def test_a_case_that_asks_for_fields_gives_curves_alone(self):
        case = self.folder / "case.toml"
        case.write_text(case.read_text() + '[output]\nfields = "all"\ncrank_angles = "0.5 degree"\n')
        data = self.curves_of("all", 'quantities = ["min_film_thickness"]\n')
        self.assertEqual(data.curve_min_film_thickness.shape, (16, 360, 1))
        self.assertNotIn("film_pressure", data)

    def test_curves_that_would_fill_a_disk_require_confirmation(self):
        # 400 000 x 4 curves x 360 angles x 4 bytes
        self.write_study(STUDY.replace("SCENARIOS", "400000") + '[keep]\ncurves = "quantiles"\n')
        self.assert_refused(self.run_program("study", "study.toml", "-o", "out"), "2.3 GB", "--yes")
        self.assertNotIn("out", self.names())

    def test_faults_of_what_is_kept_have_their_place(self):
        good = STUDY.replace("SCENARIOS", "16") + (
            '[keep]\ncurves = "all"\nquantities = ["power_loss"]\n' 'crank_step = "2 degree"\n'
        )
        line = good.splitlines().index("[keep]") + 1
        for old, new, *reported in (
            ('curves = "all"', 'curves = "al"', f"study.toml:{line + 1}:10:", "did you mean all?"),
            ('"power_loss"', '"power_los"', f"study.toml:{line + 2}:14:", "did you mean power_loss?"),
            ('"power_loss"', '"film_parameter"', f"study.toml:{line + 2}:14:", "did you mean lambda_ratio?"),
            ('"power_loss"', '"crank_angle"', f"study.toml:{line + 2}:14:", "is not known"),
            ('["power_loss"]', "[]", f"study.toml:{line + 2}:14:", "names no curve"),
            ('"power_loss"', '"power_loss", "power_loss"', f"study.toml:{line + 2}:14:", "twice"),
            ('"2 degree"', '"7 degree"', f"study.toml:{line + 3}:14:", "does not divide"),
            ('"2 degree"', '"1.5 degree"', f"study.toml:{line + 3}:14:", "not a multiple of solver.crank_step"),
            ('"2 degree"', '"2"', f"study.toml:{line + 3}:14:", "has no unit"),
            ('"2 degree"', "2", f"study.toml:{line + 3}:14:", "has no unit"),
            ("crank_step", "crank_steps", f"study.toml:{line + 3}:1:", "did you mean crank_step?"),
        ):
            with self.subTest(new):
                self.assertIn(old, good)
                self.write_study(good.replace(old, new))
                self.assert_refused(self.run_program("study", "study.toml", "-o", "out"), *reported)
        self.assertNotIn("out", self.names())

    def test_ctrl_c_stops_and_reports_how_to_continue(self):
        self.write_study(STUDY.replace("SCENARIOS", "4096"))
        code, printed = self.killed("out", 3, signal.SIGINT)
        self.assertEqual(code, 128 + signal.SIGINT, printed)
        self.assertIn("(exit code 130)", printed)
        self.assertIn("to continue: ringfilm study study.toml -o out --resume", printed)
        self.assertNotIn("out/study.nc", self.names())
        self.assert_refused(self.run_program("study", "study.toml", "-o", "out"), "was not finished", "--resume")
        self.assertIn("not finished", self.run_well("study", "status", "study.toml", "-o", "out"))

    def test_a_full_disk_stops_cleanly_and_can_be_resumed(self):
        self.write_study(STUDY.replace("SCENARIOS", "600"))
        self.run_well("study", "study.toml", "-o", "whole")
        most = (self.folder / "whole" / "study.part-1-of-1.rows").stat().st_size // 2

        def small_disk():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

        done = self.run_program("study", "study.toml", "-o", "out", preexec_fn=small_disk)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("File too large (the rows written before are kept)\n", done.stderr)
        self.assertIn("free disk space, then: ringfilm study study.toml -o out --resume", done.stderr)
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(self.contents("whole"), self.contents("out"))

    def test_a_disk_too_small_for_the_result_stops_before_it_is_begun(self):
        self.run_well("study", "study.toml", "-o", "whole")
        most = (self.folder / "whole" / "study.part-1-of-1.rows").stat().st_size + 4096

        def small_disk():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

        done = self.run_program("study", "study.toml", "-o", "out", preexec_fn=small_disk)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("MB are required", done.stderr)
        self.assertIn("free disk space, then: ringfilm study study.toml -o out --resume", done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder / "out")), ["study.part-1-of-1.rows"])
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(self.contents("whole"), self.contents("out"))

    def test_a_scenario_that_cannot_be_made_is_a_row_with_its_reason(self):
        self.write_study(
            STUDY.replace("SCENARIOS", "16").replace("deviation = 0.1\ntruncate = [0.5, 1.5]", "deviation = 1.0")
        )
        self.assertIn("were not solved", self.run_well("study", "study.toml", "-o", "out"))
        rows = self.table()
        reasons = [row["reason"] for row in rows if row["reason"]]
        self.assertTrue(0 < len(reasons) < 16)
        for row in rows:
            self.assertEqual(row["fmep [Pa]"] == "nan", row["reason"] != "")
        self.assertIn("contact.roughness", reasons[0])

    def test_levels_choices_and_lists(self):
        self.write_study(
            STUDY[: STUDY.index("[[factor]]")] + '[[factor]]\nname = "law"\nkey = "lubricant.viscosity_pressure"\n'
            'values = ["roelands", "barus"]\n[[factor]]\nkey = "operating.oil_temperature"\nhow = "add"\n'
            'name = "warmer"\nvalues = ["-5 degC", "5 K"]\n[plan]\nmethod = "one-at-a-time"\n'
        )
        self.run_well("study", "study.toml", "-o", "out")
        self.assertEqual([row["factor_law"] for row in self.table()], ["nan", "roelands", "barus", "nan", "nan"])
        self.assertEqual([row["factor_warmer [K]"] for row in self.table()], ["nan", "nan", "nan", "-5", "5"])
        self.write_study(
            STUDY[: STUDY.index("[[factor]]")] + '[[factor]]\nname = "speed"\nkey = "operating.speed"\n'
            '[plan]\nmethod = "list"\nlist = "plan.csv"\n'
        )
        (self.folder / "plan.csv").write_text("speed [rpm]\n1200\n1800\n2400\n")
        self.run_well("study", "study.toml", "-o", "listed")
        self.assertEqual(len(self.table("listed")), 3)

    def test_shipped_studies_can_be_run(self):
        studies = sorted((SOURCES / "cases" / "studies").glob("*.toml"))
        self.assertGreater(len(studies), 0)
        for study in studies:
            printed = self.run_well("study", str(study), "-o", study.stem, "--shard", "1/100")
            self.assertIn("part 1 of 100 is done", printed)
            self.assertIn(", 0 not solved, finished", self.run_well("study", "status", str(study), "-o", study.stem))

    def test_it_continues_until_the_interval_is_narrow(self):
        def until(width, most=64):
            return STUDY.replace("SCENARIOS", "8").replace(
                "[plan]\n", '[plan]\nuntil = { value = "fmep", ' f'width = "{width}", most = {most} }}\n'
            )

        def mean_width(rows):
            # Student's t of 0.975 with 7, 15, 31 and 63 degrees of freedom, from a table.
            t = {8: 2.3646, 16: 2.1314, 32: 2.0395, 64: 1.9983}[len(rows)]
            values = [float(row["fmep [Pa]"]) for row in rows]
            mean = sum(values) / len(values)
            return 2 * t * math.sqrt(sum((x - mean) ** 2 for x in values) / (len(values) - 1) / len(values))

        self.write_study(until("1e-9 Pa"))
        printed = self.run_well("study", "study.toml", "-o", "all")
        self.assertIn("gave up after 64 points: the 95 % interval of the mean of fmep is", printed)
        rows = self.table("all")
        self.assertEqual(len(rows), 64)
        widths = [mean_width(rows[:n]) for n in (8, 16, 32)]
        self.assertGreater(widths[0], 1.2 * widths[2])
        # Between the widths at 16 and 32 points it stops at 32 and has the very same rows.
        self.write_study(until(f"{1.01 * widths[2]} Pa"))
        printed = self.run_well("study", "study.toml", "-o", "out")
        self.assertIn("stopped after 32 points", printed)
        self.assertEqual(self.table(), rows[:32])
        whole = self.contents("out")
        # It neither starts again nor continues where it is done.
        self.assertEqual(self.run_well("study", "study.toml", "-o", "out", "--resume"), printed)
        self.assertEqual(self.run_well("study", "merge", "study.toml", "-o", "out"), printed)
        self.assertEqual(self.contents("out"), whole)
        # Cut off within the second look.
        rows_file = self.folder / "out" / "study.part-1-of-1.rows"
        rows_file.rename(rows_file.with_suffix(".growing"))
        with open(rows_file.with_suffix(".growing"), "r+b") as file:
            file.truncate(rows_file.with_suffix(".growing").stat().st_size - 1)
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(self.contents("out"), whole)
        self.assert_refused(self.run_program("study", "study.toml", "-o", "out", "--shard", "1/2"), "in parts")
        for wrong, *reported in (
            (until("1e-9 Pa", 4), "most = 4 is below"),
            (until("1 N"), "a pressure"),
            (until("1 Pa").replace('"fmep"', '"fmepp"'), "did you mean fmep?"),
            (until("1 Pa").replace(", most = 64", ""), "plan.until has no most"),
            (until("1 Pa").replace('"sobol"', '"latin-hypercube"'), "only Sobol points"),
        ):
            with self.subTest(reported):
                self.write_study(wrong)
                self.assert_refused(self.run_program("study", "study.toml", "-o", "none"), *reported)
        self.assertNotIn("none", self.names())

    def test_rows_of_fewer_scenarios_are_refused(self):
        self.run_well("study", "study.toml", "-o", "out")
        self.write_study(STUDY.replace("SCENARIOS", "8"))
        for words in (["study", "study.toml", "-o", "out", "--resume"], ["study", "merge", "study.toml", "-o", "out"]):
            self.assert_refused(self.run_program(*words), "another number of scenarios")

    def test_a_large_grid_requires_confirmation(self):
        self.write_study(
            STUDY[: STUDY.index("[[factor]]")] + '[[factor]]\nkey = "operating.speed"\n'
            'range = ["1000 rpm", "3000 rpm"]\npoints = 10001\n[plan]\nmethod = "grid"\n'
        )
        self.assert_refused(self.run_program("study", "study.toml", "-o", "out"), "10001 points", "--yes")
        self.assertNotIn("out", self.names())

    def test_faults_have_their_place(self):
        good = STUDY.replace("SCENARIOS", "16")
        for old, new, *reported in (
            ('key = "operating.speed"', 'key = "operating.sped"', "study.toml:11:7:", "did you mean operating.speed?"),
            ('range = ["1000 rpm", "3000 rpm"]', 'range = ["1000 N", "3000 rpm"]', "study.toml:12:10:"),
            ('how = "scale"', 'how = "scal"', "study.toml:17:7:", "did you mean scale?"),
            ("deviation = 0.1", "deviation = -0.1", "study.toml:14:", "standard deviation"),
            ('case = "case.toml"', 'case = "none.toml"', "study.toml:7:", "none.toml"),
            ("scenarios = 16", "scenario = 16", "study.toml:", "did you mean scenarios?"),
            ('method = "sobol"', 'method = "sobols"', "did you mean sobol?"),
            ("truncate = [0.5, 1.5]", "truncate = [50, 51]", "study.toml:14:", "no support"),
            ('name = "new"', 'nam = "new"', "study.toml:6:", "did you mean name?"),
        ):
            with self.subTest(new):
                self.assertIn(old, good)
                self.write_study(good.replace(old, new))
                self.assert_refused(self.run_program("study", "study.toml", "-o", "out"), *reported)
        self.assertNotIn("out", self.names())


if __name__ == "__main__":
    unittest.main(verbosity=2)
