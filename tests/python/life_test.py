"""Lives of rings from Python: what `ringfilm life --json` prints, as dicts."""

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
