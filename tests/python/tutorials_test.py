"""Each tutorial runs from its first to its last cell. That its page shows what comes out is checked by script/docs."""

import runpy

import pytest
from conftest import SOURCES

matplotlib = pytest.importorskip("matplotlib", reason="no tutorial can be run: python3-matplotlib is missing")
matplotlib.use("Agg")

TUTORIALS = sorted((SOURCES / "docs" / "tutorials").glob("*.py"))


def test_there_are_tutorials():
    assert TUTORIALS


@pytest.mark.parametrize("tutorial", TUTORIALS, ids=lambda path: path.stem)
@pytest.mark.filterwarnings("ignore:FigureCanvasAgg is non-interactive")
def test_a_tutorial_runs(tutorial, monkeypatch):
    import matplotlib.pyplot

    monkeypatch.chdir(SOURCES)
    runpy.run_path(str(tutorial), run_name="__main__")
    assert matplotlib.pyplot.get_fignums(), "it draws no figure"
    matplotlib.pyplot.close("all")
