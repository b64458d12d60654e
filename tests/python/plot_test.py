"""Figures: what is on them, in which unit, over which axis. How they look is looked at by people."""

import numpy
import pytest

import ringfilm
from conftest import PAD

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

from matplotlib.figure import Figure  # noqa: E402

from ringfilm._plots import plot_pad, plot_result  # noqa: E402

PANELS = ("overview", "film", "friction")


@pytest.fixture
def result(case):
    case["output.fields"] = [0.0, 20.0, 350.0]
    return case.run()


def at_speed(case, rpm):
    case = case.copy()
    case["operating.speed"] = f"{rpm} rpm"
    return case.run()


def words_of(figure):
    """All that can be read on a figure."""
    return " ".join(text.get_text().replace("\n", " ") for text in figure.findobj(matplotlib.text.Text))


def reaches(figure, artist):
    """Where an artist lies on its figure, in shares of it: left, bottom, right, top."""
    figure.draw_without_rendering()
    box = artist.get_window_extent().transformed(figure.transFigure.inverted())
    return box.x0, box.y0, box.x1, box.y1


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


@pytest.mark.parametrize("what", [*PANELS, "stribeck", "film_pressure", "film_content", "power_loss"])
def test_every_kind_can_be_drawn_and_has_a_caption(result, what, tmp_path):
    figure = result.plot(what)
    figure.savefig(tmp_path / "x.png")
    assert "a small case" in words_of(figure)


@pytest.mark.parametrize("what", ["total_friction", "stribeck", "film_pressure"])
def test_into_axes_of_ones_own(result, what):
    axes = Figure().subplots()
    assert result.plot(what, axes=axes) is axes.figure
    assert axes.lines and axes.get_ylabel()


@pytest.mark.parametrize("what", PANELS)
def test_several_panels_do_not_go_into_one_axes(result, what):
    with pytest.raises(ValueError, match="several panels"):
        result.plot(what, axes=Figure().subplots())


@pytest.mark.parametrize("what", ["min_film_thickness", "stribeck", "film_pressure"])
def test_a_second_result_in_the_same_axes_is_seen_whole_and_distinguished(case, what):
    case["output.fields"] = [20.0]
    axes = Figure().subplots()
    slow, fast = at_speed(case, 1000), at_speed(case, 2000)
    slow.plot(what, axes=axes)
    fast.plot(what, axes=axes)
    curves = [line for line in axes.lines if len(line.get_xdata()) > 2]
    assert len(curves) == 2 and len({line.get_color() for line in curves}) == 2
    bottom, top = axes.get_ylim()
    assert bottom == 0
    assert all(numpy.nanmax(line.get_ydata()) <= top for line in curves)
    reported = [text.get_text() for text in axes.legend().get_texts()]
    assert len(set(reported)) == 2 and all("a small case" in label for label in reported)


def test_a_label_and_a_style_of_ones_own(result):
    axes = Figure().subplots()
    plot_result(result, "power_loss", axes, label="mine", color="red", lw=3)
    line = axes.lines[0]
    assert (line.get_label(), line.get_color(), line.get_linewidth()) == ("mine", "red", 3)
    figure = plot_result(result, "power_loss", label="mine")
    assert figure.axes[0].get_legend().get_texts()[0].get_text() == "mine"
    with pytest.raises(ValueError, match="several panels"):
        plot_result(result, "overview", label="mine")


def test_a_made_up_pressure_is_marked_wherever_it_appears(case):
    case["gas.trace_origin"] = "synthetic"
    result = case.run()
    for what in ("overview", "gas_pressure"):
        figure = result.plot(what)
        assert "SYNTHETIC" in words_of(figure.axes[0]) and "SYNTHETIC" in figure.texts[0].get_text()
    axes = Figure().subplots()
    result.plot("gas_pressure", axes=axes)
    assert "SYNTHETIC" in words_of(axes) and "SYNTHETIC" in axes.lines[0].get_label()
    case["gas.trace_origin"] = "measured"
    assert "SYNTHETIC" not in words_of(case.run().plot())


@pytest.mark.parametrize("what", ["film", "oil_flow_middle", "rupture_position", "newton_iterations"])
def test_labels_stay_beside_their_panels_with_their_unit(result, what):
    figure = result.plot(what)
    figure.draw_without_rendering()
    units = {"oil_flow_middle": "[mg/s]", "rupture_position": "[um]", "newton_iterations": "angle", "film": ""}
    for panel in figure.axes:
        label = panel.yaxis.label.get_window_extent()
        inside = panel.get_window_extent()
        assert label.y0 >= inside.y0 - 4 and label.y1 <= inside.y1 + 4, "of 4 pixels, a letter has 8"
        assert panel.get_ylabel().endswith(units[what])


def test_a_long_title_is_reported_in_lines_that_fit(case):
    case["title"] = "all that there is to report about engine, ring, oil and liner, and its price of $5 or $6, " * 4
    figure = case.run().plot()
    left, bottom, right, top = reaches(figure, figure.texts[0])
    assert 0 <= left < right <= 1 and 0 <= bottom < top <= reaches(figure, figure.axes[-1].xaxis.label)[1]
    assert "$5" in figure.texts[0].get_text().replace("\\", "")


