"""What a notebook shows of cases and results, and cases and studies that begin without a file."""

import html
import json
import os
import pathlib
import tempfile

from ._ringfilm import Case, Study, quantities, starting_case

SHOWN = (
    "fmep",
    "mean_power_loss",
    "mean_boundary_power",
    "peak_total_friction",
    "min_film_thickness",
    "min_lambda_ratio",
    "boundary_regime_cycle_share",
    "mixed_regime_cycle_share",
    "mean_absolute_oil_flow",
    "peak_film_pressure",
)


def _read(text, overrides=None):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "case.toml"
        path.write_text(text, encoding="utf-8")
        case = Case.read(path, overrides)
        case._without_file(str(path))
        return case


def case_of(values):
    """A case of {key: value}, as update() takes them; files relative to the working folder."""
    return _read('title = "a case"\n', dict(values))


def new_case(engine, load, state, pack, trace):
    """The case that `ringfilm new` writes."""
    if trace is not None:
        trace = str(pathlib.Path(trace).resolve())
    return _read(starting_case(engine, trace=trace, load=load, state=state, pack=pack))


def _toml(where, value):
    """A value as TOML has it. Throws TypeError for what is not one."""
    value = value.tolist() if hasattr(value, "tolist") else value  # of numpy
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(where, one) for one in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(_assigned(where, name, one) for name, one in value.items()) + "}"
    raise TypeError(f"{where} must be a text, a number, a list or a dict, not of type {type(value).__name__}")


def _assigned(where, name, value):
    if not isinstance(name, str):
        raise TypeError(f"a key of {where} must be a text, not of type {type(name).__name__}")
    return f"{json.dumps(name, ensure_ascii=False)} = {_toml(f'{where}[{name!r}]', value)}"


def study_of(values):
    """A study of a dict with the tables and keys of its file; files relative to the working folder."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "study.toml"
        path.write_text("".join(_assigned("study", *item) + "\n" for item in values.items()), encoding="utf-8")
        return Study._read_in(path, "")


def changed(case, changes, named):
    """The copy with other values; two underscores of a name stand for the dot of a key."""
    changes = {**dict(changes), **{name.replace("__", "."): value for name, value in named.items()}}
    if changes:
        case.update(changes)
    return case


def _table(title, head, rows):
    def cells(row, tag):
        return "".join(f"<{tag} style='text-align:left'>{html.escape(str(cell))}</{tag}>" for cell in row)

    head = f"<thead><tr>{cells(head, 'th')}</tr></thead>" if head else ""
    body = "".join(f"<tr>{cells(row, 'td')}</tr>" for row in rows)
    return f"<table><caption>{html.escape(title)}</caption>{head}<tbody>{body}</tbody></table>"


def _shown(quantity, value):
    from ._drawing import shown  # needs numpy

    return f"{shown(value, quantity):.4g}"


def _name(quantity):
    return quantity.long_name + ("" if quantity.display_unit == "1" else f" [{quantity.display_unit}]")


def _cycle_quantities():
    table = {quantity.name: quantity for quantity in quantities()["cycle"]}
    return [table[name] for name in SHOWN]


def case_html(case):
    """The keys that the case states."""
    rows = [(key, case.text(key)) for key in case.keys() if key in case]
    return _table(case.title, ("key", "stated"), rows) + f"<p>{len(case.assumed())} default inputs: case.assumed()</p>"


def _notes_html(notes):
    return "".join(f"<p>{html.escape(note[1])}</p>" for note in notes[:4])


def result_html(result):
    """The values of the cycle that decide, and the first notes."""
    values = result.values
    rows = [(_name(quantity), _shown(quantity, values[quantity.name])) for quantity in _cycle_quantities()]
    return _table(result.title, None, rows) + _notes_html(result.notes)


def gas_html(gas):
    """The first values of the gas, the pressures of its regions, and the first notes."""
    tables = quantities()
    values, regions = gas.values, tables["gas_region"][:3]  # highest pressure with its crank angle, mean pressure
    rows = [(_name(one), _shown(one, values[one.name])) for one in tables["gas"][:4] if one.name in values]
    head = ("region", *(_name(one) for one in regions))
    by_region = [(row["name"], *(_shown(one, row[one.name]) for one in regions)) for row in gas["regions"]]
    return _table(gas._of("title"), None, rows) + _table("", head, by_region) + _notes_html(gas._html_notes())


LIFE_SHOWN = ("mean_power_loss", "fmep", "mean_absolute_oil_flow", "min_film_thickness", "largest_worn_depth")


def life_html(life):
    """The values of each state that decide, and the first notes."""
    table = {quantity.name: quantity for name in ("worn", "cycle") for quantity in quantities()[name]}
    shown = [table[name] for name in LIFE_SHOWN if any(state.get(name) is not None for state in life["states"])]
    rows = [
        (f"{state['hours']:g}", state["state_origin"])
        + tuple("" if state.get(one.name) is None else _shown(one, state[one.name]) for one in shown)
        for state in life["states"]
    ]
    head = ("running time [h]", "state", *(_name(one) for one in shown))
    return _table(life["title"], head, rows) + _notes_html(life._html_notes())


def pack_html(pack):
    """The same of each ring side by side."""
    rings = [ring.values for ring in pack.rings]
    rows = [
        (_name(quantity), *(_shown(quantity, values[quantity.name]) for values in rings))
        for quantity in _cycle_quantities()
    ]
    return _table(pack.title, ("", *(ring.title.rpartition(": ")[2] for ring in pack.rings)), rows)


def table_html(scenarios):
    """A study, or its result, as pandas shows it."""
    return scenarios.to_pandas()._repr_html_()


def pack_to_pandas(pack, units="attrs"):
    """Values of the cycle in SI, a row each ring."""
    import pandas

    from ._frames import with_units

    rows = {ring.title.rpartition(": ")[2]: ring.values for ring in pack.rings}
    frame = pandas.DataFrame.from_dict(rows, orient="index")
    frame.index.name = "ring"
    frame.attrs.update(title=pack.title, units=dict(pack.units))
    return with_units(frame, units)
