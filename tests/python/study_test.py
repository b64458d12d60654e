"""Studies in memory: the plan as numbers, the same values as the program's, statistics and indices."""

import csv
import math
import re

import numpy
import pytest

import ringfilm

from conftest import SOURCES

STUDY = """\
title = "a small study"
kind = "uncertainty"
seed = 5
[[base]]
name = "new"
case = "case.toml"
[[factor]]
name = "speed"
key = "operating.speed"
range = ["1000 rpm", "3000 rpm"]
[[factor]]
name = "roughness"
key = "contact.roughness"
how = "scale"
distribution = "normal"
mean = 1.0
deviation = 0.1
truncate = [0.5, 1.5]
[plan]
method = "sobol"
scenarios = 16
"""


@pytest.fixture
def study(folder):
    (folder / "study.toml").write_text(STUDY)
    return ringfilm.Study.read("study.toml")


def test_the_plan_as_numbers(study):
    assert len(study) == 16 and study.bases == ["new"]
    assert [factor["variable"] for factor in study.factors] == ["factor_speed", "factor_roughness"]
    points = study.points
    assert points.shape == (16, 2)
    rpm = math.pi / 30
    assert ((1000 * rpm <= points[:, 0]) & (points[:, 0] <= 3000 * rpm)).all()


def test_the_values_are_those_of_the_program(study, folder, run_program):
    assert run_program("study", "study.toml", "-o", "out").returncode == 0
    reported = []
    result = study.run(progress=lambda done, total: reported.append((done, total)))
    assert reported[-1] == (16, 16)
    with open(folder / "out" / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["fmep [Pa]"]) for row in rows] == list(result["fmep"])
    assert [float(row["factor_speed [rad/s]"]) for row in rows] == list(study.points[:, 0])
    assert result.unsolved == {}


def test_the_accuracy_is_estimated_on_a_sample(study, folder):
    assert study.run().accuracy is None  # its cells are stated
    (folder / "study.toml").write_text(STUDY + "[accuracy]\nsample = 3\n")
    accuracy = ringfilm.Study.read("study.toml").run().accuracy
    assert len(accuracy["scenarios"]) == 3 and accuracy["asked"] == [] and accuracy["coverage"] is None
    assert 0 < accuracy["relative_error"]["fmep"] < 0.1
    assert "min_film_thickness_angle" not in accuracy["relative_error"]


def test_statistics_are_those_of_numpy(study):
    result = study.run()
    reported = result.statistics("fmep")
    assert reported["mean"] == pytest.approx(result["fmep"].mean(), rel=1e-12)
    assert reported["deviation"] == pytest.approx(result["fmep"].std(ddof=1), rel=1e-12)
    assert reported["quantiles"][0.5] == pytest.approx(
        numpy.quantile(result["fmep"], 0.5, method="median_unbiased"), rel=1e-12
    )
    with pytest.raises(ringfilm.InputError, match="no points for Sobol indices"):
        result.sobol_indices("fmep")
    with pytest.raises(ringfilm.UnknownKeyError, match="not a value of this study"):
        result["nothing"]


def test_indices(folder):
    (folder / "study.toml").write_text(STUDY + 'indices = "first-and-total"\n')
    result = ringfilm.Study.read("study.toml").run()
    rows = result.sobol_indices("fmep")
    assert [row["factor"] for row in rows] == ["speed", "roughness"]
    assert all(row["total_interval"][0] <= row["total"] <= row["total_interval"][1] for row in rows)
    # The shares of two factors that hardly interact are nearly the whole.
    assert 0.5 < sum(row["total"] for row in rows) < 1.5


def test_tables(study):
    pytest.importorskip("xarray")
    result = study.run()
    data = result.to_xarray()
    assert data["fmep"].dims == ("scenario",) and data["fmep"].attrs["units"] == "Pa"
    assert set(data.coords) >= {"base", "factor_speed", "factor_roughness"}
    frame = result.to_pandas()
    assert list(frame["fmep"]) == list(data["fmep"].values) and len(frame) == 16
    assert study.to_pandas().shape == (16, 3)


def test_curves_of_all_scenarios(folder):
    (folder / "study.toml").write_text(
        STUDY + '[keep]\ncurves = "all"\nquantities = ["min_film_thickness", "power_loss"]\n'
    )
    study = ringfilm.Study.read("study.toml")
    result = study.run()
    curves = result.curves("power_loss")
    assert curves.shape == (16, result.crank_angle.size) and result.crank_angle[0] == -360
    # The mean of a curve at steps of 2 degree is that of the cycle but for what lies between them.
    numpy.testing.assert_allclose(curves.mean(axis=1), result["mean_power_loss"], rtol=1e-2)
    with pytest.raises(ringfilm.InputError, match="keeps no curves"):
        result.curves("total_friction")


