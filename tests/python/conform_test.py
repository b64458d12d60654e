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
