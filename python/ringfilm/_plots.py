"""Figures of results with matplotlib, which is only loaded here: units of engineers, one crank axis, captions."""

import numpy

from ._drawing import (
    BOUNDARY,
    TOTAL,
    VISCOUS,
    caption,
    crank_axis,
    draw_over_angle,
    from_intake,
    from_zero,
    label_of,
    new_figure,
    plain,
    shown,
)
from ._pad_plots import plot_pad
from ._ringfilm import quantities

__all__ = ["plot_pad", "plot_result"]

_PANELS = {
    "film": ("min_film_thickness", "film_parameter", "cavitated_fraction"),
    "friction": ("friction", "friction_coefficient", "power_loss"),
    "overview": ("gas_pressure", "min_film_thickness", "friction"),
}
_FIELDS = ("film_thickness", "film_pressure", "fill", "local_film_parameter", "asperity_pressure")
_FROM_ZERO = ("min_film_thickness", "film_parameter", "friction_coefficient", "gas_pressure")
_FEW_ANGLES = 8
_HIGH = 60  # letters along the axis of a figure of one large panel
_BY_ANGLE = "crank angle [degree], 0 = firing TDC"
_BY_PLACE = "position from the chamber edge [mm]"
_FIELD_UNITS = {"m": ("um", 1e-6), "Pa": ("bar", 1e5)}


def _curves():
    tables = quantities()
    return {quantity.name: quantity for table in ("curve", "unrolled_curve") for quantity in tables[table]}


def _input(result, key):
    """An input of the case as people read it; empty where it is not in use."""
    return next((read for name, _, read, _ in result.inputs if name == key), "")


def _when(result):
    n = len(result.crank_angle)
    return "Over one cycle" if n >= 90 else f"At {n} crank angles of the cycle"


def _is_synthetic(result):
    return _input(result, "gas.trace_origin") == "synthetic"


def _name_of(result):
    """What tells a result from another in a legend: the title of its case, and its speed."""
    title, speed = result.title or "without a title", _input(result, "operating.speed")
    return title if not speed or speed in title else f"{title}, {speed}"


def _caption(figure, text, result):
    words = [text]
    if _is_synthetic(result):
        words.append("The cylinder pressure is SYNTHETIC: made by a formula, not measured.")
    if not result.complete:
        words.append(f"The march STOPPED at {result.crank_angle[-1]:g} degree, before the end of the cycle.")
    words.append(f"Case: {result.title or 'without a title'}; {result.provenance['program']}.")
    caption(figure, " ".join(words))


def _draw_curve(axes, result, name, style):
    """Draws one curve with what belongs to its quantity."""
    quantity = _curves()[name]
    angles, order = from_intake(result.crank_angle)
    values = shown(result[name], quantity)[order]
    line = draw_over_angle(axes, angles, values, **style)
    axes.set_ylabel(label_of(quantity.long_name, quantity.display_unit), fontsize=8)
    there = values[numpy.isfinite(values)]
    if not there.size:
        axes.text(0.5, 0.5, "no value at any crank angle", transform=axes.transAxes, ha="center", color="0.45")
        return line
    if there.min() < 0 < there.max():
        axes.axhline(0, color="0.6", linewidth=0.8, zorder=0)
    if name in _FROM_ZERO or (there.min() == there.max() >= 0):
        from_zero(axes, line)
    if quantity.unit == "1" and (there == there.round()).all():
        axes.yaxis.get_major_locator().set_params(integer=True)
    if name == "gas_pressure" and _is_synthetic(result):
        top = numpy.nanargmax(values)
        axes.annotate("SYNTHETIC", (angles[top], values[top]), xytext=(12, -2), textcoords="offset points",
                      ha="left", va="top", fontsize=7, color=line.get_color())
    return line


def _draw_panel(axes, result, name, strokes):
    if name == "friction":
        _draw_curve(axes, result, "total_friction", {**TOTAL, "label": "total"})
        _draw_curve(axes, result, "boundary_friction", {**BOUNDARY, "label": "boundary"})
        _draw_curve(axes, result, "viscous_friction", {**VISCOUS, "label": "viscous"})
        axes.set_ylabel("friction [N]", fontsize=8)
        axes.legend(fontsize=7)
    else:
        _draw_curve(axes, result, name, TOTAL)
    crank_axis(axes, result.peak_gas_pressure_angle, strokes)


def _refuse_without_curves(result):
    if result.crank_angle.size:
        return
    if result.reason:
        raise ValueError(f"this result has no curves: the case was not solved: {result.reason}")
    if not result.complete:
        raise ValueError("this result has no curves: the march stopped before the first crank angle that is kept")
    raise ValueError("this result has no curves: run the batch with curves=\"all\"")


