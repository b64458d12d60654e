"""Studies that are killed at random moments, meet a full disk or another process: what --resume makes of them is what
one undisturbed run gives, to the last byte. RINGFILM_KILLS changes how many kills, RINGFILM_SEED their moments."""

import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from program import PROGRAM, skip_loudly  # noqa: E402
from study import StudyFolder  # noqa: E402

KILLS = int(os.environ.get("RINGFILM_KILLS", "50"))
SEED = int(os.environ.get("RINGFILM_SEED", "1"))


class KilledStudy(StudyFolder):
    def start(self, output):
        return subprocess.Popen(
            [PROGRAM, "study", "study.toml", "-o", output, "--resume"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )

    def killed(self, output, seconds):
        """@returns whether the process was still there"""
        run = self.start(output)
        try:
            run.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            pass
        run.kill()
        _, printed = run.communicate(timeout=100)
        self.assertIn(run.returncode, (0, -signal.SIGKILL), printed)
        return run.returncode == -signal.SIGKILL

    def whole(self):
        begun = time.monotonic()
        self.run_well("study", "study.toml", "-o", "whole")
        return time.monotonic() - begun

    def test_kills_at_random_moments_change_no_byte(self):
        self.write_scenarios(1024)
        whole = self.whole()
        moments = random.Random(SEED)
        n_killed = n_rounds = 0
        while n_killed < KILLS:
            # A round ends when the study does: it then begins anew, so that kills fall on every part of it.
            n_rounds += 1
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            while n_killed < KILLS and self.killed("out", moments.uniform(0.02, 0.6) * whole):
                n_killed += 1
                self.assert_no_half_result()
            self.run_well("study", "study.toml", "-o", "out", "--resume")
            self.assertEqual(self.contents("whole"), self.contents("out"))
        print(
            f"\n{n_killed} kills in {n_rounds} studies of {whole:.1f} s, seed {SEED}: every byte as undisturbed",
            flush=True,
        )

    def assert_no_half_result(self):
        for name in ("study.nc", "study.csv", "study.html"):
            path = self.folder / "out" / name
            if path.exists():
                self.assertEqual(path.read_bytes(), (self.folder / "whole" / name).read_bytes(), name)

    def test_kills_while_results_are_written_leave_whole_files_or_none(self):
        self.write_scenarios(1024)
        self.whole()
        rows = "study.part-1-of-1.rows"

        # Only the last row is missing, so that most of the time goes into reading, renaming and writing.
        def begin():
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            (self.folder / "out").mkdir()
            kept = (self.folder / "whole" / rows).read_bytes()[:-1]
            (self.folder / "out" / rows.replace(".rows", ".growing")).write_bytes(kept)

        begin()
        begun = time.monotonic()
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        last = time.monotonic() - begun
        moments = random.Random(SEED)
        seen = {}
        n_killed = 0
        for _ in range(2 * KILLS):
            begin()
            n_killed += self.killed("out", moments.uniform(0, 1.1) * last)
            names = {path.name.split(".partial-")[0] for path in (self.folder / "out").iterdir()}
            seen[frozenset(names)] = seen.get(frozenset(names), 0) + 1
            self.assert_no_half_result()
            self.run_well("study", "study.toml", "-o", "out", "--resume")
            self.assertEqual(self.contents("whole"), self.contents("out"))
            self.assertEqual(
                sorted(path.name for path in (self.folder / "out").iterdir()),
                ["study.csv", "study.html", "study.nc", rows],
            )
        print(
            f"\n{n_killed} kills in the last {last:.2f} s, seed {SEED}: {len(seen)} different states were left",
            flush=True,
        )
        self.assertGreater(n_killed, KILLS // 2)
        self.assertGreater(len(seen), 1, "every kill came before anything was written")

    def test_two_at_once_do_not_mix(self):
        self.write_scenarios(1024)
        self.whole()
        first = self.start("out")
        while not (self.folder / "out").exists() or "out/study.part-1-of-1.growing" not in self.names():
            time.sleep(0.01)
        second = self.run_program("study", "study.toml", "-o", "out", "--resume")
        _, printed = first.communicate(timeout=100)
        self.assertEqual(first.returncode, 0, printed)
        self.assertEqual(second.returncode, 2, second.stderr)
        self.assertIn("another process computes this part", second.stderr)
        self.assertEqual(self.contents("whole"), self.contents("out"))
        # Many at once, some of which find the part just finished: none fails in another way, none corrupts it.
        for _ in range(5):
            shutil.rmtree(self.folder / "out")
            runs = []
            for _ in range(4):
                runs.append(self.start("out"))
                time.sleep(0.02)
            for run in runs:
                _, printed = run.communicate(timeout=100)
                self.assertIn(run.returncode, (0, 2), printed)
            self.run_well("study", "study.toml", "-o", "out", "--resume")
            self.assertEqual(self.contents("whole"), self.contents("out"))

    def test_a_disk_that_fills_up_stops_it_and_it_continues(self):
        self.write_scenarios(2000)
        self.whole()
        size = (self.folder / "whole" / "study.part-1-of-1.rows").stat().st_size
        disk = self.folder / "out"
        disk.mkdir()
        mounted = (
            os.geteuid() == 0
            and subprocess.run(
                ["mount", "-t", "tmpfs", "-o", f"size={size // 2}", "none", str(disk)], capture_output=True
            ).returncode
            == 0
        )
        if not mounted:
            skip_loudly(self, "a small disk can only be mounted by root")
        self.addCleanup(subprocess.run, ["umount", "--lazy", str(disk)], check=True)
        done = self.run_program("study", "study.toml", "-o", "out")
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("No space left on device", done.stderr)
        self.assertIn("free disk space, then: ringfilm study study.toml -o out --resume", done.stderr)
        kept = (disk / "study.part-1-of-1.growing").stat().st_size
        self.assertGreater(kept, 0)
        # Room for the rows, not for the results.
        subprocess.run(["mount", "-o", f"remount,size={size + 65536}", str(disk)], check=True)
        done = self.run_program("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(done.returncode, 5, done.stdout + done.stderr)
        self.assertEqual(sorted(path.name for path in disk.iterdir()), ["study.part-1-of-1.rows"])
        subprocess.run(["mount", "-o", f"remount,size={8 * size + (1 << 20)}", str(disk)], check=True)
        self.run_well("study", "study.toml", "-o", "out", "--resume")
        self.assertEqual(self.contents("whole"), self.contents("out"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
