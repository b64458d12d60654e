"""What a kill loses of a study: nothing that waits for a slower scenario."""

import re
import signal
import subprocess
import time
import unittest

from program import PROGRAM
from study import STUDY, StudyFolder

# The first scenario takes as long as some thousands of the others.
LIST = "cells,step [degree],speed [rpm]\n8000,0.02,1000\n" + "".join(f"60,1,{1000 + n}\n" for n in range(6000))
FACTORS = "".join(
    f'[[factor]]\nname = "{name}"\nkey = "{key}"\n'
    for name, key in (("cells", "solver.cells"), ("step", "solver.crank_step"), ("speed", "operating.speed"))
)


class KilledStudy(StudyFolder):
    def setUp(self):
        super().setUp()
        (self.folder / "plan.csv").write_text(LIST)
        plan = '[plan]\nmethod = "list"\nlist = "plan.csv"\n'
        (self.folder / "study.toml").write_text(STUDY[: STUDY.index("[[factor]]")] + FACTORS + plan)

    def start(self):
        return subprocess.Popen(
            [PROGRAM, "study", "study.toml", "-o", "out", "--threads", "2", "--resume"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )

    def rows_there(self):
        printed = self.run_well("study", "status", "study.toml", "-o", "out")
        found = re.search(r"part 1 of 1: (\d+) of 6001 scenarios, 0 not solved, not finished", printed)
        return int(found.group(1)) if found else 0

    def wait_for_rows(self, run, n):
        while self.rows_there() < n:
            self.assertIsNone(run.poll(), "the study ended before its rows were written")
            time.sleep(0.1)

    def test_rows_that_wait_for_a_slow_scenario_are_on_the_disk(self):
        run = self.start()
        self.wait_for_rows(run, 100)
        run.kill()
        run.communicate(timeout=100)
        kept = self.rows_there()
        self.assertGreaterEqual(kept, 100)
        # They are not computed again, and a stop keeps those that wait, too.
        run = self.start()
        self.wait_for_rows(run, kept + 1)
        run.send_signal(signal.SIGINT)
        _, printed = run.communicate(timeout=100)
        self.assertEqual(run.returncode, 128 + signal.SIGINT, printed)
        found = re.search(r"stopped: (\d+) of 6001 scenarios are kept", printed)
        self.assertGreater(int(found.group(1)), kept)
        self.assertEqual(self.rows_there(), int(found.group(1)))


if __name__ == "__main__":
    unittest.main(verbosity=2)