def _without_aliases(style):
    from matplotlib import cbook, lines

    return cbook.normalize_kwargs(style, lines.Line2D)


def plot_result(result, what="overview", axes=None, label=None, **style):
    """See Result.plot."""
    curves = _curves()
    if what not in (*_PANELS, "stribeck", *curves, *_FIELDS):
        kinds = ", ".join((*_PANELS, "stribeck"))
        raise ValueError(f"{what!r} cannot be drawn; one of {kinds}, a curve or a field of the result")
    _refuse_without_curves(result)
    if what in _PANELS:
        if axes is not None:
            raise ValueError(f"{what!r} is a figure of several panels: leave axes out, or draw its curves one by one")
        if label is not None or style:
            raise ValueError(f"{what!r} is a figure of several panels: label and style are for one curve")
        return _plot_panels(result, _PANELS[what])
    if what in curves and not numpy.size(result[what]):
        raise ValueError(f"this result has no {what}: its film is not unrolled")
    if axes is not None and not hasattr(axes, "plot"):
        raise ValueError(f"axes is one matplotlib Axes, not {type(axes).__name__}")
    style = _without_aliases(style)
    draw = _draw_stribeck if what == "stribeck" else _draw_over_cycle if what in curves else _draw_field
    if axes is not None:
        draw(axes, result, what, {"label": plain(_name_of(result) if label is None else label), **style}, "inside")
        return axes.figure
    figure = new_figure(1 if what in curves else 2)
    own = {} if label is None else {"label": plain(label)}
    told = draw(figure.subplots(), result, what, {**own, **style}, "above")
    if label is not None:
        figure.axes[0].legend(fontsize=7)
    _caption(figure, told, result)
    return figure


def _own_look(style, strokes):
    """In a figure of ours the colour is ours, in axes of others it is the next of theirs."""
    return style if strokes == "inside" else {**TOTAL, **style}


def _dotted(result):
    return " Dotted grey line: peak of the gas pressure." if numpy.isfinite(result.peak_gas_pressure_angle) else ""


def _draw_over_cycle(axes, result, name, style, strokes):
    if name == "gas_pressure" and _is_synthetic(result) and "label" in style:
        style = {**style, "label": f"{style['label']} (SYNTHETIC)"}
    _draw_curve(axes, result, name, _own_look(style, strokes))
    crank_axis(axes, result.peak_gas_pressure_angle, strokes)
    axes.set_xlabel(_BY_ANGLE, fontsize=8)
    return f"{_when(result)}: {_curves()[name].long_name}.{_dotted(result)}"


def _plot_panels(result, names):
    figure = new_figure(len(names))
    panels = figure.subplots(len(names), 1, sharex=True)
    for panel, name in zip(panels, names):
        _draw_panel(panel, result, name, "above" if panel is panels[0] else "none")
    panels[-1].set_xlabel(_BY_ANGLE, fontsize=8)
    told = "; ".join("friction" if name == "friction" else _curves()[name].long_name for name in names)
    _caption(figure, f"{_when(result)}: {told}.{_dotted(result)}", result)
    return figure


def _draw_stribeck(axes, result, _, style, strokes):
    curves = _curves()
    number = numpy.asarray(result.stribeck_number)
    moves = number > 1e-6 * numpy.nanmax(number, initial=0.0)  # at a dead centre it is only the round-off of the angle
    if not moves.any():
        raise ValueError("at none of its crank angles this result has a Stribeck number")
    look = {"linestyle": "none", "marker": ".", "markersize": 3, **_own_look(style, strokes)}
    if "linestyle" not in style:
        look["linestyle"] = "none"
    line, = axes.plot(number[moves], numpy.asarray(result.friction_coefficient)[moves], **look)
    axes.set_xscale("log")
    axes.set_xlabel(label_of(curves["stribeck_number"].long_name, "1"), fontsize=8)
    axes.set_ylabel(label_of(curves["friction_coefficient"].long_name, "1"), fontsize=8)
    from_zero(axes, line)
    return "Friction coefficient over the Stribeck number, each crank angle a point."


def _draw_field(axes, result, name, style, strokes):
    """Few angles as curves along the face, many as a map that stays blank where nothing was computed."""
    variables, _ = result._dataset()
    if name not in variables:
        raise ValueError(f"this result has no field {name}: state output.fields in the case")
    _, values, attributes = variables[name]
    unit, factor = _FIELD_UNITS.get(attributes.get("units", "1"), ("1", 1.0))
    angles, order = from_intake(numpy.asarray(variables["field_crank_angle"][1]))
    values = numpy.asarray(values)[order] / factor
    x = numpy.asarray(variables["x"][1]) * 1e3
    if len(angles) <= _FEW_ANGLES:
        return _draw_profiles(axes, x, angles, values, (name, attributes["long_name"], unit), style, strokes)
    return _draw_map(axes, result, (x, angles, values), (name, attributes["long_name"], unit), style, strokes)


