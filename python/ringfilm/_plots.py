"""Figures of results with matplotlib, which is only loaded here: units of engineers, one crank axis, captions."""

import numpy

from ._ringfilm import _unit_scale, quantities

# Told apart by colour-blind readers and in grey print (Okabe and Ito); one line style a contribution.
_TOTAL = {"color": "#000000", "linestyle": "-"}
_BOUNDARY = {"color": "#D55E00", "linestyle": "--"}
_VISCOUS = {"color": "#0072B2", "linestyle": ":"}
_STROKES = ((-270, "intake"), (-90, "compression"), (90, "power"), (270, "exhaust"))

_PANELS = {
    "film": ("min_film_thickness", "film_parameter", "cavitated_fraction"),
    "friction": ("friction", "friction_coefficient", "power_loss"),
    "overview": ("gas_pressure", "min_film_thickness", "friction"),
}


def _curves():
    tables = quantities()
    return {quantity.name: quantity for table in ("curve", "unrolled_curve") for quantity in tables[table]}


def _shown(values, quantity):
    """Values in the unit that people read."""
    factor, offset = _unit_scale(quantity.display_unit, quantity.unit)
    return (numpy.asarray(values) - offset) / factor


def _label(quantity):
    return quantity.long_name if quantity.display_unit == "1" else f"{quantity.long_name} [{quantity.display_unit}]"


def _from_intake(angles):
    """Angles from -360 to 360 with the order in which they follow each other there."""
    turned = numpy.where(angles >= 360, angles - 720, angles)
    order = numpy.argsort(turned, kind="stable")
    return turned[order], order


def _crank_axis(axes, result, strokes=True):
    axes.set_xlim(-360, 360)
    axes.set_xticks(range(-360, 361, 90))
    for angle in (-360, -180, 0, 180, 360):
        axes.axvline(angle, color="0.8", linewidth=0.8, zorder=0)
    for angle, stroke in _STROKES if strokes else ():
        axes.annotate(stroke, (angle, 1), xycoords=("data", "axes fraction"), xytext=(0, 2),
                      textcoords="offset points", ha="center", va="bottom", fontsize=7, color="0.45")
    peak = result.peak_gas_pressure_angle
    if numpy.isfinite(peak):
        peak = peak - 720 if peak >= 360 else peak
        axes.axvline(peak, color="0.55", linewidth=0.8, linestyle=(0, (1, 2)), zorder=0)


def _draw_curve(axes, result, name, style=None, label=None):
    quantity = _curves()[name]
    angles, order = _from_intake(result.crank_angle)
    values = _shown(result[name], quantity)[order]
    axes.plot(angles, values, **(style or _TOTAL), linewidth=1.3, label=label)
    axes.set_ylabel(_label(quantity), fontsize=8)
    if numpy.nanmin(values) < 0 < numpy.nanmax(values):
        axes.axhline(0, color="0.6", linewidth=0.8, zorder=0)


def _draw_panel(axes, result, name, strokes=True):
    if name == "friction":
        _draw_curve(axes, result, "total_friction", _TOTAL, "total")
        _draw_curve(axes, result, "boundary_friction", _BOUNDARY, "boundary")
        _draw_curve(axes, result, "viscous_friction", _VISCOUS, "viscous")
        axes.set_ylabel(_label(_curves()["total_friction"]).replace("total friction", "friction"), fontsize=8)
        axes.legend(fontsize=7, loc="upper left")
    else:
        _draw_curve(axes, result, name)
    if name in ("min_film_thickness", "film_parameter"):
        axes.set_ylim(bottom=0)
    _crank_axis(axes, result, strokes)


def _caption(figure, text, result):
    by = result.provenance["program"]
    figure.text(0.01, 0.005, f"{text} Case: {result.title or 'without a title'}; {by}.", fontsize=7, color="0.3",
                wrap=True)


def _figure(n_panels):
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.5, 1.2 + 2.0 * n_panels), layout="constrained")
    figure.get_layout_engine().set(rect=(0, 0.05, 1, 0.95))
    return figure


def _known():
    fields = ("film_thickness", "film_pressure", "fill", "local_film_parameter", "asperity_pressure")
    return (*_PANELS, "stribeck"), tuple(_curves()), fields


