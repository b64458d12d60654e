"""Cases: read, changed key by key, refused in the words of the program, copied, compared, pickled."""

import copy
import pickle
import subprocess
import sys
import tomllib

import numpy
import pytest

import ringfilm
from conftest import SOURCES


def test_values_are_in_si(case):
    assert case["engine.bore"] == 0.089
    assert case["operating.speed"] == pytest.approx(157.07963267948966, rel=1e-15)
    assert case["gas.model"] == "trace"
    assert case["solver.cells"] == 60
    assert case["lubricant.kinematic_viscosity"] == [(313.15, 59.99e-6), (373.15, 9.59e-6)]
    assert case["ring.tangential_force"] is None


def test_a_unit_string_and_a_number_in_si_state_the_same(case):
    other = case.copy()
    case["operating.oil_temperature"] = "100 degC"
    other["operating.oil_temperature"] = ringfilm.SI(373.15)
    assert case["operating.oil_temperature"] == other["operating.oil_temperature"] == 373.15
    assert case == other
    assert case.text("operating.oil_temperature") == '"100 degC"'


@pytest.mark.parametrize(
    "value", [numpy.float64(200.0), numpy.float32(200.0), numpy.int64(200), 200, 200.0, numpy.array(200.0)]
)
def test_any_number_of_numpy_is_a_number(case, value):
    case["operating.speed"] = ringfilm.SI(value)
    assert case["operating.speed"] == 200.0
    case["pad.speed"] = value  # [m/s], which everybody writes
    assert case["pad.speed"] == 200.0


def test_a_key_that_does_not_exist_is_a_key_error_and_the_nearest_is_reported(case):
    with pytest.raises(KeyError) as refused:
        case["engine.bor"]
    assert isinstance(refused.value, ringfilm.InputError)
    assert str(refused.value) == "unknown key engine.bor; did you mean engine.bore?"
    assert refused.value.faults[0].message == str(refused.value)
    for act in (
        lambda: case.__delitem__("engine.bor"),
        lambda: case.__setitem__("engine.bor", 1.0),
        lambda: case.text("x"),
    ):
        with pytest.raises(ringfilm.UnknownKeyError):
            act()
    copied = pickle.loads(pickle.dumps(refused.value))
    assert isinstance(copied, ringfilm.UnknownKeyError) and str(copied) == str(refused.value)


def test_lists_and_pairs(case):
    case["lubricant.kinematic_viscosity"] = ringfilm.SI(numpy.array([[313.15, 60e-6], [373.15, 9e-6]]))
    assert case["lubricant.kinematic_viscosity"] == [(313.15, 60e-6), (373.15, 9e-6)]
    case["lubricant.kinematic_viscosity"] = [("40 degC", ringfilm.SI(60e-6)), (ringfilm.SI(373.15), "9 mm2/s")]
    assert case["lubricant.kinematic_viscosity"] == [(313.15, 60e-6), (373.15, 9e-6)]
    case["output.crank_angles"] = [0, 10.5, -30]
    assert case["output.crank_angles"] == [0.0, 10.5, 690.0]
    case["output.crank_angles"] = "2 degree"
    assert case["output.crank_angles"] == 2.0
    case["output.fields"] = ["0 degree", 20]
    assert case["output.fields"] == [0.0, 20.0]


