"""The gas between the rings of a pack from Python."""

import json
import pathlib

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