def test_a_bad_study_is_refused(folder):
    (folder / "study.toml").write_text(STUDY.replace("operating.speed", "operating.sped"))
    with pytest.raises(ringfilm.InputError, match="operating.sped"):
        ringfilm.Study.read("study.toml")


def test_a_study_of_a_dict_is_that_of_the_file(study, folder):
    factors = [
        {"name": "speed", "key": "operating.speed", "range": ["1000 rpm", "3000 rpm"]},
        {"name": "roughness", "key": "contact.roughness", "how": "scale", "distribution": "normal"},
    ]
    factors[1].update(mean=1.0, deviation=0.1, truncate=numpy.array([0.5, 1.5]))
    same = ringfilm.Study(
        {
            "title": "a small study",
            "kind": "uncertainty",
            "seed": 5,
            "base": [{"name": "new", "case": folder / "case.toml"}],
            "factor": factors,
            "plan": {"method": "sobol", "scenarios": 16},
        }
    )
    assert repr(same) == repr(study) == repr(ringfilm.Study("study.toml"))
    numpy.testing.assert_array_equal(same.points, study.points)
    assert list(same.run()["fmep"]) == list(study.run()["fmep"])


def test_files_of_a_dict_are_relative_to_the_working_folder(folder, monkeypatch):
    values = {"operating.speed": "1000 rpm"}
    plan = {"plan": {"method": "operating-points"}, "point": [{"name": "idle", "weight": 1, "values": values}]}
    study = ringfilm.Study({"kind": "compare", "base": [{"case": "case.toml"}], **plan})
    assert study.bases == ["case"] and len(study) == 1
    assert sorted(path.name for path in folder.iterdir()) == ["case.toml", "trace.csv"]
    with pytest.raises(ringfilm.InputError, match="there is no such file"):
        ringfilm.Study({"base": [{"case": "nothing.toml"}], **plan})
    with pytest.raises(TypeError, match="must be a text, a number, a list or a dict"):
        ringfilm.Study({"base": [{"case": ringfilm.Case.read("case.toml")}], **plan})


def test_a_study_in_a_notebook_and_with_units_in_its_columns(study):
    pytest.importorskip("pandas")
    result = study.run()
    assert "factor_speed" in study._repr_html_() and "fmep" in result._repr_html_()
    assert "factor_speed [rad/s]" in study.to_pandas(units="columns").columns
    assert {"factor_speed [rad/s]", "factor_roughness", "fmep [Pa]"} <= set(result.to_pandas(units="columns").columns)


def test_a_plan_with_until_continues_as_in_the_program(folder, run_program):
    until = 'scenarios = 8\nuntil = { value = "fmep", width = "2.5 kPa", most = 64 }\n'
    (folder / "until.toml").write_text(STUDY.replace("scenarios = 16\n", until))
    study = ringfilm.Study.read("until.toml")
    reported = []
    result = study.run(progress=lambda done, total: reported.append((done, total)))
    assert len(study) == 8 < len(result) == len(result.study) < 64, "it looks after 8, 16, 32 and 64 points"
    assert {total for _, total in reported} >= {8, len(result)} and reported[-1] == (len(result), len(result))
    assert run_program("study", "until.toml", "-o", "out").returncode == 0
    with open(folder / "out" / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["fmep [Pa]"]) for row in rows] == list(result["fmep"])
    assert result.to_pandas().shape[0] == len(result)


def test_the_dataset_has_what_the_file_of_the_program_has(folder, run_program):
    xarray = pytest.importorskip("xarray")
    factor = '[[factor]]\nname = "cavity"\nkey = "film.cavitation"\nvalues = ["mass-conserving", "reynolds-exit"]\n'
    text = STUDY[: STUDY.index("[[factor]]")] + factor + '[plan]\nmethod = "grid"\n[keep]\ncurves = "all"\n'
    (folder / "study.toml").write_text(text.replace('kind = "uncertainty"', 'kind = "compare"'))
    assert run_program("study", "study.toml", "-o", "out").returncode == 0
    made = ringfilm.Study.read("study.toml").run().to_xarray()
    with xarray.open_dataset(folder / "out" / "study.nc") as stored:
        elsewhere = {"base", "factor_cavity"}  # a number there, the words themselves here
        common = [name for name in made.variables if name in stored.variables and name not in elsewhere]
        assert {"fmep", "solved", "crank_angle", "ring", "curve_min_film_thickness"} < set(common)
        for name in common:
            assert made[name].dims == stored[name].dims and made[name].dtype == stored[name].dtype
            assert made[name].attrs == stored[name].attrs, name
            numpy.testing.assert_array_equal(made[name], stored[name])
        assert made["factor_cavity"].attrs == stored["factor_cavity"].attrs
        choices = stored["factor_cavity_choice"].values[stored["factor_cavity"].values.astype(int)]
        assert list(made["factor_cavity"].values) == list(choices) == ["mass-conserving", "reynolds-exit"]
        assert list(made["base"].values) == list(stored["base_name"].values[stored["base"].values])
    assert made.attrs["program"] == stored.attrs["program"]
    assert list(ringfilm.Study.read("study.toml").to_pandas()["factor_cavity"]) == ["mass-conserving", "reynolds-exit"]


