"""Results as tables of xarray and pandas, which are only loaded here."""

import difflib

import numpy

from ._ringfilm import quantities, version
from .errors import InputError


def _attributes(quantity):
    """Of a variable, those that result files have."""
    words = {
        "units": quantity.unit,
        "long_name": quantity.long_name,
        "symbol": quantity.symbol,
        "source_equation": quantity.equation,
    }
    return {name: word for name, word in words.items() if word}


def _texts(words):
    return numpy.array(list(words), dtype=object)


def _dataset(variables, attributes):
    import xarray

    coordinates = {name: variable for name, variable in variables.items() if variable[0] == (name,)}
    data = {name: variable for name, variable in variables.items() if name not in coordinates}
    return xarray.Dataset(data, coordinates, attributes)


def with_units(frame, units, index_unit="degree"):
    """The frame, with the units in the names of its columns where `units` is "columns", as in CSV files."""
    if units not in ("attrs", "columns"):
        raise ValueError(f'units: {units!r} is neither "attrs" nor "columns"')
    if units == "attrs":
        return frame
    named = {name: f"{name} [{unit}]" for name, unit in frame.attrs["units"].items() if unit not in ("", "1")}
    has_unit = frame.index.name in ("crank_angle", "time", "hours")
    return frame.rename(columns=named).rename_axis(
        f"{frame.index.name} [{index_unit}]" if has_unit else frame.index.name
    )


def check_angles(angles):
    """Throws for a word that is not an axis."""
    if angles not in ("cycle", "firing"):
        raise ValueError(f'angles: "{angles}" is neither "cycle" nor "firing"')


def result_to_xarray(result, angles):
    """The dataset that xarray reads from the file of a result, with firing TDC at its begin or in its middle."""
    check_angles(angles)
    return around_firing(_dataset(*result._dataset()), angles)


def around_firing(dataset, angles):
    """The dataset with firing TDC at the begin of its crank angles ("cycle") or in their middle ("firing")."""
    if angles == "cycle":
        return dataset
    for name in ("crank_angle", "field_crank_angle"):
        if name in dataset.coords:
            centred = (dataset[name] + 360) % 720 - 360
            dataset = dataset.assign_coords({name: centred.assign_attrs(dataset[name].attrs)}).sortby(name)
    return dataset


def result_to_pandas(result, units="attrs"):
    """Curves as columns, crank angle as index."""
    import pandas

    tables = quantities()
    curves = {quantity.name: quantity for quantity in tables["curve"] if quantity.name != "crank_angle"}
    if result.gap_leakage.size:
        curves.update({quantity.name: quantity for quantity in tables["unrolled_curve"]})
    frame = pandas.DataFrame(
        {name: result[name] for name in curves}, index=pandas.Index(result.crank_angle, name="crank_angle")
    )
    frame.attrs.update(title=result.title, units={name: curves[name].unit for name in curves})
    return with_units(frame, units)


def _values_by_attribute(tables):
    """{attribute of a Result: quantity} of the values of a cycle: `cycle_...` where a curve has the name."""
    curves = {quantity.name for quantity in tables["curve"]}
    return {
        f"cycle_{quantity.name}" if quantity.name in curves else quantity.name: quantity
        for table in ("cycle", "unrolled_cycle")
        for quantity in tables[table]
    }


def batch_column(batch, name):
    """One value of all cases, shape (case,)."""
    if name == "reason":
        return _texts(result.reason for result in batch)
    attributes = {name: name for name in _values_by_attribute(quantities())}
    attributes.update({name[len("cycle_") :]: name for name in attributes if name.startswith("cycle_")})
    if name not in attributes:
        near = difflib.get_close_matches(name, attributes, 1)
        raise KeyError(f"a batch has no value {name}" + (f"; did you mean {near[0]}?" if near else ""))
    return numpy.array([getattr(result, attributes[name]) for result in batch], dtype=float)


