"""Figures: what is on them, in which unit, over which axis. How they look is looked at by people."""

import numpy
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")


@pytest.fixture
def result(case):
    case["output.fields"] = [0.0, 20.0, 350.0]
    return case.run()


def test_a_curve_in_the_unit_of_engineers_with_firing_tdc_in_the_middle(result):
    axes = result.plot("min_film_thickness").axes[0]
    assert axes.get_ylabel() == "minimum film thickness [um]"
    assert axes.get_xlim() == (-360, 360)
    line = axes.get_lines()[0] if axes.get_lines()[0].get_xdata().__len__() > 2 else None
    x, y = line.get_xdata(), line.get_ydata()
    assert (numpy.diff(x) > 0).all()
    at = {angle: value for angle, value in zip(x, y)}
    assert at[20] == pytest.approx(result.min_film_thickness[20] * 1e6)
    assert at[-100] == pytest.approx(result.min_film_thickness[620] * 1e6)


@pytest.mark.parametrize("what", ["overview", "film", "friction", "stribeck", "film_pressure", "fill", "power_loss"])
def test_every_kind_can_be_drawn_and_has_a_caption(result, what, tmp_path):
    figure = result.plot(what)
    figure.savefig(tmp_path / "x.png")
    assert any("a small case" in text.get_text() for text in figure.texts)


def test_into_axes_of_ones_own(result):
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    assert result.plot("total_friction", axes=axes) is axes.figure


def test_what_cannot_be_drawn_is_refused(result):
    with pytest.raises(ValueError, match="cannot be drawn"):
        result.plot("nothing")
