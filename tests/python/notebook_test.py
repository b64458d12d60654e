"""Notebooks, as Jupyter runs them: what a cell that ends with a figure shows."""

import base64
import pickle

import pytest
from conftest import PAD

nbformat = pytest.importorskip("nbformat", reason="no notebook can be made: python3-nbformat is missing")
nbclient = pytest.importorskip("nbclient", reason="no notebook can be run: python3-nbclient is missing")
pytest.importorskip("ipykernel", reason="no notebook can be run: python3-ipykernel is missing")
pytest.importorskip("matplotlib", reason="no figure can be drawn: python3-matplotlib is missing")


def outputs(folder, monkeypatch, *cells):
    """What the last of the cells shows, by its kinds."""
    # The kernel is a process of its own, and asks for nothing of the user's set-up.
    monkeypatch.setenv("IPYTHONDIR", str(folder / "ipython"))
    monkeypatch.setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1")
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    nbclient.NotebookClient(
        book, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(folder)}}
    ).execute()
    shown = [output for output in book.cells[-1].outputs if output.output_type in ("execute_result", "display_data")]
    assert len(shown) == 1, book.cells[-1].outputs
    return shown[0].data


RUN = "import ringfilm\nresult = ringfilm.Case.read('case.toml').run()"


@pytest.mark.parametrize(
    "cells",
    [
        (RUN, "result.plot()"),
        (RUN, "result.plot('min_film_thickness', label='mine')"),
        (f"import ringfilm\npad = ringfilm.Case.read({str(PAD / 'rayleigh_step.toml')!r}).run()", "pad.plot()"),
        # With pyplot the figure is shown once, too.
        (RUN, "import matplotlib.pyplot as plt\nresult.plot()"),
    ],
)
def test_a_cell_that_ends_with_a_plot_shows_its_picture(folder, monkeypatch, cells):
    shown = outputs(folder, monkeypatch, *cells)
    picture = base64.b64decode(shown["image/png"])
    assert picture.startswith(b"\x89PNG") and len(picture) > 10_000


def test_a_figure_can_be_stored_and_is_one_of_matplotlib(case):
    from matplotlib.figure import Figure

    figure = case.run().plot()
    assert isinstance(figure, Figure)
    assert len(pickle.loads(pickle.dumps(figure)).axes) == len(figure.axes)
