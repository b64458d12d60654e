"""The gas between the rings of a pack from Python."""

import copy
import json
import pathlib
import pickle

import numpy
import pytest

import ringfilm
from conftest import SOURCES

PACK = pathlib.Path(SOURCES) / "cases" / "ring-pack" / "two_rings.toml"


def test_the_record_is_that_of_the_program(run_program):
    record = ringfilm.gas_path(PACK)
    curves = record.pop("curves")
    assert record == json.loads(run_program("gas", str(PACK), "--json").stdout)
    assert set(curves["pressure"]) == {region["name"] for region in record["regions"]}
    assert curves["pressure"]["land 2"].shape == curves["crank_angle"].shape == (720,)
    peak = next(region["peak_pressure"] for region in record["regions"] if region["name"] == "land 2")
    assert curves["pressure"]["land 2"].max() == pytest.approx(peak, rel=1e-3)
    assert set(curves["position"]) == {1, 2}


@pytest.fixture(scope="module")
def gas():
    """The gas of rings that move."""
    return ringfilm.gas_path(PACK, {"gas_path.ring_motion": "axial"})


def test_names_of_the_record_are_attributes(gas):
    assert isinstance(gas, ringfilm.GasPathResult) and isinstance(gas, dict)
    assert gas.blow_by_flow == gas["blow_by_flow"] == gas.values["blow_by_flow"] > 0
    assert set(gas.values) <= set(gas["units"]) and all(isinstance(value, float) for value in gas.values.values())
    assert gas.pressure is gas["curves"]["pressure"] and gas.crank_angle.shape == (720,)
    assert {"blow_by_flow", "pressure"} <= set(dir(gas))
    with pytest.raises(AttributeError, match="did you mean blow_by_flow"):
        gas.blow_by_flo
    assert repr(gas).count("\n") == 0 and f"{6e4 * gas.blow_by_flow:.3g} l/min" in repr(gas)


def test_the_gas_of_a_notebook_has_its_first_values_with_units(gas):
    shown = gas._repr_html_()
    assert "[l/min]" in shown and f"{6e4 * gas.blow_by_flow:.4g}" in shown
    assert "land 2" in shown and "SYNTHETIC" in shown


def test_the_gas_is_copied_and_pickled_with_its_page(gas, tmp_path):
    gas.write_report(tmp_path / "gas.html")
    for again in (copy.copy(gas), copy.deepcopy(gas), pickle.loads(pickle.dumps(gas))):
        assert again.values == gas.values and type(again) is type(gas)
        numpy.testing.assert_array_equal(again.pressure["land 2"], gas.pressure["land 2"])
        again.write_report(tmp_path / "again.html")
        assert (tmp_path / "again.html").read_text() == (tmp_path / "gas.html").read_text()
    assert (tmp_path / "gas.html").read_text().lstrip().lower().startswith("<!doctype html>")
    with pytest.raises(ringfilm.OutputError):
        gas.write_report(tmp_path / "no" / "folder.html")


def test_the_page_is_made_as_by_the_program(gas, run_program, folder):
    given = ("--set", "gas_path.ring_motion=axial", "-o", "gas.nc")
    assert run_program("gas", str(PACK), *given).returncode == 0
    assert run_program("report", "gas.nc", "--output", "program.html").returncode == 0
    gas.write_report("module.html")
    module, program = ((folder / f"{name}.html").read_text() for name in ("module", "program"))
    assert module[:1000] == program[:1000] and gas.title in module and '"land 2"' in module
    assert len(module) == pytest.approx(len(program), rel=0.05)


def test_the_gas_as_tables(gas, run_program, folder):
    pytest.importorskip("xarray")
    assert run_program("gas", str(PACK), "--set", "gas_path.ring_motion=axial", "--csv", "gas.csv").returncode == 0
    frame = gas.to_pandas(units="columns")
    head = (folder / "gas.csv").read_text().partition("\n")[0].split(",")
    assert [frame.index.name, *frame.columns] == head
    assert gas.to_pandas().attrs["units"]["flow_end_gap_1"] == "kg/s"
    numpy.testing.assert_array_equal(gas.to_pandas()["pressure_land_2"], gas.pressure["land 2"])
    with pytest.raises(ValueError, match="neither"):
        gas.to_pandas(units="rows")
    data = gas.to_xarray("firing")
    assert float(data.gas_region_pressure.sel(crank_angle=-20, gas_region="land 2")) == gas.pressure["land 2"][700]
    assert float(data.blow_by_flow) == gas.blow_by_flow and data.blow_by_flow.attrs["units"] == "m3/s"
    with pytest.raises(ValueError, match="neither"):
        gas.to_xarray("tdc")


def test_the_dataset_has_the_numbers_of_the_file(gas, run_program, folder):
    xarray = pytest.importorskip("xarray")
    assert run_program("gas", str(PACK), "--set", "gas_path.ring_motion=axial", "-o", "gas.nc").returncode == 0
    made = gas.to_xarray()
    with xarray.open_dataset(folder / "gas.nc") as stored:
        common = set(made.data_vars) & set(stored.data_vars)
        assert common == set(made.data_vars) and len(common) > 20
        for name in common:
            numpy.testing.assert_array_equal(made[name].values, stored[name].values, name)
            for word in ("units", "long_name"):
                assert made[name].attrs[word] == stored[name].attrs[word]


def test_the_gas_is_drawn_with_firing_tdc_in_the_middle(gas):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = gas.plot()
    assert len(figure.axes) == 3 and figure.axes[0].get_xlim() == (-360, 360)
    words = " ".join(text.get_text() for text in figure.findobj(matplotlib.text.Text))
    assert "SYNTHETIC" in words and "[bar" in words
    line = next(line for line in gas.plot("pressure").axes[0].lines if line.get_label() == "land 2")
    at = dict(zip(line.get_xdata(), line.get_ydata()))
    assert at[-20] == pytest.approx(1e-5 * gas.pressure["land 2"][700])
    assert gas.plot("flow", axes=matplotlib.figure.Figure().subplots()).axes[0].get_xlabel()
    for wrong in (("nothing", None), ("overview", figure.axes[0])):
        with pytest.raises(ValueError):
            gas.plot(*wrong)


def test_a_case_without_gas_path_is_refused(case):
    with pytest.raises(ringfilm.InputError, match="there is no gas to compute"):
        ringfilm.gas_path(case)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((5,), "case, if it is not a ringfilm.Case, must be a str or a path, not of type int"),
        ((PACK, 5), "overrides must be a dict of texts, not of type int"),
        ((PACK, {3: "axial"}), "a key of overrides must be a text"),
        ((PACK, {"operating.speed": 1500}), 'overrides["operating.speed"] must be a text'),
    ],
)
def test_an_argument_of_a_wrong_type_is_named(arguments, words):
    with pytest.raises(TypeError) as raised:
        ringfilm.gas_path(*arguments)
    assert words in str(raised.value) and "incompatible" not in str(raised.value)
