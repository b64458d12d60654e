#!/usr/bin/env python3
"""Does what docs/manual/extending/adding-a-face-form.md states, to a copy of the project: its sources compile with
the warnings of
the build, and the laws of faces hold for the form of the page. What a case makes of the form would take a new build of
all that depends on a case, and is left to the reader's own.

usage: adding_a_face_form.py SOURCE_FOLDER BUILD_FOLDER
"""

from patched_project import Project

LAWS = "tests/laws/motion_and_gas_laws_test.cpp"
CASE = "src/ringfilm/case/"
KEYS = [CASE + "keys/case_fields_pad.cpp", CASE + "keys/case_fields_ring.cpp"]
HEADERS = [
    *(CASE + name for name in ("case_choices.hpp", "case_face.hpp", "ring_face.hpp", "keys/case_fields_table.hpp")),
    "src/ringfilm/models/ring.hpp",
]
FACE = "src/ringfilm/models/ring.cpp"

with Project("docs/manual/extending/adding-a-face-form.md") as project:
    changed = sorted(project.changes())
    expected = sorted([LAWS, *KEYS, *HEADERS, FACE, "docs/theory/ring.md"])
    if changed != expected or project.changed_files() != expected:
        project.fail(f"it should change {expected}, and changes {project.changed_files()}")
    for source in KEYS:
        project.compiled(source, "libringfilm_case.a")
    project.compiled("src/ringfilm/cycle/setup/setup.cpp", "libringfilm_cycle.a")
    laws = project.linked(
        "tests/laws", [project.compiled(FACE, "libringfilm_models.a"), project.compiled(LAWS, "tests/laws")]
    )
    if "[       OK ] FaceLaws.TurningMirrorsEveryForm" not in project.run(laws, "--gtest_filter=FaceLaws.*"):
        project.fail("the laws of faces were not run")
print("the form of the page compiles and keeps the laws of faces")
