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


FLOODED = ("mean_boundary_power", "fmep", "min_film_thickness", "mean_viscous_power", "mean_absolute_oil_flow")


def test_gradients_are_those_of_richardson_and_of_what_is_proportional(case):
    key = "contact.boundary_shear_strength_coefficient"
    case["solver.crank_step"] = "2 degree"
    gradient = case.gradient([key, "ring.face_width", "operating.speed"])
    still = case.copy({"solver.crank_step_control": "fixed", "solver.tolerance": 1e-12})
    boundary = still.run().values["mean_boundary_power"]
    derivative, error = gradient["mean_boundary_power"][key]
    # Boundary friction is tau_0 A + zeta W: its derivative is the load over speed, the same at each coefficient.
    assert derivative == pytest.approx(case.copy({key: 0.2}).gradient([key])["mean_boundary_power"][key][0], rel=1e-7)
    assert 0.9 < derivative * case[key] / boundary <= 1
    assert error < 1e-5 * abs(derivative)
    for name in FLOODED:
        for of in ("ring.face_width", "operating.speed"):
            steps = [0.004 * case[of], 0.002 * case[of]]
            differences = []
            for step in steps:
                at = [still.copy({of: ringfilm.SI(case[of] + sign * step)}).run().values[name] for sign in (-1, 1)]
                differences.append((at[1] - at[0]) / (2 * step))
            limit = differences[1] + (differences[1] - differences[0]) / 3
            assert gradient[name][of][0] == pytest.approx(limit, rel=1e-5), (name, of)


def test_a_gradient_by_what_is_no_number_is_refused(case):
    for key in ("film.cavitation", "title", "solver.cells"):
        with pytest.raises(ringfilm.InputError, match="no gradient with respect to"):
            case.gradient([key])
    with pytest.raises(ringfilm.UnknownKeyError):
        case.gradient(["ring.with"])
