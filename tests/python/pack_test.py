"""Ring packs: cases with several rings and their results."""

import pickle

import numpy
import pytest
from conftest import SOURCES

import ringfilm

FACE = 'face = { form = "parabola", crown_height = "15 um" }\n'
CASE = (
    """
title = "pack"
[engine]
bore = "89 mm"
stroke = "79.5 mm"
connecting_rod_length = "138.1 mm"
[operating]
speed = "1500 rpm"
[thermal]
ring = "190 degC"
liner = [["0 mm", "180 degC"], ["79.5 mm", "110 degC"]]
[gas]
model = "wiebe"
[contact]
asperity_density = "0.097 um-2"
asperity_radius = "1.56 um"
roughness = "0.48 um"
boundary_shear_strength_coefficient = 0.3581
[lubricant]
file = "data/lubricants/styles2014.toml"
[solver]
cells = 40
crank_step = "4 degree"
[output]
crank_angles = "4 degree"
fields = ["20 degree"]
[[ring]]
face_width = "1.2 mm"
elastic_pressure = "0.2 MPa"
pressure_below = "2.5 bar"
"""
    + FACE
    + """
[[ring]]
face_width = "1.5 mm"
elastic_pressure = "0.15 MPa"
contact = { roughness = "0.6 um" }
"""
    + FACE
)


@pytest.fixture
def pack(tmp_path):
    path = tmp_path / "pack.toml"
    path.write_text(CASE)
    return ringfilm.Case.read(path)


def test_rings_are_cases_and_give_their_bits(pack, tmp_path):
    result = pack.run()
    assert len(pack.rings) == len(result.rings) == 2
    for case, ring in zip(pack.rings, result.rings, strict=True):
        alone = case.run()
        for quantity in ringfilm.quantities()["curve"]:
            numpy.testing.assert_array_equal(ring[quantity.name], alone[quantity.name], quantity.name)
    assert result["min_film_thickness"].shape == (2, 180)
    assert result["fmep"].shape == (2,)
    assert result.values["fmep"] == pytest.approx(result["fmep"].sum())
    assert "film_temperature" in result.rings[0].keys()


def test_a_file_gives_it_back(pack, tmp_path):
    result = pack.run()
    result.write(tmp_path / "pack.nc")
    read = ringfilm.Result.read(tmp_path / "pack.nc")
    assert isinstance(read, ringfilm.PackResult)
    assert read.to_json() == result.to_json()
    for a, b in zip(read.rings, result.rings, strict=True):
        assert a.notes == b.notes and a.inputs == b.inputs and a.effort == b.effort
        numpy.testing.assert_array_equal(a["film_pressure"], b["film_pressure"])
    assert pickle.loads(pickle.dumps(result)).to_json() == result.to_json()


def test_xarray_opens_the_file_with_the_dimension_ring(pack, tmp_path):
    xarray = pytest.importorskip("xarray")
    result = pack.run()
    result.write(tmp_path / "pack.nc")
    with xarray.open_dataset(tmp_path / "pack.nc") as read:
        assert read.min_film_thickness.dims == ("ring", "crank_angle")
        assert read.sel(ring=2).cycle_fmep == result.rings[1].fmep
        xarray.testing.assert_identical(read.min_film_thickness, result.to_xarray().min_film_thickness)


def test_the_resolved_case_is_the_same_pack(pack, tmp_path):
    path = tmp_path / "again.toml"
    path.write_text(pack.resolved())
    again = ringfilm.Case.read(path)
    for a, b in zip(again.run().rings, pack.run().rings, strict=True):
        assert a.values == b.values
        numpy.testing.assert_array_equal(a.min_film_thickness, b.min_film_thickness)


def test_keys_of_one_ring_have_its_number(pack):
    assert pack["ring.2.face_width"] == pytest.approx(1.5e-3)
    assert pack["ring.2.contact.roughness"] == pytest.approx(0.6e-6)
    pack["ring.2.face_width"] = "2 mm"
    pack["operating.speed"] = "3000 rpm"
    assert [ring["ring.face_width"] for ring in pack.rings] == pytest.approx([1.2e-3, 2e-3])
    assert {ring["operating.speed"] for ring in pack.rings} == {pack["operating.speed"]}
    pack["ring.1.pressure_below"] = "4 bar"
    assert pack.rings[1]["ring.pressure_above"] == pytest.approx(4e5)
    with pytest.raises(ringfilm.UnknownKeyError, match="ring.1.face_width"):
        pack["ring.face_width"]
    with pytest.raises(ringfilm.UnknownKeyError):
        pack["ring.3.face_width"] = "1 mm"
    assert pickle.loads(pickle.dumps(pack)) == pack


def test_many_at_once_are_cases_of_one_ring(pack):
    refused, solved = ringfilm.simulate_many([pack, pack.rings[0]])
    assert "one ring" in refused.reason
    assert solved.reason == ""


def test_friction_by_ring_adds_up_to_that_of_the_pack(pack):
    result = pack.run()
    assert [one["ring"] for one in result.by_ring] == [1, 2]
    assert sum(one["fmep"] for one in result.by_ring) == pytest.approx(result.values["fmep"])
    assert result.gas is None
    assert result.oil is None


