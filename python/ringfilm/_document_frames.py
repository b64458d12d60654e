"""The gas between rings and lives as tables of xarray and pandas, which are only loaded here."""

import numpy

from ._frames import _attributes, _texts, around_firing, check_angles, with_units
from ._ringfilm import quantities


def gas_to_pandas(gas, units):
    """Curves as columns by the names of the CSV file, crank angle as index."""
    import pandas

    columns = {}
    for region, values in gas.pressure.items():
        columns[f"pressure_{region}".replace(" ", "_")] = values, "Pa"
    for path, values in gas.flow.items():
        columns[f"flow_{path}".replace(" ", "_")] = values, "kg/s"
    for ring, values in gas.position.items():
        columns[f"position_ring_{ring}"] = values, "m"
    for scalar, by_region in gas._of("curves").get("share", {}).items():
        for region, values in by_region.items():
            columns[f"share_{scalar}_{region}".replace(" ", "_")] = values, "1"
    frame = pandas.DataFrame(
        {name: values for name, (values, _) in columns.items()}, pandas.Index(gas.crank_angle, name="crank_angle")
    )
    frame.attrs.update(title=gas._of("title"), units={name: unit for name, (_, unit) in columns.items()})
    return with_units(frame, units)


def _rows(records, table, prefix, dimension):
    """Variables of a list of dicts, by the names of result files."""
    for quantity in quantities()[table]:
        if records and all(isinstance(row.get(quantity.name), (int, float)) for row in records):
            values = numpy.array([row[quantity.name] for row in records], dtype=float)
            yield prefix + quantity.name, (dimension, values, _attributes(quantity))


def gas_to_xarray(gas, angles):
    """Values and curves, regions and paths by their names."""
    import xarray

    check_angles(angles)
    over = {"pressure": ("gas_region_pressure", "gas_region", "Pa", "pressure of the region, absolute")}
    over["flow"] = ("gas_path_flow", "gas_path", "kg/s", "mass flow along the path, positive to the crankcase")
    over["position"] = ("ring_position", "gas_ring", "m", "position of the ring above the lower flank of its groove")
    words = {"units": "degree", "long_name": "crank angle, 0 = firing TDC"}
    coordinates, data = {"crank_angle": ("crank_angle", gas.crank_angle, words)}, {}
    for curves, (variable, dimension, unit, long_name) in over.items():
        by_name = getattr(gas, curves)
        if by_name:
            coordinates[dimension] = [*by_name] if dimension == "gas_ring" else (dimension, _texts(by_name))
            values = numpy.column_stack(list(by_name.values()))
            data[variable] = (("crank_angle", dimension), values, {"units": unit, "long_name": long_name})
    for scalar, by_region in gas._of("curves").get("share", {}).items():
        words = {"units": "1", "long_name": f"mass share of {scalar} in the region"}
        values = numpy.column_stack(list(by_region.values()))
        data[f"gas_region_share_{scalar}"] = (("crank_angle", "gas_region"), values, words)
    for quantity in quantities()["gas"]:
        if quantity.name in gas.values:
            prefix = "" if quantity.name.startswith("blow_by") else "gas_"
            data[prefix + quantity.name] = ((), gas.values[quantity.name], _attributes(quantity))
    data.update(_rows(gas["regions"], "gas_region", "gas_region_", "gas_region"))
    data.update(_rows(gas["paths"], "gas_path", "gas_path_", "gas_path"))
    motion = [row for row in gas["ring_motion"] if row["ring"] in gas.position]
    if len(motion) == len(gas.position):
        data.update(_rows(motion, "gas_ring", "gas_ring_", "gas_ring"))
    attributes = {"title": gas._of("title"), "program": gas._of("program")}
    return around_firing(xarray.Dataset(data, coordinates, attributes), angles)


def life_to_pandas(life, units):
    """Values as columns, running hours as index."""
    import pandas

    known = {name: life["units"][name] for name in life.values}
    origin = {"state_origin": life.state_origin} if life["states"] else {}
    hours = pandas.Index([state["hours"] for state in life["states"]], name="hours")
    frame = pandas.DataFrame({**origin, **life.values}, hours)
    frame.attrs.update(title=life["title"], units=known)
    return with_units(frame, units, index_unit="h")


def _band(life, name, end):
    return numpy.array([state.get("band", {}).get(name, (numpy.nan, numpy.nan))[end] for state in life["states"]])


def life_to_xarray(life):
    """Values over the running hours, the face over (running_time, x), bands as `..._low` and `..._high`."""
    import xarray

    tables = quantities()
    described = {quantity.name: quantity for table in ("worn", "cycle") for quantity in tables[table]}
    time = {"units": "h", "long_name": "running time", "symbol": "t"}
    coordinates = {"running_time": ("running_time", [state["hours"] for state in life["states"]], time)}
    data = {}
    for name, values in life.values.items():
        words = _attributes(described[name]) if name in described else {"units": life["units"][name]}
        data[name] = ("running_time", values, words)
        for end, suffix in enumerate(("low", "high")):
            band = _band(life, name, end)
            if numpy.isfinite(band).any():
                data[f"{name}_{suffix}"] = ("running_time", band, words)
    for along in ("x", "liner_position"):
        if along in life:
            coordinates[along] = (along, getattr(life, along), {"units": "m"})
    for name, along in (("face_height", "x"), ("worn_depth", "x"), ("liner_worn_depth", "liner_position")):
        if life["states"] and all(name in state for state in life["states"]):
            data[name] = (("running_time", along), getattr(life, name), {"units": "m"})
    if life["states"]:
        data["state_origin"] = ("running_time", life.state_origin, {"long_name": "how the state is known"})
    attributes = {name: life[name] for name in ("title", "program", "commit") if name in life}
    return xarray.Dataset(data, coordinates, attributes)
