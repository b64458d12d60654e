#!/usr/bin/env python3
"""Does what docs/manual/extending/adding-a-law.md states, to a copy of the project, and looks whether all comes
that it promises.

usage: adding_a_law.py SOURCE_FOLDER BUILD_FOLDER
"""

import difflib
import os
import shutil
import sys

from patched_project import BUILD, SOURCE, Project

sys.path.insert(0, str(SOURCE / "tests" / "cli"))
from program import CASE, TRACE  # noqa: E402

PAGE = "docs/manual/extending/adding-a-law.md"
LAW, THEORY = "src/ringfilm/models/oil/viscosity_laws.cpp", "docs/theory/oil.md"
KEYS = "docs/manual/case-keys.txt"
TRUE_SLOPE, FALSE_SLOPE = "n * a * eta", "a * eta"


def check_cases(project, program):
    """Cases with the law: run, recorded, and refused where something is missing or of another law."""
    scratch = project.scratch
    (scratch / "trace.csv").write_text(TRACE, encoding="utf-8")
    law, numbers = 'viscosity_pressure = "cameron"\n', 'cameron_coefficient = "6e-10 Pa-1"\n'

    def call(lines, *words, expect=0):
        (scratch / "case.toml").write_text(CASE.replace("[lubricant]\n", "[lubricant]\n" + lines), encoding="utf-8")
        return project.run(
            program, *words, expect=expect, cwd=scratch, env={**os.environ, "RINGFILM_DATA": str(SOURCE)}
        )

    if "lubricant.cameron_coefficient" not in call(law, "check", "case.toml", expect=2):
        project.fail("a missing number is not reported by its key")
    of_another = 'pressure_viscosity_coefficient = "1e-8 Pa-1"\n'
    if "pressure_viscosity_coefficient is not used" not in call(
        law + numbers + of_another, "check", "case.toml", expect=2
    ):
        project.fail("a number of another law is not refused")
    call(law + numbers, "run", "case.toml", "--output", "result.nc")
    result = (scratch / "result.nc").read_bytes()
    if b"cameron_exponent" not in result or b'"cameron"' not in result:
        project.fail("the result does not state which law was taken, with which numbers")


# The case has the law with a = 6e-10 1/Pa.
IN_PYTHON = """
import ringfilm
case = ringfilm.Case.read("case.toml")
assert case["lubricant.cameron_exponent"] == 16
case["lubricant.cameron_exponent"] = 8
oil = ringfilm.laws.oil(case)
assert abs(oil.viscosity(1e8) / oil.viscosity(0.0) / 1.06**8 - 1) < 1e-12
"""


def check_python(project, law):
    """The names of the law in Python, and the law itself against its formula."""
    built = BUILD / "python" / "ringfilm"
    module = next(iter(sorted(built.glob("_ringfilm*.so"))), None)
    if module is None:
        print("SKIPPED Docs.TheLawOfThePageNeedsTwoFiles: the Python module is not built, its names were not tried")
        return
    package = project.scratch / "python" / "ringfilm"
    shutil.copytree(built, package)
    shutil.move(project.linked(module.relative_to(BUILD).as_posix(), law), package / module.name)
    project.run(
        "/usr/bin/python3",
        "-c",
        IN_PYTHON,
        cwd=project.scratch,
        env={**os.environ, "PYTHONPATH": str(package.parent), "RINGFILM_DATA": str(SOURCE)},
    )


with Project(PAGE) as project:
    changed = project.changes()
    if sorted(changed) != sorted([LAW, THEORY]) or project.changed_files() != sorted(changed):
        project.fail(f"it should change {LAW} and {THEORY}, and changes {project.changed_files()}")

    law = [project.compiled(LAW, "libringfilm_models.a")]
    for target in ("tests/laws", "tests/unit_models", "tests/unit_cycle"):
        tests = project.linked(target, law)
        print(project.run(tests, "--gtest_brief=1", "--gtest_filter=*Law*:*Oil*:CaseFields.*:CaseRules.*").strip())
    program = project.linked("ringfilm", law)
    fields = project.run(program, "fields")
    stored = (SOURCE / KEYS).read_text(encoding="utf-8")
    added = [line for line in difflib.ndiff(stored.splitlines(), fields.splitlines()) if line.startswith("+ ")]
    print("\n".join(added))
    for words in ("roelands | none | barus | cameron", "cameron_coefficient", "cameron_exponent"):
        if not any(words in line for line in added):
            project.fail(f"ringfilm fields does not report {words}")
    check_cases(project, program)
    check_python(project, law)

    documents = project.linked("tests/docs/docs", law)
    environment = {**os.environ, "RINGFILM_DOCUMENTS": str(project.folder)}
    only = "--gtest_filter=Docs.*Law*:Docs.*Equation*:Docs.*Label*"
    project.run(documents, only, expect=None, env=environment)  # the list of keys is still the old one
    (project.folder / KEYS).write_text(fields, encoding="utf-8")
    project.run(documents, only, env=environment)
    shutil.copy(SOURCE / THEORY, project.folder / THEORY)
    if "eq-cameron" not in project.run(documents, only, expect=None, env=environment):
        project.fail("nothing states that the equation is missing")

    right = (project.folder / LAW).read_text(encoding="utf-8")
    if TRUE_SLOPE not in right:
        project.fail(f"the law has no {TRUE_SLOPE} to corrupt")
    (project.folder / LAW).write_text(right.replace(TRUE_SLOPE, FALSE_SLOPE), encoding="utf-8")
    faulty = project.linked("tests/laws", [project.compiled(LAW, "libringfilm_models.a")])
    if "HaveTheSlopeOfTheirValues" not in project.run(faulty, "--gtest_filter=*Laws.*", expect=None):
        project.fail("a wrong slope is not caught")
print("two files, and all came that the page promises")