@pytest.mark.parametrize(
    "key, value, words",
    [
        ("operating.speed", "2000", ["operating.speed", "no unit"]),
        ("operating.speed", "2000 mm", ["operating.speed", "measures something else"]),
        ("operating.speed", ringfilm.SI(-3.0), ["out of range"]),
        ("operating.speed", 2000, ["speed = 2000 has no unit", '"1500 rpm"', "rad/s is written ringfilm.SI(2000)"]),
        ("operating.speed", numpy.float32(200), ["no unit", "ringfilm.SI(200)"]),
        ("engine.bore", 0.089, ["engine.bore = 0.089 has no unit", '"89.0 mm"', "m is written ringfilm.SI(0.089)"]),
        ("ring.face.length_unit", 1e-3, ["no unit"]),
        ("gas.crankcase_pressure", 1e5, ["no unit"]),
        ("lubricant.kinematic_viscosity", [(313.15, "60 mm2/s")], ["313.15 has no unit", "40 degC"]),
        ("lubricant.kinematic_viscosity", [("40 degC", 60e-6)], ["6e-05 has no unit", "1 mm2/s"]),
        ("operating.speed", ringfilm.SI("2000"), ["no unit"]),
        ("operating.speed", float("nan"), ["not a finite number"]),
        ("engine.bor", 1.0, ["unknown key engine.bor", "engine.bore"]),
        ("gas.model", "wibe", ["wiebe"]),
        ("solver.cells", 60.5, ["not a whole number"]),
    ],
)
def test_a_wrong_value_is_refused_and_changes_nothing(case, key, value, words):
    before = case.copy()
    with pytest.raises(ringfilm.InputError) as refusal:
        case[key] = value
    for word in words:
        assert word in str(refusal.value), str(refusal.value)
    assert case == before


@pytest.mark.parametrize("value", [True, object(), {"a": 1}, numpy.bool_(True)])
def test_what_is_not_a_value_is_a_type_error(case, value):
    with pytest.raises(TypeError):
        case["operating.speed"] = value


def test_a_bad_file_is_refused_with_the_text_of_the_program(folder, run_program):
    (folder / "case.toml").write_text(
        (folder / "case.toml").read_text().replace('"89 mm"', "89").replace("stroke", "strok")
    )
    reported = run_program("check", "case.toml").stderr
    with pytest.raises(ringfilm.InputError) as refusal:
        ringfilm.Case.read("case.toml")
    assert reported.startswith(str(refusal.value))
    first = refusal.value.faults[0]
    assert (first.file, first.line) == ("case.toml", 3)
    assert len(refusal.value.faults) == 2


def test_check_reports_what_joins_keys(case):
    case["ring.tangential_force"] = "12 N"
    with pytest.raises(ringfilm.InputError) as refusal:
        case.check()
    assert "ring." in str(refusal.value)
    del case["ring.elastic_pressure"]
    assert isinstance(case.check(), list)
    assert "ring.tangential_force" in case and "ring.elastic_pressure" not in case


def test_the_gas_model_can_be_changed_step_by_step(case):
    for key in ("gas.cylinder_pressure", "gas.pressure_reference", "gas.angle_zero"):
        case[key] = None
    case["gas.model"] = "wiebe"
    case.check()
    case["gas.model"] = "trace"
    with pytest.raises(ringfilm.InputError, match="gas.cylinder_pressure is missing"):
        case.check()


def test_a_trace_is_read_again_with_another_unit(case, folder):
    (folder / "bare.csv").write_text("angle,p\n" + "".join(f"{a},{20 + a / 10}\n" for a in range(0, 720, 5)))
    case["gas.angle_unit"] = "degree"
    case["gas.pressure_unit"] = "bar"
    case["gas.cylinder_pressure"] = "bare.csv"
    in_bar = case.run()
    case["gas.pressure_unit"] = "psi"
    assert case.run().gas_pressure[0] == pytest.approx(in_bar.gas_pressure[0] * 0.0689475729, rel=1e-6)