def _draw_profiles(axes, x, angles, values, words, style, strokes):
    from matplotlib import colormaps

    name, long_name, unit = words
    whose = style.pop("label", "")
    styles = ("-", "--", "-.", ":")
    for i, (angle, along) in enumerate(zip(angles, values)):
        look = {"color": colormaps["viridis"](0.85 * i / max(len(angles) - 1, 1)), "linestyle": styles[i % 4]}
        label = f"{angle:g} degree"
        look = style if strokes == "inside" else {**look, **style}
        line, = axes.plot(x, along, **{"linewidth": 1.3, **look}, label=f"{whose}, {label}" if whose else label)
        if along.min() >= 0:
            from_zero(axes, line)
    if name == "fill":
        axes.set_ylim(0, 1.05)
    axes.set_xlabel(_BY_PLACE, fontsize=8)
    axes.set_ylabel(label_of(long_name, unit, _HIGH), fontsize=8)
    if strokes != "inside":
        axes.legend(fontsize=7, title="crank angle", title_fontsize=7)
    told = ", ".join(f"{angle:g}" for angle in angles)
    return f"{long_name[0].upper()}{long_name[1:]}, at a crank angle of {told} degree."


def _edges(middles):
    """Edges of cells around their middles."""
    between = (middles[1:] + middles[:-1]) / 2
    return numpy.concatenate(([2 * middles[0] - between[0]], between, [2 * middles[-1] - between[-1]]))


def _columns(angles, values):
    """Edges and columns of a map over crank angle, each no wider than the usual step; blank between."""
    step = numpy.median(numpy.diff(angles))
    if 720 - (angles[-1] - angles[0]) <= 1.5 * step:  # the cycle closes
        angles, values = numpy.append(angles, angles[0] + 720), numpy.concatenate((values, values[:1]))
    middle = (angles[1:] + angles[:-1]) / 2
    right = numpy.minimum(numpy.append(middle, numpy.inf), angles + step / 2)
    left = numpy.maximum(numpy.append(-numpy.inf, middle), angles - step / 2)
    blank = numpy.flatnonzero(left[1:] > right[:-1] + 1e-9)
    edges = numpy.append(numpy.insert(left, blank + 1, right[blank]), right[-1])
    return edges, numpy.insert(values, blank + 1, numpy.nan, axis=0)


def _limits(name, values):
    """The scale of a colour bar: from zero, and logarithmic where the wide gap at the edges would hide the film."""
    from matplotlib.colors import LogNorm

    if name == "fill":
        return {"vmin": 0.0, "vmax": 1.0}
    low, high = numpy.nanmin(values), numpy.nanmax(values)
    if name in ("film_thickness", "local_film_parameter") and 0 < 20 * low < high:
        return {"norm": LogNorm(low, high)}
    return {"vmin": min(low, 0.0), "vmax": high if high > 0 else 1.0}


def _draw_map(axes, result, field, words, style, strokes):
    from matplotlib.colors import LogNorm
    from matplotlib.ticker import LogLocator

    x, angles, values = field
    name, long_name, unit = words
    style.pop("label", None)
    edges, columns = _columns(angles, values)
    limits = {} if style.keys() & {"norm", "vmin", "vmax"} else _limits(name, values)
    look = {"cmap": "viridis", "rasterized": True, "zorder": -1, **limits, **style}
    mesh = axes.pcolormesh(edges, _edges(x), columns.T, **look)
    ticks = {"ticks": LogLocator(subs=(1, 2, 5)), "format": "%g"} if isinstance(mesh.norm, LogNorm) else {}
    axes.figure.colorbar(mesh, ax=axes, **ticks).set_label(label_of(long_name, unit, _HIGH), fontsize=8)
    axes.set_xlabel(_BY_ANGLE, fontsize=8)
    axes.set_ylabel(_BY_PLACE, fontsize=8)
    # Words inside could not be read on the colours, above they would run into a title of the owner.
    crank_axis(axes, result.peak_gas_pressure_angle, "above" if strokes == "above" else "none")
    told = f"{long_name[0].upper()}{long_name[1:]} at {len(angles)} crank angles"
    blank = ", white where none was computed" if numpy.isnan(columns).any() or edges[-1] - edges[0] < 720 else ""
    return f"{told}{blank}.{_dotted(result)}"
