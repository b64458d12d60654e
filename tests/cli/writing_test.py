"""Outputs are whole or not there: kill, full disk, several writers."""

import fcntl
import os
import pathlib
import resource
import signal
import subprocess
import unittest

import program

# About 20 MB of fields, so that writing takes long enough to be hit.
LARGE = ("--set", 'output.fields="all"', "--set", "solver.cells=400")

PAD = """\
title = "a plane slider"
[pad]
length = "10 mm"
gap = "gap.csv"
speed = "5 m/s"
left_pressure = "0 bar"
right_pressure = "0 bar"
separation = "0 um"
[lubricant]
viscosity = "0.02 Pa s"
density = "850 kg/m3"
[solver]
cells = 1000
"""
GAP = "x [mm],h [um]\n0,20\n10,10\n"


class Writing(program.ProgramTest):
    def partials(self):
        return [name for name in self.names() if ".partial-" in name]

    def start(self, *words):
        return subprocess.Popen(
            [program.PROGRAM, *words], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
        )

    def killed_while_writing(self):
        """Runs until the partial file has some size, then kill -9; False if the writing was over before."""
        child = self.start("run", "case.toml", "--output", "out.nc", *LARGE)
        try:
            while child.poll() is None:
                if any((self.folder / name).stat().st_size > 0 for name in self.partials()):
                    child.send_signal(signal.SIGKILL)
                    break
        except FileNotFoundError:  # renamed between the two looks
            pass
        child.wait()
        child.stderr.close()
        return child.returncode == -signal.SIGKILL

    def test_kill_leaves_the_old_file_and_the_next_run_cleans_up(self):
        self.run_well("run", "case.toml", "--output", "out.nc")
        old = (self.folder / "out.nc").read_bytes()
        for _ in range(20):
            if self.killed_while_writing() and self.partials():
                break
            (self.folder / "out.nc").write_bytes(old)
        else:
            self.fail("the program could not be hit while it wrote")
        self.assertEqual((self.folder / "out.nc").read_bytes(), old)
        self.run_well("report", "out.nc", "--output", "page.html")
        self.run_well("run", "case.toml", "--output", "out.nc")
        self.assertEqual(self.partials(), [])
        self.assertEqual((self.folder / "out.nc").read_bytes(), old)

    def test_of_runs_at_once_to_one_name_all_but_one_are_refused(self):
        # A second that wins would silently lose what the first computed.
        long = ("--set", "solver.cells=3000", "--set", 'solver.crank_step="0.1 degree"')
        first = self.start("run", "case.toml", "--output", "out.nc", *long)
        while not self.partials():
            self.assertIsNone(first.poll(), "it ended before another began")
        for name in ("out.nc", "./out.nc", f"{self.folder}/out.nc"):
            done = self.run_program("run", "case.toml", "--output", name)
            self.assert_refused(done, f"{name}: another process computes this file now", "name another output")
        self.run_well("run", "case.toml", "--output", "other.nc")
        first.kill()
        first.communicate()
        self.run_well("run", "case.toml", "--output", "out.nc")
        self.assertEqual(self.partials(), [])
        self.assertEqual((self.folder / "out.nc").read_bytes(), (self.folder / "other.nc").read_bytes())

    def test_every_command_that_writes_refuses_an_output_that_another_computes(self):
        (self.folder / "pad.toml").write_text(PAD)
        (self.folder / "gap.csv").write_text(GAP)
        states = "".join(f'[[state]]\nhours = "{hours} h"\ncase = "case.toml"\n' for hours in (0, 2))
        (self.folder / "life.toml").write_text('case = "case.toml"\nhours = ["0 h", "2 h"]\n' + states)
        self.run_well("run", "case.toml", "--output", "short.nc")
        measured = str(program.SOURCES / "cases" / "measured") + "/"
        pack = str(program.SOURCES / "cases" / "ring-pack" / "three_rings.toml")
        for name, *words in (
            ("x.nc", "run", "case.toml", "--output"),
            ("x.csv", "run", "case.toml", "--csv"),
            ("x.nc", "run", "pad.toml", "--output"),
            ("x.nc", "life", "life.toml", "--output"),
            ("x.html", "life", "life.toml", "--html"),
            ("x.nc", "gas", pack, "--output"),
            ("x.csv", "gas", pack, "--csv"),
            ("x.csv", "gas", pack, "--vary", "operating.speed=1000 rpm,2000 rpm", "--csv"),
            ("x.toml", "pair", "--ring", measured + "ring_new.x3p", "--liner", measured + "liner.sur", "--fragment"),
            ("x.html", "report", "short.nc", "--output"),
            ("x.html", "verify", "--output"),
            ("x.toml", "new"),
        ):
            with self.subTest(words):
                # As such a process holds it.
                with open(self.folder / f"{name}.partial-{os.getpid()}", "w") as held:
                    fcntl.flock(held, fcntl.LOCK_EX)
                    self.assert_refused(self.run_program(*words, name), f"{name}: another process computes this file")
                    self.assertNotIn(name, self.names())

    def small_disk(self, size):
        """A folder with room for so many bytes."""
        if os.geteuid() != 0:
            program.skip_loudly(self, "only root can mount a small disk")
        small = self.folder / "small"
        small.mkdir(exist_ok=True)
        mounted = subprocess.run(
            ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(small)], capture_output=True
        )
        if mounted.returncode != 0:
            program.skip_loudly(self, "no small disk can be mounted here")
        return small

    def test_disk_that_is_full_anywhere_in_the_file_is_exit_code_5(self):
        self.run_well("run", "case.toml", "--output", "room.nc")
        size = (self.folder / "room.nc").stat().st_size
        sizes = [4096 * n for n in range(1, 70, 8) if 4096 * (n + 1) < size]
        self.assertGreater(len(sizes), 3, f"a result has only {size} bytes")
        for room in sizes:
            small = self.small_disk(room + 4096)
            try:
                (small / "out.nc").write_text("old")
                done = self.run_program("run", "case.toml", "--output", "small/out.nc")
                self.assertEqual(done.returncode, 5, (room, done.stderr))
                self.assertIn("small/out.nc: could not be written: No space left on device", done.stderr)
                self.assertEqual([path.name for path in small.iterdir()], ["out.nc"], room)
                self.assertEqual((small / "out.nc").read_text(), "old")
            finally:
                subprocess.run(["umount", str(small)], check=True)

    def test_an_output_that_fails_where_nothing_was_before_reports_it(self):
        self.assertEqual(self.names(), ["case.toml", "trace.csv"])

        def no_file_above_one_kilobyte():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024))

        done = self.run_program("run", "case.toml", "--csv", "out.csv", preexec_fn=no_file_above_one_kilobyte)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("out.csv: could not be written: File too large (there is no file of that name)\n", done.stderr)
        self.assertNotIn("unchanged", done.stderr)
        (self.folder / "out.csv").write_text("old")
        done = self.run_program("run", "case.toml", "--csv", "out.csv", preexec_fn=no_file_above_one_kilobyte)
        self.assertIn("(the file of that name keeps what it held before)\n", done.stderr)
        self.assertEqual((self.folder / "out.csv").read_text(), "old")

    def test_full_disk_is_exit_code_5_and_leaves_the_old_file(self):
        small = self.small_disk("600k")
        self.addCleanup(subprocess.run, ["umount", str(small)], check=True)
        self.run_well("run", "case.toml", "--output", "small/out.nc")
        old = (small / "out.nc").read_bytes()
        for words in (("--output", "small/out.nc", *LARGE), ("--csv", "small/out.csv")):
            with self.subTest(words):
                done = self.run_program("run", "case.toml", *words)
                self.assertEqual(done.returncode, 5, done.stderr)
                self.assertIn(words[1] + ": could not be written", done.stderr)
                self.assertIn("No space left on device", done.stderr)
                self.assertEqual((small / "out.nc").read_bytes(), old)
                self.assertEqual([path.name for path in small.iterdir()], ["out.nc"])

    def outputs(self, folder):
        """Every way to an output of some size: its name and the words that write it into `folder`."""
        return {
            "out.nc": ("run", "case.toml", "--output", f"{folder}/out.nc"),
            "out.csv": ("run", "case.toml", "--csv", f"{folder}/out.csv"),
            "pad.csv": ("run", "pad.toml", "--csv", f"{folder}/pad.csv"),
            "page.html": ("report", "result.nc", "--output", f"{folder}/page.html"),
            "verify.html": ("verify", "rayleigh1918_step", "--output", f"{folder}/verify.html"),
            "new.nc": ("reproduce", "styles2014", "--output", folder),
            "report.html": ("reproduce", "styles2014", "--output", folder),
        }

    def prepare_outputs(self):
        """What they need, and the folder whole/ with each of them."""
        (self.folder / "pad.toml").write_text(PAD)
        (self.folder / "gap.csv").write_text(GAP)
        self.run_well("run", "case.toml", "--output", "result.nc")
        (self.folder / "whole").mkdir()
        for name, words in self.outputs("whole").items():
            if name != "report.html":  # written along with new.nc
                self.run_well(*words)

    def test_death_in_the_middle_of_any_output_leaves_the_old_file(self):
        # SIGXFSZ kills like kill -9, and at a byte of our choice: where the file would pass the limit.
        def limited(size):
            return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

        self.prepare_outputs()
        for name, words in self.outputs("whole").items():
            path = self.folder / "whole" / name
            whole = path.stat().st_size
            path.write_text("old")
            # A reproduction takes seconds, and its page comes after its results, which are smaller.
            for share in (0.5,) if words[0] == "reproduce" else (0.1, 0.5, 0.99):
                with self.subTest(name, share=share):
                    done = self.run_program(*words, preexec_fn=limited(int(share * whole)))
                    self.assertEqual(done.returncode, -signal.SIGXFSZ, done.stderr)
                    self.assertEqual(path.read_text(), "old")
                    begun = [p for p in self.partials() if (self.folder / p).stat().st_size > 0]
                    self.assertEqual([p for p in begun if name not in p], [])  # what is claimed is empty
            self.run_well(*words)
            self.assertEqual(path.stat().st_size, whole, name)
            self.assertEqual(self.partials(), [], name)

    def test_disk_that_fills_up_under_any_output_is_exit_code_5_and_leaves_the_old_file(self):
        self.prepare_outputs()
        for name, words in self.outputs("small").items():
            small = self.small_disk((self.folder / "whole" / name).stat().st_size * 3 // 4)
            try:
                (small / name).write_text("old")
                done = self.run_program(*words)
                with self.subTest(name):
                    self.assertEqual(done.returncode, 5, done.stderr)
                    self.assertIn("could not be written: No space left on device", done.stderr)
                    self.assertEqual((small / name).read_text(), "old")
                    self.assertEqual([p.name for p in small.iterdir() if ".partial-" in p.name], [])
            finally:
                subprocess.run(["umount", str(small)], check=True)

    def test_full_standard_output_is_exit_code_5(self):
        if not pathlib.Path("/dev/full").exists():
            program.skip_loudly(self, "there is no /dev/full")
        with open("/dev/full", "w") as full:
            done = subprocess.run([program.PROGRAM, "fields"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("standard output: could not be written in full", done.stderr)
        self.assertNotIn("unchanged", done.stderr)

    def test_partial_files_of_killed_writers_go_with_the_next_run(self):
        ended = subprocess.Popen(["true"])
        ended.wait()
        for name in ("out.csv", "out.nc", "page.html"):
            (self.folder / f"{name}.partial-{ended.pid}").write_text("half")
        self.run_well("run", "case.toml", "--csv", "out.csv", "--output", "out.nc")
        self.run_well("report", "out.nc", "--output", "page.html")
        self.assertEqual(self.partials(), [])

    def test_replaced_file_keeps_who_may_read_it(self):
        modes = {"out.csv": 0o440, "out.nc": 0o640}
        for name, mode in modes.items():
            (self.folder / name).write_text("old")
            (self.folder / name).chmod(mode)
        self.run_well("run", "case.toml", "--csv", "out.csv", "--output", "out.nc")
        for name, mode in modes.items():
            self.assertEqual((self.folder / name).stat().st_mode & 0o777, mode, name)

    def test_csv_can_be_piped_on(self):
        done = self.run_program("run", "case.toml", "--json", "--csv", "/dev/stdout")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("crank_angle [degree],"))

    def test_partial_file_of_a_living_writer_stays(self):
        alive = self.folder / f"out.nc.partial-{os.getpid()}"
        alive.write_text("half")
        self.run_well("run", "case.toml", "--output", "out.nc")
        self.assertTrue(alive.exists())

    def test_odd_file_names(self):
        for name in ("with space.nc", "h#mode=zarr.nc", "h_\u00b5m.nc", "c:x.nc", "-x.nc"):
            with self.subTest(name):
                self.run_well("run", "case.toml", "--output=" + name)
                self.assertTrue((self.folder / name).exists())
                self.run_well("report", "./" + name, "--output", "page.html")


if __name__ == "__main__":
    unittest.main(verbosity=2)
