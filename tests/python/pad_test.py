"""The pad problem from Python."""

import pickle

import numpy
import pytest

import ringfilm
from conftest import PAD


@pytest.fixture
def slider():
    return ringfilm.Case.read(PAD / "inclined_slider.toml")


def test_the_slider_is_that_of_the_closed_form(slider):
    assert slider.is_pad
    result = slider.run()
    values = result.values
    assert result.load.shape == (1,) and values["load"] == result.load[0] > 0
    assert result.pressure.shape == result.film_thickness.shape == (1, result.x.size)
    # The load per width is the integral of the pressure; second order on the cells.
    assert numpy.trapz(result.pressure[0], result.x) == pytest.approx(values["load"], rel=1e-3)


def test_the_file_is_that_of_the_program(slider, folder, run_program):
    assert run_program("run", PAD / "inclined_slider.toml", "--output", "program.nc").returncode == 0
    slider.run().write("module.nc")
    assert (folder / "module.nc").read_bytes() == (folder / "program.nc").read_bytes()


def test_tables(slider):
    pytest.importorskip("xarray")
    data = slider.run().to_xarray()
    assert data["pressure"].dims == ("time", "x") and data["pressure"].attrs["units"] == "Pa"
    frame = slider.run().to_pandas()
    assert frame["load"].iloc[0] == float(data["load"][0])


def test_a_time_integration_reports_its_progress():
    reported = []
    case = ringfilm.Case.read(PAD / "oscillating_squeeze.toml")
    result = case.run(progress=lambda time, end: reported.append((time, end)))
    assert reported and all(0 < time <= end for time, end in reported)
    assert result.load.size > 1 and result.pressure.shape[0] == result.load.size


def test_a_pad_has_a_picture(slider):
    pytest.importorskip("matplotlib")
    assert len(slider.run().plot().axes) == 2


@pytest.mark.parametrize("name", ["inclined_slider.toml", "closed_pocket.toml", "oscillating_squeeze.toml"])
def test_a_result_is_that_of_its_file_and_comes_back_from_a_pickle(name, folder):
    xarray = pytest.importorskip("xarray")
    result = ringfilm.Case.read(PAD / name).run()
    result.write("pad.nc")
    xarray.testing.assert_identical(result.to_xarray(), xarray.load_dataset("pad.nc"))
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(result, protocol))
        again.write("again.nc")
        assert (folder / "again.nc").read_bytes() == (folder / "pad.nc").read_bytes()
