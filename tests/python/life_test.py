"""Lives of rings from Python: what `ringfilm life --json` prints, as an object."""

import json
import pickle

import numpy
import pytest

import ringfilm
from conftest import SOURCES

CASES = SOURCES / "cases"


def test_a_life_is_a_dict_over_its_hours():
    life = ringfilm.run_life(str(CASES / "life" / "styles2014.toml"), threads=1)
    first, last = life["states"][0], life["states"][-1]
    alone = ringfilm.Case.read(str(CASES / "styles2014" / "embedded.toml")).run()
    assert (first["hours"], last["hours"]) == (0, 150)
    assert last["mean_power_loss"] == alone.mean_power_loss
    assert len(last["face_height"]) == len(life["x"])


@pytest.fixture(scope="module")
def life():
    return ringfilm.run_life(str(CASES / "life" / "styles2014.toml"))


def test_values_over_the_hours_are_arrays(life):
    assert isinstance(life, ringfilm.LifeResult) and json.loads(json.dumps(life)) == life
    assert list(life.hours) == [state["hours"] for state in life["states"]] and life.title == life["title"]
    assert list(life.fmep) == [state["fmep"] for state in life["states"]] == list(life.values["fmep"])
    assert life.face_height.shape == (life.hours.size, life.x.size)
    assert numpy.isnan(life.worn_area).all() and "worn_area" not in life.values
    assert life.state_origin[1] == "interpolated" and "fmep" in dir(life)
    with pytest.raises(AttributeError, match="did you mean fmep"):
        life.fmpe
    assert "7 states from 0 to 150 h" in repr(life) and "\n" not in repr(life)


def test_a_life_in_a_notebook_has_its_states_with_units(life):
    shown = life._repr_html_()
    assert "minimum film thickness [um]" in shown and f"{1e6 * life.min_film_thickness[0]:.4g}" in shown
    assert shown.count("interpolated") == 4 and "SYNTHETIC" in shown


def test_a_life_as_tables(life, run_program, folder):
    xarray = pytest.importorskip("xarray")
    frame = life.to_pandas()
    assert list(frame.index) == list(life.hours) and list(frame["fmep"]) == list(life.fmep)
    named = life.to_pandas(units="columns")
    assert named.index.name == "hours [h]" and {"fmep [Pa]", "min_lambda_ratio"} <= set(named.columns)
    assert run_program("life", str(CASES / "life" / "styles2014.toml"), "-o", "life.nc").returncode == 0
    made = life.to_xarray()
    with xarray.open_dataset(folder / "life.nc") as stored:
        missing = set(stored.data_vars) - set(made.data_vars)
        assert missing == {"note_text"}
        for name in set(stored.data_vars) - missing:
            numpy.testing.assert_array_equal(made[name].values, stored[name].values, name)
    assert made.fmep.attrs["units"] == "Pa" and made.running_time.attrs["units"] == "h"


def test_a_life_is_pickled_with_its_page(life, tmp_path):
    life.write_report(tmp_path / "life.html")
    pickle.loads(pickle.dumps(life)).write_report(tmp_path / "again.html")
    page = (tmp_path / "life.html").read_text()
    assert page == (tmp_path / "again.html").read_text() and page.lstrip().lower().startswith("<!doctype html>")


def test_a_life_is_drawn_in_the_units_of_engineers(life):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = life.plot()
    assert [axes.get_ylabel().replace("\n", " ") for axes in figure.axes][1] == "minimum film thickness [um]"
    line, dots = figure.axes[1].lines
    assert list(line.get_ydata()) == pytest.approx(list(1e6 * life.min_film_thickness))
    assert list(dots.get_xdata()) == [0, 10, 150], "the measured states"
    assert len(life.plot("face_height").axes[0].lines) == life.hours.size
    assert life.plot("fmep", axes=matplotlib.figure.Figure().subplots()).axes[0].lines
    with pytest.raises(ValueError, match="cannot be drawn"):
        life.plot("nothing")


def test_a_roughness_that_runs_in_is_in_each_state():
    states = ringfilm.run_life(str(CASES / "life" / "running_in.toml"), threads=1)["states"]
    roughness = [state["running_in_roughness"] for state in states]
    assert roughness[0] == pytest.approx(0.48e-6, rel=1e-12)
    assert roughness == sorted(roughness, reverse=True)
    assert {quantity.name for quantity in ringfilm.quantities()["worn"]} >= {"running_in_roughness", "smoothing_share"}


def test_faces_give_lower_bounds():
    rings = [str(CASES / "styles2014" / f"{name}.toml") for name in ("new", "embedded")]
    (pair,) = ringfilm.compare_faces(rings)["pairs"]
    assert pair["tilted"][0]["depth_at_middle"] == pytest.approx(19.3e-6, abs=0.06e-6)


def test_a_file_that_is_not_a_life_is_refused():
    with pytest.raises(ringfilm.InputError):
        ringfilm.run_life(str(CASES / "styles2014" / "new.toml"))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: ringfilm.run_life(5), "path must be a str or a path, not of type int"),
        (lambda: ringfilm.run_life("life.toml", threads="two"), "threads must be an integer"),
        (lambda: ringfilm.compare_faces("new.toml"), "paths must be a list of paths"),
        (lambda: ringfilm.compare_faces(["new.toml", 5]), "each of paths must be a str or a path"),
    ],
)
def test_an_argument_of_a_wrong_type_is_named(call, words):
    with pytest.raises(TypeError) as raised:
        call()
    assert words in str(raised.value) and "incompatible" not in str(raised.value)