def test_keys_that_only_fit_together_are_changed_at_once(case, folder):
    rows = "".join(f"{a},{20 + a / 10},{30 + a / 10}\n" for a in range(0, 720, 5))
    (folder / "two.csv").write_text("angle [degree],p1 [bar],p2 [bar]\n" + rows)
    before = case.copy()
    for key, value in (("gas.cylinder_pressure", "two.csv"), ("gas.pressure_column", "p2")):
        with pytest.raises(ringfilm.InputError, match=r"keys that only fit together are changed by one update\(\)"):
            case[key] = value
    (folder / "corrupted.csv").write_text("angle [degree],p [bar]\n0,none\n")
    for name, fault in (("absent.csv", "no such file"), ("corrupted.csv", "none")):
        with pytest.raises(ringfilm.InputError, match=fault) as refused:
            case["gas.cylinder_pressure"] = name
        assert "update()" not in str(refused.value)
    with pytest.raises(ringfilm.InputError) as refused:
        case.update({"operating.speed": 2000, "engine.bore": 0.09})
    assert len(refused.value.faults) == 2
    with pytest.raises(ringfilm.UnknownKeyError):
        case.update({"operating.speed": "2000 rpm", "engine.bor": "90 mm"})
    with pytest.raises(TypeError, match="a key of update must be a text"):
        case.update({1: "90 mm"})
    assert case == before
    case.update(
        {"gas.cylinder_pressure": folder / "two.csv", "gas.pressure_column": "p2", "solver.cells": ringfilm.SI(None)}
    )
    assert case["gas.pressure_column"] == "p2" and "solver.cells" not in case
    case.check()
    case.update({"gas.pressure_column": None, "gas.cylinder_pressure": "trace.csv"})
    assert case["gas.pressure_column"] is None
    case.update({})


def test_overrides_replace_what_a_file_lacks(folder):
    text = (folder / "case.toml").read_text().replace('elastic_pressure = "0.2 MPa"\n', "")
    (folder / "case.toml").write_text(text)
    case = ringfilm.Case.read(
        "case.toml",
        {"ring.elastic_pressure": ringfilm.SI(0.2e6), "operating.speed": "3000 rpm", "ring.face.crown_height": "10 um"},
    )
    assert case["ring.elastic_pressure"] == 0.2e6
    assert case["ring.face.crown_height"] == 10e-6
    with pytest.raises(ringfilm.InputError, match="ring.elastic_pressure = 200000 has no unit"):
        ringfilm.Case.read("case.toml", {"ring.elastic_pressure": 0.2e6})


def test_an_oil_file_takes_the_place_of_the_oil(case):
    case["lubricant.file"] = "data/lubricants/sae-30.toml"
    case.check()
    assert case["lubricant.kinematic_viscosity"] != [(313.15, 59.99e-6), (373.15, 9.59e-6)]
    assert any(role == "lubricant.file" for role, _, _ in case.files)


def test_a_grade_finds_a_shipped_oil(case):
    case["lubricant.file"] = "data/lubricants/sae-0w-20.toml"
    case["lubricant.grade"] = "SAE 10W-40"
    case.check()
    oil = next(oil for oil in ringfilm.oils() if oil["grade"] == "SAE 10W-40")
    viscosities = case["lubricant.kinematic_viscosity"]
    assert viscosities[0][1] == pytest.approx(oil["kinematic_viscosity_40"], rel=1e-9)
    assert case["lubricant.file"] is None
    with pytest.raises(ringfilm.InputError, match="choose one of .*SAE 30"):
        case["lubricant.grade"] = "SAE 99"
    with pytest.raises(ringfilm.InputError, match="both given"):
        case.update({"lubricant.grade": "SAE 30", "lubricant.file": "data/lubricants/sae-30.toml"})
    assert case["lubricant.grade"] == "SAE 10W-40"


def test_overrides_drop_the_keys_that_they_make_unused(folder):
    with pytest.warns(UserWarning, match=r"dropped: ring.elastic_pressure \(case.toml:\d+\)"):
        case = ringfilm.Case.read("case.toml", {"ring.tangential_force": "12.5 N"})
    assert case["ring.elastic_pressure"] is None and case["ring.tangential_force"] == 12.5


