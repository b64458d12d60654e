#!/usr/bin/env python3
"""Does what docs/manual/extending/adding-a-study.md states, to a copy of the project: its study is planned and its
first part run,
its verification passes, and fails when its expected number is corrupted.

usage: adding_a_study.py SOURCE_FOLDER BUILD_FOLDER
"""

import json
import os
import tomllib

from patched_project import BUILD, Project

STUDY, VERIFICATION = "cases/studies/speed_and_tension.toml", "verification/couette1890_parallel_plates"

with Project("docs/manual/extending/adding-a-study.md") as project:
    files = project.files()
    if STUDY not in files or VERIFICATION + "/reference.toml" not in files:
        project.fail(f"it shows the files {sorted(files)}")
    if project.changed_files() != sorted(files):
        project.fail(f"it overwrites files of the project: {project.changed_files()}")
    environment = {**os.environ, "RINGFILM_DATA": str(project.folder)}
    program = BUILD / "ringfilm"

    def call(*words, expect=0):
        return project.run(program, *words, expect=expect, cwd=project.scratch, env=environment)

    if "part 1 of 3 is done" not in call("study", project.folder / STUDY, "-o", "studied", "--shard", "1/3"):
        project.fail("its study was not run")
    name = VERIFICATION.rpartition("/")[2]
    print(call("verify", name))
    worked_out = json.loads(project.run("/usr/bin/python3", project.folder / VERIFICATION / "reference.py"))
    reference = project.folder / VERIFICATION / "reference.toml"
    right = reference.read_text(encoding="utf-8")
    for value in tomllib.loads(right)["value"]:
        if abs(float(value["expected"].split()[0]) / worked_out[value["label"]] - 1) > 6e-8:
            project.fail(f"reference.py works out another {value['label']}: {worked_out[value['label']]}")
    reference.write_text(right.replace('expected = "', 'expected = "1', 1), encoding="utf-8")
    call("verify", name, expect=4)
print("the study runs; the verification passes, and fails with a wrong number")