def test_what_was_not_computed_is_not_drawn(case):
    case["output.crank_angles"] = [0.0, 20.0, 400.0]
    line = case.run().plot("power_loss").axes[0].lines[0]
    y = line.get_ydata()
    assert numpy.isfinite(y).sum() == 3 and not (numpy.isfinite(y[1:]) & numpy.isfinite(y[:-1])).any()
    assert line.get_marker() == "o" and list(line.get_markevery()) == list(numpy.flatnonzero(numpy.isfinite(y)))


def test_few_fields_are_curves_along_the_face(result):
    axes = result.plot("film_pressure").axes[0]
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["0 degree", "20 degree", "350 degree"]
    numpy.testing.assert_allclose(axes.lines[1].get_ydata() * 1e5, result["film_pressure"][1])
    low, high = result.plot("film_content").axes[0].get_ylim()
    assert low == 0 and high == pytest.approx(1.05)


def test_many_fields_are_a_map_that_is_blank_between(case):
    case["output.fields"] = [*numpy.arange(0.0, 40.0, 2.0), 100.0, 350.0]
    figure = case.run().plot("film_pressure")
    mesh = figure.axes[0].collections[0]
    edges = mesh.get_coordinates()[0, :, 0]
    there = ~numpy.ma.getmaskarray(mesh.get_array()).reshape(-1, len(edges) - 1)[0]
    widths = numpy.diff(edges)
    assert there.sum() == 22 and widths[there] == pytest.approx(2.0)
    assert "white where none was computed" in words_of(figure)
    case["output.fields"] = "all"
    figure = case.run().plot("film_content")
    assert figure.axes[0].collections[0].get_clim() == (0, 1)
    assert "white" not in words_of(figure)


def test_what_cannot_be_drawn_is_refused(result):
    with pytest.raises(ValueError, match="cannot be drawn"):
        result.plot("nothing")


def test_an_integration_that_stopped_is_not_reported_as_a_batch(case):
    case["contact.asperity_density"] = "1e-6 um-2"
    case["contact.roughness"] = "0.01 um"
    case["ring.elastic_pressure"] = "60 MPa"
    case["ring.face.crown_height"] = "200 um"
    case["ring.face.apex"] = 0.0  # no wedge on the way up
    with pytest.raises(ringfilm.ConvergenceError) as stop:
        case.run()
    assert not stop.value.result.crank_angle.size
    with pytest.raises(ValueError, match="the integration stopped before the first crank angle"):
        stop.value.result.plot()
    with pytest.raises(ValueError, match="the case was not solved: at 270 degree"):
        ringfilm.simulate_many([case])[0].plot()


def test_a_batch_without_curves_reports_how_to_have_them(case):
    with pytest.raises(ValueError, match='curves="all"'):
        ringfilm.simulate_many([case], curves="none")[0].plot()


def pad(name):
    return ringfilm.Case.read(PAD / f"{name}.toml").run()


def test_a_pad_is_drawn_in_units_of_its_size():
    gap, pressure = pad("inclined_slider").plot().axes
    assert (gap.get_ylabel(), pressure.get_ylabel()) == ("film thickness [um]", "film pressure [MPa]")
    assert pressure.get_xlabel() == "place along the pad [mm]"
    figure = pad("oscillating_squeeze").plot()
    gap, pressure = figure.axes
    assert (gap.get_ylabel(), pressure.get_ylabel()) == ("film thickness [m]", "film pressure [Pa]")
    assert pressure.get_xlabel() == "place along the pad [m]"
    assert pressure.get_ylim()[1] == pytest.approx(0.025, rel=0.1)
    assert f"ringfilm {ringfilm.__version__}" in words_of(figure)


def test_a_part_of_a_pad_into_axes_of_ones_own():
    squeeze = pad("oscillating_squeeze")
    axes = Figure().subplots()
    assert plot_pad(squeeze, "pressure", axes, label="end") is axes.figure
    numpy.testing.assert_array_equal(axes.lines[0].get_ydata(), squeeze.pressure[-1])
    assert len(plot_pad(squeeze, "load").axes[0].lines[0].get_xdata()) == len(squeeze.time)
    with pytest.raises(ValueError, match="one instant only"):
        plot_pad(pad("inclined_slider"), "load")
    with pytest.raises(ValueError, match="cannot be drawn"):
        plot_pad(squeeze, "nothing")


def test_a_second_pad_keeps_the_unit_of_the_first():
    axes = Figure().subplots()
    plot_pad(pad("oscillating_squeeze"), "film_thickness", axes)
    plot_pad(pad("inclined_slider"), "film_thickness", axes)
    assert axes.get_ylabel() == "film thickness [m]"
    assert axes.lines[1].get_ydata().max() == pytest.approx(20e-6)


def test_small_flows_of_a_pad_keep_their_small_unit():
    from ringfilm._drawing import fitting_unit

    flow = next(quantity for quantity in ringfilm.quantities()["pad"] if quantity.name == "mass_flow_left")
    assert fitting_unit([2e-5], flow) == ("g/(m s)", pytest.approx(1e-3))
    gap = next(quantity for quantity in ringfilm.quantities()["pad_film"] if quantity.name == "film_thickness")
    for size, unit in ((5e-8, "nm"), (5e-7, "um"), (2e-3, "mm"), (0.5, "m"), (0.0, "um")):
        assert fitting_unit([size, numpy.nan, -size], gap)[0] == unit
