"""Figures of results with matplotlib, which is only loaded here: units of engineers, one crank axis, captions."""

import numpy

from ._drawing import (
    BOUNDARY,
    BY_ANGLE,
    TOTAL,
    VISCOUS,
    caption,
    crank_axis,
    dotted_line,
    draw_over_angle,
    from_intake,
    from_zero,
    label_of,
    new_figure,
    plain,
    shown,
)
from ._field_plots import FIELDS, draw_field
from ._pad_plots import plot_pad
from ._ringfilm import quantities

__all__ = ["plot_pack", "plot_pad", "plot_result"]

_PANELS = {
    "film": ("min_film_thickness", "lambda_ratio", "cavitated_fraction"),
    "friction": ("friction", "friction_coefficient", "power_loss"),
    "overview": ("gas_pressure", "min_film_thickness", "friction"),
}
_FROM_ZERO = ("min_film_thickness", "lambda_ratio", "friction_coefficient", "gas_pressure")


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
    """The name of a result in a legend: the title of its case, and its speed."""
    title, speed = result.title or "without a title", _input(result, "operating.speed")
    return title if not speed or speed in title else f"{title}, {speed}"


def _caption(figure, text, result, title=None):
    words = [text]
    if _is_synthetic(result):
        words.append("The cylinder pressure is SYNTHETIC: made by a formula, not measured.")
    if not result.complete:
        words.append(f"The integration STOPPED at {result.crank_angle[-1]:g} degree, before the end of the cycle.")
    words.append(f"Case: {title or result.title or 'without a title'}; {result.provenance['program']}.")
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
        axes.annotate(
            "SYNTHETIC",
            (angles[top], values[top]),
            xytext=(12, -2),
            textcoords="offset points",
            ha="left",
            va="top",
            fontsize=7,
            color=line.get_color(),
        )
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
        raise ValueError("this result has no curves: the integration stopped before the first crank angle that is kept")
    raise ValueError('this result has no curves: run the batch with curves="all"')


def _without_aliases(style):
    from matplotlib import cbook, lines

    return cbook.normalize_kwargs(style, lines.Line2D)


def plot_result(result, what="overview", axes=None, label=None, **style):
    """See Result.plot."""
    curves = _curves()
    if what not in (*_PANELS, "stribeck", *curves, *FIELDS):
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
    draw = _draw_stribeck if what == "stribeck" else _draw_over_cycle if what in curves else draw_field
    if axes is not None:
        draw(axes, result, what, {"label": plain(_name_of(result) if label is None else label), **style}, "inside")
        return axes.figure
    figure = new_figure(1 if what in curves else 2)
    own = {} if label is None else {"label": plain(label)}
    reported = draw(figure.subplots(), result, what, {**own, **style}, "above")
    if label is not None:
        figure.axes[0].legend(fontsize=7)
    _caption(figure, reported, result)
    return figure


def plot_pack(pack, what="overview", axes=None, label=None, **style):
    """See PackResult.plot."""
    names = ["total_friction" if name == "friction" else name for name in _PANELS.get(what, (what,))]
    if what in FIELDS:
        raise ValueError(f"{what!r} is a field of one ring: draw it by pack.rings[0].plot({what!r})")
    if axes is not None and len(names) > 1:
        raise ValueError(f"{what!r} is a figure of several panels: leave axes out, or draw its curves one by one")
    figure = new_figure(len(names)) if axes is None else None
    panels = [axes] if axes is not None else numpy.atleast_1d(figure.subplots(len(names), 1, sharex=True))
    for panel, name in zip(panels, names):
        for ring in pack.rings:
            number = ring.title[len(pack.title) + 2 :]  # "ring 1 (top)"
            plot_result(ring, name, panel, number if label is None else f"{label}, {number}", **style)
        if axes is None:
            panel.legend(fontsize=7)
            panel.label_outer()
    if axes is not None:
        return axes.figure
    stopped = [ring for ring in pack.rings if not ring.complete]
    words = "; ".join("Stribeck curve" if name == "stribeck" else _curves()[name].long_name for name in names)
    _caption(figure, f"Each ring a line: {words}.", (stopped or pack.rings)[0], pack.title)
    return figure


def _own_look(style, strokes):
    """In a figure of ours the colour is ours, in axes of others it is the next of theirs."""
    return style if strokes == "inside" else {**TOTAL, **style}


def _draw_over_cycle(axes, result, name, style, strokes):
    if name == "gas_pressure" and _is_synthetic(result) and "label" in style:
        style = {**style, "label": f"{style['label']} (SYNTHETIC)"}
    _draw_curve(axes, result, name, _own_look(style, strokes))
    crank_axis(axes, result.peak_gas_pressure_angle, strokes)
    axes.set_xlabel(BY_ANGLE, fontsize=8)
    return f"{_when(result)}: {_curves()[name].long_name}.{dotted_line(result)}"


def _plot_panels(result, names):
    figure = new_figure(len(names))
    panels = figure.subplots(len(names), 1, sharex=True)
    for panel, name in zip(panels, names):
        _draw_panel(panel, result, name, "above" if panel is panels[0] else "none")
    panels[-1].set_xlabel(BY_ANGLE, fontsize=8)
    reported = "; ".join("friction" if name == "friction" else _curves()[name].long_name for name in names)
    _caption(figure, f"{_when(result)}: {reported}.{dotted_line(result)}", result)
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
    (line,) = axes.plot(number[moves], numpy.asarray(result.friction_coefficient)[moves], **look)
    axes.set_xscale("log")
    axes.set_xlabel(label_of(curves["stribeck_number"].long_name, "1"), fontsize=8)
    axes.set_ylabel(label_of(curves["friction_coefficient"].long_name, "1"), fontsize=8)
    from_zero(axes, line)
    return "Friction coefficient over the Stribeck number, each crank angle a point."