@pytest.fixture
def batch(case):
    """Four cases, of which the third is not solved."""
    cases = [case.copy() for _ in range(4)]
    for rpm, one in zip((1000, 2000, 2500, 3000), cases):
        one["operating.speed"] = f"{rpm} rpm"
    for key, text in (
        ("contact.asperity_density", "1e-6 um-2"),
        ("contact.roughness", "0.01 um"),
        ("ring.elastic_pressure", "60 MPa"),
        ("ring.face.crown_height", "200 um"),
        ("ring.face.apex", 0.0),
    ):
        cases[2][key] = text
    cases[3]["output.crank_angles"] = [0.0, 20.0]
    batch = ringfilm.simulate_many(cases)
    assert list(batch.unsolved) == [2]
    return batch


def test_a_batch_takes_what_numpy_takes(batch):
    fmep = batch["fmep"]
    assert fmep.shape == (4,) and fmep.dtype == float and fmep[1] == batch[1].fmep and numpy.isnan(fmep[2])
    assert list(batch["cycle_min_film_thickness"][:2]) == list(batch["min_film_thickness"][:2])
    assert batch["min_film_thickness"][1] == batch[1].cycle_min_film_thickness
    assert list(batch["reason"]) == [result.reason for result in batch]
    solved = batch[numpy.isfinite(fmep)]
    assert len(solved) == 3 and solved[2] is batch[3] and not solved.unsolved
    assert [one is other for one, other in zip(batch[[3, -4]], (batch[3], batch[0]))] == [True, True]
    assert len(batch[[]]) == 0 and batch[numpy.int64(1)] is batch[1] and len(batch[1:3]) == 2
    for wrong in ([0, 9], [True], [0.5], [[0]]):
        with pytest.raises(IndexError):
            batch[wrong]
    with pytest.raises(KeyError, match="did you mean fmep"):
        batch["fmepp"]


def test_a_batch_as_a_dataset(batch):
    pytest.importorskip("xarray")
    data = batch.to_xarray()
    assert data["fmep"].dims == ("case",) and data["fmep"].attrs["units"] == "Pa"
    numpy.testing.assert_array_equal(data["fmep"], batch["fmep"])
    numpy.testing.assert_array_equal(data["cycle_min_film_thickness"], batch["min_film_thickness"])
    curve = data["min_film_thickness"]
    assert curve.dims == ("case", "crank_angle") and curve.attrs["long_name"] == "minimum film thickness"
    numpy.testing.assert_array_equal(curve[1], batch[1].min_film_thickness)
    assert float(curve.sel(case=3, crank_angle=20)) == batch[3].min_film_thickness[1]
    assert numpy.isfinite(curve[3]).sum() == 2 and numpy.isnan(curve[2]).all()
    assert list(data["solved"].values) == [1, 1, 0, 1] and str(data["reason"][2].values) == batch[2].reason
    assert set(batch.to_xarray(["power_loss"]).data_vars) - set(batch[:0].to_xarray().data_vars) == {"power_loss"}
    with pytest.raises(KeyError, match="no curve nothing"):
        batch.to_xarray(["nothing"])


def test_a_batch_without_curves_and_one_without_cases(case):
    pandas = pytest.importorskip("pandas")
    data = ringfilm.simulate_many([case], curves="none").to_xarray()
    assert "crank_angle" not in data.dims and data["fmep"].shape == (1,)
    frame = ringfilm.simulate_many([]).to_pandas()
    assert len(frame) == 0 and set(frame.drop(columns="reason").dtypes) == {numpy.dtype(float)}
    assert list(frame.columns) == list(ringfilm.simulate_many([case]).to_pandas().columns)
    assert pandas.api.types.is_object_dtype(frame["reason"])
    named = ringfilm.simulate_many([case]).to_pandas(units="columns")
    assert "fmep [Pa]" in named.columns and "min_lambda_ratio" in named.columns


