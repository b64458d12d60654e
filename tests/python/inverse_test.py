"""Fits and optimisations from Python: what the program prints, as dicts."""

import pytest

import ringfilm
from conftest import SOURCES

SHIPPED = SOURCES / "cases" / "inverse"


def test_fit_recovers_the_hidden_viscosity(tmp_path):
    points = tmp_path / "points.jsonl"
    found = ringfilm.fit(SHIPPED / "fit_slider.toml", threads=1, points=points)
    viscosity = found["parameters"][0]
    assert viscosity["key"] == "lubricant.viscosity" and viscosity["identified"]
    assert viscosity["value"] == pytest.approx(0.013, rel=0.1)  # some times its interval
    again = ringfilm.fit(SHIPPED / "fit_slider.toml", points=points)
    assert again["cases_computed"] == 0
    assert again["parameters"] == found["parameters"]


def test_optimise_finds_rayleighs_step():
    best = ringfilm.optimise(SHIPPED / "rayleigh_step.toml")["best"]
    assert best["quantities"]["load"] == pytest.approx(20627, abs=1)  # 0.20627 eta U L^2/h0^2


def test_faults_are_input_errors(tmp_path):
    with pytest.raises(ringfilm.InputError, match="this file is an optimisation, not a fit|has no"):
        ringfilm.fit(SHIPPED / "rayleigh_step.toml")
