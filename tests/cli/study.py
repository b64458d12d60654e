"""A small study around the case of program.py, to be run with some number for SCENARIOS."""

from program import ProgramTest

STUDY = """\
title = "a small study"
kind = "uncertainty"
seed = 5

[[base]]
name = "new"
case = "case.toml"

[[factor]]
name = "speed"
key = "operating.speed"
range = ["1000 rpm", "3000 rpm"]

[[factor]]
name = "roughness"
key = "contact.roughness"
how = "scale"
distribution = "normal"
mean = 1.0
deviation = 0.1
truncate = [0.5, 1.5]

[plan]
method = "sobol"
scenarios = SCENARIOS
"""


class StudyFolder(ProgramTest):
    """A folder with study.toml in it, around the case of ProgramTest."""

    def write_scenarios(self, n):
        (self.folder / "study.toml").write_text(STUDY.replace("SCENARIOS", str(n)))

    def run_well(self, *words):
        """Lines of progress may be reported where the machine is slow."""
        done = self.run_program(*words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def contents(self, output):
        return [(self.folder / output / name).read_bytes() for name in ("study.nc", "study.csv", "study.html")]
