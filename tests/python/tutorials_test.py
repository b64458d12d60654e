"""Each tutorial runs from its first to its last line, as a program and as a notebook. script/docs checks that its page
shows what comes out."""

import os
import subprocess
import sys

import pytest
from conftest import SOURCES

sys.path.insert(0, str(SOURCES / "docs" / "site"))

from tutorial_cells import cells  # noqa: E402

pytest.importorskip("matplotlib", reason="no tutorial can be run: python3-matplotlib is missing")

TUTORIALS = sorted((SOURCES / "docs" / "tutorials").glob("*.py"))
EACH = pytest.mark.parametrize("tutorial", TUTORIALS, ids=lambda path: path.stem)


def test_there_are_five_tutorials():
    assert len(TUTORIALS) == 5


@pytest.fixture
def cases(tmp_path):
    """A working folder with nothing but the shipped files that tutorials read."""
    for name in ("cases", "data"):
        (tmp_path / name).symlink_to(SOURCES / name)
    return tmp_path


@EACH
def test_a_tutorial_runs_as_a_program(tutorial, cases):
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    done = subprocess.run(
        [sys.executable, tutorial], cwd=cases, env=environment, capture_output=True, text=True, timeout=250
    )
    assert done.returncode == 0, done.stderr


@EACH
def test_a_tutorial_runs_as_a_notebook(tutorial, cases, tmp_path_factory, monkeypatch):
    nbformat = pytest.importorskip("nbformat", reason="no notebook can be made: python3-nbformat is missing")
    nbclient = pytest.importorskip("nbclient", reason="no notebook can be run: python3-nbclient is missing")
    pytest.importorskip("ipykernel", reason="no notebook can be run: python3-ipykernel is missing")
    # The kernel is a process of its own, and asks for nothing of the user's set-up.
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path_factory.mktemp("ipython")))
    monkeypatch.setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1")
    monkeypatch.delenv("MPLBACKEND", raising=False)
    made = {True: nbformat.v4.new_markdown_cell, False: nbformat.v4.new_code_cell}
    book = nbformat.v4.new_notebook(cells=[made[is_text](body) for is_text, body in cells(tutorial.read_text())])
    nbclient.NotebookClient(
        book, timeout=250, kernel_name="python3", resources={"metadata": {"path": str(cases)}}
    ).execute()
    outputs = [output for cell in book.cells if cell.cell_type == "code" for output in cell.outputs]
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    assert pictures, "it shows no figure"