def plot_result(result, what="overview", axes=None):
    """See Result.plot."""
    kinds, curves, fields = _known()
    if not result.crank_angle.size:
        raise ValueError("this result has no curves: run the batch with curves=\"all\"")
    if what in fields:
        return _plot_field(result, what)
    if what == "stribeck":
        return _plot_stribeck(result)
    if what in curves:
        return _plot_curves(result, (what,), axes)
    if what in _PANELS:
        return _plot_curves(result, _PANELS[what], axes)
    raise ValueError(f"{what!r} cannot be drawn; one of {', '.join(kinds)}, a curve or a field of the result")


def _plot_curves(result, names, axes):
    if axes is not None:
        if len(names) > 1:
            raise ValueError("axes takes one curve; leave it out for a figure of several")
        _draw_panel(axes, result, names[0])
        axes.set_xlabel("crank angle [degree]", fontsize=8)
        return axes.figure
    figure = _figure(len(names))
    panels = figure.subplots(len(names), 1, sharex=True, squeeze=False)[:, 0]
    for panel, name in zip(panels, names):
        _draw_panel(panel, result, name, panel is panels[0])
    panels[-1].set_xlabel("crank angle [degree], 0 = firing TDC", fontsize=8)
    told = ", ".join("friction" if name == "friction" else _curves()[name].long_name for name in names)
    _caption(figure, f"Over one cycle: {told}. Dotted grey line: peak of the gas pressure.", result)
    return figure


def _plot_stribeck(result):
    curves = _curves()
    figure = _figure(2)
    axes = figure.subplots()
    number = numpy.asarray(result.stribeck_number)
    shown = number > 1e-6 * number.max()  # at a dead centre it is only the round-off of the angle
    axes.semilogx(number[shown], numpy.asarray(result.friction_coefficient)[shown], ".", color="#000000", markersize=3)
    axes.set_xlabel(_label(curves["stribeck_number"]), fontsize=8)
    axes.set_ylabel(_label(curves["friction_coefficient"]), fontsize=8)
    axes.set_ylim(bottom=0)
    _caption(figure, "Friction coefficient over the Stribeck number, each crank angle a point.", result)
    return figure


def _plot_field(result, name):
    variables, _ = result._dataset()
    if name not in variables:
        raise ValueError(f"this result has no field {name}: state output.fields in the case")
    dimensions, values, attributes = variables[name]
    values = numpy.asarray(values)
    angles, order = _from_intake(numpy.asarray(variables["field_crank_angle"][1]))
    display = {"m": ("um", 1e6), "Pa": ("MPa", 1e-6)}
    unit, factor = display.get(attributes.get("units", "1"), ("", 1.0))
    figure = _figure(2)
    axes = figure.subplots()
    x = numpy.asarray(variables["x"][1]) * 1e3
    if len(angles) > 1:
        mesh = axes.pcolormesh(angles, x, values[order].T * factor, shading="nearest", cmap="viridis")
        figure.colorbar(mesh, ax=axes).set_label(f"{attributes['long_name']} [{unit or '1'}]", fontsize=8)
        axes.set_xlabel("crank angle [degree], 0 = firing TDC", fontsize=8)
        axes.set_ylabel("position from the chamber edge [mm]", fontsize=8)
        _crank_axis(axes, result)
    else:
        axes.plot(x, values[0] * factor, **_TOTAL)
        axes.set_xlabel("position from the chamber edge [mm]", fontsize=8)
        axes.set_ylabel(f"{attributes['long_name']} [{unit or '1'}]", fontsize=8)
    _caption(figure, f"{attributes['long_name'].capitalize()} at {len(angles)} crank angles.", result)
    return figure


def plot_pad(result):
    """See PadResult.plot."""
    figure = _figure(2)
    gap, pressure = figure.subplots(2, 1, sharex=True)
    x = result.x * 1e3
    thickness, film = result.film_thickness[-1], result.pressure[-1]
    where = ""
    if thickness.ndim == 2:
        middle = thickness.shape[0] // 2
        thickness, film, where = thickness[middle], film[middle], f" on the strip y = {result.y[middle] * 1e3:.4g} mm"
    gap.plot(x, thickness * 1e6, **_TOTAL)
    gap.set_ylabel("film thickness [um]", fontsize=8)
    gap.set_ylim(bottom=0)
    pressure.plot(x, film * 1e-6, **_TOTAL)
    pressure.set_ylabel("film pressure [MPa]", fontsize=8)
    pressure.set_xlabel("position along the pad [mm]", fontsize=8)
    figure.text(0.01, 0.005, f"Film of the pad{where}. Case: {result.title}.", fontsize=7, color="0.3")
    return figure