def test_the_notes_of_results_are_kept_with_their_scenarios(study, folder, run_program):
    result = study.run()
    order = ringfilm.note_topics()
    assert result.notes and list(result.notes) == sorted(result.notes, key=order.index)
    rows = [set() for _ in range(len(result))]
    for topic, (message, scenarios) in result.notes.items():
        assert message and scenarios == sorted(set(scenarios))
        for i in scenarios:
            rows[i].add(topic)
    alone = ringfilm.Case.read("case.toml")
    alone["operating.speed"] = f"{study.points[3, 0]!r} rad/s"
    alone["contact.roughness"] = f"{alone['contact.roughness'] * study.points[3, 1]!r} m"
    assert rows[3] == {topic for topic, _, _ in alone.run().notes}
    printed = run_program("study", "study.toml", "-o", "out").stdout
    for topic, (message, scenarios) in result.notes.items():
        line = re.escape(f"{len(scenarios)} of 16  {topic}: {message} ")
        shown = re.search(line + r"\((worst|first): scenario (\d+)\)", printed)
        assert shown and int(shown[2]) in scenarios
        assert shown[1] == "worst" or int(shown[2]) == scenarios[0]
    with open(folder / "out" / "study.csv", newline="") as file:
        assert [set(filter(None, row["notes"].split("; "))) for row in csv.DictReader(file)] == rows
    pytest.importorskip("xarray")
    data = result.to_xarray()
    for topic, (_, scenarios) in result.notes.items():
        assert list(numpy.flatnonzero(data.has_note.sel(note_topic=topic))) == scenarios


def test_a_factor_that_changes_no_value_is_noted(folder, run_program):
    text = STUDY[: STUDY.index("[[factor]]")] + '[plan]\nmethod = "grid"\n[[factor]]\nkey = "operating.speed"\n'
    text += 'values = ["1000 rpm", "2000 rpm"]\n[[factor]]\nname = "zero"\nkey = "ring.face.height_zero"\n'
    (folder / "study.toml").write_text(text + 'values = ["minimum", "as-given"]\n')
    notes = ringfilm.Study.read("study.toml").run().plan_notes
    about_pressure, unused, *flat = notes
    assert "the cylinder pressure stays the same" in about_pressure
    assert unused.startswith('factor "zero" changes no value of the cycle')
    printed = run_program("study", "study.toml", "-o", "out").stdout
    for note in (unused, *flat):
        assert "note: " + note in printed


def test_a_column_that_is_chosen_gives_the_pressures_of_its_own(folder):
    lines = (folder / "trace.csv").read_text().splitlines()
    rows = [line + f",{float(line.split(',')[1]) * 2:.6f}" for line in lines[1:]]
    (folder / "trace.csv").write_text("\n".join(["crank_angle [degree],low [bar],high [bar]", *rows]) + "\n")
    case = (folder / "case.toml").read_text()
    (folder / "case.toml").write_text(case.replace("[gas]", '[gas]\npressure_column = "low"'))
    factor = '[[factor]]\nkey = "gas.pressure_column"\nvalues = ["low", "high"]\n[plan]\nmethod = "grid"\n'
    (folder / "study.toml").write_text(STUDY[: STUDY.index("[[factor]]")] + factor)
    result = ringfilm.Study.read("study.toml").run()
    cases = [ringfilm.Case.read("case.toml") for _ in range(2)]
    cases[1]["gas.pressure_column"] = "high"
    batch = ringfilm.simulate_many(cases)
    assert list(result["peak_gas_pressure"]) == list(batch["peak_gas_pressure"])
    assert result["peak_gas_pressure"][1] > 1.9 * result["peak_gas_pressure"][0]
    assert {topic: cases for topic, (_, cases) in batch.notes.items()} == {
        topic: scenarios for topic, (_, scenarios) in result.notes.items()
    }


def test_a_study_of_a_ring_pack_has_the_values_of_its_gas():
    study = ringfilm.Study.read(SOURCES / "cases" / "studies" / "blow_by_map.toml")
    names = [value.name for value in study.values]
    assert {"blow_by_flow", "land_2_peak_pressure"} <= set(names) and "fmep" not in names
    result = study.run()
    assert (result["blow_by_flow"] > 0).all()
    frame = result.to_pandas()
    assert frame.attrs["units"]["land_2_peak_pressure"] == "Pa"
    # More load, more pressure on the second land, at each speed.
    by_load = frame.groupby("factor_peak_cylinder_pressure")["land_2_peak_pressure"].mean()
    assert by_load.is_monotonic_increasing