def batch_to_pandas(batch, units="attrs"):
    """Values of the cycle as columns, cases as rows."""
    import pandas

    tables = quantities()
    unit_of = {quantity.name: quantity.unit for quantity in (*tables["cycle"], *tables["unrolled_cycle"])}
    rows = [result.values for result in batch]
    there = {quantity.name for quantity in tables["cycle"]}.union(*rows)
    unit_of = {name: unit for name, unit in unit_of.items() if name in there}
    frame = pandas.DataFrame(rows, columns=list(unit_of), dtype=float)
    frame["reason"] = _texts(result.reason for result in batch)
    frame.index.name = "case"
    frame.attrs["units"] = unit_of
    return with_units(frame, units)


def _over_all_angles(results, name, angles, places):
    """A curve of all results over the angles of all of them, NaN where one has none."""
    curves = numpy.full((len(results), len(angles)), numpy.nan)
    for row, result, at in zip(curves, results, places):
        if len(result[name]):
            row[at] = result[name]
    return curves


def batch_to_xarray(batch, curves=None):
    """Values over case, curves over case and crank angle."""
    import xarray

    tables = quantities()
    results = list(batch)
    data = {
        "solved": (
            "case",
            numpy.array([not result.reason for result in results], dtype=numpy.int8),
            {"units": "1", "long_name": "1 where the case was solved"},
        ),
        "reason": ("case", _texts(result.reason for result in results), {"long_name": "why it was not solved"}),
    }
    for name, quantity in _values_by_attribute(tables).items():
        values = numpy.array([getattr(result, name) for result in results], dtype=float)
        if quantity not in tables["unrolled_cycle"] or numpy.isfinite(values).any():
            data[name] = ("case", values, _attributes(quantity))
    titles = _texts(result.title for result in results)
    coordinates = {"case": numpy.arange(len(results)), "title": ("case", titles, {"long_name": "title of the case"})}
    angles = numpy.unique(numpy.concatenate([numpy.empty(0), *(result.crank_angle for result in results)]))
    axis, *known = tables["curve"]
    if any(result.gap_leakage.size for result in results):
        known += tables["unrolled_curve"]
    unknown = set(curves or ()) - {quantity.name for quantity in known}
    if unknown:
        raise KeyError(
            f"this batch has no curve {', '.join(sorted(unknown))}: " 'ringfilm.quantities()["curve"] lists them'
        )
    if angles.size:
        coordinates["crank_angle"] = ("crank_angle", angles, _attributes(axis))
        places = [numpy.searchsorted(angles, result.crank_angle) for result in results]
        for quantity in known:
            if curves is None or quantity.name in curves:
                over = _over_all_angles(results, quantity.name, angles, places)
                data[quantity.name] = (("case", "crank_angle"), over, _attributes(quantity))
    return xarray.Dataset(data, coordinates)


def pad_to_xarray(result):
    """The dataset that xarray reads from the file of a pad."""
    return _dataset(*result._dataset())


def pad_to_pandas(result, units="attrs"):
    """Numbers of all instants, time as index."""
    import pandas

    names = list(result.values)
    frame = pandas.DataFrame({name: getattr(result, name) for name in names})
    unit_of = {quantity.name: quantity.unit for table in ("pad", "pad_width") for quantity in quantities()[table]}
    frame = frame.set_index("time") if "time" in frame else frame
    frame.attrs.update(title=result.title, units={name: unit_of[name] for name in names})
    return with_units(frame, units, index_unit="s")


def _columns(study):
    """(factor, its numbers over the scenarios); of choices their texts, empty where it leaves its base as it is."""
    points = study.points
    for j, factor in enumerate(study.factors):
        numbers, choices = points[:, j], factor["choices"]
        if choices:
            yield factor, _texts("" if numpy.isnan(number) else choices[int(number)] for number in numbers)
        else:
            yield factor, numbers


