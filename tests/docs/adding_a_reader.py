#!/usr/bin/env python3
"""Does what docs/manual/extending/adding-a-reader.md states, to a copy of the project, and runs the page's own
tests of the reader.

usage: adding_a_reader.py SOURCE_FOLDER BUILD_FOLDER
"""

from patched_project import Project

MODULE = "src/ringfilm/instrument/"
TEST = "tests/unit/instrument/surfer_grid_file_test.cpp"

with Project("docs/manual/extending/adding-a-reader.md") as project:
    changed = sorted(project.changes())
    expected = [
        MODULE + "formats/surfer_grid_file.cpp",
        MODULE + "formats/surfer_grid_file.hpp",
        MODULE + "surface_file.cpp",
        TEST,
    ]
    if changed != expected or project.changed_files() != expected:
        project.fail(f"it should change {expected}, and changes {project.changed_files()}")
    reader = [
        project.compiled(MODULE + "surface_file.cpp", "libringfilm_instrument.a"),
        project.compiled(
            MODULE + "formats/surfer_grid_file.cpp",
            "libringfilm_instrument.a",
            like=MODULE + "formats/simple_field_file.cpp",
        ),
        project.compiled(TEST, "tests/unit_instrument", like="tests/unit/instrument/simple_field_file_test.cpp"),
    ]
    tests = project.linked("tests/unit_instrument", reader)
    printed = project.run(tests, "--gtest_filter=SurferGrid.*:SimpleField.*:HostileFile.*")
    if printed.count("[       OK ] SurferGrid.") != 3:
        project.fail(f"its three tests did not run:\n{printed}")
print("the reader of the page reads, asks and refuses")
