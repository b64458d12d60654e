"""Submission where Slurm's commands fail: programs of a few lines replace them."""

import os
import unittest

from study import STUDY, StudyFolder

SUBMIT = ["study", "submit", "study.toml", "-o", "out", "--engine", "slurm", "--parts", "2"]


class Submission(StudyFolder):
    def setUp(self):
        super().setUp()
        self.write_scenarios(16)
        self.put("sbatch", "echo 41\n")
        self.put("squeue", "exit 0\n")

    def put(self, name, text):
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        (folder / name).write_text("#!/bin/sh\n" + text)
        (folder / name).chmod(0o755)

    def submit(self, *words):
        path = f"{self.folder / 'bin'}:{os.environ['PATH']}"
        return self.run_program(*SUBMIT, *words, env={**os.environ, "PATH": path})

    def test_where_the_queue_cannot_be_seen_nothing_is_submitted_twice(self):
        self.assertEqual(self.submit().returncode, 0)
        self.assertEqual(self.submit().returncode, 0)  # the queue is empty
        self.put("squeue", "echo 'Unable to contact slurm controller'; exit 1\n")
        self.assert_refused(self.submit(), "squeue does not answer", "jobs 41 and 41", "--yes")
        self.assertEqual(self.submit("--yes").returncode, 0)

    def test_a_merge_that_is_not_taken_leaves_nobody_in_the_dark(self):
        self.put("sbatch", 'case "$*" in *merge*) echo "no such partition"; exit 1;; esac\necho 41\n')
        done = self.submit()
        self.assertEqual(done.returncode, 4, done.stderr)
        for words in ("no such partition", "to try by hand", "scancel 41"):
            self.assertIn(words, done.stderr)
        self.put("squeue", "echo '1 RUNNING None'\n")
        self.assert_refused(self.submit(), "in the queue already, as job 41", "scancel 41")

    def test_a_part_whose_header_was_cut_off_is_begun_anew(self):
        self.run_well("study", "study.toml", "-o", "out", "--shard", "1/2")
        rows = self.folder / "out" / "study.part-1-of-2.rows"
        rows.with_suffix(".growing").write_bytes(rows.read_bytes()[:100])
        rows.unlink()
        self.assertEqual(self.submit().returncode, 0)
        self.assertIn("--array=1-2\n", (self.folder / "out" / "study.array.sh").read_text())

    def test_a_study_with_until_is_not_submitted(self):
        (self.folder / "study.toml").write_text(
            STUDY.replace("SCENARIOS", "8").replace(
                "[plan]\n", '[plan]\nuntil = { value = "fmep", width = "1 Pa", most = 64 }\n'
            )
        )
        done = self.submit()
        self.assert_refused(done, "cannot be submitted", "ringfilm study study.toml -o out --resume")
        self.assertNotIn("--shard", done.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