def test_start_cases(folder):
    for engine in ("passenger-car", "heavy-duty", "hydrogen"):
        (folder / "start.toml").write_text(ringfilm.starting_case(engine))
        assert ringfilm.Case.read("start.toml")["contact.boundary_shear_strength_coefficient"] == 0.12
    assert "MISSING: absolute or gauge?" in ringfilm.starting_case(trace="trace.csv")
    with pytest.raises(ringfilm.InputError, match="did you mean heavy-duty"):
        ringfilm.starting_case("heavy_duty")


def test_copies_are_independent(case):
    for other in (
        case.copy(),
        copy.copy(case),
        copy.deepcopy(case),
        *(pickle.loads(pickle.dumps(case, protocol)) for protocol in range(6)),
    ):
        assert other == case
        other["operating.speed"] = "3000 rpm"
        assert other != case
    assert case != 3


def test_a_pickle_runs_without_its_files(case, folder):
    stored = pickle.dumps(case)
    expected = case.run().fmep
    (folder / "trace.csv").unlink()
    (folder / "case.toml").unlink()
    again = pickle.loads(stored)
    assert again.resolved() == case.resolved()
    assert again.files == case.files
    assert again.run().fmep == expected


def test_keys_and_what_is_assumed(case):
    assert "operating.speed" in case.keys() and "gas.peak_pressure" not in case.keys()
    assumed = case.assumed()
    assert assumed["ring.youngs_modulus"] == '"203 GPa"'
    assert "engine.bore" not in assumed
    assert list(case) == case.keys()
    assert any("oil" in sentence for sentence in case.assumptions())
    assert "a small case" in repr(case)


def test_the_table_of_fields():
    fields = {field.key: field for field in ringfilm.fields()}
    assert fields["engine.bore"].unit == "m" and fields["engine.bore"].is_required
    assert fields["ring.youngs_modulus"].default == 203e9
    assert "trace" in fields["gas.model"].choices
    assert all(field.help for field in fields.values())
    assert {quantity.name for quantity in ringfilm.quantities()["cycle"]} >= {"fmep", "full_film_cycle_share"}


def test_a_key_that_a_case_cannot_do_without_has_no_value_once_it_is_taken_out(case):
    del case["engine.bore"]
    assert case["engine.bore"] is None and case.text("engine.bore") == ""
    assert "engine.bore" not in case.assumed()
    with pytest.raises(ringfilm.InputError, match="engine.bore"):
        case.check()


def test_a_case_is_walked_like_a_dict(case):
    assert len(case) == len(case.keys()) == len(case.items()) == len(list(case))
    assert dict(case) == dict(case.items())
    assert dict(case)["engine.bore"] == 0.089


def test_numbers_that_are_whole_are_counts(case):
    case["solver.cells"] = numpy.float64(80)
    assert case["solver.cells"] == 80 and isinstance(case["solver.cells"], int)
    with pytest.raises(ringfilm.InputError, match="whole number"):
        case["solver.cells"] = 80.5


@pytest.mark.parametrize("value", [b"90 mm", {"bore": 1}, None.__class__, object()])
def test_what_is_not_a_value_is_reported_as_such(case, value):
    with pytest.raises(TypeError, match="engine.bore = .* is expected"):
        case["engine.bore"] = value


def test_names_that_no_file_can_have(case, folder):
    with pytest.raises(ringfilm.InputError, match="zero byte"):
        ringfilm.Case.read("case\0.toml")
    with pytest.raises(ringfilm.InputError, match=r"title = .* holds the control character U\+0000"):
        case["title"] = "a\0b"
    with pytest.raises(TypeError, match="a key of overrides must be a text"):
        ringfilm.Case.read("case.toml", overrides={3: 4})
    assert ringfilm.Case.read(b"case.toml") == ringfilm.Case.read("case.toml", overrides=None)


def test_a_bare_number_is_accepted_where_nothing_can_be_mistaken():
    """The key has no unit, or its SI unit is the one that people write; the table of fields decides."""
    case = ringfilm.Case.read(SOURCES / "cases" / "styles2014" / "new.toml")
    for field in ringfilm.fields():
        if not isinstance(case[field.key], float):
            continue
        if field.unit in ("1", field.display_unit):
            case[field.key] = case[field.key]
        else:
            with pytest.raises(ringfilm.InputError, match=rf"{field.key} = .* has no unit(.|\n)*ringfilm.SI"):
                case[field.key] = case[field.key]


