"""What a notebook shows of cases and results, and cases that begin without a file."""

import html
import pathlib
import tempfile

from ._ringfilm import Case, quantities, starting_case

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


def pack_to_pandas(pack):
    """Values of the cycle in SI, a row each ring."""
    import pandas

    rows = {ring.title.rpartition(": ")[2]: ring.values for ring in pack.rings}
    frame = pandas.DataFrame.from_dict(rows, orient="index")
    frame.index.name = "ring"
    frame.attrs.update(title=pack.title, units=dict(pack.units))
    return frame
