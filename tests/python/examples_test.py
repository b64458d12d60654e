"""Each example of examples/python, run as a program in an empty folder."""

import re
import subprocess
import sys

import pytest
from conftest import SOURCES

EXAMPLES = sorted((SOURCES / "examples" / "python").glob("*.py"))
UNITS = re.compile(r"\d (kPa|MPa|bar|um|mm|W|kN/m|mPa s|l/min)\b")


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_prints_a_few_lines_with_units(example, tmp_path):
    done = subprocess.run([sys.executable, example], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert not done.stderr
    assert 2 <= len(done.stdout.splitlines()) <= 6, done.stdout
    assert UNITS.search(done.stdout), done.stdout


def test_the_table_of_examples_is_complete():
    table = (SOURCES / "examples" / "README.md").read_text()
    named = set(re.findall(r"\]\((python/\w+\.py|cpp/\w+/\w+\.cpp)\)", table))
    folder = SOURCES / "examples"
    assert named == {
        path.relative_to(folder).as_posix()
        for pattern in ("python/*.py", "cpp/*/*.cpp")
        for path in folder.glob(pattern)
    }
    assert len(EXAMPLES) == 12
