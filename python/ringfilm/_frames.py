"""Results as tables of xarray and pandas, which are only loaded here."""

from ._ringfilm import quantities


def _dataset(variables, attributes):
    import xarray

    coordinates = {name: variable for name, variable in variables.items() if variable[0] == (name,)}
    data = {name: variable for name, variable in variables.items() if name not in coordinates}
    return xarray.Dataset(data, coordinates, attributes)


def result_to_xarray(result):
    """The dataset that xarray reads from the file of a result."""
    return _dataset(*result._dataset())


def result_to_pandas(result):
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
    return frame


def batch_to_pandas(batch):
    """Values of the cycle as columns, cases as rows."""
    import pandas

    units = {quantity.name: quantity.unit for quantity in quantities()["cycle"]}
    rows = [result.values for result in batch]
    frame = pandas.DataFrame(rows, columns=list(rows[0]) if rows else list(units))
    frame["reason"] = [result.reason for result in batch]
    frame.index.name = "case"
    frame.attrs["units"] = units
    return frame


def pad_to_xarray(result):
    """The dataset that xarray reads from the file of a pad."""
    return _dataset(*result._dataset())


def pad_to_pandas(result):
    """Numbers of all instants, time as index."""
    import pandas

    names = list(result.values)
    frame = pandas.DataFrame({name: getattr(result, name) for name in names})
    units = {quantity.name: quantity.unit for table in ("pad", "pad_width") for quantity in quantities()[table]}
    frame.attrs.update(title=result.title, units={name: units[name] for name in names})
    return frame.set_index("time") if "time" in frame else frame


def study_to_pandas(study):
    """Factors as columns, scenarios as rows."""
    import pandas

    factors = study.factors
    frame = pandas.DataFrame(study.points, columns=[factor["variable"] for factor in factors])
    frame.insert(0, "base", study.base_of)
    frame.index.name = "scenario"
    frame.attrs.update(title=study.title, units={factor["variable"]: factor["unit"] for factor in factors})
    return frame


def study_result_to_xarray(result):
    """Values over scenario, base and factors as coordinates."""
    import xarray

    study = result.study
    points = study.points
    coordinates = {"base": ("scenario", study.base_of)}
    for j, factor in enumerate(study.factors):
        attributes = {"units": factor["unit"], "long_name": factor["name"]}
        coordinates[factor["variable"]] = ("scenario", points[:, j], attributes)
    dataset = xarray.Dataset(result._dataset(), coordinates, {"title": study.title})
    unsolved = result.unsolved
    dataset["reason"] = ("scenario", [unsolved.get(i, "") for i in range(len(result))])
    return dataset


def study_result_to_pandas(result):
    """Factors and values as columns, scenarios as rows."""
    import pandas

    plan = study_to_pandas(result.study)
    units = {quantity.name: quantity.unit for quantity in quantities()["cycle"]}
    frame = pandas.concat([plan, pandas.DataFrame({name: result[name] for name in units}, index=plan.index)], axis=1)
    unsolved = result.unsolved
    frame["reason"] = [unsolved.get(i, "") for i in range(len(result))]
    frame.attrs.update(title=result.study.title, units={**plan.attrs["units"], **units})
    return frame