def test_coupled_pack_has_its_gas_and_its_oil(tmp_path):
    case = ringfilm.Case.read(SOURCES / "cases" / "ring-pack" / "three_rings.toml")
    case["solver.cells"] = 50
    result = case.run()
    assert result.gas["blow_by_per_cycle"] > 1e-6
    assert 0 < result.oil["oil_to_chamber_upper_bound"] < 1e-4
    for name in ("blow_by_per_cycle", "blow_by_flow"):
        assert result.gas[name] == result[name], name
    assert result.gas["units"]["blow_by_flow"] == "m3/s"
    first = result.gas["ring_motion"][0]
    assert first["least_seating_force"] == result["gas_ring_least_seating_force"][0]
    assert first["largest_static_twist"] == result["gas_ring_largest_static_twist"][0]
    for path, forward in zip(result.gas["paths"], result["gas_path_mass_forward_per_cycle"], strict=True):
        assert path["mass_forward_per_cycle"] == forward
    assert result["gas_region_pressure"].shape == (720, len(result.gas["regions"]))
    gas = result.gas
    assert isinstance(gas, ringfilm.GasPathResult) and gas.values["blow_by_flow"] == result["blow_by_flow"]
    numpy.testing.assert_array_equal(gas.pressure["land 2"], result["gas_region_pressure"][:, 2])
    assert gas.to_pandas()["flow_end_gap_1"].size == 720 and "land 2" in gas._repr_html_()
    with pytest.raises(ValueError, match="write_report of the PackResult"):
        gas.write_report(tmp_path / "gas.html")
    assert len(result.rings) == 4
    assert len(result.by_ring) == 3
    # Written out, the rails are rings of their own, with the same bits.
    resolved = tmp_path / "resolved.toml"
    resolved.write_text(result.resolved_case)
    again = ringfilm.Case.read(resolved).run()
    assert [ring["fmep"] for ring in again.rings] == [ring["fmep"] for ring in result.rings]
    assert again.gas["blow_by_per_cycle"] == result.gas["blow_by_per_cycle"]


def test_a_pack_has_the_words_of_a_result(pack):
    result = pack.run()
    assert result.units == {name: result.rings[0].units[name] for name in result.values}
    assert set(result.rings[0].units) == set(result.rings[0].values)
    notes = [
        (topic, f"ring {i + 1}: {message}", n)
        for i, ring in enumerate(result.rings)
        for topic, message, n in ring.notes
    ]
    assert [note for note in result.notes if note[0] != "input"] == [note for note in notes if note[0] != "input"]
    assert result.provenance == result.rings[0].provenance
    assert "ring.2.face_width" in {key for key, *_ in result.inputs}
    assert "fmep" in result and "cycle_fmep" in result.keys() and "rate" not in result
    with pytest.raises(KeyError, match="did you mean min_film_thickness"):
        result["min_film_thicknes"]


@pytest.mark.parametrize("what", ["overview", "film", "friction", "power_loss", "stribeck"])
def test_a_pack_is_drawn_with_a_line_for_each_ring(pack, what):
    pytest.importorskip("matplotlib").use("Agg")
    result = pack.run()
    figure = result.plot(what)
    for axes in figure.axes:
        assert [text.get_text() for text in axes.get_legend().get_texts()] == ["ring 1", "ring 2"]
    axes = figure.axes[0]
    if len(figure.axes) == 1:
        assert result.plot(what, axes=axes, label="again") is figure
    else:
        with pytest.raises(ValueError, match="several panels"):
            result.plot(what, axes=axes)
    with pytest.raises(ValueError, match="field of one ring"):
        result.plot("film_pressure")


def test_the_oil_of_a_pack_settles_before_its_cycles():
    """What the oil ring scrapes off does not matter: the friction of a pack is the same within 0.2 %, as required.

    With crowned rails. Flat ones, half full of oil, let it scatter by 0.4 % between 1 and 6 um.
    """
    case = ringfilm.Case.read(SOURCES / "cases" / "ring-pack" / "three_rings.toml")
    case.update({"ring.3.face.crown_height": "2 um", "ring.3.film.land_lift": "none", "ring.3.film.land_law": None})
    found = []
    for film in ["2 um", "10 um"]:
        case["supply.film"] = film
        pack = case.run()
        assert all(ring.effort["cycles_integrated"] <= 5 for ring in pack.rings)
        found.append(pack.values["fmep"])
    assert found[0] == pytest.approx(found[1], rel=2e-3)


def test_a_pack_has_its_sums_a_table_and_what_a_notebook_shows(pack):
    pandas = pytest.importorskip("pandas")
    result = pack.run()
    assert result.fmep == result.values["fmep"]
    table = result.to_pandas()
    assert isinstance(table, pandas.DataFrame) and len(table) == 2
    assert table["fmep"].sum() == pytest.approx(result.fmep)
    assert table.attrs["units"]["fmep"] == "Pa"
    assert "ring 2" in result._repr_html_()