def study_to_pandas(study, units="attrs"):
    """Factors as columns, scenarios as rows."""
    import pandas

    columns = {factor["variable"]: column for factor, column in _columns(study)}
    frame = pandas.DataFrame({"base": study.base_of, **columns})
    frame.index.name = "scenario"
    frame.attrs.update(title=study.title, units={factor["variable"]: factor["unit"] for factor in study.factors})
    return with_units(frame, units)


def _kept_curves(result):
    """Curves over scenario, crank angle and ring, as in files of studies."""
    for quantity in quantities()["curve"]:
        try:
            curves = result.curves(quantity.name)
        except InputError:
            continue
        yield f"curve_{quantity.name}", (("scenario", "crank_angle", "ring"), curves[:, :, None], _attributes(quantity))


def _reasons(result):
    unsolved = result.unsolved
    return _texts(unsolved.get(i, "") for i in range(len(result)))


def study_result_to_xarray(result):
    """Values over scenario, base and factors as coordinates."""
    import xarray

    study, tables = result.study, quantities()
    coordinates = {"base": ("scenario", _texts(study.base_of), {"long_name": "base case of the scenario"})}
    for factor, column in _columns(study):
        words = {
            "units": factor["unit"],
            "long_name": factor["name"],
            "key": factor["keys"][0],
            "source": factor.get("source", ""),
        }
        attributes = {name: word for name, word in words.items() if word}
        coordinates[factor["variable"]] = ("scenario", column, attributes)
    described = {quantity.name: _attributes(quantity) for quantity in study.values}
    reasons = _reasons(result)
    data = {
        "solved": (
            "scenario",
            (reasons == "").astype(numpy.int8),
            {"units": "1", "long_name": "1 where the scenario was solved"},
        )
    }
    for name, (dimensions, values, attributes) in result._dataset().items():
        data[name] = (dimensions, values, {**attributes, **described.get(name, {})})
    if len(result.crank_angle):
        coordinates["crank_angle"] = ("crank_angle", result.crank_angle, _attributes(tables["curve"][0]))
        coordinates["ring"] = ("ring", [1.0], {"units": "1", "long_name": "ring, counted from the chamber"})
        data.update(_kept_curves(result))
    data["reason"] = ("scenario", reasons, {"long_name": "why it was not solved"})
    notes = result.notes
    if notes:
        coordinates["note_topic"] = ("note_topic", _texts(notes), {"long_name": "topic of notes on single results"})
        messages = _texts(message for message, _ in notes.values())
        words = {"long_name": "the note, with the figures of the scenario where it is worst, else of the first"}
        data["note_message"] = ("note_topic", messages, words)
        carries = numpy.zeros((len(result), len(notes)), numpy.int8)
        for topic, (_, scenarios) in enumerate(notes.values()):
            carries[scenarios, topic] = 1
        words = {"units": "1", "long_name": "1 where the result carries the note"}
        data["has_note"] = (("scenario", "note_topic"), carries, words)
    program, commit = version().split(" commit ")
    return xarray.Dataset(data, coordinates, {"title": study.title, "program": program, "commit": commit})


def study_result_to_pandas(result, units="attrs"):
    """Factors and values as columns, scenarios as rows."""
    import pandas

    plan = study_to_pandas(result.study)
    unit_of = {quantity.name: quantity.unit for quantity in result.study.values}
    frame = pandas.concat([plan, pandas.DataFrame({name: result[name] for name in unit_of}, index=plan.index)], axis=1)
    frame["reason"] = _reasons(result)
    topics = [[] for _ in range(len(result))]
    for topic, (_, scenarios) in result.notes.items():
        for i in scenarios:
            topics[i].append(topic)
    frame["notes"] = ["; ".join(of_row) for of_row in topics]
    frame.attrs.update(title=result.study.title, units={**plan.attrs["units"], **unit_of})
    return with_units(frame, units)
