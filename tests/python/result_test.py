"""Results: the program's numbers to the last bit, views without a copy, files, tables of xarray and pandas, pickles."""

import gc
import json
import pickle
import re

import numpy
import pytest

import ringfilm
from conftest import PAD, SOURCES


@pytest.fixture
def result(case):
    case["output.fields"] = [0.0, 20.0]
    return case.run()


def test_the_file_is_that_of_the_program(case, folder, run_program):
    assert run_program("run", "case.toml", "--output", "program.nc").returncode == 0
    case.run().write("module.nc")
    assert (folder / "module.nc").read_bytes() == (folder / "program.nc").read_bytes()


def test_the_table_is_that_of_the_program(case, folder, run_program):
    assert run_program("run", "case.toml", "--csv", "program.csv").returncode == 0
    case.run().write_csv("module.csv")
    assert (folder / "module.csv").read_bytes() == (folder / "program.csv").read_bytes()


def test_curves_are_views_without_a_copy(result):
    curve = result.min_film_thickness
    assert curve.shape == result.crank_angle.shape == (720,)
    assert not curve.flags.owndata and not curve.flags.writeable
    assert numpy.shares_memory(curve, result["min_film_thickness"])
    # Curve after curve of one crank angle: the neighbour in memory is another quantity.
    assert curve.strides[0] > curve.itemsize
    with pytest.raises(ValueError):
        curve[0] = 1


def test_a_view_keeps_its_result_alive(case):
    curve = case.run().min_film_thickness
    expected = curve.copy()
    gc.collect()
    case.run()
    numpy.testing.assert_array_equal(curve, expected)


def test_values_of_the_cycle(result):
    assert result.fmep == result.values["fmep"] > 0
    assert result.cycle_min_film_thickness == result.values["min_film_thickness"]
    # The vertex of the parabola through the thinnest step and its neighbours.
    assert result.cycle_min_film_thickness == pytest.approx(result.min_film_thickness.min(), rel=1e-3)
    assert result["fmep"] == result["cycle_fmep"] == result.fmep
    assert result.derived["elastic_pressure"] == 0.2e6
    assert result.complete and not result.reason


def test_an_unknown_name_is_a_key_error_with_a_suggestion(result):
    with pytest.raises(KeyError, match="did you mean min_film_thickness"):
        result["min_film_thicknes"]


def test_fields(result):
    assert result["film_pressure"].shape == (2, result["x"].size)
    assert list(result["field_crank_angle"]) == [0.0, 20.0]


def test_notes_and_assumptions_come_along(result):
    assert all(len(note) == 3 for note in result.notes)
    assert {key for key, *_ in result.inputs} >= {"engine.bore", "ring.youngs_modulus"}
    assert result.assumptions and result.effort["cycles_integrated"] > 0
    assert result.effort == json.loads(result.to_json())["effort"]
    assert "relaxation_sweeps" in result.effort
    assert result.provenance["program"].startswith("ringfilm")


def test_read_gives_back_what_was_written(result, folder):
    result.write("x.nc")
    again = ringfilm.Result.read("x.nc")
    numpy.testing.assert_array_equal(again.min_film_thickness, result.min_film_thickness)
    assert again.values == result.values
    again.write("y.nc")
    assert (folder / "y.nc").read_bytes() == (folder / "x.nc").read_bytes()


def test_what_is_not_a_result_is_refused(folder):
    with pytest.raises(ringfilm.InputError, match="not a NetCDF file"):
        ringfilm.Result.read("case.toml")
    with pytest.raises(ringfilm.InputError, match="no such file"):
        ringfilm.Result.read("nothing.nc")


def test_a_file_that_cannot_be_written_is_an_output_error(result, folder):
    with pytest.raises((ringfilm.OutputError, ringfilm.InputError)):
        result.write("no/such/folder/x.nc")


def test_pickles(result):
    again = pickle.loads(pickle.dumps(result, 0))
    for name in ("min_film_thickness", "friction_on_liner", "film_pressure"):
        numpy.testing.assert_array_equal(again[name], result[name])
    assert again.values == result.values


