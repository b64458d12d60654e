"""What the tests of the Python module share: a small case in a folder of its own, and the program to compare with."""

import os
import pathlib
import subprocess
import sys

import pytest

SOURCES = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCES / "tests" / "cli"))

import program  # noqa: E402

PAD = SOURCES / "cases" / "pad"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The working folder, with case.toml and trace.csv in it."""
    (tmp_path / "trace.csv").write_text(program.TRACE)
    (tmp_path / "case.toml").write_text(program.CASE)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def case(folder):
    import ringfilm

    return ringfilm.Case.read("case.toml")


@pytest.fixture
def run_program(folder):
    """Runs the program in the working folder."""
    name = os.environ.get("RINGFILM_PROGRAM")
    assert name, "set RINGFILM_PROGRAM to the program to compare with"

    def run(*words):
        return subprocess.run([name, *map(str, words)], cwd=folder, capture_output=True, text=True, timeout=120)

    return run