@pytest.mark.parametrize("path", ["styles2014/new.toml", "pad/inclined_slider.toml"])
def test_what_was_read_can_be_written_back(path):
    case = ringfilm.Case.read(SOURCES / "cases" / path)
    other = case.copy()
    for key, value in case.items():
        if key in case and key not in ("gas.cylinder_pressure", "pad.gap"):  # files, named from the folder of the case
            other[key] = ringfilm.SI(value)
    assert other == case
    other["operating.oil_temperature"] = ringfilm.SI(None)
    assert "operating.oil_temperature" not in other


def test_a_lone_surrogate_is_refused_as_input():
    """Every argument that is a text, by the same words."""
    case = ringfilm.Case.read(SOURCES / "cases" / "pad" / "inclined_slider.toml")
    pad = case.run()
    bad = "a\ud800"
    for use in (
        lambda: case.__setitem__("title", bad),
        lambda: case.__setitem__("title", ringfilm.SI(bad)),
        lambda: case.__setitem__("operating.oil_temperature", bad),
        lambda: case.__setitem__("lubricant.density", [{bad: 1}]),
        lambda: case.__setitem__("lubricant.kinematic_viscosity", [(bad, "1 mm2/s")]),
        lambda: case.__setitem__("output.crank_angles", [bad]),
        lambda: case.__setitem__(bad, 1),
        lambda: case[bad],
        lambda: bad in case,
        lambda: case.__delitem__(bad),
        lambda: case.text(bad),
        lambda: ringfilm.Case.read(bad),
        lambda: ringfilm.Case.read("x.toml", {bad: 1}),
        lambda: ringfilm.Case.read("x.toml", {"title": bad}),
        lambda: ringfilm.Study.read(bad),
        lambda: ringfilm.Result.read(bad),
        lambda: ringfilm.simulate_many([], curves=bad),
        lambda: pad.plot(bad),
        lambda: pad.write(bad),
        lambda: ringfilm.surface.read(bad),
        lambda: ringfilm.surface.read("x.sur", channel=bad),
        lambda: ringfilm.lateral_force.read("x.csv", load_deviation=bad),
    ):
        with pytest.raises(ringfilm.InputError, match="lone surrogate"):
            use()


# Every member of every public class is used of an object that was never constructed, in a process of its own: none may
# end the interpreter, and what is raised must be about the object or an argument.
USE_OF_EMPTY_OBJECTS = """
import copy, inspect, pickle, sys, ringfilm
modules = (ringfilm, ringfilm.errors, ringfilm.surface, ringfilm.face, ringfilm.lateral_force, ringfilm.laws)
classes = {thing for module in modules for thing in vars(module).values()
           if inspect.isclass(thing) and thing.__module__.startswith("ringfilm")}
n, unrefused = 0, set()
for one in sorted(classes, key=lambda each: each.__name__):
    try:
        empty = one.__new__(one)
    except TypeError:
        continue  # there are no such objects
    # What `object` answers without looking into an object; an OSError may be empty.
    of_object = {name for name in dir(one) if getattr(one, name) is getattr(object, name, None)}
    if issubclass(one, OSError):
        continue
    uses = {f"{name}({arguments})": (lambda name=name, arguments=arguments: getattr(empty, name)(*arguments))
            for name in dir(one) if callable(getattr(one, name, None)) and name not in of_object
            and name not in ("__class__", "__new__", "__setstate__", "__init_subclass__", "__getattribute__",
                             "__subclasshook__", "__dir__", "__format__")
            and not isinstance(inspect.getattr_static(one, name), staticmethod)
            for arguments in ((), (1,), ("fmep",), ("fmep", "1"))}
    uses.update({name: lambda name=name: getattr(empty, name) for name in dir(one)
                 if isinstance(inspect.getattr_static(one, name), property)})
    uses.update({f"pickle {k}": lambda k=k: pickle.dumps(empty, k) for k in range(6)})
    uses.update({"copy": lambda: copy.copy(empty), "deepcopy": lambda: copy.deepcopy(empty)})
    uses["repr"] = lambda: repr(empty)
    for name, use in uses.items():
        print(one.__name__, name, file=sys.stderr, flush=True)
        if name == "repr" and "__repr__" in of_object:
            continue
        try:
            use()
        except (TypeError, ValueError):  # of the object, or of an argument
            n += 1
        else:
            unrefused.add(f"{one.__name__} {name}")
print(n, *sorted(unrefused), sep="\\n")
"""