def test_a_result_with_one_changed_byte_is_refused(result, folder):
    result.write("x.nc")
    whole = (folder / "x.nc").read_bytes()
    of_digest = len(whole) - 17  # its highest bit makes text that is not UTF-8
    changes = [(at, 1 << at % 8) for at in range(7, len(whole), len(whole) // 200)] + [(of_digest, 128)]
    for at, bit in changes:
        (folder / "x.nc").write_bytes(whole[:at] + bytes([whole[at] ^ bit]) + whole[at + 1 :])
        with pytest.raises(ringfilm.InputError):
            ringfilm.Result.read("x.nc")


def test_xarray_is_what_xarray_reads_from_the_file(result, folder):
    xarray = pytest.importorskip("xarray")
    result.write("x.nc")
    with xarray.open_dataset("x.nc") as stored:
        made = result.to_xarray()
        assert dict(made.sizes) == dict(stored.sizes)
        assert set(made.variables) == set(stored.variables)
        assert set(made.coords) == set(stored.coords)
        xarray.testing.assert_identical(made, stored.load())
    assert made["min_film_thickness"].attrs["units"] == "m"
    assert float(made["min_film_thickness"].sel(crank_angle=20)) == result.min_film_thickness[20]


def test_xarray_does_not_copy_the_curves(result):
    pytest.importorskip("xarray")
    assert numpy.shares_memory(result.to_xarray()["power_loss"].values, result.power_loss)


def test_pandas(result):
    pytest.importorskip("pandas")
    frame = result.to_pandas()
    assert frame.index.name == "crank_angle" and len(frame) == 720
    numpy.testing.assert_array_equal(frame["total_friction"], result.total_friction)
    assert frame.attrs["units"]["total_friction"] == "N"
    named = result.to_pandas(units="columns")
    assert named.index.name == "crank_angle [degree]" and "total_friction [N]" in named.columns
    assert "lambda_ratio" in named.columns
    with pytest.raises(ValueError, match="neither"):
        result.to_pandas(units="rows")


def test_a_report_is_a_page(result, folder):
    result.write_report("x.html")
    assert (folder / "x.html").read_text().lstrip().lower().startswith("<!doctype html>")


def test_what_a_run_finds_out_beside_is_that_of_the_program(case, folder, run_program):
    case["solver.cells"] = 60
    (folder / "small.toml").write_text(case.resolved())
    words = ("--error-estimate", "--ledger", "--output", "program.nc")
    assert run_program("run", "small.toml", *words).returncode == 0
    result = ringfilm.Case.read("small.toml").run(error_estimate=True, ledger=True, threads=1)
    result.write("module.nc")
    assert (folder / "module.nc").read_bytes() == (folder / "program.nc").read_bytes()
    assert result["cycle_fmep_error"] > 0 and result["friction_on_liner_error"].shape == (720,)
    settings = {variant["setting"]: variant for entry in result.ledger for variant in entry["variants"]}
    assert settings['lubricant.viscosity_pressure = "none"']["values"]["fmep"] != result.fmep
    assert all(not variant["reason"] for variant in settings.values())
    assert {entry["topic"] for entry in result.ledger} < {topic for topic, *_ in result.assumptions}
    assert ringfilm.Result.read("program.nc").ledger == result.ledger


def test_a_run_that_only_runs_has_neither_ledger_nor_errors(result):
    assert result.ledger == []
    with pytest.raises(KeyError):
        result["cycle_fmep_error"]


def test_a_run_for_an_accuracy_has_errors_and_says_which_values_reach_it(case):
    case["solver.accuracy"] = "5 %"
    result = case.run()
    assert 0 < result["cycle_fmep_error"] < 0.05 * result.fmep
    assert any(note == "accuracy-reached" and "are within 5 %" in text for note, text, _ in result.notes)


def test_a_pad_has_neither_ledger_nor_errors(folder):
    pad = ringfilm.Case.read(PAD / "inclined_slider.toml")
    for wish in ("ledger", "error_estimate"):
        with pytest.raises(ringfilm.InputError, match=f"{wish} is for rings"):
            pad.run(**{wish: True})


def test_a_result_is_walked_like_a_dict(result):
    assert "fmep" in result and "min_film_thickness" in result and "film_pressure" in result
    assert "nothing" not in result and 3 not in result
    assert len(result) == len(result.keys()) and set(result) >= {"crank_angle", "cycle_fmep", "film_pressure"}
    assert all(result[name] is not None for name in result)


def test_a_file_name_with_a_null_byte_writes_nothing(result, folder):
    with pytest.raises(ringfilm.InputError, match="zero byte"):
        result.write("a\0b.nc")
    assert not (folder / "a").exists()


def test_the_version_is_that_of_the_program(result, run_program):
    assert run_program("--version").stdout.split()[1] == ringfilm.__version__
    assert result.provenance["program"] == f"ringfilm {ringfilm.__version__}"


def test_the_first_example_of_the_module_names_a_case_that_there_is():
    named = re.search(r'Case.read\("(.*)"\)', ringfilm.__doc__).group(1)
    assert (SOURCES / named).is_file()


def test_notebooks_show_the_values_that_decide(result):
    shown = result._repr_html_()
    assert "minimum film thickness [um]" in shown
    assert f"{1e6 * result.values['min_film_thickness']:.4g}" in shown
    assert "min_film_thickness" in result._ipython_key_completions_()


def test_the_cycle_is_tabled_around_firing_tdc(result):
    pytest.importorskip("xarray")
    table = result.to_xarray(angles="firing")
    angles = table.crank_angle.values
    assert (angles[0], angles[-1]) == (-360, 359) and (numpy.diff(angles) > 0).all()
    assert table.crank_angle.attrs["units"] == "degree"
    before = float(table.min_film_thickness.sel(crank_angle=-20))
    assert before == float(result.to_xarray().min_film_thickness.sel(crank_angle=700))
    assert float(table.film_pressure.sel(field_crank_angle=20).max()) > 0
    with pytest.raises(ValueError, match="neither"):
        result.to_xarray(angles="tdc")
