"""Studies as job arrays of a Slurm that is started for the test: joined results are those of one undisturbed run,
whatever is requeued, killed or taken down on the way."""

import os
import pathlib
import random
import re
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from program import skip_loudly  # noqa: E402
from slurm import CannotStart, Slurm  # noqa: E402
from study import StudyFolder  # noqa: E402

SLURM = None
WHY_NOT = ""
LONGEST = 600  # s, of one array on a machine that is busy


def setUpModule():
    global SLURM, WHY_NOT
    try:
        SLURM = Slurm()
    except CannotStart as reason:
        WHY_NOT = str(reason)


def tearDownModule():
    if SLURM:
        SLURM.stop()


class StudyOnSlurm(StudyFolder):
    def setUp(self):
        super().setUp()
        if not SLURM:
            skip_loudly(self, f"Slurm could not be started: {WHY_NOT}")
        self.write_scenarios(64)

    def run_program(self, *words, **how):
        return super().run_program(*words, env=SLURM.environment, **how)

    def submit(self, *words, output="out"):
        printed = self.run_well("study", "submit", "study.toml", "-o", output, "--engine", "slurm", *words)
        return re.findall(r"^job (\d+)", printed, re.MULTILINE)

    def status(self, output="out"):
        return self.run_well("study", "status", "study.toml", "-o", output)

    def logs(self):
        return "".join(
            f"{path.name}: {path.read_text(errors='replace')}" for path in sorted(self.folder.glob("out/*.log"))
        )

    def wait_for_result(self):
        SLURM.wait_until_empty(LONGEST)
        self.assertTrue((self.folder / "out" / "study.nc").exists(), self.logs())

    def test_an_array_and_its_merge_give_the_result_of_one_run(self):
        self.run_well("study", "study.toml", "-o", "whole")
        array, merge = self.submit("--parts", "5", "--", "--comment=two words")
        self.assertEqual(int(merge), int(array) + 1)
        self.assert_refused(
            self.run_program("study", "submit", "study.toml", "-o", "out", "--engine", "slurm"),
            f"in the queue already, as jobs {array} and {merge}",
            "scancel",
        )
        self.wait_for_result()
        self.assertEqual(self.contents("whole"), self.contents("out"))
        self.assertIn("part 5 of 5", self.status())
        printed = self.run_well("study", "submit", "study.toml", "-o", "out", "--engine", "slurm")
        self.assertIn("all 5 parts are there", printed)
        self.assertEqual(SLURM.in_queue(), [])

    def test_odd_names_reach_the_tasks_as_they_are(self):
        folder = self.folder / "it's a 50% $HOME;study `x`"
        folder.mkdir()
        for name in ("case.toml", "trace.csv", "study.toml"):
            (folder / name).write_text((self.folder / name).read_text())
        self.folder = folder
        self.run_well("study", "study.toml", "-o", "whole.nc")
        (self.folder / "b c").mkdir()
        self.submit("--parts", "2", output="b c/d 100% 'e'.nc")
        SLURM.wait_until_empty(LONGEST)
        self.assertIn("b c/d 100% 'e'.part-1-of-2.log", self.names())
        self.assertEqual((self.folder / "whole.nc").read_bytes(), (self.folder / "b c" / "d 100% 'e'.nc").read_bytes())

    def running(self, array):
        return [job for job, state, _ in SLURM.in_queue() if state == "RUNNING" and job.startswith(f"{array}_")]

    def test_requeues_and_a_node_that_goes_down_change_no_byte(self):
        self.write_scenarios(8000)
        self.run_well("study", "study.toml", "-o", "whole", "--threads", "1")
        seed = int(os.environ.get("RINGFILM_SEED", "7"))
        moments = random.Random(seed)
        to_come = ["requeue"] * 5 + ["down"] * 2
        moments.shuffle(to_come)
        array, _ = self.submit("--parts", "8")
        end = time.monotonic() + LONGEST
        while SLURM.in_queue() and time.monotonic() < end:
            # At first at short distances, so that all come to pass before the study ends.
            time.sleep(moments.uniform(0.1, 0.8))
            tasks = self.running(array)
            what = to_come.pop() if tasks and to_come else "nothing"
            if what == "requeue":
                SLURM.say("scontrol", "requeue", moments.choice(tasks))
            if what == "down":
                SLURM.order("scontrol", "update", f"nodename={SLURM.node}", "state=down", "reason=test")
                time.sleep(1)
                # Where the node has come back by itself this is refused.
                SLURM.say("scontrol", "update", f"nodename={SLURM.node}", "state=resume")
            self.begin_at_once(array)
        self.wait_for_result()
        n_cut_off = self.logs().count("CANCELLED AT")
        print(f"\n5 requeues and 2 times a node down, seed {seed}: {n_cut_off} tasks were cut off", flush=True)
        self.assertEqual(to_come, [], "the study is too short to be disturbed")
        self.assertGreaterEqual(n_cut_off, 5, self.logs())
        self.assertEqual(self.contents("whole"), self.contents("out"))

    @staticmethod
    def begin_at_once(array):
        """What looks after a cluster does: a task that was put back waits two minutes otherwise, and Slurm drains
        a node
        and holds a task that it tried to start there while the one before was still ending."""
        time.sleep(0.5)
        if SLURM.say("sinfo", "-h", "-o", "%T").startswith(("drain", "down")):
            SLURM.say("scontrol", "update", f"nodename={SLURM.node}", "state=resume")
        for job, state, reason in SLURM.in_queue():
            if state == "PENDING" and job.startswith(f"{array}_"):
                SLURM.say(
                    "scontrol", *(["release", job] if "held" in reason else ["update", f"jobid={job}", "StartTime=now"])
                )

    def test_where_a_part_fails_nothing_is_joined_and_status_reports_why(self):
        self.run_well("study", "study.toml", "-o", "whole")
        self.submit("--parts", "4", "--dry-run")
        # The second part finds a folder where its rows should go.
        blocked = self.folder / "out" / "study.part-2-of-4.growing"
        script = self.folder / "out" / "study.array.sh"
        self.assertIn("--array=1-4", script.read_text())
        self.submit("--parts", "4", "--", "--hold")
        blocked.mkdir()
        for job, _, reason in SLURM.in_queue():
            if "Dependency" not in reason:
                SLURM.say("scontrol", "release", job)
        SLURM.wait_until_empty(LONGEST)
        self.assertNotIn("out/study.nc", self.names())
        blocked.rmdir()
        reported = self.status()
        self.assertIn("part 2 of 4: not begun", reported)
        self.assertIn("not in the queue of Slurm", reported)
        self.assertRegex(reported, r"part-2-of-4.log ends with: .*(exit code|Is a directory|could not)")
        self.assertRegex(reported, r"the job that joins the parts, \d+: not in the queue")
        # What is there stays; the array is that of the missing part alone.
        finished = (self.folder / "out" / "study.part-1-of-4.rows").stat().st_mtime_ns
        self.submit()
        self.assertIn("--array=2\n", script.read_text())
        self.wait_for_result()
        self.assertEqual(finished, (self.folder / "out" / "study.part-1-of-4.rows").stat().st_mtime_ns)
        self.assertEqual(self.contents("whole"), self.contents("out"))

    def test_what_sbatch_refuses_is_reported(self):
        done = self.run_program(
            "study", "submit", "study.toml", "-o", "out", "--engine", "slurm", "--", "--partition=none"
        )
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("invalid partition", done.stderr)
        self.assertIn("to try by hand, in out: sbatch", done.stderr)

    def test_the_scripts_can_be_submitted_by_hand(self):
        self.run_well("study", "study.toml", "-o", "whole")
        self.submit("--parts", "3", "--dry-run")
        printed = subprocess.run(
            ["sbatch", "--parsable", "study.array.sh"],
            cwd=self.folder / "out",
            text=True,
            env=SLURM.environment,
            capture_output=True,
            check=True,
        ).stdout
        subprocess.run(
            ["sbatch", f"--dependency=afterok:{printed.strip()}", "study.merge.sh"],
            cwd=self.folder / "out",
            env=SLURM.environment,
            capture_output=True,
            check=True,
        )
        self.wait_for_result()
        self.assertEqual(self.contents("whole"), self.contents("out"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