def test_an_object_that_was_never_constructed_is_a_type_error():
    """Class.__new__(Class) has nothing in it; every class of the module refuses to be used so, or to be made so."""
    done = subprocess.run([sys.executable, "-c", USE_OF_EMPTY_OBJECTS], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-300:]
    n, *unrefused = done.stdout.splitlines()
    assert int(n) > 1000
    # A number is the name of nothing, whatever the result holds.
    assert unrefused == ["PackResult __contains__((1,))", "Result __contains__((1,))"]
    with pytest.raises(TypeError, match="made by __new__ alone"):
        ringfilm.Result.__new__(ringfilm.Result).fmep
    with pytest.raises(TypeError, match="made by __new__ alone"):
        ringfilm.simulate_many([ringfilm.Case.__new__(ringfilm.Case)])
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'results'"):
        ringfilm.BatchResult.__new__(ringfilm.BatchResult)


@pytest.mark.parametrize("protocol", range(6))
def test_what_cannot_be_pickled_is_a_type_error(protocol):
    with pytest.raises(TypeError, match="ringfilm.Field cannot be pickled or copied"):
        pickle.dumps(ringfilm.fields()[0], protocol)
    for made in (
        ringfilm.SI(2.5),
        ringfilm.BatchResult([]),
        ringfilm.InputError("a", []),
        ringfilm.ConvergenceError("b"),
    ):
        assert repr(pickle.loads(pickle.dumps(made, protocol))) == repr(made) == repr(copy.copy(made))


def test_cases_begin_without_a_file():
    case = ringfilm.Case.new("heavy-duty", load="part")
    assert case.text("engine.bore") == '"130 mm"'
    stated = {key: tomllib.loads("x = " + case.text(key))["x"] for key in case.keys() if key in case}
    assert "lubricant.grade" in stated
    other = ringfilm.Case({**stated, "title": "mine"})
    assert other.title == "mine"
    case["title"] = "mine"
    assert other.resolved() == case.resolved()
    with pytest.raises(ringfilm.InputError, match="key engine.bore is missing"):
        ringfilm.Case({"engine.stroke": "80 mm"})
    with pytest.raises(ringfilm.InputError, match="heavy_duty"):
        ringfilm.Case.new("heavy_duty")
    assert len(ringfilm.Case.new(pack=True).rings) == 3


def test_a_copy_takes_other_values():
    case = ringfilm.Case.new()
    fast = case.copy({"lubricant.grade": "SAE 0W-20"}, operating__speed="3000 rpm")
    assert fast.text("operating.speed") == '"3000 rpm"'
    assert case.text("operating.speed") == '"1500 rpm"'
    assert case.copy() == case
    with pytest.raises(ringfilm.InputError):
        case.copy(operating__speed="3000")


def test_notebooks_show_a_table_and_complete_keys():
    case = ringfilm.Case.new()
    case["title"] = "a <b> case"
    assert "engine.bore" in case._repr_html_() and "a &lt;b&gt; case" in case._repr_html_()
    assert "engine.bore" in case._ipython_key_completions_()
