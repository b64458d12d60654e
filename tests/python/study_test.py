"""Studies in memory: the plan as numbers, the same values as the program's, statistics and indices."""

import csv
import math

import numpy
import pytest

import ringfilm

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
    told = []
    result = study.run(progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (16, 16)
    with open(folder / "out" / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["fmep [Pa]"]) for row in rows] == list(result["fmep"])
    assert [float(row["factor_speed [rad/s]"]) for row in rows] == list(study.points[:, 0])
    assert result.unsolved == {}


def test_statistics_are_those_of_numpy(study):
    result = study.run()
    told = result.statistics("fmep")
    assert told["mean"] == pytest.approx(result["fmep"].mean(), rel=1e-12)
    assert told["deviation"] == pytest.approx(result["fmep"].std(ddof=1), rel=1e-12)
    assert told["quantiles"][0.5] == pytest.approx(numpy.quantile(result["fmep"], 0.5, method="median_unbiased"), rel=1e-12)
    with pytest.raises(ringfilm.InputError, match="no points for Sobol indices"):
        result.sobol_indices("fmep")
    with pytest.raises(ringfilm.InputError, match="no value of a cycle"):
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
    (folder / "study.toml").write_text(STUDY + '[keep]\ncurves = "all"\nquantities = ["min_film_thickness", "power_loss"]\n')
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


def test_a_plan_with_until_goes_on_as_in_the_program(folder, run_program):
    until = 'scenarios = 8\nuntil = { value = "fmep", width = "2.5 kPa", most = 64 }\n'
    (folder / "until.toml").write_text(STUDY.replace("scenarios = 16\n", until))
    study = ringfilm.Study.read("until.toml")
    told = []
    result = study.run(progress=lambda done, total: told.append((done, total)))
    assert len(study) == 8 < len(result) == len(result.study) < 64, "it looks after 8, 16, 32 and 64 points"
    assert {total for _, total in told} >= {8, len(result)} and told[-1] == (len(result), len(result))
    assert run_program("study", "until.toml", "-o", "out").returncode == 0
    with open(folder / "out" / "study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["fmep [Pa]"]) for row in rows] == list(result["fmep"])
    assert result.to_pandas().shape[0] == len(result)
