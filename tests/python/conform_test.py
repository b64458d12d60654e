"""The static closure of a ring: what `ringfilm conform` prints, as numbers and arrays."""

import numpy
import pytest

import ringfilm
from conftest import SOURCES

FOLLOWED = SOURCES / "cases" / "distorted-bore" / "followed.toml"


def test_a_path_and_a_case_give_the_same_record():
    closed = ringfilm.conform(FOLLOWED)
    of_case = ringfilm.conform(ringfilm.Case.read(str(FOLLOWED)))
    assert closed["max_clearance"] == of_case["max_clearance"] == pytest.approx(1.568e-6, rel=1e-3)
    assert closed["contact_arcs"] == of_case["contact_arcs"]
    assert closed["title"] == "Distorted bore that the ring follows"


def test_arrays_go_around_the_ring():
    closed = ringfilm.conform(FOLLOWED)
    assert closed["angle"].shape == closed["moment"].shape == (361,)
    assert closed["cumulative_force"][-1] == pytest.approx(2 * numpy.pi * closed["mean_wall_force"], rel=1e-12)
    assert closed["clearance"].min() > -1e-15
    ((first, last),) = closed["contact_arcs"]
    inside = (closed["angle"] > first) & (closed["angle"] < last)
    assert closed["clearance"][inside].max() == 0 and closed["line_force"][inside].min() > 0


def test_keys_of_the_bore_are_set_and_read():
    case = ringfilm.Case.read(str(FOLLOWED))
    case["liner.distortion"] = [{"order": 4, "amplitude": "8 um", "phase": "0 degree"}]
    assert case["liner.distortion"] == [{"order": 4, "amplitude": pytest.approx(8e-6), "phase": 0}]
    assert ringfilm.conform(case)["max_clearance"] == pytest.approx(1.79e-6, rel=1e-2)
    with pytest.raises(ringfilm.InputError, match="leave no bore"):
        case["liner.distortion"] = [{"order": 4, "amplitude": "60 mm", "phase": "0 degree"}]
        ringfilm.conform(case)
    with pytest.raises(TypeError):
        ringfilm.conform(5)


def test_a_measured_free_shape_gives_back_its_pressure(tmp_path):
    case = ringfilm.Case.read(str(FOLLOWED))
    case["ring.pressure_orders"] = [{"order": 2, "amplitude": 0.25, "phase": "20 degree"}]
    made_for = ringfilm.conform(case)
    assert made_for["pressure_orders"] == [(2, pytest.approx(0.25), pytest.approx(20))]
    rows = zip(made_for["free_angle"], 1e3 * made_for["free_radius"])
    (tmp_path / "free.csv").write_text("angle [degree],radius [mm]\n" + "".join(f"{a:.8f},{r:.8f}\n" for a, r in rows))
    case.update(
        {
            "ring.pressure_orders": None,
            "ring.elastic_pressure": None,
            "ring.free_shape": str(tmp_path / "free.csv"),
            "ring.free_shape_smoothing": "40 mm",
        }
    )
    found = ringfilm.conform(case)
    assert found["tangential_force"] == pytest.approx(made_for["tangential_force"], rel=1e-3)
    assert found["target_force"] == pytest.approx(made_for["target_force"], rel=1e-3)
    assert found["free_shape_residual"] < 1e-8 and found["force_deviation"] < 1e-4
    assert found["free_shape_orders"] == 6
