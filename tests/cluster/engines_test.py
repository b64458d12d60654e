"""The engines that the manual shows beside Slurm, with the very words of the manual."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from program import PROGRAM, SOURCES, skip_loudly  # noqa: E402
from study import StudyFolder  # noqa: E402

MANUAL = SOURCES / "docs" / "manual"


class Engines(StudyFolder):
    def setUp(self):
        super().setUp()
        self.write_scenarios(64)
        self.run_well("study", "study.toml", "-o", "whole")

    def by_shell(self, line, **environment):
        path = f"{pathlib.Path(PROGRAM).parent}:{os.environ['PATH']}"
        done = subprocess.run(
            ["/bin/sh", "-c", line],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=600,
            env={**os.environ, "PATH": path, **environment},
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def line_of_manual(self, engine):
        lines = re.findall(rf"^(.*ringfilm study .*?) +# {engine}$", (MANUAL / "study.md").read_text(), re.MULTILINE)
        self.assertEqual(len(lines), 1, engine)
        return lines[0]

    def test_gnu_parallel_computes_the_parts(self):
        if not shutil.which("parallel"):
            skip_loudly(self, "GNU parallel is not installed (script/bootstrap --cluster)")
        self.by_shell(self.line_of_manual("GNU parallel"))
        self.run_well("study", "merge", "study.toml", "-o", "results")
        self.assertEqual(self.contents("whole"), self.contents("results"))

    def test_an_indexed_job_of_kubernetes_computes_and_joins_the_parts(self):
        try:
            import yaml
        except ImportError:
            skip_loudly(self, "python3-yaml is not installed (script/bootstrap --cluster)")
        parts, merge = yaml.safe_load_all((MANUAL / "study-kubernetes.yaml").read_text())
        for job in (parts, merge):
            self.assertEqual((job["apiVersion"], job["kind"]), ("batch/v1", "Job"))
            pod = job["spec"]["template"]["spec"]
            self.assertIn(pod["restartPolicy"], ("OnFailure", "Never"))
            mounted = {mount["name"] for mount in pod["containers"][0]["volumeMounts"]}
            self.assertEqual(mounted, {volume["name"] for volume in pod["volumes"]})
        self.assertEqual(parts["spec"]["completionMode"], "Indexed")
        container = parts["spec"]["template"]["spec"]["containers"][0]
        self.assertEqual(container["command"], ["/bin/sh", "-c"])
        (line,) = container["args"]
        self.assertIn(self.line_of_manual("Kubernetes").split("--resume")[-1], line)
        for index in range(parts["spec"]["completions"]):
            self.by_shell(line, JOB_COMPLETION_INDEX=str(index))
        words = merge["spec"]["template"]["spec"]["containers"][0]["command"]
        self.assertEqual(words[0], "ringfilm")
        self.run_well(*words[1:])
        self.assertEqual(self.contents("whole"), self.contents("results"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
